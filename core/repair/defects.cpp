// Each check is a function that makes one entry. Their order is that in which repairs do not undo each other.
#include "core/repair/defects.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/connectivity.h"
#include "core/mesh/topology.h"
#include "core/mesh/union_find.h"
#include "core/repair/boundary.h"
#include "core/repair/coincident.h"
#include "core/repair/components.h"
#include "core/repair/self_intersections.h"

namespace mw {
namespace {

using Edge = TopologyReport::Edge;

std::vector<ElementSet> each(const std::vector<Edge>& edges)
{
    std::vector<ElementSet> sets;
    sets.reserve(edges.size());
    for (const Edge& e : edges) sets.push_back({ElementKind::Edge, {e.first, e.second}});
    return sets;
}

std::vector<ElementSet> each(ElementKind kind, const std::vector<uint32_t>& elements)
{
    std::vector<ElementSet> sets;
    sets.reserve(elements.size());
    for (const uint32_t i : elements) sets.push_back({kind, {i}});
    return sets;
}

std::vector<ElementSet> each(ElementKind kind, std::vector<std::vector<uint32_t>> groups)
{
    std::vector<ElementSet> sets;
    for (auto& g : groups) sets.push_back({kind, std::move(g)});
    return sets;
}

void largestFirst(std::vector<ElementSet>& sets)
{
    std::stable_sort(sets.begin(), sets.end(), [](const auto& a, const auto& b) { return a.indices.size() > b.indices.size(); });
}

ElementSet edgeSet(std::vector<Edge> edges)
{
    std::sort(edges.begin(), edges.end());
    ElementSet set{ElementKind::Edge, {}};
    for (const Edge& e : edges) set.indices.insert(set.indices.end(), {e.first, e.second});
    return set;
}

/// Loops that can be filled, and as one more offender the boundary edges that belong to none.
std::vector<ElementSet> holes(const Mesh& mesh)
{
    std::vector<ElementSet> sets;
    std::vector<Edge> inLoops, rest;
    for (const BoundaryLoop& loop : boundaryLoopsOf(mesh)) {
        std::vector<Edge> edges;
        for (size_t i = 0; i < loop.vertices.size(); ++i)
            edges.push_back(std::minmax(loop.vertices[i], loop.vertices[(i + 1) % loop.vertices.size()]));
        inLoops.insert(inLoops.end(), edges.begin(), edges.end());
        sets.push_back(edgeSet(std::move(edges)));
    }
    largestFirst(sets);
    if (inLoops.size() == mesh.topology().boundaryEdges) return sets;
    std::sort(inLoops.begin(), inLoops.end());
    const EdgeSides edges = edgeSidesOf(mesh, degenerateFacesOf(mesh));
    for (size_t e = 0; e < edges.size(); ++e) {
        const Edge edge(edges.ends[2 * e], edges.ends[2 * e + 1]);
        if (edges.sides(e).size() == 1 && !std::binary_search(inLoops.begin(), inLoops.end(), edge)) rest.push_back(edge);
    }
    if (!rest.empty()) sets.push_back(edgeSet(std::move(rest)));
    return sets;
}

/// Faces that hang together by intersecting, the most first.
std::vector<ElementSet> tangles(const Mesh& mesh, Progress* progress)
{
    const std::vector<FacePair> pairs = selfIntersectionsOf(mesh, {}, progress);
    if (pairs.empty()) return {};
    UnionFind sets(mesh.faceCount());
    std::vector<uint8_t> concerned(mesh.faceCount(), 0);
    for (const auto& [a, b] : pairs) {
        sets.join(a, b);
        concerned[a] = concerned[b] = 1;
    }
    Array<uint32_t> number(mesh.faceCount(), none);
    std::vector<ElementSet> out;
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
        if (!concerned[f]) continue;
        uint32_t& n = number[sets.root(f)];
        if (n == none) {
            n = uint32_t(out.size());
            out.push_back({ElementKind::Face, {}});
        }
        out[n].indices.push_back(f);
    }
    largestFirst(out);
    return out;
}

/// Points are the content of a mesh without faces, and ends of lines are in use.
std::vector<uint32_t> isolated(const Mesh& mesh)
{
    if (mesh.faceCount() == 0) return {};
    std::vector<uint8_t> onLine(mesh.vertexCount(), 0);
    for (const uint32_t v : mesh.lines()) onLine[v] = 1;
    std::vector<uint32_t> out;
    for (const uint32_t v : mesh.topology().isolatedVertices)
        if (!onLine[v]) out.push_back(v);
    return out;
}

Defect orientation(const TopologyReport& r)
{
    Defect d{"orientation",
             "Inconsistent orientation",
             "Neighbouring faces turn opposite ways, so one of them shows its back and is shaded wrong.",
             "Neighbouring faces turn the same way.",
             each(r.inconsistentEdges),
             "orient"};
    if (!r.orientable) {
        d.explanation = "The surface has one side only, like a Moebius strip, so its faces agree only after a cut across it.";
        d.repairParameters = "cut=true";
    }
    return d;
}

std::string percent(double share)
{
    const long tenths = std::lround(1000 * share);
    return std::to_string(tenths / 10) + (tenths % 10 ? "." + std::to_string(tenths % 10) : "") + " %";
}

Defect tiny(const Mesh& mesh, double share)
{
    Defect d{"tiny-components",
             "Tiny components",
             "Pieces smaller than " + percent(share) + " of the whole are mostly crumbs of a scan.",
             "No piece is smaller than " + percent(share) + " of the whole.",
             each(ElementKind::Face, tinyComponents(mesh, share)),
             "repair",
             "drop-tiny=true"};
    if (share != 0.01) d.repairParameters += ",tiny-share=" + std::to_string(share);
    return d;
}

}  // namespace

std::vector<Defect> defectsOf(const Mesh& mesh, const DefectOptions& options, Progress* progress)
{
    const auto at = [&](float f) {
        if (progress) progress->at(f);
    };
    at(0);
    const TopologyReport& r = mesh.topology();
    at(0.2f);
    std::vector<Defect> all{
        {"nonmanifold-edges", "Non-manifold edges", "More than two faces meet at an edge, so there is no telling inside from outside.",
         "No edge has more than two faces.", each(r.nonmanifoldEdges), "repair"},
        {"nonmanifold-vertices", "Non-manifold vertices", "Several fans of faces meet at one vertex, so its neighbours are no single ring.",
         "The faces at each vertex are one fan.", each(ElementKind::Vertex, r.nonmanifoldVertices), "repair"},
        {"coincident-vertices", "Coincident vertices", "Vertices lie at exactly the same place, so the surface is cut open there without showing it.",
         "No two vertices that could be one lie at the same place.", each(ElementKind::Vertex, joinableVertices(mesh, progress)), "repair",
         "weld=true"},
        {"degenerate-faces", "Degenerate faces", "A face has fewer than three corners, or visits a vertex twice, so it has no proper area.",
         "Every face has at least three corners, all different.", each(ElementKind::Face, r.degenerateFaces), "repair"},
        {"duplicate-faces", "Duplicate faces", "A face has the same vertices as another one, and the two flicker over each other.",
         "No two faces have the same vertices.", each(ElementKind::Face, r.duplicateFaces), "repair"}};
    at(0.3f);
    all.push_back(orientation(r));
    if (options.selfIntersections)
        all.push_back({"self-intersections", "Self-intersections",
                       "Faces pass through each other or lie on each other; move their vertices apart, or delete them and fill the hole.",
                       "No face passes through another one.", tangles(mesh, progress)});
    at(0.9f);
    all.push_back(tiny(mesh, options.tinyComponent));
    all.push_back({"holes", "Holes", "Edges with one face only go round an opening, so the mesh encloses no volume.", "Every edge has two faces.",
                   holes(mesh), "fill-holes"});
    all.push_back({"isolated-vertices", "Isolated vertices", "Vertices that no face uses are dead weight and stretch the bounds.",
                   "Every vertex belongs to a face.", each(ElementKind::Vertex, isolated(mesh)), "repair"});
    std::stable_partition(all.begin(), all.end(), [](const Defect& d) { return !d.passed(); });
    at(1);
    return all;
}

}  // namespace mw
