#include "core/mesh/reorder.h"

#include <algorithm>
#include <numeric>

#include "core/mesh/rings.h"

namespace mw {

namespace {

/// New numbers of vertices and faces, as lists of the old ones.
struct Order {
    Array<uint32_t> vertices, faces;
};

class VertexList {
public:
    explicit VertexList(size_t n) : listed_(n, 0) { list_.reserve(n); }
    bool add(uint32_t v)
    {
        if (listed_[v]) return false;
        listed_[v] = 1;
        list_.push_back(v);
        return true;
    }
    const Array<uint32_t>& list() const { return list_; }
    /// With all that were not listed, ascending.
    Array<uint32_t> whole()
    {
        for (uint32_t v = 0; v < listed_.size(); ++v) add(v);
        return std::move(list_);
    }

private:
    std::vector<uint8_t> listed_;
    Array<uint32_t> list_;
};

Order firstUse(const Mesh& mesh)
{
    VertexList vertices(mesh.vertexCount());
    for (const uint32_t v : mesh.cornerVertex()) vertices.add(v);
    Order order{vertices.whole(), Array<uint32_t>(mesh.faceCount())};
    std::iota(order.faces.begin(), order.faces.end(), 0u);
    return order;
}

/// Faces by the lowest new number among their vertices (counting sort, stable).
Array<uint32_t> byLowestVertex(const Mesh& mesh, const Array<uint32_t>& vertices)
{
    Array<uint32_t> rank(vertices.size()), lowest(mesh.faceCount()), start(vertices.size() + 2, 0u), faces(mesh.faceCount());
    for (uint32_t i = 0; i < vertices.size(); ++i) rank[vertices[i]] = i;
    for (size_t f = 0; f < faces.size(); ++f) {
        uint32_t low = uint32_t(vertices.size());  // of a face without corners: after all others
        for (const uint32_t v : mesh.face(f)) low = std::min(low, rank[v]);
        lowest[f] = low;
        ++start[low + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (uint32_t f = 0; f < faces.size(); ++f) faces[start[lowest[f]]++] = f;
    return faces;
}

Order breadthFirst(const Mesh& mesh)
{
    const Rings& rings = mesh.rings();
    VertexList vertices(mesh.vertexCount());
    size_t next = 0;
    for (uint32_t seed = 0; seed < mesh.vertexCount(); ++seed) {
        if (rings.cornersOf(seed).empty() || !vertices.add(seed)) continue;
        for (; next < vertices.list().size(); ++next)
            for (const uint32_t w : rings.neighboursOf(vertices.list()[next])) vertices.add(w);
    }
    Array<uint32_t> list = vertices.whole();
    Array<uint32_t> faces = byLowestVertex(mesh, list);
    return {std::move(list), std::move(faces)};
}

Mesh inOrder(const Mesh& mesh, const Order& order)
{
    Array<uint32_t> rank(order.vertices.size()), start(mesh.faceCount() + 1, 0u), corners(mesh.cornerCount()), oldCorner(mesh.cornerCount());
    Array<glm::vec3> positions(order.vertices.size());
    for (uint32_t i = 0; i < order.vertices.size(); ++i) {
        rank[order.vertices[i]] = i;
        positions[i] = mesh.positions()[order.vertices[i]];
    }
    uint32_t c = 0;
    for (size_t f = 0; f < order.faces.size(); ++f) {
        const uint32_t first = mesh.faceStart()[order.faces[f]], end = mesh.faceStart()[order.faces[f] + 1];
        for (uint32_t old = first; old < end; ++old, ++c) {
            corners[c] = rank[mesh.cornerVertex()[old]];
            oldCorner[c] = old;
        }
        start[f + 1] = c;
    }
    Mesh out(std::move(positions), std::move(start), std::move(corners));
    if (!mesh.lines().empty()) {
        Array<uint32_t> lines(mesh.lines().begin(), mesh.lines().end());
        for (uint32_t& v : lines) v = rank[v];
        out = out.withLines(std::move(lines));
    }
    for (const Attribute& a : mesh.attributes())
        out = out.with(gathered(a, a.domain == Domain::Vertex ? order.vertices : a.domain == Domain::Corner ? oldCorner : order.faces));
    return out.withGroupNames(mesh.groupNames());
}

}  // namespace

double scatterOf(const Mesh& mesh)
{
    constexpr size_t run = 1024, verticesALine = 16;
    const size_t faces = mesh.faceCount();
    if (faces < 4 * run) return 0;
    std::vector<uint32_t> lines;
    size_t touched = 0, looked = 0;
    const size_t step = std::max(run, faces / 16);
    for (size_t first = 0; first + run <= faces; first += step) {
        lines.clear();
        for (uint32_t c = mesh.faceStart()[first]; c < mesh.faceStart()[first + run]; ++c)
            lines.push_back(uint32_t(mesh.cornerVertex()[c] / verticesALine));
        std::sort(lines.begin(), lines.end());
        touched += size_t(std::unique(lines.begin(), lines.end()) - lines.begin());
        looked += run;
    }
    return double(touched) / double(looked);
}

Generator reorder(Mesh input, Reorder parameters, Stage<Mesh>& stage)
{
    stage.show([&input] { return input; });
    Reorder::Method method = parameters.method;
    if (method == Reorder::Method::Automatic) {
        if (scatterOf(input) <= mostScatterInOrder) {
            stage.finish(input);
            co_return;
        }
        // Whether the faces are in order under shuffled vertices, only a trial tells.
        method = scatterOf(inOrder(input, firstUse(input))) > mostScatterInOrder ? Reorder::Method::BreadthFirst : Reorder::Method::FirstUse;
    }
    co_yield Step("order").progress(0.1);
    const Order order = method == Reorder::Method::FirstUse ? firstUse(input) : breadthFirst(input);
    co_yield Step("gather").progress(0.6);
    stage.finish(inOrder(input, order));
}

}  // namespace mw
