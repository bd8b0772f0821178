// Selection along edges and by what is measured: loops and rings on the half-edge view, borders, valence, bends and planes.
#include <OpenMesh/Core/Mesh/Handles.hh>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/mesh/connectivity.h"
#include "core/mesh/halfedge.h"
#include "core/mesh/select.h"
#include "core/mesh/select_masks.h"
#include "core/mesh/union_find.h"

namespace mw {

using namespace select;

namespace {

using HH = OpenMesh::HalfedgeHandle;

/// Walks on the half-edge view; every edge is taken once.
class Walk {
public:
    explicit Walk(const Mesh& mesh)
        : mesh_(mesh), view_(mesh.halfedges()), kernel_(view_.kernel), taken_(kernel_.n_edges(), 0), cornerFace_(cornerFacesOf(mesh))
    {}

    void loop(HH h);
    void ring(HH h);
    /// The half-edges of the view between two vertices of the mesh: one an edge of the view.
    std::vector<HH> between(uint32_t a, uint32_t b) const;
    bool onBorder(HH h) const { return kernel_.is_boundary(h) || kernel_.is_boundary(twin(h)); }
    ElementSet result() const;

private:
    bool take(HH h) { return !std::exchange(taken_[size_t(kernel_.edge_handle(h).idx())], uint8_t(1)); }
    HH twin(HH h) const { return kernel_.opposite_halfedge_handle(h); }
    HH next(HH h) const { return kernel_.next_halfedge_handle(h); }
    HH straightOn(HH h) const;
    HH across(HH h) const;
    template <class Step>
    void follow(HH h, const Step& step)
    {
        for (h = step(h); h.is_valid() && take(h);) h = step(h);
    }

    const Mesh& mesh_;
    const HalfedgeView& view_;
    const OpenMesh::PolyConnectivity& kernel_;
    Mask taken_;
    Array<uint32_t> cornerFace_;
};

// At the end of h: the edge with as many faces on its left as on its right. None at a border and where the vertex is not regular.
HH Walk::straightOn(HH h) const
{
    size_t n = 0;
    bool triangles = true;
    HH out = next(h);
    do {
        if (kernel_.is_boundary(out)) return HH();
        triangles = triangles && next(next(next(out))) == out;
        out = next(twin(out));
    } while (++n < 8 && out != next(h));
    if (out != next(h) || (n != 4 && !(n == 6 && triangles))) return HH();
    for (size_t i = 1; i < n / 2; ++i) out = next(twin(out));
    return out;
}

HH Walk::across(HH h) const
{
    if (kernel_.is_boundary(h)) return HH();
    const HH far = next(next(h));
    return far != h && next(next(far)) == h ? twin(far) : HH();
}

void Walk::loop(HH h)
{
    take(h);
    if (onBorder(h)) return;  // a seam of the view; true borders are followed on the mesh
    const auto step = [&](HH g) { return straightOn(g); };
    follow(h, step);
    follow(twin(h), step);
}

void Walk::ring(HH h)
{
    take(h);
    const auto step = [&](HH g) { return across(g); };
    follow(h, step);
    follow(twin(h), step);
}

std::vector<HH> Walk::between(uint32_t a, uint32_t b) const
{
    std::vector<HH> found;
    if (a >= mesh_.vertexCount() || b >= mesh_.vertexCount()) return found;
    for (const uint32_t c : mesh_.rings().cornersOf(a)) {
        const uint32_t f = cornerFace_[c], first = mesh_.faceStart()[f], end = mesh_.faceStart()[f + 1];
        const uint32_t after = c + 1 < end ? c + 1 : first, before = c > first ? c - 1 : end - 1;
        for (const auto& [from, to] : {std::pair(c, after), std::pair(before, before)}) {
            if (view_.cornerHalfedge[from] == none || mesh_.cornerVertex()[to] != b) continue;
            const HH h(int(view_.cornerHalfedge[from]));
            const auto same = [&](HH g) { return kernel_.edge_handle(g) == kernel_.edge_handle(h); };
            if (std::none_of(found.begin(), found.end(), same)) found.push_back(h);
        }
    }
    return found;
}

ElementSet Walk::result() const
{
    ElementSet out{ElementKind::Edge, {}};
    for (size_t e = 0; e < taken_.size(); ++e) {
        if (!taken_[e]) continue;
        const HH h = kernel_.halfedge_handle(OpenMesh::EdgeHandle(int(e)), 0);
        out.indices.push_back(view_.vertexOf(uint32_t(kernel_.from_vertex_handle(h).idx())));
        out.indices.push_back(view_.vertexOf(uint32_t(kernel_.to_vertex_handle(h).idx())));
    }
    return sorted(std::move(out));
}

EdgeSides edgesOfGoodFaces(const Mesh& mesh)
{
    const std::vector<uint8_t> degenerate = degenerateFacesOf(mesh);
    return edgeSidesOf(mesh, degenerate);
}

void add(ElementSet& set, const EdgeSides& edges, size_t e)
{
    set.indices.push_back(edges.ends[2 * e]);
    set.indices.push_back(edges.ends[2 * e + 1]);
}

/// Cosine of the bend at an edge of two faces, whichever way they run; -1 where a face has no area.
double bendCosine(const Mesh& mesh, const Array<uint32_t>& faceOf, std::span<const uint32_t> sides)
{
    const glm::dvec3 a(mesh.faceNormals()[faceOf[sides[0]]]), b(mesh.faceNormals()[faceOf[sides[1]]]);
    if (a == glm::dvec3(0) || b == glm::dvec3(0)) return -1;
    const bool sameWay = mesh.cornerVertex()[sides[0]] == mesh.cornerVertex()[sides[1]];
    return glm::dot(a, b) * (sameWay ? -1 : 1);
}

/// A little slack, so that a bend of exactly the angle is within it.
double cosineOf(double degrees)
{
    return std::cos(glm::radians(std::clamp(degrees, 0.0, 180.0))) - 1e-6;
}

}  // namespace

ElementSet edgeLoop(const Mesh& mesh, const ElementSet& edges)
{
    if (edges.kind != ElementKind::Edge || edges.indices.empty()) return {ElementKind::Edge, {}};
    Walk walk(mesh);
    ElementSet border{ElementKind::Vertex, {}};
    for (size_t i = 0; i + 1 < edges.indices.size(); i += 2) {
        const std::vector<HH> found = walk.between(edges.indices[i], edges.indices[i + 1]);
        for (const HH h : found) walk.loop(h);
        if (found.size() == 1 && walk.onBorder(found[0])) border.indices.push_back(edges.indices[i]);
    }
    if (border.indices.empty()) return walk.result();
    return united(walk.result(), boundaryLoops(mesh, sorted(std::move(border))));
}

ElementSet edgeRing(const Mesh& mesh, const ElementSet& edges)
{
    if (edges.kind != ElementKind::Edge || edges.indices.empty()) return {ElementKind::Edge, {}};
    Walk walk(mesh);
    for (size_t i = 0; i + 1 < edges.indices.size(); i += 2)
        for (const HH h : walk.between(edges.indices[i], edges.indices[i + 1])) walk.ring(h);
    return walk.result();
}

ElementSet boundary(const Mesh& mesh, ElementKind kind)
{
    const EdgeSides edges = edgesOfGoodFaces(mesh);
    const Array<uint32_t> faceOf = kind == ElementKind::Face ? cornerFacesOf(mesh) : Array<uint32_t>();
    ElementSet out{kind, {}};
    for (size_t e = 0; e < edges.size(); ++e) {
        if (edges.sides(e).size() != 1) continue;
        if (kind == ElementKind::Face)
            out.indices.push_back(faceOf[edges.sides(e)[0]]);
        else
            add(out, edges, e);
    }
    return sorted(std::move(out));
}

ElementSet boundaryLoops(const Mesh& mesh, const ElementSet& set)
{
    const ElementSet all = boundary(mesh, ElementKind::Edge), seeds = converted(mesh, set, ElementKind::Vertex);
    UnionFind sets(mesh.vertexCount());
    Mask onBorder(mesh.vertexCount(), 0), wanted(mesh.vertexCount(), 0);
    for (size_t i = 0; i < all.indices.size(); i += 2) {
        sets.join(all.indices[i], all.indices[i + 1]);
        onBorder[all.indices[i]] = onBorder[all.indices[i + 1]] = 1;
    }
    for (const uint32_t v : seeds.indices)
        if (v < onBorder.size() && onBorder[v]) wanted[sets.root(v)] = 1;
    ElementSet out{ElementKind::Edge, {}};
    for (size_t i = 0; i < all.indices.size(); i += 2)
        if (wanted[sets.root(all.indices[i])]) out.indices.insert(out.indices.end(), {all.indices[i], all.indices[i + 1]});
    return out;
}

ElementSet ofValence(const Mesh& mesh, size_t least, size_t most)
{
    const EdgeSides edges = edgesOfGoodFaces(mesh);
    std::vector<uint32_t> valence(mesh.vertexCount(), 0);
    for (const uint32_t v : edges.ends) ++valence[v];
    ElementSet out{ElementKind::Vertex, {}};
    for (uint32_t v = 0; v < valence.size(); ++v)
        if (valence[v] >= least && valence[v] <= most) out.indices.push_back(v);
    return out;
}

ElementSet sharpEdges(const Mesh& mesh, double degrees)
{
    const EdgeSides edges = edgesOfGoodFaces(mesh);
    const Array<uint32_t> faceOf = cornerFacesOf(mesh);
    const double least = cosineOf(degrees);
    ElementSet out{ElementKind::Edge, {}};
    for (size_t e = 0; e < edges.size(); ++e)
        if (edges.sides(e).size() == 2 && bendCosine(mesh, faceOf, edges.sides(e)) < least) add(out, edges, e);
    return out;
}

ElementSet flatRegion(const Mesh& mesh, const ElementSet& set, double degrees)
{
    const ElementSet seeds = converted(mesh, set, ElementKind::Face, true);
    const EdgeSides edges = edgesOfGoodFaces(mesh);
    const Array<uint32_t> faceOf = cornerFacesOf(mesh);
    const double least = cosineOf(degrees);
    UnionFind sets(mesh.faceCount());
    for (size_t e = 0; e < edges.size(); ++e) {
        const auto sides = edges.sides(e);
        if (sides.size() == 2 && bendCosine(mesh, faceOf, sides) >= least) sets.join(faceOf[sides[0]], faceOf[sides[1]]);
    }
    Mask wanted(mesh.faceCount(), 0);
    for (const uint32_t f : seeds.indices)
        if (f < wanted.size()) wanted[sets.root(f)] = 1;
    ElementSet out{ElementKind::Face, {}};
    for (uint32_t f = 0; f < wanted.size(); ++f)
        if (wanted[sets.root(f)]) out.indices.push_back(f);
    return out;
}

ElementSet coplanar(const Mesh& mesh, const ElementSet& set, double degrees, double distance)
{
    const ElementSet seeds = converted(mesh, set, ElementKind::Face, true);
    ElementSet out{ElementKind::Face, {}};
    const auto& p = mesh.positions();
    glm::dvec3 normal(0), middle(0);
    double area = 0;
    for (const uint32_t f : seeds.indices) {
        if (f >= mesh.faceCount()) continue;
        const auto v = mesh.face(f);
        for (size_t i = 2; i < v.size(); ++i) {
            const glm::dvec3 a(p[v[0]]), b(p[v[i - 1]]), c(p[v[i]]), n = 0.5 * glm::cross(b - a, c - a);
            normal += n;
            middle += glm::length(n) * (a + b + c) / 3.0;
            area += glm::length(n);
        }
    }
    if (area == 0 || normal == glm::dvec3(0)) return out;
    normal = glm::normalize(normal);
    middle /= area;
    const double least = cosineOf(degrees);
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
        const auto v = mesh.face(f);
        const auto near = [&](uint32_t i) { return std::abs(glm::dot(glm::dvec3(p[i]) - middle, normal)) <= distance; };
        if (std::abs(glm::dot(glm::dvec3(mesh.faceNormals()[f]), normal)) >= least && std::all_of(v.begin(), v.end(), near)) out.indices.push_back(f);
    }
    return out;
}

}  // namespace mw
