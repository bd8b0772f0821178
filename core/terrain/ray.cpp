// A walk over tiles, and within tiles whose heights the ray may reach over cells. In a cell the height above ground is a quadratic
// polynomial of the ray's parameter, so the meeting is exact.
#include "core/terrain/ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mw {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A part of the ray.
struct Span {
    double from, to;
};

/// Cuts the part in which origin + t * direction lies within least..most.
void cut(Span& s, double origin, double direction, double least, double most)
{
    if (direction == 0) {
        if (origin < least || origin > most) s = {1, 0};
        return;
    }
    const double a = (least - origin) / direction, b = (most - origin) / direction;
    s = {std::max(s.from, std::min(a, b)), std::min(s.to, std::max(a, b))};
}

/// Squares of `side` cells that a walk may enter, both ends included.
struct Field {
    int side, x0, z0, x1, z1;
};

class Walker {
public:
    Walker(const HeightMap& map, double scale, glm::dvec3 origin, glm::dvec3 direction)
        : map_(map), scale_(scale), origin_(origin), direction_(direction)
    {}
    std::optional<double> run(Span s);

private:
    template <class Visit>
    bool walk(const Field& f, Span s, const Visit& visit) const;
    bool block(int tx, int tz, Span s);
    bool cell(int x, int z, Span s);
    bool misses(double least, double most, Span s);
    double y(double t) const { return origin_.y + t * direction_.y; }

    const HeightMap& map_;
    double scale_;
    glm::dvec3 origin_, direction_;
    double above_ = 0;  // sign of the height above ground where the last cell was left; 0: not known
    double met_ = 0;
};

/// Calls visit(x, z, part of the ray) for each square the ray crosses, in order, until it says true.
template <class Visit>
bool Walker::walk(const Field& f, Span s, const Visit& visit) const
{
    const auto square = [&](double at, int lo, int hi) { return std::clamp(int(std::floor(at / f.side)), lo, hi); };
    int x = square(origin_.x + s.from * direction_.x, f.x0, f.x1), z = square(origin_.z + s.from * direction_.z, f.z0, f.z1);
    const auto leaves = [&](int i, double o, double d) { return d == 0 ? infinity : (double(i + (d > 0)) * f.side - o) / d; };
    for (double t = s.from;;) {
        const double outX = leaves(x, origin_.x, direction_.x), outZ = leaves(z, origin_.z, direction_.z);
        const double end = std::max(t, std::min({outX, outZ, s.to}));
        if (visit(x, z, Span{t, end})) return true;
        if (end >= s.to) return false;
        if (outX <= outZ)
            x += direction_.x > 0 ? 1 : -1;
        else
            z += direction_.z > 0 ? 1 : -1;
        if (x < f.x0 || x > f.x1 || z < f.z0 || z > f.z1) return false;
        t = end;
    }
}

/// True when the ray stays above or below all heights of a part.
bool Walker::misses(double least, double most, Span s)
{
    if (scale_ < 0) std::swap(least, most);
    const double a = y(s.from), b = y(s.to);
    if (std::min(a, b) > most * scale_) return above_ = 1, true;
    if (std::max(a, b) < least * scale_) return above_ = -1, true;
    return false;
}

bool Walker::block(int tx, int tz, Span s)
{
    const int size = int(HeightMap::tileSize);
    float least = std::numeric_limits<float>::infinity(), most = -least;
    // Its last cells end at the first samples of the next tiles.
    for (int j = tz; j <= std::min(tz + 1, int(map_.tilesY()) - 1); ++j)
        for (int i = tx; i <= std::min(tx + 1, int(map_.tilesX()) - 1); ++i) {
            const auto [lo, hi] = map_.range(uint32_t(i), uint32_t(j));
            least = std::min(least, lo), most = std::max(most, hi);
        }
    if (misses(double(least), double(most), s)) return false;
    const Field cells{1, tx * size, tz * size, std::min(tx * size + size, int(map_.width()) - 1) - 1,
                      std::min(tz * size + size, int(map_.height()) - 1) - 1};
    return walk(cells, s, [this](int x, int z, Span part) { return cell(x, z, part); });
}

bool Walker::cell(int x, int z, Span s)
{
    const auto i = uint32_t(x), j = uint32_t(z);
    const double h00 = double(map_.at(i, j)), h10 = double(map_.at(i + 1, j)), h01 = double(map_.at(i, j + 1)), h11 = double(map_.at(i + 1, j + 1));
    if (misses(std::min({h00, h10, h01, h11}), std::max({h00, h10, h01, h11}), s)) return false;
    // Height of the cell a + b u + c v + e u v; above ground q0 + q1 r + q2 r^2 with r counted from where the ray enters.
    const double u = origin_.x + s.from * direction_.x - x, v = origin_.z + s.from * direction_.z - z;
    const double du = direction_.x, dv = direction_.z, b = h10 - h00, c = h01 - h00, e = h00 - h10 - h01 + h11;
    const double q0 = y(s.from) - scale_ * (h00 + b * u + c * v + e * u * v);
    const double q1 = direction_.y - scale_ * (b * du + c * dv + e * (u * dv + v * du)), q2 = -scale_ * e * du * dv;
    const double length = s.to - s.from;
    const auto meets = [&](double r) { return met_ = s.from + std::clamp(r, 0.0, length), true; };
    if (q0 == 0 || q0 * above_ < 0) return meets(0);  // rounding must let no ray slip through between two cells
    const double discriminant = q1 * q1 - 4 * q2 * q0;
    double first = infinity;
    if (discriminant >= 0) {
        const double q = -0.5 * (q1 + std::copysign(std::sqrt(discriminant), q1));  // no cancellation
        for (double r : {q2 != 0 ? q / q2 : infinity, q != 0 ? q0 / q : infinity})
            if (r >= 0) first = std::min(first, r);
    }
    if (first <= length) return meets(first);
    above_ = q0 > 0 ? 1 : -1;
    return false;
}

std::optional<double> Walker::run(Span s)
{
    const int size = int(HeightMap::tileSize), lastX = int(map_.width()) - 2, lastZ = int(map_.height()) - 2;
    const Field blocks{size, 0, 0, lastX / size, lastZ / size};
    if (walk(blocks, s, [this](int x, int z, Span part) { return block(x, z, part); })) return met_;
    return std::nullopt;
}

}  // namespace

std::optional<double> meetGrid(const HeightMap& map, double scale, glm::dvec3 origin, glm::dvec3 direction)
{
    for (int k = 0; k < 3; ++k)
        if (!std::isfinite(origin[k]) || !std::isfinite(direction[k])) return std::nullopt;
    if (map.empty() || direction == glm::dvec3(0)) return std::nullopt;
    auto [least, most] = map.range();
    const double low = std::min(double(least) * scale, double(most) * scale), high = std::max(double(least) * scale, double(most) * scale);
    const double slack = 1e-6 * (high - low) + 1e-9 * std::max({1.0, std::abs(low), std::abs(high)});
    Span s{0, infinity};
    cut(s, origin.x, direction.x, 0, map.width() - 1);
    cut(s, origin.z, direction.z, 0, map.height() - 1);
    cut(s, origin.y, direction.y, low - slack, high + slack);
    if (!(s.from <= s.to)) return std::nullopt;
    return Walker(map, scale, origin, direction).run(s);
}

}  // namespace mw
