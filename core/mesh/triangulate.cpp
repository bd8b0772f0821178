// Polygons cut into triangles: fans where a face is convex, ear clipping where it is not.
#include "core/mesh/triangulate.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>

#include "core/mesh/normals.h"

namespace mw {

namespace {

/// Twice the signed area of the triangle a b c.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Clips the ears of one polygon after the other; keeps its arrays between them.
class EarClipper {
public:
    explicit EarClipper(size_t budget) : budget_(budget) {}

    /// `points`: the polygon, counter-clockwise. Writes triples of its corner numbers to `out`.
    void clip(const std::vector<glm::dvec2>& points, std::vector<uint32_t>& out);

private:
    enum class Corner : uint8_t { Convex, Straight, Reflex };
    void classify(uint32_t i);
    bool isEar(uint32_t i);
    void cut(uint32_t i, std::vector<uint32_t>& out);
    uint32_t leastBad(uint32_t from) const;

    const std::vector<glm::dvec2>* points_ = nullptr;
    std::vector<uint32_t> next_, before_, reflex_;
    std::vector<Corner> kind_;
    size_t budget_;  // tests of a point against an ear, all polygons together
};

void EarClipper::classify(uint32_t i)
{
    const auto& p = *points_;
    const double t = turn(p[before_[i]], p[i], p[next_[i]]);
    kind_[i] = t > 0 ? Corner::Convex : t < 0 ? Corner::Reflex : Corner::Straight;
}

/// Convex, and no other corner inside. Only a corner that is not convex can be the innermost one. Corners at the same place as one of the
/// three (the bridge to a hole is walked twice) do not count as inside.
bool EarClipper::isEar(uint32_t i)
{
    if (budget_ > 0) --budget_;
    if (kind_[i] != Corner::Convex) return false;
    const auto& p = *points_;
    const glm::dvec2 a = p[before_[i]], b = p[i], c = p[next_[i]];
    for (const uint32_t r : reflex_) {
        if (budget_ > 0) --budget_;
        if (kind_[r] == Corner::Convex || r == i || r == before_[i] || r == next_[i]) continue;
        const glm::dvec2 q = p[r];
        if (q == a || q == b || q == c) continue;
        if (turn(a, b, q) >= 0 && turn(b, c, q) >= 0 && turn(c, a, q) >= 0) return false;
    }
    return true;
}

void EarClipper::cut(uint32_t i, std::vector<uint32_t>& out)
{
    const uint32_t a = before_[i], c = next_[i];
    out.insert(out.end(), {a, i, c});
    next_[a] = c;
    before_[c] = a;
    kind_[i] = Corner::Convex;  // no obstacle any more
    classify(a);
    classify(c);
}

/// The corner to cut when no ear is left (the outline crosses or touches itself): a straight one, which costs nothing, else a convex one.
uint32_t EarClipper::leastBad(uint32_t from) const
{
    uint32_t convex = none, i = from;
    do {
        if (kind_[i] == Corner::Straight) return i;
        if (kind_[i] == Corner::Convex && convex == none) convex = i;
        i = next_[i];
    } while (i != from);
    return convex == none ? from : convex;
}

void EarClipper::clip(const std::vector<glm::dvec2>& points, std::vector<uint32_t>& out)
{
    const uint32_t n = uint32_t(points.size());
    points_ = &points;
    next_.resize(n);
    before_.resize(n);
    kind_.resize(n);
    reflex_.clear();
    for (uint32_t i = 0; i < n; ++i) {
        next_[i] = (i + 1) % n;
        before_[i] = (i + n - 1) % n;
    }
    for (uint32_t i = 0; i < n; ++i) {
        classify(i);
        if (kind_[i] != Corner::Convex) reflex_.push_back(i);
    }
    uint32_t left = n, i = 0, tried = 0;
    while (left > 3 && budget_ > 0) {
        const bool stuck = tried > left;
        if (stuck) i = leastBad(i);
        if (!stuck && !isEar(i)) {
            i = next_[i];
            ++tried;
            continue;
        }
        cut(i, out);
        i = next_[next_[i]];  // not the neighbour: ears all round give better triangles than one fan
        --left;
        tried = 0;
        if ((left & 63) == 0) std::erase_if(reflex_, [&](uint32_t r) { return kind_[r] == Corner::Convex; });
    }
    for (; left >= 3; --left) cut(next_[i], out);
}

/// Which cut of a quad keeps both triangles on the side of its normal: 0 from the first corner, 1 from the second.
uint32_t quadCut(const glm::dvec3 p[4], const glm::dvec3& normal)
{
    auto worst = [&](int a, int b, int c, int d) {  // triangles a b c and a c d
        const double one = glm::dot(glm::cross(p[b] - p[a], p[c] - p[a]), normal), two = glm::dot(glm::cross(p[c] - p[a], p[d] - p[a]), normal);
        return std::min(one, two);
    };
    const double first = worst(0, 1, 2, 3);
    return first > 0 || first >= worst(1, 2, 3, 0) ? 0 : 1;
}

class Cutter {
public:
    explicit Cutter(const Mesh& mesh) : mesh_(mesh), clipper_(size_t(64) << 20) {}
    Mesh::Triangulation run();

private:
    void polygon(size_t f);
    void project(std::span<const uint32_t> face, const glm::dvec3& normal);
    bool isConvex() const;
    void emit(size_t f, uint32_t a, uint32_t b, uint32_t c);

    const Mesh& mesh_;
    EarClipper clipper_;
    std::vector<glm::dvec2> flat_;
    std::vector<uint32_t> triples_;
    Array<uint32_t> vertices_, corners_, faces_;
    size_t filled_ = 0;
};

/// Corners are given within the face.
void Cutter::emit(size_t f, uint32_t a, uint32_t b, uint32_t c)
{
    const uint32_t first = mesh_.faceStart()[f];
    const uint32_t corner[3] = {first + a, first + b, first + c};
    for (int k = 0; k < 3; ++k) {
        corners_[3 * filled_ + k] = corner[k];
        vertices_[3 * filled_ + k] = mesh_.cornerVertex()[corner[k]];
    }
    faces_[filled_++] = uint32_t(f);
}

/// Along the largest component of the normal, turned so that the polygon is counter-clockwise.
void Cutter::project(std::span<const uint32_t> face, const glm::dvec3& normal)
{
    const glm::dvec3 size = glm::abs(normal);
    const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    int u = (drop + 1) % 3, v = (drop + 2) % 3;
    if (normal[drop] < 0) std::swap(u, v);
    flat_.clear();
    for (const uint32_t w : face) flat_.emplace_back(mesh_.positions()[w][u], mesh_.positions()[w][v]);
}

/// All turns to the left and once round. A polygon that winds several times has no turn to the right either, but more than two changes of
/// direction along x.
bool Cutter::isConvex() const
{
    const size_t n = flat_.size();
    int changes = 0;
    double last = 0;
    for (size_t i = 0; i < n; ++i) {
        const glm::dvec2 &a = flat_[i], &b = flat_[(i + 1) % n], &c = flat_[(i + 2) % n];
        if (turn(a, b, c) <= 0) return false;
        const double x = b.x - a.x;
        if (x != 0 && last != 0 && (x > 0) != (last > 0)) ++changes;
        if (x != 0) last = x;
    }
    return changes <= 2;
}

void Cutter::polygon(size_t f)
{
    const auto face = mesh_.face(f);
    const uint32_t n = uint32_t(face.size());
    const glm::dvec3 normal = areaVector(mesh_, f);
    if (n == 4) {
        glm::dvec3 p[4];
        for (int k = 0; k < 4; ++k) p[k] = mesh_.positions()[face[size_t(k)]];
        const uint32_t k = quadCut(p, normal);
        emit(f, k, k + 1, k + 2);
        emit(f, k, k + 2, (k + 3) % 4);
        return;
    }
    project(face, normal);
    if (isConvex()) {
        for (uint32_t i = 1; i + 1 < n; ++i) emit(f, 0, i, i + 1);
        return;
    }
    triples_.clear();
    clipper_.clip(flat_, triples_);
    for (size_t i = 0; i + 2 < triples_.size(); i += 3) emit(f, triples_[i], triples_[i + 1], triples_[i + 2]);
}

Mesh::Triangulation Cutter::run()
{
    size_t total = 0;
    for (size_t f = 0; f < mesh_.faceCount(); ++f) total += mesh_.face(f).size() < 3 ? 0 : mesh_.face(f).size() - 2;
    vertices_.resize(3 * total);
    corners_.resize(3 * total);
    faces_.resize(total);
    for (size_t f = 0; f < mesh_.faceCount(); ++f) {
        const size_t n = mesh_.face(f).size();
        if (n == 3)
            emit(f, 0, 1, 2);
        else if (n > 3)
            polygon(f);
    }
    return {std::move(vertices_), std::move(corners_), std::move(faces_)};
}

}  // namespace

Mesh::Triangulation triangulationOf(const Mesh& mesh)
{
    if (!mesh.isTriangles()) return Cutter(mesh).run();
    Array<uint32_t> corners(mesh.cornerCount()), faces(mesh.faceCount());
    std::iota(corners.begin(), corners.end(), 0u);
    std::iota(faces.begin(), faces.end(), 0u);
    return {mesh.cornerVertex(), std::move(corners), std::move(faces)};
}

}  // namespace mw
