#include "core/io/gltf_points.h"

#include <bit>
#include <cstring>

namespace mw {

namespace {

// Rows of bytes that must be equal for two points to be one vertex.
struct Rows {
    const unsigned char* data;
    size_t size;
};

std::vector<Rows> vertexRows(const GltfPoints& points)
{
    std::vector<Rows> rows{{reinterpret_cast<const unsigned char*>(points.positions.data()), sizeof(glm::vec3)}};
    for (const GltfStream& s : points.streams)
        if (s.ofVertex)
            rows.push_back(
                {s.integral ? reinterpret_cast<const unsigned char*>(s.integers.data()) : reinterpret_cast<const unsigned char*>(s.floats.data()),
                 size_t(s.components) * 4});
    return rows;
}

uint32_t hashOf(const std::vector<Rows>& rows, size_t point)
{
    uint64_t h = 0x9E3779B97F4A7C15u;
    for (const Rows& r : rows)
        for (size_t at = 0; at < r.size; at += 4) {
            uint32_t x;
            std::memcpy(&x, r.data + point * r.size + at, 4);
            h = (h ^ x) * 0xFF51AFD7ED558CCDu;
            h ^= h >> 32;
        }
    return uint32_t(h);
}

bool same(const std::vector<Rows>& rows, size_t a, size_t b)
{
    return std::all_of(rows.begin(), rows.end(), [&](const Rows& r) { return std::memcmp(r.data + a * r.size, r.data + b * r.size, r.size) == 0; });
}

template <class T>
Array<T> picked(const Array<T>& from, size_t components, const Array<uint32_t>& rows)
{
    Array<T> out(rows.size() * components);
    for (size_t i = 0; i < rows.size(); ++i) std::copy_n(from.data() + rows[i] * components, components, out.data() + i * components);
    return out;
}

Attribute attributeOf(const GltfStream& s, Domain domain, const Array<uint32_t>& rows)
{
    Attribute a = s.integral ? integerAttribute(s.name, domain, s.components, picked(s.integers, size_t(s.components), rows))
                             : floatAttribute(s.name, domain, s.components, picked(s.floats, size_t(s.components), rows));
    a.stored = s.stored;
    return a;
}

}  // namespace

Array<uint32_t> weldedPoints(const GltfPoints& points, Array<uint32_t>& representative)
{
    const size_t n = points.positions.size();
    Array<uint32_t> vertexOf(n);
    representative.clear();
    representative.reserve(n);
    const auto fresh = [&](size_t p) {
        vertexOf[p] = uint32_t(representative.size());
        representative.push_back(uint32_t(p));
    };
    if (points.corners.empty()) {
        for (size_t p = 0; p < n; ++p) fresh(p);
        return vertexOf;
    }
    const std::vector<Rows> rows = vertexRows(points);
    const size_t mask = std::bit_ceil(std::max<size_t>(2 * n, 16)) - 1;
    Array<uint32_t> table(mask + 1, none);  // of vertices
    auto range = points.apart.begin();
    for (size_t p = 0; p < n; ++p) {
        while (range != points.apart.end() && p >= range->second) ++range;
        if (range != points.apart.end() && p >= range->first) {
            fresh(p);
            continue;
        }
        size_t at = hashOf(rows, p) & mask;
        while (table[at] != none && !same(rows, representative[table[at]], p)) at = (at + 1) & mask;
        if (table[at] == none) {
            fresh(p);
            table[at] = vertexOf[p];
        } else {
            vertexOf[p] = table[at];
        }
    }
    return vertexOf;
}

Mesh meshOf(GltfPoints points, GltfDocument& document, const std::string& pointer)
{
    size_t cornerBytes = 8, vertexBytes = 24;
    for (const GltfStream& s : points.streams) (s.ofVertex ? vertexBytes : cornerBytes) += size_t(s.components) * 4;
    document.charge(points.corners.size() * cornerBytes + points.positions.size() * vertexBytes, pointer);
    Array<uint32_t> representative;
    const Array<uint32_t> vertexOf = weldedPoints(points, representative);
    const auto vertices = [&](const Array<uint32_t>& of) {
        Array<uint32_t> out(of.size());
        for (size_t i = 0; i < of.size(); ++i) out[i] = vertexOf[of[i]];
        return out;
    };
    Mesh mesh = Mesh::triangles(picked(points.positions, 1, representative), vertices(points.corners));
    if (!points.lines.empty()) mesh = mesh.withLines(vertices(points.lines));
    const bool faces = !points.corners.empty();
    for (GltfStream& s : points.streams) {
        mesh = s.ofVertex || !faces ? mesh.with(attributeOf(s, Domain::Vertex, representative))
                                    : mesh.with(attributeOf(s, Domain::Corner, points.corners));
        s = {};  // its memory is free for the next one
    }
    if (std::any_of(points.faceMaterial.begin(), points.faceMaterial.end(), [](uint32_t slot) { return slot != 0; }))
        mesh = mesh.with(
            integerAttribute(std::string(names::material), Domain::Face, 1, Array<int32_t>(points.faceMaterial.begin(), points.faceMaterial.end())));
    return mesh;
}

}  // namespace mw
