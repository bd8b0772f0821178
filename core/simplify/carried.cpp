// Attributes over edge collapses: seams, the nearest place on the old surface, rows of mixing.
#include "core/simplify/carried.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "core/math/closest.h"

namespace mw {

OldTriangles::OldTriangles(const Mesh& mesh)
{
    if (mesh.isTriangles()) {
        vertices = mesh.cornerVertex();
    } else {
        const Mesh::Triangulation& t = mesh.triangulation();
        vertices = t.vertices, corners = t.corners, faces = t.faces;
    }
}

SeamTest::SeamTest(const Mesh& mesh, const OldTriangles& triangles) : mesh_(&mesh), triangles_(&triangles)
{
    for (const Attribute& a : mesh.attributes()) {
        const bool onCorners = a.domain == Domain::Corner && a.name != names::crease;
        const bool direction = a.name == names::tangent || a.name.starts_with("morph-normal:");  // follow what they belong to
        cornersCarry_ = cornersCarry_ || onCorners;
        if (onCorners && !direction)
            cornerValues_.push_back({&a, a.floats().data(), size_t(a.components), a.name == names::normal && a.components == 3});
        if (a.domain == Domain::Face && (a.name == names::material || a.name == names::group)) faceValues_.push_back(&a);
    }
    crease_ = mesh.find(names::crease, Domain::Corner);
}

// Normals part only where they part visibly: a faceted mesh has no seams.
bool SeamTest::differ(const Values& v, uint32_t a, uint32_t b) const
{
    if (v.floats && std::memcmp(v.floats + a * v.components, v.floats + b * v.components, v.components * sizeof(float)) == 0) return false;
    const auto at = [&](uint32_t c, size_t k) { return v.floats ? double(v.floats[c * v.components + k]) : v.attribute->at(c, int(k)); };
    if (v.normal) {
        double dot = 0, la = 0, lb = 0;
        for (size_t k = 0; k < 3; ++k) {
            const double x = at(a, k), y = at(b, k);
            dot += x * y, la += x * x, lb += y * y;
        }
        static const double visible = std::cos(glm::radians(40.0));
        return dot < visible * std::sqrt(la * lb);
    }
    for (size_t k = 0; k < v.components; ++k) {
        const double x = at(a, k), y = at(b, k);
        if (!(std::abs(x - y) <= 1e-5 * (1 + std::abs(x)))) return true;
    }
    return false;
}

bool SeamTest::parts(uint32_t c, uint32_t d) const
{
    if (crease_ && (crease(c) > 0 || crease(d) > 0)) return true;
    for (const Attribute* a : faceValues_)
        if (a->at(triangles_->face(c / 3), 0) != a->at(triangles_->face(d / 3), 0)) return true;
    if (cornerValues_.empty()) return false;
    const uint32_t c0 = triangles_->corner(c), c1 = triangles_->corner(OldTriangles::next(c));
    const uint32_t d0 = triangles_->corner(d), d1 = triangles_->corner(OldTriangles::next(d));
    for (const Values& v : cornerValues_)
        if (differ(v, c0, d1) || differ(v, c1, d0)) return true;
    return false;
}

float SeamTest::crease(uint32_t c) const
{
    const uint32_t corner = triangles_->corner(c), face = triangles_->face(c / 3), first = mesh_->faceStart()[face],
                   end = mesh_->faceStart()[face + 1];
    const bool side = triangles_->corner(OldTriangles::next(c)) == (corner + 1 == end ? first : corner + 1);
    return side ? float(crease_->at(corner, 0)) : 0;
}

namespace {

/// For each of some new places the place on the old surface that is nearest to it, among the triangles that are offered.
class NearestOld {
public:
    explicit NearestOld(size_t places) : best_(places) {}

    /// `reach`: the square of how far the triangle goes from its first corner.
    void offer(uint32_t place, uint32_t triangle, const glm::dvec3& p, const glm::dvec3 (&corner)[3], double reach)
    {
        Found& b = best_[place];
        if (b.triangle == triangle || b.distance == 0) return;
        const glm::dvec3 arm = p - corner[0];
        if (glm::dot(arm, arm) > 2 * (b.distance + reach)) return;  // too far: (x + y)^2 <= 2 (x^2 + y^2)
        const glm::dvec3 w = closestOnTriangle(p, corner[0], corner[1], corner[2]);
        const glm::dvec3 gap = w[0] * corner[0] + w[1] * corner[1] + w[2] * corner[2] - p;
        const double d = glm::dot(gap, gap);
        if (d < b.distance) b = {d, triangle, w};
    }
    bool found(uint32_t place) const { return best_[place].triangle != none; }
    /// `names(3 * triangle + k)` is what the rows call corner k of a triangle.
    template <class Name>
    void addRow(Stencils& rows, uint32_t place, const Name& name) const
    {
        const Found& b = best_[place];
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

/// Where the values of each new vertex, and of each of its wedges, are read.
class Transfer {
public:
    Transfer(const Mesh& mesh, const OldTriangles& triangles, const Collapsed& collapsed, const std::vector<uint32_t>& number);
    Stencils vertexRows(const std::vector<uint32_t>& kept) const;
    Stencils cornerRows(const std::vector<uint32_t>& number) const;

private:
    const OldTriangles& triangles_;
    const Collapsed& collapsed_;
    NearestOld vertices_, wedges_;
};

Transfer::Transfer(const Mesh& mesh, const OldTriangles& triangles, const Collapsed& collapsed, const std::vector<uint32_t>& number)
    : triangles_(triangles), collapsed_(collapsed), vertices_(collapsed.positions.size()), wedges_(collapsed.wedges)
{
    const auto& old = mesh.positions();
    for (uint32_t t = 0; t < triangles.size(); ++t) {
        const uint32_t* v = triangles.vertices.data() + 3 * t;
        const glm::dvec3 corner[3] = {glm::dvec3(old[v[0]]), glm::dvec3(old[v[1]]), glm::dvec3(old[v[2]])};
        const glm::dvec3 side = corner[1] - corner[0], other = corner[2] - corner[0];
        const double reach = std::max(glm::dot(side, side), glm::dot(other, other));
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t root = number[collapsed.into[v[k]]];
            const glm::dvec3 p(collapsed.positions[root]);
            vertices_.offer(root, t, p, corner, reach);
            const uint32_t wedge = collapsed.wedge.empty() ? none : collapsed.wedge[3 * t + k];
            if (wedge != none) wedges_.offer(wedge, t, p, corner, reach);
        }
    }
}

Stencils Transfer::vertexRows(const std::vector<uint32_t>& kept) const
{
    Stencils rows;
    for (uint32_t i = 0; i < kept.size(); ++i) {
        if (vertices_.found(i)) {
            vertices_.addRow(rows, i, [&](uint32_t c) { return triangles_.vertices[c]; });
        } else {
            rows.add(kept[i], 1);
            rows.endRow();
        }
    }
    return rows;
}

Stencils Transfer::cornerRows(const std::vector<uint32_t>& number) const
{
    const auto name = [&](uint32_t c) { return triangles_.corner(c); };
    Stencils rows;
    for (size_t i = 0; i < collapsed_.corners.size(); ++i) {
        const uint32_t old = 3 * collapsed_.triangles[i / 3] + uint32_t(i % 3);
        const uint32_t wedge = collapsed_.wedge.empty() ? none : collapsed_.wedge[old];
        if (wedge != none)
            wedges_.addRow(rows, wedge, name);
        else
            vertices_.addRow(rows, number[collapsed_.corners[i]], name);
    }
    return rows;
}

Mesh withAttributes(Mesh mesh, const Mesh& old, const OldTriangles& triangles, const Collapsed& c, const std::vector<uint32_t>& kept,
                    const std::vector<uint32_t>& number)
{
    const auto has = [&](Domain d) {
        return std::any_of(old.attributes().begin(), old.attributes().end(),
                           [&](const Attribute& a) { return a.domain == d && !(d == Domain::Corner && a.name == names::crease); });
    };
    Stencils ofVertices, ofCorners;
    if (has(Domain::Vertex) || has(Domain::Corner)) {
        const Transfer transfer(old, triangles, c, number);
        if (has(Domain::Vertex)) ofVertices = transfer.vertexRows(kept);
        if (has(Domain::Corner)) ofCorners = transfer.cornerRows(number);
    }
    std::vector<uint32_t> faceFrom;
    if (has(Domain::Face))
        for (const uint32_t t : c.triangles) faceFrom.push_back(triangles.face(t));
    const Attribute *joints = old.find(names::joints, Domain::Vertex), *weights = old.find(names::weights, Domain::Vertex);
    for (const Attribute& a : old.attributes()) {
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

}  // namespace

Mesh carried(const Mesh& old, const OldTriangles& triangles, Collapsed c)
{
    std::vector<uint32_t> kept, number(c.into.size(), none);
    for (uint32_t v = 0; v < c.into.size(); ++v) {
        if (c.into[v] != v) continue;
        number[v] = uint32_t(kept.size());
        kept.push_back(v);
    }
    Array<uint32_t> corners(c.corners.size());
    for (size_t i = 0; i < corners.size(); ++i) corners[i] = number[c.corners[i]];
    Mesh mesh = Mesh::triangles(c.positions, std::move(corners)).withGroupNames(old.groupNames());
    Array<uint32_t> lines;
    for (const uint32_t v : old.lines()) lines.push_back(number[v]);
    if (!lines.empty()) mesh = mesh.withLines(std::move(lines));
    if (!c.creases.empty()) mesh = mesh.with(floatAttribute(std::string(names::crease), Domain::Corner, 1, std::move(c.creases)));
    return withAttributes(std::move(mesh), old, triangles, c, kept, number);
}

}  // namespace mw
