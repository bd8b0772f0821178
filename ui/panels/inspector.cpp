// See inspector.h. The report is made by a job; until it is there the panel says so.
#include "ui/panels/inspector.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPointer>
#include <QPushButton>
#include <QStackedLayout>
#include <QStyle>
#include <QStyledItemDelegate>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/panels/inspection.h"
#include "ui/panels/look.h"
#include "ui/panels/valence_histogram.h"

namespace mw {

namespace {

constexpr size_t largeFaces = 5'000'000;  // from here on measuring is asked for
constexpr int findingRole = Qt::UserRole, offenderRole = Qt::UserRole + 1, sectionRole = Qt::UserRole + 2;

/// Sections as bars; other rows with their figure at the right end, which it keeps while the title is cut short. The figure is the text of
/// column 1, whose cell holds a button or nothing.
class Rows : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QSize sizeHint(const QStyleOptionViewItem& o, const QModelIndex& i) const override { return {QStyledItemDelegate::sizeHint(o, i).width(), 26}; }
    void paint(QPainter* p, const QStyleOptionViewItem& o, const QModelIndex& i) const override
    {
        if (i.data(sectionRole).toBool()) return paintSection(p, o, i);
        QStyleOptionViewItem row = o;
        initStyleOption(&row, i);
        const QString figure = i.column() == 0 ? i.siblingAtColumn(1).data().toString() : QString();
        const int w = figure.isEmpty() ? 0 : o.fontMetrics.horizontalAdvance(figure) + 16;
        const int room = o.rect.width() - w - (row.icon.isNull() ? 8 : 30);
        row.text = i.column() == 0 ? o.fontMetrics.elidedText(row.text, Qt::ElideRight, room) : QString();
        const QWidget* view = o.widget;
        view->style()->drawControl(QStyle::CE_ItemViewItem, &row, p, view);
        const bool selected = o.state & QStyle::State_Selected;
        p->setPen(selected ? look::tone().selectionText : i.siblingAtColumn(1).data(Qt::ForegroundRole).value<QBrush>().color());
        p->drawText(o.rect.adjusted(0, 0, -8, 0), Qt::AlignRight | Qt::AlignVCenter, figure);
    }

private:
    void paintSection(QPainter* p, const QStyleOptionViewItem& o, const QModelIndex& i) const
    {
        const look::Tones& t = look::tone();
        p->fillRect(o.rect, t.raised);
        QFont bold = o.font;
        bold.setBold(true);
        const QString title = i.data(Qt::DisplayRole).toString();
        const int w = QFontMetrics(bold).horizontalAdvance(title);
        const QRect r = o.rect.adjusted(8, 0, 0, 0);
        p->setFont(bold);
        p->setPen(t.text);
        p->drawText(r, Qt::AlignVCenter, title);
        p->setFont(o.font);
        p->setPen(t.text2);
        p->drawText(r.adjusted(w + 8, 0, 0, 0), Qt::AlignVCenter, i.data(sectionRole + 1).toString());
    }
};

class Inspector : public QWidget {
public:
    Inspector(Session& session, QWidget* parent);

protected:
    void showEvent(QShowEvent*) override { update(false); }
    void leaveEvent(QEvent*) override { flash(nullptr); }
    bool eventFilter(QObject* o, QEvent* e) override;
    void changeEvent(QEvent* e) override;

private:
    void makePage();
    void makeTree();
    QWidget* makeCounts(QWidget* parent);
    NodeId wantedNode() const;
    void update(bool measureLarge);
    void refreshLevels(const MeshObject& object);
    Mesh inspected(MeshId id) const;
    void measure(const Mesh& mesh);
    void show(std::shared_ptr<const Inspection> i);
    void fill();
    QTreeWidgetItem* section(const QString& title, const QString& figure);
    void addFinding(QTreeWidgetItem* under, size_t index);
    void addRepair(QTreeWidgetItem* row, const Finding& f);
    void addValence();
    void showMessage(const QString& text, const QString& button);

    const ElementSet* elementsOf(const QTreeWidgetItem* row) const;
    void select(const ElementSet& elements);
    void selectValence(size_t valence, bool orMore);
    void frame(const QTreeWidgetItem* row);
    void flash(const QTreeWidgetItem* row);
    void repair(const Finding& f, QTreeWidgetItem* row);
    void selectionChanged();

    Session& session_;
    std::shared_ptr<void> subscription_;
    QStackedLayout* pages_;
    QLabel *message_ = nullptr, *values_[6] = {};
    QPushButton* messageButton_ = nullptr;
    QComboBox* level_ = nullptr;
    QLabel* busy_ = nullptr;
    QTreeWidget* tree_ = nullptr;
    NodeId node_;
    std::shared_ptr<const Inspection> shown_;
    Mesh measuring_;
    quint64 job_ = 0, ticket_ = 0;
    bool selecting_ = false, dimmed_ = false;
};

Inspector::Inspector(Session& session, QWidget* parent) : QWidget(parent), session_(session)
{
    setObjectName("inspector");
    pages_ = new QStackedLayout(this);
    pages_->addWidget(look::emptyState(this, &message_, &messageButton_));
    connect(messageButton_, &QPushButton::clicked, this, [this] { update(true); });
    makePage();
    subscription_ = session_.document.subscribe([this](const Change& c) {
        if (c.aspects & Aspect::Selection) selectionChanged();
        if (c.aspects & (Aspect::Selection | Aspect::Mesh | Aspect::Stack | Aspect::Evaluation | Aspect::Tree)) update(false);
    });
    showMessage(tr("Select a mesh to inspect it."), {});
}

void Inspector::makePage()
{
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 8, 0, 0);
    column->setSpacing(6);
    auto* top = new QHBoxLayout;
    top->setContentsMargins(8, 0, 8, 0);
    auto* label = new QLabel(tr("Inspect"), page);
    top->addWidget(label);
    top->addWidget(level_ = new QComboBox(page), 1);
    label->setBuddy(level_);
    level_->setObjectName("inspect-level");
    level_->setFocusPolicy(Qt::TabFocus);
    level_->setToolTip(tr("Which level of the modifiers is measured."));
    connect(level_, &QComboBox::activated, this, [this] { update(false); });
    column->addLayout(top);
    column->addWidget(makeCounts(page));
    column->addWidget(busy_ = new QLabel(tr("Measuring..."), page));
    busy_->setContentsMargins(8, 0, 8, 0);
    busy_->setProperty("secondary", true);
    makeTree();
    column->addWidget(tree_, 1);
    pages_->addWidget(page);
}

QWidget* Inspector::makeCounts(QWidget* parent)
{
    auto* box = new QWidget(parent);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(8, 0, 8, 0);
    grid->setVerticalSpacing(3);
    grid->setHorizontalSpacing(8);
    const QString names[] = {tr("Vertices"), tr("Edges"), tr("Faces"), tr("Euler char."), tr("Genus"), tr("Components")};
    const char* ids[] = {"vertices", "edges", "faces", "euler", "genus", "components"};
    for (int i = 0; i < 6; ++i) {
        auto* name = new QLabel(names[i], box);
        name->setProperty("secondary", true);
        grid->addWidget(name, i % 3, i / 3 * 2);
        grid->addWidget(values_[i] = new QLabel(box), i % 3, i / 3 * 2 + 1, Qt::AlignRight);
        values_[i]->setObjectName(QString("inspect-") + ids[i]);
        values_[i]->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    grid->setColumnStretch(1, 3);
    grid->setColumnStretch(3, 2);
    return box;
}

void Inspector::makeTree()
{
    tree_ = new QTreeWidget(this);
    tree_->setObjectName("inspect-list");
    tree_->setAccessibleName(tr("Checks of the mesh"));
    tree_->setColumnCount(2);
    tree_->setHeaderHidden(true);
    tree_->setRootIsDecorated(false);
    tree_->setIndentation(16);
    tree_->setFrameShape(QFrame::NoFrame);
    tree_->setExpandsOnDoubleClick(false);
    tree_->setMouseTracking(true);
    tree_->setUniformRowHeights(false);
    tree_->setItemDelegate(new Rows(tree_));
    tree_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    tree_->header()->setStretchLastSection(false);
    tree_->header()->setMinimumSectionSize(4);
    tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    tree_->header()->setSectionResizeMode(1, QHeaderView::Fixed);
    tree_->installEventFilter(this);
    connect(tree_, &QTreeWidget::itemEntered, this, [this](QTreeWidgetItem* row) { flash(row); });
    connect(tree_, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* row) { frame(row); });
    connect(tree_, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* row) {
        if (const ElementSet* e = elementsOf(row)) select(*e);
    });
    connect(tree_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* row) {
        const ElementSet* e = row && tree_->hasFocus() ? elementsOf(row) : nullptr;
        if (e) select(*e);
    });
}

bool Inspector::eventFilter(QObject* o, QEvent* e)
{
    if (o == tree_ && e->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(e)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            frame(tree_->currentItem());
            return true;
        }
    }
    return QWidget::eventFilter(o, e);
}

void Inspector::changeEvent(QEvent* e)
{
    QWidget::changeEvent(e);
    if (e->type() == QEvent::PaletteChange && shown_) fill();
}

// The active node, else the one inspected so far, else the only mesh there is.
NodeId Inspector::wantedNode() const
{
    const Scene& s = session_.document.scene();
    auto hasMesh = [&](NodeId id) {
        const Node* n = s.find(id);
        return n && n->mesh;
    };
    const NodeId active = session_.document.selection().active();
    if (hasMesh(active)) return active;
    if (hasMesh(node_)) return node_;
    NodeId only;
    for (NodeId id : s.nodes())
        if (hasMesh(id)) {
            if (only) return {};
            only = id;
        }
    return only;
}

void Inspector::update(bool measureLarge)
{
    if (!isVisible()) return;  // what nobody sees is not measured
    const NodeId node = wantedNode();
    if (!node) {
        node_ = {};
        shown_.reset();
        return showMessage(tr("Select a mesh to inspect it."), {});
    }
    const Scene& s = session_.document.scene();
    const MeshObject& object = *s.find(s.node(node).mesh);
    if (node != node_) level_->clear();
    node_ = node;
    refreshLevels(object);
    const Mesh mesh = inspected(s.node(node).mesh);
    auto same = [&](const Mesh& m) {
        return m.positions().data() == mesh.positions().data() && m.cornerVertex().data() == mesh.cornerVertex().data() &&
               m.faceStart().data() == mesh.faceStart().data() && m.vertexCount() == mesh.vertexCount();
    };
    if (shown_ && same(shown_->mesh)) return pages_->setCurrentIndex(1);
    if (job_ != 0 && same(measuring_)) return;
    if (mesh.faceCount() > largeFaces && !measureLarge) return showMessage(tr("Not yet measured: the mesh has over 5 million faces."), tr("Measure"));
    measure(mesh);
}

void Inspector::refreshLevels(const MeshObject& object)
{
    QStringList names{object.stack.empty() ? tr("Mesh") : tr("Base mesh, level 0")};
    for (size_t i = 0; i < object.stack.size(); ++i) {
        const Operation* op = findOperation(object.stack[i].operation);
        const QString title = op ? QString::fromStdString(op->title) : QString::fromStdString(object.stack[i].operation);
        names << tr("%1, level %2").arg(title).arg(i + 1);
    }
    if (!object.stack.empty()) names << tr("Result");
    QStringList before;
    for (int i = 0; i < level_->count(); ++i) before << level_->itemText(i);
    if (before == names) return;
    // The result stays the result when modifiers come and go.
    const bool last = level_->count() == 0 || level_->currentIndex() == level_->count() - 1;
    const int kept = level_->currentIndex();
    level_->clear();
    level_->addItems(names);
    level_->setCurrentIndex(last ? level_->count() - 1 : std::min(kept, level_->count() - 1));
}

Mesh Inspector::inspected(MeshId id) const
{
    const MeshObject& object = *session_.document.scene().find(id);
    const size_t level = size_t(std::max(0, level_->currentIndex()));
    if (level == 0) return object.base;
    const auto e = session_.document.evaluation(id);
    if (!e) return object.base;
    return level > object.stack.size() ? e->result() : e->at(std::min(level, e->levels.size()));
}

void Inspector::measure(const Mesh& mesh)
{
    if (job_ != 0) session_.jobs.cancel(job_);
    measuring_ = mesh;
    pages_->setCurrentIndex(1);
    busy_->setVisible(true);
    const quint64 ticket = ++ticket_;
    const QString name = QString::fromStdString(session_.document.scene().node(node_).name);
    QPointer<Inspector> self(this);
    job_ = session_.jobs.start(
        tr("Inspect %1").arg(name),
        [self, ticket, mesh](Progress& p) -> std::function<void()> {
            p.at(0);
            auto result = std::make_shared<const Inspection>(inspect(mesh));
            return [self, ticket, result] {
                if (self && self->ticket_ == ticket) self->show(result);
            };
        },
        [self, ticket](const QString& why) {
            if (!self || self->ticket_ != ticket) return;
            self->job_ = 0;
            self->showMessage(why, self->tr("Measure again"));
        });
}

void Inspector::show(std::shared_ptr<const Inspection> i)
{
    job_ = 0;
    measuring_ = Mesh();
    shown_ = std::move(i);
    busy_->setVisible(false);
    pages_->setCurrentIndex(1);
    fill();
}

void Inspector::fill()
{
    const Inspection& i = *shown_;
    values_[0]->setText(look::count(i.vertices) + (i.isolated ? " + " + look::count(i.isolated) : QString()));
    values_[0]->setToolTip(i.isolated ? tr("%1 in faces, %2 isolated").arg(look::count(i.vertices), look::count(i.isolated)) : QString());
    values_[1]->setText(look::count(i.edges));
    values_[2]->setText(look::count(i.faces));
    values_[3]->setText(look::number(double(i.euler)));
    values_[4]->setText(i.genus ? look::number(double(*i.genus)) : tr("none"));
    values_[4]->setToolTip(i.genus ? QString() : tr("Only a manifold, orientable mesh without degenerate faces has one."));
    values_[5]->setText(look::count(i.components));
    tree_->clear();
    tree_->header()->resizeSection(1, 20);
    const auto mendable = [](const Finding& f) { return !f.passed() && !f.repair.empty(); };
    tree_->setColumnHidden(1, std::none_of(i.findings.begin(), i.findings.end(), mendable));
    const size_t bad = i.toFix(), good = i.findings.size() - bad;
    if (bad > 0) {
        QTreeWidgetItem* s = section(tr("To fix"), look::counted(bad, tr("kind"), tr("kinds")));
        for (size_t k = 0; k < bad; ++k) addFinding(s, k);
    }
    QTreeWidgetItem* s = bad == 0 ? section(tr("Nothing to fix"), tr("%1 passed").arg(look::counted(good, tr("check"), tr("checks"))))
                                  : section(tr("Passed"), look::counted(good, tr("check"), tr("checks")));
    for (size_t k = bad; k < i.findings.size(); ++k) addFinding(s, k);
    addValence();
}

QTreeWidgetItem* Inspector::section(const QString& title, const QString& figure)
{
    auto* s = new QTreeWidgetItem(tree_, {title});
    s->setFirstColumnSpanned(true);
    s->setData(0, sectionRole, true);
    s->setData(0, sectionRole + 1, figure);
    s->setFlags(Qt::ItemIsEnabled);
    s->setExpanded(true);
    s->setData(0, Qt::AccessibleTextRole, title + ", " + figure);
    return s;
}

void Inspector::addFinding(QTreeWidgetItem* under, size_t index)
{
    const Finding& f = shown_->findings[index];
    auto* row = new QTreeWidgetItem(under, {f.title, f.figure});
    row->setData(0, findingRole, int(index) + 1);
    row->setFirstColumnSpanned(f.passed() || f.repair.empty());
    row->setData(0, Qt::AccessibleTextRole, f.title + ", " + f.figure);
    row->setIcon(0, f.passed() ? look::icon("ok", look::tone().success) : look::icon("warning", look::tone().warning));
    row->setForeground(1, f.passed() ? look::tone().text2 : look::tone().accentText);
    row->setToolTip(0, f.passed() ? f.checked : tr("Click selects them all, Enter frames them."));
    if (f.passed()) {
        auto* why = new QTreeWidgetItem(row, {f.checked});
        why->setForeground(0, look::tone().text2);
        why->setFirstColumnSpanned(true);
        why->setFlags(Qt::ItemIsEnabled);
        return;
    }
    for (size_t k = 0; k < f.offenders.size(); ++k) {
        auto* o = new QTreeWidgetItem(row, {f.offenders[k].name, f.offenders[k].figure});
        o->setData(0, findingRole, int(index) + 1);
        o->setData(0, offenderRole, int(k) + 1);
        o->setFirstColumnSpanned(true);
        o->setForeground(1, look::tone().text2);
        o->setToolTip(0, tr("Click selects it, Enter or a double click frames it."));
    }
    const size_t listed = f.id == "coincident" ? f.offenders.size() : f.total;
    if (listed > f.offenders.size()) {
        auto* more = new QTreeWidgetItem(row, {tr("and %1 more").arg(look::count(listed - f.offenders.size()))});
        more->setForeground(0, look::tone().text2);
        more->setFirstColumnSpanned(true);
        more->setFlags(Qt::ItemIsEnabled);
    }
    row->setExpanded(f.offenders.size() <= 8);
    addRepair(row, f);
}

void Inspector::addRepair(QTreeWidgetItem* row, const Finding& f)
{
    if (f.repair.empty()) return;
    auto* b = new QPushButton(f.repairText, tree_);
    b->setFixedHeight(20);
    b->setFocusPolicy(Qt::TabFocus);
    b->setObjectName("repair-" + f.id);
    b->setAccessibleName(tr("%1: %2").arg(f.title, f.repairText));
    b->setToolTip(tr("Adds the modifier \"%1\".").arg(QString::fromStdString(operation(f.repair).title)));
    connect(b, &QPushButton::clicked, this, [this, finding = f, row] { repair(finding, row); });
    tree_->header()->resizeSection(1, std::max(tree_->header()->sectionSize(1), b->sizeHint().width() + 4));
    tree_->setItemWidget(row, 1, b);
}

void Inspector::addValence()
{
    QTreeWidgetItem* s = section(tr("Valence"), tr("%1 % regular").arg(int(std::round(100 * shown_->regular))));
    s->setToolTip(0, tr("Edges at a vertex. Regular: 6 inside a triangle mesh, 4 on its boundary; 4 and 3 where there are other faces."));
    auto* row = new QTreeWidgetItem(s);
    row->setFlags(Qt::ItemIsEnabled);
    row->setFirstColumnSpanned(true);
    auto* h = new ValenceHistogram(tree_);
    h->setValences(shown_->valences);
    connect(h, &ValenceHistogram::barClicked, this, &Inspector::selectValence);
    tree_->setItemWidget(row, 0, h);
    row->setSizeHint(0, h->sizeHint());
}

void Inspector::showMessage(const QString& text, const QString& button)
{
    message_->setText(text);
    messageButton_->setText(button);
    messageButton_->setVisible(!button.isEmpty());
    pages_->setCurrentIndex(0);
}

const ElementSet* Inspector::elementsOf(const QTreeWidgetItem* row) const
{
    const int f = row ? row->data(0, findingRole).toInt() : 0, o = row ? row->data(0, offenderRole).toInt() : 0;
    if (!shown_ || f <= 0 || size_t(f) > shown_->findings.size()) return nullptr;
    const Finding& finding = shown_->findings[size_t(f) - 1];
    if (finding.passed()) return nullptr;
    return o > 0 ? &finding.offenders[size_t(o) - 1].elements : &finding.all;
}

// The elements belong to the level that was measured, so that one is shown.
void Inspector::select(const ElementSet& elements)
{
    const Scene& s = session_.document.scene();
    const Node* n = s.find(node_);
    if (!n || !n->mesh) return;
    const size_t level = size_t(std::max(0, level_->currentIndex())), levels = s.find(n->mesh)->stack.size();
    if (level > levels || levels == 0)
        session_.view.shownLevel.erase(n->mesh);
    else
        session_.view.shownLevel[n->mesh] = level;
    session_.view.flashes.clear();
    session_.view.dimOthers = dimmed_ = true;
    selecting_ = true;
    session_.document.select({{node_}, node_, elements});
    selecting_ = false;
    session_.view.touch();
}

void Inspector::selectionChanged()
{
    if (selecting_ || !dimmed_) return;
    dimmed_ = session_.view.dimOthers = false;
    session_.view.touch();
}

void Inspector::selectValence(size_t valence, bool orMore)
{
    QPointer<Inspector> self(this);
    session_.jobs.start(tr("Select vertices of valence %1").arg(valence), [self, valence, orMore, mesh = shown_->mesh](Progress&) {
        auto found = std::make_shared<const ElementSet>(verticesOfValence(mesh, valence, orMore));
        return std::function<void()>([self, found] {
            if (self) self->select(*found);
        });
    });
}

void Inspector::frame(const QTreeWidgetItem* row)
{
    const ElementSet* e = elementsOf(row);
    if (!e || !session_.document.scene().find(node_)) return;
    const glm::dmat4 world = session_.document.scene().worldFromLocal(node_);
    const Bounds local = boundsOf(shown_->mesh, *e);
    Bounds b;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p(corner & 1 ? local.max.x : local.min.x, corner & 2 ? local.max.y : local.min.y, corner & 4 ? local.max.z : local.min.z);
        b.add(glm::dvec3(world * glm::dvec4(p, 1)));
    }
    // A single vertex has no size: some of what is around it shows where it is.
    const double least = 0.02 * shown_->mesh.bounds().diagonal();
    if (b.diagonal() < least) b.add(b.centre() - glm::dvec3(least / 2)), b.add(b.centre() + glm::dvec3(least / 2));
    session_.view.frameBounds(b);
}

void Inspector::flash(const QTreeWidgetItem* row)
{
    const ElementSet* e = elementsOf(row);
    if (!e && session_.view.flashes.empty()) return;
    session_.view.flashes.clear();
    if (e) {
        Mark m;
        m.node = node_;
        m.kind = e->kind;
        m.indices = e->indices;
        m.color = {1, 0.42f, 0.37f, 1};
        m.width = e->kind == ElementKind::Vertex ? 8 : 3;
        m.through = true;
        session_.view.flashes.push_back(std::move(m));
    }
    session_.view.touch();
}

void Inspector::repair(const Finding& f, QTreeWidgetItem* row)
{
    Scene next = session_.document.scene();
    const Node* n = next.find(node_);
    if (!n || !n->mesh) return;
    MeshObject object = *next.find(n->mesh);
    const size_t level = std::min(size_t(std::max(0, level_->currentIndex())), object.stack.size());
    Modifier m;
    m.id = next.newModifierId();
    m.operation = f.repair;
    object.stack.insert(object.stack.begin() + long(level), std::move(m));
    const std::string name = object.name + ": add " + operation(f.repair).title;
    next.set(n->mesh, std::move(object));
    QFont struck = row->font(0);
    struck.setStrikeOut(true);
    row->setFont(0, struck);
    session_.document.commit(name, std::move(next));
}

}  // namespace

QWidget* makeInspectorPanel(Session& session, QWidget* parent)
{
    return new Inspector(session, parent);
}

}  // namespace mw
