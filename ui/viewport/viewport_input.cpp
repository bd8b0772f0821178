// Pointer events of the view: click to pick, drag to look (ui/UI.md 3).
#include <QLineF>
#include <QMouseEvent>
#include <algorithm>
#include <set>

#include "render/bones.h"
#include "ui/viewport/step_frame.h"
#include "ui/viewport/viewport.h"

namespace mw {
namespace {

constexpr double dragThreshold = 4;

ElementKind elementKind(PickKind k)
{
    return k == PickKind::Vertex ? ElementKind::Vertex : k == PickKind::Edge ? ElementKind::Edge : ElementKind::Face;
}

// Elements as sortable keys: one index, or the two of an edge.
using Keys = std::set<std::pair<uint32_t, uint32_t>>;

Keys keysOf(const ElementSet& s)
{
    Keys keys;
    if (s.kind == ElementKind::Edge)
        for (size_t i = 0; i + 1 < s.indices.size(); i += 2) keys.insert({s.indices[i], s.indices[i + 1]});
    else
        for (uint32_t i : s.indices) keys.insert({i, 0});
    return keys;
}

ElementSet setOf(ElementKind kind, const Keys& keys)
{
    ElementSet s{kind, {}};
    for (const auto& [a, b] : keys) {
        s.indices.push_back(a);
        if (kind == ElementKind::Edge) s.indices.push_back(b);
    }
    return s;
}

// Shift adds, Ctrl toggles (box: removes), nothing replaces.
void combine(Document& document, NodeId node, ElementKind kind, const Keys& picked, Qt::KeyboardModifiers m, bool toggle)
{
    const Selection& old = document.selection();
    Keys keys;
    if (m & (Qt::ShiftModifier | Qt::ControlModifier) && old.elementsOf == node && old.elements.kind == kind) keys = keysOf(old.elements);
    for (const auto& k : picked)
        if (m & Qt::ControlModifier && (!toggle || keys.count(k)))
            keys.erase(k);
        else
            keys.insert(k);
    document.select({{node}, node, setOf(kind, keys)});
}

}  // namespace

void Viewport::mousePressEvent(QMouseEvent* e)
{
    if (drag_ != Drag::None) return;
    setFocus(Qt::MouseFocusReason);
    flight_.stop();
    button_ = e->button();
    modifiers_ = e->modifiers();
    pressed_ = last_ = e->position();
    drag_ = Drag::Pending;
    const bool paints =
        session_.view.brushInHand && !session_.steps.isOpen() && button_ == Qt::LeftButton && !(modifiers_ & (Qt::AltModifier | Qt::ShiftModifier));
    if (!paints || !markerView(pressed_).isEmpty() || !brush_.press(rayAt(pressed_), modifiers_ & Qt::ControlModifier)) return;
    drag_ = Drag::Paint;  // a drag that starts beside the ground orbits
    pointAt(pressed_);
}

void Viewport::beginDrag(QPointF)
{
    const bool alt = modifiers_ & Qt::AltModifier, shift = modifiers_ & Qt::ShiftModifier;
    if (button_ == Qt::LeftButton && !alt && (shift || boxTool_)) {
        drag_ = Drag::Box;
        band_->show();
        return;
    }
    if (button_ == Qt::LeftButton || (button_ == Qt::MiddleButton && !shift && !alt)) {
        drag_ = Drag::Orbit;
        const auto pick = pickAt(pressed_);
        const Bounds all = boundsOf(frame());
        pivot_ = pick ? pick->atWorld : all.empty ? session_.view.camera.target : all.centre();
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
    Camera& c = session_.view.camera;
    switch (drag_) {
        case Drag::Orbit:
            c.orbit(delta, pivot_);
            break;
        case Drag::Pan:
            c.pan(delta, logicalSize());
            break;
        case Drag::Paint:
            brush_.move(rayAt(at));
            pointAt(at);
            return;
        case Drag::Zoom:
            c.zoom(-delta.y / 40, {pressed_.x(), pressed_.y()}, logicalSize());
            break;
        case Drag::Box:
            band_->setGeometry(QRectF(pressed_, at).normalized().toRect());
            return;
        default:
            return;
    }
    update();
    emit cameraMoved();
}

void Viewport::mouseMoveEvent(QMouseEvent* e)
{
    const QPointF at = e->position();
    if (drag_ == Drag::None) {
        say(e->modifiers());
        last_ = at;
        pointAt(at);
        if (!session_.steps.isOpen()) hoverTimer_.start();
        return;
    }
    if (drag_ == Drag::Pending) {
        if ((at - pressed_).manhattanLength() < dragThreshold) return;
        beginDrag(at);
    }
    drag(at);
    last_ = at;
}

void Viewport::mouseReleaseEvent(QMouseEvent* e)
{
    if (e->button() != button_ || drag_ == Drag::None) return;
    const Drag was = drag_;
    drag_ = Drag::None;
    setCursor(boxTool_ ? Qt::CrossCursor : Qt::ArrowCursor);
    if (was == Drag::Paint) {
        brush_.release();
        pointAt(e->position());
    } else if (was == Drag::Box) {
        band_->hide();
        selectBox(QRectF(pressed_, e->position()).normalized().toRect(), e->modifiers());
    } else if (was == Drag::Pending && button_ == Qt::LeftButton) {
        click(pressed_, e->modifiers());
    } else if (was == Drag::Pending && button_ == Qt::RightButton && menu_) {
        if (const auto pick = pickAt(pressed_); pick && !session_.document.selection().has(pick->node)) click(pressed_, {});
        menu_->popup(e->globalPosition().toPoint());
    }
}

// The marker is drawn by the renderer: 78 across, 12 from the corner.
QString Viewport::markerView(QPointF at) const
{
    constexpr double radius = 39, margin = 12, reach = radius - 12, ball = 9;
    if (!session_.view.options.orientationMarker) return {};
    const glm::dmat3 turn(session_.view.camera.viewFromWorld());
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
    frame();
    frame_.camera = session_.view.camera;
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
    if (kind == PickKind::Object || kind == PickKind::Joint) {
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
    const Keys picked{{kind == PickKind::Edge ? std::min(i[0], i[1]) : i[0], kind == PickKind::Edge ? std::max(i[0], i[1]) : 0}};
    combine(session_.document, pick->node, elementKind(kind), picked, m, true);
}

void Viewport::selectBox(const QRect& box, Qt::KeyboardModifiers m)
{
    if (isLab(session_.steps)) return;
    if (!renderer_ || box.width() < 2 || box.height() < 2) return;
    frame();
    frame_.camera = session_.view.camera;
    const double r = devicePixelRatioF();
    makeCurrent();
    const auto visible =
        renderer_->visibleFaces(frame_, deviceSize(), {int(box.left() * r), int(box.top() * r)}, {int(box.right() * r), int(box.bottom() * r)});
    doneCurrent();
    const PickKind kind = session_.view.pickKind;
    if (kind == PickKind::Joint) return;
    if (kind == PickKind::Object) {
        Selection s = session_.document.selection();
        if (boxTool_ && !(m & (Qt::ShiftModifier | Qt::ControlModifier))) s.nodes.clear();
        for (const auto& [node, faces] : visible) {
            s.nodes.erase(std::remove(s.nodes.begin(), s.nodes.end(), node), s.nodes.end());
            if (!(m & Qt::ControlModifier)) s.nodes.push_back(node);
        }
        session_.document.select({s.nodes, {}, {}});
        return;
    }
    const NodeId active = session_.document.selection().active();
    for (const auto& [node, faces] : visible) {
        const bool preferred = node == active || visible.size() == 1 || !active;
        const auto object = std::find_if(frame_.objects.begin(), frame_.objects.end(), [n = node](const DrawObject& o) { return o.node == n; });
        if (!preferred || object == frame_.objects.end()) continue;
        const Shared<glm::vec3> places = object->pose ? posed(object->mesh, *object->pose).positions() : object->mesh.positions();
        const auto inside = [&](uint32_t v) {
            const glm::dvec3 p = frame_.camera.project(glm::dvec3(object->worldFromLocal * glm::dvec4(glm::dvec3(places[v]), 1)), logicalSize());
            return box.contains(int(p.x), int(p.y));
        };
        Keys picked;
        for (uint32_t f : faces) {
            const auto corners = object->mesh.face(f);
            if (kind == PickKind::Face) picked.insert({f, 0});
            for (size_t i = 0; kind != PickKind::Face && i < corners.size(); ++i) {
                const uint32_t a = corners[i], b = corners[(i + 1) % corners.size()];
                if (kind == PickKind::Vertex && inside(a)) picked.insert({a, 0});
                if (kind == PickKind::Edge && inside(a) && inside(b)) picked.insert({std::min(a, b), std::max(a, b)});
            }
        }
        combine(session_.document, node, elementKind(kind), picked, m, false);
        return;
    }
}

void Viewport::wheelEvent(QWheelEvent* e)
{
    session_.view.camera.zoom(e->angleDelta().y() / 120.0, {e->position().x(), e->position().y()}, logicalSize());
    update();
    emit cameraMoved();
    e->accept();
}

void Viewport::leaveEvent(QEvent*)
{
    hoverTimer_.stop();
    session_.view.setGround({});
    const bool had = hoverMark_.has_value() || session_.view.hovered;
    hoverMark_.reset();
    session_.view.hovered = {};
    if (had) refresh();
}

bool Viewport::event(QEvent* e)
{
    if (e->type() == QEvent::ScreenChangeInternal) refresh();
    return QOpenGLWidget::event(e);
}

void Viewport::hover()
{
    if (drag_ != Drag::None || session_.steps.isOpen() || session_.view.brushInHand) return;
    QElapsedTimer clock;
    clock.start();
    const auto pick = pickAt(last_);
    hoverTimer_.setInterval(std::clamp(int(clock.elapsed()) * 3, 30, 600));  // a slow driver gets time between
    NodeId node = pick && session_.view.pickKind == PickKind::Object ? pick->node : NodeId{};
    if (const NodeId joint = jointUnder(last_, pick.has_value())) node = joint;
    auto mark = pick ? hoverMark(*pick, session_.view.pickKind) : std::nullopt;
    const bool same = node == session_.view.hovered && mark.has_value() == hoverMark_.has_value() &&
                      (!mark || (mark->indices == hoverMark_->indices && mark->node == hoverMark_->node));
    if (same) return;
    session_.view.hovered = node;
    hoverMark_ = std::move(mark);
    refresh();
}

void Viewport::pointAt(QPointF at)
{
    session_.view.setGround(rect().contains(at.toPoint()) && !session_.steps.isOpen() ? brush_.under(rayAt(at)) : std::nullopt);
    if (session_.view.brushInHand && drag_ != Drag::Pan && drag_ != Drag::Orbit) setCursor(session_.view.ground ? Qt::BlankCursor : Qt::ArrowCursor);
}

void Viewport::say(Qt::KeyboardModifiers m)
{
    if (session_.steps.isOpen())
        emit hint("→ next step · ← step back · Shift+→ next phase · Space plays · F frames the focus");
    else if (session_.view.brushInHand) {
        const bool lowers = (session_.view.brush.kind == Brush::Kind::Lower) != bool(m & Qt::ControlModifier);
        emit hint(QString("Drag %1 \u00b7 Ctrl+drag %2 \u00b7 [ ] radius \u00b7 Shift+[ ] strength \u00b7 Right-drag pans \u00b7 Middle-drag, or a "
                          "drag beside the ground, orbits")
                      .arg(lowers ? "lowers" : "raises", lowers ? "raises" : "lowers"));
    } else if (m & Qt::ShiftModifier)
        emit hint("Shift+click adds · Shift+drag boxes, adding · Shift+middle-drag pans");
    else if (m & Qt::ControlModifier)
        emit hint("Ctrl+click toggles");
    else if (boxTool_)
        emit hint("Drag a box over what is to be selected · Middle-drag orbits · Esc back to Select");
    else
        emit hint("Click picks · Drag orbits · Shift+drag boxes · Right-drag pans · F frames");
}

}  // namespace mw
