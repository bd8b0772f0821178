#include "ui/viewport/measure_tool.h"

#include <QApplication>
#include <QClipboard>
#include <algorithm>
#include <cmath>

#include "core/math/measure.h"
#include "core/math/point_triangle.h"
#include "core/mesh/triangle_tree.h"
#include "ui/viewport/heat_probe.h"
#include "ui/words.h"

namespace mw {
namespace {

constexpr glm::vec4 white{1, 1, 1, 1}, yellow{1, 0.88f, 0.30f, 1};

QString number(double v)
{
    return QString::number(v, 'g', 4).replace('-', QChar(0x2212));
}

QString degrees(double radians)
{
    return number(radians * 180 / M_PI) + QChar(0xb0);
}

const DrawObject* objectOf(const Frame& frame, NodeId node)
{
    for (const DrawObject& o : frame.objects)
        if (o.node == node) return &o;
    return nullptr;
}

/// The place of a segment nearest to a ray.
glm::dvec3 onSegment(const Ray& ray, glm::dvec3 a, glm::dvec3 b)
{
    const glm::dvec3 along = b - a, w = ray.origin - a;
    const double aa = glm::dot(along, along), ad = glm::dot(along, ray.direction), slope = aa - ad * ad;
    const double t = slope > 1e-12 * aa ? (glm::dot(w, along) - glm::dot(w, ray.direction) * ad) / slope : 0;
    return a + std::clamp(t, 0.0, 1.0) * along;
}

}  // namespace

std::optional<MeasuredPoint> MeasureTool::pointAt(glm::dvec2 at)
{
    const auto pick = view_.pick(at);
    if (!pick) return std::nullopt;
    MeasuredPoint p;
    p.node = pick->node;
    p.at = pick->atWorld;
    p.face = pick->face;
    const DrawObject* o = objectOf(view_.seen(), pick->node);
    if (!o) {
        p.on = MeasuredPoint::On::Ground;
        return p;
    }
    const WorldPlaces places(*o);
    if (pick->vertex != none) {
        p.on = MeasuredPoint::On::Vertex;
        p.vertex = pick->vertex;
        p.at = places[p.vertex];
    } else if (pick->edge.x != none) {
        p.on = MeasuredPoint::On::Edge;
        p.edge = pick->edge;
        p.at = onSegment(view_.ray(at), places[p.edge.x], places[p.edge.y]);
    }
    if (p.face == none) return p;
    if (const auto t = triangleAt(*o, p.face, p.at)) {
        p.corners = t->vertices;
        p.weights = t->weights;
        for (int k = 0; k < 3; ++k) p.triangle[k] = places[t->vertices[k]];
    }
    return p;
}

void MeasureTool::describe(MeasuredPoint& p)
{
    const DrawObject* o = objectOf(view_.seen(), p.node);
    const auto t = o && p.face != none ? triangleAt(*o, p.face, p.at) : std::nullopt;
    if (!t) return;
    const auto row = [&](const char* attribute, const QString& title) {
        QStringList numbers;
        for (const double v : mixed(o->mesh, attribute, t->vertices, t->corners, t->weights)) numbers << number(v);
        if (!numbers.isEmpty()) p.carried.emplace_back(title, numbers.join(", "));
    };
    row("color", "Colour");
    row("texcoord", "Texture");
    if (const auto v = probed(*o, p.face, t->vertices, t->weights))
        p.carried.emplace_back(QString::fromStdString(v->name),
                               std::isnan(v->value) ? "undefined" : number(v->value) + " " + QString::fromStdString(v->unit));
}

void MeasureTool::measureSurface()
{
    if (points_.size() == 3) return;  // a third point is about the angle
    toSurface_.reset();
    if (points_.size() != 2 || points_[0].corners.x == none) return;
    const MeasuredPoint &a = points_[0], &b = points_[1];
    const PointTriangle t = pointTriangle(b.at, a.triangle[0], a.triangle[1], a.triangle[2]);
    SurfaceMeasure m{t.distance, t.inside, a.node != b.node, 0};
    const DrawObject* o = objectOf(view_.seen(), a.node);
    if (m.other && o) {
        const WorldPlaces places(*o);
        Array<glm::vec3> world(o->mesh.vertexCount());
        for (uint32_t v = 0; v < world.size(); ++v) world[v] = glm::vec3(places[v]);
        m.surface = std::sqrt(TriangleTree(o->mesh.withPositions(std::move(world))).closest(b.at).distance2);
    }
    toSurface_ = m;
}

bool MeasureTool::click(const PointerEvent& e)
{
    auto p = pointAt(e.at);
    if (!p) return true;  // beside everything: nothing to measure, and the selection stays
    if (points_.size() == 3) points_.clear();
    describe(*p);
    points_.push_back(*std::move(p));
    measureSurface();
    tell();
    return true;
}

void MeasureTool::rest(const PointerEvent& e)
{
    hover_ = pointAt(e.at);
    view_.redraw();
}

void MeasureTool::leave()
{
    hover_.reset();
    view_.redraw();
}

void MeasureTool::tell()
{
    view_.redraw();
    if (changed) changed();
}

bool MeasureTool::abort()
{
    if (points_.empty()) return false;
    points_.clear();
    tell();
    return true;
}

bool MeasureTool::key(const QKeyEvent& e)
{
    if (!e.matches(QKeySequence::Copy) || points_.empty()) return false;
    QApplication::clipboard()->setText(copyText());
    return true;
}

void MeasureTool::decorate(Frame& frame)
{
    const auto disc = [&](glm::dvec3 at, float size, glm::vec4 color) { frame.points.push_back({glm::vec3(at), color, size, {}, false, true}); };
    const auto line = [&](glm::dvec3 a, glm::dvec3 b, glm::vec4 color, bool dashed) {
        frame.points.push_back({glm::vec3(a), color, dashed ? 1.6f : 2.4f, glm::vec3(b), dashed, true});
    };
    for (size_t i = 0; i + 1 < points_.size(); ++i) {
        const glm::dvec3 a = points_[i].at, b = points_[i + 1].at;
        line(a, b, yellow, false);
        frame.labels.push_back({glm::vec3(0.5 * (a + b)), (number(glm::distance(a, b)) + " m").toStdString(), white});
    }
    if (points_.size() == 3) {
        line(points_[2].at, points_[0].at, yellow, true);
        frame.labels.push_back({glm::vec3(points_[1].at), degrees(angleAt(points_[1].at, points_[0].at, points_[2].at)).toStdString(), yellow});
    }
    for (const MeasuredPoint& p : points_) disc(p.at, 9, yellow);
    if (!hover_) return;
    if (points_.size() == 1 || points_.size() == 2) line(points_.back().at, hover_->at, white, true);
    disc(hover_->at, hover_->on == MeasuredPoint::On::Vertex ? 10.f : 6.f, white);
}

QString MeasureTool::hint(Qt::KeyboardModifiers) const
{
    const QString all = " \u00b7 Snaps to vertices and edges \u00b7 Drag orbits";
    if (points_.empty()) return "Click the first point" + all;
    if (points_.size() == 1) return "Click the second point" + all + " \u00b7 Esc clears";
    if (points_.size() == 2) return "Click a third point for angle and area \u00b7 Ctrl+C copies \u00b7 Esc clears";
    return "Click to begin anew \u00b7 Ctrl+C copies \u00b7 Esc clears";
}

QString MeasureTool::report() const
{
    if (points_.empty()) return {};
    QString rows;
    const auto row = [&](const QString& name, const QString& value) {
        rows += QString("<tr><td>%1 &nbsp;</td><td align='right'><b>%2</b></td></tr>").arg(name, value);
    };
    const MeasuredPoint& last = points_.back();
    if (points_.size() >= 2) {
        const glm::dvec3 d = points_[1].at - points_[0].at;
        row("Distance", number(glm::length(d)) + " m");
        row("along X, Y, Z", QString("%1, %2, %3 m").arg(number(d.x), number(d.y), number(d.z)));
    }
    if (toSurface_ && toSurface_->other) row("to the surface of the first", number(toSurface_->surface) + " m");
    if (toSurface_) row("to the plane of its triangle", number(toSurface_->plane) + (toSurface_->inside ? " m, foot inside" : " m, foot outside"));
    if (points_.size() == 3) {
        const glm::dvec3 a = points_[0].at, b = points_[1].at, c = points_[2].at;
        row("Second distance", number(glm::distance(b, c)) + " m");
        row("Angle at the second", degrees(angleAt(b, a, c)));
        row("Area of the triangle", number(triangleArea(a, b, c)) + QString(" m\u00b2"));
    }
    if (points_.size() == 1) row("Place", QString("%1, %2, %3 m").arg(number(last.at.x), number(last.at.y), number(last.at.z)));
    if (last.corners.x != none && !std::isnan(last.weights.x)) {
        row(last.on == MeasuredPoint::On::Vertex ? QString("On vertex %1, face").arg(grouped(last.vertex)) : QString("On face"), grouped(last.face));
        row("Barycentric", QString("%1, %2, %3")
                               .arg(last.weights.x, 0, 'f', 3)
                               .arg(last.weights.y, 0, 'f', 3)
                               .arg(last.weights.z, 0, 'f', 3)
                               .replace('-', QChar(0x2212)));
        row("of vertices", QString("%1, %2, %3").arg(grouped(last.corners.x), grouped(last.corners.y), grouped(last.corners.z)));
        for (const auto& [title, value] : last.carried) row(title, value);
    }
    return "<table>" + rows + "</table>";
}

QString MeasureTool::copyText() const
{
    QStringList lines;
    const auto full = [](double v) { return QString::number(v, 'g', 9); };
    const auto triple = [&](glm::dvec3 v) { return full(v.x) + " " + full(v.y) + " " + full(v.z); };
    if (points_.size() == 1) lines << "point\t" + triple(points_[0].at);
    if (points_.size() >= 2) {
        const glm::dvec3 d = points_[1].at - points_[0].at;
        lines << "distance\t" + full(glm::length(d)) << "along\t" + triple(d);
    }
    if (toSurface_ && points_.size() >= 2) {
        lines << "to plane\t" + full(toSurface_->plane) + (toSurface_->inside ? "\tfoot inside" : "\tfoot outside");
        if (toSurface_->other) lines << "to surface\t" + full(toSurface_->surface);
    }
    if (points_.size() == 3) {
        const glm::dvec3 a = points_[0].at, b = points_[1].at, c = points_[2].at;
        lines << "angle\t" + full(angleAt(b, a, c) * 180 / M_PI) << "area\t" + full(triangleArea(a, b, c));
    }
    if (!points_.empty() && points_.back().corners.x != none)
        lines << QString("barycentric\t%1\tface %2").arg(triple(points_.back().weights)).arg(points_.back().face);
    return lines.join('\n');
}

}  // namespace mw
