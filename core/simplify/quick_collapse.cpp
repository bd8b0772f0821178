// The usual collapse of the quick decimation: two free vertices, closed rings, four floats at a time. What is not usual is in quick_open.cpp.
#include "core/simplify/quick_collapse.h"

#include <cmath>

namespace mw::quick {

/// The ring of the new vertex. Half-edge out[i] belongs to face i, which has around[i] and around[i + 1] on its far side; the first `ofA` faces come
/// from the first end. around[0] and around[ofA] are the tips of the two faces that go; those are `size` and `size` + 1 in `before`. Places are
/// relative to the first end, normals as long as twice the area.
struct Collapser::Ring {
    int a, b, size = 0, ofA = 0;
    int out[mostRing], around[mostRing + 2];
    Float4 apart, to, arm[mostRing + 2], before[mostRing + 2], after[mostRing + 2];
    alignas(16) float sizeBefore[mostRing + 4], sizeAfter[mostRing + 4], perBefore[mostRing + 4], perAfter[mostRing + 4];

    MW_INLINE bool sharesOthers() const;
    MW_INLINE void keepVolume(const Symmetric& qa, const Symmetric& qb);
    MW_INLINE bool foldedInside() const;
};

Attempt Collapser::attempt(int h, const Target& to)
{
    const int g = t_.twin(h);
    if (g >= 0 && !(t_.vertices[size_t(t_.from(h))].flag | t_.vertices[size_t(t_.from(g))].flag)) {
        Ring ring;
        switch (walk(h, ring)) {
            case Walk::Closed:
                return inner(h, to, ring);
            case Walk::Pinched:
                return {Refusal::Link};
            case Walk::Odd:
                return {Refusal::Locked};
            case Walk::Open:
                break;
        }
    }
    return open(h, to);
}

// From a half-edge out of the vertex to the one that ends in `tip`.
MW_INLINE bool Collapser::walkFan(int half, int tip, int& last, Ring& r) const
{
    for (;;) {
        if (half < 0 || r.size >= mostRing - 2) return false;
        const Face& f = t_.faces[size_t(half >> 2)];
        const int k = half & 3, far = f.v[k == 2 ? 0 : k + 1];
        if (far == tip) {
            last = half;
            return true;
        }
        r.out[r.size] = half;
        r.around[r.size++] = far;
        half = f.twin[k == 0 ? 2 : k - 1];
    }
}

// Both fans into one ring; whether the rings of the ends share more than the two tips (the link condition; Dey and others 1999).
MW_INLINE Collapser::Walk Collapser::walk(int h, Ring& r) const
{
    const int g = t_.twin(h), tipA = t_.from(prev(h)), tipB = t_.from(prev(g));
    int last = -1;
    if (!walkFan(t_.twin(prev(h)), tipB, last, r)) return Walk::Open;
    if (last >> 2 != g >> 2) return Walk::Pinched;
    r.ofA = r.size;
    if (!walkFan(t_.twin(prev(g)), tipA, last, r)) return Walk::Open;
    if (last >> 2 != h >> 2) return Walk::Pinched;
    r.a = t_.from(h), r.b = t_.from(g);
    const Vertex &a = t_.vertices[size_t(r.a)], &b = t_.vertices[size_t(r.b)];
    if (uint32_t(r.ofA) + 2 != a.faces || uint32_t(r.size - r.ofA) + 2 != b.faces) return Walk::Odd;  // more than one fan at a vertex
    if (r.ofA == 0 || r.size == r.ofA || r.size < 3 || r.around[0] != tipA || r.around[r.ofA] != tipB || r.sharesOthers()) return Walk::Pinched;
    return Walk::Closed;
}

MW_INLINE bool Collapser::Ring::sharesOthers() const
{
    bool shared = false;
    for (int i = 1; i < ofA; ++i)
        for (int j = ofA + 1; j < size; ++j) shared |= around[i] == around[j];
    return shared;
}

MW_INLINE void Collapser::measure(Ring& r) const
{
    const Float4 origin = t_.vertices[size_t(r.a)].place;
    const int n = r.size;
    r.apart = t_.vertices[size_t(r.b)].place - origin;
    for (int i = 0; i < n; ++i) r.arm[i] = t_.vertices[size_t(r.around[i])].place - origin;
    r.arm[n] = r.arm[0];
    for (int i = 0; i < r.ofA; ++i) r.before[i] = cross(r.arm[i], r.arm[i + 1]);
    for (int i = r.ofA; i < n; ++i) r.before[i] = cross(r.arm[i] - r.apart, r.arm[i + 1] - r.apart);
    r.before[n] = cross(r.apart, r.arm[0]);
    r.before[n + 1] = cross(r.arm[r.ofA], r.apart);
}

// The volume under the star is linear in the new place: it moves along (A + B)^-1 g until g . t = k (Lindstrom and Turk 1998 have it as a
// constraint).
MW_INLINE void Collapser::Ring::keepVolume(const Symmetric& qa, const Symmetric& qb)
{
    Float4 fromA = before[size] + before[size + 1], fromB = {};
    for (int i = 0; i < ofA; ++i) fromA += before[i];
    for (int i = ofA; i < size; ++i) fromB += before[i];
    const double k = dot(fromB, apart);
    const Float4 g = fromA + fromB;
    double y[3];
    Adjugate(qa, qb).times(g[0], g[1], g[2], y);
    const double along = g[0] * y[0] + g[1] * y[1] + g[2] * y[2];
    if (!(along > 0)) return;
    const double l = (k - (double(g[0]) * to[0] + double(g[1]) * to[1] + double(g[2]) * to[2])) / along;
    to += Float4{float(l * y[0]), float(l * y[1]), float(l * y[2]), 0};
}

// No face may turn far. One that had no area may go anywhere.
MW_INLINE bool Collapser::turned(Ring& r) const
{
    const float limit = t_.rules.turn * t_.rules.turn;
    const int n = r.size;
    const Float4 first = r.arm[0] - r.to;
    Float4 side = first;
    bool bad = false;
    for (int i = 0; i < n; ++i) {
        const Float4 following = i + 1 < n ? r.arm[i + 1] - r.to : first;
        const Float4 after = r.after[i] = cross(side, following);
        side = following;
        const float d = dot(r.before[i], after), u = r.sizeBefore[i] = dot(r.before[i], r.before[i]), v = r.sizeAfter[i] = dot(after, after);
        bad |= !((d > 0 && d * d > limit * u * v) || (u == 0 && v > 0));
    }
    r.after[n] = r.after[0];
    return bad;
}

// No two neighbours in the ring may come to lie on each other that did not; where a face between them goes, one of them may have lain on that.
MW_INLINE bool Collapser::Ring::foldedInside() const
{
    for (int i = 0; i < size; ++i) {
        if (__builtin_expect(dot(after[i], after[i + 1]) > 0, 1)) continue;
        const bool atA = i + 1 == size, atB = i + 1 == ofA;
        const Float4 gone = before[atA ? size : size + 1], following = before[atA ? 0 : i + 1];
        const bool was = atA || atB ? dot(before[i], gone) <= 0 || dot(gone, following) <= 0 : dot(before[i], following) <= 0;
        if (!was) return true;
    }
    return false;
}

// The same across the rim.
MW_INLINE Attempt Collapser::foldedOutside(const Ring& r) const
{
    const Float4 origin = t_.vertices[size_t(r.a)].place;
    bool folded = false, outside = false;
    for (int i = 0; i < r.size; ++i) {
        const int k = r.out[i] & 3, rim = t_.faces[size_t(r.out[i] >> 2)].twin[k == 2 ? 0 : k + 1];
        if (rim < 0) continue;
        const int apex = t_.from(prev(rim));
        outside |= !range_.holds(apex);
        if (outside) break;
        const Float4 beyond = cross(r.arm[i] - r.arm[i + 1], t_.vertices[size_t(apex)].place - origin - r.arm[i + 1]);
        folded |= dot(beyond, r.after[i]) <= 0 && dot(beyond, r.before[i]) > 0;
    }
    return {folded ? Refusal::Fold : Refusal::None, outside, 2, 2};
}

// How far the surface is off afterwards: the distances of the new place to the planes it leaves and of the old ones to the planes there are then, on
// top of what was before.
float Collapser::moved(const Ring& r) const
{
    float most = 0;
    for (int i = 0; i < r.size; ++i) {
        const Float4 way = i < r.ofA ? r.to : r.to - r.apart;
        if (r.sizeBefore[i] > 0) most = std::max(most, std::abs(dot(r.before[i], way)) / std::sqrt(r.sizeBefore[i]));
        if (r.sizeAfter[i] > 0) most = std::max(most, std::abs(dot(r.after[i], way)) / std::sqrt(r.sizeAfter[i]));
    }
    return unsafe * most + std::max(t_.deviation[size_t(r.a)], t_.deviation[size_t(r.b)]);
}

MW_INLINE Attempt Collapser::inner(int h, const Target& to, Ring& r)
{
    bool outside = false;
    for (int i = 0; i < r.size; ++i) outside |= !range_.holds(r.around[i]);
    if (outside) return {Refusal::None, true};
    measure(r);
    r.to = Float4{to.x, to.y, to.z, 0};
    if (!t_.rules.endsOnly) r.keepVolume(t_.vertices[size_t(r.a)].quadric, t_.vertices[size_t(r.b)].quadric);
    if (turned(r)) return {Refusal::Turn, false, 2, 2};
    if (r.foldedInside()) return {Refusal::Fold, false, 2, 2};
    const Attempt rim = foldedOutside(r);
    if (rim.outside || rim.refusal != Refusal::None) return rim;
    if (!t_.deviation.empty()) {
        const float far = moved(r);
        if (far > t_.rules.deviation) return {Refusal::Error, false, 2, 2};
        t_.deviation[size_t(r.a)] = far;
    }
    commit(h, r);
    return rim;
}

// Nothing is remembered: the quadrics of the ring change by what the faces around the new vertex give now, less what they gave. Its own is new.
MW_INLINE void Collapser::commit(int h, Ring& r)
{
    const int n = r.size;
    r.sizeBefore[n] = dot(r.before[n], r.before[n]);
    r.sizeBefore[n + 1] = dot(r.before[n + 1], r.before[n + 1]);
    const auto roots = [](float* size, float* per, int count) {
        for (int i = 0; i < count; ++i) {
            const float root = std::sqrt(size[i]);
            size[i] = root;
            per[i] = 1 / std::max(1e-30f, root);
        }
    };
    roots(r.sizeBefore, r.perBefore, n + 2);
    roots(r.sizeAfter, r.perAfter, n);
    const auto gave = [&](int i) { return faceQuadric(r.before[i], r.sizeBefore[i], r.perBefore[i]); };
    Symmetric sum = zero, last = zero, first = zero;
    for (int i = 0; i < n; ++i) {
        const Symmetric gives = faceQuadric(r.after[i], r.sizeAfter[i], r.perAfter[i]), change = gives - gave(i);
        sum = sum + gives;
        if (i == 0) {
            first = change;
        } else {
            Symmetric& q = t_.vertices[size_t(r.around[i])].quadric;
            q = q + change + last;
        }
        last = change;
    }
    Vertex &v = t_.vertices[size_t(r.a)], &tipA = t_.vertices[size_t(r.around[0])], &tipB = t_.vertices[size_t(r.around[r.ofA])];
    tipA.quadric = tipA.quadric + first + last - gave(n);
    tipB.quadric = tipB.quadric - gave(n + 1);
    --tipA.faces, --tipB.faces;
    const bool atEnd = r.to[0] == r.apart[0] && r.to[1] == r.apart[1] && r.to[2] == r.apart[2];
    v.quadric = sum;
    v.place = atEnd ? t_.vertices[size_t(r.b)].place : v.place + r.to;
    v.faces = uint32_t(n);
    for (int i = r.ofA; i < n; ++i) t_.faces[size_t(r.out[i] >> 2)].v[r.out[i] & 3] = r.a;
    const int g = t_.twin(h);
    closeInner(h, g);
    t_.vertices[size_t(r.b)].parent = r.a;
    if (t_.watched()) t_.noteRemoved(r.b, h >> 2, g >> 2);
}

// Takes the two faces out and joins what was beyond them. No side of theirs is weighed, for it ends in one of the two vertices.
MW_INLINE void Collapser::closeInner(int h, int g)
{
    for (int z = 0; z < 2; ++z) {
        const int side = z ? g : h, x = t_.twin(next(side)), y = t_.twin(prev(side));
        joined_[2 * z] = x, joined_[2 * z + 1] = y;
        t_.faces[size_t(x >> 2)].twin[x & 3] = y;
        t_.faces[size_t(y >> 2)].twin[y & 3] = x;
        t_.faces[size_t(side >> 2)].v[0] = -1;
    }
}

}  // namespace mw::quick
