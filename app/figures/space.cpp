// A view in space on a page.
#include <cmath>

#include "app/figures/figure.h"
#include "core/error.h"

namespace mw::figures {

void Space::look(double azimuth, double elevation, bool perspective)
{
    frame.camera.azimuth = azimuth * M_PI / 180;
    frame.camera.elevation = elevation * M_PI / 180;
    frame.camera.perspective = perspective;
    if (perspective) frame.camera.fieldOfView = 0.45;
}

void Space::fixed(const Camera& camera)
{
    frame.camera = camera;
    fixed_ = true;
}

NodeId Space::put(Mesh mesh, const glm::dmat4& worldFromLocal)
{
    DrawObject o;
    o.node = NodeId{uint32_t(frame.objects.size() + 1)};
    o.mesh = std::move(mesh);
    o.worldFromLocal = worldFromLocal;
    o.materials = {clay_};
    frame.objects.push_back(std::move(o));
    return frame.objects.back().node;
}

NodeId Space::last(NodeId node) const
{
    if (frame.objects.empty()) throw Error("a figure marks elements before it has put a mesh");
    return node ? node : frame.objects.back().node;
}

DrawObject& Space::object(NodeId node)
{
    const NodeId wanted = last(node);
    for (DrawObject& o : frame.objects)
        if (o.node == wanted) return o;
    throw Error("a figure names a mesh that it has not put");
}

Mark& Space::mark(ElementKind kind, std::vector<uint32_t> indices, glm::vec4 color, float width, NodeId node)
{
    Mark m;
    m.node = last(node);
    m.kind = kind;
    m.indices = std::move(indices);
    m.color = color;
    m.width = width;
    frame.marks.push_back(std::move(m));
    return frame.marks.back();
}

void Space::faces(std::vector<uint32_t> faces, glm::vec4 color, NodeId node)
{
    mark(ElementKind::Face, std::move(faces), color, 1, node);
}

void Space::edges(std::vector<uint32_t> vertexPairs, glm::vec4 color, float width, NodeId node, bool dashed, bool through)
{
    Mark& m = mark(ElementKind::Edge, std::move(vertexPairs), color, width, node);
    m.style = dashed ? Mark::Style::Dashed : Mark::Style::Solid;
    m.through = through;
}

void Space::vertices(std::vector<uint32_t> vertices, glm::vec4 color, float diameter, NodeId node)
{
    mark(ElementKind::Vertex, std::move(vertices), color, diameter, node);
}

bool Space::hidden(const At& at) const
{
    // Towards the eye; how far off it is does not matter to a figure's small models.
    Camera towards = frame.camera;
    towards.target = glm::dvec3(0);
    const glm::dvec3 way = glm::normalize(towards.eye());
    for (const DrawObject& o : frame.objects) {
        const auto& t = o.mesh.triangulation().vertices;
        const auto place = [&](size_t i) { return glm::dvec3(o.worldFromLocal * glm::dvec4(glm::dvec3(o.mesh.positions()[t[i]]), 1)); };
        for (size_t i = 0; i + 2 < t.size(); i += 3) {
            const glm::dvec3 a = place(i), u = place(i + 1) - a, v = place(i + 2) - a, p = glm::cross(way, v), from = at.p - a;
            const double d = glm::dot(u, p), reach = glm::length(u) + glm::length(v);
            if (std::abs(d) < 1e-12 * reach * reach) continue;
            const double s = glm::dot(from, p) / d, r = glm::dot(way, glm::cross(from, u)) / d, along = glm::dot(v, glm::cross(from, u)) / d;
            if (s > 1e-6 && r > 1e-6 && s + r < 1 - 1e-6 && along > 1e-5 * reach) return true;
        }
    }
    return false;
}

void Space::numberVertices(glm::vec4 color, glm::vec4 behind, NodeId node, int size)
{
    const size_t count = mesh(node).vertexCount();
    for (uint32_t v = 0; v < count; ++v) {
        const bool back = hidden(at(v, node));
        words(at(v, node), std::to_string(v), {back ? behind : color, Beside::Auto, size, !back});
    }
}

void Space::heat(Table table, size_t column, double low, double high, bool histogram, NodeId node)
{
    HeatMap h;
    h.table = std::make_shared<const Table>(std::move(table));
    h.column = column;
    std::tie(h.low, h.high) = low <= high ? std::pair(low, high) : heatRange(h.table->columns[column]);
    scale = Scale{h, histogram, h.table->columns[column].name};
    object(node).heat = std::make_shared<const HeatMap>(h);
}

glm::dvec3 Space::at(uint32_t vertex, NodeId node)
{
    const DrawObject& o = object(node);
    return glm::dvec3(o.worldFromLocal * glm::dvec4(glm::dvec3(o.mesh.positions()[vertex]), 1));
}

glm::dvec3 Space::centre(uint32_t face, NodeId node)
{
    glm::dvec3 sum(0);
    const auto corners = mesh(node).face(face);
    for (const uint32_t v : corners) sum += at(v, node);
    return sum / double(corners.size());
}

void Space::arrange(const Box& place)
{
    Panel::arrange(place);
    const glm::dvec2 pixels(place.size());
    if (!fixed_) {
        CameraFit fit(frame.camera, pixels.x / pixels.y);
        for (const DrawObject& o : frame.objects)
            for (const glm::vec3& p : o.mesh.positions()) fit.add(glm::dvec3(o.worldFromLocal * glm::dvec4(glm::dvec3(p), 1)));
        for (const MarkPoint& p : frame.points) {
            fit.add(glm::dvec3(p.atWorld));
            if (p.toWorld) fit.add(glm::dvec3(*p.toWorld));
        }
        for (const Item& item : items_)
            for (const At& a : item.at) fit.add(a.p);
        fit.apply(frame.camera);
        frame.camera.distance /= zoom;
    }
    frame.camera.fitClip(boundsOf(frame));
}

std::optional<Picture> Space::picture(Offscreen& offscreen, float pixelRatio)
{
    frame.options.pixelRatio = pixelRatio;
    const glm::ivec2 pixels(glm::round(place_.size() * pixelRatio));
    return offscreen.draw(frame, pixels.x, pixels.y);
}

glm::vec2 Space::onPage(const At& at) const
{
    return place_.low + glm::vec2(frame.camera.project(at.p, glm::dvec2(place_.size())));
}

void Space::paint(Painter& painter)
{
    paintItems(painter);
}

}  // namespace mw::figures
