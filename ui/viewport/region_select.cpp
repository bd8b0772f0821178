#include "ui/viewport/region_select.h"

#include <algorithm>

#include "ui/viewport/step_frame.h"

namespace mw {
namespace {

/// Elements as one number each, so that sets are sorted arrays: an index, or both of an edge.
using Keys = std::vector<uint64_t>;

uint64_t edgeKey(uint32_t a, uint32_t b)
{
    return uint64_t(std::min(a, b)) << 32 | std::max(a, b);
}

Keys keysOf(const ElementSet& s)
{
    Keys keys;
    if (s.kind == ElementKind::Edge)
        for (size_t i = 0; i + 1 < s.indices.size(); i += 2) keys.push_back(edgeKey(s.indices[i], s.indices[i + 1]));
    else
        keys.assign(s.indices.begin(), s.indices.end());
    if (!std::is_sorted(keys.begin(), keys.end())) std::sort(keys.begin(), keys.end());
    return keys;
}

ElementSet setOf(ElementKind kind, const Keys& keys)
{
    ElementSet s{kind, {}};
    s.indices.reserve(keys.size() * (kind == ElementKind::Edge ? 2 : 1));
    for (const uint64_t k : keys) {
        if (kind == ElementKind::Edge) s.indices.push_back(uint32_t(k >> 32));
        s.indices.push_back(uint32_t(k));
    }
    return s;
}

/// Which vertices of an object lie in the region.
class Inside {
public:
    Inside(ToolView& view, const Region& region, const DrawObject& o)
        : region_(region), size_(view.pixelRatio() * view.logicalSize()), places_(o.pose ? posedPositions(o.mesh, *o.pose) : o.mesh.positions())
    {
        const Camera& c = view.look().camera;
        clip_ = c.clipFromView(size_.x / size_.y) * c.viewFromWorld() * o.worldFromLocal;
    }
    bool vertex(uint32_t v) const { return point(glm::dvec3(places_[v])); }
    bool middle(std::span<const uint32_t> face) const
    {
        glm::dvec3 sum(0);
        for (const uint32_t v : face) sum += glm::dvec3(places_[v]);
        return !face.empty() && point(sum / double(face.size()));
    }

private:
    bool point(const glm::dvec3& local) const
    {
        const glm::dvec4 p = clip_ * glm::dvec4(local, 1);
        return p.w > 0 && region_.contains(0.5 * glm::dvec2(1 + p.x / p.w, 1 - p.y / p.w) * size_);
    }
    const Region& region_;
    glm::dvec2 size_;
    Shared<glm::vec3> places_;
    glm::dmat4 clip_{1};
};

const DrawObject* objectOf(const Frame& frame, NodeId node)
{
    for (const DrawObject& o : frame.objects)
        if (o.node == node) return &o;
    return nullptr;
}

Keys sorted(Keys keys)
{
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
}

Keys visibleElements(ToolView& view, const Region& region, const DrawObject& o, const std::vector<uint32_t>& faces, ElementKind kind)
{
    if (kind == ElementKind::Face) return Keys(faces.begin(), faces.end());
    const Inside inside(view, region, o);
    std::vector<uint8_t> known(o.mesh.vertexCount(), 0);  // 1: outside, 2: inside
    const auto isIn = [&](uint32_t v) {
        if (!known[v]) known[v] = inside.vertex(v) ? 2 : 1;
        return known[v] == 2;
    };
    Keys keys;
    for (const uint32_t f : faces) {
        const auto corners = o.mesh.face(f);
        for (size_t i = 0; i < corners.size(); ++i) {
            const uint32_t a = corners[i], b = corners[(i + 1) % corners.size()];
            if (!isIn(a)) continue;
            if (kind == ElementKind::Vertex)
                keys.push_back(a);
            else if (a != b && isIn(b))
                keys.push_back(edgeKey(a, b));
        }
    }
    return sorted(std::move(keys));
}

Keys allElements(ToolView& view, const Region& region, const DrawObject& o, ElementKind kind)
{
    const Inside inside(view, region, o);
    Keys keys;
    if (kind == ElementKind::Face) {
        for (uint32_t f = 0; f < o.mesh.faceCount(); ++f)
            if (inside.middle(o.mesh.face(f))) keys.push_back(f);
        return keys;
    }
    std::vector<uint8_t> in(o.mesh.vertexCount());
    for (uint32_t v = 0; v < in.size(); ++v) in[v] = inside.vertex(v);
    if (kind == ElementKind::Vertex) {
        for (uint32_t v = 0; v < in.size(); ++v)
            if (in[v]) keys.push_back(v);
        return keys;
    }
    const Shared<uint32_t>& edges = o.mesh.edges();
    for (size_t e = 0; e + 1 < edges.size(); e += 2)
        if (in[edges[e]] && in[edges[e + 1]]) keys.push_back(edgeKey(edges[e], edges[e + 1]));
    return sorted(std::move(keys));
}

void selectNodes(Document& document, const std::vector<NodeId>& found, SelectMode mode)
{
    std::vector<NodeId> nodes = mode == SelectMode::Replace ? std::vector<NodeId>() : document.selection().nodes;
    for (const NodeId n : found) {
        std::erase(nodes, n);
        if (mode != SelectMode::Remove) nodes.push_back(n);
    }
    document.select({std::move(nodes), {}, {}});
}

std::vector<NodeId> jointsIn(ToolView& view, const Region& region)
{
    std::vector<NodeId> joints;
    for (const DrawBone& b : view.seen().bones) {
        const glm::dvec3 at = view.look().camera.project(glm::dvec3(b.head), view.logicalSize());
        const bool in = at.z >= 0 && at.z <= 1 && region.contains(view.pixelRatio() * glm::dvec2(at));
        if (in && std::find(joints.begin(), joints.end(), b.node) == joints.end()) joints.push_back(b.node);
    }
    return joints;
}

std::vector<NodeId> objectsIn(ToolView& view, const Region& region)
{
    std::vector<NodeId> nodes;
    for (const auto& [node, faces] : view.visibleFaces(region)) nodes.push_back(node);
    if (!view.look().options.xray) return nodes;
    for (const DrawObject& o : view.seen().objects) {
        if (std::find(nodes.begin(), nodes.end(), o.node) != nodes.end()) continue;
        const Inside inside(view, region, o);
        for (uint32_t v = 0; v < o.mesh.vertexCount(); ++v)
            if (inside.vertex(v)) {
                nodes.push_back(o.node);
                break;
            }
    }
    return nodes;
}

struct Found {
    NodeId node;
    Keys keys;
};

Found elementsIn(ToolView& view, const Region& region, ElementKind kind)
{
    const NodeId active = view.session().document.selection().active();
    Found best;
    const auto take = [&](NodeId node, Keys keys) {
        const bool better = node == active ? !keys.empty() : best.node != active && keys.size() > best.keys.size();
        if (better) best = {node, std::move(keys)};
    };
    if (view.look().options.xray) {
        for (const DrawObject& o : view.seen().objects) take(o.node, allElements(view, region, o, kind));
        return best;
    }
    for (const auto& [node, faces] : view.visibleFaces(region))
        if (const DrawObject* o = objectOf(view.seen(), node)) take(node, visibleElements(view, region, *o, faces, kind));
    return best;
}

}  // namespace

ElementKind elementKind(PickKind kind)
{
    return kind == PickKind::Vertex ? ElementKind::Vertex : kind == PickKind::Edge ? ElementKind::Edge : ElementKind::Face;
}

ElementSet combined(const ElementSet& old, const ElementSet& picked, SelectMode mode)
{
    if (mode == SelectMode::Replace || old.kind != picked.kind) return mode == SelectMode::Remove ? old : picked;
    const Keys a = keysOf(old), b = keysOf(picked);
    Keys out;
    out.reserve(a.size() + b.size());
    if (mode == SelectMode::Add)
        std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
    else
        std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
    return setOf(picked.kind, out);
}

void selectRegion(ToolView& view, const Region& region, SelectMode mode)
{
    Document& document = view.session().document;
    const PickKind kind = view.session().view.pickKind;
    if (isLab(view.session().steps)) return;
    if (kind == PickKind::Joint) return selectNodes(document, jointsIn(view, region), mode);
    if (kind == PickKind::Object) return selectNodes(document, objectsIn(view, region), mode);
    const Found found = elementsIn(view, region, elementKind(kind));
    const Selection& old = document.selection();
    if (!found.node) {
        if (mode == SelectMode::Replace) document.select({old.nodes, {}, {}});
        return;
    }
    const ElementSet picked = setOf(elementKind(kind), found.keys);
    const bool same = old.elementsOf == found.node && old.elements.kind == picked.kind;
    if (!same && mode == SelectMode::Remove) return;
    document.select({{found.node}, found.node, same ? combined(old.elements, picked, mode) : picked});
}

}  // namespace mw
