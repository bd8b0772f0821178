#include "ui/viewport/gizmo.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/colors.h"

namespace mw {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double planeFrom = 28, planeTo = 46, viewRing = 106, freeRadius = 7;
const glm::vec3 axisColors[] = {hex(0xE5484D), hex(0x6CC04A), hex(0x4A90E2)};
const char* const axisNames[] = {"X", "Y", "Z"};

double distanceToLine(const std::vector<glm::dvec2>& line, glm::dvec2 p)
{
    double nearest = 1e9;
    for (size_t i = 0; i + 1 < line.size(); ++i) {
        const glm::dvec2 along = line[i + 1] - line[i];
        const double t = std::clamp(glm::dot(p - line[i], along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
        nearest = std::min(nearest, glm::distance(p, line[i] + t * along));
    }
    return nearest;
}

bool withinQuad(const std::vector<glm::dvec2>& q, glm::dvec2 p)
{
    int left = 0, right = 0;
    for (size_t i = 0; i < q.size(); ++i) {
        const glm::dvec2 side = q[(i + 1) % q.size()] - q[i], to = p - q[i];
        (side.x * to.y - side.y * to.x > 0 ? left : right)++;
    }
    return left == 0 || right == 0;
}

QString shown(double v)
{
    QString s = QString::number(std::abs(v) < 5e-7 ? 0.0 : v, 'g', 4);
    return s.replace('-', QChar(0x2212));
}

}  // namespace

Gizmo::Gizmo(ToolKind tool, const Camera& camera, glm::dvec2 size, const GizmoPlace& place) : tool_(tool), camera_(camera), size_(size), place_(place)
{
    const glm::dmat4 view = camera.viewFromWorld();
    const double depth = -(view * glm::dvec4(place.origin, 1)).z;
    if (camera.perspective && depth <= camera.nearClip) return;
    const glm::dvec3 right(view[0][0], view[1][0], view[2][0]);
    const double step = 1e-3 * std::max(camera.perspective ? depth : camera.distance, 1e-9);
    centre_ = pixelOf(place.origin);
    const double pixels = glm::distance(centre_, pixelOf(place.origin + step * right));
    if (!(pixels > 0)) return;
    unit_ = step / pixels;
    if (tool == ToolKind::Rotate) {
        for (int a = 0; a < 3; ++a) addRing(a);
        Handle ring{Handle::Kind::ViewRing, 0, {}};
        for (int i = 0; i <= 96; ++i) ring.line.push_back(centre_ + viewRing * glm::dvec2(std::cos(2 * pi * i / 96), std::sin(2 * pi * i / 96)));
        handles_.push_back(std::move(ring));
        return;
    }
    handles_.push_back({Handle::Kind::Free, 0, {centre_}});
    for (int a = 0; a < 3; ++a) addPlane(a);
    for (int a = 0; a < 3; ++a) addAxis(a);
}

glm::dvec3 Gizmo::toEye() const
{
    const glm::dmat4 view = camera_.viewFromWorld();
    if (camera_.perspective) return glm::normalize(camera_.eye() - place_.origin);
    return {view[0][2], view[1][2], view[2][2]};
}

// One that points at the eye has no length to drag along.
void Gizmo::addAxis(int axis)
{
    const glm::dvec3 along = unit_ * place_.axes[axis];
    Handle h{Handle::Kind::Axis, axis, {pixelOf(place_.origin + 14.0 * along), pixelOf(place_.origin + reach * along)}};
    if (glm::distance(h.line[0], h.line[1]) >= 16) handles_.push_back(std::move(h));
}

void Gizmo::addPlane(int axis)
{
    if (std::abs(glm::dot(place_.axes[axis], toEye())) < 0.25) return;  // edge on
    const glm::dvec3 u = unit_ * place_.axes[(axis + 1) % 3], v = unit_ * place_.axes[(axis + 2) % 3];
    Handle h{Handle::Kind::Plane, axis, {}};
    for (const auto& [a, b] : {std::pair{planeFrom, planeFrom}, {planeTo, planeFrom}, {planeTo, planeTo}, {planeFrom, planeTo}})
        h.line.push_back(pixelOf(place_.origin + a * u + b * v));
    handles_.push_back(std::move(h));
}

// The half that faces the eye; all of one that is seen from its axis.
void Gizmo::addRing(int axis)
{
    const glm::dvec3 n = place_.axes[axis], eye = toEye();
    const glm::dvec3 inPlane = eye - glm::dot(eye, n) * n;
    const bool whole = glm::length(inPlane) < 0.2;
    const glm::dvec3 u = whole ? place_.axes[(axis + 1) % 3] : glm::normalize(inPlane), v = glm::cross(n, u);
    const double half = whole ? pi : 0.5 * pi;
    Handle h{Handle::Kind::Ring, axis, {}};
    for (int i = -32; i <= 32; ++i) {
        const double a = half * i / 32;
        h.line.push_back(pixelOf(place_.origin + reach * unit_ * (std::cos(a) * u + std::sin(a) * v)));
    }
    handles_.push_back(std::move(h));
}

int Gizmo::at(glm::dvec2 pixel) const
{
    int best = -1;
    double nearest = grab;
    for (size_t i = 0; i < handles_.size(); ++i) {
        const Handle& h = handles_[i];
        if (h.kind == Handle::Kind::Plane) {
            if (withinQuad(h.line, pixel) && nearest > 1) best = int(i), nearest = 1;
            continue;
        }
        double d = h.kind == Handle::Kind::Free ? glm::distance(h.line[0], pixel) - freeRadius + 1 : distanceToLine(h.line, pixel);
        if (h.kind == Handle::Kind::Axis) d = std::min(d, glm::distance(h.line[1], pixel) - 3);  // its head is thicker
        if (d < nearest) best = int(i), nearest = d;
    }
    return best;
}

glm::dvec2 Gizmo::anchor(int handle) const
{
    const Handle& h = handles_[size_t(handle)];
    if (h.kind == Handle::Kind::Axis) return h.line[1];
    return h.line[h.line.size() / 2];
}

void Gizmo::draw(int hot, bool held, std::vector<Flat>& out) const
{
    for (size_t k = handles_.size(); k-- > 0;) {  // what is found first lies on top
        const Handle& h = handles_[k];
        const bool isHot = int(k) == hot;
        const bool coloured = h.kind == Handle::Kind::Axis || h.kind == Handle::Kind::Plane || h.kind == Handle::Kind::Ring;
        glm::vec4 color(isHot || !coloured ? glm::vec3(1) : axisColors[h.axis], held && !isHot ? 0.25f : 1.f);
        Flat f;
        f.color = color;
        f.width = isHot ? 3.2f : 2.4f;
        if (h.kind == Handle::Kind::Free) {
            f.kind = Flat::Kind::Disc;
            f.at = {glm::vec2(centre_)};
            f.width = float(2 * freeRadius) - (isHot ? 0.f : 3.f);
            f.color.a *= isHot ? 1.f : 0.85f;
            out.push_back(std::move(f));
            continue;
        }
        for (const glm::dvec2& p : h.line) f.at.emplace_back(p);
        if (h.kind == Handle::Kind::Plane) {
            Flat fill = f;
            fill.kind = Flat::Kind::Quad;
            fill.halo = false;
            fill.color.a *= isHot ? 0.7f : 0.35f;
            f.at.push_back(f.at.front());
            f.width = 1.4f;
            out.push_back(std::move(fill));
        }
        if (h.kind == Handle::Kind::ViewRing) {
            f.width -= 0.8f;
            f.color.a *= isHot ? 1.f : 0.7f;
        }
        out.push_back(std::move(f));
        if (h.kind != Handle::Kind::Axis) continue;
        const glm::vec2 tip(h.line[1]), along = glm::normalize(tip - glm::vec2(h.line[0])), across(-along.y, along.x);
        Flat head;
        head.kind = Flat::Kind::Quad;
        head.color = color;
        if (tool_ == ToolKind::Move) {
            const glm::vec2 foot = tip - 9.f * along;
            head.at = {tip + 5.f * along, foot + 5.5f * across, foot, foot - 5.5f * across};
        } else {
            head.at = {tip + 5.f * (along + across), tip + 5.f * (along - across), tip - 5.f * (along + across), tip - 5.f * (along - across)};
        }
        out.push_back(std::move(head));
    }
}

std::optional<glm::dvec3> Gizmo::onPlane(glm::dvec2 pixel, glm::dvec3 normal) const
{
    const Ray r = camera_.ray(pixel, size_);
    const double slope = glm::dot(r.direction, normal);
    if (std::abs(slope) < 1e-6) return std::nullopt;
    const double t = glm::dot(place_.origin - r.origin, normal) / slope;
    if (camera_.perspective && t <= 0) return std::nullopt;
    return r.origin + t * r.direction - place_.origin;
}

glm::dvec3 Gizmo::ringAxis(const Handle& h) const
{
    return h.kind == Handle::Kind::ViewRing ? toEye() : place_.axes[h.axis];
}

std::optional<glm::dvec3> Gizmo::meaning(const Handle& h, glm::dvec2 pixel) const
{
    if (h.kind == Handle::Kind::ViewRing) return glm::dvec3(std::atan2(centre_.y - pixel.y, pixel.x - centre_.x), 0, 0);
    if (h.kind == Handle::Kind::Ring) {
        const glm::dvec3 n = place_.axes[h.axis];
        if (std::abs(glm::dot(n, toEye())) < 0.15) {  // edge on: along its line
            const glm::dvec2 along = h.line.back() - h.line.front();
            return glm::dvec3(glm::dot(pixel - centre_, glm::normalize(along)) / reach, 0, 0);
        }
        const auto p = onPlane(pixel, n);
        if (!p) return std::nullopt;
        return glm::dvec3(std::atan2(glm::dot(*p, place_.axes[(h.axis + 2) % 3]), glm::dot(*p, place_.axes[(h.axis + 1) % 3])), 0, 0);
    }
    if (h.kind == Handle::Kind::Free && tool_ == ToolKind::Scale) return glm::dvec3(pixel.x - centre_.x + centre_.y - pixel.y, 0, 0);
    if (h.kind == Handle::Kind::Axis) {  // the place of the axis nearest to the line of sight
        const Ray r = camera_.ray(pixel, size_);
        const glm::dvec3 a = place_.axes[h.axis], w = r.origin - place_.origin;
        const double b = glm::dot(a, r.direction), slope = 1 - b * b;
        if (slope < 1e-6) return std::nullopt;
        glm::dvec3 value(0);
        value[h.axis] = (glm::dot(w, a) - glm::dot(w, r.direction) * b) / slope;
        return value;
    }
    const auto p = onPlane(pixel, h.kind == Handle::Kind::Free ? toEye() : place_.axes[h.axis]);
    if (!p) return std::nullopt;
    glm::dvec3 value = glm::transpose(place_.axes) * *p;
    if (h.kind == Handle::Kind::Plane) value[h.axis] = 0;
    return value;
}

HandleDrag::HandleDrag(const Gizmo& gizmo, int handle, glm::dvec2 pixel) : gizmo_(gizmo), index_(handle)
{
    start_ = last_ = gizmo_.meaning(this->handle(), pixel).value_or(glm::dvec3(0));
    if (gizmo_.tool() == ToolKind::Scale) value_ = glm::dvec3(1);
}

bool HandleDrag::involves(int axis) const
{
    const Handle& h = handle();
    return h.kind == Handle::Kind::Free || (h.kind == Handle::Kind::Plane ? h.axis != axis : h.axis == axis);
}

void HandleDrag::move(glm::dvec2 pixel, bool slow)
{
    const auto now = gizmo_.meaning(handle(), pixel);
    if (!now) return;
    glm::dvec3 by = *now - last_;
    last_ = *now;
    const double pace = slow ? 0.1 : 1;
    if (gizmo_.tool() == ToolKind::Rotate) {
        value_.x += pace * std::remainder(by.x, 2 * pi);
    } else if (gizmo_.tool() == ToolKind::Move) {
        value_ += pace * by;
    } else if (handle().kind == Handle::Kind::Free) {
        value_ += glm::dvec3(pace * by.x / Gizmo::reach);
    } else {  // as far as the pointer is from the middle, compared with where it began
        const double began = glm::dot(start_, start_);
        const double factor = began > 0 ? glm::dot(by, start_) / began : 0;
        for (int a = 0; a < 3; ++a)
            if (involves(a)) value_[a] += pace * factor;
    }
}

glm::dvec3 HandleDrag::value(bool snap) const
{
    if (!snap) return value_;
    if (gizmo_.tool() == ToolKind::Rotate) return {std::round(value_.x / (pi / 36)) * (pi / 36), 0, 0};
    glm::dvec3 v = value_;
    for (int a = 0; a < 3; ++a)
        if (involves(a)) v[a] = std::round(10 * v[a]) / 10;
    return v;
}

std::optional<glm::dvec3> HandleDrag::typed(const QString& text) const
{
    std::vector<double> numbers;
    for (const QString& part : text.split(',')) {
        bool ok = false;
        numbers.push_back(part.toDouble(&ok));
        if (!ok || !std::isfinite(numbers.back())) return std::nullopt;
    }
    if (gizmo_.tool() == ToolKind::Rotate) return glm::dvec3(numbers[0] * pi / 180, 0, 0);
    const bool scales = gizmo_.tool() == ToolKind::Scale;
    glm::dvec3 v(scales ? 1 : 0);
    size_t next = 0;  // of scale one number serves all axes of the handle; of move each has its own
    for (int a = 0; a < 3; ++a) {
        if (!involves(a)) continue;
        if (next < numbers.size())
            v[a] = numbers[next++];
        else if (scales)
            v[a] = numbers.back();
    }
    return v;
}

QString HandleDrag::text(glm::dvec3 value) const
{
    if (gizmo_.tool() == ToolKind::Rotate) return shown(value.x * 180 / pi) + QChar(0xb0);
    const bool scales = gizmo_.tool() == ToolKind::Scale;
    if (scales && handle().kind == Handle::Kind::Free) return shown(value.x);
    QStringList parts;
    for (int a = 0; a < 3; ++a)
        if (involves(a)) parts << QString("%1 %2").arg(axisNames[a], shown(value[a]));
    return parts.join("  ") + (scales ? "" : " m");
}

}  // namespace mw
