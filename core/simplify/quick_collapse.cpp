// The usual collapse of the quick decimation: two free vertices, closed rings, four floats at a time. What is not usual is in quick_open.cpp.
#include "core/simplify/quick_collapse.h"

#include <cmath>

#include "core/simplify/lanes.h"

namespace mw::quick {

/// The ring of the new vertex. Half-edge out[i] belongs to face i, which has around[i] and around[i + 1] on its far side; the first `ofA` faces come
/// from the first end. around[0] and around[ofA] are the tips of the two faces that go. Places are relative to the first end, normals as long as
/// twice the area. Lists go on in a circle beyond `size`, as far as four at a time may read.
struct Collapser::Ring {
    static constexpr int beyond = 2 * lanes, capacity = mostRing + beyond;
    using List = VectorList<capacity>;

    int a, b, size = 0, ofA = 0;
    int out[mostRing], around[capacity];
    Float4 apart, to, goneA, goneB;  ///< normals of the faces that go, the one at the tip of either end
    Vectors ofAll{}, ofB{};          ///< sums of normals
    List arm, before, after;
    alignas(16) float sizeBefore[capacity], sizeAfter[capacity];

    MW_INLINE bool sharesOthers() const;
    MW_INLINE void keepVolume(const Symmetric& qa, const Symmetric& qb);
    bool foldedInside() const;
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
            case Walk::Outside:
                return {Refusal::None, true};
            case Walk::Open:
                break;
        }
    }
    return open(h, to);
}

// From a half-edge out of the vertex to the one that ends in `tip`.
MW_INLINE Collapser::Walk Collapser::walkFan(int half, int tip, int& last, Ring& r) const
{
    for (;;) {
        if (half < 0 || r.size >= mostRing - 2) return Walk::Open;
        const Face& f = t_.faces[size_t(half >> 2)];
        const int k = half & 3, far = f.v[k == 2 ? 0 : k + 1];
        if (!range_.holds(far)) return Walk::Outside;
        if (far == tip) {
            last = half;
            return Walk::Closed;
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
    if (const Walk a = walkFan(t_.twin(prev(h)), tipB, last, r); a != Walk::Closed) return a;
    if (last >> 2 != g >> 2) return Walk::Pinched;
    r.ofA = r.size;
    if (const Walk b = walkFan(t_.twin(prev(g)), tipA, last, r); b != Walk::Closed) return b;
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

/// The places of four vertices, from an origin.
MW_INLINE Vectors Collapser::armsOf(const int* v, Float4 origin) const
{
    Float4 r[4];
    for (int k = 0; k < 4; ++k) r[k] = t_.vertices[size_t(v[k])].place - origin;
    transpose(r);
    return {r[0], r[1], r[2]};
}

MW_INLINE void Collapser::measure(Ring& r) const
{
    const Float4 origin = t_.vertices[size_t(r.a)].place;
    const int n = r.size;
    r.apart = t_.vertices[size_t(r.b)].place - origin;
    for (int i = 0; i < Ring::beyond; ++i) r.around[n + i] = r.around[i];
    for (int i = 0; i < n + lanes + 1; i += lanes) r.arm.set(i, armsOf(r.around + i, origin));
    const Vectors apart = all(r.apart);
    for (int i = 0; i < n; i += lanes) {
        const Int4 there = below(i, n), atB = there & ~below(i, r.ofA);
        const Vectors end = where(atB, apart), normal = cross(r.arm.from(i) - end, r.arm.from(i + 1) - end);
        r.before.set(i, normal);
        r.ofAll = r.ofAll + where(there, normal);
        r.ofB = r.ofB + where(atB, normal);
    }
    r.goneA = cross(r.apart, r.arm[0]);
    r.goneB = cross(r.arm[r.ofA], r.apart);
}

// The volume under the star is linear in the new place: it moves along (A + B)^-1 g until g . t = k (Lindstrom and Turk 1998 have it as a
// constraint).
MW_INLINE void Collapser::Ring::keepVolume(const Symmetric& qa, const Symmetric& qb)
{
    const double k = dot(sum(ofB), apart);
    const Float4 g = sum(ofAll) + goneA + goneB;
    double y[3];
    Adjugate(qa, qb).times(g[0], g[1], g[2], y);
    const double along = g[0] * y[0] + g[1] * y[1] + g[2] * y[2];
    if (!(along > 0)) return;
    const double l = (k - (double(g[0]) * to[0] + double(g[1]) * to[1] + double(g[2]) * to[2])) / along;
    to += Float4{float(l * y[0]), float(l * y[1]), float(l * y[2]), 0};
}

// No face may turn far. One that had no area may go anywhere. No two neighbours in the ring may come to lie on each other that did not.
MW_INLINE Refusal Collapser::shape(Ring& r) const
{
    const Float4 limit = all(t_.rules.turn * t_.rules.turn), none = {};
    const Vectors to = all(r.to);
    Int4 turned = {}, folded = {};
    for (int i = 0; i < r.size; i += lanes) {
        const Vectors a = r.arm.from(i) - to, b = r.arm.from(i + 1) - to, c = r.arm.from(i + 2) - to;
        const Vectors before = r.before.from(i), after = cross(a, b), following = cross(b, c);
        const Float4 d = dot(before, after), u = dot(before, before), v = dot(after, after);
        const Int4 there = below(i, r.size), fine = ((d > none) & (d * d > limit * u * v)) | ((u == none) & (v > none));
        turned |= there & ~fine;
        folded |= there & ~(dot(after, following) > none);
        r.after.set(i, after);
        __builtin_memcpy(r.sizeBefore + i, &u, sizeof u);
        __builtin_memcpy(r.sizeAfter + i, &v, sizeof v);
    }
    if (any(turned)) return Refusal::Turn;
    return any(folded) && r.foldedInside() ? Refusal::Fold : Refusal::None;
}

// Where two neighbours do lie on each other: whether they have not before; where a face between them goes, one of them may have lain on that.
bool Collapser::Ring::foldedInside() const
{
    for (int i = 0; i < size; ++i) {
        const bool atA = i + 1 == size, atB = i + 1 == ofA;
        const int j = atA ? 0 : i + 1;
        if (dot(after[i], after[j]) > 0) continue;
        const Float4 gone = atA ? goneA : goneB;
        const bool was = atA || atB ? dot(before[i], gone) <= 0 || dot(gone, before[j]) <= 0 : dot(before[i], before[j]) <= 0;
        if (!was) return true;
    }
    return false;
}

// The same across the rim. Where nothing is beyond it a point of the rim stands for that, and the face has no area.
MW_INLINE Attempt Collapser::foldedOutside(const Ring& r) const
{
    const Float4 origin = t_.vertices[size_t(r.a)].place, none = {};
    int apex[Ring::capacity];
    bool outside = false;
    for (int i = 0; i < r.size; ++i) {
        const int k = r.out[i] & 3, rim = t_.faces[size_t(r.out[i] >> 2)].twin[k == 2 ? 0 : k + 1];
        apex[i] = rim < 0 ? r.around[i] : t_.from(prev(rim));
        outside |= !range_.holds(apex[i]);
    }
    if (outside) return {Refusal::None, true, 2, 2};
    for (int i = r.size; i < r.size + lanes - 1; ++i) apex[i] = r.a;
    Int4 folded = {};
    for (int i = 0; i < r.size; i += lanes) {
        const Vectors rim = r.arm.from(i + 1), beyond = cross(r.arm.from(i) - rim, armsOf(apex + i, origin) - rim);
        folded |= below(i, r.size) & (dot(beyond, r.after.from(i)) <= none) & (dot(beyond, r.before.from(i)) > none);
    }
    return {any(folded) ? Refusal::Fold : Refusal::None, false, 2, 2};
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
    measure(r);
    r.to = Float4{to.x, to.y, to.z, 0};
    if (!t_.rules.endsOnly) r.keepVolume(t_.vertices[size_t(r.a)].quadric, t_.vertices[size_t(r.b)].quadric);
    const Refusal shaped = shape(r);
    if (shaped != Refusal::None) return {shaped, false, 2, 2};
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
    Symmetrics all{};
    Symmetric change[lanes], first = zero, last = zero;
    for (int i = 0; i < n; i += lanes) {
        const Symmetrics gives = faceQuadrics(r.after.from(i), Ring::List::load(r.sizeAfter + i));
        all = all + where(below(i, n), gives);
        (gives - faceQuadrics(r.before.from(i), Ring::List::load(r.sizeBefore + i))).split(change);
        for (int k = 0; k < lanes && i + k < n; ++k) {
            Symmetric& q = t_.vertices[size_t(r.around[i + k])].quadric;
            if (i + k > 0) q = q + change[k] + last;
            last = change[k];
        }
        if (i == 0) first = change[0];
    }
    Vertex &v = t_.vertices[size_t(r.a)], &tipA = t_.vertices[size_t(r.around[0])], &tipB = t_.vertices[size_t(r.around[r.ofA])];
    tipA.quadric = tipA.quadric + first + last - faceQuadric(r.goneA);
    tipB.quadric = tipB.quadric - faceQuadric(r.goneB);
    --tipA.faces, --tipB.faces;
    const bool atEnd = r.to[0] == r.apart[0] && r.to[1] == r.apart[1] && r.to[2] == r.apart[2];
    v.quadric = sum(all);
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
