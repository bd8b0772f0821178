#include "ui/samples.h"

#include <cmath>

#include "core/io/io.h"
#include "core/scene/samples.h"

namespace mw {
namespace {

Mesh sphere(int64_t subdivisions)
{
    return std::get<Mesh>(apply(operation("icosphere"), {}, {{"subdivisions", subdivisions}}));
}

// Every vertex of the sphere moved along its radius by f(direction).
template <class F>
Mesh shaped(const Mesh& m, F f)
{
    Array<glm::vec3> p(m.vertexCount());
    for (size_t i = 0; i < p.size(); ++i) {
        const glm::dvec3 d = glm::normalize(glm::dvec3(m.positions()[i]));
        p[i] = glm::vec3(d * f(d));
    }
    return m.withPositions(Shared<glm::vec3>(std::move(p)));
}

Scene sceneWith(Mesh mesh, const char* name, std::vector<Modifier> stack)
{
    Scene scene = sceneOf(std::move(mesh), name);
    const MeshId id = scene.meshes().front();
    MeshObject object = *scene.find(id);
    for (Modifier& m : stack) {
        if (!findOperation(m.operation)) continue;
        m.id = scene.newModifierId();
        object.stack.push_back(std::move(m));
    }
    scene.set(id, std::move(object));
    return scene;
}

// A coarse star: Loop subdivision rounds it.
Scene blossom()
{
    Mesh star =
        shaped(sphere(2), [](glm::dvec3 d) { return 1.0 + 0.32 * std::cos(5 * std::atan2(d.z, d.x)) * (1 - d.y * d.y) + 0.12 * std::sin(9 * d.y); });
    return sceneWith(std::move(star), "Blossom", {{{}, "subdivide-loop", {{"levels", int64_t(2)}}, true}});
}

// A finely meshed pebble with folds: something to simplify.
Scene pebble()
{
    Mesh m = shaped(sphere(6), [](glm::dvec3 d) {
        double r = 1, amplitude = 0.16, frequency = 2.3;
        for (int octave = 0; octave < 5; ++octave, amplitude *= 0.5, frequency *= 1.9)
            r += amplitude * std::sin(frequency * d.x + 1.3 * octave) * std::sin(frequency * d.y - 0.7 * octave) * std::cos(frequency * d.z + octave);
        return r;
    });
    return sceneWith(std::move(m), "Pebble", {{{}, "decimate-quadric", {{"ratio", 0.1}}, true}});
}

Scene icosphere()
{
    return sceneWith(sphere(3), "Icosphere", {});
}

Scene mannequin()
{
    return sampleScene("mannequin");
}

}  // namespace

const std::vector<Sample>& samples()
{
    static const std::vector<Sample> all{
        {"blossom", "Blossom", "A coarse star, rounded by Loop subdivision", blossom},
        {"pebble", "Pebble", "81,920 faces with fine folds, simplified to a tenth", pebble},
        {"mannequin", "Mannequin", "A figure with skeleton and skin that walks and breathes", mannequin},
        {"icosphere", "Icosphere", "A plain sphere of 1,280 triangles", icosphere},
    };
    return all;
}

}  // namespace mw
