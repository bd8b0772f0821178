// Meshes and measures that the tests of simplification and subdivision share.
#pragma once
#include <algorithm>
#include <fstream>
#include <glm/geometric.hpp>
#include <map>
#include <string>

#include "core/catalog/catalog.h"
#include "core/io/io.h"
#include "core/math/closest.h"
#include "core/mesh/mesh.h"
#include "tests/core/mesh/shapes.h"

namespace mw::test {

/// The first mesh of a file; OFF (faces of any size) is read here.
inline Mesh meshOf(const std::filesystem::path& file)
{
    if (file.extension() != ".off") {
        const Imported read = readFile(file);
        return read.scene.find(read.scene.meshes().front())->base;
    }
    std::ifstream in(file);
    std::string off;
    size_t vertices = 0, faces = 0, edges = 0;
    in >> off >> vertices >> faces >> edges;
    Polygons p;
    p.positions.resize(vertices);
    for (glm::vec3& v : p.positions) in >> v.x >> v.y >> v.z;
    for (size_t f = 0; f < faces; ++f) {
        size_t n = 0;
        in >> n;
        for (uint32_t v; n > 0 && in >> v; --n) p.corners.push_back(v);
        p.start.push_back(uint32_t(p.corners.size()));
    }
    return p.mesh();
}

inline Mesh applied(const char* id, const Mesh& mesh, const char* parameters)
{
    const Operation& op = operation(id);
    return std::get<Mesh>(apply(op, mesh, parsed(op.parameters, parameters)));
}

/// Largest distance of the vertices of `from` to the triangles of `to`, by looking at all pairs.
inline double farthest(const Mesh& from, const Mesh& to)
{
    double worst = 0;
    const auto corners = to.triangulation().vertices;
    for (const glm::vec3& q : from.positions()) {
        double best = 1e300;
        for (size_t t = 0; t < corners.size(); t += 3) {
            const glm::dvec3 a = to.positions()[corners[t]], b = to.positions()[corners[t + 1]], c = to.positions()[corners[t + 2]], p = q;
            const glm::dvec3 w = closestOnTriangle(p, a, b, c), gap = w[0] * a + w[1] * b + w[2] * c - p;
            best = std::min(best, glm::dot(gap, gap));
        }
        worst = std::max(worst, best);
    }
    return std::sqrt(worst);
}

/// Edges whose two faces lie on each other (normals over 90 degrees apart).
inline size_t folds(const Mesh& m)
{
    std::map<std::pair<uint32_t, uint32_t>, std::vector<glm::dvec3>> normals;
    for (size_t f = 0; f < m.faceCount(); ++f) {
        const auto c = m.face(f);
        const glm::dvec3 a = m.positions()[c[0]], n = glm::cross(glm::dvec3(m.positions()[c[1]]) - a, glm::dvec3(m.positions()[c[2]]) - a);
        for (size_t k = 0; k < 3; ++k) normals[std::minmax(c[k], c[(k + 1) % 3])].push_back(n);
    }
    size_t count = 0;
    for (const auto& [edge, n] : normals) count += n.size() == 2 && glm::dot(n[0], n[1]) < -1e-4 * glm::length(n[0]) * glm::length(n[1]);
    return count;
}

}  // namespace mw::test
