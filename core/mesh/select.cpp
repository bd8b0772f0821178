// Sets of elements: set operations, conversion, growth. What walks or measures is in select_walk.cpp.
#include "core/mesh/select.h"

#include <algorithm>

#include "core/mesh/connectivity.h"
#include "core/mesh/select_masks.h"
#include "core/mesh/union_find.h"

namespace mw {

using namespace select;

namespace {

// Keys sort like elements: an index, or the two of an edge.
using Keys = std::vector<uint64_t>;

Keys keysOf(const ElementSet& s)
{
    Keys keys;
    if (s.kind == ElementKind::Edge) {
        keys.reserve(s.indices.size() / 2);
        for (size_t i = 0; i + 1 < s.indices.size(); i += 2) keys.push_back(uint64_t(s.indices[i]) << 32 | s.indices[i + 1]);
    } else {
        keys.assign(s.indices.begin(), s.indices.end());
    }
    return keys;
}

ElementSet setOf(ElementKind kind, const Keys& keys)
{
    ElementSet s{kind, {}};
    s.indices.reserve(keys.size() * (kind == ElementKind::Edge ? 2 : 1));
    for (const uint64_t k : keys) {
        if (kind == ElementKind::Edge) s.indices.push_back(uint32_t(k >> 32));
        s.indices.push_back(uint32_t(k));
    }
    return s;
}

template <class Operation>
ElementSet combined(const ElementSet& a, const ElementSet& b, const Operation& operation)
{
    const Keys x = keysOf(a), y = keysOf(b);
    Keys out;
    out.reserve(x.size() + y.size());
    operation(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(out));
    return setOf(a.kind, out);
}

// Many indices of a small range are ticked off in a mask instead of being sorted.
std::vector<uint32_t> sortedIndices(std::vector<uint32_t> indices)
{
    const auto ordered = [](uint32_t a, uint32_t b) { return a >= b; };
    if (std::adjacent_find(indices.begin(), indices.end(), ordered) == indices.end()) return indices;
    const uint32_t most = *std::max_element(indices.begin(), indices.end());
    if (most / 16 < indices.size()) {
        Mask mask(size_t(most) + 1, 0);
        for (const uint32_t i : indices) mask[i] = 1;
        return ticked(mask);
    }
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return indices;
}

// By lower vertex in one pass, then few at each vertex.
void sortEdges(Keys& keys)
{
    uint32_t most = 0;
    for (const uint64_t k : keys) most = std::max(most, uint32_t(k >> 32));
    if (most / 16 >= keys.size()) return std::sort(keys.begin(), keys.end());
    std::vector<uint32_t> start(size_t(most) + 3, 0);
    for (const uint64_t k : keys) ++start[(k >> 32) + 2];
    for (size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    Keys out(keys.size());
    for (const uint64_t k : keys) out[start[(k >> 32) + 1]++] = k;
    for (size_t v = 0; v + 1 < start.size(); ++v) std::sort(out.begin() + start[v], out.begin() + start[v + 1]);
    keys.swap(out);
}

Mask vertexMask(const Mesh& mesh, const ElementSet& s)
{
    Mask mask(mesh.vertexCount(), 0);
    if (s.kind != ElementKind::Face) {
        for (const uint32_t v : s.indices)
            if (v < mask.size()) mask[v] = 1;
        return mask;
    }
    for (const uint32_t f : s.indices)
        if (f < mesh.faceCount())
            for (const uint32_t v : mesh.face(f)) mask[v] = 1;
    return mask;
}

/// Faces of which test(vertices of the face) holds.
template <class Test>
ElementSet facesWhere(const Mesh& mesh, const Test& test)
{
    ElementSet out{ElementKind::Face, {}};
    for (uint32_t f = 0; f < mesh.faceCount(); ++f)
        if (test(mesh.face(f))) out.indices.push_back(f);
    return out;
}

template <class Test>
ElementSet edgesWhere(const Mesh& mesh, const Test& test)
{
    ElementSet out{ElementKind::Edge, {}};
    const Shared<uint32_t>& edges = mesh.edges();
    for (size_t i = 0; i + 1 < edges.size(); i += 2)
        if (test(edges[i], edges[i + 1])) {
            out.indices.push_back(edges[i]);
            out.indices.push_back(edges[i + 1]);
        }
    return sorted(std::move(out));
}

ElementSet edgesOfFaces(const Mesh& mesh, const ElementSet& faces)
{
    ElementSet out{ElementKind::Edge, {}};
    for (const uint32_t f : faces.indices) {
        if (f >= mesh.faceCount()) continue;
        const auto v = mesh.face(f);
        for (size_t i = 0; i < v.size(); ++i) {
            out.indices.push_back(v[i]);
            out.indices.push_back(v[(i + 1) % v.size()]);
        }
    }
    return sorted(std::move(out));
}

// Faces with all their sides in the set.
ElementSet facesOfEdges(const Mesh& mesh, const ElementSet& edges)
{
    const Keys keys = keysOf(edges);
    const auto has = [&](uint32_t a, uint32_t b) {
        return std::binary_search(keys.begin(), keys.end(), uint64_t(std::min(a, b)) << 32 | std::max(a, b));
    };
    const Mask touched = vertexMask(mesh, edges);
    return facesWhere(mesh, [&](std::span<const uint32_t> v) {
        for (const uint32_t i : v)
            if (!touched[i]) return false;
        for (size_t i = 0; i < v.size(); ++i)
            if (!has(v[i], v[(i + 1) % v.size()])) return false;
        return !v.empty();
    });
}

ElementSet withVertices(const Mesh& mesh, const Mask& mask, ElementKind kind, bool all)
{
    if (kind == ElementKind::Vertex) return {kind, ticked(mask)};
    if (kind == ElementKind::Edge) return edgesWhere(mesh, [&](uint32_t a, uint32_t b) { return all ? mask[a] && mask[b] : mask[a] || mask[b]; });
    const auto in = [&](uint32_t v) { return mask[v] != 0; };
    return facesWhere(mesh, [&](std::span<const uint32_t> v) {
        return !v.empty() && (all ? std::all_of(v.begin(), v.end(), in) : std::any_of(v.begin(), v.end(), in));
    });
}

// Vertices joined by sides of faces.
UnionFind joinedVertices(const Mesh& mesh)
{
    UnionFind sets(mesh.vertexCount());
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto v = mesh.face(f);
        for (size_t i = 1; i < v.size(); ++i) sets.join(v[0], v[i]);
    }
    return sets;
}

}  // namespace

ElementSet sorted(ElementSet s)
{
    if (s.kind != ElementKind::Edge) return {s.kind, sortedIndices(std::move(s.indices))};
    Keys keys;
    keys.reserve(s.indices.size() / 2);
    for (size_t i = 0; i + 1 < s.indices.size(); i += 2) {
        const auto [a, b] = std::minmax(s.indices[i], s.indices[i + 1]);
        if (a != b) keys.push_back(uint64_t(a) << 32 | b);
    }
    if (!std::is_sorted(keys.begin(), keys.end())) sortEdges(keys);
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return setOf(s.kind, keys);
}

size_t countOf(const ElementSet& s)
{
    return s.kind == ElementKind::Edge ? s.indices.size() / 2 : s.indices.size();
}

ElementSet united(const ElementSet& a, const ElementSet& b)
{
    return combined(a, b, [](auto... i) { std::set_union(i...); });
}

ElementSet without(const ElementSet& a, const ElementSet& b)
{
    return combined(a, b, [](auto... i) { std::set_difference(i...); });
}

ElementSet toggled(const ElementSet& a, const ElementSet& b)
{
    return combined(a, b, [](auto... i) { std::set_symmetric_difference(i...); });
}

ElementSet allElements(const Mesh& mesh, ElementKind kind)
{
    if (kind == ElementKind::Edge) return edgesWhere(mesh, [](uint32_t, uint32_t) { return true; });
    ElementSet out{kind, std::vector<uint32_t>(kind == ElementKind::Vertex ? mesh.vertexCount() : mesh.faceCount())};
    for (uint32_t i = 0; i < out.indices.size(); ++i) out.indices[i] = i;
    return out;
}

ElementSet inverted(const Mesh& mesh, const ElementSet& set)
{
    if (set.kind == ElementKind::Edge) return without(allElements(mesh, set.kind), set);
    Mask mask(set.kind == ElementKind::Vertex ? mesh.vertexCount() : mesh.faceCount(), 1);
    for (const uint32_t i : set.indices)
        if (i < mask.size()) mask[i] = 0;
    return {set.kind, ticked(mask)};
}

ElementSet converted(const Mesh& mesh, const ElementSet& set, ElementKind kind, bool touching)
{
    if (kind == set.kind) return set;
    if (set.kind == ElementKind::Face && kind == ElementKind::Edge) return edgesOfFaces(mesh, set);
    if (set.kind == ElementKind::Edge && kind == ElementKind::Face && !touching) return facesOfEdges(mesh, set);
    if (kind == ElementKind::Face && set.kind == ElementKind::Edge) {  // one side of it, not one vertex
        const Keys keys = keysOf(set);
        const Mask touched = vertexMask(mesh, set);
        return facesWhere(mesh, [&](std::span<const uint32_t> v) {
            for (size_t i = 0; i < v.size(); ++i) {
                const auto [a, b] = std::minmax(v[i], v[(i + 1) % v.size()]);
                if (touched[a] && touched[b] && std::binary_search(keys.begin(), keys.end(), uint64_t(a) << 32 | b)) return true;
            }
            return false;
        });
    }
    return withVertices(mesh, vertexMask(mesh, set), kind, !touching);
}

ElementSet grown(const Mesh& mesh, const ElementSet& set)
{
    const Mask mask = vertexMask(mesh, set);
    if (set.kind != ElementKind::Vertex) return withVertices(mesh, mask, set.kind, false);
    Mask next = mask;
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto v = mesh.face(f);
        for (size_t i = 0; i < v.size(); ++i) {
            const uint32_t a = v[i], b = v[(i + 1) % v.size()];
            next[a] |= mask[b];
            next[b] |= mask[a];
        }
    }
    return {set.kind, ticked(next)};
}

ElementSet shrunk(const Mesh& mesh, const ElementSet& set)
{
    return inverted(mesh, grown(mesh, inverted(mesh, set)));
}

ElementSet connected(const Mesh& mesh, const ElementSet& set)
{
    UnionFind sets = joinedVertices(mesh);
    const Mask seeds = vertexMask(mesh, set);
    Mask roots(seeds.size(), 0), mask(seeds.size(), 0);
    for (uint32_t v = 0; v < seeds.size(); ++v)
        if (seeds[v]) roots[sets.root(v)] = 1;
    for (uint32_t v = 0; v < seeds.size(); ++v) mask[v] = roots[sets.root(v)];
    return withVertices(mesh, mask, set.kind, true);
}

ElementSet component(const Mesh& mesh, ElementKind kind, size_t rank)
{
    UnionFind sets = joinedVertices(mesh);
    std::vector<uint32_t> faces(mesh.vertexCount(), 0), roots;
    for (size_t f = 0; f < mesh.faceCount(); ++f)
        if (!mesh.face(f).empty()) ++faces[sets.root(mesh.face(f)[0])];
    for (uint32_t v = 0; v < faces.size(); ++v)
        if (faces[v] > 0) roots.push_back(v);
    if (rank >= roots.size()) return {kind, {}};
    std::stable_sort(roots.begin(), roots.end(), [&](uint32_t a, uint32_t b) { return faces[a] > faces[b]; });
    return converted(mesh, connected(mesh, {ElementKind::Vertex, {roots[rank]}}), kind);
}

}  // namespace mw
