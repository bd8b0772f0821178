#include "core/io/gltf_split.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace mw {

GltfSplitter::GltfSplitter(const Mesh& mesh, const std::vector<GltfSource>& sources) : pointOf_(mesh.vertexCount(), none)
{
    for (const GltfSource& s : sources)
        if (s.domain == Domain::Corner) atCorners_.push_back(&s);
}

GltfSplit GltfSplitter::split(std::span<const uint32_t> vertices, std::span<const uint32_t> corners)
{
    GltfSplit s;
    s.sequence.resize(vertices.size());
    if (atCorners_.empty() || corners.empty())
        byVertex(s, vertices, corners);
    else
        byContent(s, vertices, corners);
    // In the order of vertices, so that what is read back is numbered as it was.
    const size_t n = s.vertex.size();
    std::vector<uint64_t> order(n);
    for (size_t i = 0; i < n; ++i) order[i] = uint64_t(s.vertex[i]) << 32 | i;
    std::sort(order.begin(), order.end());
    GltfSplit sorted{Array<uint32_t>(n), Array<uint32_t>(n), std::move(s.sequence)};
    Array<uint32_t> place(n);
    for (size_t i = 0; i < n; ++i) {
        const uint32_t from = uint32_t(order[i]);
        place[from] = uint32_t(i);
        sorted.vertex[i] = s.vertex[from];
        sorted.corner[i] = s.corner[from];
    }
    for (uint32_t& p : sorted.sequence) p = place[p];
    return sorted;
}

void GltfSplitter::byVertex(GltfSplit& s, std::span<const uint32_t> vertices, std::span<const uint32_t> corners)
{
    for (size_t i = 0; i < vertices.size(); ++i) {
        uint32_t& point = pointOf_[vertices[i]];
        if (point == none) {
            point = uint32_t(s.vertex.size());
            s.vertex.push_back(vertices[i]);
            s.corner.push_back(corners.empty() ? none : corners[i]);
        }
        s.sequence[i] = point;
    }
    for (const uint32_t v : s.vertex) pointOf_[v] = none;
}

void GltfSplitter::byContent(GltfSplit& s, std::span<const uint32_t> vertices, std::span<const uint32_t> corners)
{
    const auto hash = [&](size_t i) {
        uint64_t h = (uint64_t(vertices[i]) + 1) * 0x9E3779B97F4A7C15u;
        for (const GltfSource* a : atCorners_)
            for (int k = 0; k < a->components; ++k) {
                h = (h ^ std::bit_cast<uint32_t>(a->values[size_t(corners[i]) * size_t(a->components) + size_t(k)])) * 0xFF51AFD7ED558CCDu;
                h ^= h >> 32;
            }
        return size_t(h);
    };
    const auto same = [&](uint32_t point, size_t i) {
        if (s.vertex[point] != vertices[i]) return false;
        for (const GltfSource* a : atCorners_) {
            const size_t n = size_t(a->components);
            if (std::memcmp(a->values.data() + s.corner[point] * n, a->values.data() + corners[i] * n, 4 * n) != 0) return false;
        }
        return true;
    };
    const size_t mask = std::bit_ceil(std::max<size_t>(vertices.size() + vertices.size() / 2, 16)) - 1;
    Array<uint32_t> table(mask + 1, none);
    for (size_t i = 0; i < vertices.size(); ++i) {
        size_t at = hash(i) & mask;
        while (table[at] != none && !same(table[at], i)) at = (at + 1) & mask;
        if (table[at] == none) {
            table[at] = uint32_t(s.vertex.size());
            s.vertex.push_back(vertices[i]);
            s.corner.push_back(corners[i]);
        }
        s.sequence[i] = table[at];
    }
}

}  // namespace mw
