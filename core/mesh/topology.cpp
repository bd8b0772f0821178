// The topology report. A mesh that is a plain manifold is walked once round every vertex; for any other edges are sorted, then come plain passes
// over flat arrays. No input takes longer than n log n.
#include "core/mesh/topology.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "core/math/hash.h"
#include "core/mesh/connectivity.h"
#include "core/mesh/union_find.h"

namespace mw {

namespace {

/// One phase a function, called in order by run().
class Analysis {
public:
    explicit Analysis(const Mesh& mesh)
        : mesh_(mesh), at_(mesh.cornerVertex().data()), start_(mesh.faceStart().data()), triangles_(mesh.isTriangles()), corners_(mesh)
    {}
    TopologyReport run();

private:
    void countFaces();
    bool walkVertices();
    bool walkVertex(uint32_t first, std::vector<uint32_t>& seenFrom, UnionFind& sets);
    void concludeWalk();
    void sortEdges();
    void classifyEdges();
    void countValences();
    void testOrientability();
    void countFans();
    void countComponents();
    void traceBoundary();
    void findDuplicates();
    void tallyValences();
    void findIsolated();
    void conclude();

    uint32_t next(uint32_t c) const { return corners_.next(c); }
    uint32_t prev(uint32_t c) const { return corners_.previous(c); }
    uint32_t faceOf(uint32_t c) const { return corners_.faceOf(c); }
    bool isLeftOut(size_t f) const { return !degenerate_.empty() && degenerate_[f]; }

    const Mesh& mesh_;
    const uint32_t *at_, *start_;
    const bool triangles_;
    const FaceCorners corners_;
    std::vector<uint8_t> degenerate_;
    Array<uint32_t> opposite_;         // of each corner
    EdgeSides edges_;                  // only where the mesh is no plain manifold
    std::vector<uint32_t> boundary_;   // edges with one face
    std::vector<uint8_t> onBoundary_;  // vertices
    Array<uint32_t> valence_;
    size_t walked_ = 0, joined_ = 0;
    TopologyReport report_;
};

void Analysis::countFaces()
{
    report_.vertices = mesh_.vertexCount();
    report_.faces = mesh_.faceCount();
    std::vector<size_t> sizes(64);
    for (size_t f = 0; f < report_.faces; ++f) {
        const size_t n = start_[f + 1] - start_[f];
        report_.triangles += n < 3 ? 0 : n - 2;
        if (n < sizes.size())
            ++sizes[n];
        else
            ++report_.faceSizes[n];  // rare
        if (isLeftOut(f)) report_.degenerateFaces.push_back(uint32_t(f));
    }
    for (size_t n = 0; n < sizes.size(); ++n)
        if (sizes[n]) report_.faceSizes[n] = sizes[n];
}

/// Round a vertex from one of its corners, through faces that share an edge there. False when a neighbour comes twice: an edge of more than two
/// faces, or of two that run along it the same way.
bool Analysis::walkVertex(uint32_t first, std::vector<uint32_t>& seenFrom, UnionFind& sets)
{
    const uint32_t v = at_[first];
    uint32_t neighbours = 0;
    bool twice = false;
    const auto meet = [&](uint32_t w) {
        twice |= seenFrom[w] == v;
        seenFrom[w] = v;
        ++neighbours;
        if (w < v) joined_ += sets.join(w, v);
    };
    uint32_t c = first, before = first;
    do {
        meet(at_[next(c)]);
        ++walked_;
        before = prev(c);
        c = opposite_[before];
    } while (c != none && c != first);
    if (c == none) {
        onBoundary_[v] = 1;
        meet(at_[before]);
        for (uint32_t d = opposite_[first]; d != none; d = opposite_[c]) {
            c = next(d);
            meet(at_[next(c)]);
            ++walked_;
        }
    }
    valence_[v] = neighbours;
    return !twice;
}

/// True when every vertex has one fan and every edge one or two faces that agree: then all there is to report follows from this one walk.
bool Analysis::walkVertices()
{
    if (!degenerate_.empty()) return false;
    opposite_ = oppositeCornersOf(mesh_);
    const size_t n = mesh_.vertexCount();
    valence_.assign(n, 0);
    onBoundary_.assign(n, 0);
    std::vector<uint32_t> seenFrom(n, none);
    UnionFind sets(n);
    for (uint32_t c = 0; c < mesh_.cornerCount(); ++c)
        if (valence_[at_[c]] == 0 && !walkVertex(c, seenFrom, sets)) return false;
    return walked_ == mesh_.cornerCount();
}

/// The long way, for meshes with edges or vertices that are no surface.
void Analysis::sortEdges()
{
    opposite_ = {};
    edges_ = edgeSidesOf(mesh_, degenerate_);
    classifyEdges();
    countValences();
    testOrientability();
    countFans();
    countComponents();
    traceBoundary();
    findDuplicates();
}

void Analysis::classifyEdges()
{
    report_.edges = edges_.size();
    for (uint32_t e = 0; e < edges_.size(); ++e) {
        const auto sides = edges_.sides(e);
        const TopologyReport::Edge ends(edges_.ends[2 * e], edges_.ends[2 * e + 1]);
        if (sides.size() == 1)
            boundary_.push_back(e);
        else if (sides.size() > 2)
            report_.nonmanifoldEdges.push_back(ends);
        else if (at_[sides[0]] == at_[sides[1]])
            report_.inconsistentEdges.push_back(ends);
    }
    report_.boundaryEdges = boundary_.size();
    report_.consistentlyOriented = report_.inconsistentEdges.empty();
}

void Analysis::countValences()
{
    valence_.assign(mesh_.vertexCount(), 0);
    for (const uint32_t v : edges_.ends) ++valence_[v];
    onBoundary_.assign(mesh_.vertexCount(), 0);
    for (const uint32_t e : boundary_) onBoundary_[edges_.ends[2 * e]] = onBoundary_[edges_.ends[2 * e + 1]] = 1;
}

void Analysis::tallyValences()
{
    const uint32_t inner = triangles_ ? 6 : 4, outer = triangles_ ? 4 : 3;
    std::vector<size_t> count(valence_.empty() ? 0 : *std::max_element(valence_.begin(), valence_.end()) + 1);
    for (size_t v = 0; v < valence_.size(); ++v) {
        ++count[valence_[v]];
        report_.regularVertices += valence_[v] == (onBoundary_[v] ? outer : inner);
    }
    for (size_t n = 0; n < count.size(); ++n)
        if (count[n]) report_.vertexValences[n] = count[n];
}

/// Each edge of two faces says whether one of them must be turned over. Orientable unless these wishes contradict each other.
void Analysis::testOrientability()
{
    if (report_.consistentlyOriented) return;
    ParityUnionFind sets(mesh_.faceCount());
    for (uint32_t e = 0; e < edges_.size() && report_.orientable; ++e) {
        const auto sides = edges_.sides(e);
        if (sides.size() == 2) report_.orientable = sets.join(faceOf(sides[0]), faceOf(sides[1]), at_[sides[0]] == at_[sides[1]]);
    }
}

/// Corners at a vertex whose faces share an edge there are one fan. A vertex starts with as many fans as corners; each union takes one away.
void Analysis::countFans()
{
    Array<uint32_t> fans(mesh_.vertexCount(), 0);
    for (size_t f = 0; f < mesh_.faceCount(); ++f)
        if (!isLeftOut(f))
            for (uint32_t c = start_[f]; c < start_[f + 1]; ++c) ++fans[at_[c]];
    UnionFind sets(mesh_.cornerCount());
    for (size_t e = 0; e < edges_.size(); ++e) {
        const auto sides = edges_.sides(e);
        for (size_t i = 1; i < sides.size(); ++i) {
            const uint32_t c = sides[0], d = sides[i];
            const bool same = at_[c] == at_[d];
            fans[at_[c]] -= sets.join(c, same ? d : next(d));
            fans[at_[next(c)]] -= sets.join(next(c), same ? next(d) : d);
        }
    }
    for (uint32_t v = 0; v < fans.size(); ++v)
        if (fans[v] > 1) report_.nonmanifoldVertices.push_back(v);
}

/// Faces with a common vertex belong together, so the components are those of vertices joined by edges.
void Analysis::countComponents()
{
    UnionFind sets(mesh_.vertexCount());
    size_t joined = 0, used = 0;
    for (size_t e = 0; e < edges_.size(); ++e) joined += sets.join(edges_.ends[2 * e], edges_.ends[2 * e + 1]);
    for (const uint32_t n : valence_) used += n > 0;
    report_.components = used - joined;
}

/// The graph of boundary edges, on its own small numbering: boundary vertices in ascending order.
class BoundaryGraph {
public:
    void addDirected(uint32_t from, uint32_t to) { arcs_.emplace_back(from, to); }
    std::vector<std::vector<uint32_t>> components();

private:
    void build();
    std::vector<uint32_t> collect(uint32_t first);
    std::vector<uint32_t> walk(uint32_t first, size_t length) const;

    std::vector<std::pair<uint32_t, uint32_t>> arcs_;
    std::vector<uint32_t> vertex_, start_, neighbour_, ahead_;
    std::vector<uint8_t> seen_;
};

void BoundaryGraph::build()
{
    for (const auto& [a, b] : arcs_) {
        vertex_.push_back(a);
        vertex_.push_back(b);
    }
    std::sort(vertex_.begin(), vertex_.end());
    vertex_.erase(std::unique(vertex_.begin(), vertex_.end()), vertex_.end());
    for (auto& [a, b] : arcs_) {
        a = uint32_t(std::lower_bound(vertex_.begin(), vertex_.end(), a) - vertex_.begin());
        b = uint32_t(std::lower_bound(vertex_.begin(), vertex_.end(), b) - vertex_.begin());
    }
    start_.assign(vertex_.size() + 2, 0);
    for (const auto& [a, b] : arcs_) {
        ++start_[a + 2];
        ++start_[b + 2];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    neighbour_.resize(2 * arcs_.size());
    ahead_.assign(vertex_.size(), none);
    for (const auto& [a, b] : arcs_) {
        neighbour_[start_[a + 1]++] = b;
        neighbour_[start_[b + 1]++] = a;
        ahead_[a] = std::min(ahead_[a], b);
    }
    seen_.assign(vertex_.size(), 0);
}

std::vector<uint32_t> BoundaryGraph::collect(uint32_t first)
{
    std::vector<uint32_t> found{first};
    seen_[first] = 1;
    for (size_t i = 0; i < found.size(); ++i)
        for (uint32_t k = start_[found[i]]; k < start_[found[i] + 1]; ++k)
            if (!seen_[neighbour_[k]]) {
                seen_[neighbour_[k]] = 1;
                found.push_back(neighbour_[k]);
            }
    return found;
}

/// Round a simple loop, in the direction in which its half-edges run (the hole on the left), if they agree.
std::vector<uint32_t> BoundaryGraph::walk(uint32_t first, size_t length) const
{
    std::vector<uint32_t> loop{first};
    uint32_t last = first, v = ahead_[first] == none ? neighbour_[start_[first]] : ahead_[first];
    while (loop.size() < length) {
        loop.push_back(v);
        const uint32_t a = neighbour_[start_[v]], b = neighbour_[start_[v] + 1];
        const uint32_t ahead = a == last ? b : a;
        last = v;
        v = ahead;
    }
    return loop;
}

std::vector<std::vector<uint32_t>> BoundaryGraph::components()
{
    build();
    std::vector<std::vector<uint32_t>> out;
    for (uint32_t v = 0; v < vertex_.size(); ++v) {
        if (seen_[v]) continue;
        std::vector<uint32_t> found = collect(v);
        const bool simple = std::all_of(found.begin(), found.end(), [&](uint32_t w) { return start_[w + 1] - start_[w] == 2; });
        if (simple)
            found = walk(v, found.size());
        else
            std::sort(found.begin(), found.end());
        for (uint32_t& w : found) w = vertex_[w];
        out.push_back(std::move(found));
    }
    return out;
}

void Analysis::traceBoundary()
{
    BoundaryGraph graph;
    for (const uint32_t e : boundary_) {
        const uint32_t c = edges_.sides(e)[0];
        graph.addDirected(at_[next(c)], at_[c]);  // against the face
    }
    report_.boundaryLoops = graph.components();
}

void Analysis::concludeWalk()
{
    BoundaryGraph graph;
    bool doubled = !triangles_;  // two triangles with the same vertices share all their edges; larger faces need a closer look
    for (uint32_t c = 0; c < mesh_.cornerCount(); ++c) {
        if (opposite_[c] == none) {
            graph.addDirected(at_[next(c)], at_[c]);  // against the face
            ++report_.boundaryEdges;
        } else if (triangles_ && c % 3 == 0 && opposite_[c + 1] != none && opposite_[c] / 3 == opposite_[c + 1] / 3) {
            doubled = doubled || (opposite_[c + 2] != none && opposite_[c + 2] / 3 == opposite_[c] / 3);
        }
    }
    report_.edges = (mesh_.cornerCount() + report_.boundaryEdges) / 2;
    report_.boundaryLoops = graph.components();
    if (doubled) findDuplicates();
    size_t used = 0;
    for (const uint32_t k : valence_) used += k > 0;
    report_.components = used - joined_;
}

/// The vertices of a face, each once, ascending.
void vertexSet(std::span<const uint32_t> face, std::vector<uint32_t>& set)
{
    set.assign(face.begin(), face.end());
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
}

struct FaceKey {
    uint64_t key;
    uint32_t lowest, face;
};

/// Equal sets give equal keys. Triangles: exact, made without sorting.
FaceKey keyOf(std::span<const uint32_t> face, uint32_t f, std::vector<uint32_t>& set)
{
    if (face.size() == 3 && face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) {
        const uint32_t low = std::min({face[0], face[1], face[2]}), high = std::max({face[0], face[1], face[2]});
        return {uint64_t(face[0] ^ face[1] ^ face[2] ^ low ^ high) << 32 | high, low, f};
    }
    vertexSet(face, set);
    if (set.size() == 3) return {uint64_t(set[1]) << 32 | set[2], set[0], f};
    Hasher h;
    h.array(std::span<const uint32_t>(set));
    return {h.value(), set[0], f};
}

void Analysis::findDuplicates()
{
    // By lowest vertex first (counting), then by key within the few faces there.
    const size_t n = mesh_.faceCount();
    Array<FaceKey> keys(n), sorted(n);
    Array<uint32_t> start(mesh_.vertexCount() + 2, 0);
    std::vector<uint32_t> set, other;
    size_t count = 0;
    for (size_t f = 0; f < n; ++f) {
        if (mesh_.face(f).empty()) continue;
        keys[count] = keyOf(mesh_.face(f), uint32_t(f), set);
        ++start[keys[count++].lowest + 2];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (size_t i = 0; i < count; ++i) sorted[start[keys[i].lowest + 1]++] = keys[i];
    for (size_t v = 0; v < mesh_.vertexCount(); ++v) {
        FaceKey *first = sorted.data() + start[v], *last = sorted.data() + start[v + 1];
        if (last - first < 2) continue;
        std::sort(first, last, [](const FaceKey& a, const FaceKey& b) { return a.key != b.key ? a.key < b.key : a.face < b.face; });
        for (FaceKey *i = first + 1, *run = first; i != last; ++i) {
            if (i->key != run->key) {
                run = i;
                continue;
            }
            vertexSet(mesh_.face(run->face), set);
            vertexSet(mesh_.face(i->face), other);
            if (set == other) report_.duplicateFaces.push_back(i->face);
        }
    }
    std::sort(report_.duplicateFaces.begin(), report_.duplicateFaces.end());
}

void Analysis::findIsolated()
{
    std::vector<uint8_t> used(mesh_.vertexCount(), 0);
    for (const uint32_t v : mesh_.cornerVertex()) used[v] = 1;
    for (uint32_t v = 0; v < used.size(); ++v)
        if (!used[v]) report_.isolatedVertices.push_back(v);
}

void Analysis::conclude()
{
    const size_t faces = report_.faces - report_.degenerateFaces.size();
    const size_t used = size_t(std::count_if(valence_.begin(), valence_.end(), [](uint32_t n) { return n > 0; }));
    report_.euler = long(used) - long(report_.edges) + long(faces);
    report_.closed = faces > 0 && report_.boundaryEdges == 0;
    if (faces > 0 && report_.manifold() && report_.orientable && report_.degenerateFaces.empty())
        report_.genus = (2 * long(report_.components) - long(report_.boundaryLoops.size()) - report_.euler) / 2;
}

TopologyReport Analysis::run()
{
    degenerate_ = degenerateFacesOf(mesh_);
    countFaces();
    if (walkVertices())
        concludeWalk();
    else
        sortEdges();
    tallyValences();
    findIsolated();
    conclude();
    return std::move(report_);
}

}  // namespace

TopologyReport topologyOf(const Mesh& mesh)
{
    return Analysis(mesh).run();
}

double surfaceArea(const Mesh& mesh)
{
    const auto& p = mesh.positions();
    const auto& t = mesh.triangulation().vertices;
    double sum = 0;
    for (size_t i = 0; i + 2 < t.size(); i += 3) {
        const glm::dvec3 a(p[t[i]]), b(p[t[i + 1]]), c(p[t[i + 2]]);
        sum += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return sum;
}

double enclosedVolume(const Mesh& mesh)
{
    const auto& p = mesh.positions();
    const auto& t = mesh.triangulation().vertices;
    const glm::dvec3 centre = mesh.bounds().centre();  // near the surface: less is lost in the sum than from a far origin
    double sum = 0;
    for (size_t i = 0; i + 2 < t.size(); i += 3) {
        const glm::dvec3 a = glm::dvec3(p[t[i]]) - centre, b = glm::dvec3(p[t[i + 1]]) - centre, c = glm::dvec3(p[t[i + 2]]) - centre;
        sum += glm::dot(a, glm::cross(b, c)) / 6;
    }
    return sum;
}

}  // namespace mw
