#include "ui/command_search.h"

#include <QApplication>
#include <QClipboard>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPainter>
#include <QScreen>
#include <QSettings>
#include <QStyledItemDelegate>
#include <QTextLayout>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/theme.h"

namespace mw {
namespace {

constexpr int lastOnes = 8;

// The letters of a word in order, anywhere in the title.
std::vector<std::pair<int, int>> inOrder(const QString& word, const QString& title)
{
    std::vector<std::pair<int, int>> found;
    int from = 0;
    for (const QChar c : word) {
        const int at = int(title.indexOf(c, from, Qt::CaseInsensitive));
        if (at < 0) return {};
        if (!found.empty() && found.back().first + found.back().second == at)
            ++found.back().second;
        else
            found.push_back({at, 1});
        from = at + 1;
    }
    return found;
}

// Icon, title with the matched letters bold, where it is, and the keys or the reason at the right.
class Delegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& o, const QModelIndex&) const override { return {200, std::max(30, o.fontMetrics.height() + 12)}; }

    void paint(QPainter* p, const QStyleOptionViewItem& o, const QModelIndex& i) const override
    {
        const auto* model = static_cast<const FoundModel*>(i.model());
        const Findable& f = model->at(i.row());
        const Tokens& t = tokens();
        const bool selected = o.state & QStyle::State_Selected, can = f.whyNot.isEmpty();
        if (selected) p->fillRect(o.rect, t.selection);
        const QColor text = selected ? t.selectionText : can ? t.text : t.text3;
        const QColor quiet = selected ? t.selectionText : can ? t.text2 : t.text3;
        QRect box = o.rect.adjusted(10, 0, -10, 0);
        f.icon.paint(p, QRect(box.left(), box.center().y() - 8, 16, 16), Qt::AlignCenter,
                     !can       ? QIcon::Disabled
                     : selected ? QIcon::Selected
                                : QIcon::Normal);
        box.setLeft(box.left() + 26);
        const QString right = can ? f.keys : f.whyNot;
        const int rightWidth = std::min(o.fontMetrics.horizontalAdvance(right), box.width() / 2);
        p->setPen(quiet);
        p->drawText(box, Qt::AlignVCenter | Qt::AlignRight, o.fontMetrics.elidedText(right, Qt::ElideRight, rightWidth + 1));
        box.setRight(box.right() - rightWidth - 12);
        const int used = drawTitle(p, o, box, f.title, model->letters(i.row()), text);
        box.setLeft(box.left() + used + 10);
        p->setPen(quiet);
        p->drawText(box, Qt::AlignVCenter | Qt::AlignLeft, o.fontMetrics.elidedText(f.where, Qt::ElideRight, box.width()));
    }

private:
    static int drawTitle(QPainter* p, const QStyleOptionViewItem& o, const QRect& box, const QString& title,
                         const std::vector<std::pair<int, int>>& letters, const QColor& color)
    {
        QTextLayout layout(title, o.font);
        QList<QTextLayout::FormatRange> formats;
        for (const auto& [start, length] : letters) {
            QTextCharFormat bold;
            bold.setFontWeight(QFont::Bold);
            bold.setFontUnderline(true);  // weight alone is hard to see in some fonts
            formats << QTextLayout::FormatRange{start, length, bold};
        }
        layout.setFormats(formats);
        layout.beginLayout();
        QTextLine line = layout.createLine();
        line.setLineWidth(box.width());
        layout.endLayout();
        p->setPen(color);
        p->save();
        p->setClipRect(box);
        layout.draw(p, QPointF(box.left(), box.center().y() - line.height() / 2 + 1));
        p->restore();
        return int(line.naturalTextWidth());
    }
};

}  // namespace

std::vector<std::pair<int, int>> matchedLetters(const QString& query, const Findable& entry, int* rank)
{
    const QStringList words = query.split(' ', Qt::SkipEmptyParts);
    std::vector<std::pair<int, int>> letters;
    const QString all = entry.title + ' ' + entry.where + ' ' + entry.more;
    *rank = 0;
    for (const QString& w : words) {
        const int at = int(entry.title.indexOf(w, 0, Qt::CaseInsensitive));
        if (at >= 0) {
            letters.push_back({at, int(w.size())});
            *rank += at == 0 ? 0 : entry.title[at - 1] == ' ' ? 1 : 2;
        } else if (all.contains(w, Qt::CaseInsensitive)) {
            *rank += 4;
        } else if (words.size() == 1 && w.size() > 1 && !(letters = inOrder(w, entry.title)).empty()) {
            *rank = 20 + int(letters.size());
        } else {
            *rank = -1;
            return {};
        }
    }
    std::sort(letters.begin(), letters.end());
    return letters;
}

FoundModel::FoundModel(std::vector<Findable> all, QObject* parent) : QAbstractListModel(parent), all_(std::move(all)) {}

void FoundModel::search(const QString& query)
{
    beginResetModel();
    rows_.clear();
    const QStringList latest = QSettings().value("search/latest").toStringList();
    for (size_t i = 0; i < all_.size(); ++i) {
        int rank = 0;
        auto letters = matchedLetters(query, all_[i], &rank);
        if (query.trimmed().isEmpty()) {
            rank = int(latest.indexOf(all_[i].id));
            if (latest.isEmpty()) rank = 0;
        }
        if (rank >= 0) rows_.push_back({i, rank + (all_[i].whyNot.isEmpty() ? 0 : 1000), std::move(letters)});
    }
    std::stable_sort(rows_.begin(), rows_.end(), [](const Row& a, const Row& b) { return a.rank < b.rank; });
    endResetModel();
}

QVariant FoundModel::data(const QModelIndex& index, int role) const
{
    const Findable& f = at(index.row());
    if (role == Qt::DisplayRole) return f.title;
    if (role == Qt::ToolTipRole) return f.whyNot.isEmpty() ? f.more : f.whyNot;
    if (role == Qt::AccessibleTextRole) {
        QString text = f.title + ", " + f.where;
        if (!f.keys.isEmpty()) text += ", " + f.keys;
        if (!f.whyNot.isEmpty()) text += ", not now: " + f.whyNot;
        return text;
    }
    return {};
}

Qt::ItemFlags FoundModel::flags(const QModelIndex&) const
{
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable;  // those that cannot run can be read, too
}

CommandSearch::CommandSearch(std::vector<Findable> all, QWidget* window)
    : QFrame(window, Qt::Popup), model_(new FoundModel(std::move(all), this)), field_(new QLineEdit(this)), list_(new QListView(this))
{
    setObjectName("popup");
    setAttribute(Qt::WA_DeleteOnClose);
    setAccessibleName("Search commands and settings");
    auto* box = new QVBoxLayout(this);
    box->setContentsMargins(8, 8, 8, 6);
    box->setSpacing(6);
    field_->setObjectName("searchQuery");
    field_->setPlaceholderText("Commands, modifiers, lessons, parameters, nodes, settings");
    field_->setAccessibleName("Search");
    field_->setToolTip("Words, or letters in order. Down and up choose");
    list_->setObjectName("searchResults");
    list_->setAccessibleName("Found");
    list_->setModel(model_);
    list_->setItemDelegate(new Delegate(list_));
    list_->setUniformItemSizes(true);
    list_->setFocusPolicy(Qt::NoFocus);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* foot = new QLabel("Enter runs · Ctrl+Enter copies its command line · F1 explains · Esc closes", this);
    foot->setProperty("secondary", true);
    auto* nothing = new QLabel("Nothing has these words. Try fewer, or a part of one.", this);
    nothing->setProperty("secondary", true);
    nothing->hide();
    box->addWidget(field_);
    box->addWidget(nothing);
    box->addWidget(list_, 1);
    box->addWidget(foot);
    resize(560, 420);
    field_->installEventFilter(this);
    const auto search = [this, nothing] {
        model_->search(field_->text());
        nothing->setVisible(model_->rowCount() == 0);
        list_->setCurrentIndex(model_->index(0));
    };
    connect(field_, &QLineEdit::textChanged, this, search);
    connect(list_, &QListView::clicked, this, [this] { run(); });
    search();
}

void CommandSearch::openBelow(QWidget* anchor)
{
    QPoint at = anchor->mapToGlobal(QPoint(anchor->width() - width(), anchor->height() + 2));
    at.setX(std::max(at.x(), anchor->screen()->availableGeometry().left()));
    move(at);
    show();
    field_->setFocus();
}

void CommandSearch::run()
{
    const QModelIndex i = list_->currentIndex();
    if (!i.isValid() || !model_->at(i.row()).whyNot.isEmpty()) return;
    const Findable f = model_->at(i.row());
    QStringList latest = QSettings().value("search/latest").toStringList();
    latest.removeAll(f.id);
    latest.prepend(f.id);
    QSettings().setValue("search/latest", QStringList(latest.mid(0, lastOnes)));
    close();
    QTimer::singleShot(0, qApp, f.run);  // the popup has gone: what it opens gets the focus
}

void CommandSearch::copyCommand()
{
    const QModelIndex i = list_->currentIndex();
    if (!i.isValid()) return;
    const Findable& f = model_->at(i.row());
    if (f.command.isEmpty()) return emit said(f.title + " is no edit: there is no command line for it.");
    QApplication::clipboard()->setText(f.command);
    emit said("Copied: " + f.command);
    close();
}

bool CommandSearch::eventFilter(QObject* o, QEvent* e)
{
    if (e->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(e)->key() == Qt::Key_F1) {
        e->accept();
        return true;
    }
    if (e->type() != QEvent::KeyPress) return QFrame::eventFilter(o, e);
    const auto* press = static_cast<QKeyEvent*>(e);
    const int key = press->key(), row = list_->currentIndex().row();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        if (press->modifiers() & Qt::ControlModifier)
            copyCommand();
        else
            run();
        return true;
    }
    if (key == Qt::Key_F1 && row >= 0) {
        const Findable f = model_->at(row);
        close();
        emit helpWanted(f.title, f.more + (f.keys.isEmpty() ? QString() : "<br><br>Keys: " + f.keys) + "<br>Where: " + f.where);
        return true;
    }
    const int page = std::max(1, list_->height() / 30 - 1);
    const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : key == Qt::Key_PageDown ? page : key == Qt::Key_PageUp ? -page : 0;
    if (step == 0) return false;
    list_->setCurrentIndex(model_->index(std::clamp(row + step, 0, std::max(0, model_->rowCount() - 1))));
    return true;
}

}  // namespace mw
