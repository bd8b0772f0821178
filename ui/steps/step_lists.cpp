// See step_lists.h.
#include "ui/steps/step_lists.h"

#include <QHeaderView>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>
#include <optional>

#include "ui/look.h"
#include "ui/steps/step_history.h"
#include "ui/steps/step_words.h"

namespace mw {

namespace {

constexpr int rowHeight = 26, countRole = Qt::UserRole + 1;

/// A count at the right end of the row, beside the title.
class PhaseRow : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {80, rowHeight}; }
    void paint(QPainter* p, const QStyleOptionViewItem& o, const QModelIndex& i) const override
    {
        const look::Tones& t = look::tone();
        const bool current = i.data(Qt::CheckStateRole).toInt() == Qt::PartiallyChecked;
        const bool done = i.data(Qt::CheckStateRole).toInt() == Qt::Checked;
        const QRect r = o.rect;
        if (current)
            p->fillRect(r, t.selection);
        else if (o.state & QStyle::State_MouseOver)
            p->fillRect(r, t.hover);
        if (current || done) look::icon(current ? "here" : "ok", current ? t.selectionText : t.success).paint(p, r.left() + 6, r.top() + 5, 16, 16);
        p->setPen(current ? t.selectionText : done ? t.text : t.text2);
        const QString count = i.data(countRole).toString();
        const int w = o.fontMetrics.horizontalAdvance(count) + 16;
        p->drawText(r.adjusted(28, 0, -w, 0), Qt::AlignVCenter,
                    o.fontMetrics.elidedText(i.data(Qt::DisplayRole).toString(), Qt::ElideRight, r.width() - 28 - w));
        if (!current) p->setPen(t.text2);
        p->drawText(r.adjusted(0, 0, -8, 0), Qt::AlignVCenter | Qt::AlignRight, count);
        if (o.state & QStyle::State_HasFocus) {
            p->setPen(QPen(t.accentText, 2));
            p->drawRect(r.adjusted(1, 1, -1, -1));
        }
    }
};

QString ordinal(size_t n)
{
    const char* end = n % 100 / 10 == 1 ? "th" : n % 10 == 1 ? "st" : n % 10 == 2 ? "nd" : n % 10 == 3 ? "rd" : "th";
    return look::count(n) + end;
}

/// A number at a step: what it gives itself, else what it was last; and the value before that.
struct NowAndLast {
    bool here = false;
    std::optional<double> now, last;
};

NowAndLast valuesAt(const StepSession& steps, const std::string& name)
{
    NowAndLast v;
    for (const Number& n : steps.step().numbers)
        if (name == n.name) v.now = n.value, v.here = true;
    const auto& points = steps.series(name);
    auto before = [&](size_t position) {
        return std::lower_bound(points.begin(), points.end(), position, [](const auto& x, size_t p) { return x.first < p; });
    };
    auto i = before(steps.position());
    if (!v.here && i != points.end() && i->first == steps.position()) ++i;
    if (!v.here && i != points.begin()) v.now = (--i)->second;
    if (i != points.begin()) v.last = (--i)->second;
    return v;
}

}  // namespace

PhaseList::PhaseList(StepSession& steps, QWidget* parent) : QListWidget(parent), steps_(steps)
{
    setObjectName("phase-list");
    setAccessibleName(tr("Phases"));
    setFrameShape(NoFrame);
    setItemDelegate(new PhaseRow(this));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSelectionMode(NoSelection);
    setMouseTracking(true);
    viewport()->setAutoFillBackground(false);
    auto run = [this](QListWidgetItem* row) { steps_.toPhase(row->data(Qt::UserRole).toString()); };
    connect(this, &QListWidget::itemClicked, this, run);
    connect(this, &QListWidget::itemActivated, this, [this, run](QListWidgetItem* row) {
        if (hasFocus()) run(row);
    });
}

void PhaseList::refresh()
{
    if (!steps_.isOpen()) return;
    QStringList ids;
    for (const PhaseWords& w : phasesOf(*steps_.operation())) ids << w.id;
    for (const std::string& p : steps_.history().phases())
        if (!ids.contains(QString::fromStdString(p))) ids << QString::fromStdString(p);
    if (ids != shown_) {
        shown_ = ids;
        clear();
        for (qsizetype i = 0; i < ids.size(); ++i) {
            auto* row = new QListWidgetItem(QString("%1 %2").arg(i + 1).arg(phaseOf(*steps_.operation(), ids[i]).title), this);
            row->setData(Qt::UserRole, ids[i]);
            row->setToolTip(tr("Click: run to the next step of this phase."));
        }
        setFixedHeight(int(ids.size()) * rowHeight);
    }
    const QString now = QString::fromStdString(steps_.step().phase);
    for (int i = 0; i < count(); ++i) {
        const size_t n = steps_.history().countOf(ids[i].toStdString(), steps_.position());
        const bool current = ids[i] == now;
        item(i)->setData(Qt::CheckStateRole, current ? Qt::PartiallyChecked : n > 0 ? Qt::Checked : Qt::Unchecked);
        const QString text = n < 2 ? QString() : current ? tr("%1 time").arg(ordinal(n)) : tr("%1 times").arg(look::count(n));
        item(i)->setData(countRole, text);
        item(i)->setData(Qt::AccessibleTextRole, item(i)->text() + ", " +
                                                     (current ? tr("running")
                                                      : n > 0 ? tr("done")
                                                              : tr("not yet")) +
                                                     ", " + text);
    }
}

NumberTable::NumberTable(StepSession& steps, QWidget* parent) : QTreeWidget(parent), steps_(steps)
{
    setObjectName("number-table");
    setAccessibleName(tr("Numbers of the step"));
    setFrameShape(NoFrame);
    setColumnCount(3);
    setHeaderLabels({tr("Numbers"), tr("now"), tr("last")});
    setRootIsDecorated(false);
    setSelectionMode(NoSelection);
    setUniformRowHeights(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    header()->setStretchLastSection(false);
    header()->setSectionsMovable(false);
    header()->setSectionsClickable(false);
    header()->setMinimumSectionSize(40);
    setStyleSheet("QTreeView::item { padding: 0 8px; min-height: 20px; } QHeaderView::section { padding: 3px 8px; }");
    header()->setSectionResizeMode(0, QHeaderView::Stretch);
    header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    for (int c : {1, 2}) headerItem()->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
    viewport()->setAutoFillBackground(false);
    connect(this, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* row) {
        const QString name = row->data(0, Qt::UserRole).toString();
        if (!name.isEmpty()) steps_.setPlotted({name});
    });
}

void NumberTable::refresh()
{
    if (!steps_.isOpen()) return;
    clear();
    addFocus();
    addNumbers();
    fitHeight();
}

void NumberTable::addFocus()
{
    for (const FocusWords& f : focusOf(steps_.step())) {
        auto* row = new QTreeWidgetItem(this, {f.title, f.text});
        row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        row->setForeground(0, look::tone().text2);
        row->setForeground(1, look::roleTextColor(f.role));
        row->setToolTip(0, look::roleName(f.role));
    }
}

// Those of this step, then those worth a curve that other steps gave. A matrix of the formula is left to the formula.
std::vector<std::string> NumberTable::shownNumbers() const
{
    const Operation& op = *steps_.operation();
    std::vector<std::string> names;
    for (const Number& n : steps_.step().numbers)
        if (!isInMatrix(op, steps_.step().phase, QString::fromUtf8(n.name))) names.emplace_back(n.name);
    for (const std::string& name : steps_.seriesNames()) {
        const QString id = QString::fromStdString(name);
        const bool wanted = isWorthACurve(op, id) || steps_.plotted().contains(id);
        if (wanted && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return names;
}

void NumberTable::addNumbers()
{
    const Operation& op = *steps_.operation();
    const std::string& phase = steps_.step().phase;
    for (const std::string& name : shownNumbers()) {
        const NowAndLast v = valuesAt(steps_, name);
        if (!v.now) continue;
        const QString id = QString::fromStdString(name);
        auto* row = new QTreeWidgetItem(
            this, {numberTitle(op, id, phase), numberText(op, id, *v.now, phase), v.last ? numberText(op, id, *v.last, phase) : QString()});
        row->setData(0, Qt::UserRole, id);
        row->setToolTip(0, tr("Click: plot it."));
        row->setToolTip(1, look::exactNumber(*v.now));
        row->setToolTip(2, v.last ? look::exactNumber(*v.last) : QString());
        for (int c : {1, 2}) row->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
        row->setForeground(0, look::tone().text2);
        row->setForeground(1, v.here ? look::tone().text : look::tone().text2);
        row->setForeground(2, look::tone().text2);
        QFont bold = font();
        bold.setBold(v.here && v.last != v.now);
        row->setFont(1, bold);
        if (steps_.plotted().contains(id)) row->setForeground(0, look::tone().accentText);
    }
}

void NumberTable::fitHeight()
{
    const int row = topLevelItemCount() > 0 ? std::max(20, sizeHintForRow(0)) : 20;
    setFixedHeight(header()->sizeHint().height() + row * topLevelItemCount() + 4);
}

RoleLegend::RoleLegend(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Signs in the view: current, neighbour, new, removed, rejected"));
    QSizePolicy p(QSizePolicy::Preferred, QSizePolicy::Minimum);
    p.setHeightForWidth(true);
    setSizePolicy(p);
}

int RoleLegend::columns(int w) const
{
    return std::clamp(w / 110, 1, 5);
}

int RoleLegend::heightForWidth(int w) const
{
    return (5 + columns(w) - 1) / columns(w) * 22;
}

QSize RoleLegend::sizeHint() const
{
    return {330, heightForWidth(330)};
}

void RoleLegend::paintEvent(QPaintEvent*)
{
    QPainter p(this);
    const int n = columns(width()), w = width() / n;
    for (int i = 0; i < 5; ++i) {
        const QRect cell(i % n * w, i / n * 22, w, 22);
        look::paintRole(p, Role(i), QRectF(cell.left() + 2, cell.top() + 5, 18, 12));
        p.setPen(look::tone().text);
        p.drawText(cell.adjusted(28, 0, 0, 0), Qt::AlignVCenter, look::roleName(Role(i)));
    }
}

}  // namespace mw
