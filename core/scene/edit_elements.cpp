// Edits of elements of a base mesh.
#include <algorithm>
#include <cmath>

#include "core/mesh/select.h"
#include "core/scene/edit_entries.h"
#include "core/scene/move_elements.h"

namespace mw {
namespace {

enum class Part { Vertex, Edge, Face };
constexpr ElementKind kindsOfParts[] = {ElementKind::Vertex, ElementKind::Edge, ElementKind::Face};

/// The columns of an affine matrix, so that any move, turn and scaling can be said.
struct MoveElements {
    std::string node;
    Part kind = Part::Vertex;
    std::string elements;
    glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, by{0};
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = "Whose mesh."});
        v.choice("kind", kind, {"vertex", "edge", "face"}, {.title = "Kind", .help = "What the list names."});
        v.text("elements", elements, {.title = "Elements", .help = "Their numbers: 0-99;105, edges as 3~7."});
        v.point("x", x, {.title = "X axis", .help = "Where the step 1, 0, 0 goes."});
        v.point("y", y, {.title = "Y axis", .help = "Where the step 0, 1, 0 goes."});
        v.point("z", z, {.title = "Z axis", .help = "Where the step 0, 0, 1 goes."});
        v.point("by", by, {.title = "Shift", .help = "Added to every place, in the mesh's own space.", .unit = "m"});
    }
};

void moveElements(Scene& scene, const MoveElements& p, EditRun&)
{
    const NodeId node = nodeOf(scene, p.node);
    const Mesh mesh = meshOf(scene, node).base;
    const size_t below = p.kind == Part::Face ? mesh.faceCount() : mesh.vertexCount();
    const ElementSet set = parsedElements(kindsOfParts[size_t(p.kind)], p.elements, below);
    const glm::dmat4 matrix(glm::dvec4(p.x, 0), glm::dvec4(p.y, 0), glm::dvec4(p.z, 0), glm::dvec4(p.by, 1));
    moveVertices(scene, node, verticesOf(mesh, set), matrix);
}

std::string moveElementsName(const Scene& scene, const MoveElements& p)
{
    const char* const many[] = {"vertices", "edges", "faces"};
    return scene.node(nodeOf(scene, p.node)).name + ": move " + many[size_t(p.kind)];
}

}  // namespace

std::vector<uint32_t> verticesOf(const Mesh& mesh, const ElementSet& elements)
{
    std::vector<uint8_t> in(mesh.vertexCount(), 0);
    for (const uint32_t i : elements.indices) {
        if (elements.kind == ElementKind::Face) {
            if (i < mesh.faceCount())
                for (const uint32_t v : mesh.face(i)) in[v] = 1;
        } else if (i < in.size()) {
            in[i] = 1;
        }
    }
    std::vector<uint32_t> out;
    for (uint32_t v = 0; v < in.size(); ++v)
        if (in[v]) out.push_back(v);
    return out;
}

void moveVertices(Scene& scene, NodeId node, std::span<const uint32_t> vertices, const glm::dmat4& matrix)
{
    MeshObject object = meshOf(scene, node);
    Array<glm::vec3> places(object.base.positions().begin(), object.base.positions().end());
    for (const uint32_t v : vertices) {
        const glm::vec3 to(glm::dvec3(matrix * glm::dvec4(glm::dvec3(places[v]), 1)));
        if (!std::isfinite(to.x) || !std::isfinite(to.y) || !std::isfinite(to.z))
            throw Error("vertex " + std::to_string(v) + " of \"" + scene.node(node).name + "\" would leave the range of numbers; move it less far");
        places[v] = to;
    }
    object.base = object.base.withPositions(std::move(places)).without(names::normal).without(names::tangent);
    scene.set(scene.node(node).mesh, std::move(object));
}

std::vector<Edit> elementEdits()
{
    return {editEntry<MoveElements>("move-elements", "Move elements", "Moves, turns or scales vertices, edges or faces of a base mesh.", moveElements,
                                    moveElementsName)};
}

}  // namespace mw
