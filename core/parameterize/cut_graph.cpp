// A forest of shortest ways from border or seed vertices, then a spanning forest of the faces that does not cross it.
#include "core/parameterize/cut_graph.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <queue>
#include <tuple>

#include "core/error.h"
#include "core/mesh/connectivity.h"
#include "core/mesh/rings.h"
#include "core/mesh/topology.h"
#include "core/mesh/union_find.h"

namespace mw {
namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

double length(const Mesh& mesh, uint32_t a, uint32_t b)
{
    return glm::distance(glm::dvec3(mesh.positions()[a]), glm::dvec3(mesh.positions()[b]));
}

uint32_t farthest(const EdgeDistances& d, std::span<const uint32_t> among)
{
    uint32_t best = among[0];
    for (const uint32_t v : among)
        if (d.distance[v] < unreached && d.distance[v] > d.distance[best]) best = v;
    return best;
}

/// A way of at least two edges between two vertices far apart: one edge alone opens nothing.
std::vector<uint32_t> longPath(const Mesh& mesh, std::span<const uint32_t> component)
{
    const uint32_t seed[] = {component[0]}, from[] = {farthest(edgeDistances(mesh, seed), component)};
    std::vector<uint32_t> path = edgePath(mesh, from[0], farthest(edgeDistances(mesh, from), component));
    if (path.size() == 2)
        for (const uint32_t w : mesh.rings().neighboursOf(path[1]))
            if (w != path[0] && path.size() == 2) path.push_back(w);
    return path;
}

class DiskCut {
public:
    explicit DiskCut(const Mesh& mesh) : mesh_(mesh), sides_(edgeSidesOf(mesh)), faceOf_(cornerFacesOf(mesh)), cut_(sides_.size(), 1)
    {
        components();
        distances_ = edgeDistances(mesh, seeds_);
        crossFaces();
        prune();
    }
    std::vector<uint32_t> edges() const
    {
        std::vector<uint32_t> out;
        std::vector<uint8_t> opened(members_.size(), 0);
        for (size_t e = 0; e < sides_.size(); ++e) {
            if (sides_.sides(e).size() == 1) opened[component_[end(e, 0)]] = 1;
            if (!cut_[e]) continue;
            opened[component_[end(e, 0)]] = 1;
            if (sides_.sides(e).size() > 1) out.insert(out.end(), {end(e, 0), end(e, 1)});
        }
        for (size_t c = 0; c < members_.size(); ++c) {
            if (opened[c]) continue;
            const std::vector<uint32_t> path = longPath(mesh_, members_[c]);
            for (size_t i = 0; i + 1 < path.size(); ++i) out.insert(out.end(), {path[i], path[i + 1]});
        }
        return out;
    }

private:
    uint32_t end(size_t e, size_t k) const { return sides_.ends[2 * e + k]; }

    /// Of vertices by edges. Ways start at all border vertices, or at one vertex of a closed component.
    void components()
    {
        UnionFind joined(mesh_.vertexCount());
        std::vector<uint8_t> open(mesh_.vertexCount(), 0), used(mesh_.vertexCount(), 0);
        for (size_t e = 0; e < sides_.size(); ++e) {
            joined.join(end(e, 0), end(e, 1));
            used[end(e, 0)] = used[end(e, 1)] = 1;
        }
        for (size_t e = 0; e < sides_.size(); ++e)
            if (sides_.sides(e).size() == 1) {
                open[joined.root(end(e, 0))] = 1;
                seeds_.push_back(end(e, 0));
                seeds_.push_back(end(e, 1));
            }
        component_.assign(mesh_.vertexCount(), none);
        for (uint32_t v = 0; v < mesh_.vertexCount(); ++v) {
            if (!used[v]) continue;
            const uint32_t root = joined.root(v);  // the lowest vertex, so it comes first
            if (root == v) {
                component_[v] = uint32_t(members_.size());
                members_.emplace_back();
                if (!open[v]) seeds_.push_back(v);
            }
            component_[v] = component_[root];
            members_[component_[v]].push_back(v);
        }
        std::sort(seeds_.begin(), seeds_.end());
        seeds_.erase(std::unique(seeds_.begin(), seeds_.end()), seeds_.end());
    }
    /// Edges of the ways are never crossed; of the others those first that close the longest loops.
    void crossFaces()
    {
        std::vector<std::pair<double, uint32_t>> order;
        for (uint32_t e = 0; e < sides_.size(); ++e) {
            const uint32_t a = end(e, 0), b = end(e, 1);
            if (sides_.sides(e).size() != 2 || distances_.before[a] == b || distances_.before[b] == a) continue;
            order.emplace_back(-(distances_.distance[a] + distances_.distance[b] + length(mesh_, a, b)), e);
        }
        std::sort(order.begin(), order.end());
        UnionFind faces(mesh_.faceCount());
        for (const auto& [loop, e] : order) cut_[e] = !faces.join(faceOf_[sides_.sides(e)[0]], faceOf_[sides_.sides(e)[1]]);
    }
    /// Twigs go: edges with an end that no other cut or border edge has.
    void prune()
    {
        std::vector<uint32_t> degree(mesh_.vertexCount(), 0), ends;
        for (size_t e = 0; e < sides_.size(); ++e)
            if (cut_[e]) ++degree[end(e, 0)], ++degree[end(e, 1)];
        // Edges at each vertex.
        Array<uint32_t> start(mesh_.vertexCount() + 1, 0u), at(2 * sides_.size());
        for (const uint32_t v : sides_.ends) ++start[v + 1];
        for (size_t v = 0; v < mesh_.vertexCount(); ++v) start[v + 1] += start[v];
        Array<uint32_t> cursor(start.begin(), start.end());
        for (size_t i = 0; i < sides_.ends.size(); ++i) at[cursor[sides_.ends[i]]++] = uint32_t(i / 2);
        for (uint32_t v = 0; v < degree.size(); ++v)
            if (degree[v] == 1) ends.push_back(v);
        while (!ends.empty()) {
            const uint32_t v = ends.back();
            ends.pop_back();
            for (uint32_t k = start[v]; k < start[v + 1]; ++k) {
                const uint32_t e = at[k];
                if (!cut_[e]) continue;
                cut_[e] = 0;
                --degree[v];
                const uint32_t w = end(e, 0) == v ? end(e, 1) : end(e, 0);
                if (--degree[w] == 1) ends.push_back(w);
            }
        }
    }

    const Mesh& mesh_;
    EdgeSides sides_;
    Array<uint32_t> faceOf_;
    std::vector<uint8_t> cut_;
    std::vector<uint32_t> seeds_, component_;
    std::vector<std::vector<uint32_t>> members_;
    EdgeDistances distances_;
};

}  // namespace

EdgeDistances edgeDistances(const Mesh& mesh, std::span<const uint32_t> starts, uint32_t target, Progress* progress)
{
    EdgeDistances d{Array<double>(mesh.vertexCount(), unreached), Array<uint32_t>(mesh.vertexCount(), none)};
    using Entry = std::pair<double, uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const uint32_t v : starts) {
        d.distance[v] = 0;
        queue.emplace(0.0, v);
    }
    size_t settled = 0;
    while (!queue.empty()) {
        const auto [far, v] = queue.top();
        queue.pop();
        if (far > d.distance[v]) continue;
        if (progress) progress->at(float(++settled) / float(mesh.vertexCount()));
        if (v == target) break;
        for (const uint32_t w : mesh.rings().neighboursOf(v)) {
            const double there = far + length(mesh, v, w);
            if (there >= d.distance[w]) continue;
            d.distance[w] = there;
            d.before[w] = v;
            queue.emplace(there, w);
        }
    }
    return d;
}

std::vector<uint32_t> edgePath(const Mesh& mesh, uint32_t from, uint32_t to)
{
    const uint32_t start[] = {from};
    const EdgeDistances d = edgeDistances(mesh, start, to);
    if (!(d.distance[to] < unreached)) return {};
    std::vector<uint32_t> path;
    for (uint32_t v = to; v != none; v = d.before[v]) path.push_back(v);
    std::reverse(path.begin(), path.end());
    return path;
}

std::vector<uint32_t> diskCut(const Mesh& mesh)
{
    const TopologyReport& t = mesh.topology();
    if (!t.degenerateFaces.empty() || !t.nonmanifoldEdges.empty())
        throw Error("The mesh cannot be cut to a disk: it has " + std::to_string(t.degenerateFaces.size()) + " degenerate faces and " +
                    std::to_string(t.nonmanifoldEdges.size()) + " edges of more than two faces. Add Repair before it.");
    return DiskCut(mesh).edges();
}

}  // namespace mw
