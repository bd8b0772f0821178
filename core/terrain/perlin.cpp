// Perlin noise row by row. Along a row the contribution of each vector is linear in x, so a row of a cell needs four numbers and a
// table of the fade; vectors come from a hash, not from a table. No branches inside: the loops vectorise.
#include "core/terrain/perlin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

// Compiled several times, the right one is taken when the program starts. Sanitizers and clang do without.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define MW_FOR_EACH_MACHINE __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define MW_FOR_EACH_MACHINE
#endif

namespace mw {

namespace {

/// Each bit of the result depends on each of x (Wellons' lowbias32).
inline uint32_t mixed(uint32_t x)
{
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

inline uint32_t rowKey(int64_t seed, uint32_t y)
{
    return mixed(y + mixed(uint32_t(seed) ^ 0x5bd1e995u));
}

inline uint32_t fieldAt(uint32_t key, uint32_t x)
{
    return mixed(x * 0x9e3779b1u ^ key);
}

/// sin(pi t / 2) for t from -1 to 1, to 6e-8.
inline float quarterSine(float t)
{
    const float s = t * t;
    return t * (1.57079633f + s * (-0.645964098f + s * (0.0796926262f + s * (-0.00468175414f + s * (0.000160441185f - 0.00000359884324f * s)))));
}

/// Unit vectors of the field at samples 0, interval, 2 interval, ... of a row.
MW_FOR_EACH_MACHINE void vectorsOfRow(uint32_t key, uint32_t interval, size_t n, float* x, float* y)
{
    for (size_t i = 0; i < n; ++i) {
        const float turn = float(int32_t(fieldAt(key, uint32_t(i) * interval))) * 0x1p-31f;  // of half a turn, -1 to 1
        const float twice = 2 * std::abs(turn);
        x[i] = quarterSine(1 - twice);
        y[i] = std::copysign(quarterSine(1 - std::abs(1 - twice)), turn);
    }
}

/// Vectors above and below a row and where it lies between.
struct Between {
    const float *x0, *y0, *x1, *y1;
    float dy, wy, scale, shift;
};

/// What the corners of column i give along the row: slope * dx + base. A shift of all bases shifts the row.
MW_FOR_EACH_MACHINE void columnsOfRow(const Between& b, size_t n, float* slope, float* base)
{
    const float upper = b.scale * (1 - b.wy), lower = b.scale * b.wy;
    const float upperWay = upper * b.dy, lowerWay = lower * (b.dy - 1);
    for (size_t i = 0; i < n; ++i) {
        slope[i] = upper * b.x0[i] + lower * b.x1[i];
        base[i] = b.shift + upperWay * b.y0[i] + lowerWay * b.y1[i];
    }
}

/// Whole cells of an interval known when compiled (0: not known).
template <uint32_t I>
inline __attribute__((always_inline)) void addCells(float* __restrict out, size_t cells, uint32_t interval, const float* __restrict slope,
                                                    const float* __restrict base, const float* __restrict dx, const float* __restrict w)
{
    const uint32_t length = I ? I : interval;
    for (size_t i = 0; i < cells; ++i, out += length) {
        const float s0 = slope[i], b0 = base[i], s1 = slope[i + 1], b1 = base[i + 1] - s1;
        for (uint32_t j = 0; j < length; ++j) {
            const float left = s0 * dx[j] + b0, right = s1 * dx[j] + b1;
            out[j] += left + w[j] * (right - left);
        }
    }
}

MW_FOR_EACH_MACHINE void addRow(float* out, size_t n, uint32_t interval, const float* slope, const float* base, const float* dx, const float* w)
{
    const size_t cells = n / interval;
    switch (interval) {
        case 2:
            addCells<2>(out, cells, interval, slope, base, dx, w);
            break;
        case 4:
            addCells<4>(out, cells, interval, slope, base, dx, w);
            break;
        case 8:
            addCells<8>(out, cells, interval, slope, base, dx, w);
            break;
        default:
            addCells<0>(out, cells, interval, slope, base, dx, w);
    }
    const size_t done = cells * interval;
    const float s0 = slope[cells], b0 = base[cells], s1 = slope[cells + 1], b1 = base[cells + 1] - s1;
    for (size_t j = 0; j < n - done; ++j) {
        const float left = s0 * dx[j] + b0, right = s1 * dx[j] + b1;
        out[done + j] += left + w[j] * (right - left);
    }
}

MW_FOR_EACH_MACHINE void widen(const float* row, size_t n, float* least, float* most)
{
    for (size_t i = 0; i < n; ++i) {
        least[i] = row[i] < least[i] ? row[i] : least[i];
        most[i] = row[i] > most[i] ? row[i] : most[i];
    }
}

double faded(Perlin::Fade f, double w)
{
    switch (f) {
        case Perlin::Fade::None:
            return w;
        case Perlin::Fade::Cubic:
            return w * w * (3 - 2 * w);
        case Perlin::Fade::Quintic:
            return w * w * w * (w * (6 * w - 15) + 10);
    }
    return w;
}

/// What is the same for all rows of an octave.
struct Octave {
    int64_t seed = 0;
    uint32_t interval = 0, number = 0;  // number: 1, 2, ...
    double weight = 1, least = 0, most = 0;
    Array<float> dx, w;

    Octave(const Perlin& p, uint32_t k) : seed(p.seed), interval(uint32_t(p.interval) >> k), number(k + 1), weight(std::ldexp(1.0, -int(k)))
    {
        for (uint32_t j = 0; j < interval; ++j) {
            dx.push_back(float(double(j) / interval));
            w.push_back(float(faded(p.fade, double(j) / interval)));
        }
    }
};

/// Adds rows of an octave from above to below.
class Rows {
public:
    Rows(const Octave& octave, size_t n) : octave_(octave), n_(n), columns_(n / octave.interval + 2)
    {
        for (Array<float>* a : {&x_[0], &y_[0], &x_[1], &y_[1], &slope_, &base_}) a->resize(columns_);
    }
    /// Adds scale times the octave and the shift.
    void add(float* out, uint32_t y, float scale, float shift)
    {
        const uint32_t line = y / octave_.interval, j = y % octave_.interval;
        if (line != line_) {
            if (line == line_ + 1) {
                std::swap(x_[0], x_[1]);
                std::swap(y_[0], y_[1]);
            } else {
                vectors(line, 0);
            }
            vectors(line + 1, 1);
            line_ = line;
        }
        const Between between{x_[0].data(), y_[0].data(), x_[1].data(), y_[1].data(), octave_.dx[j], octave_.w[j], scale, shift};
        columnsOfRow(between, columns_, slope_.data(), base_.data());
        addRow(out, n_, octave_.interval, slope_.data(), base_.data(), octave_.dx.data(), octave_.w.data());
    }

private:
    void vectors(uint32_t line, int which)
    {
        vectorsOfRow(rowKey(octave_.seed, line * octave_.interval), octave_.interval, columns_, x_[which].data(), y_[which].data());
    }

    const Octave& octave_;
    size_t n_, columns_;
    uint32_t line_ = ~0u - 1;
    Array<float> x_[2], y_[2], slope_, base_;
};

constexpr uint32_t band = 64;  // rows one thread works on at a time

/// Calls work(first row, row after the last) for bands of rows, on all cores.
template <class Work>
void inBands(uint32_t from, uint32_t to, const Work& work)
{
    tbb::parallel_for(tbb::blocked_range<uint32_t>(from, to, band), [&](const tbb::blocked_range<uint32_t>& r) { work(r.begin(), r.end()); });
}

/// Least and greatest value of an octave, (5.14).
void findRange(Octave& octave, uint32_t n)
{
    std::mutex mutex;
    float least = std::numeric_limits<float>::infinity(), most = -least;
    inBands(0, n, [&](uint32_t from, uint32_t to) {
        Rows rows(octave, n);
        Array<float> row(n), low(n, std::numeric_limits<float>::infinity()), high(n, -std::numeric_limits<float>::infinity());
        for (uint32_t y = from; y < to; ++y) {
            std::fill(row.begin(), row.end(), 0.f);
            rows.add(row.data(), y, 1, 0);
            widen(row.data(), n, low.data(), high.data());
        }
        const std::lock_guard lock(mutex);
        least = std::min(least, *std::min_element(low.begin(), low.end()));
        most = std::max(most, *std::max_element(high.begin(), high.end()));
    });
    octave.least = double(least);
    octave.most = double(most);
}

std::vector<Octave> octavesOf(const Perlin& p)
{
    std::vector<Octave> list;
    for (uint32_t k = 0; k < uint32_t(p.octaves) || k < uint32_t(p.octave); ++k) {
        if ((p.interval >> k) < 2) break;
        if (p.octave == 0 || p.octave == int64_t(k) + 1) list.emplace_back(p, k);
    }
    return list;
}

/// The sum being made.
struct Sum {
    uint32_t n;
    bool stretched;  // each octave, before it is added
    double weights = 0, added = 0;
    Array<float> heights;

    Sum(uint32_t size, const std::vector<Octave>& octaves, bool stretch) : n(size), stretched(stretch), heights(size_t(size) * size, 0.f)
    {
        for (const Octave& o : octaves) weights += o.weight;
    }
    void add(const Octave& o, uint32_t from, uint32_t to)
    {
        const double share = o.weight / weights, scale = !stretched ? share : o.most > o.least ? share / (o.most - o.least) : 0;
        const double shift = stretched ? -scale * o.least : 0;
        Rows rows(o, n);
        for (uint32_t y = from; y < to; ++y) rows.add(heights.data() + size_t(y) * n, y, float(scale), float(shift));
    }
    /// As if there were no further octaves.
    HeightMap shown() const
    {
        if (added == 0 || added == weights) return HeightMap(n, n, heights);
        Array<float> part = heights;
        for (float& h : part) h = float(double(h) * weights / added);
        return HeightMap(n, n, part);
    }
};

/// One sample, worked out as (5.12) and (5.13) say.
struct Example {
    uint32_t x = 0, y = 0, x1 = 0, y1 = 0, x2 = 0, y2 = 0;
    double dx = 0, dy = 0, wx = 0, wy = 0, d[4] = {}, upper = 0, lower = 0, value = 0;

    Example(const Octave& o, uint32_t n, Perlin::Fade fade)
    {
        const uint32_t i = o.interval, middle = n / 2 / i * i;
        x1 = middle + i < n ? middle : middle - std::min(middle, i), y1 = x1, x2 = x1 + i, y2 = y1 + i;
        x = x1 + (3 * i + 5) / 10, y = y1 + (6 * i + 5) / 10;
        dx = double(x - x1) / i, dy = double(y - y1) / i;
        wx = faded(fade, dx), wy = faded(fade, dy);
        for (int k = 0; k < 4; ++k) {
            const double angle = 2 * M_PI * perlinTurn(o.seed, k % 2 ? x2 : x1, k / 2 ? y2 : y1);
            d[k] = std::cos(angle) * (dx - k % 2) + std::sin(angle) * (dy - k / 2);
        }
        upper = d[0] + wx * (d[1] - d[0]), lower = d[2] + wx * (d[3] - d[2]), value = upper + wy * (lower - upper);
    }
};

}  // namespace

double perlinTurn(int64_t seed, uint32_t x, uint32_t y)
{
    return double(fieldAt(rowKey(seed, y), x)) * 0x1p-32;
}

Generator perlin(Perlin parameters, Stage<HeightMap>& stage)
{
    const uint32_t n = uint32_t(parameters.size);
    const bool stretched = parameters.normalise == Perlin::Normalise::Octaves;
    std::vector<Octave> octaves = octavesOf(parameters);
    Sum sum(n, octaves, stretched);
    stage.show([&] { return sum.shown(); });
    const double share = 1 / double(octaves.size() + 1);
    if (stage.watched()) {
        for (Octave& o : octaves) {
            const Example e(o, n, parameters.fade);
            if (e.x2 < n)
                co_yield Step("corners")
                    .vertex(e.y * n + e.x, Role::Current, "P")
                    .vertex(e.y1 * n + e.x1, Role::Neighbour, "P1")
                    .vertex(e.y1 * n + e.x2, Role::Neighbour, "P2")
                    .vertex(e.y2 * n + e.x1, Role::Neighbour, "P3")
                    .vertex(e.y2 * n + e.x2, Role::Neighbour, "P4")
                    .number("octave", o.number)
                    .number("interval", o.interval)
                    .number("dx", e.dx)
                    .number("dy", e.dy)
                    .number("d1", e.d[0])
                    .number("d2", e.d[1])
                    .number("d3", e.d[2])
                    .number("d4", e.d[3])
                    .number("wx", e.wx)
                    .number("wy", e.wy)
                    .number("d12", e.upper)
                    .number("d34", e.lower)
                    .number("d", e.value);
            findRange(o, n);
            inBands(0, n, [&](uint32_t from, uint32_t to) { sum.add(o, from, to); });
            sum.added += o.weight;
            co_yield Step("octave")
                .number("octave", o.number)
                .number("interval", o.interval)
                .number("vectors", std::pow(double((n - 1) / o.interval + 1), 2))
                .number("weight", o.weight)
                .number("least", o.least)
                .number("most", o.most)
                .progress(share * double(&o - octaves.data() + 1));
        }
    } else {
        for (Octave& o : octaves)
            if (stretched) {
                findRange(o, n);
                co_yield Step("octave").progress(0.5 * share * double(&o - octaves.data() + 1));
            }
        const uint32_t piece = std::max(band, (1u << 22) / n);
        for (uint32_t from = 0; from < n; from += piece) {
            inBands(from, std::min(n, from + piece), [&](uint32_t first, uint32_t last) {
                for (const Octave& o : octaves) sum.add(o, first, last);
            });
            co_yield Step("octave").progress(0.5 + 0.5 * double(from) / n);
        }
    }
    if (parameters.normalise == Perlin::Normalise::Sum) {
        const auto [low, high] = std::minmax_element(sum.heights.begin(), sum.heights.end());
        const double least = double(*low), most = double(*high), scale = most > least ? 1 / (most - least) : 0;
        co_yield Step("normalise").number("least", least).number("most", most).progress(1);
        for (float& h : sum.heights) h = float((double(h) - least) * scale);
    }
    stage.finish(HeightMap(n, n, sum.heights));
}

}  // namespace mw
