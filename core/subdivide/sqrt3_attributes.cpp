// Where each new corner lies in which old triangle.
#include "core/subdivide/sqrt3_attributes.h"

#include <algorithm>

#include "core/subdivide/carried.h"

namespace mw {

namespace {

constexpr uint32_t next(uint32_t corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// Where new triangles and corners come from.
struct Sources {
    Array<uint32_t> face;
    Stencils corners;
    Array<uint32_t> side;  // by new corner: the old corner whose sharp side its side is part of, or none
};

void addMean(uint32_t face, Stencils& rows)
{
    for (uint32_t c = 3 * face; c < 3 * face + 3; ++c) rows.add(c, 1.0 / 3);
}

/// After one round a triangle has its start in the face f of its corner and, if flipped, an apex in each of two faces.
Sources afterOne(const Sqrt3Round& r)
{
    Sources s;
    s.side.assign(3 * r.mesh.cornerCount(), none);
    for (uint32_t c = 0; c < r.mesh.cornerCount(); ++c) {
        const uint32_t d = r.partner(c);
        const bool flipped = d != none && r.triangles[3 * c + 1] == r.triangles[3 * d + 2];
        s.face.push_back(c / 3);
        s.corners.add(c, 1);
        s.corners.endRow();
        if (flipped)
            addMean(d / 3, s.corners);
        else
            s.corners.add(next(c), 1);
        s.corners.endRow();
        addMean(c / 3, s.corners);
        s.corners.endRow();
        if (r.sharp[r.edges.half[c] >> 1]) s.side[3 * c] = c;
    }
    return s;
}

/// The corner of a face at a vertex.
uint32_t cornerAt(const Mesh& mesh, uint32_t face, uint32_t vertex)
{
    for (uint32_t c = 3 * face; c < 3 * face + 2; ++c)
        if (mesh.cornerVertex()[c] == vertex) return c;
    return 3 * face + 2;
}

/// After two rounds every triangle lies in one old face, its vertices at thirds of its sides, at its corners or in its centre.
class AfterTwo {
public:
    AfterTwo(const Sqrt3Round& first, const Sqrt3Round& second) : first_(first), second_(second), onSharp_(second.points.size(), none)
    {
        for (uint32_t f = 0; f < second.mesh.faceCount(); ++f)
            if (second.centre[f] != none) onSharp_[second.centre[f]] = f;  // the corner of the first mesh whose side it lies on, near its start
        for (uint32_t e = 0; e < second.edges.size(); ++e) {
            if (second.firstOnSharp[e] == none) continue;
            const uint32_t corner = second.edges.corner[e].a / 3;  // a piece of the first round, and a corner of its mesh
            const bool same = second.edges.ends[e].a == first.mesh.cornerVertex()[corner];
            onSharp_[second.firstOnSharp[e] + (same ? 0 : 1)] = corner;
            fromEnd_.push_back(second.firstOnSharp[e] + (same ? 1 : 0));
            onSharp_[fromEnd_.back()] = corner;
        }
        std::sort(fromEnd_.begin(), fromEnd_.end());
    }
    Sources sources() const
    {
        Sources s;
        s.side.assign(second_.triangles.size(), none);
        for (uint32_t child = 0; child < second_.mesh.cornerCount(); ++child) {
            const uint32_t piece = child / 3, d = first_.partner(piece), face = d != none && child % 3 != 2 ? d / 3 : piece / 3;
            s.face.push_back(face);
            for (uint32_t k = 0; k < 3; ++k) addPlace(face, second_.triangles[3 * child + k], s.corners);
            addSharpSide(child, piece, s.side);
        }
        return s;
    }

private:
    void addPlace(uint32_t face, uint32_t vertex, Stencils& rows) const
    {
        const Mesh& m = first_.mesh;
        if (vertex < m.vertexCount()) {
            rows.add(cornerAt(m, face, vertex), 1);
        } else if (onSharp_[vertex] == none) {
            addMean(face, rows);
        } else {
            const uint32_t c = onSharp_[vertex];
            uint32_t near = m.cornerVertex()[c], far = m.cornerVertex()[next(c)];
            if (std::binary_search(fromEnd_.begin(), fromEnd_.end(), vertex)) std::swap(near, far);
            rows.add(cornerAt(m, face, near), 2.0 / 3);
            rows.add(cornerAt(m, face, far), 1.0 / 3);
        }
        rows.endRow();
    }
    /// The pieces of a triangle whose side was cut lie along it; flipping gives that of the last one to its neighbour.
    void addSharpSide(uint32_t child, uint32_t piece, Array<uint32_t>& side) const
    {
        if (second_.centre[piece] != none) return;
        uint32_t cut = 0;
        for (uint32_t k = 0; k < 3; ++k)
            if (second_.sharp[second_.edges.half[3 * piece + k] >> 1]) cut = k;
        const uint32_t place = (child % 3 + 3 - cut) % 3, neighbour = second_.partner(child);
        if (place == 0) side[3 * child] = piece;
        if (place == 1) side[3 * child + 2] = piece;
        if (place == 2) side[neighbour == none ? 3 * child + 1 : 3 * neighbour] = piece;
    }
    const Sqrt3Round &first_, &second_;
    Array<uint32_t> onSharp_;  // by vertex of the second round: the first mesh's corner whose side it lies on; none: none
    std::vector<uint32_t> fromEnd_;
};

bool differ(const Attribute& a, size_t i, size_t k)
{
    for (int c = 0; c < a.components; ++c)
        if (a.at(i, c) != a.at(k, c)) return true;
    return false;
}

}  // namespace

std::vector<Attribute> sqrt3Attributes(const Sqrt3Round& first, const Sqrt3Round* second)
{
    std::vector<Attribute> out;
    const auto needed = [](const Attribute& a) { return a.domain != Domain::Vertex; };
    if (std::none_of(first.mesh.attributes().begin(), first.mesh.attributes().end(), needed)) return out;
    const Sources sources = second ? AfterTwo(first, *second).sources() : afterOne(first);
    for (const Attribute& a : first.mesh.attributes()) {
        if (a.domain == Domain::Face) out.push_back(gathered(a, sources.face));
        if (a.domain != Domain::Corner) continue;
        if (a.name != names::crease || a.components != 1) {
            out.push_back(blended(a, sources.corners));
            continue;
        }
        Array<float> crease(sources.side.size(), 0.f);
        for (size_t c = 0; c < crease.size(); ++c)
            if (sources.side[c] != none) crease[c] = float(a.at(sources.side[c], 0));
        out.push_back(floatAttribute(a.name, Domain::Corner, 1, std::move(crease)));
    }
    return out;
}

std::vector<uint8_t> seamsOf(const Sqrt3Round& r)
{
    std::vector<uint8_t> seam(r.edges.size(), 0);
    for (const Attribute& a : r.mesh.attributes()) {
        if (a.domain == Domain::Vertex || a.name == names::crease) continue;
        for (size_t e = 0; e < seam.size(); ++e) {
            const uint32_t c = r.edges.corner[e].a, d = r.edges.corner[e].b;
            if (r.sharp[e] || seam[e]) continue;
            seam[e] = a.domain == Domain::Face ? differ(a, c / 3, d / 3) : differ(a, c, next(d)) || differ(a, next(c), d);
        }
    }
    return seam;
}

}  // namespace mw
