#include "render/turntable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "render/posing.h"

namespace mw {
namespace {

/// Everything turned about an upright axis: how far it reaches at each height.
class Profile {
public:
    explicit Profile(const Bounds& b) : bounds_(b) {}
    void add(const glm::dvec3& p)
    {
        const double share = (p.y - bounds_.min.y) / std::max(bounds_.max.y - bounds_.min.y, 1e-300);
        Ring& r = rings_[size_t(std::clamp(share, 0.0, 1.0) * double(rings_.size() - 1))];
        const glm::dvec3 c = bounds_.centre();
        r.radius = std::max(r.radius, std::hypot(p.x - c.x, p.z - c.z));
        r.low = std::min(r.low, p.y);
        r.high = std::max(r.high, p.y);
    }
    void addTo(CameraFit& fit) const
    {
        const glm::dvec3 c = bounds_.centre();
        for (const Ring& r : rings_) {
            if (r.radius < 0) continue;
            for (int k = 0; k < sides; ++k) {
                const double a = 2 * std::numbers::pi * k / sides;
                for (const double y : {r.low, r.high}) fit.add({c.x + r.radius * std::cos(a), y, c.z + r.radius * std::sin(a)});
            }
        }
    }

private:
    struct Ring {
        double radius = -1, low = 1e300, high = -1e300;
    };
    static constexpr int sides = 48;
    Bounds bounds_;
    std::array<Ring, 64> rings_{};
};

void addCorners(Profile& p, const Bounds& b, const glm::dmat4& worldFromLocal)
{
    for (int i = 0; i < 8 && !b.empty; ++i)
        p.add(glm::dvec3(worldFromLocal * glm::dvec4(i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z, 1)));
}

}  // namespace

void frameTurntable(Frame& frame, double aspect)
{
    const Bounds bounds = boundsOf(frame);
    if (bounds.empty) return;
    Profile profile(bounds);
    for (const DrawObject& o : frame.objects) {
        const Mesh mesh = o.pose ? posed(o.mesh, *o.pose) : o.mesh;
        for (const glm::vec3& p : mesh.positions()) profile.add(glm::dvec3(o.worldFromLocal * glm::dvec4(glm::dvec3(p), 1)));
    }
    for (const DrawBone& b : frame.bones) {
        profile.add(glm::dvec3(b.head));
        profile.add(glm::dvec3(b.tail));
    }
    for (const DrawTerrain& t : frame.terrains) addCorners(profile, boundsOf(t.terrain), t.worldFromLocal);
    CameraFit fit(frame.camera, aspect);
    profile.addTo(fit);
    fit.apply(frame.camera);
    const glm::dvec3 c = bounds.centre();
    const glm::dvec3 eye = frame.camera.eye();
    const glm::dvec3 forward = glm::normalize(frame.camera.target - eye);
    const glm::dvec2 flat(forward.x, forward.z);
    if (glm::dot(flat, flat) > 1e-6) {
        // The target moves along the line of sight to the axis, so that the camera turns about it and not about a place before or behind.
        const double along = glm::dot(glm::dvec2(c.x - eye.x, c.z - eye.z), flat) / glm::dot(flat, flat);
        frame.camera.target = eye + along * forward;
        frame.camera.target.x = c.x;
        frame.camera.target.z = c.z;
        if (frame.camera.perspective) frame.camera.distance = along;
    }
    frame.camera.fitClip(bounds);
}

void turn(Frame& frame, const Camera& first, double firstTurn, int i, int count)
{
    const double angle = 2 * std::numbers::pi * i / std::max(count, 1);
    frame.camera = first;
    frame.camera.azimuth += angle;
    frame.options.environmentTurn = firstTurn + angle;
}

}  // namespace mw
