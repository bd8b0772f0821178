// Sample scenes from a formula each: blossom, rock, dog, terrain.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/catalog/catalog.h"
#include "core/math/limb.h"
#include "core/math/random.h"
#include "core/mesh/surface_net.h"
#include "core/scene/samples.h"

namespace mw {

namespace {

using glm::dvec3;

Mesh sphere(int64_t subdivisions)
{
    return std::get<Mesh>(apply(operation("icosphere"), {}, {{"subdivisions", subdivisions}}));
}

/// Every vertex of a unit sphere moved along its radius to f(direction).
template <class F>
Mesh shaped(const Mesh& m, F f)
{
    Array<glm::vec3> p(m.vertexCount());
    for (size_t i = 0; i < p.size(); ++i) {
        const dvec3 d = glm::normalize(dvec3(m.positions()[i]));
        p[i] = glm::vec3(d * f(d));
    }
    return m.withPositions(Shared<glm::vec3>(std::move(p)));
}

Scene sceneWith(Mesh mesh, const char* name, const std::optional<Material>& material = {}, dvec3 at = dvec3(0))
{
    Scene scene;
    MeshObject object;
    object.name = name;
    object.base = std::move(mesh);
    if (material) object.materials.push_back(scene.add(*material));
    Node node;
    node.name = name;
    node.local.translation = at;
    node.mesh = scene.add(std::move(object));
    scene.add(std::move(node));
    return scene;
}

Material matt(const char* name, dvec3 color, double roughness)
{
    Material m;
    m.name = name;
    m.baseColor = glm::dvec4(color, 1);
    m.roughness = roughness;
    return m;
}

/// Waves of random direction and phase, each octave twice as fine and half as high: smooth, about -1 to 1, no lattice.
class Waves {
public:
    Waves(uint64_t seed, int octaves, double frequency)
    {
        Random random(seed);
        for (double height = 0.5; octaves > 0; --octaves, height *= 0.5, frequency *= 2)
            for (int i = 0; i < 5; ++i) {
                const dvec3 way = glm::normalize(dvec3(random.normal(), random.normal(), random.normal()));
                waves_.push_back({way * frequency * (0.7 + 0.6 * random.uniform()), 6.2832 * random.uniform(), height * 0.45});
            }
    }
    double operator()(const dvec3& p) const
    {
        double sum = 0;
        for (const Wave& w : waves_) sum += w.height * std::sin(glm::dot(w.way, p) + w.phase);
        return sum;
    }

private:
    struct Wave {
        dvec3 way;
        double phase, height;
    };
    std::vector<Wave> waves_;
};

/// Distance from the middle to the surface of a boulder: broken off along planes, their edges worn, rough.
class Boulder {
public:
    Boulder()
    {
        Random random(11);
        for (int i = 0; i < 26; ++i)
            planes_.push_back({glm::normalize(dvec3(random.normal(), random.normal(), random.normal())), 0.78 + 0.32 * random.uniform()});
    }
    double operator()(const dvec3& d) const
    {
        double wear = 0;  // a smooth minimum over the planes
        for (const auto& [normal, distance] : planes_)
            if (const double towards = glm::dot(normal, d); towards > 0.05) wear += std::pow(towards / distance, 24);
        const double body = std::pow(wear + 1e-4, -1.0 / 24);
        return 0.24 * body * (1 + 0.05 * rough_(d * body)) + 0.0016 * grain_(d);
    }

private:
    std::vector<std::pair<dvec3, double>> planes_;
    Waves rough_{5, 4, 3.5}, grain_{9, 3, 55};
};

/// Where the scanner saw nothing: the ground it stood on, and some pockets.
bool unseen(const dvec3& d, const Waves& ragged)
{
    static const std::pair<dvec3, double> pockets[] = {
        {{0.1, -1, 0.05}, 0.52}, {{0.85, -0.1, 0.5}, 0.13}, {{-0.6, 0.35, 0.72}, 0.09}, {{0.2, 0.72, -0.65}, 0.11}, {{-0.8, -0.35, -0.45}, 0.16}};
    for (const auto& [middle, reach] : pockets)
        if (std::acos(std::clamp(glm::dot(d, glm::normalize(middle)), -1.0, 1.0)) < reach * (1 + 0.35 * ragged(d))) return true;
    return false;
}

/// Lichen and stone, linear.
Attribute stoneColors(const Mesh& m)
{
    const Waves patches(21, 4, 4), speckle(23, 2, 60);
    Array<float> c;
    c.reserve(3 * m.vertexCount());
    for (const glm::vec3& p : m.positions()) {
        const dvec3 d = glm::normalize(dvec3(p));
        const double lichen = std::clamp(4 * (patches(d) + 0.35 * d.y - 0.25), 0.0, 1.0), light = 1 + 0.16 * speckle(d) + 0.12 * patches(2.3 * d);
        const dvec3 color = glm::mix(dvec3(0.34, 0.32, 0.29), dvec3(0.40, 0.42, 0.20), lichen) * light;
        for (int i = 0; i < 3; ++i) c.push_back(float(std::clamp(color[i], 0.0, 1.0)));
    }
    return floatAttribute(std::string(names::color), Domain::Vertex, 3, std::move(c));
}

/// The left half, in metres; it looks along +Z.
const Limb dog[] = {
    // trunk and neck
    {{0, 0.415, 0.150}, {0, 0.440, 0.020}, 0.098, 0.084},
    {{0, 0.440, 0.020}, {0, 0.452, -0.190}, 0.084, 0.078},
    {{0, 0.462, 0.170}, {0, 0.575, 0.285}, 0.076, 0.054},
    // skull, cheek, snout, nose, ear
    {{0, 0.612, 0.305}, {0, 0.606, 0.345}, 0.060, 0.052},
    {{0.020, 0.585, 0.335}, {0.012, 0.580, 0.375}, 0.040, 0.032},
    {{0, 0.588, 0.370}, {0, 0.573, 0.455}, 0.037, 0.026},
    {{0, 0.584, 0.462}, {0, 0.582, 0.466}, 0.012, 0.012},
    {{0.036, 0.648, 0.288}, {0.052, 0.712, 0.278}, 0.026, 0.012, {1, 1, 0.75}},
    // foreleg and paw
    {{0.060, 0.400, 0.150}, {0.074, 0.300, 0.125}, 0.060, 0.042},
    {{0.074, 0.300, 0.125}, {0.074, 0.175, 0.140}, 0.039, 0.025},
    {{0.074, 0.175, 0.140}, {0.074, 0.045, 0.138}, 0.025, 0.021},
    {{0.074, 0.028, 0.142}, {0.075, 0.024, 0.186}, 0.029, 0.024},
    // hind leg and paw
    {{0.054, 0.425, -0.190}, {0.080, 0.300, -0.150}, 0.076, 0.052},
    {{0.080, 0.300, -0.150}, {0.080, 0.170, -0.235}, 0.043, 0.025},
    {{0.080, 0.170, -0.235}, {0.080, 0.045, -0.210}, 0.024, 0.020},
    {{0.080, 0.030, -0.200}, {0.081, 0.024, -0.160}, 0.029, 0.024},
    // tail
    {{0, 0.492, -0.245}, {0, 0.520, -0.345}, 0.028, 0.024},
    {{0, 0.520, -0.345}, {0, 0.620, -0.420}, 0.027, 0.017},
};

std::vector<double> evenLines(double from, double to, double step)
{
    std::vector<double> at;
    const int n = int(std::lround((to - from) / step));
    for (int i = 0; i <= n; ++i) at.push_back(from + (to - from) * i / n);
    return at;
}

std::vector<double> mirroredLines(double to, double step)
{
    const std::vector<double> half = evenLines(0, to, step);
    std::vector<double> at;
    for (size_t i = half.size() - 1; i > 0; --i) at.push_back(-half[i]);
    at.insert(at.end(), half.begin(), half.end());
    return at;
}

}  // namespace

Scene blossomScene()
{
    Mesh star =
        shaped(sphere(2), [](dvec3 d) { return 1.0 + 0.32 * std::cos(5 * std::atan2(d.z, d.x)) * (1 - d.y * d.y) + 0.12 * std::sin(9 * d.y); });
    Scene scene = sceneWith(std::move(star), "Blossom");
    const MeshId id = scene.meshes().front();
    MeshObject object = *scene.find(id);
    object.stack.push_back({scene.newModifierId(), "subdivide-loop", {{"levels", int64_t(2)}}, true});
    scene.set(id, std::move(object));
    return scene;
}

Scene rockScene()
{
    const Mesh whole = shaped(sphere(6), Boulder());
    const Waves ragged(31, 3, 9);
    Array<uint32_t> seen;
    for (size_t f = 0; f < whole.faceCount(); ++f) {
        const auto v = whole.face(f);
        const dvec3 middle = dvec3(whole.positions()[v[0]]) + dvec3(whole.positions()[v[1]]) + dvec3(whole.positions()[v[2]]);
        if (!unseen(glm::normalize(middle), ragged)) seen.insert(seen.end(), v.begin(), v.end());
    }
    Mesh scan = Mesh::triangles(whole.positions(), std::move(seen)).with(stoneColors(whole));
    return sceneWith(std::move(scan), "Rock", matt("Stone", dvec3(1), 0.9), {0, 0.2, 0});
}

Scene quadrupedScene()
{
    const auto field = [](const dvec3& p) {
        const double body = blendedDistance(dog, {std::abs(p.x), p.y, p.z}, 0.012);
        return std::max(body, -p.y);  // it stands on flat soles
    };
    Mesh body = mirroredSurfaceNet({mirroredLines(0.150, 0.0115), evenLines(-0.020, 0.760, 0.0115), evenLines(-0.500, 0.510, 0.0115)}, field);
    return sceneWith(std::move(body), "Dog", matt("Fur", {0.46, 0.26, 0.12}, 0.75));
}

Scene terrainScene()
{
    const Operation& source = operation("diamond-square");
    TerrainObject object;
    object.sourceOperation = source.id;
    object.sourceValues = checked(source.parameters, {{"size", int64_t(513)}, {"seed", int64_t(7)}});
    object.terrain.name = "Terrain";
    object.terrain.map = std::get<HeightMap>(apply(source, {}, object.sourceValues));
    object.terrain.extent = 600;
    object.terrain.maximumHeight = 110;
    object.terrain.waterLevel = 46;
    object.terrain.layers = {.sandTo = 0.44, .grassTo = 0.66, .snowFrom = 0.8, .rockSlope = 34};
    Scene scene;
    Node node;
    node.name = "Terrain";
    node.terrain = scene.add(std::move(object));
    scene.add(std::move(node));
    return scene;
}

}  // namespace mw
