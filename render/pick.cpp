// What is under the pointer: object and face from the id buffer, the nearest vertex and edge from the faces seen round it.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "render/id_buffer.h"

namespace mw {
namespace {

constexpr double vertexReach = 10, edgeReach = 7;  // logical pixels

/// Vertices of one object as pixels.
class Projected {
public:
    Projected(DrawContext& c, const DrawObject& o) : places_(c.places(o)), size_(c.size), clip_(c.clipFromView * c.viewFromWorld * o.worldFromLocal)
    {}
    /// False behind the eye.
    bool pixel(uint32_t v, glm::dvec2& out) const
    {
        const glm::dvec4 p = clip_ * glm::dvec4(glm::dvec3(places_[v]), 1);
        if (p.w <= 0) return false;
        out = {0.5 * (p.x / p.w + 1) * size_.x, 0.5 * (1 - p.y / p.w) * size_.y};
        return true;
    }

private:
    Shared<glm::vec3> places_;
    glm::dvec2 size_;
    glm::dmat4 clip_;
};

struct Nearest {
    NodeId node;
    uint32_t vertex = none;
    glm::uvec2 edge{none, none};
    double vertexDistance = 0, edgeDistance = 0;
};

bool contains(std::span<const uint32_t> face, uint32_t v)
{
    return std::find(face.begin(), face.end(), v) != face.end();
}

/// Looks at one face's corners and edges; keeps what is nearer than what is known. `seen` says whether a place is not hidden.
class Search {
public:
    Search(const DrawContext& c, glm::dvec2 pixel, const SeenWindow* window) : pixel_(pixel), window_(window)
    {
        best.vertexDistance = vertexReach * c.frame.options.pixelRatio;
        best.edgeDistance = edgeReach * c.frame.options.pixelRatio;
    }

    void face(const DrawObject& o, const Projected& p, std::span<const uint32_t> corners)
    {
        for (size_t i = 0; i < corners.size(); ++i) {
            vertex(o, p, corners[i]);
            edge(o, p, corners[i], corners[(i + 1) % corners.size()]);
        }
    }
    void vertex(const DrawObject& o, const Projected& p, uint32_t v)
    {
        glm::dvec2 at;
        if (!p.pixel(v, at)) return;
        const double d = glm::distance(at, pixel_);
        if (d >= best.vertexDistance || !seen(o, at, v, v)) return;
        best.vertex = v;
        best.vertexDistance = d;
        best.node = o.node;
    }
    void edge(const DrawObject& o, const Projected& p, uint32_t a, uint32_t b)
    {
        glm::dvec2 pa, pb;
        if (a == b || !p.pixel(a, pa) || !p.pixel(b, pb)) return;
        const glm::dvec2 along = pb - pa;
        const double t = std::clamp(glm::dot(pixel_ - pa, along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
        const glm::dvec2 at = pa + t * along;
        const double d = glm::distance(at, pixel_);
        if (d >= best.edgeDistance || !seen(o, at, a, b)) return;
        best.edge = {std::min(a, b), std::max(a, b)};
        best.edgeDistance = d;
        if (best.vertex == none) best.node = o.node;
    }

    Nearest best;

private:
    /// A face with both ends is seen at the place or beside it.
    bool seen(const DrawObject& o, glm::dvec2 at, uint32_t a, uint32_t b) const
    {
        if (!window_) return true;
        const int x = int(std::floor(at.x)), y = int(std::floor(at.y));
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const SeenId id = window_->at(x + dx, y + dy);
                if (id.node != o.node.value) continue;
                if (id.isPoint() ? id.index() == a && a == b : contains(o.mesh.face(id.index()), a) && contains(o.mesh.face(id.index()), b))
                    return true;
            }
        }
        return false;
    }
    glm::dvec2 pixel_;
    const SeenWindow* window_;
};

/// Where a ray meets a triangle's plane within the triangle, as distance along the ray; negative: not at all.
double hit(const Ray& r, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c)
{
    const glm::dvec3 u = b - a, v = c - a, p = glm::cross(r.direction, v);
    const double det = glm::dot(u, p);
    if (det == 0) return -1;
    const glm::dvec3 s = r.origin - a, q = glm::cross(s, u);
    const double x = glm::dot(s, p) / det, y = glm::dot(r.direction, q) / det, slack = 1e-3;  // a pixel's centre may lie just outside
    if (x < -slack || y < -slack || x + y > 1 + slack) return -1;
    return glm::dot(v, q) / det;
}

glm::dvec3 facePoint(DrawContext& c, const DrawObject& o, uint32_t face, glm::dvec2 pixel)
{
    const Ray ray = c.camera.ray(pixel, glm::dvec2(c.size));
    const Mesh::Triangulation& t = o.mesh.triangulation();
    const auto [first, last] = std::equal_range(t.faces.begin(), t.faces.end(), face);
    const Shared<glm::vec3> places = c.places(o);
    const auto world = [&](uint32_t v) { return glm::dvec3(o.worldFromLocal * glm::dvec4(glm::dvec3(places[v]), 1)); };
    double nearest = -1;
    for (const uint32_t* i = first; i != last; ++i) {
        const size_t k = 3 * size_t(i - t.faces.begin());
        const double d = hit(ray, world(t.vertices[k]), world(t.vertices[k + 1]), world(t.vertices[k + 2]));
        if (d > 0 && (nearest < 0 || d < nearest)) nearest = d;
    }
    if (nearest > 0) return ray.origin + nearest * ray.direction;
    const glm::dvec3 corner = world(o.mesh.face(face)[0]);  // seen edge on: the ray just misses it
    return ray.origin + glm::dot(corner - ray.origin, ray.direction) * ray.direction;
}

/// Everything, hidden or not: what X-ray lets in.
void searchAll(DrawContext& c, Search& search, NodeId only)
{
    for (const DrawObject& o : c.frame.objects) {
        if (only && o.node != only) continue;
        const Projected p(c, o);
        for (uint32_t v = 0; v < o.mesh.vertexCount(); ++v) search.vertex(o, p, v);
        const Shared<uint32_t>& edges = o.mesh.edges();
        for (size_t e = 0; e + 1 < edges.size(); e += 2) search.edge(o, p, edges[e], edges[e + 1]);
    }
}

void searchSeen(DrawContext& c, Search& search, const SeenWindow& window, NodeId only)
{
    std::set<std::pair<uint32_t, uint32_t>> done;
    for (const SeenId& id : window.ids) {
        if (id.node == 0 || (only && id.node != only.value) || !done.insert({id.node, id.element}).second) continue;
        const DrawObject* o = c.object(NodeId{id.node});
        if (!o) continue;
        const Projected p(c, *o);
        if (id.isPoint())
            search.vertex(*o, p, id.index());
        else
            search.face(*o, p, o->mesh.face(id.index()));
    }
}

/// Where the ray meets the ground itself; what was drawn may lie a little beside it.
Pick terrainPick(const DrawContext& c, const DrawTerrain& d, glm::dvec2 pixel)
{
    const Ray ray = c.camera.ray(pixel, glm::dvec2(c.size));
    const glm::dmat4 localFromWorld = glm::inverse(d.worldFromLocal);
    const glm::dvec3 origin(localFromWorld * glm::dvec4(ray.origin, 1)), direction(localFromWorld * glm::dvec4(ray.direction, 0));
    Pick pick;
    pick.node = d.node;
    if (const auto met = d.terrain.meet(origin, direction)) {
        pick.atWorld = glm::dvec3(d.worldFromLocal * glm::dvec4(*met, 1));
    } else {  // the ray just misses a ridge
        const glm::dvec3 middle(d.worldFromLocal * glm::dvec4(0, 0.5 * d.terrain.maximumHeight, 0, 1));
        pick.atWorld = ray.origin + glm::dot(middle - ray.origin, ray.direction) * ray.direction;
    }
    return pick;
}

}  // namespace

std::optional<Pick> pickAt(DrawContext& c, IdBuffer& ids, glm::dvec2 pixel)
{
    const glm::ivec2 at(glm::floor(pixel));
    if (at.x < 0 || at.y < 0 || at.x >= c.size.x || at.y >= c.size.y) return {};
    const int reach = int(std::ceil(vertexReach * c.frame.options.pixelRatio)) + 2;
    const SeenWindow window = ids.read(c, at - reach, at + reach + 1);
    const SeenId here = window.at(at.x, at.y);
    if (here.isTerrain())
        if (const DrawTerrain* ground = c.terrain(NodeId{here.node})) return terrainPick(c, *ground, pixel);
    const DrawObject* object = here.node ? c.object(NodeId{here.node}) : nullptr;
    const NodeId only = object ? object->node : NodeId{};  // none: any

    const bool xray = c.frame.options.xray;
    Search search(c, pixel, xray ? nullptr : &window);
    if (xray)
        searchAll(c, search, only);
    else
        searchSeen(c, search, window, only);

    Pick pick;
    pick.node = object ? object->node : search.best.node;
    if (!pick.node) return {};
    const DrawObject& o = *c.object(pick.node);
    if (object && !here.isPoint()) pick.face = here.index();
    pick.vertex = search.best.vertex;
    pick.edge = search.best.edge;
    if (pick.face != none) {
        pick.atWorld = facePoint(c, o, pick.face, pixel);
    } else {
        const uint32_t v = pick.vertex != none ? pick.vertex : pick.edge.x != none ? pick.edge.x : here.index();
        pick.atWorld = glm::dvec3(o.worldFromLocal * glm::dvec4(glm::dvec3(c.places(o)[v]), 1));
    }
    return pick;
}

std::vector<std::pair<NodeId, std::vector<uint32_t>>> facesIn(const SeenWindow& window, const Region& region)
{
    std::map<uint32_t, std::vector<uint32_t>> byNode;
    SeenId last;  // neighbours are mostly of one face
    size_t i = 0;
    for (int y = window.low.y; y < window.high.y; ++y) {
        for (int x = window.low.x; x < window.high.x; ++x, ++i) {
            const SeenId id = window.ids[i];
            if (id == last || id.node == 0 || !region.contains({x + 0.5, y + 0.5})) continue;
            last = id;
            if (id.isTerrain())
                byNode[id.node];  // seen, but of no faces
            else if (!id.isPoint())
                byNode[id.node].push_back(id.index());
        }
    }
    std::vector<std::pair<NodeId, std::vector<uint32_t>>> out;
    for (auto& [node, faces] : byNode) {
        std::sort(faces.begin(), faces.end());
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
        out.emplace_back(NodeId{node}, std::move(faces));
    }
    return out;
}

}  // namespace mw
