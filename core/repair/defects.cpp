#include "core/repair/defects.h"

#include <algorithm>
#include <map>

#include "core/mesh/topology.h"

namespace mw {
namespace {

using Edge = TopologyReport::Edge;

ElementSet edgeSet(const Edge& e)
{
    return {ElementKind::Edge, {e.first, e.second}};
}

std::vector<ElementSet> each(const std::vector<Edge>& edges)
{
    std::vector<ElementSet> sets;
    for (const Edge& e : edges) sets.push_back(edgeSet(e));
    return sets;
}

std::vector<ElementSet> each(ElementKind kind, const std::vector<uint32_t>& elements)
{
    std::vector<ElementSet> sets;
    for (const uint32_t i : elements) sets.push_back({kind, {i}});
    return sets;
}

std::vector<ElementSet> loops(const TopologyReport& r)
{
    std::vector<ElementSet> sets;
    for (const auto& loop : r.boundaryLoops) {
        std::vector<Edge> edges;
        for (size_t i = 0; i < loop.size(); ++i) edges.push_back(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
        std::sort(edges.begin(), edges.end());
        ElementSet set{ElementKind::Edge, {}};
        for (const Edge& e : edges) set.indices.push_back(e.first), set.indices.push_back(e.second);
        sets.push_back(std::move(set));
    }
    std::stable_sort(sets.begin(), sets.end(), [](const auto& a, const auto& b) { return a.indices.size() > b.indices.size(); });
    return sets;
}

}  // namespace

std::vector<Defect> defectsOf(const Mesh& mesh, const DefectOptions&, Progress* progress)
{
    const TopologyReport& r = mesh.topology();
    if (progress) progress->at(0.5f);
    std::vector<Defect> all{
        {"nonmanifold-edges", "Non-manifold edges", "More than two faces meet at an edge, so it has no inside and outside.",
         "No edge has more than two faces.", each(r.nonmanifoldEdges), "repair"},
        {"nonmanifold-vertices", "Non-manifold vertices", "Several fans of faces meet at a vertex, so its ring is no single walk.",
         "The faces at each vertex are one fan.", each(ElementKind::Vertex, r.nonmanifoldVertices), "repair"},
        {"orientation", "Inconsistent orientation", "Neighbouring faces turn opposite ways, so one of them shows its back.",
         "Neighbouring faces turn the same way.", each(r.inconsistentEdges), "orient"},
        {"degenerate-faces", "Degenerate faces", "A face has fewer than three different vertices and so no area and no normal.",
         "Every face has three different vertices.", each(ElementKind::Face, r.degenerateFaces), "repair"},
        {"duplicate-faces", "Duplicate faces", "Two faces have the same vertices and flicker over each other.",
         "No two faces have the same vertices.", each(ElementKind::Face, r.duplicateFaces), "repair"},
        {"holes", "Holes", "Edges with one face only go round an opening.", "Every edge has two faces.", loops(r), "fill-holes"},
        {"isolated-vertices", "Isolated vertices", "A vertex that no face uses is dead weight and stretches the bounds.",
         "Every vertex belongs to a face.", each(ElementKind::Vertex, r.isolatedVertices), "repair"},
    };
    std::stable_partition(all.begin(), all.end(), [](const Defect& d) { return !d.passed(); });
    return all;
}

}  // namespace mw
