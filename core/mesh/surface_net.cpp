#include "core/mesh/surface_net.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace mw {

namespace {

using glm::dvec3;

class SurfaceNet {
public:
    SurfaceNet(NetLines lines, DistanceField f);
    Mesh mesh();

private:
    size_t index(size_t x, size_t y, size_t z) const { return (z * y_.size() + y) * x_.size() + x; }
    dvec3 corner(size_t x, size_t y, size_t z) const { return {x_[x], y_[y], z_[z]}; }
    void sample();
    void placeVertices();
    void addQuads();
    void relax();

    dvec3 ontoSurface(const dvec3& p) const;

    std::vector<double> x_, y_, z_;
    DistanceField field_;
    std::vector<float> value_;
    std::vector<uint32_t> vertexOf_;  // by cell, named by its lowest corner
    std::vector<dvec3> vertices_;
    Array<uint32_t> corners_;
};

SurfaceNet::SurfaceNet(NetLines lines, DistanceField f) : x_(std::move(lines.x)), y_(std::move(lines.y)), z_(std::move(lines.z)), field_(std::move(f))
{
    sample();
    placeVertices();
    addQuads();
    relax();
}

// Most of the space is far from the surface: the field changes by no more than one moves, so whole blocks need one look.
void SurfaceNet::sample()
{
    value_.assign(x_.size() * y_.size() * z_.size(), 0);
    constexpr size_t block = 6;
    for (size_t bz = 0; bz < z_.size(); bz += block)
        for (size_t by = 0; by < y_.size(); by += block)
            for (size_t bx = 0; bx < x_.size(); bx += block) {
                const size_t ex = std::min(bx + block, x_.size()), ey = std::min(by + block, y_.size()), ez = std::min(bz + block, z_.size());
                const dvec3 low = corner(bx, by, bz), high = corner(ex - 1, ey - 1, ez - 1);
                const double middle = field_(0.5 * (low + high));
                const bool far = std::abs(middle) > 0.5 * glm::length(high - low) + 0.03;
                for (size_t z = bz; z < ez; ++z)
                    for (size_t y = by; y < ey; ++y)
                        for (size_t x = bx; x < ex; ++x) value_[index(x, y, z)] = float(far ? middle : field_(corner(x, y, z)));
            }
}

void SurfaceNet::placeVertices()
{
    vertexOf_.assign(value_.size(), none);
    for (size_t z = 0; z + 1 < z_.size(); ++z)
        for (size_t y = 0; y + 1 < y_.size(); ++y)
            for (size_t x = 0; x + 1 < x_.size(); ++x) {
                dvec3 sum(0);
                int crossings = 0;
                const auto look = [&](size_t x0, size_t y0, size_t z0, size_t x1, size_t y1, size_t z1) {
                    const double a = double(value_[index(x0, y0, z0)]), b = double(value_[index(x1, y1, z1)]);
                    if ((a < 0) == (b < 0)) return;
                    sum += glm::mix(corner(x0, y0, z0), corner(x1, y1, z1), a / (a - b));
                    ++crossings;
                };
                for (size_t i = 0; i < 2; ++i)
                    for (size_t k = 0; k < 2; ++k) {
                        look(x, y + i, z + k, x + 1, y + i, z + k);
                        look(x + i, y, z + k, x + i, y + 1, z + k);
                        look(x + i, y + k, z, x + i, y + k, z + 1);
                    }
                if (!crossings) continue;
                vertexOf_[index(x, y, z)] = uint32_t(vertices_.size());
                vertices_.push_back(sum / double(crossings));
            }
}

void SurfaceNet::addQuads()
{
    const auto quad = [&](bool outwards, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
        if (outwards)
            corners_.insert(corners_.end(), {a, b, c, d});
        else
            corners_.insert(corners_.end(), {d, c, b, a});
    };
    for (size_t z = 1; z + 1 < z_.size(); ++z)
        for (size_t y = 1; y + 1 < y_.size(); ++y)
            for (size_t x = 1; x + 1 < x_.size(); ++x) {
                const bool inside = value_[index(x, y, z)] < 0;
                const auto cell = [&](size_t dx, size_t dy, size_t dz) { return vertexOf_[index(x - dx, y - dy, z - dz)]; };
                if (inside != (value_[index(x + 1, y, z)] < 0)) quad(inside, cell(0, 1, 1), cell(0, 0, 1), cell(0, 0, 0), cell(0, 1, 0));
                if (inside != (value_[index(x, y + 1, z)] < 0)) quad(inside, cell(1, 0, 1), cell(1, 0, 0), cell(0, 0, 0), cell(0, 0, 1));
                if (inside != (value_[index(x, y, z + 1)] < 0)) quad(inside, cell(1, 1, 0), cell(0, 1, 0), cell(0, 0, 0), cell(1, 0, 0));
            }
}

/// One step of Newton's towards the surface.
dvec3 SurfaceNet::ontoSurface(const dvec3& p) const
{
    constexpr double h = 1e-4;
    const double here = field_(p);
    dvec3 g;
    for (int i = 0; i < 3; ++i) {
        dvec3 d(0);
        d[i] = h;
        g[i] = (field_(p + d) - here) / h;
    }
    return p - g * (here / std::max(glm::dot(g, g), 0.25));
}

// Evens out the quads: each vertex moves towards the middle of its neighbours, then back onto the surface. The left half is computed, the
// right one mirrored: sums in another order would differ in the last bit.
void SurfaceNet::relax()
{
    const size_t n = vertices_.size();
    std::vector<uint32_t> mirror(n);
    const size_t last = x_.size() - 2;
    for (size_t z = 0; z + 1 < z_.size(); ++z)
        for (size_t y = 0; y + 1 < y_.size(); ++y)
            for (size_t x = 0; x + 1 < x_.size(); ++x)
                if (const uint32_t v = vertexOf_[index(x, y, z)]; v != none) mirror[v] = vertexOf_[index(last - x, y, z)];
    const auto even = [&] {
        for (size_t v = 0; v < n; ++v)
            if (vertices_[v].x > 0) vertices_[mirror[v]] = vertices_[v] * dvec3(-1, 1, 1);
    };
    even();
    constexpr int rounds = 6;
    for (int round = 0; round < rounds; ++round) {
        std::vector<dvec3> sum(n, dvec3(0));
        std::vector<int> count(n, 0);
        for (size_t q = 0; q < corners_.size(); q += 4)
            for (size_t k = 0; k < 4; ++k) {
                const uint32_t a = corners_[q + k], b = corners_[q + (k + 1) % 4];
                sum[a] += vertices_[b], ++count[a];
            }
        for (size_t v = 0; v < n; ++v) {
            if (vertices_[v].x <= 0) continue;
            dvec3 p = glm::mix(vertices_[v], sum[v] / double(count[v]), 0.5);
            for (int step = round < rounds - 1 ? 1 : 3; step > 0; --step) p = ontoSurface(p);
            vertices_[v] = p;
        }
        even();
    }
}

Mesh SurfaceNet::mesh()
{
    Array<glm::vec3> positions;
    for (const dvec3& v : vertices_) positions.emplace_back(v);
    Array<uint32_t> start{0u};
    for (size_t i = 4; i <= corners_.size(); i += 4) start.push_back(uint32_t(i));
    return Mesh(std::move(positions), std::move(start), std::move(corners_));
}

}  // namespace

Mesh mirroredSurfaceNet(NetLines lines, DistanceField field)
{
    return SurfaceNet(std::move(lines), std::move(field)).mesh();
}

}  // namespace mw
