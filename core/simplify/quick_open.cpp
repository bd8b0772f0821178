// Collapses that are not usual: at borders, along seams and creases, beside walls, of large fans. Plain code; the tests are those of the usual case.
#include <algorithm>
#include <cmath>

#include "core/simplify/quick_collapse.h"

namespace mw::quick {

void Collapser::fanOf(int h, Fan& fan) const
{
    fan.out.clear(), fan.ring.clear();
    fan.open = fan.tooMany = false;
    int g = h;
    do {
        if (int(fan.out.size()) >= mostFan) {
            fan.tooMany = true;
            return;
        }
        fan.out.push_back(g);
        g = t_.twin(prev(g));
    } while (g >= 0 && g != h);
    fan.open = g < 0;
    const int lastNeighbour = fan.open ? t_.from(prev(fan.out.back())) : -1;
    for (g = fan.open ? t_.twin(h) : -1; g >= 0; g = t_.twin(g)) {  // the side beyond h
        if (int(fan.out.size()) >= mostFan) {
            fan.tooMany = true;
            return;
        }
        g = next(g);
        fan.out.push_back(g);
    }
    for (const int out : fan.out) fan.ring.push_back(t_.to(out));
    if (fan.open) fan.ring.push_back(lastNeighbour);
}

const std::vector<int>& Collapser::star(int h)
{
    gatherStar(h);
    return star_;
}

// Corners at the two ends, of the faces that stay.
bool Collapser::gatherStar(int h)
{
    const int g = t_.twin(h);
    star_.clear();
    fanOf(h, fanA_);
    fanOf(g >= 0 ? g : next(h), fanB_);
    if (fanA_.tooMany || fanB_.tooMany) return false;
    for (const Fan* fan : {&fanA_, &fanB_})
        for (const int out : fan->out)
            if (out >> 2 != h >> 2 && (g < 0 || out >> 2 != g >> 2)) star_.push_back(out);
    return true;
}

// A border counts as one more vertex that all border vertices share; hence an inner edge between two curves is refused by collapsible().
Attempt Collapser::linkOpen(int h)
{
    Attempt a;
    a.allowed = t_.twin(h) < 0 ? 1 : 2;
    for (const int v : fanA_.ring) a.common += int(std::count(fanB_.ring.begin(), fanB_.ring.end(), v));
    const bool tetrahedron = !fanA_.open && !fanB_.open && fanA_.ring.size() == 3 && fanB_.ring.size() == 3;
    if (a.common != a.allowed || star_.empty() || tetrahedron) a.refusal = Refusal::Link;
    for (const int side : {h, t_.twin(h)}) {
        if (side < 0 || a.refusal != Refusal::None) continue;
        const int x = next(side), y = prev(side);
        if (t_.twin(x) < 0 && t_.twin(y) < 0)
            a.refusal = Refusal::Link;  // the tip would be left alone
        else if (t_.onCurve(x) && t_.onCurve(y))
            a.refusal = Refusal::Feature;  // two curves would become one
    }
    return a;
}

// Whether faces i and j of the star, neighbours across the side to `rim`, lay on each other; where a face between them goes, whether one of them lay
// on that.
bool Collapser::foldedBefore(int h, size_t i, size_t j, int rim) const
{
    for (const int side : {h, t_.twin(h)}) {
        if (side < 0 || t_.from(prev(side)) != rim) continue;
        const Float4 gone = t_.normal(side >> 2);
        return dot(old_[i], gone) <= 0 || dot(old_[j], gone) <= 0;
    }
    return dot(old_[i], old_[j]) <= 0;
}

Attempt Collapser::shapeOpen(Float4 to)
{
    const int h = fanA_.out.front();
    old_.clear(), new_.clear();
    for (const int c : star_) {
        old_.push_back(t_.normal(c >> 2));
        new_.push_back(cross(t_.vertices[size_t(t_.to(c))].place - to, t_.vertices[size_t(t_.from(prev(c)))].place - to));
        const float d = dot(old_.back(), new_.back()), u = dot(old_.back(), old_.back()), v = dot(new_.back(), new_.back());
        if (!((d > 0 && d * d > t_.rules.turn * t_.rules.turn * u * v) || (u == 0 && v > 0))) return {Refusal::Turn};
    }
    for (size_t i = 0; i < star_.size(); ++i) {
        const int last = t_.from(prev(star_[i])), rim = t_.twin(next(star_[i]));
        for (size_t j = 0; j < star_.size(); ++j)
            if (last == t_.to(star_[j]) && dot(new_[i], new_[j]) <= 0 && !foldedBefore(h, i, j, last)) return {Refusal::Fold};
        if (rim < 0) continue;
        if (!range_.holds(t_.from(prev(rim)))) return {Refusal::Link, true};
        const Float4 beyond = t_.normal(rim >> 2);
        if (dot(beyond, new_[i]) <= 0 && dot(beyond, old_[i]) > 0) return {Refusal::Fold};
    }
    return {};
}

float Collapser::offLine(int h, Float4 p) const
{
    const Float4 start = t_.vertices[size_t(t_.from(h))].place, line = t_.vertices[size_t(t_.to(h))].place - start, off = cross(line, p - start);
    return dot(line, line) > 0 ? std::sqrt(dot(off, off) / dot(line, line)) : 0;
}

float Collapser::movedOpen(Float4 to) const
{
    const int h = fanA_.out.front();
    float most = t_.onCurve(h) ? offLine(h, to) : 0;
    for (size_t i = 0; i < star_.size(); ++i) {
        const int c = star_[i];
        const Float4 way = to - t_.vertices[size_t(t_.from(c))].place;
        for (const Float4 n : {old_[i], new_[i]})
            if (dot(n, n) > 0) most = std::max(most, std::abs(dot(n, way)) / std::sqrt(dot(n, n)));
        for (const int side : {c, prev(c)})  // a curve moves by what the new point is off its lines
            if (t_.onCurve(side)) most = std::max(most, offLine(side, to));
    }
    return most;
}

Attempt Collapser::open(int h, const Target& target)
{
    const int a = t_.from(h), b = t_.to(h);
    if (!t_.collapsible(h)) {
        const bool locked = t_.vertices[size_t(a)].kind() == Locked || t_.vertices[size_t(b)].kind() == Locked;
        return {locked ? Refusal::Locked : Refusal::Feature};
    }
    if (!gatherStar(h)) return {Refusal::Valence};
    if (fanA_.out.size() != t_.vertices[size_t(a)].faces || fanB_.out.size() != t_.vertices[size_t(b)].faces) return {Refusal::Locked};
    for (const Fan* fan : {&fanA_, &fanB_})
        for (const int v : fan->ring)
            if (!range_.holds(v)) return {Refusal::Link, true};
    const Attempt link = linkOpen(h);
    if (link.refusal != Refusal::None) return link;
    const Float4 first = t_.vertices[size_t(a)].place, second = t_.vertices[size_t(b)].place, way = second - first;
    const bool atEnd = target.x == way[0] && target.y == way[1] && target.z == way[2];  // exactly there: a border must not creep
    const Float4 to = atEnd ? second : first + Float4{target.x, target.y, target.z, 0};
    Attempt shape = shapeOpen(to);
    shape.common = link.common, shape.allowed = link.allowed;
    if (shape.refusal != Refusal::None) return shape;
    if (!t_.deviation.empty()) {
        const float moved = unsafe * movedOpen(to) + std::max(t_.deviation[size_t(a)], t_.deviation[size_t(b)]);
        if (moved > t_.rules.deviation) shape.refusal = Refusal::Error;
        if (moved > t_.rules.deviation) return shape;
        t_.deviation[size_t(a)] = moved;
    }
    commitOpen(h, to);
    return shape;
}

// The faces that change or go take back what they gave; the new vertex begins with nothing.
void Collapser::commitOpen(int h, Float4 to)
{
    const int a = t_.from(h), b = t_.to(h), g = t_.twin(h);
    Vertex &v = t_.vertices[size_t(a)], &w = t_.vertices[size_t(b)];
    for (const int c : star_) t_.give(c >> 2, -1);
    for (const int side : {h, g}) {
        if (side < 0) continue;
        t_.give(side >> 2, -1);
        --t_.vertices[size_t(t_.from(prev(side)))].faces;
    }
    t_.uniteWedges(h);
    v.place = to;
    v.quadric = zero;
    v.flag = std::max(v.flag & Vertex::kindBits, w.flag & Vertex::kindBits) | ((v.flag | w.flag) & Vertex::nearWall);
    v.faces = uint32_t(star_.size());
    close(h);
    for (const int c : star_) {
        if (t_.from(c) == b) t_.faces[size_t(c >> 2)].v[c & 3] = a;
    }
    for (const int c : star_) t_.give(c >> 2, 1);
}

// Takes the two faces out and joins what was beyond them.
void Collapser::close(int h)
{
    const int g = t_.twin(h), a = t_.from(h), b = t_.to(h);
    joined_[2] = joined_[3] = -1;
    for (int z = 0; z < (g >= 0 ? 2 : 1); ++z) {
        const int side = z ? g : h;
        joined_[2 * z] = t_.twin(next(side)), joined_[2 * z + 1] = t_.twin(prev(side));
        t_.closeFace(side);
    }
    t_.vertices[size_t(b)].parent = a;
    if (t_.watched()) t_.noteRemoved(b, h >> 2, g >> 2);
}

}  // namespace mw::quick
