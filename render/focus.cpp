// The focus of a step as marks: each role has its shape as well as its colour.
#include <algorithm>
#include <map>

#include "render/colors.h"

namespace mw {
namespace {

struct Look {
    float width;
    float alpha = 1;
    Mark::Style style = Mark::Style::Solid;
};

Look vertexLook(Role r)
{
    switch (r) {
        case Role::Current:
            return {12};
        case Role::Neighbour:
            return {7};
        case Role::New:
            return {15, 1, Mark::Style::Plus};
        case Role::Removed:
            return {9};
        case Role::Rejected:
            return {9};
    }
    return {8};
}

Look edgeLook(Role r)
{
    switch (r) {
        case Role::Current:
            return {4.5f};
        case Role::Neighbour:
            return {2};
        case Role::New:
            return {3};
        case Role::Removed:
            return {3};
        case Role::Rejected:
            return {3.5f, 1, Mark::Style::Dashed};
    }
    return {2};
}

Look faceLook(Role r)
{
    switch (r) {
        case Role::Current:
            return {1, 0.6f};
        case Role::Neighbour:
            return {1, 0.42f};
        case Role::New:
            return {1, 0.55f};
        case Role::Removed:
            return {1, 0.9f, Mark::Style::Hatched};
        case Role::Rejected:
            return {1, 0.5f, Mark::Style::Hatched};
    }
    return {1, 0.5f};
}

/// Focus entries that are elements of the mesh, corners as their vertices.
bool elementOf(const Focus& f, const Mesh& mesh, ElementKind& kind, std::vector<uint32_t>& indices)
{
    kind = f.kind;
    switch (f.kind) {
        case ElementKind::Vertex:
            indices = {f.index};
            return f.index < mesh.vertexCount();
        case ElementKind::Edge:
            indices = {f.index, f.other};
            return f.index < mesh.vertexCount() && f.other < mesh.vertexCount();
        case ElementKind::Face:
            indices = {f.index};
            return f.index < mesh.faceCount();
        case ElementKind::Corner:
            if (f.index >= mesh.cornerCount()) return false;
            kind = ElementKind::Vertex;
            indices = {mesh.cornerVertex()[f.index]};
            return true;
        default:
            return false;
    }
}

glm::dvec3 placeOf(const Mesh& mesh, ElementKind kind, const std::vector<uint32_t>& indices)
{
    const std::span<const uint32_t> vertices = kind == ElementKind::Face ? mesh.face(indices[0]) : std::span<const uint32_t>(indices);
    glm::dvec3 sum(0);
    for (const uint32_t v : vertices) sum += glm::dvec3(mesh.positions()[v]);
    return vertices.empty() ? sum : sum / double(vertices.size());
}

Mark makeMark(NodeId node, ElementKind kind, Role role)
{
    const Look look = kind == ElementKind::Vertex ? vertexLook(role) : kind == ElementKind::Edge ? edgeLook(role) : faceLook(role);
    Mark m;
    m.node = node;
    m.kind = kind;
    m.color = glm::vec4(roleColor(role), look.alpha);
    m.width = look.width;
    m.style = look.style;
    return m;
}

}  // namespace

void addFocus(const StepRecord& step, const Mesh& mesh, NodeId node, const glm::dmat4& worldFromLocal, std::vector<Mark>& marks,
              std::vector<MarkPoint>& points, std::vector<Label>& labels)
{
    const auto world = [&](glm::dvec3 p) { return glm::vec3(worldFromLocal * glm::dvec4(p, 1)); };
    // Later in this order is drawn over earlier: what the step is about comes last.
    constexpr Role order[] = {Role::Neighbour, Role::Removed, Role::Rejected, Role::Current, Role::New};
    std::map<std::pair<int, ElementKind>, Mark> byLook;
    for (const Focus& f : step.focus) {
        const int rank = int(std::find(std::begin(order), std::end(order), f.role) - std::begin(order));
        const glm::vec4 color(roleColor(f.role), 1);
        ElementKind kind{};
        std::vector<uint32_t> indices;
        glm::vec3 labelAt{0};
        if (f.kind == ElementKind::Point) {
            labelAt = world(f.at);
            points.push_back({labelAt, color, f.role == Role::Neighbour ? 7.f : 11.f, {}, false});
        } else if (f.kind == ElementKind::Segment) {
            const glm::vec3 a = world(f.at), b = world(f.to);
            labelAt = 0.5f * (a + b);
            points.push_back({a, color, edgeLook(f.role).width, b, f.role == Role::Rejected});
        } else if (elementOf(f, mesh, kind, indices)) {
            Mark& m = byLook.try_emplace({rank, kind}, makeMark(node, kind, f.role)).first->second;
            m.indices.insert(m.indices.end(), indices.begin(), indices.end());
            labelAt = world(placeOf(mesh, kind, indices));
        } else {
            continue;
        }
        if (f.label) labels.push_back({labelAt, f.label, color});
    }
    for (auto& [look, mark] : byLook) marks.push_back(std::move(mark));
}

}  // namespace mw
