// Each kind of value as things a frame has: meshes, bones, marks by place.
#include "render/value_frame.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "core/character/interpolate_rotation.h"
#include "render/colors.h"
#include "render/height_grid.h"

namespace mw {
namespace {

constexpr glm::vec3 boneColor = hex(0xB4C2D0), jointColor = hex(0xE6ECF2), targetColor = hex(0xFF5FA2), curveColor = hex(0x6CB2FF);
constexpr glm::vec3 axisColors[] = {hex(0xF0605A), hex(0x6FC36A), hex(0x5C9DF5)};
constexpr glm::vec3 pathColors[] = {hex(0xFFB347), hex(0x31C6F0), hex(0x8FE36B), hex(0xD58CFF)};
constexpr size_t mostPoints = 100;  // of a curve or a path that are marked one by one

struct Place {
    Frame& frame;
    NodeId node;
    const glm::dmat4& worldFromLocal;
    glm::vec3 world(glm::dvec3 p) const { return glm::vec3(worldFromLocal * glm::dvec4(p, 1)); }
    DrawObject& object(Mesh mesh, NodeId of)
    {
        DrawObject o;
        o.node = of;
        o.worldFromLocal = worldFromLocal;
        o.mesh = std::move(mesh);
        frame.objects.push_back(std::move(o));
        return frame.objects.back();
    }
};

/// Points joined one after the other; vertices are the points.
Mesh polyline(std::span<const glm::dvec3> points, bool closed)
{
    Array<glm::vec3> p(points.begin(), points.end());
    Array<uint32_t> lines;
    for (uint32_t i = 0; i + 1 < points.size(); ++i) lines.insert(lines.end(), {i, i + 1});
    if (closed && points.size() > 2) lines.insert(lines.end(), {uint32_t(points.size() - 1), 0u});
    return Mesh(std::move(p), Array<uint32_t>{0u}, Array<uint32_t>{}).withLines(std::move(lines));
}

/// A wide line along all the loose lines of a mesh, and discs on its points.
void markLines(Frame& frame, const DrawObject& o, glm::vec3 color, float width, float discs)
{
    Mark line;
    line.node = o.node;
    line.kind = ElementKind::Edge;
    line.indices.assign(o.mesh.lines().begin(), o.mesh.lines().end());
    line.color = glm::vec4(color, 1);
    line.width = width;
    frame.marks.push_back(line);
    if (discs <= 0) return;
    Mark points = std::move(line);
    points.kind = ElementKind::Vertex;
    points.indices.resize(o.mesh.vertexCount());
    for (uint32_t i = 0; i < points.indices.size(); ++i) points.indices[i] = i;
    points.width = discs;
    frame.marks.push_back(std::move(points));
}

void add(Place p, const Mesh& mesh)
{
    p.object(mesh, p.node);
}

void add(Place p, const HeightMap& map)
{
    p.object(HeightGrid(map).mesh(), p.node);
}

void add(Place p, const Curve& curve)
{
    if (!curve.control.empty()) p.object(polyline(curve.control, curve.closed), {});
    const DrawObject& o = p.object(polyline(curve.points, curve.closed), p.node);
    markLines(p.frame, o, curveColor, 3, curve.points.size() <= mostPoints ? 6 : 0);
}

/// A disc with a cross through it, of a size that goes with the skeleton.
void addTarget(Place p, glm::dvec3 at, double reach)
{
    const glm::vec4 color(targetColor, 1);
    p.frame.points.push_back({p.world(at), color, 11, {}, false, true});
    for (int k = 0; k < 3; ++k) {
        glm::dvec3 arm(0);
        arm[k] = reach;
        p.frame.points.push_back({p.world(at - arm), color, 2, p.world(at + arm), false, true});
    }
}

void add(Place p, const Pose& pose)
{
    if (!pose.skeleton) return;
    const std::vector<glm::dvec3> places = jointPlaces(pose);
    const std::vector<Joint>& joints = pose.skeleton->joints;
    std::vector<bool> ends(places.size(), true);
    Bounds bounds;
    for (size_t i = 0; i < places.size(); ++i) {
        bounds.add(places[i]);
        if (joints[i].parent == none) continue;
        ends[joints[i].parent] = false;
        p.frame.bones.push_back({joints[joints[i].parent].node, p.world(places[joints[i].parent]), p.world(places[i]), glm::vec4(boneColor, 1)});
    }
    for (size_t i = 0; i < places.size(); ++i) {
        if (ends[i] && !joints[i].end) p.frame.bones.push_back({joints[i].node, p.world(places[i]), p.world(places[i]), glm::vec4(boneColor, 1)});
        p.frame.points.push_back({p.world(places[i]), glm::vec4(jointColor, 1), 6, {}, false, true});
    }
    for (const PoseTarget& t : pose.targets) addTarget(p, t.at, 0.03 * bounds.diagonal());
}

/// Meridians and parallels of the unit sphere, every 30 degrees.
Mesh globe()
{
    constexpr uint32_t around = 72;
    Array<glm::vec3> points;
    Array<uint32_t> lines;
    const auto circle = [&](auto at) {
        const auto first = uint32_t(points.size());
        for (uint32_t i = 0; i < around; ++i) {
            points.emplace_back(at(2 * M_PI * i / around));
            lines.insert(lines.end(), {first + i, first + (i + 1) % around});
        }
    };
    for (int k = 0; k < 6; ++k) {
        const double turn = M_PI * k / 6;
        circle([&](double a) { return glm::dvec3(std::cos(turn) * std::sin(a), std::cos(a), std::sin(turn) * std::sin(a)); });
    }
    for (int k = -2; k <= 2; ++k) {
        const double up = M_PI * k / 6;
        circle([&](double a) { return glm::dvec3(std::cos(up) * std::cos(a), std::sin(up), std::cos(up) * std::sin(a)); });
    }
    return Mesh(std::move(points), Array<uint32_t>{0u}, Array<uint32_t>{}).withLines(std::move(lines));
}

/// One path over the sphere, and its samples where they can be told apart: their distances show the speed.
void addPath(Place p, const Rotations::Path& path, glm::dvec3 axis, glm::vec4 color, float width)
{
    const std::vector<Rotations::Sample>& s = path.samples;
    for (size_t i = 0; i + 1 < s.size(); ++i)
        p.frame.points.push_back({p.world(s[i].orientation * axis), color, width, p.world(s[i + 1].orientation * axis)});
    if (s.size() <= mostPoints)
        for (const Rotations::Sample& one : s) p.frame.points.push_back({p.world(one.orientation * axis), color, width + 3, {}});
    if (!s.empty()) p.frame.labels.push_back({p.world(s[s.size() / 2].orientation * axis * 1.06), path.name, color});
}

void add(Place p, const Rotations& r)
{
    constexpr float widths[] = {3, 7, 3};  // NLERP and SLERP go the same way: one shows under the other
    p.object(globe(), p.node).dimmed = true;
    const glm::dvec3 axis = tracedAxis(r);
    glm::dquat now = r.from;
    for (size_t k = 0; k < r.paths.size(); ++k) {
        addPath(p, r.paths[k], axis, glm::vec4(pathColors[k % std::size(pathColors)], 1), widths[k % std::size(widths)]);
        if (!r.paths[k].samples.empty()) now = r.paths[k].samples.back().orientation;
    }
    for (int k = 0; k < 3; ++k) {
        glm::dvec3 body(0);
        body[k] = 1;
        p.frame.points.push_back({p.world({}), glm::vec4(axisColors[k], 1), 4, p.world(now * body)});
    }
    for (const glm::dquat& end : {r.from, r.to}) p.frame.points.push_back({p.world(end * axis), glm::vec4(jointColor, 1), 8, {}});
}

template <class T>
void add(Place, const T&)
{}

}  // namespace

bool isDrawable(const Value& value)
{
    switch (kindOf(value)) {
        case Kind::Mesh:
        case Kind::HeightMap:
        case Kind::Curve:
        case Kind::Pose:
        case Kind::Rotations:
            return true;
        default:
            return false;
    }
}

void addValue(Frame& frame, const Value& value, NodeId node, const glm::dmat4& worldFromLocal)
{
    std::visit([&](const auto& v) { add(Place{frame, node, worldFromLocal}, v); }, value);
}

}  // namespace mw
