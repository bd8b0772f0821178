// The tables of a mesh under collapse: how they are built, when an edge may be collapsed, and doing it.
#include "core/simplify/collapse_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>

#include "core/error.h"

namespace mw {

CollapseMesh::CollapseMesh(Mesh input, const Options& options, bool watched) : input_(std::move(input)), options_(options), watched_(watched)
{
    readTriangles();
    scalePositions();
    findTwins();
    lockOddVertices();
    const SeamTest seams(input_, old_);
    markSeams(seams);
    if (seams.cornersCarry()) joinWedges();  // before bends are marked: a bend is no seam
    if (options.featureAngle < 180) markBends(options.featureAngle);
    classify();
    if (watched) {
        vertexRank_ = LiveRank(vertexSlots());
        faceRank_ = LiveRank(faceSlots());
    }
}

void CollapseMesh::readTriangles()
{
    old_ = OldTriangles(input_);
    if (old_.vertices.size() >= size_t(none) / 2) throw mw::Error("the mesh has over 700 million triangles; cut it into parts first");
    vertex_.assign(old_.vertices.begin(), old_.vertices.end());
    faces_ = faceSlots();
    into_.resize(input_.vertexCount());
    std::iota(into_.begin(), into_.end(), 0u);
    kind_.assign(input_.vertexCount(), Free);
    stamp_.assign(input_.vertexCount(), 0);
    sharp_.assign(vertex_.size(), 0);
    for (const uint32_t v : input_.lines()) kind_[v] = Locked;
}

void CollapseMesh::scalePositions()
{
    const Bounds box = input_.bounds();
    centre_ = box.centre();
    scale_ = box.diagonal() > 0 ? box.diagonal() : 1;
    place_.reserve(input_.vertexCount());
    for (const glm::vec3& p : input_.positions()) place_.push_back((glm::dvec3(p) - centre_) / scale_);
}

// Half-edges are sorted into lists by their lower end; in a list, those with the same other end are one edge. Two that run against each other are
// twins; anything else that has company is no edge of a surface, and its ends are locked.
void CollapseMesh::findTwins()
{
    const size_t n = vertex_.size(), vertices = vertexSlots();
    twin_.assign(n, none);
    std::vector<uint32_t> start(vertices + 2, 0);
    for (uint32_t h = 0; h < n; ++h) ++start[std::min(from(h), to(h)) + 2];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<uint64_t> list(n);
    for (uint32_t h = 0; h < n; ++h) list[start[std::min(from(h), to(h)) + 1]++] = uint64_t(std::max(from(h), to(h))) << 32 | h;
    for (size_t v = 0; v < vertices; ++v) {
        uint64_t* first = list.data() + start[v];
        uint64_t* const end = list.data() + start[v + 1];
        std::sort(first, end);
        while (first != end) {
            uint64_t* last = first + 1;
            while (last != end && *last >> 32 == *first >> 32) ++last;
            const uint32_t h = uint32_t(first[0]), other = uint32_t(first[0] >> 32);
            const uint32_t g = last - first == 2 ? uint32_t(first[1]) : none;
            if (g != none && from(h) != from(g) && other != v)
                twin_[h] = g, twin_[g] = h;
            else if (last - first > 1 || other == v)
                kind_[v] = kind_[other] = Locked;
            first = last;
        }
    }
}

// A vertex is sound when one walk round it meets all of its corners.
void CollapseMesh::lockOddVertices()
{
    std::vector<uint32_t> corners(vertexSlots(), 0), out;
    std::vector<uint32_t> any(vertexSlots(), none);
    for (uint32_t h = uint32_t(vertex_.size()); h-- > 0;) {
        ++corners[from(h)];
        any[from(h)] = h;
    }
    // A face with a vertex twice is kept as it is.
    for (uint32_t h = 0; h < vertex_.size(); h += 3)
        if (from(h) == from(h + 1) || from(h + 1) == from(h + 2) || from(h + 2) == from(h))
            for (uint32_t k = 0; k < 3; ++k) kind_[from(h + k)] = Locked;
    bool open = false;
    for (uint32_t v = 0; v < vertexSlots(); ++v) {
        if (any[v] == none || kind_[v] == Locked) continue;
        fan(any[v], out, open);
        if (out.size() < std::min<size_t>(corners[v], mostFan)) kind_[v] = Locked;
    }
}

void CollapseMesh::markBends(double angle)
{
    const double least = std::cos(glm::radians(angle));
    for (uint32_t h = 0; h < vertex_.size(); ++h) {
        if (twin_[h] == none || twin_[h] < h) continue;
        const glm::dvec3 a = areaNormal(h / 3), b = areaNormal(twin_[h] / 3);
        if (glm::dot(a, b) >= least * glm::length(a) * glm::length(b)) continue;
        sharp_[h] |= bend;
        sharp_[twin_[h]] |= bend;
    }
}

void CollapseMesh::classify()
{
    std::vector<uint32_t> curves(vertexSlots(), 0);
    for (uint32_t h = 0; h < vertex_.size(); ++h) {
        if (!onCurve(h) || twin_[h] < h) continue;
        ++curves[from(h)];
        ++curves[to(h)];
    }
    for (size_t v = 0; v < curves.size(); ++v)
        if (curves[v] > 0) kind_[v] = std::max<uint8_t>(kind_[v], curves[v] == 2 ? Curve : Corner);
}

bool CollapseMesh::collapsible(uint32_t h) const
{
    const Kind a = kind(from(h)), b = kind(to(h));
    if (a == Locked || b == Locked || (a == Corner && b == Corner)) return false;
    return a == Free || b == Free || onCurve(h);
}

glm::dvec3 CollapseMesh::areaNormal(uint32_t face) const
{
    const glm::dvec3& a = place_[vertex_[3 * face]];
    return glm::cross(place_[vertex_[3 * face + 1]] - a, place_[vertex_[3 * face + 2]] - a);
}

bool CollapseMesh::fan(uint32_t h, std::vector<uint32_t>& out, bool& open) const
{
    out.clear();
    uint32_t g = h;
    do {
        if (out.size() >= mostFan) return false;
        out.push_back(g);
        g = twin_[prev(g)];
    } while (g != none && g != h);
    open = g == none;
    if (!open) return true;
    const size_t turned = out.size();  // the side beyond h: its farthest half-edge shall come first
    for (g = twin_[h]; g != none; g = twin_[g]) {
        if (out.size() >= mostFan) return false;
        g = next(g);
        out.push_back(g);
    }
    std::reverse(out.begin() + std::ptrdiff_t(turned), out.end());
    std::rotate(out.begin(), out.begin() + std::ptrdiff_t(turned), out.end());
    return true;
}

const std::vector<uint32_t>& CollapseMesh::star(uint32_t h)
{
    const uint32_t g = twin_[h], dying = h / 3, dyingToo = g == none ? none : g / 3;
    star_.clear();
    const bool v = fan(h, fanV_, openV_), w = fan(g == none ? next(h) : g, fanW_, openW_);
    tooMany_ = !v || !w;
    if (tooMany_) return star_;
    for (const auto* one : {&fanV_, &fanW_})
        for (const uint32_t c : *one)
            if (c / 3 != dying && c / 3 != dyingToo) star_.push_back(c);
    return star_;
}

// The link condition: the rings of v and w share the tips of the faces that go and nothing else (Dey and others 1999). A border counts as one more
// vertex that all border vertices share, hence an inner edge between two borders is refused by the rule on curves.
Refusal CollapseMesh::linkRefusal(uint32_t h, Verdict& v)
{
    const uint32_t g = twin_[h];
    v.allowed = g == none ? 1 : 2;
    ++stampNow_;
    for (const uint32_t c : fanV_) stamp_[to(c)] = stampNow_;
    if (openV_) stamp_[from(prev(fanV_.back()))] = stampNow_;
    size_t ringW = fanW_.size();
    for (const uint32_t c : fanW_) v.common += stamp_[to(c)] == stampNow_;
    if (openW_) {
        v.common += stamp_[from(prev(fanW_.back()))] == stampNow_;
        ++ringW;
    }
    if (v.common != v.allowed || star_.empty()) return Refusal::Link;
    if (!openV_ && !openW_ && fanV_.size() == 3 && ringW == 3) return Refusal::Link;  // a tetrahedron
    for (const uint32_t side : {h, g}) {
        if (side == none) continue;
        const uint32_t x = next(side), y = prev(side);
        if (twin_[x] == none && twin_[y] == none) return Refusal::Link;  // the tip would be left alone
        if (onCurve(x) && onCurve(y)) return Refusal::Feature;           // two curves would become one
    }
    return Refusal::None;
}

// Whether faces i and j of the star, neighbours across the side to `rim`, lay on each other; where a face between them goes, whether one of them lay
// on that.
bool CollapseMesh::foldedBefore(uint32_t h, size_t i, size_t j, uint32_t rim) const
{
    for (const uint32_t side : {h, twin_[h]}) {
        if (side == none || from(prev(side)) != rim) continue;
        const glm::dvec3 gone = areaNormal(side / 3);
        return glm::dot(before_[i], gone) <= 0 || glm::dot(before_[j], gone) <= 0;
    }
    return glm::dot(before_[i], before_[j]) <= 0;
}

// No face may turn far, and no two neighbours may come to lie on each other that did not before: inside the star and across its rim.
Refusal CollapseMesh::shapeRefusal(uint32_t h, const glm::dvec3& p, Verdict& v) const
{
    thread_local std::vector<glm::dvec3> after;
    after.clear();
    const double limit = options_.turnCosine;
    for (size_t i = 0; i < star_.size(); ++i) {
        const uint32_t c = star_[i];
        const glm::dvec3 n = glm::cross(place_[to(c)] - p, place_[from(prev(c))] - p);
        after.push_back(n);
        const double dot = glm::dot(before_[i], n), old = glm::dot(before_[i], before_[i]), now = glm::dot(n, n);
        if (old == 0 && now > 0) continue;  // had no direction
        const double size = std::sqrt(old * now), turn = size > 0 ? dot / size : -1;
        v.turn = std::min(v.turn, turn);
        if (!(turn > limit)) return Refusal::Turn;
    }
    for (size_t i = 0; i < star_.size(); ++i) {
        const uint32_t last = from(prev(star_[i])), outer = twin_[next(star_[i])];
        for (size_t j = 0; j < star_.size(); ++j)
            if (last == to(star_[j]) && glm::dot(after[i], after[j]) <= 0 && !foldedBefore(h, i, j, last)) return Refusal::Fold;
        if (outer == none) continue;
        const glm::dvec3 n = areaNormal(outer / 3);
        if (glm::dot(n, after[i]) <= 0 && glm::dot(n, before_[i]) > 0) return Refusal::Fold;
    }
    return Refusal::None;
}

Verdict CollapseMesh::test(uint32_t h, const glm::dvec3& p)
{
    Verdict v;
    if (!collapsible(h)) {
        v.refusal = std::max(kind(from(h)), kind(to(h))) == Locked ? Refusal::Locked : Refusal::Feature;
        return v;
    }
    if (tooMany_) {
        v.refusal = Refusal::Valence;
        return v;
    }
    v.refusal = linkRefusal(h, v);
    if (v.refusal != Refusal::None) return v;
    before_.clear();
    for (const uint32_t c : star_) {
        before_.push_back(areaNormal(c / 3));
        const double length = glm::length(before_.back());
        if (length > 0) v.deviation = std::max(v.deviation, std::abs(glm::dot(before_.back(), p - place_[from(c)])) / length);
        for (const uint32_t side : {c, prev(c)}) {  // a curve moves by what the new point is off its lines
            if (!onCurve(side)) continue;
            const glm::dvec3 line = place_[to(side)] - place_[from(side)];
            const double size = glm::length(line);
            if (size > 0) v.deviation = std::max(v.deviation, glm::length(glm::cross(line, p - place_[from(side)])) / size);
        }
    }
    v.refusal = shapeRefusal(h, p, v);
    return v;
}

void CollapseMesh::unite(std::vector<uint32_t>& parent, uint32_t a, uint32_t b)
{
    const auto root = [&](uint32_t x) {
        while (parent[x] != x) x = parent[x] = parent[parent[x]];
        return x;
    };
    a = root(a), b = root(b);
    parent[std::max(a, b)] = std::min(a, b);
}

// Takes the face of h out and joins what was beyond its two outer sides.
void CollapseMesh::closeFace(uint32_t h)
{
    const uint32_t inner[2] = {next(h), prev(h)}, outer[2] = {twin_[inner[0]], twin_[inner[1]]};
    const uint8_t sharp = uint8_t(sharp_[inner[0]] | sharp_[inner[1]]);
    const float crease = crease_.empty() ? 0 : std::max(crease_[inner[0]], crease_[inner[1]]);
    for (int k = 0; k < 2; ++k) {
        if (outer[k] == none) continue;
        twin_[outer[k]] = outer[1 - k];
        sharp_[outer[k]] |= sharp;
        if (outer[1 - k] != none) sharp_[outer[k]] |= sharp_[outer[1 - k]];
        if (!crease_.empty()) crease_[outer[k]] = std::max(crease_[outer[k]], crease);
    }
    vertex_[h - h % 3] = none;
    --faces_;
    if (watched_) faceRank_.remove(h / 3);
}

uint32_t CollapseMesh::collapse(uint32_t h, const glm::dvec3& p)
{
    const uint32_t v = from(h), w = to(h), g = twin_[h];
    if (!wedge_.empty()) {
        unite(wedge_, h, next(h));
        if (g != none) unite(wedge_, g, next(g));
    }
    const uint32_t stays = star_.front();
    for (const uint32_t c : star_) vertex_[c] = v;
    closeFace(h);
    if (g != none) closeFace(g);
    place_[v] = p;
    kind_[v] = std::max(kind_[v], kind_[w]);
    into_[w] = v;
    if (watched_) vertexRank_.remove(w);
    return stays;
}

}  // namespace mw
