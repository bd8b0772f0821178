#include "ui/viewport/measure_tool.h"

#include <QApplication>
#include <QClipboard>
#include <algorithm>
#include <cmath>

#include "core/math/measure.h"
#include "render/bones.h"
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

class Places {
public:
    explicit Places(const DrawObject& o) : object_(o), places_(o.pose ? posedPositions(o.mesh, *o.pose) : o.mesh.positions()) {}
    glm::dvec3 operator[](uint32_t v) const { return glm::dvec3(object_.worldFromLocal * glm::dvec4(glm::dvec3(places_[v]), 1)); }

private:
    const DrawObject& object_;
    Shared<glm::vec3> places_;
};

/// The place of a segment nearest to a ray.
glm::dvec3 onSegment(const Ray& ray, glm::dvec3 a, glm::dvec3 b)
{
    const glm::dvec3 along = b - a, w = ray.origin - a;
    const double aa = glm::dot(along, along), ad = glm::dot(along, ray.direction), slope = aa - ad * ad;
    const double t = slope > 1e-12 * aa ? (glm::dot(w, along) - glm::dot(w, ray.direction) * ad) / slope : 0;
    return a + std::clamp(t, 0.0, 1.0) * along;
}

/// The triangle of the face that holds the point best, and the point's weights there.
void findTriangle(const DrawObject& o, const Places& places, MeasuredPoint& p)
{
    const Mesh::Triangulation& t = o.mesh.triangulation();
    const auto [first, last] = std::equal_range(t.faces.begin(), t.faces.end(), p.face);
    double best = -1e9;
    for (const uint32_t* i = first; i != last; ++i) {
        const size_t k = 3 * size_t(i - t.faces.begin());
        const glm::uvec3 corners(t.vertices[k], t.vertices[k + 1], t.vertices[k + 2]);
        const glm::dvec3 w = barycentric(p.at, places[corners.x], places[corners.y], places[corners.z]);
        const double least = std::min({w.x, w.y, w.z});
        if (!(least > best)) continue;
        best = least;
        p.corners = corners;
        p.weights = w;
    }
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
    const Places places(*o);
    if (pick->vertex != none) {
        p.on = MeasuredPoint::On::Vertex;
        p.vertex = pick->vertex;
        p.at = places[p.vertex];
    } else if (pick->edge.x != none) {
        p.on = MeasuredPoint::On::Edge;
        p.edge = pick->edge;
        p.at = onSegment(view_.ray(at), places[p.edge.x], places[p.edge.y]);
    }
    if (p.face != none) findTriangle(*o, places, p);
    return p;
}

bool MeasureTool::click(const PointerEvent& e)
{
    const auto p = pointAt(e.at);
    if (!p) return true;  // beside everything: nothing to measure, and the selection stays
    if (points_.size() == 3) points_.clear();
    points_.push_back(*p);
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
    if (points_.size() == 3) {
        const glm::dvec3 a = points_[0].at, b = points_[1].at, c = points_[2].at;
        lines << "angle\t" + full(angleAt(b, a, c) * 180 / M_PI) << "area\t" + full(triangleArea(a, b, c));
    }
    if (!points_.empty() && points_.back().corners.x != none)
        lines << QString("barycentric\t%1\tface %2").arg(triple(points_.back().weights)).arg(points_.back().face);
    return lines.join('\n');
}

}  // namespace mw
