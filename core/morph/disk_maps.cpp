// Two disks on one convex outline: their borders get each other's vertices, then each is laid out by its planar embedding.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/morph/morph_maps.h"
#include "core/parameterize/embed_planar.h"

namespace mw {

namespace {

/// A border: its half-edges once round, the mesh on the left.
std::vector<uint32_t> border(const MorphMesh& mesh)
{
    const std::vector<Direction> nowhere(mesh.positions.size());
    const DomainMesh map(nowhere, mesh.corners);
    std::vector<uint32_t> at(mesh.positions.size(), none), out;
    uint32_t first = none;
    for (uint32_t h = 0; h < mesh.corners.size(); ++h) {
        if (map.opposite(h) != none) continue;
        at[map.from(h)] = h;
        if (first == none || map.from(h) < map.from(first)) first = h;
    }
    uint32_t h = first;
    do {
        out.push_back(h);
        h = at[map.to(h)];
    } while (h != none && h != first && out.size() <= mesh.corners.size());
    return out;
}

/// A vertex of the common border: its share of the way round, and which vertex of each mesh it is, none where it is still to be made.
struct BorderPoint {
    double share;
    uint32_t vertex[2] = {none, none};
};

/// A border by the length of its edges.
struct Outline {
    std::vector<uint32_t> halves;
    std::vector<double> share;  ///< of the tail of each
    std::vector<glm::dvec3> place;

    Outline(const MorphMesh& mesh) : halves(border(mesh))
    {
        double length = 0;
        for (const uint32_t h : halves) {
            const glm::dvec3 &a = mesh.positions[mesh.corners[h]], &b = mesh.positions[mesh.corners[DomainMesh::next(h)]];
            share.push_back(length);
            place.push_back(a);
            length += glm::distance(a, b);
        }
        for (size_t i = 0; i < share.size(); ++i) share[i] = length > 0 ? share[i] / length : double(i) / double(share.size());
    }
    glm::dvec3 at(double s) const
    {
        s -= std::floor(s);
        const size_t n = share.size(), i = size_t(std::upper_bound(share.begin(), share.end(), s) - share.begin()) - 1;
        const double end = i + 1 < n ? share[i + 1] : 1, t = end > share[i] ? (s - share[i]) / (end - share[i]) : 0;
        return (1 - t) * place[i] + t * place[(i + 1) % n];
    }
};

/// The share of the second border at which the first one begins, so that borders of one middle and size are near each other.
double aligningShift(const Outline& a, const Outline& b)
{
    constexpr int samples = 256;
    const auto sampled = [](const Outline& o) {
        std::vector<glm::dvec3> p;
        glm::dvec3 mean(0);
        for (int i = 0; i < samples; ++i) p.push_back(o.at(double(i) / samples)), mean += p.back() / double(samples);
        double size = 0;
        for (glm::dvec3& q : p) q -= mean, size += glm::dot(q, q);
        for (glm::dvec3& q : p) q /= std::max(std::sqrt(size), 1e-30);
        return p;
    };
    const std::vector<glm::dvec3> p = sampled(a), q = sampled(b);
    int best = 0;
    double least = -1;
    for (int shift = 0; shift < samples; ++shift) {
        double sum = 0;
        for (int i = 0; i < samples; ++i) {
            const glm::dvec3 d = p[size_t(i)] - q[size_t((i + shift) % samples)];
            sum += glm::dot(d, d);
        }
        if (least < 0 || sum < least) least = sum, best = shift;
    }
    return double(best) / samples;
}

/// All border points of both in order; those of the two that nearly meet are one.
std::vector<BorderPoint> united(const Outline& a, const Outline& b, double shift, const MorphMesh (&meshes)[2])
{
    std::vector<BorderPoint> all;
    for (int m = 0; m < 2; ++m) {
        const Outline& o = m == 0 ? a : b;
        for (size_t i = 0; i < o.halves.size(); ++i) {
            double s = o.share[i] - (m == 0 ? 0 : shift);
            BorderPoint p{s - std::floor(s), {none, none}};
            p.vertex[m] = meshes[m].corners[o.halves[i]];
            all.push_back(p);
        }
    }
    std::stable_sort(all.begin(), all.end(), [](const BorderPoint& x, const BorderPoint& y) { return x.share < y.share; });
    const double near = 1e-6;
    std::vector<BorderPoint> out;
    for (const BorderPoint& p : all) {
        const int m = p.vertex[0] != none ? 0 : 1;
        if (!out.empty() && p.share - out.back().share < near && out.back().vertex[m] == none)
            out.back().vertex[m] = p.vertex[m];
        else
            out.push_back(p);
    }
    return out;
}

/// Puts the points that a mesh lacks on the edges of its border.
void insertBorder(MorphMesh& mesh, int m, const Outline& outline, double shift, std::vector<BorderPoint>& points)
{
    std::vector<uint32_t> halfFrom(mesh.positions.size(), none);  // border half-edge from a vertex
    std::vector<double> shareOf(mesh.positions.size(), 0), endOf(mesh.positions.size(), 0);
    for (size_t i = 0; i < outline.halves.size(); ++i) {
        const uint32_t v = mesh.corners[outline.halves[i]];
        halfFrom[v] = outline.halves[i];
        shareOf[v] = outline.share[i];
        endOf[v] = i + 1 < outline.share.size() ? outline.share[i + 1] : 1;
    }
    const size_t n = points.size();
    size_t begin = 0;
    while (points[begin].vertex[m] == none) ++begin;
    uint32_t half = none, tail = none, tailCorner = 0, headCorner = 0, head = none;
    for (size_t i = 0; i < n; ++i) {
        BorderPoint& p = points[(begin + i) % n];
        if (p.vertex[m] != none) {
            tail = p.vertex[m];
            half = halfFrom[tail];
            head = mesh.corners[DomainMesh::next(half)];
            tailCorner = mesh.cornerOf[half].a;
            headCorner = mesh.cornerOf[DomainMesh::next(half)].a;
            continue;
        }
        double s = p.share + (m == 0 ? 0 : shift);
        s -= std::floor(s);
        const double t = std::clamp((s - shareOf[tail]) / (endOf[tail] - shareOf[tail]), 1e-9, 1 - 1e-9);
        const uint32_t fresh = uint32_t(mesh.positions.size()), f = half / 3, next = DomainMesh::next(half), last = DomainMesh::previous(half);
        mesh.positions.push_back((1 - t) * glm::dvec3(mesh.source.positions()[mesh.vertexOf[tail].a]) +
                                 t * glm::dvec3(mesh.source.positions()[mesh.vertexOf[head].a]));
        mesh.vertexOf.push_back({mesh.vertexOf[tail].a, mesh.vertexOf[head].a, t});
        // The triangle keeps the part before the new vertex; the part behind it is a new one: new vertex, head, apex.
        const MorphMesh::Mix mix{tailCorner, headCorner, t}, headMix = mesh.cornerOf[next], apexMix = mesh.cornerOf[last];
        const uint32_t apex = mesh.corners[last], headVertex = mesh.corners[next], newHalf = uint32_t(mesh.corners.size());
        mesh.corners[next] = fresh;
        mesh.cornerOf[next] = mix;
        mesh.corners.insert(mesh.corners.end(), {fresh, headVertex, apex});
        mesh.cornerOf.insert(mesh.cornerOf.end(), {mix, headMix, apexMix});
        mesh.faceOf.push_back(mesh.faceOf[f]);
        if (headVertex < halfFrom.size() && halfFrom[headVertex] == next) halfFrom[headVertex] = newHalf + 1;
        half = newHalf;
        p.vertex[m] = fresh;
    }
}

/// Round the circle; no two nearer than a tenth of even steps.
std::vector<glm::dvec2> onCircle(const std::vector<BorderPoint>& points)
{
    std::vector<glm::dvec2> out;
    for (size_t i = 0; i < points.size(); ++i) {
        const double a = 2 * std::numbers::pi * (0.9 * points[i].share + 0.1 * double(i) / double(points.size()));
        out.push_back({std::cos(a), std::sin(a)});
    }
    return out;
}

DomainMesh mapOf(const MorphMesh& mesh, int m, const std::vector<BorderPoint>& points, EdgeWeights weights)
{
    const std::vector<glm::dvec2> circle = onCircle(points);
    std::vector<glm::dvec2> at(mesh.positions.size());
    for (size_t i = 0; i < points.size(); ++i) at[points[i].vertex[m]] = circle[i];
    const Disk disk = diskOf(mesh.mesh());
    std::vector<glm::dvec2> outline;
    for (const uint32_t v : disk.border) outline.push_back(at[v]);
    const std::vector<glm::dvec2> places = planarEmbedding(disk, weights, outline);
    std::vector<Direction> directions;
    for (const glm::dvec2& p : places) directions.push_back(Direction::inPlane(p.x, p.y));
    for (size_t i = 0; i < points.size(); ++i) directions[points[i].vertex[m]] = Direction::inPlane(circle[i].x, circle[i].y);
    return DomainMesh(std::move(directions), mesh.corners);
}

}  // namespace

MorphMaps diskMaps(const Mesh& first, const Mesh& second, bool align)
{
    MorphMaps out;
    Generator parts = diskMaps(first, second, align, out);
    while (parts.next()) {
    }
    return out;
}

Generator diskMaps(Mesh first, Mesh second, bool align, MorphMaps& out)
{
    out = MorphMaps();
    out.meshes[0] = MorphMesh::of(first);
    out.meshes[1] = MorphMesh::of(second);
    const Outline a(out.meshes[0]), b(out.meshes[1]);
    const double shift = align ? aligningShift(a, b) : 0;
    out.turn = 360 * shift;
    std::vector<BorderPoint> points = united(a, b, shift, out.meshes);
    insertBorder(out.meshes[0], 0, a, 0, points);
    insertBorder(out.meshes[1], 1, b, shift, points);
    for (int m = 0; m < 2; ++m) {
        co_yield Step("embed").progress(0.5 * m);
        const MorphMesh& mesh = out.meshes[m];
        DomainMesh map = mapOf(mesh, m, points, EdgeWeights::MeanValue);
        // Weights of needle-like triangles span so many orders that their places run together; equal weights do not look at them.
        co_yield Step("embed").progress(0.5 * m + 0.25);
        if (!map.folds().empty()) map = mapOf(mesh, m, points, EdgeWeights::Uniform);
        out.maps[m] = {std::move(map), mesh.positions, std::vector<double>(mesh.positions.size(), 1)};
    }
}

}  // namespace mw
