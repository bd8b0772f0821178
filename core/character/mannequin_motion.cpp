// Gait from curves of the phase: where each foot is and how it rolls is given, so that a standing foot moves with the ground and does not
// slide; hips bob, sway and turn; legs follow by two-bone inverse kinematics; arms and trunk swing against the legs.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <span>

#include "core/character/mannequin.h"
#include "core/math/rotations.h"

namespace mw {

namespace {

using glm::dquat;
using glm::dvec3;

constexpr double pi = 3.14159265358979323846;

double radians(double degrees)
{
    return degrees * pi / 180;
}
dquat turn(double x, double y, double z)  // degrees, y after x after z
{
    return aboutAxis(1, radians(y)) * aboutAxis(0, radians(x)) * aboutAxis(2, radians(z));
}
double wave(double phase)
{
    return std::cos(2 * pi * phase);
}
double smooth(double u)
{
    u = std::clamp(u, 0.0, 1.0);
    return u * u * (3 - 2 * u);
}

using Keys = std::span<const std::array<double, 2>>;

/// Through points over one period without overshoot (Fritsch and Carlson 1980): what is level stays level.
double curve(Keys keys, double phase)
{
    const size_t n = keys.size() - 1;  // the last one repeats the first
    const auto slope = [&](size_t i) { return (keys[i + 1][1] - keys[i][1]) / (keys[i + 1][0] - keys[i][0]); };
    const auto tangent = [&](size_t i) {
        const double before = slope((i + n - 1) % n), after = slope(i % n);
        return before * after <= 0 ? 0 : 2 * before * after / (before + after);
    };
    size_t i = 0;
    while (i + 1 < n && phase >= keys[i + 1][0]) ++i;
    const double h = keys[i + 1][0] - keys[i][0], u = (phase - keys[i][0]) / h, v = 1 - u;
    return keys[i][1] * (1 + 2 * u) * v * v + keys[i + 1][1] * u * u * (3 - 2 * u) + h * (tangent(i) * u * v * v - tangent(i + 1) * u * u * v);
}

/// Joints of the skeleton by what they are.
struct Names {
    explicit Names(const Skeleton& s)
    {
        const auto find = [&](const std::string& name) {
            for (uint32_t i = 0; i < s.joints.size(); ++i)
                if (s.joints[i].name == name) return i;
            return none;
        };
        hips = find("Hips"), spine = find("Spine"), chest = find("Chest"), neck = find("Neck"), head = find("Head");
        for (size_t side = 0; side < 2; ++side) {
            const std::string l = side == 0 ? "Left" : "Right";
            shoulder[side] = find(l + "Shoulder"), upperArm[side] = find(l + "UpperArm"), lowerArm[side] = find(l + "LowerArm"),
            hand[side] = find(l + "Hand");
            upperLeg[side] = find(l + "UpperLeg"), lowerLeg[side] = find(l + "LowerLeg"), foot[side] = find(l + "Foot"),
            toes[side] = find(l + "Toes");
        }
    }
    uint32_t hips, spine, chest, neck, head;
    std::array<uint32_t, 2> shoulder, upperArm, lowerArm, hand, upperLeg, lowerLeg, foot, toes;
};

struct Frame {
    dvec3 hips;
    std::vector<dquat> rotations;
};

/// Where a foot is: the ankle, how far the heel is raised (toes raised when negative), and how far the toes are bent up; degrees.
struct Foot {
    dvec3 ankle;
    double pitch = 0, toes = 0;
};

class Mover {
public:
    Mover(const Skeleton& skeleton, const Mesh& body);
    MannequinMotion walk() const;
    MannequinMotion idle() const;

private:
    Frame frame(const dvec3& hips) const;
    Foot stanceFoot(size_t side, double phase) const;
    Foot walkFoot(size_t side, double phase) const;
    Frame walkFrame(double phase) const;
    Frame idleFrame(double phase) const;
    void poseArm(Frame& f, size_t side, double lowered, double swing, double elbow) const;
    void poseLeg(Frame& f, size_t side, const Foot& foot) const;
    double lowest(const Frame& f) const;
    MannequinMotion motion(std::string name, double seconds, int frames, Frame (Mover::*at)(double) const) const;

    const Skeleton& skeleton_;
    Names names_;
    std::vector<dvec3> rest_;  // of joints, world
    struct SoleVertex {
        dvec3 at;
        std::vector<std::pair<uint32_t, double>> weights;
    };
    std::vector<SoleVertex> soles_;
};

Mover::Mover(const Skeleton& skeleton, const Mesh& body) : skeleton_(skeleton), names_(skeleton)
{
    for (const Joint& j : skeleton.joints) rest_.push_back((j.parent == none ? dvec3(0) : rest_[j.parent]) + j.rest.translation);
    const Attribute *joints = body.find(names::joints), *weights = body.find(names::weights);
    for (size_t v = 0; v < body.vertexCount(); ++v) {
        if (body.positions()[v].y > 0.06f) continue;
        SoleVertex s{dvec3(body.positions()[v]), {}};
        for (int k = 0; k < weights->components; ++k)
            if (weights->at(v, k) > 0) s.weights.emplace_back(uint32_t(joints->at(v, k)), weights->at(v, k));
        soles_.push_back(std::move(s));
    }
}

Frame Mover::frame(const dvec3& hips) const
{
    return {hips, std::vector<dquat>(skeleton_.joints.size(), dquat(1, 0, 0, 0))};
}

// The arm hangs: from the rest, half lowered, by `lowered` degrees more; swing is forwards.
void Mover::poseArm(Frame& f, size_t side, double lowered, double swing, double elbow) const
{
    const double sign = side == 0 ? 1 : -1;
    f.rotations[names_.shoulder[side]] = turn(0, -sign * swing * 0.12, -sign * 3);
    f.rotations[names_.upperArm[side]] = turn(-swing, 0, -sign * (lowered - 3));
    const dvec3 along = glm::normalize(rest_[names_.lowerArm[side]] - rest_[names_.upperArm[side]]);
    f.rotations[names_.lowerArm[side]] = glm::angleAxis(radians(elbow), glm::normalize(glm::cross(along, dvec3(0, 0, 1))));
    f.rotations[names_.hand[side]] = turn(0, 0, -sign * 4);
}

// Two bones: the knee bends as far as the distance asks, then the leg is turned to where the ankle is wanted.
void Mover::poseLeg(Frame& f, size_t side, const Foot& foot) const
{
    const uint32_t upper = names_.upperLeg[side], lower = names_.lowerLeg[side], ankle = names_.foot[side];
    const dvec3 thigh = rest_[lower] - rest_[upper], shin = rest_[ankle] - rest_[lower];
    const dquat hips = f.rotations[names_.hips];
    const dvec3 joint = f.hips + hips * (rest_[upper] - rest_[names_.hips]);
    const dvec3 wanted = glm::conjugate(hips) * (foot.ankle - joint);
    const double a = glm::length(thigh), b = glm::length(shin), d = std::min(glm::length(wanted), (a + b) * 0.9995);
    const double bend = pi - std::acos(std::clamp((a * a + b * b - d * d) / (2 * a * b), -1.0, 1.0));
    const dvec3 down = glm::normalize(thigh), axis = glm::normalize(dvec3(1, 0, 0) - down.x * down);
    f.rotations[lower] = glm::angleAxis(bend, axis);
    const dvec3 from = glm::normalize(thigh + f.rotations[lower] * shin), to = glm::normalize(wanted);
    f.rotations[upper] = glm::normalize(dquat(1 + glm::dot(from, to), glm::cross(from, to)));
    f.rotations[ankle] = glm::conjugate(hips * f.rotations[upper] * f.rotations[lower]) * turn(foot.pitch, 0, 0);
    f.rotations[names_.toes[side]] = turn(-foot.toes, 0, 0);
}

// Of the walk. Phase 0 is where the heel touches the ground; lift is when the toes leave it.
constexpr double period = 1.1, lift = 0.62, under = 0.29, heelRadius = 0.034;
constexpr std::array<double, 2> pitchKeys[] = {{0, -19},   {0.05, -9}, {0.10, 0},  {0.34, 0}, {0.44, 8},   {0.53, 26},
                                               {0.62, 52}, {0.68, 58}, {0.77, 34}, {0.87, 2}, {0.95, -16}, {1, -19}};

/// Rolls over the heel, stands, rolls over the ball; the ground carries it backwards at the speed of the walk.
Foot Mover::stanceFoot(size_t side, double phase) const
{
    const dvec3 ankle = rest_[names_.foot[side]], ball = rest_[names_.toes[side]], heel(ankle.x, heelRadius, ankle.z - 0.04);
    Foot f;
    f.pitch = curve(pitchKeys, phase);
    const bool overHeel = f.pitch < 0;
    const dvec3 pivot = overHeel ? heel : ball;
    f.ankle = pivot + aboutAxis(0, radians(f.pitch)) * (ankle - pivot);
    f.ankle.z += mannequinWalkSpeed * period * (under - phase) + (overHeel ? heelRadius * radians(f.pitch) : 0);
    f.toes = std::max(f.pitch, 0.0);
    return f;
}

Foot Mover::walkFoot(size_t side, double phase) const
{
    phase -= std::floor(phase);
    if (phase <= lift) return stanceFoot(side, phase);
    // Through the air: on from how it left the ground to how it will come down.
    constexpr double h = 1e-4;
    const Foot leaves = stanceFoot(side, lift), lands = stanceFoot(side, 0);
    const dvec3 leaving = (leaves.ankle - stanceFoot(side, lift - h).ankle) / h, landing = (stanceFoot(side, h).ankle - lands.ankle) / h;
    const double length = 1 - lift, u = (phase - lift) / length, v = 1 - u;
    Foot f;
    f.pitch = curve(pitchKeys, phase);
    f.toes = leaves.toes * (1 - smooth(u / 0.35));
    f.ankle = leaves.ankle * ((1 + 2 * u) * v * v) + lands.ankle * (u * u * (3 - 2 * u)) + length * (leaving * (u * v * v) - landing * (u * u * v));
    f.ankle.y += 0.045 * 6.75 * u * v * v;
    return f;
}

Frame Mover::walkFrame(double phase) const
{
    const double swing = wave(phase), over = wave(phase - 0.31);  // the left leg is in front; the weight is on the left leg
    Frame f = frame(rest_[names_.hips] + dvec3(0.016 * over, -0.024 - 0.015 * wave(2 * (phase - 0.05)), 0));
    f.rotations[names_.hips] = turn(1.5, -6 * swing, 2.5 * over);
    f.rotations[names_.spine] = turn(1, 4 * swing, -2 * over);
    f.rotations[names_.chest] = turn(-2.5 + 0.8 * wave(2 * phase), 7 * swing, -1.5 * over);
    f.rotations[names_.neck] = turn(1, -2.5 * swing, 0.5 * over);
    f.rotations[names_.head] = turn(-1 - 0.8 * wave(2 * phase), -2.5 * swing, 0.5 * over);
    for (size_t side = 0; side < 2; ++side) {
        const double arm = -wave(phase - 0.03 + (side ? 0.5 : 0));  // against the leg of its side
        poseArm(f, side, 36, 2 + 19 * arm, 19 + 9 * arm);
        poseLeg(f, side, walkFoot(side, phase + (side ? 0.5 : 0)));
    }
    return f;
}

Frame Mover::idleFrame(double phase) const
{
    const double breath = 0.5 - 0.5 * wave(phase), sway = std::sin(2 * pi * phase);
    Frame f = frame(rest_[names_.hips] + dvec3(0.006 * sway, -0.008 - 0.002 * breath, 0));
    f.rotations[names_.hips] = turn(1, 0.8 * sway, 0.5 * sway);
    f.rotations[names_.spine] = turn(1 - 1.2 * breath, -0.5 * sway, -0.7 * sway);
    f.rotations[names_.chest] = turn(0.5 - 1.8 * breath, -0.5 * sway, 0);
    f.rotations[names_.neck] = turn(0.5 + 1.5 * breath, 1.0 * sway, 0);
    f.rotations[names_.head] = turn(0.5 + 1.0 * breath, 1.5 * sway, 0.3 * sway);
    for (size_t side = 0; side < 2; ++side) {
        poseArm(f, side, 33 - 1.5 * breath, 2 + 0.8 * breath, 14 + 1.5 * breath);
        poseLeg(f, side, {rest_[names_.foot[side]], 0, 0});
    }
    return f;
}

double Mover::lowest(const Frame& f) const
{
    std::vector<dquat> turned(f.rotations.size());
    std::vector<dvec3> at(f.rotations.size());
    for (size_t j = 0; j < turned.size(); ++j) {
        const uint32_t parent = skeleton_.joints[j].parent;
        turned[j] = parent == none ? f.rotations[j] : turned[parent] * f.rotations[j];
        at[j] = parent == none ? f.hips : at[parent] + turned[parent] * skeleton_.joints[j].rest.translation;
    }
    double y = 1e9;
    for (const SoleVertex& s : soles_) {
        double here = 0;
        for (const auto& [joint, weight] : s.weights) here += weight * (at[joint] + turned[joint] * (s.at - rest_[joint])).y;
        y = std::min(y, here);
    }
    return y;
}

MannequinMotion Mover::motion(std::string name, double seconds, int frames, Frame (Mover::*at)(double) const) const
{
    MannequinMotion m{std::move(name), {}, {}, std::vector<std::vector<dquat>>(skeleton_.joints.size())};
    for (int i = 0; i <= frames; ++i) {
        Frame f = (this->*at)(i == frames ? 0.0 : double(i) / frames);
        f.hips.y -= lowest(f);  // to the ground
        m.times.push_back(seconds * i / frames);
        m.hips.push_back(f.hips);
        for (size_t j = 0; j < f.rotations.size(); ++j) m.rotations[j].push_back(f.rotations[j]);
    }
    for (size_t j = 0; j < m.rotations.size(); ++j)
        if (skeleton_.joints[j].end) m.rotations[j].clear();
    return m;
}

MannequinMotion Mover::walk() const
{
    return motion("Walk", period, 66, &Mover::walkFrame);
}
MannequinMotion Mover::idle() const
{
    return motion("Idle", 4, 80, &Mover::idleFrame);
}

}  // namespace

std::vector<MannequinMotion> mannequinMotions(const Skeleton& skeleton, const Mesh& body)
{
    const Mover mover(skeleton, body);
    return {mover.walk(), mover.idle()};
}

}  // namespace mw
