#include "ui/viewport/viewport.h"

#include <QOpenGLContext>
#include <QWindow>
#include <algorithm>
#include <cmath>

#include "render/picture_target.h"
#include "ui/evaluation_service.h"
#include "ui/theme.h"
#include "ui/variants.h"
#include "ui/viewport/brush_tool.h"
#include "ui/viewport/collapse_tool.h"
#include "ui/viewport/cut_tool.h"
#include "ui/viewport/measure_tool.h"
#include "ui/viewport/region_tool.h"
#include "ui/viewport/select_tool.h"
#include "ui/viewport/step_frame.h"
#include "ui/viewport/transform_tool.h"

namespace mw {

Viewport::Viewport(Session& session, std::shared_ptr<HeatService> heats, int view, QWidget* parent)
    : QOpenGLWidget(parent), session_(session), heats_(std::move(heats)), view_(view)
{
    tools_[size_t(ToolKind::Select)] = std::make_unique<SelectTool>(*this);
    tools_[size_t(ToolKind::Box)] = std::make_unique<RegionTool>(*this, false);
    tools_[size_t(ToolKind::Lasso)] = std::make_unique<RegionTool>(*this, true);
    for (const ToolKind k : {ToolKind::Move, ToolKind::Rotate, ToolKind::Scale}) tools_[size_t(k)] = std::make_unique<TransformTool>(*this, k);
    tools_[size_t(ToolKind::Measure)] = std::make_unique<MeasureTool>(*this);
    tools_[size_t(ToolKind::Collapse)] = std::make_unique<CollapseTool>(*this);
    tools_[size_t(ToolKind::Cut)] = std::make_unique<CutTool>(*this);
    auto brush = std::make_unique<BrushTool>(*this);
    brush_ = brush.get();
    tools_[size_t(ToolKind::Brush)] = std::move(brush);
    setObjectName(view_ == 0 ? QString("viewport") : QString("viewport%1").arg(view_ + 1));
    setAccessibleName(view_ == 0 ? QString("View") : QString("View %1").arg(view_ + 1));
    setAccessibleDescription("The scene. Click picks, drag orbits.");
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(240, 180);
    subscription_ = session_.document.subscribe([this](const Change&) { refresh(); });
    connect(&session_.view, &ViewState::changed, this, &Viewport::refresh);
    connect(&session_.view, &ViewState::timeChanged, this, &Viewport::refresh);
    connect(&session_.view, &ViewState::camerasFollowed, this, [this] { update(); });
    connect(&session_.view, &ViewState::frameRequested, this, [this](const std::vector<NodeId>& nodes) {
        if (session_.view.activeView() == view_) showFrame(boundsOfNodes(nodes), true);
    });
    connect(&session_.view, &ViewState::boundsRequested, this, [this](const Bounds& b) {
        if (session_.view.activeView() == view_) showFrame(b, true);
    });
    connect(&session_.steps, &StepSession::changed, this, [this] {
        refresh();
        followFocus();
    });
    for (auto signal : {&StepSession::opened, &StepSession::closed})
        connect(&session_.steps, signal, this, [this] {
            enterOrLeaveLab();
            refresh();
            say({});
        });
    connect(heats_.get(), &HeatService::ready, this, &Viewport::refresh);
    if (session_.evaluations) connect(&session_.evaluations->variants(), &VariantService::changed, this, &Viewport::refresh);
    connect(heats_.get(), &HeatService::failed, this, &Viewport::failed);
    connect(&session_.view, &ViewState::toolChanged, this, &Viewport::toolChanged);
    connect(&session_.view, &ViewState::brushChanged, this, [this] {
        if (session_.view.tool == ToolKind::Brush) brush_->tell();
        update();
        if (underMouse()) say({});
    });
    connect(&session_.view, &ViewState::groundChanged, this, [this] {
        if (session_.view.tool == ToolKind::Brush) update();
    });
    hoverTimer_.setSingleShot(true);
    hoverTimer_.setInterval(30);
    connect(&hoverTimer_, &QTimer::timeout, this, &Viewport::hover);
    flight_.setDuration(180);
    flight_.setStartValue(0.0);
    flight_.setEndValue(1.0);
    flight_.setEasingCurve(QEasingCurve::OutCubic);
}

Viewport::~Viewport()
{
    makeCurrent();
    renderer_.reset();
    doneCurrent();
}

void Viewport::initializeGL()
{
    // With shared contexts a floated window keeps the context; when the platform made a new one anyway, everything is uploaded again.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
        makeCurrent();
        renderer_.reset();
        doneCurrent();
    });
    try {
        renderer_ = std::make_unique<Renderer>();
    } catch (const std::exception& e) {
        emit failed(QString::fromUtf8(e.what()));
    }
}

void Viewport::refresh()
{
    stale_ = true;
    if (!session_.view.hovered && session_.steps.isOpen()) hoverMark_.reset();
    update();
}

const Frame& Viewport::frame()
{
    if (!stale_) return frame_;
    stale_ = false;
    frame_ = buildFrame(session_, look(), *heats_);
    ++framesBuilt_;
    frame_.options.pixelRatio = devicePixelRatioF();
    return frame_;
}

void Viewport::paintGL()
{
    if (!renderer_) return;
    ++framesDrawn_;
    frame();
    const Bounds bounds = boundsOf(frame_);
    look().camera.fitClip(bounds);
    frame_.camera = look().camera;
    const size_t marks = frame_.marks.size(), points = frame_.points.size(), labels = frame_.labels.size();
    if (hoverMark_ && !session_.steps.isOpen()) frame_.marks.push_back(*hoverMark_);
    if (hoverValue_ && !look().colourBy.isEmpty() && !session_.steps.isOpen() && tool().marksHover()) frame_.labels.push_back(*hoverValue_);
    if (dragTool_ && dragTool_ != &tool()) dragTool_->decorate(frame_);
    if (toolIdle() && (session_.view.tool != ToolKind::Brush || drag_ == Drag::None || drag_ == Drag::Pending || drag_ == Drag::Tool))
        tool().decorate(frame_);
    // The brush lies on the ground itself; all else that tools show lies over the scene.
    if (std::none_of(frame_.terrains.begin(), frame_.terrains.end(), [](const DrawTerrain& t) { return t.brush.has_value(); }))
        frame_.scene = framesBuilt_;
    try {
        renderer_->draw(frame_, defaultFramebufferObject(), deviceSize());
    } catch (const std::exception& e) {
        emit failed(QString::fromUtf8(e.what()));
        renderer_.reset();
    }
    frame_.marks.resize(marks);
    frame_.points.resize(points);
    frame_.labels.resize(labels);
    frame_.flats.clear();
    frame_.scene = 0;
    for (DrawTerrain& t : frame_.terrains) t.brush.reset();
    drawn_ = renderer_ ? renderer_->counts() : Renderer::Counts();
    emit painted();
}

Picture Viewport::picture(const Frame& of, glm::ivec2 size)
{
    if (!renderer_) throw Error("the graphics driver cannot draw, so there is no picture");
    makeCurrent();
    PictureTarget target;
    return target.draw(*renderer_, of, size.x, size.y);
}

glm::ivec2 Viewport::deviceSize() const
{
    const double r = devicePixelRatioF();
    return {int(std::lround(width() * r)), int(std::lround(height() * r))};
}

const Frame& Viewport::seen()
{
    frame();
    frame_.camera = look().camera;
    return frame_;
}

std::vector<std::pair<NodeId, std::vector<uint32_t>>> Viewport::visibleFaces(const Region& region)
{
    if (!renderer_) return {};
    seen();
    makeCurrent();
    auto faces = renderer_->visibleFaces(frame_, deviceSize(), region);
    doneCurrent();
    return faces;
}

std::optional<Pick> Viewport::pickAt(QPointF at)
{
    if (!renderer_ || !rect().contains(at.toPoint())) return std::nullopt;
    seen();
    makeCurrent();
    const double r = devicePixelRatioF();
    const auto pick = renderer_->pick(frame_, deviceSize(), {at.x() * r, at.y() * r});
    doneCurrent();
    return pick;
}

Bounds Viewport::boundsOfNodes(const std::vector<NodeId>& nodes)
{
    if (nodes.empty()) return boundsOf(frame());
    Frame part;
    const auto within = [&](NodeId node, NodeId n) {
        while (node && node != n) node = session_.document.scene().node(node).parent;
        return node == n;
    };
    for (NodeId n : nodes) {
        for (const DrawObject& o : frame().objects)
            if (within(o.node, n)) part.objects.push_back(o);
        for (const DrawBone& b : frame().bones)
            if (within(b.node, n)) part.bones.push_back(b);
        for (const DrawTerrain& t : frame().terrains)
            if (within(t.node, n)) part.terrains.push_back(t);
    }
    return boundsOf(part);
}

void Viewport::frameAll(bool fly)
{
    showFrame(boundsOf(frame()), fly);
}

Bounds Viewport::focusBounds()
{
    return stepFocusBounds(session_, frame());
}

// A lab has a camera of its own; the scene's comes back with the scene.
void Viewport::enterOrLeaveLab()
{
    const bool lab = isLab(session_.steps);
    if (lab && (!beforeLab_ || labOf_ != session_.steps.operation())) {
        if (!beforeLab_) beforeLab_ = look().camera;
        labOf_ = session_.steps.operation();
        flight_.stop();
        lookAtLab(session_, look().camera, double(width()) / std::max(1, height()));
        // Docks may come and go with the workspace: once more when the view has its size.
        QTimer::singleShot(0, this, [this] {
            if (!isLab(session_.steps) || session_.steps.position() > 0) return;
            lookAtLab(session_, look().camera, double(width()) / std::max(1, height()));
            update();
        });
    } else if (!lab && beforeLab_) {
        flight_.stop();
        look().camera = *beforeLab_;
        beforeLab_.reset();
        labOf_ = nullptr;
    } else {
        return;
    }
    emit cameraMoved();
    session_.view.touch();  // the header says what kind of camera it is
}

// From the middle of the scene through the focus outwards: there it is seen on anything that bulges.
Camera Viewport::facing(const Bounds& focus)
{
    Camera to = look().camera;
    const glm::dvec3 out = focus.centre() - boundsOf(frame()).centre();
    if (glm::length(out) == 0) return to;
    const glm::dvec3 d = glm::normalize(out);
    to.azimuth = std::atan2(d.x, d.z);
    to.elevation = std::clamp(std::asin(d.y), -1.2, 1.2);
    return to;
}

void Viewport::followFocus()
{
    if (session_.view.activeView() != view_) return;
    if (!session_.steps.isOpen() || session_.steps.playing() || session_.steps.seeking() || drag_ != Drag::None) return;
    const Value* value = session_.steps.value();
    if (isLab(session_.steps) || (value && kindOf(*value) == Kind::Pose)) return;  // all of it is in view, and seen through what hides it
    const Bounds focus = focusBounds();
    // Many elements, or all, are no place to look at.
    const double scene = boundsOf(frame()).diagonal();
    if (focus.empty || focus.diagonal() > 0.5 * scene) return;
    const glm::dvec3 at = look().camera.project(focus.centre(), logicalSize());
    const bool inside = at.x > 0 && at.y > 0 && at.x < width() && at.y < height();
    if (inside) {
        const auto pick = pickAt({at.x, at.y});
        if (!pick || glm::length(pick->atWorld - focus.centre()) < focus.diagonal() + 0.02 * scene) return;
    }
    Camera to = facing(focus);
    if (!inside) to.target = focus.centre();
    flyTo(to);
}

void Viewport::frameSelection()
{
    if (session_.steps.isOpen()) {
        Bounds focus = focusBounds();
        if (focus.empty) return frameAll();
        // With some of what is round it.
        const glm::dvec3 reach(std::max(focus.diagonal(), 1e-3 * boundsOf(frame()).diagonal()));
        focus.add(focus.min - reach);
        focus.add(focus.max + reach);
        Camera to = isLab(session_.steps) ? look().camera : facing(focus);
        to.frame(focus, double(width()) / std::max(1, height()));
        return flyTo(to);
    }
    const Selection& s = session_.document.selection();
    if (s.elementsOf && !s.elements.indices.empty()) {
        for (const DrawObject& o : frame().objects) {
            if (o.node != s.elementsOf) continue;
            Bounds b;
            const Shared<glm::vec3> places = o.pose ? posedPositions(o.mesh, *o.pose) : o.mesh.positions();
            const auto add = [&](uint32_t v) {
                if (v < places.size()) b.add(glm::dvec3(o.worldFromLocal * glm::dvec4(glm::dvec3(places[v]), 1)));
            };
            for (uint32_t i : s.elements.indices)
                if (s.elements.kind != ElementKind::Face) {
                    add(i);
                } else if (i < o.mesh.faceCount()) {
                    for (uint32_t v : o.mesh.face(i)) add(v);
                }
            if (!b.empty && b.diagonal() == 0) {  // a single point: some of what is round it
                const double reach = 0.03 * boundsOf(frame()).diagonal();
                b.add(b.min - glm::dvec3(reach));
                b.add(b.max + glm::dvec3(reach));
            }
            return showFrame(b, true);
        }
    }
    showFrame(boundsOfNodes(s.nodes), true);
}

void Viewport::showFrame(const Bounds& bounds, bool fly)
{
    if (bounds.empty) return;
    Camera to = look().camera;
    to.frame(bounds, double(width()) / std::max(1, height()));
    if (fly) return flyTo(to);
    look().camera = to;
    moved();
}

void Viewport::flyTo(const Camera& to)
{
    flight_.stop();
    flight_.disconnect(this);
    if (reducedMotion()) {
        look().camera = to;
        return moved();
    }
    const Camera from = look().camera;
    connect(&flight_, &QVariantAnimation::valueChanged, this, [this, from, to](const QVariant& v) {
        const double t = v.toDouble();
        Camera& c = look().camera;
        c = to;
        if (t < 1) {
            c.target = glm::mix(from.target, to.target, t);
            c.distance = std::exp(glm::mix(std::log(from.distance), std::log(to.distance), t));
            c.azimuth = from.azimuth + t * std::remainder(to.azimuth - from.azimuth, 2 * M_PI);
            c.elevation = glm::mix(from.elevation, to.elevation, t);
        }
        session_.view.follow(view_);
        update();
        if (t >= 1) emit cameraMoved();
    });
    flight_.start();
}

void Viewport::lookFrom(const QString& view)
{
    static const std::map<QString, QString> opposite{{"front", "back"}, {"right", "left"}, {"top", "bottom"}};
    Camera to = look().camera;
    setView(to, view.toStdString());
    const Camera& now = look().camera;
    const auto same = [](double a, double b) { return std::abs(std::remainder(a - b, 2 * M_PI)) < 1e-6; };
    if (const auto other = opposite.find(view); other != opposite.end() && same(now.azimuth, to.azimuth) && same(now.elevation, to.elevation))
        setView(to, other->second.toStdString());
    flyTo(to);
}

bool Viewport::abortDrag()
{
    Tool* busy = dragTool_ ? dragTool_ : toolIdle() ? &tool() : nullptr;
    if (!busy || !busy->abort()) return false;
    if (drag_ == Drag::Tool) drag_ = Drag::None;
    dragTool_ = nullptr;
    showCursor();
    return true;
}

bool Viewport::toolIdle() const
{
    return !session_.steps.isOpen();
}

void Viewport::showCursor()
{
    setCursor(toolIdle() ? tool().cursor() : Qt::ArrowCursor);
}

void Viewport::moved()
{
    session_.view.follow(view_);
    update();
    emit cameraMoved();
}

void Viewport::toolChanged()
{
    if (dragTool_) {  // another tool was taken in the middle of a drag
        dragTool_->abort();
        dragTool_ = nullptr;
        drag_ = Drag::None;
    }
    if (!toolIdle() || !tool().marksHover()) {
        hoverMark_.reset();
        session_.view.hovered = {};
    }
    showCursor();
    refresh();
    say({});
}

}  // namespace mw
