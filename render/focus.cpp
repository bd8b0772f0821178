// The focus of a step as marks: each role has its shape as well as its colour.
#include <algorithm>
#include <functional>
#include <map>

#include "render/colors.h"
#include "render/height_grid.h"
#include "render/value_frame.h"

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

/// What a focus can be about in a value: places of vertices (samples, points, joints), and which of them a face (a cell) has.
struct Elements {
    size_t vertices = 0, faces = 0;
    ElementKind vertexKind = ElementKind::Vertex, faceKind = ElementKind::Face;
    bool marked = false;   ///< drawn as a mesh of these very vertices and faces, on which marks may lie
    bool through = false;  ///< seen through surfaces
    std::function<glm::dvec3(uint32_t)> vertex = {};
    std::function<std::vector<uint32_t>(uint32_t)> face = {};
    std::function<glm::dvec3(glm::dvec3)> place = {};  ///< of points and segments; none: as they are
};

Elements elementsOf(const Mesh& mesh)
{
    Elements e;
    e.vertices = mesh.vertexCount();
    e.faces = mesh.faceCount();
    e.marked = true;
    e.vertex = [mesh](uint32_t v) { return glm::dvec3(mesh.positions()[v]); };
    e.face = [mesh](uint32_t f) { return std::vector<uint32_t>(mesh.face(f).begin(), mesh.face(f).end()); };
    return e;
}

Elements elementsOf(const HeightMap& map)
{
    Elements e;
    if (map.empty()) return e;
    const auto grid = std::make_shared<HeightGrid>(map);
    const uint32_t width = map.width();
    e.vertices = size_t(width) * map.height();
    e.faces = size_t(width - 1) * (map.height() - 1);
    e.faceKind = ElementKind::Cell;
    e.marked = grid->stride() == 1;
    e.vertex = [grid](uint32_t i) { return grid->sample(i); };
    e.face = [width](uint32_t i) {
        const uint32_t a = i / (width - 1) * width + i % (width - 1);
        return std::vector<uint32_t>{a, a + width, a + width + 1, a + 1};
    };
    e.place = [grid](glm::dvec3 at) { return grid->place(at.x, at.y, at.z); };
    return e;
}

Elements elementsOf(const Curve& curve)
{
    Elements e;
    e.vertices = curve.points.size();
    e.marked = true;
    e.vertex = [&curve](uint32_t i) { return curve.points[i]; };
    return e;
}

Elements elementsOf(const Pose& pose)
{
    Elements e;
    e.vertices = pose.size();
    e.vertexKind = ElementKind::Joint;
    e.through = true;
    e.vertex = [places = jointPlaces(pose)](uint32_t i) { return places[i]; };
    return e;
}

template <class T>
Elements elementsOf(const T&)
{
    return {};
}

/// One entry of a focus: the vertices it is about, or its places.
struct Found {
    enum class What { Nothing, Vertex, Edge, Face, Point, Segment } what = What::Nothing;
    std::vector<uint32_t> vertices = {};
    glm::dvec3 at{0}, to{0};
};

Found find(const Focus& f, const Elements& e, const Value& value)
{
    const auto in = [&](uint32_t v) { return v < e.vertices; };
    const auto place = [&](const glm::vec3& p) { return e.place ? e.place(glm::dvec3(p)) : glm::dvec3(p); };
    if (f.kind == ElementKind::Point) return {Found::What::Point, {}, place(f.at), {}};
    if (f.kind == ElementKind::Segment) return {Found::What::Segment, {}, place(f.at), place(f.to)};
    if (f.kind == e.vertexKind && in(f.index)) return {Found::What::Vertex, {f.index}, {}, {}};
    if (f.kind == ElementKind::Edge && in(f.index) && in(f.other)) return {Found::What::Edge, {f.index, f.other}, {}, {}};
    if (f.kind == e.faceKind && f.index < e.faces) return {Found::What::Face, e.face(f.index), {}, {}};
    const Mesh* mesh = std::get_if<Mesh>(&value);
    if (f.kind == ElementKind::Corner && mesh && f.index < mesh->cornerCount()) return {Found::What::Vertex, {mesh->cornerVertex()[f.index]}, {}, {}};
    return {};
}

glm::dvec3 centreOf(const Found& f, const Elements& e)
{
    if (f.what == Found::What::Point) return f.at;
    if (f.what == Found::What::Segment) return 0.5 * (f.at + f.to);
    glm::dvec3 sum(0);
    for (const uint32_t v : f.vertices) sum += e.vertex(v);
    return f.vertices.empty() ? sum : sum / double(f.vertices.size());
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

/// Puts the marks of one focus into a frame.
class Marker {
public:
    Marker(Frame& frame, const Value& value, NodeId node, const glm::dmat4& worldFromLocal)
        : frame_(frame),
          value_(value),
          node_(node),
          worldFromLocal_(worldFromLocal),
          elements_(std::visit([](const auto& v) { return elementsOf(v); }, value))
    {}
    void add(const Focus& f)
    {
        const Found found = find(f, elements_, value_);
        if (found.what == Found::What::Nothing) return;
        const glm::vec4 color(roleColor(f.role), 1);
        if (found.what == Found::What::Point)
            point(found.at, f.role, f.role == Role::Neighbour ? 7.f : 11.f);
        else if (found.what == Found::What::Segment)
            segment(found.at, found.to, f.role);
        else if (elements_.marked)
            mark(found, f);
        else
            place(found, f.role);
        if (f.label) frame_.labels.push_back({world(centreOf(found, elements_)), f.label, color});
    }
    void finish()
    {
        for (auto& [look, mark] : byLook_) frame_.marks.push_back(std::move(mark));
    }

private:
    glm::vec3 world(glm::dvec3 p) const { return glm::vec3(worldFromLocal_ * glm::dvec4(p, 1)); }
    void point(glm::dvec3 at, Role role, float diameter)
    {
        frame_.points.push_back({world(at), glm::vec4(roleColor(role), 1), diameter, {}, false, elements_.through});
    }
    void segment(glm::dvec3 a, glm::dvec3 b, Role role)
    {
        frame_.points.push_back({world(a), glm::vec4(roleColor(role), 1), edgeLook(role).width, world(b), role == Role::Rejected, elements_.through});
    }
    // On the mesh that is drawn. Later in this order is drawn over earlier: what the step is about comes last.
    void mark(const Found& found, const Focus& f)
    {
        constexpr Role order[] = {Role::Neighbour, Role::Removed, Role::Rejected, Role::Current, Role::New};
        const int rank = int(std::find(std::begin(order), std::end(order), f.role) - std::begin(order));
        const ElementKind kind = found.what == Found::What::Vertex ? ElementKind::Vertex
                                 : found.what == Found::What::Edge ? ElementKind::Edge
                                                                   : ElementKind::Face;
        Mark& m = byLook_.try_emplace({rank, kind}, makeMark(node_, kind, f.role)).first->second;
        if (kind == ElementKind::Face)
            m.indices.push_back(f.index);
        else
            m.indices.insert(m.indices.end(), found.vertices.begin(), found.vertices.end());
    }
    void place(const Found& found, Role role)
    {
        const std::vector<uint32_t>& v = found.vertices;
        if (found.what == Found::What::Vertex) return point(elements_.vertex(v[0]), role, vertexLook(role).width);
        const size_t sides = found.what == Found::What::Edge ? 1 : v.size();
        for (size_t i = 0; i < sides; ++i) segment(elements_.vertex(v[i]), elements_.vertex(v[(i + 1) % v.size()]), role);
    }

    Frame& frame_;
    const Value& value_;
    NodeId node_;
    const glm::dmat4& worldFromLocal_;
    Elements elements_;
    std::map<std::pair<int, ElementKind>, Mark> byLook_;
};

}  // namespace

void addFocus(Frame& frame, const StepRecord& step, const Value& value, NodeId node, const glm::dmat4& worldFromLocal)
{
    Marker marker(frame, value, node, worldFromLocal);
    for (const Focus& f : step.focus) marker.add(f);
    marker.finish();
}

Bounds focusBounds(const StepRecord& step, const Value& value, const glm::dmat4& worldFromLocal)
{
    Bounds b;
    const Elements e = std::visit([](const auto& v) { return elementsOf(v); }, value);
    const auto add = [&](glm::dvec3 p) { b.add(glm::dvec3(worldFromLocal * glm::dvec4(p, 1))); };
    for (const Focus& f : step.focus) {
        const Found found = find(f, e, value);
        if (found.what == Found::What::Point || found.what == Found::What::Segment) add(found.at);
        if (found.what == Found::What::Segment) add(found.to);
        for (const uint32_t v : found.vertices) add(e.vertex(v));
    }
    return b;
}

}  // namespace mw
