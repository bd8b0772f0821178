// Diamond-square: each round halves the squares and the displacements.
#include "core/terrain/diamond_square.h"

#include <algorithm>
#include <utility>

#include "core/math/random.h"

namespace mw {

namespace {

/// A sample as it is made.
struct Made {
    uint32_t place = 0, count = 0;
    uint32_t parent[4] = {};
    double mean = 0, displacement = 0, height = 0;
};

/// The square grid being made, row by row.
class Grid {
public:
    Grid(uint32_t side, const DiamondSquare& p) : side_(side), known_(side - 1), random_(uint64_t(p.seed)), h_(size_t(side) * side, 0.f)
    {
        h_.front() = float(p.a);
        h_[side - 1] = float(p.b);
        h_.back() = float(p.c);
        h_[size_t(side) * (side - 1)] = float(p.d);
    }

    /// The centre (x, y) of a square, from its corners.
    Made square(uint32_t x, uint32_t y, uint32_t half, double sigma)
    {
        Made m{index(x, y)};
        for (const uint32_t row : {y - half, y + half})
            for (const uint32_t column : {x - half, x + half}) m.parent[m.count++] = index(column, row);
        return displaced(m, sigma);
    }
    /// The middle (x, y) of a side, from those above, left, right and below that there are.
    Made diamond(uint32_t x, uint32_t y, uint32_t half, double sigma)
    {
        Made m{index(x, y)};
        if (y >= half) m.parent[m.count++] = index(x, y - half);
        if (x >= half) m.parent[m.count++] = index(x - half, y);
        if (x + half < side_) m.parent[m.count++] = index(x + half, y);
        if (y + half < side_) m.parent[m.count++] = index(x, y + half);
        return displaced(m, sigma);
    }
    /// A row of either, when nobody watches; gives the number of samples made.
    uint32_t squareRow(uint32_t y, uint32_t half, double sigma)
    {
        for (uint32_t x = half; x < side_; x += 2 * half) square(x, y, half, sigma);
        return (side_ - 1) / (2 * half);
    }
    uint32_t diamondRow(uint32_t y, uint32_t half, double sigma)
    {
        const uint32_t first = y / half % 2 ? 0 : half;
        for (uint32_t x = first; x < side_; x += 2 * half) diamond(x, y, half, sigma);
        return (side_ - 1) / (2 * half) + (first == 0);
    }
    /// For those who watch a round of squares of side 2 half: what it is going to make is so far the mean along sides and of squares.
    void foresee(uint32_t half);
    /// Heights are known at this spacing; between them the surface is bilinear.
    void know(uint32_t spacing)
    {
        known_ = spacing;
        changed_ = {0, 0, side_, side_};
    }
    /// For those who watch: a sample was made, and what hangs on it changes.
    void touch(const Made& m, uint32_t half)
    {
        const uint32_t x = m.place % side_, y = m.place / side_;
        const auto before = [half](uint32_t at) { return at > half ? at - half : 0; };
        changed_ = {std::min(changed_.x0, before(x)), std::min(changed_.y0, before(y)), std::max(changed_.x1, std::min(side_, x + half)),
                    std::max(changed_.y1, std::min(side_, y + half))};
    }
    /// The first `size` of each side.
    Array<float> filled(uint32_t size) const;
    /// All of it. What did not change since the last call shares its tiles.
    const HeightMap& shown();

private:
    struct Area {
        uint32_t x0, y0, x1, y1;
    };
    static constexpr Area nothing{~0u, ~0u, 0, 0};

    double at(uint32_t place) const { return double(h_[place]); }
    void fillRow(float* out, uint32_t x0, uint32_t x1, uint32_t y) const;
    uint32_t index(uint32_t x, uint32_t y) const { return y * side_ + x; }
    Made displaced(Made m, double sigma)
    {
        double sum = 0;
        for (uint32_t i = 0; i < m.count; ++i) sum += double(h_[m.parent[i]]);
        m.mean = sum / m.count;
        m.displacement = sigma * random_.normal();
        m.height = m.mean + m.displacement;
        h_[m.place] = float(m.height);
        return m;
    }

    uint32_t side_, known_;
    Random random_;
    Array<float> h_;
    HeightMap map_;
    Area changed_ = nothing;
};

void Grid::foresee(uint32_t half)
{
    const auto mean = [&](uint32_t a, uint32_t b) { return float(0.5 * (double(h_[a]) + double(h_[b]))); };
    for (uint32_t y = 0; y < side_; y += 2 * half)
        for (uint32_t x = half; x < side_; x += 2 * half) h_[index(x, y)] = mean(index(x - half, y), index(x + half, y));
    for (uint32_t y = half; y < side_; y += 2 * half)
        for (uint32_t x = 0; x < side_; x += half) h_[index(x, y)] = mean(index(x, y - half), index(x, y + half));
}

/// Heights of the samples x0 to x1 of a row.
void Grid::fillRow(float* out, uint32_t x0, uint32_t x1, uint32_t y) const
{
    if (known_ == 1) {
        std::copy(h_.data() + index(x0, y), h_.data() + index(x1, y), out);
        return;
    }
    const uint32_t top = std::min(y - y % known_, side_ - 1 - known_);
    const double v = double(y - top) / known_;
    for (uint32_t x = x0; x < x1; ++x) {
        const uint32_t left = std::min(x - x % known_, side_ - 1 - known_), a = index(left, top), d = index(left, top + known_);
        const double u = double(x - left) / known_;
        *out++ = float((1 - v) * ((1 - u) * at(a) + u * at(a + known_)) + v * ((1 - u) * at(d) + u * at(d + known_)));
    }
}

Array<float> Grid::filled(uint32_t size) const
{
    Array<float> out(size_t(size) * size);
    for (uint32_t y = 0; y < size; ++y) fillRow(out.data() + size_t(y) * size, 0, size, y);
    return out;
}

const HeightMap& Grid::shown()
{
    constexpr uint32_t tile = HeightMap::tileSize;
    const Area c = std::exchange(changed_, nothing);
    if (map_.empty()) return map_ = HeightMap(side_, side_, filled(side_));
    for (uint32_t ty = c.y0 / tile; ty * tile < c.y1; ++ty)
        for (uint32_t tx = c.x0 / tile; tx * tile < c.x1; ++tx) {
            const Shared<float>& old = map_.tile(tx, ty);
            Array<float> heights(old.begin(), old.end());
            const uint32_t x0 = std::max(c.x0, tx * tile), x1 = std::min(c.x1, tx * tile + tile);
            for (uint32_t y = std::max(c.y0, ty * tile); y < std::min(c.y1, ty * tile + tile); ++y)
                fillRow(heights.data() + size_t(y % tile) * tile + x0 % tile, x0, x1, y);
            map_.setTile(tx, ty, std::move(heights));
        }
    return map_;
}

/// Rounds until squares have side 1.
uint32_t roundsFor(int64_t size)
{
    uint32_t n = 0;
    while ((int64_t(1) << n) + 1 < size) ++n;
    return n;
}

/// To 0 and 1; what is constant to 0.
void stretch(Array<float>& heights, double least, double most)
{
    const double scale = most > least ? 1 / (most - least) : 0;
    for (float& h : heights) h = float((double(h) - least) * scale);
}

constexpr const char* letters[] = {"A", "B", "C", "D"};
constexpr uint32_t pause = 1u << 16;  // samples between two pauses when nobody watches

}  // namespace

Generator diamondSquare(DiamondSquare parameters, Stage<HeightMap>& stage)
{
    const uint32_t size = uint32_t(parameters.size), n = roundsFor(size), side = (1u << n) + 1;
    const uint32_t rounds = parameters.rounds > 0 ? std::min(n, uint32_t(parameters.rounds)) : n;
    Grid grid(side, parameters);
    stage.show([&] { return grid.shown(); });
    uint32_t done = 0, since = 0;
    const double all = double((1u << rounds) + 1) * double((1u << rounds) + 1) - 4;
    double sigma = parameters.sigma;
    for (uint32_t k = 0; k < rounds; ++k, sigma *= 0.5) {
        const uint32_t half = (side - 1) >> (k + 1), step = 2 * half;
        grid.know(half);
        if (!stage.watched()) {
            for (uint32_t y = half; y < side; y += step) {
                const uint32_t made = grid.squareRow(y, half, sigma);
                done += made, since += made;
                if (since >= pause) co_yield Step("square").progress(done / all);
                if (since >= pause) since = 0;
            }
            for (uint32_t y = 0; y < side; y += half) {
                const uint32_t made = grid.diamondRow(y, half, sigma);
                done += made, since += made;
                if (since >= pause) co_yield Step("diamond").progress(done / all);
                if (since >= pause) since = 0;
            }
            continue;
        }
        grid.foresee(half);
        for (uint32_t y = half; y < side; y += step)
            for (uint32_t x = half; x < side; x += step) {
                const Made m = grid.square(x, y, half, sigma);
                grid.touch(m, half);
                ++done;
                co_yield Step("square")
                    .vertex(m.place, Role::New, "P")
                    .vertex(m.parent[0], Role::Neighbour, "A")
                    .vertex(m.parent[1], Role::Neighbour, "B")
                    .vertex(m.parent[3], Role::Neighbour, "C")
                    .vertex(m.parent[2], Role::Neighbour, "D")
                    .number("round", k + 1)
                    .number("side", step)
                    .number("sigma", sigma)
                    .number("mean", m.mean)
                    .number("displacement", m.displacement)
                    .number("height", m.height)
                    .progress(done / all);
            }
        for (uint32_t y = 0; y < side; y += half)
            for (uint32_t x = y / half % 2 ? 0 : half; x < side; x += step) {
                const Made m = grid.diamond(x, y, half, sigma);
                grid.touch(m, half);
                ++done;
                Step s("diamond");
                std::move(s).vertex(m.place, Role::New, "P");
                for (uint32_t i = 0; i < m.count; ++i) std::move(s).vertex(m.parent[i], Role::Neighbour, letters[i]);
                co_yield std::move(s)
                    .number("round", k + 1)
                    .number("side", step)
                    .number("sigma", sigma)
                    .number("neighbours", m.count)
                    .number("mean", m.mean)
                    .number("displacement", m.displacement)
                    .number("height", m.height)
                    .progress(done / all);
            }
        if (half > 1)
            co_yield Step("interpolate")
                .number("round", k + 1)
                .number("squares", double(1u << (k + 1)) * double(1u << (k + 1)))
                .number("side", half)
                .progress(done / all);
    }
    Array<float> heights = grid.filled(size);
    if (parameters.normalise) {
        const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
        const double least = double(*low), most = double(*high);
        co_yield Step("normalise").number("least", least).number("most", most).progress(1);
        stretch(heights, least, most);
    }
    stage.finish(HeightMap(size, size, heights));
}

}  // namespace mw
