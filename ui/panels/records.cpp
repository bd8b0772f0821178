// See records_widget.h. Half-edges of a large mesh are made by a job; the panel is about the mesh as shown, and looks nowhere while it is hidden.
#include "ui/panels/records.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QStackedLayout>
#include <QTableWidget>
#include <QToolButton>

#include "core/mesh/same_mesh.h"
#include "ui/look.h"
#include "ui/panels/records_widget.h"
#include "ui/viewport/frame_builder.h"

namespace mw {

namespace {

constexpr size_t atOnce = 30'000;  // faces: half-edges in a few milliseconds

PickKind pickKindOf(ElementKind kind)
{
    return kind == ElementKind::Vertex ? PickKind::Vertex : kind == ElementKind::Edge ? PickKind::Edge : PickKind::Face;
}

}  // namespace

Records::Records(Session& session, QWidget* parent) : QWidget(parent), session_(session)
{
    setObjectName("records");
    pages_ = new QStackedLayout(this);
    pages_->addWidget(look::emptyState(this, &message_, &messageButton_));
    message_->setProperty("secondary", true);
    connect(messageButton_, &QPushButton::clicked, this, [this] { messageClicked(); });
    makePage();
    subscription_ = session_.document.subscribe([this](const Change& c) {
        if (c.aspects & (Aspect::Selection | Aspect::Mesh | Aspect::Stack | Aspect::Evaluation | Aspect::Tree | Aspect::Transform | Aspect::History |
                         Aspect::File))
            update();
    });
    connect(&session_.view, &ViewState::changed, this, [this] {
        const Node* n = session_.document.scene().find(node_);
        if (isVisible() && n && n->mesh && !sameMesh(shownMesh(session_, n->mesh), wanted_)) update();  // another level is shown
    });
    showMessage(tr("Select a mesh to see its records."), {});
}

// The node whose elements are selected, else the active one, else the only mesh there is.
NodeId Records::wantedNode() const
{
    const Scene& s = session_.document.scene();
    const auto hasMesh = [&](NodeId id) {
        const Node* n = s.find(id);
        return n && n->mesh;
    };
    const Selection& selection = session_.document.selection();
    if (hasMesh(selection.elementsOf) && !selection.elements.indices.empty()) return selection.elementsOf;
    if (hasMesh(selection.active())) return selection.active();
    NodeId only;
    for (const NodeId id : s.nodes())
        if (hasMesh(id)) {
            if (only) return {};
            only = id;
        }
    return only;
}

void Records::update()
{
    if (!isVisible() || selecting_) return;
    const NodeId node = wantedNode();
    if (!node) {
        node_ = {};
        mesh_.reset();
        wanted_ = Mesh();
        stand({});
        return showMessage(tr("Select a mesh to see its records."), {});
    }
    const Mesh mesh = shownMesh(session_, session_.document.scene().node(node).mesh);
    const bool other = node != node_ || !sameMesh(mesh, wanted_);
    node_ = node;
    if (!other && mesh_) return followSelection();
    if (!other) return;  // on its way
    path_.clear();
    pathAt_ = 0;
    prepare(mesh);
}

void Records::prepare(const Mesh& mesh)
{
    if (job_ != 0) session_.jobs.cancel(job_);
    job_ = 0;
    wanted_ = mesh;
    mesh_.reset();
    const quint64 ticket = ++ticket_;
    if (mesh.faceCount() <= atOnce) return take(std::make_shared<const RecordMesh>(mesh));
    stand({});
    showMessage(tr("Making the half-edges of %1 faces...").arg(look::count(mesh.faceCount())), {});
    QPointer<Records> self(this);
    const QString name = QString::fromStdString(session_.document.scene().node(node_).name);
    job_ = session_.jobs.start(
        tr("Half-edges of %1").arg(name),
        [self, ticket, mesh](Progress& p) -> std::function<void()> {
            p.at(0);
            auto made = std::make_shared<const RecordMesh>(mesh);
            return [self, ticket, made] {
                if (self && self->ticket_ == ticket) self->take(made);
            };
        },
        [self, ticket](const QString& why) {
            if (!self || self->ticket_ != ticket) return;
            self->job_ = 0;
            self->showMessage(why, {});
        });
}

void Records::take(std::shared_ptr<const RecordMesh> m)
{
    job_ = 0;
    mesh_ = std::move(m);
    followSelection();
}

// What is selected is where the panel stands. A half-edge is more than the edge that is selected for it: it stays.
void Records::followSelection()
{
    const Selection& selection = session_.document.selection();
    const ElementSet elements = selection.elementsOf == node_ ? selection.elements : ElementSet{};
    const RecordLink link = mw::linkOf(*mesh_, elements);
    if (link.to == RecordLink::To::Nothing) {
        stand({});
        const QString name = QString::fromStdString(session_.document.scene().node(node_).name);
        if (mesh_->mesh.faceCount() == 0) return showMessage(tr("%1 has no faces, so nothing has neighbours.").arg(name), {});
        return showMessage(tr("Click a vertex, an edge or a face of %1 to see what the mesh structures store there.").arg(name),
                           session_.view.pickKind == PickKind::Object || session_.view.pickKind == PickKind::Joint ? tr("Pick vertices")
                                                                                                                   : tr("Start at the first face"));
    }
    if (mw::elementsOf(*mesh_, here_).indices == elements.indices && mw::elementsOf(*mesh_, here_).kind == elements.kind) return stand(here_);
    path_.resize(std::min(path_.size(), pathAt_ + 1));
    path_.push_back(link);
    pathAt_ = path_.size() - 1;
    stand(link);
}

void Records::showMessage(const QString& text, const QString& button)
{
    message_->setText(text);
    messageButton_->setText(button);
    messageButton_->setToolTip(button == tr("Pick vertices") ? tr("Clicks in the view pick vertices of the mesh (Ctrl+2)")
                                                             : tr("Shows the records of the first face; links lead on from there"));
    messageButton_->setVisible(!button.isEmpty());
    pages_->setCurrentIndex(0);
}

void Records::messageClicked()
{
    if (!mesh_ || !node_) return;
    if (session_.view.pickKind == PickKind::Object || session_.view.pickKind == PickKind::Joint) {
        session_.view.pickKind = PickKind::Vertex;
        session_.view.touch();
        return followSelection();
    }
    go({RecordLink::To::Face, 0});
}

/// Moves the pick, as a click in the view would, and remembers where it was.
void Records::go(RecordLink link)
{
    if (!mesh_ || link.to == RecordLink::To::Nothing) return;
    path_.resize(std::min(path_.size(), pathAt_ + 1));
    path_.push_back(link);
    pathAt_ = path_.size() - 1;
    here_ = link;
    selectHere();
}

void Records::travel(int by)
{
    if (!mesh_ || (by < 0 && pathAt_ == 0) || (by > 0 && pathAt_ + 1 >= path_.size())) return;
    pathAt_ += size_t(by);
    here_ = path_[pathAt_];
    selectHere();
}

void Records::selectHere()
{
    select(mw::elementsOf(*mesh_, here_));
    stand(here_);
}

void Records::select(const ElementSet& elements)
{
    if (!session_.document.scene().find(node_)) return;
    selecting_ = true;
    session_.view.flashes.clear();
    session_.view.pickKind = pickKindOf(elements.kind);
    session_.document.select({{node_}, node_, elements});
    session_.view.touch();
    selecting_ = false;
}

void Records::stand(RecordLink link)
{
    here_ = link;
    place_ = mesh_ ? placeOf(mesh_->walk, link) : RecordPlace();
    if (link.to != RecordLink::To::Nothing) {
        pages_->setCurrentIndex(1);
        fill();
    }
    draw();
}

void Records::hideEvent(QHideEvent*)
{
    flash(nullptr);
    draw();
}

void Records::changeEvent(QEvent* e)
{
    QWidget::changeEvent(e);
    if (e->type() == QEvent::PaletteChange && mesh_ && here_.to != RecordLink::To::Nothing) fill();
}

bool Records::eventFilter(QObject* o, QEvent* e)
{
    if (o == table_ && e->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(e);
        if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
            follow(table_->currentItem());
            return true;
        }
        if (key->modifiers() & Qt::AltModifier && (key->key() == Qt::Key_Left || key->key() == Qt::Key_Right)) {
            travel(key->key() == Qt::Key_Left ? -1 : 1);
            return true;
        }
    }
    return QWidget::eventFilter(o, e);
}

QWidget* makeRecordsPanel(Session& session, QWidget* parent)
{
    return new Records(session, parent);
}

}  // namespace mw
