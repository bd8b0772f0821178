// How the tables of the quick decimation are made: order, twins, curves, quadrics.
#include "core/simplify/quick_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.h"
#include "core/simplify/ranges.h"

namespace mw::quick {

namespace {

constexpr size_t regionFaces = size_t(1) << 17;
constexpr uint64_t taken = ~uint64_t(0);

/// Eight bits with two gaps after each.
uint32_t spread(uint32_t x)
{
    x = (x | x << 8) & 0x00f00f;
    x = (x | x << 4) & 0x0c30c3;
    return (x | x << 2) & 0x249249;
}

int leastCorner(const int* v)
{
    return v[1] < v[0] ? (v[2] < v[1] ? 2 : 1) : (v[2] < v[0] ? 2 : 0);
}
int middleOf(const int* v)
{
    return std::max(std::min(v[0], v[1]), std::min(std::max(v[0], v[1]), v[2]));
}

/// Ascending by the 24 bits above the index, equal ones as they were: two passes of 12 bits.
void sortByCode(LargeBuffer<uint64_t>& keys)
{
    LargeBuffer<uint64_t> other(keys.size());
    for (const int shift : {32, 44}) {
        std::vector<uint32_t> place(4097, 0);
        for (size_t i = 0; i < keys.size(); ++i) ++place[(keys[i] >> shift & 4095) + 1];
        std::partial_sum(place.begin(), place.end(), place.begin());
        for (size_t i = 0; i < keys.size(); ++i) other[place[keys[i] >> shift & 4095]++] = keys[i];
        std::swap(keys, other);
    }
}

}  // namespace

Tables::Tables(Mesh input, const Rules& given, bool watched) : rules(given), input_(std::move(input)), old_(input_), watched_(watched)
{
    if (old_.size() >= size_t(1) << 29) throw mw::Error("the mesh has over 500 million triangles; cut it into parts first");
    measure();
    orderVertices();
    findTwins(orderFaces());
    lockOddOnes();
    const SeamTest seams(input_, old_);
    markSeams(seams);
    markBends();
    classify();
    if (seams.cornersCarry()) joinWedges();
    gatherQuadrics();
    if (rules.deviation >= 0) deviation.assign(vertices.size(), 0.f);
    if (!watched_) return;
    vertexRank_ = LiveRank(vertices.size());
    faceRank_ = LiveRank(faces.size());
}

void Tables::measure()
{
    const Bounds box = input_.bounds();
    const glm::dvec3 size = box.size();
    centre_ = box.centre();
    scale_ = std::max({size.x, size.y, size.z});
    if (!(scale_ > 0)) scale_ = 1;
}

Float4 Tables::scaled(const glm::vec3& p) const
{
    const glm::dvec3 q = (glm::dvec3(p) - centre_) / scale_;
    return Float4{float(q.x), float(q.y), float(q.z), 0};
}

glm::vec3 Tables::position(Float4 p) const
{
    return glm::vec3(glm::dvec3(p[0], p[1], p[2]) * scale_ + centre_);
}

glm::vec3 Tables::position(const Vertex& v) const
{
    const glm::vec3 old = input_.positions()[v.old];
    const Float4 p = scaled(old);
    return p[0] == v.place[0] && p[1] == v.place[1] && p[2] == v.place[2] ? old : position(v.place);
}

// Vertices go into the order of a Morton curve over 256 cells a side.
void Tables::orderVertices()
{
    const auto& positions = input_.positions();
    const size_t n = positions.size();
    LargeBuffer<uint64_t> keys(n);
    inPieces(n, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            const glm::dvec3 cell = ((glm::dvec3(positions[i]) - centre_) / scale_ + 0.5) * 255.99;
            const uint32_t code = spread(uint32_t(cell.x)) | spread(uint32_t(cell.y)) << 1 | spread(uint32_t(cell.z)) << 2;
            keys[i] = uint64_t(code) << 32 | i;
        }
    });
    sortByCode(keys);
    vertices.take(n);
    rank.resize(n);
    inPieces(n, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            const uint32_t old = uint32_t(keys[i]);
            rank[old] = uint32_t(i);
            vertices[i] = {scaled(positions[old]), zero, Free, int(i), old, 0};
        }
    });
}

// Faces follow their least vertex. How many there are up to each one's.
std::vector<uint32_t> Tables::orderFaces()
{
    const size_t n = old_.size();
    LargeBuffer<uint32_t> corner(3 * n), least(n);
    inPieces(n, [&](size_t begin, size_t end) {
        for (size_t f = begin; f < end; ++f) {
            uint32_t* const c = corner.data() + 3 * f;
            for (size_t k = 0; k < 3; ++k) c[k] = rank[old_.vertices[3 * f + k]];
            least[f] = std::min({c[0], c[1], c[2]});
        }
    });
    std::vector<uint32_t> place(vertices.size() + 1, 0);
    for (size_t f = 0; f < n; ++f) ++place[least[f] + 1];
    std::partial_sum(place.begin(), place.end(), place.begin());
    makeRegions(place.data());
    faces.take(n);
    for (size_t f = 0; f < n; ++f) {
        const uint32_t* const c = corner.data() + 3 * f;
        faces[place[least[f]]++] = {{int(c[0]), int(c[1]), int(c[2])}, 0, {-1, -1, -1}, uint32_t(f)};
    }
    return place;
}

void Tables::makeRegions(const uint32_t* facesBefore)
{
    const size_t count = std::max<size_t>(1, old_.size() / regionFaces);
    const uint32_t* const end = facesBefore + vertices.size();
    uint32_t from = 0;
    for (size_t i = 1; i <= count; ++i) {
        const auto to = i == count ? vertices.size() : size_t(std::lower_bound(facesBefore, end, uint32_t(i * old_.size() / count)) - facesBefore);
        regions.push_back({{int(from), int(to)}, int(facesBefore[from]), int(facesBefore[to])});
        from = uint32_t(to);
    }
}

void Tables::lock(int v)
{
    std::atomic_ref<uint32_t>(vertices[size_t(v)].flag).fetch_or(Locked, std::memory_order_relaxed);
}

// Half-edges are put into lists by their lower end; in a list, those with the same other end are one edge. Two that run against each other are twins;
// anything else that has company is no edge of a surface, and its ends are locked. As faces follow their least vertex, two sides of each are where
// they belong; only the third ones, from the middle vertex to the greatest, are sorted.
void Tables::findTwins(const std::vector<uint32_t>& facesUpTo)
{
    const auto listed = [](int far, int h) { return uint64_t(far) << 32 | uint32_t(h); };
    std::vector<uint32_t> start(vertices.size() + 2, 0);
    for (size_t f = 0; f < faces.size(); ++f) ++start[size_t(middleOf(faces[f].v)) + 2];
    std::partial_sum(start.begin(), start.end(), start.begin());
    LargeBuffer<uint64_t> thirds(faces.size());
    for (size_t f = 0; f < faces.size(); ++f) {
        const int* v = faces[f].v;
        thirds[start[size_t(middleOf(v)) + 1]++] = listed(std::max({v[0], v[1], v[2]}), next(int(4 * f) + leastCorner(v)));
    }
    inPieces(vertices.size(), [&](size_t begin, size_t end) {
        std::vector<uint64_t> sides;
        for (size_t v = begin; v < end; ++v) {
            const size_t first = v > 0 ? facesUpTo[v - 1] : 0, own = 2 * (facesUpTo[v] - first), all = own + start[v + 1] - start[v];
            if (sides.size() < all) sides.resize(2 * all);
            for (size_t f = first; f < facesUpTo[v]; ++f) {
                const int h = int(4 * f) + leastCorner(faces[f].v), g = prev(h);
                sides[2 * (f - first)] = listed(to(h), h), sides[2 * (f - first) + 1] = listed(from(g), g);
            }
            std::copy(thirds.data() + start[v], thirds.data() + start[v + 1], sides.data() + own);
            twinsOf(int(v), sides.data(), sides.data() + all);
        }
    });
}

void Tables::twinsOf(int v, uint64_t* first, uint64_t* last)
{
    const bool sorted = last - first > 24;  // a hub: comparing each with each takes too long
    if (sorted) std::sort(first, last);
    for (; first != last; ++first) {
        if (*first == taken) continue;
        const uint64_t far = *first >> 32;
        const int h = int(uint32_t(*first));
        uint64_t* other = nullptr;
        size_t company = 0;
        for (uint64_t* e = first + 1; e != last; ++e) {
            if (*e >> 32 == far) {
                other = e, ++company;
            } else if (sorted) {
                break;
            }
        }
        const int g = company ? int(uint32_t(*other)) : -1;
        if (company == 1 && from(h) != from(g) && far != uint64_t(v)) {
            faces[size_t(h >> 2)].twin[h & 3] = g, faces[size_t(g >> 2)].twin[g & 3] = h;
            *other = taken;
            continue;
        }
        anyCurve_.store(true, std::memory_order_relaxed);
        if (company || far == uint64_t(v)) lock(v), lock(int(far));
        for (uint64_t* e = first + 1; company && e != last; ++e)
            if (*e >> 32 == far) *e = taken, --company;
    }
}

// A face with a vertex twice is kept as it is, and so are the ends of loose lines.
void Tables::lockOddOnes()
{
    for (size_t f = 0; f < faces.size(); ++f) {
        const int* v = faces[f].v;
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
            for (int k = 0; k < 3; ++k) lock(v[k]);
    }
    for (const uint32_t v : input_.lines()) lock(int(rank[v]));
}

void Tables::markSeams(const SeamTest& seams)
{
    if (!seams.any()) return;
    if (seams.creases()) crease_.assign(4 * faces.size(), 0.f);
    inPieces(faces.size(), [&](size_t begin, size_t end) {
        for (int h = int(4 * begin); h < int(4 * end); ++h) {
            if ((h & 3) == 3) continue;
            if (seams.creases()) crease_[size_t(h)] = seams.crease(oldCorner(h));
            if (twin(h) < h || !seams.parts(oldCorner(h), oldCorner(twin(h)))) continue;
            for (const int side : {h, twin(h)})
                std::atomic_ref<uint32_t>(faces[size_t(side >> 2)].bits).fetch_or(1u << (Face::curve + (side & 3)), std::memory_order_relaxed);
            anyCurve_.store(true, std::memory_order_relaxed);
        }
    });
}

void Tables::markBends()
{
    if (!(rules.bend > -1)) return;
    for (int h = 0; h < int(4 * faces.size()); ++h) {
        if ((h & 3) == 3 || twin(h) < h) continue;
        const Float4 a = normal(h >> 2), b = normal(twin(h) >> 2);
        if (double(dot(a, b)) >= double(rules.bend) * std::sqrt(double(dot(a, a)) * double(dot(b, b)))) continue;
        for (const int side : {h, twin(h)}) {
            faces[size_t(side >> 2)].bits |= 1u << (Face::bent + (side & 3));
            vertices[size_t(from(side))].flag |= Vertex::nearWall;
        }
    }
}

void Tables::classify()
{
    if (!anyCurve_) return;
    std::vector<uint8_t> curves(vertices.size(), 0);
    const auto count = [&](int v) { curves[size_t(v)] = uint8_t(std::min(curves[size_t(v)] + 1, 3)); };
    for (int h = 0; h < int(4 * faces.size()); ++h)
        if ((h & 3) != 3 && onCurve(h) && (twin(h) < 0 || twin(h) > h)) count(from(h)), count(to(h));
    for (size_t v = 0; v < curves.size(); ++v) {
        if (curves[v] == 0) continue;
        uint32_t& flag = vertices[v].flag;
        const uint32_t kind = std::max<uint32_t>(flag & Vertex::kindBits, curves[v] == 2 ? Curve : Corner);
        flag = kind | Vertex::nearWall;
    }
}

Symmetric Tables::wallOf(int h, Float4 n) const
{
    const Float4 side = vertices[size_t(to(h))].place - vertices[size_t(from(h))].place, m = cross(n, side);
    const float length = dot(m, m);
    return length > 0 ? square(m) * (2 * rules.wall * dot(side, side) / length) : zero;
}

void Tables::give(int f, float sign)
{
    const Float4 n = normal(f);
    const Symmetric q = faceQuadric(n) * sign;
    for (int k = 0; k < 3; ++k) {
        Vertex& v = vertices[size_t(faces[size_t(f)].v[k])];
        v.quadric = v.quadric + q;
        if (!(v.flag & Vertex::nearWall) || !weighed(4 * f + k)) continue;
        Vertex& w = vertices[size_t(to(4 * f + k))];
        const Symmetric wall = wallOf(4 * f + k, n) * sign;
        v.quadric = v.quadric + wall;
        w.quadric = w.quadric + wall;
    }
}

// Each region adds the faces that lie in it; those that reach over into the next one come afterwards.
void Tables::gatherQuadrics()
{
    std::vector<std::vector<int>> mixed(regions.size());
    const auto add = [&](int f) {
        give(f, 1);
        for (const int v : faces[size_t(f)].v) ++vertices[size_t(v)].faces;
    };
    tbb::parallel_for(size_t(0), regions.size(), [&](size_t i) {
        const Region& r = regions[i];
        for (int f = r.firstFace; f < r.lastFace; ++f) {
            const int* v = faces[size_t(f)].v;
            if (r.vertices.holds(v[0]) && r.vertices.holds(v[1]) && r.vertices.holds(v[2]))
                add(f);
            else
                mixed[i].push_back(f);
        }
    });
    for (const auto& list : mixed)
        for (const int f : list) add(f);
}

Target Tables::endTarget(const Vertex& a, const Vertex& b) const
{
    const Float4 d = b.place - a.place;
    const Target first = firstEnd(b.quadric, d), second = secondEnd(a.quadric, d);
    if (a.kind() != b.kind()) return a.kind() > b.kind() ? first : second;
    return first.cost <= second.cost ? first : second;
}

}  // namespace mw::quick
