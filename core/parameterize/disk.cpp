// Tests for a disk, and outlines for its border.
#include "core/parameterize/disk.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <string>

#include "core/error.h"
#include "core/mesh/rings.h"
#include "core/mesh/topology.h"

namespace mw {
namespace {

[[noreturn]] void refuse(const std::string& why)
{
    throw Error("Planar embedding needs a disk, but this mesh " + why);
}

std::string several(size_t n, const char* one, const char* many)
{
    return n == 1 ? std::string("one ") + one : std::to_string(n) + " " + many;
}

void expectDisk(const Mesh& mesh)
{
    const TopologyReport& t = mesh.topology();
    if (mesh.faceCount() == 0) refuse("has no faces. Add some first.");
    if (!t.degenerateFaces.empty())
        refuse("has " + several(t.degenerateFaces.size(), "face", "faces") + " with fewer than three different corners. Add Repair before it.");
    if (!t.manifold())
        refuse("is not a manifold: " + std::to_string(t.nonmanifoldEdges.size()) + " edges and " + std::to_string(t.nonmanifoldVertices.size()) +
               " vertices have too many faces. Add Repair before it.");
    if (!t.orientable) refuse("has only one side (like a Moebius band). Add Orient faces with cut before it.");
    if (!t.consistentlyOriented) refuse("has neighbouring faces turned against each other. Add Orient faces before it.");
    if (t.components > 1) refuse("has " + std::to_string(t.components) + " pieces. Keep one of them, or separate them into objects.");
    if (t.closed) refuse("is closed. Cut it open before (modifier Cut open).");
    if (t.boundaryLoops.size() > 1)
        refuse("has " + std::to_string(t.boundaryLoops.size()) +
               " boundaries. Fill the holes, or cut it open before (modifier Cut open joins them).");
    if (t.euler != 1) refuse("has genus " + std::to_string(t.genus.value_or(0)) + ". Cut it open before (modifier Cut open).");
}

/// Lengths of the edges of the border, the first from border[0].
std::vector<double> borderLengths(const Disk& disk)
{
    const size_t n = disk.border.size();
    std::vector<double> length(n);
    double sum = 0;
    for (size_t i = 0; i < n; ++i) {
        const glm::dvec3 a(disk.triangles.positions()[disk.border[i]]), b(disk.triangles.positions()[disk.border[(i + 1) % n]]);
        sum += length[i] = glm::length(b - a);
    }
    // No two vertices at one place.
    for (double& l : length) l = std::max(l, sum > 0 ? 1e-6 * sum / double(n) : 1.0);
    return length;
}

std::vector<glm::dvec2> onCircle(const std::vector<double>& steps)
{
    double sum = 0, before = 0;
    for (const double s : steps) sum += s;
    std::vector<glm::dvec2> places;
    for (const double s : steps) {
        const double angle = 2 * std::numbers::pi * before / sum;
        places.emplace_back(std::cos(angle), std::sin(angle));
        before += s;
    }
    return places;
}

/// Four vertices of the border as corners of a square.
class Corners {
public:
    explicit Corners(const Disk& disk);
    /// Places in the border, ascending from the first, which may be any.
    std::array<size_t, 4> best() const;

private:
    size_t next(size_t first, double target, size_t after, size_t left) const;
    double cost(const std::array<size_t, 4>& corner) const;

    size_t n_;
    std::vector<double> angle_, along_;  // sum of the angles of the faces; distance from border[0], once more round at n and beyond
    double total_ = 0;
    std::vector<std::pair<size_t, size_t>> chords_;  // inner edges between two vertices of the border
};

Corners::Corners(const Disk& disk) : n_(disk.border.size()), angle_(n_, 0.0)
{
    const Mesh& mesh = disk.triangles;
    Array<uint32_t> at(mesh.vertexCount(), none);
    for (size_t i = 0; i < n_; ++i) at[disk.border[i]] = uint32_t(i);
    for (size_t c = 0; c < mesh.cornerCount(); ++c) {
        const size_t f = c - c % 3;
        const uint32_t v = mesh.cornerVertex()[c], a = mesh.cornerVertex()[f + (c + 1) % 3], b = mesh.cornerVertex()[f + (c + 2) % 3];
        if (at[v] == none) continue;
        const glm::dvec3 p(mesh.positions()[v]), u = glm::dvec3(mesh.positions()[a]) - p, w = glm::dvec3(mesh.positions()[b]) - p;
        angle_[at[v]] += std::atan2(glm::length(glm::cross(u, w)), glm::dot(u, w));
    }
    const std::vector<double> length = borderLengths(disk);
    for (size_t i = 0; i < 2 * n_; ++i) {
        along_.push_back(total_);
        total_ += length[i % n_];
    }
    total_ /= 2;
    for (size_t i = 0; i < n_; ++i)
        for (const uint32_t w : mesh.rings().neighboursOf(disk.border[i]))
            if (at[w] != none && at[w] > i + 1 && !(i == 0 && at[w] == n_ - 1)) chords_.push_back({i, at[w]});
}

/// The sharpest vertex about a quarter of the way on.
size_t Corners::next(size_t first, double target, size_t after, size_t left) const
{
    size_t found = 0, nearest = after + 1;
    double least = std::numeric_limits<double>::infinity();
    const double reach = total_ / 12;
    for (size_t i = after + 1; i + left < first + n_; ++i) {
        const double off = std::abs(along_[i] - along_[first] - target), worth = angle_[i % n_] + 0.5 * off / reach;
        if (off < std::abs(along_[nearest] - along_[first] - target)) nearest = i;
        if (off > reach || worth >= least) continue;
        least = worth;
        found = i;
    }
    return least < 1e9 ? found : nearest;
}

double Corners::cost(const std::array<size_t, 4>& corner) const
{
    double sum = 0;
    for (size_t k = 0; k < 4; ++k) {
        sum += angle_[corner[k] % n_];
        const double side = along_[k < 3 ? corner[k + 1] : corner[0] + n_] - along_[corner[k]];
        sum += 4 * std::abs(side / total_ - 0.25);
    }
    // Edges whose two ends would lie on one side: the faces beyond them would be flat.
    for (const auto& [a, b] : chords_) {
        const auto side = [&](size_t i, bool later) {
            const size_t at = i < corner[0] ? i + n_ : i;
            size_t k = 0;
            while (k < 3 && (later ? at >= corner[k + 1] : at > corner[k + 1])) ++k;
            return k == 0 && at == corner[0] && !later ? size_t(3) : k;
        };
        if (side(a, true) == side(b, true) || side(a, false) == side(b, false) || side(a, true) == side(b, false) || side(a, false) == side(b, true))
            sum += 100;
    }
    return sum;
}

std::array<size_t, 4> Corners::best() const
{
    std::vector<size_t> firsts(n_);
    for (size_t i = 0; i < n_; ++i) firsts[i] = i;
    std::stable_sort(firsts.begin(), firsts.end(), [&](size_t a, size_t b) { return angle_[a] < angle_[b]; });
    firsts.resize(std::min<size_t>(n_, 32));
    std::array<size_t, 4> best{};
    double least = std::numeric_limits<double>::infinity();
    for (const size_t first : firsts) {
        std::array<size_t, 4> corner{first, 0, 0, 0};
        for (size_t k = 1; k < 4; ++k) corner[k] = next(first, total_ * double(k) / 4, corner[k - 1], 3 - k);
        const double c = cost(corner);
        if (c < least) {
            least = c;
            best = corner;
        }
    }
    return best;
}

std::vector<glm::dvec2> onSquare(const Disk& disk)
{
    constexpr glm::dvec2 places[4] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const std::vector<double> length = borderLengths(disk);
    const size_t n = length.size();
    const std::array<size_t, 4> corner = Corners(disk).best();
    std::vector<glm::dvec2> out(n);
    for (size_t k = 0; k < 4; ++k) {
        const size_t first = corner[k], last = k < 3 ? corner[k + 1] : corner[0] + n;
        double side = 0, before = 0;
        for (size_t i = first; i < last; ++i) side += length[i % n];
        for (size_t i = first; i < last; ++i) {
            out[i % n] = places[k] + before / side * (places[(k + 1) % 4] - places[k]);
            before += length[i % n];
        }
    }
    return out;
}

}  // namespace

Disk diskOf(const Mesh& mesh)
{
    expectDisk(mesh);
    Disk disk{mesh.isTriangles() ? mesh : Mesh::triangles(mesh.positions(), mesh.triangulation().vertices), mesh.topology().boundaryLoops[0], {}, {}};
    std::reverse(disk.border.begin(), disk.border.end());
    std::rotate(disk.border.begin(), std::min_element(disk.border.begin(), disk.border.end()), disk.border.end());
    disk.unknown = Array<uint32_t>(mesh.vertexCount(), none);
    std::vector<bool> onBorder(mesh.vertexCount());
    for (const uint32_t v : disk.border) onBorder[v] = true;
    const Rings& rings = disk.triangles.rings();
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
        if (onBorder[v] || rings.cornersOf(v).empty()) continue;
        disk.unknown[v] = uint32_t(disk.inner.size());
        disk.inner.push_back(v);
    }
    return disk;
}

std::vector<glm::dvec2> outlinePlaces(const Disk& disk, PlanarOutline outline)
{
    if (outline == PlanarOutline::Circle) return onCircle(std::vector<double>(disk.border.size(), 1.0));
    if (outline == PlanarOutline::Chord || disk.border.size() < 4) return onCircle(borderLengths(disk));
    return onSquare(disk);
}

}  // namespace mw
