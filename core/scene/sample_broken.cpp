// A pear with one of each defect, so that the worklist has something to list.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "core/catalog/catalog.h"
#include "core/scene/samples.h"

namespace mw {

namespace {

using glm::dvec3;

struct Faces {
    Array<glm::vec3> positions;
    std::vector<std::array<uint32_t, 3>> faces;

    dvec3 middle(size_t f) const { return (dvec3(positions[faces[f][0]]) + dvec3(positions[faces[f][1]]) + dvec3(positions[faces[f][2]])) / 3.0; }
    uint32_t add(dvec3 p)
    {
        positions.push_back(glm::vec3(p));
        return uint32_t(positions.size() - 1);
    }
    /// All faces whose middle is within `reach` of a place.
    template <class F>
    void each(dvec3 place, double reach, F f)
    {
        for (size_t i = 0; i < faces.size(); ++i)
            if (glm::distance(middle(i), place) < reach) f(faces[i]);
    }
    void addTetrahedron(uint32_t apex, dvec3 at, double size)
    {
        const uint32_t a = add(at + dvec3(size, 0, 0)), b = add(at + dvec3(-size, 0, size)), c = add(at + dvec3(-size, 0, -size));
        const bool above = positions[apex].y > at.y;
        for (auto [i, j, k] : {std::array{apex, b, a}, {apex, c, b}, {apex, a, c}, {a, b, c}}) faces.push_back({i, above ? j : k, above ? k : j});
    }
};

Faces pear(int64_t subdivisions, double size, dvec3 at)
{
    const Mesh ball = std::get<Mesh>(apply(operation("icosphere"), {}, {{"subdivisions", subdivisions}}));
    Faces out;
    for (const glm::vec3& p : ball.positions()) {
        const double waist = 1 - 0.35 / (1 + std::exp(-6 * (double(p.y) - 0.25)));
        out.add(at + size * dvec3(p.x * waist, p.y * 1.25, p.z * waist));
    }
    for (size_t f = 0; f < ball.faceCount(); ++f) out.faces.push_back({ball.face(f)[0], ball.face(f)[1], ball.face(f)[2]});
    return out;
}

/// Two openings, as a scanner leaves them.
void punch(Faces& m)
{
    std::vector<std::array<uint32_t, 3>> kept;
    for (size_t f = 0; f < m.faces.size(); ++f)
        if (glm::distance(m.middle(f), dvec3(0.05, 0.22, 0.2)) > 0.09 && glm::distance(m.middle(f), dvec3(-0.2, 0.1, 0.02)) > 0.05)
            kept.push_back(m.faces[f]);
    m.faces = std::move(kept);
}

/// A strip of faces gets vertices of its own at the same places: a seam that cannot be seen.
void tear(Faces& m)
{
    std::map<uint32_t, uint32_t> copies;
    m.each({0.15, 0.48, 0.0}, 0.06, [&](std::array<uint32_t, 3>& face) {
        for (uint32_t& v : face) {
            const auto [at, isNew] = copies.emplace(v, uint32_t(m.positions.size()));
            if (isNew) m.positions.push_back(m.positions[v]);
            v = at->second;
        }
    });
}

}  // namespace

Scene brokenScene()
{
    Faces m = pear(4, 0.25, {0, 0.32, 0});
    punch(m);
    tear(m);
    m.each({0.2, 0.3, -0.1}, 0.06, [](std::array<uint32_t, 3>& f) { std::swap(f[1], f[2]); });  // turned inside out
    const std::vector<std::array<uint32_t, 3>> first(m.faces.begin(), m.faces.begin() + 400);
    for (size_t f = 100; f < 104; ++f) m.faces.push_back(first[f]);                                 // twice
    for (size_t f = 200; f < 203; ++f) m.faces.push_back({first[f][0], first[f][1], first[f][1]});  // no area
    for (size_t f = 300; f < 303; ++f) {                                                            // a third face on an edge
        const dvec3 a = dvec3(m.positions[first[f][0]]), out = glm::normalize(a - dvec3(0, 0.3, 0));
        const uint32_t tip = m.add(a + 0.06 * out);
        m.faces.push_back({first[f][0], first[f][1], tip});
    }
    m.addTetrahedron(0, dvec3(m.positions[0]) + dvec3(0, m.positions[0].y > 0.3f ? 0.05 : -0.05, 0), 0.02);  // joined by one vertex alone
    m.addTetrahedron(m.add({0.36, 0.404, 0.05}), {0.36, 0.4, 0.05}, 0.003);                                  // crumbs
    m.addTetrahedron(m.add({-0.33, 0.194, 0.1}), {-0.33, 0.19, 0.1}, 0.002);
    for (int i = 0; i < 12; ++i) m.add({0.3 * std::cos(0.5 * i), 0.02 + 0.05 * i, 0.3 * std::sin(0.5 * i)});  // used by nobody
    const Faces stem = pear(2, 0.05, {0.02, 0.63, 0});                                                        // stuck into the top
    const uint32_t base = uint32_t(m.positions.size());
    m.positions.insert(m.positions.end(), stem.positions.begin(), stem.positions.end());
    for (const auto& f : stem.faces) m.faces.push_back({f[0] + base, f[1] + base, f[2] + base});
    Array<uint32_t> indices;
    for (const auto& f : m.faces) indices.insert(indices.end(), f.begin(), f.end());
    Scene scene;
    MeshObject object;
    object.name = "Pear";
    object.base = Mesh::triangles(std::move(m.positions), std::move(indices));
    Node node;
    node.name = "Pear";
    node.mesh = scene.add(std::move(object));
    scene.add(std::move(node));
    return scene;
}

}  // namespace mw
