#include "ui/viewport/region_select.h"

#include <algorithm>

#include "core/mesh/select.h"
#include "ui/variants.h"
#include "ui/viewport/step_frame.h"

namespace mw {
namespace {

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

ElementSet visibleElements(ToolView& view, const Region& region, const DrawObject& o, const std::vector<uint32_t>& faces, ElementKind kind)
{
    if (kind == ElementKind::Face) return {kind, faces};
    const Inside inside(view, region, o);
    std::vector<uint8_t> known(o.mesh.vertexCount(), 0);  // 1: outside, 2: inside
    const auto isIn = [&](uint32_t v) {
        if (!known[v]) known[v] = inside.vertex(v) ? 2 : 1;
        return known[v] == 2;
    };
    ElementSet found{kind, {}};
    for (const uint32_t f : faces) {
        const auto corners = o.mesh.face(f);
        for (size_t i = 0; i < corners.size(); ++i) {
            const uint32_t a = corners[i], b = corners[(i + 1) % corners.size()];
            if (!isIn(a)) continue;
            if (kind == ElementKind::Vertex)
                found.indices.push_back(a);
            else if (a != b && isIn(b))
                found.indices.insert(found.indices.end(), {a, b});
        }
    }
    return sorted(std::move(found));
}

ElementSet allElements(ToolView& view, const Region& region, const DrawObject& o, ElementKind kind)
{
    const Inside inside(view, region, o);
    ElementSet found{kind, {}};
    if (kind == ElementKind::Face) {
        for (uint32_t f = 0; f < o.mesh.faceCount(); ++f)
            if (inside.middle(o.mesh.face(f))) found.indices.push_back(f);
        return found;
    }
    std::vector<uint8_t> in(o.mesh.vertexCount());
    for (uint32_t v = 0; v < in.size(); ++v) in[v] = inside.vertex(v);
    if (kind == ElementKind::Vertex) {
        for (uint32_t v = 0; v < in.size(); ++v)
            if (in[v]) found.indices.push_back(v);
        return found;
    }
    const Shared<uint32_t>& edges = o.mesh.edges();
    for (size_t e = 0; e + 1 < edges.size(); e += 2)
        if (in[edges[e]] && in[edges[e + 1]]) found.indices.insert(found.indices.end(), {edges[e], edges[e + 1]});
    return sorted(std::move(found));
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
    ElementSet elements;
};

Found elementsIn(ToolView& view, const Region& region, ElementKind kind)
{
    const NodeId active = view.session().document.selection().active();
    Found best;
    const auto take = [&](NodeId node, ElementSet elements) {
        const size_t n = elements.indices.size();
        const bool better = node == active ? n > 0 : best.node != active && n > best.elements.indices.size();
        if (better) best = {node, std::move(elements)};
    };
    if (view.look().options.xray) {
        for (const DrawObject& o : view.seen().objects) take(o.node, allElements(view, region, o, kind));
        return best;
    }
    for (const auto& [node, faces] : view.visibleFaces(region))
        if (const DrawObject* o = objectOf(view.seen(), node)) take(node, visibleElements(view, region, *o, faces, kind));
    return best;
}

/// Of two sets of elements, as the mode says.
ElementSet combined(const ElementSet& old, const ElementSet& picked, SelectMode mode)
{
    if (mode == SelectMode::Replace || old.kind != picked.kind) return mode == SelectMode::Remove ? old : picked;
    return mode == SelectMode::Add ? united(sorted(old), picked) : without(sorted(old), picked);
}

}  // namespace

ElementKind elementKind(PickKind kind)
{
    return kind == PickKind::Vertex ? ElementKind::Vertex : kind == PickKind::Edge ? ElementKind::Edge : ElementKind::Face;
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
    if (showsVariant(view.look(), document.scene(), found.node)) return;  // elements are picked where the result is shown
    if (!found.node) {
        if (mode == SelectMode::Replace) document.select({old.nodes, {}, {}});
        return;
    }
    const ElementSet& picked = found.elements;
    const bool same = old.elementsOf == found.node && old.elements.kind == picked.kind;
    if (!same && mode == SelectMode::Remove) return;
    document.select({{found.node}, found.node, same ? combined(old.elements, picked, mode) : picked});
}

}  // namespace mw
