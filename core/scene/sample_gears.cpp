// Toothed wheels of quads: a plate with a bore and a window between any two spokes, so the genus is one more than the number of spokes.
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <numbers>
#include <tuple>

#include "core/scene/samples.h"

namespace mw {

namespace {

/// Radii in metres; the pitch circle of `teeth` teeth of one module.
struct Wheel {
    int teeth, spokes;
    double bore, hub, thickness;
};

constexpr double module = 0.02;
constexpr int stepsPerTooth = 6;

double pitchRadius(const Wheel& w)
{
    return 0.5 * module * w.teeth;
}

/// Root, flank, tip, flank: the outline over one tooth, as a share of the tooth's height.
double outline(int step)
{
    static constexpr double up[stepsPerTooth] = {0, 0, 0.55, 1, 1, 0.55};
    return up[step % stepsPerTooth];
}

/// Metal is cut: no face is rounded into the next.
Mesh withFlatNormals(const Mesh& m)
{
    Array<float> normals;
    for (size_t f = 0; f < m.faceCount(); ++f)
        for (size_t c = 0; c < m.face(f).size(); ++c)
            for (int i = 0; i < 3; ++i) normals.push_back(m.faceNormals()[f][i]);
    return m.with(floatAttribute(std::string(names::normal), Domain::Corner, 3, std::move(normals)));
}

/// The plate seen from above as a grid of angle steps and rings (bore, hub, rim, root, outline); which of its cells are there.
class Plate {
public:
    explicit Plate(const Wheel& w) : wheel_(w), steps_(w.teeth * stepsPerTooth) {}

    Mesh mesh()
    {
        for (int s = 0; s < steps_; ++s)
            for (int r = 0; r < rings; ++r)
                if (filled(s, r)) addCell(s, r);
        Array<uint32_t> start{0u};
        for (size_t i = 4; i <= corners_.size(); i += 4) start.push_back(uint32_t(i));
        return withFlatNormals(Mesh(std::move(positions_), std::move(start), std::move(corners_)));
    }

private:
    static constexpr int rings = 4;  // hub, spokes, rim, teeth

    bool filled(int s, int r) const
    {
        if (r < 0 || r >= rings) return false;
        if (r != 1) return true;
        const int perSpoke = steps_ / wheel_.spokes, within = ((s % steps_) + steps_) % steps_ % perSpoke;
        return within < perSpoke / 3;
    }

    double radius(int s, int ring) const
    {
        const double root = pitchRadius(wheel_) - 1.25 * module, height = 2.25 * module;
        switch (ring) {
            case 0:
                return wheel_.bore;
            case 1:
                return wheel_.hub;
            case 2:
                return root - 1.3 * module;
            case 3:
                return root - 0.15 * module;
            default:
                return root + height * outline(s);
        }
    }

    uint32_t vertex(int s, int ring, bool top)
    {
        s = (s + steps_) % steps_;
        const auto [at, isNew] = known_.emplace(std::tuple(s, ring, top), uint32_t(positions_.size()));
        if (isNew) {
            const double angle = 2 * std::numbers::pi * s / steps_, r = radius(s, ring);
            positions_.push_back({float(r * std::cos(angle)), float(r * std::sin(angle)), float((top ? 0.5 : -0.5) * wheel_.thickness)});
        }
        return at->second;
    }

    void quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d) { corners_.insert(corners_.end(), {a, b, c, d}); }

    /// Top, bottom, and a wall to each side where there is nothing.
    void addCell(int s, int r)
    {
        const int n = s + 1, o = r + 1;
        quad(vertex(s, r, true), vertex(s, o, true), vertex(n, o, true), vertex(n, r, true));
        quad(vertex(s, r, false), vertex(n, r, false), vertex(n, o, false), vertex(s, o, false));
        const auto wall = [&](int s0, int r0, int s1, int r1) {
            quad(vertex(s0, r0, false), vertex(s1, r1, false), vertex(s1, r1, true), vertex(s0, r0, true));
        };
        if (!filled(s, r - 1)) wall(n, r, s, r);
        if (!filled(s, r + 1)) wall(s, o, n, o);
        if (!filled(s - 1, r)) wall(s, r, s, o);
        if (!filled(s + 1, r)) wall(n, o, n, r);
    }

    Wheel wheel_;
    int steps_;
    std::map<std::tuple<int, int, bool>, uint32_t> known_;
    Array<glm::vec3> positions_;
    Array<uint32_t> corners_;
};

void addWheel(Scene& scene, const char* name, const Wheel& wheel, glm::dvec2 at, double turnDegrees, glm::dvec3 color)
{
    Material metal;
    metal.name = name;
    metal.baseColor = glm::dvec4(color, 1);
    metal.metallic = 1;
    metal.roughness = 0.38;
    MeshObject object;
    object.name = name;
    object.base = Plate(wheel).mesh();
    object.materials.push_back(scene.add(std::move(metal)));
    Node node;
    node.name = name;
    node.local.translation = {at.x, at.y, 0};
    node.local.rotation = glm::angleAxis(glm::radians(turnDegrees), glm::dvec3(0, 0, 1));
    node.mesh = scene.add(std::move(object));
    scene.add(std::move(node));
}

}  // namespace

Scene gearsScene()
{
    const Wheel large{36, 6, 0.05, 0.11, 0.06}, middle{24, 4, 0.04, 0.08, 0.06}, small{20, 5, 0.035, 0.07, 0.06};
    // Wheels mesh when their pitch circles touch and a tooth of one meets a gap of the other.
    const double a = glm::radians(20.0), b = glm::radians(140.0);
    const double first = pitchRadius(large) + pitchRadius(middle), second = pitchRadius(large) + pitchRadius(small);
    const double tooth = 3.5 / stepsPerTooth;  // middle of a tooth, in teeth from the start
    const auto meshing = [&](double angle, const Wheel& other) {
        // The large wheel has phase p at this angle; the other must have p + half a tooth, counted the other way, at angle + 180 degrees.
        const double p = glm::degrees(angle) / 360 * large.teeth - tooth;
        const double phase = -(p + 0.5) + tooth;
        return glm::degrees(angle) + 180 - phase * 360 / other.teeth;
    };
    Scene scene;
    addWheel(scene, "Wheel", large, {0, 0.42}, 0, {0.78, 0.62, 0.34});
    addWheel(scene, "Pinion", middle, glm::dvec2(0, 0.42) + first * glm::dvec2(std::cos(a), std::sin(a)), meshing(a, middle), {0.62, 0.63, 0.65});
    addWheel(scene, "Idler", small, glm::dvec2(0, 0.42) + second * glm::dvec2(std::cos(b), std::sin(b)), meshing(b, small), {0.72, 0.45, 0.32});
    return scene;
}

}  // namespace mw
