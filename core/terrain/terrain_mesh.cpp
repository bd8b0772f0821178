// A right-triangulated irregular network (Evans, Kirkpatrick, Townsend 2001): square roots of 2^n cells, each halved along a diagonal, every
// triangle halved from its right angle to the middle of its longest side as long as the error there asks for it. The error of a middle
// includes those of all finer middles that hang on it, so that neighbours halve together and no crack opens. Grids of any size are
// covered by roots that reach over the border; what lies beyond is cut off, always at samples, because edges run along rows, columns
// or diagonals.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/terrain/terrain.h"
#include "core/terrain/terrain_colors.h"

namespace mw {

namespace {

/// Heights in metres with water filled in, held beyond the border.
struct Surface {
    int64_t width, height;
    Array<float> y;

    explicit Surface(const Terrain& t) : width(t.map.width()), height(t.map.height()), y(t.map.rows())
    {
        for (float& h : y) h = float(std::max(t.maximumHeight * double(h), t.waterLevel));
    }
    float at(int64_t x, int64_t z) const { return y[size_t(std::min(z, height - 1) * width + std::min(x, width - 1))]; }
};

/// Roots of `side` cells, so many along x and z.
struct Roots {
    int64_t side = 1, x = 1, z = 1;
    int64_t area() const { return side * side * x * z; }
};

/// Little beyond the border, and few enough to leave room for detail.
Roots chooseRoots(int64_t cellsX, int64_t cellsZ, size_t budget)
{
    Roots best;
    for (int64_t side = int64_t(std::bit_ceil(uint64_t(std::max(cellsX, cellsZ)))); side >= 1; side /= 2) {
        const Roots r{side, (cellsX + side - 1) / side, (cellsZ + side - 1) / side};
        const bool first = best.x * best.z == 1 && best.side == 1;
        if (first || (uint64_t(r.x * r.z) * 16 <= budget && r.area() < best.area())) best = r;
    }
    return best;
}

/// For each middle of a longest side the largest error that halving there mends.
class Errors {
public:
    Errors(const Surface& surface, const Roots& roots, Progress* progress)
        : surface_(surface), width_(roots.side * roots.x + 1), height_(roots.side * roots.z + 1), error_(size_t(width_ * height_), 0.f)
    {
        int level = 0;
        for (int64_t s = 1; s <= roots.side / 2; s *= 2) {
            if (progress) progress->at(0.6f * float(level++) / 14);
            sides(s);
            centres(s);
        }
    }
    float at(int64_t x, int64_t z) const { return error_[size_t(z * width_ + x)]; }

private:
    template <class Row>
    void rows(int64_t from, int64_t step, const Row& row) const
    {
        const int64_t count = (height_ - 1 - from) / step + 1;
        tbb::parallel_for(tbb::blocked_range<int64_t>(0, count, 16), [&](const tbb::blocked_range<int64_t>& r) {
            for (int64_t i = r.begin(); i < r.end(); ++i) row(from + i * step);
        });
    }
    /// Errors of pictures of few grey values are often equal; a little dither lets any budget be met.
    static float dithered(float error, int64_t x, int64_t z)
    {
        const uint32_t h = (uint32_t(x) * 0x9e3779b1u ^ uint32_t(z) * 0x85ebca77u) * 0xc2b2ae3du;
        return error * (1 + 0.1f * float(h >> 8) * 0x1p-24f);
    }
    float bend(int64_t x, int64_t z, int64_t dx, int64_t dz) const
    {
        const float middle = surface_.at(x, z), a = surface_.at(x - dx, z - dz), b = surface_.at(x + dx, z + dz);
        return dithered(std::abs(middle - 0.5f * (a + b)), x, z);
    }
    float& ref(int64_t x, int64_t z) { return error_[size_t(z * width_ + x)]; }
    float inside(int64_t x, int64_t z) const { return x >= 0 && z >= 0 && x < width_ && z < height_ ? at(x, z) : 0.f; }

    /// Middles of the sides of squares of 2 s cells. The triangles on both sides have their finer middles at the corners of a small square.
    void sides(int64_t s)
    {
        rows(0, s, [&](int64_t z) {
            const bool alongX = z / s % 2 == 0;
            for (int64_t x = alongX ? s : 0; x < width_; x += 2 * s) {
                float e = alongX ? bend(x, z, s, 0) : bend(x, z, 0, s);
                if (const int64_t q = s / 2; q > 0)
                    for (const int64_t dz : {-q, q})
                        for (const int64_t dx : {-q, q}) e = std::max(e, inside(x + dx, z + dz));
                ref(x, z) = e;
            }
        });
    }
    /// Middles of squares of 2 s cells, halved by a diagonal through the middle of the square of 4 s cells.
    void centres(int64_t s)
    {
        rows(s, 2 * s, [&](int64_t z) {
            for (int64_t x = s; x < width_; x += 2 * s) {
                const bool falling = (x / (2 * s) + z / (2 * s)) % 2 == 0;
                const float finer = std::max({at(x - s, z), at(x + s, z), at(x, z - s), at(x, z + s)});
                ref(x, z) = std::max(bend(x, z, s, falling ? s : -s), finer);
            }
        });
    }

    const Surface& surface_;
    int64_t width_, height_;
    Array<float> error_;
};

struct Place {
    int32_t x, z;
    bool operator==(const Place&) const = default;
};

/// What is left of a triangle within the border.
struct Polygon {
    Place corner[6];
    int count = 0;
};

/// Keeps what lies at coordinate <= limit.
template <int32_t Place::*Coordinate>
Polygon cut(const Polygon& p, int32_t limit)
{
    Polygon out;
    for (int i = 0; i < p.count; ++i) {
        const Place a = p.corner[i], b = p.corner[(i + 1) % p.count];
        if (a.*Coordinate <= limit) out.corner[out.count++] = a;
        if ((a.*Coordinate < limit && b.*Coordinate > limit) || (a.*Coordinate > limit && b.*Coordinate < limit)) {
            const int32_t way = limit - a.*Coordinate, whole = b.*Coordinate - a.*Coordinate;  // the edge's slope is 0, 1 or -1
            out.corner[out.count++] = {a.x + (b.x - a.x) / whole * way, a.z + (b.z - a.z) / whole * way};
            out.corner[out.count - 1].*Coordinate = limit;
        }
    }
    return out;
}

/// Walks the tree down to the triangles that a threshold leaves.
class Cutter {
public:
    Cutter(const Roots& roots, const Errors& errors, int64_t width, int64_t height)
        : roots_(roots), errors_(errors), lastX_(int32_t(width - 1)), lastZ_(int32_t(height - 1))
    {}

    /// Their number, or any larger than `most`.
    size_t count(float threshold, size_t most)
    {
        size_t n = 0;
        run(threshold, [&](const Polygon& p) { return (n += size_t(p.count - 2)) <= most; });
        return n;
    }
    /// Calls emit(polygon) for each, until it says false.
    template <class Emit>
    void run(float threshold, const Emit& emit)
    {
        for (int64_t z = 0; z < roots_.z; ++z)
            for (int64_t x = 0; x < roots_.x; ++x) {
                const auto x0 = int32_t(x * roots_.side), z0 = int32_t(z * roots_.side), s = int32_t(roots_.side);
                const Place nw{x0, z0}, ne{x0 + s, z0}, sw{x0, z0 + s}, se{x0 + s, z0 + s};
                // Anticlockwise from above: z points towards the viewer.
                const bool more = (x + z) % 2 == 0 ? walk(se, nw, sw, threshold, emit) && walk(nw, se, ne, threshold, emit)
                                                   : walk(ne, sw, se, threshold, emit) && walk(sw, ne, nw, threshold, emit);
                if (!more) return;
            }
    }

private:
    /// The triangle with the longest side from a to b and the right angle at c.
    template <class Emit>
    bool walk(Place a, Place b, Place c, float threshold, const Emit& emit)
    {
        if (std::min({a.x, b.x, c.x}) >= lastX_ || std::min({a.z, b.z, c.z}) >= lastZ_) return true;
        const Place m{(a.x + b.x) / 2, (a.z + b.z) / 2};
        const bool smallest = std::abs(a.x - b.x) + std::abs(a.z - b.z) == 2 && a.x != b.x && a.z != b.z;
        if (!smallest && errors_.at(m.x, m.z) > threshold) return walk(c, a, m, threshold, emit) && walk(b, c, m, threshold, emit);
        Polygon p{{a, b, c}, 3};
        if (std::max({a.x, b.x, c.x}) > lastX_) p = cut<&Place::x>(p, lastX_);
        if (std::max({a.z, b.z, c.z}) > lastZ_) p = cut<&Place::z>(p, lastZ_);
        return p.count < 3 || emit(p);
    }

    const Roots& roots_;
    const Errors& errors_;
    int32_t lastX_, lastZ_;
};

/// The least threshold that keeps the budget; the numbers of floats are halved, not the floats.
float findThreshold(Cutter& cutter, size_t budget, Progress* progress)
{
    uint32_t low = 0, high = std::bit_cast<uint32_t>(std::numeric_limits<float>::max());
    if (cutter.count(0, budget) <= budget) return 0;
    for (int i = 0; low + 1 < high; ++i) {  // low makes too many, high does not
        if (progress) progress->at(0.6f + 0.01f * float(i));
        const uint32_t middle = low + (high - low) / 2;
        const size_t n = cutter.count(std::bit_cast<float>(middle), budget);
        (n <= budget ? high : low) = middle;
        if (n <= budget && n + n / 200 >= budget) break;
    }
    return std::bit_cast<float>(high);
}

/// Corners in the order in which triangles name them.
struct Sheet {
    Array<glm::vec3> positions;
    Array<Place> places;
    Array<uint32_t> corners;
};

Sheet sheetOf(const Terrain& t, const Surface& surface, Cutter& cutter, float threshold)
{
    Sheet out;
    Array<uint32_t> vertex(surface.y.size(), none);
    const double spacing = t.extent / double(surface.width - 1);
    const glm::dvec2 half = 0.5 * t.size();
    const auto use = [&](Place p) {
        uint32_t& v = vertex[size_t(p.z * surface.width + p.x)];
        if (v == none) {
            v = uint32_t(out.places.size());
            out.places.push_back(p);
            out.positions.push_back({float(p.x * spacing - half.x), surface.at(p.x, p.z), float(p.z * spacing - half.y)});
        }
        out.corners.push_back(v);
    };
    cutter.run(threshold, [&](const Polygon& p) {
        for (int i = 2; i < p.count; ++i) {
            use(p.corner[0]);
            use(p.corner[i - 1]);
            use(p.corner[i]);
        }
        return true;
    });
    return out;
}

Mesh dressed(const Terrain& t, const Sheet& sheet)
{
    Mesh mesh = Mesh::triangles(sheet.positions, sheet.corners);
    Array<float> normal, color, texcoord;
    for (size_t v = 0; v < sheet.places.size(); ++v) {
        const glm::vec3 n = mesh.vertexNormals()[v];
        const double ground = t.maximumHeight * double(t.map.at(uint32_t(sheet.places[v].x), uint32_t(sheet.places[v].z)));
        const glm::vec3 c = groundColor(t, ground, double(n.y));
        normal.insert(normal.end(), {n.x, n.y, n.z});
        color.insert(color.end(), {c.x, c.y, c.z});
    }
    for (uint32_t v : sheet.corners) {
        const Place p = sheet.places[v];
        texcoord.insert(texcoord.end(), {float(p.x / double(t.map.width() - 1)), float(1 - p.z / double(t.map.height() - 1))});
    }
    return mesh.with(floatAttribute(std::string(names::normal), Domain::Vertex, 3, std::move(normal)))
        .with(floatAttribute(std::string(names::color), Domain::Vertex, 3, std::move(color)))
        .with(floatAttribute(std::string(names::texcoord), Domain::Corner, 2, std::move(texcoord)));
}

}  // namespace

Mesh terrainMesh(const Terrain& t, size_t triangleBudget, Progress* progress)
{
    if (t.map.empty()) return {};
    const Surface surface(t);
    const Roots roots = chooseRoots(surface.width - 1, surface.height - 1, triangleBudget);
    const Errors errors(surface, roots, progress);
    Cutter cutter(roots, errors, surface.width, surface.height);
    const bool all = uint64_t(surface.width - 1) * uint64_t(surface.height - 1) * 2 <= triangleBudget;
    const float threshold = all ? -1 : findThreshold(cutter, triangleBudget, progress);
    if (progress) progress->at(0.9f);
    return dressed(t, sheetOf(t, surface, cutter, threshold));
}

double terrainMeshError(const Terrain& t, const Mesh& mesh)
{
    if (t.map.empty()) return 0;
    const Surface surface(t);
    const double spacing = t.extent / double(surface.width - 1);
    const glm::dvec2 half = 0.5 * t.size();
    double worst = 0;
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        glm::dvec3 p[3];
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 q(mesh.positions()[mesh.face(f)[size_t(k)]]);
            p[k] = {std::round((q.x + half.x) / spacing), q.y, std::round((q.z + half.y) / spacing)};
        }
        const double area = (p[1].x - p[0].x) * (p[2].z - p[0].z) - (p[2].x - p[0].x) * (p[1].z - p[0].z);
        if (area == 0) continue;
        const double slopeX = ((p[1].y - p[0].y) * (p[2].z - p[0].z) - (p[2].y - p[0].y) * (p[1].z - p[0].z)) / area;
        const double slopeZ = ((p[2].y - p[0].y) * (p[1].x - p[0].x) - (p[1].y - p[0].y) * (p[2].x - p[0].x)) / area;
        const double first = std::min({p[0].z, p[1].z, p[2].z}), last = std::max({p[0].z, p[1].z, p[2].z});
        for (double z = first; z <= last; ++z) {
            double from = std::numeric_limits<double>::infinity(), to = -from;
            for (int k = 0; k < 3; ++k) {  // where the row crosses the sides
                const glm::dvec3 a = p[k], b = p[(k + 1) % 3];
                if (std::min(a.z, b.z) > z || std::max(a.z, b.z) < z) continue;
                const double x = a.z == b.z ? a.x : a.x + (b.x - a.x) * (z - a.z) / (b.z - a.z);
                from = std::min({from, x, a.z == b.z ? b.x : x}), to = std::max({to, x, a.z == b.z ? b.x : x});
            }
            for (double x = std::ceil(from - 1e-9); x <= to + 1e-9; ++x) {
                const double y = p[0].y + slopeX * (x - p[0].x) + slopeZ * (z - p[0].z);
                worst = std::max(worst, std::abs(y - double(surface.at(int64_t(x), int64_t(z)))));
            }
        }
    }
    return worst;
}

}  // namespace mw
