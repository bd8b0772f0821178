// The body as the zero set of a field of distances, meshed by surface nets (Gibson 1998): one vertex in each cell the surface passes, one
// quad around each grid edge it crosses. Left and right are the same to the last bit.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/character/mannequin.h"

namespace mw {

namespace {

using glm::dvec3;

/// A cone with a ball at each end. `flat` presses it along an axis about the first ball.
struct Limb {
    dvec3 a, b;
    double ra, rb;
    dvec3 flat{1};
};

double distanceTo(const Limb& l, const dvec3& where)
{
    const dvec3 p = (where - l.a) / l.flat, ba = (l.b - l.a) / l.flat;
    const double least = std::min({l.flat.x, l.flat.y, l.flat.z});
    const double l2 = glm::dot(ba, ba);
    if (l2 == 0) return (glm::length(p) - l.ra) * least;
    // Round cone: Quilez, "Distance functions".
    const double rr = l.ra - l.rb, a2 = l2 - rr * rr, il2 = 1 / l2, y = glm::dot(p, ba), z = y - l2;
    const dvec3 across = p * l2 - ba * y;
    const double x2 = glm::dot(across, across), y2 = y * y * l2, z2 = z * z * l2, k = (rr < 0 ? -1 : 1) * rr * rr * x2;
    double d;
    if ((z < 0 ? -1 : 1) * a2 * z2 > k)
        d = std::sqrt(x2 + z2) * il2 - l.rb;
    else if ((y < 0 ? -1 : 1) * a2 * y2 < k)
        d = std::sqrt(x2 + y2) * il2 - l.ra;
    else
        d = (std::sqrt(x2 * a2 * il2) + y * rr) * il2 - l.ra;
    return d * least;
}

/// Of the left half; the right one is its mirror.
const std::vector<Limb>& limbs()
{
    static const std::vector<Limb> all = [] {
        std::vector<Limb> l{
            // head: skull, jaw, nose; neck
            {{0, 1.655, -0.014}, {0, 1.660, 0.012}, 0.082, 0.078, {0.92, 1.06, 1.08}},
            {{0, 1.645, 0.008}, {0, 1.580, 0.022}, 0.074, 0.053, {0.92, 1, 1}},
            {{0, 1.640, 0.088}, {0, 1.622, 0.090}, 0.004, 0.008},
            {{0, 1.44, -0.020}, {0, 1.57, -0.006}, 0.050, 0.046},
            {{0.018, 1.505, -0.030}, {0.115, 1.425, -0.022}, 0.036, 0.034},
            // trunk: shoulder girdle, ribs, waist, pelvis
            {{0, 1.415, -0.018}, {0.135, 1.402, -0.018}, 0.062, 0.048, {1, 1, 1}},
            {{0, 1.31, -0.004}, {0.066, 1.315, -0.006}, 0.110, 0.098, {1, 1.1, 0.80}},
            {{0, 1.22, 0.002}, {0.050, 1.22, 0}, 0.098, 0.090, {1, 1.1, 0.80}},
            {{0, 1.10, 0.004}, {0.042, 1.10, 0.002}, 0.086, 0.078, {1, 1.2, 0.82}},
            {{0, 1.045, 0.002}, {0.050, 1.035, 0.000}, 0.086, 0.078, {1, 1.2, 0.84}},
            {{0, 0.985, 0.000}, {0.064, 0.950, -0.002}, 0.090, 0.088, {1, 1.1, 0.88}},
            {{0.066, 0.905, -0.034}, {0.068, 0.945, -0.026}, 0.070, 0.068},
            {{0.064, 1.325, 0.038}, {0.085, 1.335, 0.034}, 0.052, 0.046, {1, 1, 0.8}},
            // leg
            {{0.093, 0.90, 0.002}, {0.100, 0.52, 0.006}, 0.078, 0.050},
            {{0.100, 0.52, 0.010}, {0.101, 0.475, 0.008}, 0.047, 0.043},
            {{0.102, 0.40, -0.014}, {0.104, 0.33, -0.012}, 0.048, 0.042},
            {{0.101, 0.49, 0.002}, {0.105, 0.10, -0.004}, 0.044, 0.031},
            // foot: heel, instep, ball, toes
            {{0.105, 0.034, -0.040}, {0.105, 0.060, -0.012}, 0.033, 0.034},
            {{0.105, 0.075, 0.000}, {0.100, 0.034, 0.110}, 0.034, 0.026},
            {{0.104, 0.030, -0.010}, {0.122, 0.026, 0.105}, 0.030, 0.025},
            {{0.086, 0.024, 0.130}, {0.092, 0.018, 0.186}, 0.023, 0.018},
            {{0.108, 0.023, 0.130}, {0.112, 0.017, 0.182}, 0.021, 0.017},
            {{0.128, 0.022, 0.120}, {0.130, 0.016, 0.164}, 0.020, 0.015},
        };
        // The arm, along its own line from the shoulder: t along, s to the palm, z.
        const dvec3 shoulder(0.172, 1.405, -0.018), along(std::sqrt(0.5), -std::sqrt(0.5), 0), palm(-std::sqrt(0.5), -std::sqrt(0.5), 0);
        const auto at = [&](double t, double s, double z) { return shoulder + along * t + palm * s + dvec3(0, 0, z); };
        for (const Limb& piece : {
                 Limb{at(-0.012, 0, 0), at(0.05, 0, 0), 0.055, 0.050},
                 Limb{at(0.04, 0, 0), at(0.28, 0, -0.002), 0.047, 0.037},
                 Limb{at(0.13, 0.004, 0.008), at(0.18, 0.002, 0.006), 0.041, 0.038},
                 Limb{at(0.28, 0, -0.002), at(0.53, 0, 0.004), 0.038, 0.024},
                 Limb{at(0.33, 0.002, 0), at(0.38, 0.002, 0), 0.040, 0.035},
                 Limb{at(0.53, 0, 0.004), at(0.56, 0, 0.006), 0.025, 0.024},
                 // hand: palm, fingers held together, thumb
                 Limb{at(0.550, 0.002, 0.018), at(0.615, 0.004, 0.027), 0.019, 0.017},
                 Limb{at(0.550, 0.002, -0.004), at(0.615, 0.004, -0.015), 0.019, 0.017},
                 Limb{at(0.600, 0.004, 0.006), at(0.620, 0.004, 0.006), 0.017, 0.017},
                 Limb{at(0.615, 0.004, 0.028), at(0.694, 0.014, 0.024), 0.0150, 0.0125},
                 Limb{at(0.620, 0.004, 0.006), at(0.708, 0.015, 0.006), 0.0155, 0.0125},
                 Limb{at(0.615, 0.004, -0.015), at(0.686, 0.014, -0.012), 0.0150, 0.0120},
                 Limb{at(0.550, 0.006, 0.024), at(0.592, 0.020, 0.053), 0.0175, 0.0140},
                 Limb{at(0.592, 0.020, 0.053), at(0.628, 0.028, 0.062), 0.0140, 0.0120},
             })
            l.push_back(piece);
        return l;
    }();
    return all;
}

/// All limbs blended: the smooth minimum by exponentials does not depend on their order. The soles are flat.
double field(dvec3 p)
{
    constexpr double blend = 0.011;
    p.x = std::abs(p.x);
    double distances[64], least = 1e9;
    size_t n = 0;
    for (const Limb& l : limbs()) least = std::min(least, distances[n++] = distanceTo(l, p));
    double sum = 0;
    for (size_t i = 0; i < n; ++i)
        if (const double beyond = (distances[i] - least) / blend; beyond < 30) sum += std::exp(-beyond);
    const double body = least - blend * std::log(sum), below = -p.y;
    constexpr double edge = 0.006;
    const double h = std::max(edge - std::abs(body - below), 0.0) / edge;
    return std::max(body, below) + h * h * edge / 4;
}

/// Grid lines: finer where hands and feet are. Symmetric about 0 when `mirrored`.
std::vector<double> lines(std::initializer_list<std::array<double, 2>> untilWithStep, double from, bool mirrored)
{
    std::vector<double> at{from};
    for (const auto& [until, step] : untilWithStep) {
        const double begin = at.back();
        const int n = std::max(1, int(std::lround((until - begin) / step)));
        for (int i = 1; i <= n; ++i) at.push_back(begin + (until - begin) * i / n);
    }
    if (!mirrored) return at;
    std::vector<double> both;
    for (size_t i = at.size() - 1; i > 0; --i) both.push_back(-at[i]);
    both.insert(both.end(), at.begin(), at.end());
    return both;
}

class SurfaceNet {
public:
    SurfaceNet();
    Mesh mesh();

private:
    size_t index(size_t x, size_t y, size_t z) const { return (z * y_.size() + y) * x_.size() + x; }
    dvec3 corner(size_t x, size_t y, size_t z) const { return {x_[x], y_[y], z_[z]}; }
    void sample();
    void placeVertices();
    void addQuads();
    void relax();

    std::vector<double> x_, y_, z_;
    std::vector<float> value_;
    std::vector<uint32_t> vertexOf_;  // by cell, named by its lowest corner
    std::vector<dvec3> vertices_;
    Array<uint32_t> corners_;
};

SurfaceNet::SurfaceNet()
    : x_(lines({{0.20, 0.0182}, {0.52, 0.0178}, {0.72, 0.0130}}, 0, true)),
      y_(lines({{0.09, 0.0125}, {0.84, 0.0225}, {1.06, 0.0150}, {1.80, 0.0185}}, -0.021, false)),
      z_(lines({{0.23, 0.0164}}, -0.160, false))
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
                const double middle = field(0.5 * (low + high));
                const bool far = std::abs(middle) > 0.5 * glm::length(high - low) + 0.03;
                for (size_t z = bz; z < ez; ++z)
                    for (size_t y = by; y < ey; ++y)
                        for (size_t x = bx; x < ex; ++x) value_[index(x, y, z)] = float(far ? middle : field(corner(x, y, z)));
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
dvec3 ontoSurface(const dvec3& p)
{
    constexpr double h = 1e-4;
    const double here = field(p);
    dvec3 g;
    for (int i = 0; i < 3; ++i) {
        dvec3 d(0);
        d[i] = h;
        g[i] = (field(p + d) - here) / h;
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

Mesh mannequinBody()
{
    return SurfaceNet().mesh();
}

}  // namespace mw
