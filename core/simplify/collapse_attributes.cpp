// What a mesh under collapse carries: where corner values part (seams), and reading every attribute off the old surface.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numeric>
#include <utility>

#include "core/math/closest.h"
#include "core/simplify/collapse_mesh.h"

namespace mw {

namespace {

/// The end of a chain of parents.
uint32_t rootOf(const std::vector<uint32_t>& parent, uint32_t x)
{
    while (parent[x] != x) x = parent[x];
    return x;
}

/// All roots at once; parents of higher and lower index occur.
std::vector<uint32_t> rootsOf(std::vector<uint32_t> parent)
{
    for (uint32_t i = 0; i < parent.size(); ++i) {
        const uint32_t root = rootOf(parent, i);
        for (uint32_t x = i; parent[x] != root;) x = std::exchange(parent[x], root);
    }
    return parent;
}

/// For each root the place on the old surface that is nearest to it, among the triangles that had a corner in it.
class NearestOld {
public:
    explicit NearestOld(size_t roots) : best_(roots) {}

    void offer(uint32_t root, uint32_t triangle, const glm::dvec3& p, const glm::dvec3 (&corner)[3])
    {
        Found& b = best_[root];
        if (b.triangle == triangle || b.distance == 0) return;
        const glm::dvec3 w = closestOnTriangle(p, corner[0], corner[1], corner[2]);
        const glm::dvec3 gap = w[0] * corner[0] + w[1] * corner[1] + w[2] * corner[2] - p;
        const double d = glm::dot(gap, gap);
        if (d < b.distance) b = {d, triangle, w};
    }
    bool found(uint32_t root) const { return best_[root].triangle != none; }
    /// `names[3 * triangle + k]` is what the rows call corner k of a triangle.
    template <class Name>
    void addRow(Stencils& rows, uint32_t root, const Name& name) const
    {
        const Found& b = best_[root];
        for (uint32_t k = 0; k < 3; ++k)
            if (b.weight[int(k)] > 0) rows.add(name(3 * b.triangle + k), b.weight[int(k)]);
        rows.endRow();
    }

private:
    struct Found {
        double distance = std::numeric_limits<double>::infinity();
        uint32_t triangle = none;
        glm::dvec3 weight{0};
    };
    std::vector<Found> best_;
};

}  // namespace

// Values of two corners of one vertex, as far as a seam is concerned. Normals part only where they part visibly: a faceted mesh has none.
bool CollapseMesh::differ(const Attribute& a, uint32_t cornerA, uint32_t cornerB) const
{
    if (a.name == names::normal && a.components == 3) {
        double dot = 0, la = 0, lb = 0;
        for (int k = 0; k < 3; ++k) {
            const double x = a.at(cornerA, k), y = a.at(cornerB, k);
            dot += x * y, la += x * x, lb += y * y;
        }
        return dot < std::cos(glm::radians(40.0)) * std::sqrt(la * lb);
    }
    const auto f = a.floats();
    for (int k = 0; k < a.components; ++k) {
        const size_t m = size_t(a.components), i = cornerA * m + size_t(k), j = cornerB * m + size_t(k);
        const double x = f.empty() ? a.at(cornerA, k) : double(f[i]), y = f.empty() ? a.at(cornerB, k) : double(f[j]);
        if (!(std::abs(x - y) <= 1e-5 * (1 + std::abs(x)))) return true;
    }
    return false;
}

void CollapseMesh::markSeams()
{
    std::vector<const Attribute*> faceValues;
    for (const Attribute& a : input_.attributes()) {
        const bool direction = a.name == names::tangent || a.name.starts_with("morph-normal:");  // follow what they belong to
        if (a.domain == Domain::Corner && a.name != names::crease && !direction) cornerValues_.push_back(&a);
        if (a.domain == Domain::Face && (a.name == names::material || a.name == names::group)) faceValues.push_back(&a);
    }
    const auto faceOf = [&](uint32_t h) { return oldFace_.empty() ? h / 3 : oldFace_[h / 3]; };
    if (const Attribute* c = input_.find(names::crease, Domain::Corner)) {
        // A corner's value belongs to the side that leaves it; sides made by cutting polygons have none.
        crease_.assign(vertex_.size(), 0.f);
        for (uint32_t h = 0; h < vertex_.size(); ++h) {
            const uint32_t corner = oldCorner(h), face = faceOf(h), first = input_.faceStart()[face], end = input_.faceStart()[face + 1];
            if (oldCorner(next(h)) == (corner + 1 == end ? first : corner + 1)) crease_[h] = float(c->at(corner, 0));
        }
    }
    for (uint32_t h = 0; h < vertex_.size(); ++h) {
        const uint32_t g = twin_[h];
        if (g == none || g < h) continue;
        bool seam = !crease_.empty() && (crease_[h] > 0 || crease_[g] > 0);
        for (const Attribute* a : faceValues) seam = seam || a->at(faceOf(h), 0) != a->at(faceOf(g), 0);
        for (const Attribute* a : cornerValues_)
            seam = seam || differ(*a, oldCorner(h), oldCorner(next(g))) || differ(*a, oldCorner(next(h)), oldCorner(g));
        if (seam) sharp_[h] = sharp_[g] = rule;
    }
}

void CollapseMesh::joinWedges()
{
    const auto& attributes = input_.attributes();
    const auto onCorners = [](const Attribute& a) { return a.domain == Domain::Corner && a.name != names::crease; };
    if (std::none_of(attributes.begin(), attributes.end(), onCorners)) return;
    wedge_.resize(vertex_.size());
    std::iota(wedge_.begin(), wedge_.end(), 0u);
    for (uint32_t h = 0; h < vertex_.size(); ++h) {
        const uint32_t g = twin_[h];
        if (g == none || g < h || onCurve(h)) continue;
        unite(wedge_, h, next(g));
        unite(wedge_, next(h), g);
    }
}

Stencils CollapseMesh::vertexRows(const std::vector<uint32_t>& kept) const
{
    const std::vector<uint32_t> root = rootsOf(into_);
    NearestOld nearest(vertexSlots());
    const auto& old = input_.positions();
    for (uint32_t t = 0; t < faceSlots(); ++t) {
        const uint32_t* v = oldVertex_.data() + 3 * t;
        glm::dvec3 corner[3];
        for (int k = 0; k < 3; ++k) corner[k] = (glm::dvec3(old[v[k]]) - centre_) / scale_;
        for (int k = 0; k < 3; ++k) nearest.offer(root[v[k]], t, place_[root[v[k]]], corner);
    }
    Stencils rows;
    for (const uint32_t v : kept) {
        if (nearest.found(v)) {
            nearest.addRow(rows, v, [&](uint32_t c) { return oldVertex_[c]; });
        } else {
            rows.add(v, 1);
            rows.endRow();
        }
    }
    return rows;
}

Stencils CollapseMesh::cornerRows() const
{
    const std::vector<uint32_t> root = rootsOf(into_), wedge = rootsOf(wedge_);
    NearestOld nearest(wedge_.size());
    const auto& old = input_.positions();
    for (uint32_t t = 0; t < faceSlots(); ++t) {
        const uint32_t* v = oldVertex_.data() + 3 * t;
        glm::dvec3 corner[3];
        for (int k = 0; k < 3; ++k) corner[k] = (glm::dvec3(old[v[k]]) - centre_) / scale_;
        for (uint32_t k = 0; k < 3; ++k) nearest.offer(wedge[3 * t + k], t, place_[root[v[k]]], corner);
    }
    Stencils rows;
    for (uint32_t f = 0; f < faceSlots(); ++f)
        for (uint32_t k = 0; alive(f) && k < 3; ++k) nearest.addRow(rows, wedge[3 * f + k], [&](uint32_t c) { return oldCorner(c); });
    return rows;
}

Mesh CollapseMesh::payload() const
{
    std::vector<uint32_t> kept, number(vertexSlots(), none), faceFrom;
    Array<glm::vec3> positions;
    for (uint32_t v = 0; v < vertexSlots(); ++v) {
        if (into_[v] != v) continue;
        number[v] = uint32_t(kept.size());
        kept.push_back(v);
        const glm::vec3 old = input_.positions()[v];
        const bool moved = place_[v] != (glm::dvec3(old) - centre_) / scale_;
        positions.push_back(moved ? position(place_[v]) : old);
    }
    Array<uint32_t> triangles;
    triangles.reserve(3 * faces_);
    Array<float> creases;
    for (uint32_t f = 0; f < faceSlots(); ++f) {
        if (!alive(f)) continue;
        faceFrom.push_back(oldFace_.empty() ? f : oldFace_[f]);
        for (uint32_t k = 0; k < 3; ++k) triangles.push_back(number[vertex_[3 * f + k]]);
        for (uint32_t k = 0; !crease_.empty() && k < 3; ++k) creases.push_back(crease_[3 * f + k]);
    }
    Mesh mesh = Mesh::triangles(std::move(positions), std::move(triangles)).withGroupNames(input_.groupNames());
    Array<uint32_t> lines;
    for (const uint32_t v : input_.lines()) lines.push_back(number[v]);
    if (!lines.empty()) mesh = mesh.withLines(std::move(lines));
    if (!creases.empty()) mesh = mesh.with(floatAttribute(std::string(names::crease), Domain::Corner, 1, std::move(creases)));

    const auto has = [&](Domain d) {
        return std::any_of(input_.attributes().begin(), input_.attributes().end(),
                           [&](const Attribute& a) { return a.domain == d && !(d == Domain::Corner && a.name == names::crease); });
    };
    const Stencils ofVertices = has(Domain::Vertex) ? vertexRows(kept) : Stencils(), ofCorners = has(Domain::Corner) ? cornerRows() : Stencils();
    const Attribute *joints = input_.find(names::joints, Domain::Vertex), *weights = input_.find(names::weights, Domain::Vertex);
    for (const Attribute& a : input_.attributes()) {
        if (a.domain == Domain::Face)
            mesh = mesh.with(gathered(a, faceFrom));
        else if (a.domain == Domain::Corner && a.name != names::crease)
            mesh = mesh.with(blended(a, ofCorners));
        else if (a.domain == Domain::Vertex && !(joints && weights && (&a == joints || &a == weights)))
            mesh = mesh.with(blended(a, ofVertices));
    }
    if (joints && weights) {
        SkinWeights skin = blendedSkin(*joints, *weights, ofVertices);
        mesh = mesh.with(std::move(skin.joints)).with(std::move(skin.weights));
    }
    return mesh;
}

}  // namespace mw
