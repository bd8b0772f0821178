// The edges by one of four methods, then one cut.
#include "core/parameterize/cut.h"

#include <algorithm>
#include <charconv>

#include "core/error.h"
#include "core/mesh/cut_open.h"
#include "core/mesh/rings.h"
#include "core/mesh/select.h"
#include "core/metrics/uv_layout.h"
#include "core/parameterize/cut_graph.h"

namespace mw {
namespace {

std::vector<uint32_t> givenEdges(const Mesh& mesh, const std::string& text)
{
    const ElementSet set = parsedElements(ElementKind::Edge, text, mesh.vertexCount());
    for (size_t i = 0; i < set.indices.size(); i += 2) {
        const auto ring = mesh.rings().neighboursOf(set.indices[i]);
        if (!std::binary_search(ring.begin(), ring.end(), set.indices[i + 1]))
            throw Error("edges: " + std::to_string(set.indices[i]) + "~" + std::to_string(set.indices[i + 1]) +
                        " is no edge of this mesh; select the edges anew");
    }
    return set.indices;
}

/// In the order given.
std::vector<uint32_t> givenVertices(const Mesh& mesh, const std::string& text)
{
    std::vector<uint32_t> out;
    const char *at = text.data(), *end = at + text.size();
    while (at != end) {
        uint32_t v = 0;
        const auto [next, error] = std::from_chars(at, end, v);
        if (error != std::errc{} || (next != end && *next != ';'))
            throw Error("vertices: \"" + std::string(at, std::min(end, at + 40)) + "\" is no index; write them like 12;55;90");
        if (v >= mesh.vertexCount())
            throw Error("vertices: " + std::to_string(v) + " is beyond the last vertex; indices are below " + std::to_string(mesh.vertexCount()));
        out.push_back(v);
        at = next == end ? end : next + 1;
    }
    return out;
}

std::vector<uint32_t> shortestWay(const Mesh& mesh, const std::string& text)
{
    const std::vector<uint32_t> stops = givenVertices(mesh, text);
    std::vector<uint32_t> edges;
    for (size_t i = 0; i + 1 < stops.size(); ++i) {
        const std::vector<uint32_t> path = edgePath(mesh, stops[i], stops[i + 1]);
        if (path.empty())
            throw Error("vertices: there is no way along edges from " + std::to_string(stops[i]) + " to " + std::to_string(stops[i + 1]) +
                        "; choose two of one piece");
        for (size_t k = 0; k + 1 < path.size(); ++k) edges.insert(edges.end(), {path[k], path[k + 1]});
    }
    return edges;
}

std::vector<uint32_t> seams(const Mesh& mesh)
{
    const UvLayout layout = uvLayoutOf(mesh, 0);
    std::vector<uint32_t> edges;
    for (size_t e = 0; e < layout.kinds.size(); ++e)
        if (layout.kinds[e] == UvLayout::Seam)
            edges.insert(edges.end(), {mesh.cornerVertex()[layout.edges[2 * e]], mesh.cornerVertex()[layout.edges[2 * e + 1]]});
    return edges;
}

std::vector<uint32_t> edgesOf(const Mesh& mesh, const Cut& p)
{
    switch (p.method) {
        case Cut::Method::Edges:
            return givenEdges(mesh, p.edges);
        case Cut::Method::Shortest:
            return shortestWay(mesh, p.vertices);
        case Cut::Method::Seams:
            return seams(mesh);
        default:
            return diskCut(mesh);
    }
}

}  // namespace

Generator cut(Mesh input, Cut p, Stage<Mesh>& stage)
{
    co_yield Step("choose").progress(0);
    const std::vector<uint32_t> edges = edgesOf(input, p);
    co_yield Step("cut").progress(0.7);
    stage.finish(cutOpen(input, edges));
}

}  // namespace mw
