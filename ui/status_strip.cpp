#include "ui/status_strip.h"

#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <QToolButton>

#include "ui/elided.h"
#include "ui/theme.h"
#include "ui/viewport/frame_builder.h"
#include "ui/words.h"

namespace mw {

StatusStrip::StatusStrip(Session& session, QWidget* parent) : QStatusBar(parent), session_(session)
{
    setSizeGripEnabled(false);
    hint_ = new ElidedLabel(this);
    hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    selection_ = new QLabel(this);
    counts_ = new QLabel(this);
    job_ = new QToolButton(this);
    job_->setText("No jobs");
    job_->setFocusPolicy(Qt::TabFocus);
    job_->setToolTip("Opens the list of jobs");
    selection_->setToolTip("What is selected");
    counts_->setToolTip("Vertices, edges and faces of what is shown");
    bar_ = new QProgressBar(this);
    bar_->setFixedWidth(90);
    bar_->setTextVisible(false);
    bar_->setRange(0, 1000);
    cancel_ = new QToolButton(this);
    cancel_->setIcon(icon("x", tokens().text2));
    cancel_->setAccessibleName("Cancel job");
    cancel_->setToolTip("Cancel the job; the scene stays as it is");
    bar_->setAccessibleName("Progress of the job");
    cancel_->setFocusPolicy(Qt::TabFocus);
    addWidget(hint_, 1);
    for (QWidget* w : {static_cast<QWidget*>(selection_), static_cast<QWidget*>(counts_), static_cast<QWidget*>(job_), static_cast<QWidget*>(bar_),
                       static_cast<QWidget*>(cancel_)})
        addPermanentWidget(w);
    for (QLabel* l : {static_cast<QLabel*>(hint_), selection_, counts_}) l->setContentsMargins(6, 0, 6, 0);
    timer_ = new QTimer(this);
    timer_->setSingleShot(true);
    connect(timer_, &QTimer::timeout, this, [this] { hint_->setText(hintText_); });
    connect(job_, &QToolButton::clicked, this, &StatusStrip::jobsClicked);
    connect(cancel_, &QToolButton::clicked, this, [this] { session_.jobs.cancel(shownJob_); });
    connect(&session_.jobs, &Jobs::changed, this, [this] { refreshJob(); });
    const auto soon = [this] {
        if (pending_) return;
        pending_ = true;
        QMetaObject::invokeMethod(
            this, [this] { refresh(); }, Qt::QueuedConnection);
    };
    subscription_ = session_.document.subscribe([soon](const Change&) { soon(); });
    connect(&session_.view, &ViewState::changed, this, soon);
    connect(&session_.steps, &StepSession::changed, this, soon);
    connect(&session_.steps, &StepSession::closed, this, soon);
    refresh();
    refreshJob();
}

void StatusStrip::setHint(const QString& hint)
{
    hintText_ = hint;
    if (!timer_->isActive()) hint_->setText(hint);
}

void StatusStrip::say(const QString& message)
{
    hint_->setText(message);
    timer_->start(6000);
}

void StatusStrip::refresh()
{
    pending_ = false;
    const Selection& s = session_.document.selection();
    const Scene& scene = session_.document.scene();
    if (s.elementsOf && !s.elements.indices.empty())
        selection_->setText("<b>" + elementsText(s.elements).section(' ', 0, 0) + "</b> " + elementsText(s.elements).section(' ', 1));
    else if (s.nodes.empty())
        selection_->setText("Nothing selected");
    else if (s.nodes.size() == 1)
        selection_->setText("<b>" + nodeName(scene, s.nodes[0]).toHtmlEscaped() + "</b> selected");
    else
        selection_->setText(counted(s.nodes.size(), "node", "nodes") + " selected");
    const Node* n = scene.find(s.active());
    std::optional<Mesh> mesh;
    if (session_.steps.isOpen()) {
        const Value* v = session_.steps.value();
        if (const Mesh* m = v ? std::get_if<Mesh>(v) : nullptr) mesh = *m;
    } else if (n && n->mesh) {
        mesh = shownMesh(session_, n->mesh);
    }
    if (const TerrainObject* ground = n && n->terrain ? scene.find(n->terrain) : nullptr; ground && !mesh)
        return counts_->setText(grouped(ground->terrain.map.width()) + " \u00d7 " + grouped(ground->terrain.map.height()) + " heights");
    if (!mesh) return counts_->setText(allCounts());
    // Edges are counted where the list is there already: never here.
    QString text = "V " + grouped(mesh->vertexCount());
    const bool counted = session_.document.evaluation(n ? n->mesh : MeshId{}) != nullptr && !session_.steps.isOpen();
    if (counted && mesh->positions().id() == session_.document.shownMesh(n->mesh).positions().id())
        text += " · E " + grouped(mesh->edges().size() / 2);
    counts_->setText(text + " · F " + grouped(mesh->faceCount()));
}

// With nothing selected: everything that is shown, together.
QString StatusStrip::allCounts() const
{
    const Scene& scene = session_.document.scene();
    size_t vertices = 0, faces = 0;
    const auto visit = [&](auto&& self, NodeId id) -> void {
        const Node& n = scene.node(id);
        if (!n.visible) return;
        if (n.mesh) {
            const Mesh m = shownMesh(session_, n.mesh);
            vertices += m.vertexCount();
            faces += m.faceCount();
        }
        for (const NodeId child : n.children) self(self, child);
    };
    for (const NodeId root : scene.roots()) visit(visit, root);
    return vertices ? "All: V " + grouped(vertices) + " · F " + grouped(faces) : QString();
}

void StatusStrip::refreshJob()
{
    const Job* longest = nullptr;
    int running = 0;
    for (const Job& j : session_.jobs.jobs()) {
        if (j.state != Job::State::Running || j.clock.elapsed() < 500) continue;
        ++running;
        if (!longest) longest = &j;
    }
    bar_->setVisible(running == 1);
    cancel_->setVisible(running == 1);
    shownJob_ = longest ? longest->id : 0;
    if (!longest) {
        job_->setText("No jobs");
    } else if (running > 1) {
        job_->setText(QString("%1 jobs").arg(running));
    } else {
        job_->setText(QString("%1  %2 %").arg(longest->name).arg(int(100 * longest->progress->fraction)));
        bar_->setValue(int(1000 * longest->progress->fraction));
    }
}

}  // namespace mw
