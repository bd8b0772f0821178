#include "render/bones.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "render/colors.h"

namespace mw {
namespace {

constexpr double apart = 25;                      // CIEDE2000 between relatives
constexpr ptrdiff_t mostSiblings = 12;            // that one is told from: the nearest before it
constexpr double jointReach = 12, boneReach = 5;  // logical pixels
constexpr double stubLength = 0.3;                // of the bone before it

glm::dvec3 placeOf(const std::map<NodeId, glm::dmat4>& worlds, NodeId id)
{
    return glm::dvec3(worlds.at(id)[3]);
}

/// The nearest joint above a node, over nodes that are none.
NodeId jointAbove(const Scene& scene, NodeId id)
{
    NodeId up = scene.node(id).parent;
    while (up && scene.node(up).joint == Node::Joint::No) up = scene.node(up).parent;
    return up;
}

std::set<NodeId> hiddenNodes(const Scene& scene)
{
    std::set<NodeId> hidden;
    for (const NodeId id : scene.nodes())
        if (!scene.node(id).visible || hidden.count(scene.node(id).parent)) hidden.insert(id);
    return hidden;
}

glm::dvec3 labOf(glm::vec3 srgb)
{
    const glm::dvec3 rgb(linearOf(srgb));
    const glm::dvec3 white(0.95047, 1, 1.08883);
    const glm::dvec3 xyz(0.4124564 * rgb.x + 0.3575761 * rgb.y + 0.1804375 * rgb.z, 0.2126729 * rgb.x + 0.7151522 * rgb.y + 0.0721750 * rgb.z,
                         0.0193339 * rgb.x + 0.1191920 * rgb.y + 0.9503041 * rgb.z);
    glm::dvec3 f;
    for (int i = 0; i < 3; ++i) {
        const double t = xyz[i] / white[i];
        f[i] = t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
    }
    return {116 * f.y - 16, 500 * (f.x - f.y), 200 * (f.y - f.z)};
}

/// The angle of a and b, 0 to 360 degrees.
double hueOf(double a, double b)
{
    if (a == 0 && b == 0) return 0;
    const double h = glm::degrees(std::atan2(b, a));
    return h < 0 ? h + 360 : h;
}

double labDifference(glm::dvec3 p, glm::dvec3 q)
{
    const auto seventh = [](double c) { return std::sqrt(std::pow(c, 7) / (std::pow(c, 7) + std::pow(25.0, 7))); };
    const double mean = 0.5 * (std::hypot(p.y, p.z) + std::hypot(q.y, q.z)), g = 1.5 - 0.5 * seventh(mean);
    const double a1 = g * p.y, a2 = g * q.y, c1 = std::hypot(a1, p.z), c2 = std::hypot(a2, q.z);
    const double h1 = hueOf(a1, p.z), h2 = hueOf(a2, q.z);
    const bool grey = c1 * c2 == 0;
    double turn = grey ? 0 : h2 - h1;
    if (turn > 180) turn -= 360;
    if (turn < -180) turn += 360;
    const double dL = q.x - p.x, dC = c2 - c1, dH = 2 * std::sqrt(c1 * c2) * std::sin(glm::radians(0.5 * turn));
    const double L = 0.5 * (p.x + q.x), C = 0.5 * (c1 + c2);
    double h = h1 + h2;
    if (!grey) h = std::abs(h1 - h2) <= 180 ? 0.5 * h : h < 360 ? 0.5 * (h + 360) : 0.5 * (h - 360);
    const auto wave = [](double degrees) { return std::cos(glm::radians(degrees)); };
    const double T = 1 - 0.17 * wave(h - 30) + 0.24 * wave(2 * h) + 0.32 * wave(3 * h + 6) - 0.20 * wave(4 * h - 63);
    const double away = (L - 50) * (L - 50), SL = 1 + 0.015 * away / std::sqrt(20 + away), SC = 1 + 0.045 * C, SH = 1 + 0.015 * C * T;
    const double RT = -std::sin(glm::radians(60 * std::exp(-std::pow((h - 275) / 25, 2)))) * 2 * seventh(C);
    const double l = dL / SL, c = dC / SC, t = dH / SH;
    return std::sqrt(std::max(0.0, l * l + c * c + t * t + RT * c * t));
}

/// Between any two of the 24 colours.
class Differences {
public:
    Differences()
    {
        for (int i = 0; i < categoryCount; ++i)
            for (int k = 0; k < categoryCount; ++k) between_[i][k] = colorDifference(categoryColor(i), categoryColor(k));
    }
    double least(int color, const std::vector<int>& others) const
    {
        double d = 1e9;
        for (const int o : others) d = std::min(d, between_[color][o]);
        return d;
    }

private:
    double between_[categoryCount][categoryCount];
};

int firstApart(const Differences& differences, const std::vector<int>& relatives)
{
    int best = 0;
    for (int i = 0; i < categoryCount; ++i) {
        const double d = differences.least(i, relatives);
        if (d >= apart) return i;
        if (d > differences.least(best, relatives)) best = i;
    }
    return best;
}

}  // namespace

double colorDifference(glm::vec3 a, glm::vec3 b)
{
    return labDifference(labOf(a), labOf(b));
}

std::map<NodeId, glm::vec3> boneColors(const Scene& scene)
{
    static const Differences differences;
    std::map<NodeId, int> chosen;
    std::map<NodeId, std::vector<int>> children;  // colours of those that have one already
    for (const NodeId id : scene.nodes()) {
        if (scene.node(id).joint == Node::Joint::No) continue;
        const NodeId parent = jointAbove(scene, id);
        std::vector<int> relatives;
        if (parent) {
            const std::vector<int>& siblings = children[parent];
            relatives.assign(siblings.end() - std::min(ptrdiff_t(siblings.size()), mostSiblings), siblings.end());
            relatives.push_back(chosen.at(parent));
            if (const NodeId grand = jointAbove(scene, parent)) relatives.push_back(chosen.at(grand));
        }
        chosen[id] = firstApart(differences, relatives);
        children[parent].push_back(chosen[id]);
    }
    std::map<NodeId, glm::vec3> colors;
    for (const auto& [id, i] : chosen) colors[id] = categoryColor(i);
    return colors;
}

void addBones(Frame& frame, const Scene& scene, const std::map<NodeId, glm::dmat4>& worlds)
{
    const std::set<NodeId> hidden = hiddenNodes(scene);
    const std::map<NodeId, glm::vec3> colors = boneColors(scene);
    std::map<NodeId, glm::dvec3> along;  // of the bone that ends at a joint
    std::set<NodeId> continued;
    for (const NodeId id : scene.nodes()) {
        const NodeId parent = scene.node(id).joint == Node::Joint::No ? NodeId{} : jointAbove(scene, id);
        if (!parent || hidden.count(id)) continue;
        const glm::dvec3 head = placeOf(worlds, parent), tail = placeOf(worlds, id);
        continued.insert(parent);
        along[id] = tail - head;
        frame.bones.push_back({parent, glm::vec3(head), glm::vec3(tail), glm::vec4(colors.at(parent), 1)});
    }
    for (const auto& [id, color] : colors) {
        if (continued.count(id) || hidden.count(id) || scene.node(id).joint != Node::Joint::Joint) continue;
        const auto before = along.find(id);
        const glm::dvec3 head = placeOf(worlds, id), tail = before == along.end() ? head : head + stubLength * before->second;
        frame.bones.push_back({id, glm::vec3(head), glm::vec3(tail), glm::vec4(color, 1)});
    }
}

NodeId jointAt(const Frame& frame, glm::ivec2 size, glm::dvec2 pixel)
{
    const glm::dmat4 clip = frame.camera.clipFromView(double(size.x) / size.y) * frame.camera.viewFromWorld();
    const auto project = [&](glm::vec3 p, glm::dvec2& out) {
        const glm::dvec4 c = clip * glm::dvec4(glm::dvec3(p), 1);
        if (c.w <= 0) return false;
        out = {0.5 * (c.x / c.w + 1) * size.x, 0.5 * (1 - c.y / c.w) * size.y};
        return true;
    };
    NodeId joint, bone;
    double nearestJoint = jointReach * frame.options.pixelRatio, nearestBone = boneReach * frame.options.pixelRatio;
    for (const DrawBone& b : frame.bones) {
        glm::dvec2 head, tail;
        if (!project(b.head, head) || !project(b.tail, tail)) continue;
        if (const double d = glm::distance(head, pixel); d < nearestJoint) joint = b.node, nearestJoint = d;
        const glm::dvec2 along = tail - head;
        const double t = std::clamp(glm::dot(pixel - head, along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
        if (const double d = glm::distance(head + t * along, pixel); d < nearestBone) bone = b.node, nearestBone = d;
    }
    return joint ? joint : bone;
}

}  // namespace mw
