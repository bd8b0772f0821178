#include "ui/panels/outliner.h"

#include <QDropEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QTimer>
#include <QTreeView>
#include <QVBoxLayout>
#include <map>
#include <set>

#include "render/bones.h"
#include "ui/edit_commands.h"
#include "ui/panels/empty_state.h"
#include "ui/stack_edits.h"
#include "ui/theme.h"
#include "ui/words.h"

namespace mw {
namespace {

enum Columns { NameColumn, CountColumn, EyeColumn, ColumnCount };
constexpr int nodeRole = Qt::UserRole + 1, jointRole = Qt::UserRole + 2;

// Enter frames, rows are dragged onto others; everything else as a tree does.
class Tree : public QTreeView {
public:
    explicit Tree(QWidget* parent) : QTreeView(parent) {}
    std::function<void()> enter;
    std::function<void(const QModelIndex& parent)> dropped;
    void keyboardSearch(const QString&) override {}  // the filter field does it

protected:
    void keyPressEvent(QKeyEvent* e) override
    {
        if ((e->key() == Qt::Key_Return || e->key() == Qt::Key_Enter) && state() != EditingState && enter)
            enter();
        else
            QTreeView::keyPressEvent(e);
    }
    // The tree is made anew by the edit: the view itself moves nothing.
    void dropEvent(QDropEvent* e) override
    {
        const QModelIndex at = indexAt(e->position().toPoint()).siblingAtColumn(NameColumn);
        const QModelIndex parent = dropIndicatorPosition() == OnItem ? at : dropIndicatorPosition() == OnViewport ? QModelIndex() : at.parent();
        const bool own = e->source() == this;
        e->setDropAction(Qt::IgnoreAction);
        e->accept();
        stopAutoScroll();
        setState(NoState);
        viewport()->update();
        if (own && dropped) dropped(parent);
    }
};

class Outliner : public QWidget {
public:
    Outliner(Session& session, QWidget* parent) : QWidget(parent), session_(session)
    {
        auto* box = new QVBoxLayout(this);
        box->setContentsMargins(8, 8, 8, 0);
        box->setSpacing(6);
        filter_ = new QLineEdit(this);
        filter_->setPlaceholderText("Filter nodes and joints");
        filter_->setAccessibleName("Filter nodes and joints");
        filter_->setToolTip("Only nodes whose name has these letters");
        filter_->setClearButtonEnabled(true);
        filter_->addAction(icon("search", tokens().text2), QLineEdit::LeadingPosition);
        tree_ = new Tree(this);
        model_ = new QStandardItemModel(0, ColumnCount, this);
        proxy_ = new QSortFilterProxyModel(this);
        empty_ = emptyStateLabel("The scene is empty. Open a file or drop one on the view.", this);
        box->addWidget(filter_);
        box->addWidget(empty_);
        box->addWidget(tree_, 1);
        setUpTree();
        subscription_ = session_.document.subscribe([this](const Change& c) {
            if (c.aspects & (Aspect::Tree | Aspect::Skin | Aspect::Mesh | Aspect::Stack | Aspect::Evaluation | Aspect::File)) rebuildSoon();
            if (c.aspects & (Aspect::Selection | Aspect::History)) showSelection();
        });
        rebuild();
    }

private:
    void setUpTree()
    {
        proxy_->setSourceModel(model_);
        proxy_->setRecursiveFilteringEnabled(true);
        proxy_->setFilterCaseSensitivity(Qt::CaseInsensitive);
        tree_->setModel(proxy_);
        tree_->setHeaderHidden(true);
        tree_->setAccessibleName("Nodes of the scene");
        tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
        tree_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
        tree_->setIndentation(14);
        tree_->setUniformRowHeights(true);
        tree_->setContextMenuPolicy(Qt::CustomContextMenu);
        auto* header = tree_->header();
        header->setStretchLastSection(false);
        header->setMinimumSectionSize(24);
        header->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
        header->setSectionResizeMode(CountColumn, QHeaderView::ResizeToContents);
        header->setSectionResizeMode(EyeColumn, QHeaderView::Fixed);
        header->resizeSection(EyeColumn, 28);
        connect(filter_, &QLineEdit::textChanged, this, [this](const QString& t) {
            proxy_->setFilterFixedString(t);
            tree_->expandAll();
        });
        connect(tree_, &QTreeView::clicked, this, [this](const QModelIndex& i) {
            if (i.column() != EyeColumn) return;
            const NodeId id = nodeAt(i);
            edits::setVisible(session_.document, {id}, !session_.document.scene().node(id).visible);
        });
        connect(tree_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] { takeSelection(); });
        connect(model_, &QStandardItemModel::itemChanged, this, [this](QStandardItem* item) {
            if (!filling_ && item->column() == NameColumn) edits::rename(session_.document, {item->data(nodeRole).toUInt()}, item->text());
        });
        connect(tree_, &QTreeView::customContextMenuRequested, this, [this](const QPoint& p) { menu(tree_->viewport()->mapToGlobal(p)); });
        for (auto [signal, open] : {std::pair{&QTreeView::expanded, true}, {&QTreeView::collapsed, false}})
            connect(tree_, signal, this, [this, open = open](const QModelIndex& i) {
                if (filling_ || !i.data(jointRole).toBool()) return;
                if (open)
                    unfolded_.insert(nodeAt(i));
                else
                    unfolded_.erase(nodeAt(i));
            });
        tree_->setDragEnabled(true);
        tree_->setAcceptDrops(true);
        tree_->setDragDropMode(QAbstractItemView::InternalMove);
        tree_->dropped = [this](const QModelIndex& parent) {
            const Scene& scene = session_.document.scene();
            edits::run(session_, {"reparent",
                                  {{"nodes", nodeText(scene, session_.document.selection().nodes)},
                                   {"to", parent.isValid() ? nodeText(scene, nodeAt(parent)) : std::string()}}});
        };
        tree_->enter = [this] { session_.view.frameNodes(session_.document.selection().nodes); };
    }

    NodeId nodeAt(const QModelIndex& i) const { return {i.siblingAtColumn(NameColumn).data(nodeRole).toUInt()}; }

    void rebuildSoon()
    {
        if (pending_) return;
        pending_ = true;
        QTimer::singleShot(0, this, [this] { rebuild(); });
    }

    QList<QStandardItem*> rowOf(NodeId id)
    {
        const Node& n = session_.document.scene().node(id);
        const bool joint = n.joint != Node::Joint::No;
        auto* name = new QStandardItem(icon(n.mesh      ? "mesh"
                                            : n.terrain ? "terrain"
                                            : joint     ? "bone"
                                                        : "tree"),
                                       nodeName(session_.document.scene(), id));
        const size_t users = n.mesh ? session_.document.scene().users(n.mesh) : 0;
        auto* counts = new QStandardItem(n.mesh ? countsText(session_.document.shownMesh(n.mesh)) : QString());
        if (users > 1) counts->setText(counted(users, "user", "users") + ", " + counts->text());
        auto* eye = new QStandardItem(icon(n.visible ? "eye" : "eye-off", n.visible ? QColor() : tokens().text3), QString());
        name->setData(id.value, nodeRole);
        name->setData(joint, jointRole);
        if (joint) {
            const glm::vec3 c = colors_.at(id);
            counts->setIcon(chip(QColor::fromRgbF(c.r, c.g, c.b)));
            counts->setToolTip("The colour of its bone");
        }
        name->setEditable(true);
        counts->setEditable(false);
        counts->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        eye->setEditable(false);
        eye->setToolTip(n.visible ? "Hide (H)" : "Show (H)");
        eye->setData(n.visible ? "shown" : "hidden", Qt::AccessibleTextRole);
        if (!n.visible) name->setForeground(tokens().text3);
        if (users > 1) name->setToolTip(QString("%1 nodes show this mesh").arg(users));
        for (NodeId child : n.children) name->appendRow(rowOf(child));
        return {name, counts, eye};
    }

    void rebuild()
    {
        pending_ = false;
        filling_ = true;
        model_->removeRows(0, model_->rowCount());
        colors_ = boneColors(session_.document.scene());
        for (NodeId id : session_.document.scene().roots()) model_->appendRow(rowOf(id));
        tree_->expandAll();
        foldJoints();
        filling_ = false;
        const bool any = model_->rowCount() > 0;
        empty_->setVisible(!any);
        tree_->setVisible(any);
        filter_->setEnabled(any);
        showSelection();
    }

    // Skeletons are long: they open when asked to, and stay so.
    void foldJoints()
    {
        visit({}, [&](const QModelIndex& i) {
            if (i.data(jointRole).toBool() && !unfolded_.count(nodeAt(i))) tree_->collapse(i);
        });
    }

    QIcon chip(const QColor& color) const
    {
        const qreal ratio = devicePixelRatioF();
        QPixmap picture(QSize(16, 16) * ratio);
        picture.setDevicePixelRatio(ratio);
        picture.fill(Qt::transparent);
        QPainter p(&picture);
        p.setRenderHint(QPainter::Antialiasing);
        p.setPen(Qt::NoPen);
        p.setBrush(color);
        p.drawRoundedRect(QRectF(4, 4, 8, 8), 2, 2);
        return QIcon(picture);
    }

    void visit(const QModelIndex& parent, const std::function<void(const QModelIndex&)>& f)
    {
        for (int r = 0; r < proxy_->rowCount(parent); ++r) {
            const QModelIndex i = proxy_->index(r, 0, parent);
            f(i);
            visit(i, f);
        }
    }

    void showSelection()
    {
        filling_ = true;
        const Selection& s = session_.document.selection();
        tree_->selectionModel()->clearSelection();
        visit({}, [&](const QModelIndex& i) {
            if (!s.has(nodeAt(i))) return;
            tree_->selectionModel()->select(i, QItemSelectionModel::Select | QItemSelectionModel::Rows);
            for (QModelIndex up = i.parent(); up.isValid(); up = up.parent()) tree_->expand(up);
            if (nodeAt(i) == s.active()) {
                tree_->selectionModel()->setCurrentIndex(i, QItemSelectionModel::NoUpdate);
                tree_->scrollTo(i);
            }
        });
        filling_ = false;
    }

    void takeSelection()
    {
        if (filling_) return;
        std::vector<NodeId> nodes;
        const NodeId current = nodeAt(tree_->currentIndex());
        for (const QModelIndex& i : tree_->selectionModel()->selectedRows())
            if (nodeAt(i) != current) nodes.push_back(nodeAt(i));
        if (tree_->selectionModel()->isRowSelected(tree_->currentIndex().row(), tree_->currentIndex().parent())) nodes.push_back(current);
        session_.document.select({nodes, {}, {}});
    }

    void menu(const QPoint& at)
    {
        const auto nodes = session_.document.selection().nodes;
        if (nodes.empty()) return;
        auto* m = new QMenu(this);
        m->setAttribute(Qt::WA_DeleteOnClose);
        const bool shown = session_.document.scene().node(nodes.back()).visible;
        m->addAction(icon("frame"), "Frame", this, [this, nodes] { session_.view.frameNodes(nodes); });
        m->addAction("Rename", this, [this] { tree_->edit(tree_->currentIndex().siblingAtColumn(NameColumn)); });
        m->addAction(shown ? "Hide" : "Show", this, [this, nodes, shown] { edits::setVisible(session_.document, nodes, !shown); });
        m->addSeparator();
        const auto edit = [&](const QString& text, edits::SelectionEdit which, bool linked = false) {
            QAction* a = m->addAction(text, this, [this, which, linked] { edits::run(session_, which, linked); });
            const QString why = edits::whyNot(session_.document, which);
            a->setEnabled(why.isEmpty());
            a->setToolTip(why);
        };
        m->setToolTipsVisible(true);
        edit("Duplicate", edits::SelectionEdit::Duplicate);
        edit("Duplicate linked", edits::SelectionEdit::Duplicate, true);
        edit("Make own copy", edits::SelectionEdit::OwnCopy);
        edit("Join", edits::SelectionEdit::Join);
        edit("Separate by components", edits::SelectionEdit::SeparateParts);
        edit("Separate by material", edits::SelectionEdit::SeparateMaterials);
        edit("Group", edits::SelectionEdit::Group);
        m->addSeparator();
        m->addAction("Delete", this, [this, nodes] { edits::removeNodes(session_, nodes); });
        m->popup(at);
    }

    void keyPressEvent(QKeyEvent* e) override
    {
        if (e->key() == Qt::Key_Delete)
            edits::removeNodes(session_, session_.document.selection().nodes);
        else
            QWidget::keyPressEvent(e);
    }

    Session& session_;
    QLineEdit* filter_;
    Tree* tree_;
    QLabel* empty_;
    QStandardItemModel* model_;
    QSortFilterProxyModel* proxy_;
    std::shared_ptr<void> subscription_;
    std::map<NodeId, glm::vec3> colors_;
    std::set<NodeId> unfolded_;
    bool filling_ = false, pending_ = false;
};

}  // namespace

QWidget* makeOutlinerPanel(Session& session, QWidget* parent)
{
    return new Outliner(session, parent);
}

}  // namespace mw
