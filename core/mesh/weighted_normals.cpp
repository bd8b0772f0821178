// Normals of vertices and corners as weighted sums over the faces around.
#include "core/mesh/weighted_normals.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/mesh/connectivity.h"
#include "core/mesh/normals.h"
#include "core/mesh/union_find.h"

namespace mw {

namespace {

double lengthOf(glm::dvec3 v)
{
    return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

glm::dvec3 unit(glm::dvec3 v)
{
    const double length = lengthOf(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

/// Body(corner, weighted normal) for all corners of faces that have an area.
template <class Body>
void forCorners(const Mesh& mesh, NormalWeight weight, const Body& body)
{
    const auto& p = mesh.positions();
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto face = mesh.face(f);
        const glm::dvec3 area = areaVector(mesh, f), n = unit(area);
        const uint32_t first = mesh.faceStart()[f];
        if (n == glm::dvec3(0)) continue;
        for (size_t i = 0; i < face.size(); ++i) {
            if (weight != NormalWeight::Angle) {
                body(first + uint32_t(i), weight == NormalWeight::Area ? area : n);
                continue;
            }
            const glm::dvec3 at(p[face[i]]), u = glm::dvec3(p[face[(i + 1) % face.size()]]) - at,
                                             v = glm::dvec3(p[face[(i + face.size() - 1) % face.size()]]) - at;
            double angle = std::atan2(glm::dot(n, glm::cross(u, v)), glm::dot(u, v));
            if (angle < 0) angle += 2 * std::numbers::pi;  // a corner that points inwards
            body(first + uint32_t(i), angle * n);
        }
    }
}

Array<glm::vec3> madeUnit(const std::vector<glm::dvec3>& sums)
{
    Array<glm::vec3> out(sums.size());
    for (size_t i = 0; i < sums.size(); ++i) out[i] = glm::vec3(unit(sums[i]));
    return out;
}

/// Corners at one vertex whose faces meet at an edge that is not a crease are joined.
UnionFind smoothCorners(const Mesh& mesh, double degrees)
{
    UnionFind sets(mesh.cornerCount());
    const EdgeSides edges = edgeSidesOf(mesh);
    const Array<uint32_t> faceOf = cornerFacesOf(mesh);
    const double least = std::cos(std::min(degrees, 180.) * std::numbers::pi / 180) - 1e-9;
    const auto ends = [&](size_t e, uint32_t side) {  // corners of a side at the lower and at the higher vertex
        const uint32_t f = faceOf[side], next = side + 1 == mesh.faceStart()[f + 1] ? mesh.faceStart()[f] : side + 1;
        return mesh.cornerVertex()[side] == edges.ends[2 * e] ? std::pair(side, next) : std::pair(next, side);
    };
    for (size_t e = 0; e < edges.size(); ++e) {
        if (edges.sides(e).size() != 2) continue;
        const uint32_t a = edges.sides(e)[0], b = edges.sides(e)[1];
        const glm::dvec3 m = unit(areaVector(mesh, faceOf[a])), n = unit(areaVector(mesh, faceOf[b]));
        if (glm::dot(m, n) < least) continue;
        const auto [aLow, aHigh] = ends(e, a);
        const auto [bLow, bHigh] = ends(e, b);
        sets.join(aLow, bLow);
        sets.join(aHigh, bHigh);
    }
    return sets;
}

/// As an attribute; a file wants a unit normal everywhere.
Attribute attributeOf(const Array<glm::vec3>& normals, Domain domain)
{
    Array<float> values(3 * normals.size());
    for (size_t i = 0; i < normals.size(); ++i) {
        const glm::vec3 n = normals[i] == glm::vec3(0) ? glm::vec3(0, 0, 1) : normals[i];
        for (int k = 0; k < 3; ++k) values[3 * i + size_t(k)] = n[k];
    }
    return floatAttribute(std::string(names::normal), domain, 3, std::move(values));
}

}  // namespace

Array<glm::vec3> vertexNormalsOf(const Mesh& mesh, NormalWeight weight)
{
    if (weight == NormalWeight::Area) return vertexNormalsOf(mesh);
    std::vector<glm::dvec3> sums(mesh.vertexCount(), glm::dvec3(0));
    forCorners(mesh, weight, [&](uint32_t corner, glm::dvec3 n) { sums[mesh.cornerVertex()[corner]] += n; });
    return madeUnit(sums);
}

Array<glm::vec3> cornerNormalsOf(const Mesh& mesh, NormalWeight weight, double degrees)
{
    UnionFind sets = smoothCorners(mesh, degrees);
    std::vector<glm::dvec3> sums(mesh.cornerCount(), glm::dvec3(0));
    forCorners(mesh, weight, [&](uint32_t corner, glm::dvec3 n) { sums[sets.root(corner)] += n; });
    for (uint32_t c = 0; c < sums.size(); ++c)
        if (const uint32_t root = sets.root(c); root != c) sums[c] = sums[root];
    return madeUnit(sums);
}

Generator normals(Mesh input, Normals parameters, Stage<Mesh>& stage)
{
    co_yield Step("sum").number("faces", double(input.faceCount())).progress(0);
    const bool corners = parameters.on == Normals::On::Corners;
    const Array<glm::vec3> made = corners ? cornerNormalsOf(input, parameters.weight, parameters.crease) : vertexNormalsOf(input, parameters.weight);
    co_yield Step("write").progress(0.9);
    stage.finish(input.without(names::normal).with(attributeOf(made, corners ? Domain::Corner : Domain::Vertex)));
}

}  // namespace mw
