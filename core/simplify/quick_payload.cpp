// What the tables of the quick decimation do beside geometry: corners that share values, and the way back to a payload.
#include <numeric>
#include <utility>

#include "core/simplify/quick_mesh.h"

namespace mw::quick {

void Tables::unite(uint32_t a, uint32_t b)
{
    const auto root = [&](uint32_t x) {
        while (wedge_[x] != x) x = wedge_[x] = wedge_[wedge_[x]];
        return x;
    };
    a = root(a), b = root(b);
    wedge_[std::max(a, b)] = std::min(a, b);
}

// Free vertices need none of this: all of their corners have one value.
void Tables::joinWedges()
{
    wedge_.resize(3 * faces.size());
    std::iota(wedge_.begin(), wedge_.end(), 0u);
    joined_.assign(vertices.size(), none);
    for (int h = 0; h < int(4 * faces.size()); ++h) {
        if ((h & 3) == 3 || twin(h) < h || onCurve(h)) continue;
        if (vertices[size_t(from(h))].kind() != Free) unite(oldCorner(h), oldCorner(next(twin(h))));
        if (vertices[size_t(to(h))].kind() != Free) unite(oldCorner(next(h)), oldCorner(twin(h)));
    }
}

/// The corner that stands for all that share its values; `none` where a free vertex does.
uint32_t Tables::wedgeOf(uint32_t corner) const
{
    for (size_t v = rank[old_.vertices[corner]];;) {
        if (joined_[v] != none) {
            corner = joined_[v];
            break;
        }
        if (vertices[v].kind() != Free) break;
        if (vertices[v].parent == int(v)) return none;
        v = size_t(vertices[v].parent);
    }
    while (wedge_[corner] != corner) corner = wedge_[corner] = wedge_[wedge_[corner]];
    return corner;
}

void Tables::uniteWedges(int h)
{
    if (wedge_.empty()) return;
    const int a = from(h), b = to(h), g = twin(h);
    const bool freeA = vertices[size_t(a)].kind() == Free, freeB = vertices[size_t(b)].kind() == Free;
    if (freeA && freeB) return;
    if (freeA) {
        joined_[size_t(a)] = wedgeOf(oldCorner(next(h)));
    } else if (freeB) {
        joined_[size_t(b)] = wedgeOf(oldCorner(h));
    } else {
        unite(wedgeOf(oldCorner(h)), wedgeOf(oldCorner(next(h))));
        if (g >= 0) unite(wedgeOf(oldCorner(g)), wedgeOf(oldCorner(next(g))));
    }
}

void Tables::noteRemoved(int vertex, int face, int other)
{
    vertexRank_.remove(vertices[size_t(vertex)].old);
    for (const int f : {face, other})
        if (f >= 0) faceRank_.remove(faces[size_t(f)].old);
}

// Takes the face of h out and joins what was beyond its two outer sides.
void Tables::closeFace(int h)
{
    const int inner[2] = {next(h), prev(h)}, outer[2] = {twin(inner[0]), twin(inner[1])};
    Face& gone = faces[size_t(h >> 2)];
    for (int k = 0; k < 2; ++k)
        if (outer[k] >= 0) faces[size_t(outer[k] >> 2)].twin[outer[k] & 3] = outer[1 - k];
    if (gone.bits >> Face::curve) {  // an edge that must stay has become one with an edge that need not
        for (const int shift : {Face::curve, Face::bent}) {
            const bool either = (gone.bits >> (shift + (inner[0] & 3)) | gone.bits >> (shift + (inner[1] & 3))) & 1;
            for (const int side : outer)
                if (either && side >= 0) faces[size_t(side >> 2)].bits |= 1u << (shift + (side & 3));
        }
    }
    if (!crease_.empty())
        for (const int side : outer)
            if (side >= 0)
                for (const int from : inner) crease_[size_t(side)] = std::max(crease_[size_t(side)], crease_[size_t(from)]);
    gone.v[0] = -1;
}

void Tables::numberWedges(Collapsed& c) const
{
    if (wedge_.empty()) return;
    std::vector<uint32_t> number(wedge_.size(), none);
    c.wedge.assign(wedge_.size(), none);
    for (uint32_t i = 0; i < wedge_.size(); ++i) {
        if (vertices[rank[c.into[old_.vertices[i]]]].kind() == Free) continue;
        const uint32_t w = wedgeOf(i);
        if (number[w] == none) number[w] = c.wedges++;
        c.wedge[i] = number[w];
    }
}

Mesh Tables::payload() const
{
    Collapsed c;
    c.into.resize(vertices.size());
    for (size_t v = 0; v < vertices.size(); ++v) c.into[vertices[v].old] = vertices[size_t(vertices[v].parent)].old;
    for (uint32_t v = 0; v < c.into.size(); ++v)
        if (c.into[v] == v) c.positions.push_back(position(vertices[rank[v]]));
    std::vector<int> slot(old_.size(), -1);
    for (size_t f = 0; f < faces.size(); ++f)
        if (faces[f].v[0] >= 0) slot[faces[f].old] = int(f);
    for (uint32_t t = 0; t < slot.size(); ++t) {
        if (slot[t] < 0) continue;
        c.triangles.push_back(t);
        for (size_t k = 0; k < 3; ++k) c.corners.push_back(vertices[size_t(faces[size_t(slot[t])].v[k])].old);
        for (size_t k = 0; !crease_.empty() && k < 3; ++k) c.creases.push_back(crease_[4 * size_t(slot[t]) + k]);
    }
    if (!input_.attributes().empty()) {
        for (uint32_t v = 0; v < c.into.size(); ++v) {
            uint32_t root = v;
            while (c.into[root] != root) root = c.into[root];
            for (uint32_t x = v; c.into[x] != root;) x = std::exchange(c.into[x], root);
        }
        numberWedges(c);
    }
    return carried(input_, old_, std::move(c));
}

}  // namespace mw::quick
