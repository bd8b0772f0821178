// See inspector_widget.h. The report is made by a job; until it is there the panel says so.
#include "ui/panels/inspector.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QStackedLayout>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/elided.h"
#include "ui/look.h"
#include "ui/panels/inspector_rows.h"
#include "ui/panels/inspector_widget.h"

namespace mw {

namespace {

constexpr size_t largeFaces = 5'000'000;  // from here on measuring is asked for

}  // namespace

Inspector::Inspector(Session& session, QWidget* parent) : QWidget(parent), session_(session)
{
    setObjectName("inspector");
    pages_ = new QStackedLayout(this);
    pages_->addWidget(look::emptyState(this, &message_, &messageButton_));
    connect(messageButton_, &QPushButton::clicked, this, [this] { update(true); });
    makePage();
    subscription_ = session_.document.subscribe([this](const Change& c) {
        if (c.aspects & Aspect::Selection) selectionChanged();
        if (c.aspects & (Aspect::History | Aspect::Evaluation)) unstrike();
        if (c.aspects & (Aspect::Selection | Aspect::Mesh | Aspect::Stack | Aspect::Evaluation | Aspect::Tree)) update(false);
    });
    connect(&session_.jobs, &Jobs::changed, this, [this] {
        for (const Job& j : session_.jobs.jobs())
            if (job_ != 0 && j.id == job_) busyText_->setText(tr("Measuring, %1 %").arg(int(100 * j.progress->fraction)));
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
    top->addWidget(level_ = new ElidedComboBox(page), 1);
    label->setBuddy(level_);
    level_->setObjectName("inspect-level");
    level_->setFocusPolicy(Qt::TabFocus);
    level_->setToolTip(tr("Which level of the modifiers is measured."));
    connect(level_, &QComboBox::activated, this, [this] { update(false); });
    column->addLayout(top);
    column->addWidget(makeCounts(page));
    column->addWidget(busy_ = new QWidget(page));
    auto* line = new QHBoxLayout(busy_);
    line->setContentsMargins(8, 0, 8, 0);
    line->addWidget(busyText_ = new QLabel(tr("Measuring..."), busy_), 1);
    busyText_->setProperty("secondary", true);
    auto* cancel = new QPushButton(tr("Cancel"), busy_);
    cancel->setFixedHeight(20);
    cancel->setFocusPolicy(Qt::TabFocus);
    cancel->setObjectName("inspect-cancel");
    cancel->setToolTip(tr("Stops measuring; what was measured before stays."));
    connect(cancel, &QPushButton::clicked, this, [this] { cancelMeasuring(); });
    line->addWidget(cancel);
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
    tree_->setItemDelegate(new InspectorRows(tree_));
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

// Sentences wrap anew.
void Inspector::resizeEvent(QResizeEvent* e)
{
    QWidget::resizeEvent(e);
    QMetaObject::invokeMethod(
        tree_, [t = tree_] { t->doItemsLayout(); }, Qt::QueuedConnection);
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
    if (job_ != 0 && same(measuring_)) return;
    if (job_ != 0) cancelMeasuring();
    if (shown_ && same(shown_->mesh)) return pages_->setCurrentIndex(1);
    if (mesh.faceCount() > largeFaces && !measureLarge) return showMessage(tr("Not yet measured: the mesh has over 5 million faces."), tr("Measure"));
    measure(mesh, false);
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

void Inspector::cancelMeasuring()
{
    if (job_ != 0) session_.jobs.cancel(job_);
    job_ = 0;
    ++ticket_;
    measuring_ = Mesh();
    busy_->setVisible(false);
    if (!shown_) showMessage(tr("Not measured."), tr("Measure"));
}

void Inspector::measure(const Mesh& mesh, bool everything)
{
    if (job_ != 0) session_.jobs.cancel(job_);
    measuring_ = mesh;
    pages_->setCurrentIndex(1);
    busyText_->setText(tr("Measuring..."));
    busy_->setVisible(true);
    const quint64 ticket = ++ticket_;
    const QString name = QString::fromStdString(session_.document.scene().node(node_).name);
    QPointer<Inspector> self(this);
    job_ = session_.jobs.start(
        tr("Inspect %1").arg(name),
        [self, ticket, mesh, everything](Progress& p) -> std::function<void()> {
            p.at(0);
            auto result = std::make_shared<const Inspection>(inspect(mesh, everything, &p));
            return [self, ticket, result] {
                if (self && self->ticket_ == ticket) self->show(result);
            };
        },
        [self, ticket](const QString& why) {
            if (!self || self->ticket_ != ticket) return;
            self->job_ = 0;
            self->measuring_ = Mesh();
            self->busy_->setVisible(false);
            self->showMessage(why, self->tr("Measure again"));
        });
}

void Inspector::show(std::shared_ptr<const Inspection> i)
{
    job_ = 0;
    measuring_ = Mesh();
    shown_ = std::move(i);
    struck_.clear();
    busy_->setVisible(false);
    pages_->setCurrentIndex(1);
    fill();
}

void Inspector::showMessage(const QString& text, const QString& button)
{
    message_->setText(text);
    messageButton_->setText(button);
    messageButton_->setVisible(!button.isEmpty());
    pages_->setCurrentIndex(0);
}

QWidget* makeInspectorPanel(Session& session, QWidget* parent)
{
    return new Inspector(session, parent);
}

}  // namespace mw
