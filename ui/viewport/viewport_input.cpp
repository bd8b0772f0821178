// Pointer events of the view: click to pick, drag to look (ui/UI.md 3).
#include <QGuiApplication>
#include <QLineF>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "core/mesh/select.h"
#include "render/bones.h"
#include "ui/selection_commands.h"
#include "ui/variants.h"
#include "ui/viewport/brush_tool.h"
#include "ui/viewport/heat_probe.h"
#include "ui/viewport/region_tool.h"
#include "ui/viewport/step_frame.h"
#include "ui/viewport/viewport.h"

namespace mw {
namespace {

constexpr double dragThreshold = 4;

}  // namespace

void Viewport::mousePressEvent(QMouseEvent* e)
{
    if (drag_ != Drag::None) return;
    setFocus(Qt::MouseFocusReason);
    session_.view.activate(view_);
    flight_.stop();
    button_ = e->button();
    modifiers_ = e->modifiers();
    pressed_ = last_ = e->position();
    drag_ = Drag::Pending;
    if (button_ != Qt::LeftButton || !toolIdle() || !markerView(pressed_).isEmpty()) return;
    if (!tool().press(eventAt(pressed_, modifiers_))) return;
    dragTool_ = &tool();
    drag_ = Drag::Tool;
    pointAt(pressed_);
}

void Viewport::beginDrag(QPointF)
{
    const bool alt = modifiers_ & Qt::AltModifier, shift = modifiers_ & Qt::ShiftModifier;
    if (button_ == Qt::LeftButton && toolIdle()) {
        const PointerEvent begin = eventAt(pressed_, modifiers_);
        if (tool().beginDrag(begin)) {
            dragTool_ = &tool();
        } else if (!alt && shift) {
            auto& region = static_cast<RegionTool&>(tool(modifiers_ & Qt::ControlModifier ? ToolKind::Lasso : ToolKind::Box));
            region.beginQuick(begin);
            dragTool_ = &region;
        }
        if (dragTool_) {
            drag_ = Drag::Tool;
            setCursor(dragTool_->cursor());
            return;
        }
    }
    if (button_ == Qt::LeftButton || (button_ == Qt::MiddleButton && !shift && !alt)) {
        drag_ = Drag::Orbit;
        const auto pick = pickAt(pressed_);
        const Bounds all = boundsOf(frame());
        pivot_ = pick ? pick->atWorld : all.empty ? look().camera.target : all.centre();
        setCursor(Qt::ClosedHandCursor);
    } else if (button_ == Qt::RightButton && alt) {
        drag_ = Drag::Zoom;
    } else {
        drag_ = Drag::Pan;
        setCursor(Qt::SizeAllCursor);
    }
}

void Viewport::drag(QPointF at)
{
    const glm::dvec2 delta{at.x() - last_.x(), at.y() - last_.y()};
    Camera& c = look().camera;
    switch (drag_) {
        case Drag::Orbit:
            c.orbit(delta, pivot_);
            break;
        case Drag::Pan:
            c.pan(delta, logicalSize());
            break;
        case Drag::Zoom:
            c.zoom(-delta.y / 40, {pressed_.x(), pressed_.y()}, logicalSize());
            break;
        default:
            return;
    }
    moved();
}

void Viewport::mouseMoveEvent(QMouseEvent* e)
{
    const QPointF at = e->position();
    if (drag_ == Drag::None) {
        say(e->modifiers());
        last_ = at;
        pointAt(at);
        if (!toolIdle()) return;
        tool().hover(eventAt(at, e->modifiers()));
        showCursor();
        hoverTimer_.start();
        return;
    }
    if (drag_ == Drag::Pending) {
        if ((at - pressed_).manhattanLength() < dragThreshold) return;
        beginDrag(at);
    }
    if (drag_ == Drag::Tool) {
        dragTool_->move(eventAt(at, e->modifiers()));
        say(e->modifiers());
        pointAt(at);
    } else {
        drag(at);
    }
    last_ = at;
}

void Viewport::mouseReleaseEvent(QMouseEvent* e)
{
    if (e->button() != button_ || drag_ == Drag::None) return;
    const Drag was = drag_;
    drag_ = Drag::None;
    if (was == Drag::Tool) {
        std::exchange(dragTool_, nullptr)->release(eventAt(e->position(), e->modifiers()));
        pointAt(e->position());
    } else if (was == Drag::Pending && button_ == Qt::LeftButton) {
        const bool used = toolIdle() && markerView(pressed_).isEmpty() && tool().click(eventAt(pressed_, e->modifiers()));
        if (!used) click(pressed_, e->modifiers());
    } else if (was == Drag::Pending && button_ == Qt::RightButton && menu_) {
        if (const auto pick = pickAt(pressed_); pick && !session_.document.selection().has(pick->node)) click(pressed_, {});
        menu_->popup(e->globalPosition().toPoint());
    }
    showCursor();
}

// The first click has picked an edge; the second one takes its loop.
void Viewport::mouseDoubleClickEvent(QMouseEvent* e)
{
    if (e->button() == Qt::LeftButton && session_.view.pickKind == PickKind::Edge && !session_.steps.isOpen() &&
        session_.view.tool == ToolKind::Select) {
        const auto pick = pickAt(e->position());
        const bool elements = pick && !showsVariant(look(), session_.document.scene(), pick->node);
        const auto mark = elements ? hoverMark(*pick, PickKind::Edge) : std::nullopt;
        if (mark && mark->indices.size() == 2)
            return selecting::selectLoop(session_, pick->node, mark->indices[0], mark->indices[1], e->modifiers() & Qt::ShiftModifier);
    }
    mousePressEvent(e);
}

// The marker is drawn by the renderer: 78 across, 12 from the corner.
QString Viewport::markerView(QPointF at) const
{
    constexpr double radius = 39, margin = 12, reach = radius - 12, ball = 9;
    if (!look().options.orientationMarker) return {};
    const glm::dmat3 turn(look().camera.viewFromWorld());
    static const char* const names[] = {"right", "top", "front", "left", "bottom", "back"};
    QString nearest;
    double depth = -2;
    for (int i = 0; i < 6; ++i) {
        const glm::dvec3 d = turn[i % 3] * (i < 3 ? 1.0 : -1.0);
        const QPointF place(width() - margin - radius + reach * d.x, margin + radius - reach * d.y);
        if (QLineF(place, at).length() > ball || d.z < depth) continue;
        depth = d.z;
        nearest = names[i];
    }
    return nearest;
}

NodeId Viewport::jointUnder(QPointF at, bool surface)
{
    const PickKind kind = session_.view.pickKind;
    if (kind != PickKind::Joint && (kind != PickKind::Object || surface)) return {};
    seen();
    const double r = devicePixelRatioF();
    return jointAt(frame_, deviceSize(), {at.x() * r, at.y() * r});
}

void Viewport::click(QPointF point, Qt::KeyboardModifiers m)
{
    if (const QString view = markerView(point); !view.isEmpty()) return lookFrom(view);
    if (isLab(session_.steps)) return;  // nothing of the document is in view
    auto pick = pickAt(point);
    Selection s = session_.document.selection();
    const bool extend = m & (Qt::ShiftModifier | Qt::ControlModifier);
    if (const NodeId joint = jointUnder(point, pick.has_value())) {
        pick.emplace();
        pick->node = joint;
    } else if (session_.view.pickKind == PickKind::Joint) {
        pick.reset();
    }
    if (!pick) {
        if (!extend) session_.document.select({});
        return;
    }
    const PickKind kind = session_.view.pickKind;
    if (kind == PickKind::Object || kind == PickKind::Joint || showsVariant(look(), session_.document.scene(), pick->node)) {
        const auto at = std::find(s.nodes.begin(), s.nodes.end(), pick->node);
        const bool had = at != s.nodes.end();
        if (!extend)
            s.nodes.clear();
        else if (had)
            s.nodes.erase(at);
        if (!extend || !had || m & Qt::ShiftModifier) s.nodes.push_back(pick->node);
        session_.document.select({s.nodes, {}, {}});
        return;
    }
    const auto mark = hoverMark(*pick, kind);
    if (!mark) {
        if (!extend) session_.document.select({{pick->node}, {}, {}});
        return;
    }
    const auto& i = mark->indices;
    ElementSet picked{elementKind(kind), {i[0]}};
    if (kind == PickKind::Edge) picked.indices = {std::min(i[0], i[1]), std::max(i[0], i[1])};
    const bool same = s.elementsOf == pick->node && s.elements.kind == picked.kind;
    if (same && m & Qt::ControlModifier)
        picked = toggled(sorted(s.elements), picked);
    else if (same && m & Qt::ShiftModifier)
        picked = united(sorted(s.elements), picked);
    session_.document.select({{pick->node}, pick->node, std::move(picked)});
}

void Viewport::selectBox(const QRect& box, Qt::KeyboardModifiers m)
{
    if (!renderer_ || box.width() < 2 || box.height() < 2) return;
    const SelectMode mode = m & Qt::ShiftModifier ? SelectMode::Add : m & Qt::ControlModifier ? SelectMode::Remove : SelectMode::Replace;
    selectRegion(*this, boxRegion(*this, {box.left(), box.top()}, {box.left() + box.width(), box.top() + box.height()}), mode);
}

void Viewport::wheelEvent(QWheelEvent* e)
{
    e->accept();
    if (drag_ == Drag::Tool) return;  // a drag's numbers are those of one camera
    session_.view.activate(view_);
    look().camera.zoom(e->angleDelta().y() / 120.0, {e->position().x(), e->position().y()}, logicalSize());
    moved();
}

void Viewport::leaveEvent(QEvent*)
{
    hoverTimer_.stop();
    tool().leave();
    session_.view.setGround({});
    const bool had = hoverMark_.has_value() || session_.view.hovered;
    hoverMark_.reset();
    hoverValue_.reset();
    session_.view.hovered = {};
    if (had) refresh();
}

bool Viewport::event(QEvent* e)
{
    if (e->type() == QEvent::ScreenChangeInternal) refresh();
    // A tool's keys come before shortcuts: digits while a handle is dragged are a number, not views.
    if (e->type() == QEvent::ShortcutOverride && toolIdle() && (dragTool_ ? dragTool_ : &tool())->key(*static_cast<QKeyEvent*>(e))) {
        toolKey_ = true;
        e->accept();
        if (!dragTool_) showCursor();
        return true;
    }
    return QOpenGLWidget::event(e);
}

void Viewport::keyPressEvent(QKeyEvent* e)
{
    if (std::exchange(toolKey_, false)) return e->accept();  // was used when shortcuts were asked
    QOpenGLWidget::keyPressEvent(e);
}

void Viewport::focusInEvent(QFocusEvent* e)
{
    session_.view.activate(view_);
    QOpenGLWidget::focusInEvent(e);
}

void Viewport::hover()
{
    if (drag_ != Drag::None || !toolIdle()) return;
    QElapsedTimer clock;
    clock.start();
    if (!tool().marksHover()) {
        tool().rest(eventAt(last_, {}));
        say(QGuiApplication::keyboardModifiers());
        hoverTimer_.setInterval(std::clamp(int(clock.elapsed()) * 3, 30, 600));
        return;
    }
    const auto pick = pickAt(last_);
    hoverTimer_.setInterval(std::clamp(int(clock.elapsed()) * 3, 30, 600));  // a slow driver gets time between
    NodeId node = pick && session_.view.pickKind == PickKind::Object ? pick->node : NodeId{};
    if (const NodeId joint = jointUnder(last_, pick.has_value())) node = joint;
    // Elements are picked where the result is shown.
    const bool elements = pick && !showsVariant(look(), session_.document.scene(), pick->node);
    auto mark = elements ? hoverMark(*pick, session_.view.pickKind) : std::nullopt;
    showValue(pick);
    const bool same = node == session_.view.hovered && mark.has_value() == hoverMark_.has_value() &&
                      (!mark || (mark->indices == hoverMark_->indices && mark->node == hoverMark_->node));
    if (same) return;
    hoverMark_ = std::move(mark);
    if (std::exchange(session_.view.hovered, node) != node)
        refresh();
    else
        update();  // the mark lies over the scene
}

// What the colours say at the pointer.
void Viewport::showValue(const std::optional<Pick>& pick)
{
    const bool had = hoverValue_.has_value();
    hoverValue_.reset();
    if (pick && pick->face != none && !look().colourBy.isEmpty())
        for (const DrawObject& o : frame_.objects) {
            if (o.node != pick->node) continue;
            const auto t = triangleAt(o, pick->face, pick->atWorld);
            const auto v = t ? probed(o, pick->face, t->vertices, t->weights) : std::nullopt;
            if (!v) continue;
            const std::string unit = v->unit.empty() ? "" : " " + v->unit;
            hoverValue_ =
                Label{glm::vec3(pick->atWorld), std::isnan(v->value) ? "undefined" : QString::number(v->value, 'g', 3).toStdString() + unit};
        }
    if (had || hoverValue_) update();
}

void Viewport::pointAt(QPointF at)
{
    const bool inside = rect().contains(at.toPoint()) && !session_.steps.isOpen();
    session_.view.setGround(inside ? brush_->under(ray({at.x(), at.y()})) : std::nullopt);
}

void Viewport::say(Qt::KeyboardModifiers m)
{
    if (session_.steps.isOpen())
        emit hint("→ next step · ← step back · Shift+→ next phase · Space plays · F frames the focus");
    else
        emit hint((dragTool_ ? dragTool_ : &tool())->hint(m));
}

}  // namespace mw
