// Triangle strips, greedily: start where a triangle would be left over later, try three directions, take the longest.
//
//      s1 ----- s3 ----- s5        Triangle i is (s_i, s_i+1, s_i+2); an odd one has its first two swapped, so that all of them run
//      / \  1  / \  3  / \         anticlockwise. The strip leaves triangle i over the edge s_i+1 s_i+2. Seen from the side it came in by
//     /   \   /   \   /   \        (that runs against the one it left), it leaves an odd triangle by the side before and an even one by
//    /  0  \ /  2  \ /     \       the side after. Backwards from triangle 0 it is the other way round.
//   s0 ---- s2 ---- s4 ---- s6
#include "core/mesh/stripify.h"

#include <algorithm>
#include <deque>
#include <limits>

#include "core/mesh/opposite_sides.h"

namespace mw {

namespace {

uint32_t sideAfter(uint32_t c)
{
    return c % 3 == 2 ? c - 2 : c + 1;
}

uint32_t sideBefore(uint32_t c)
{
    return c % 3 == 0 ? c + 2 : c - 1;
}

/// Free triangles by the number of their free neighbours, 0 to 3. Of equal ones the latest touched comes first: next to the strip just made.
class StartQueue {
public:
    StartQueue(size_t triangles, bool inOrder) : inOrder_(inOrder), free_(triangles, 0), taken_(triangles, 0) {}
    void setFreeNeighbours(uint32_t t, uint8_t n)
    {
        free_[t] = n;
        if (!inOrder_) bucket_[n].push_back(t);
    }
    uint8_t freeNeighbours(uint32_t t) const { return free_[t]; }
    bool isTaken(uint32_t t) const { return taken_[t]; }
    void take(uint32_t t) { taken_[t] = 1; }
    void neighbourTaken(uint32_t t)
    {
        if (!taken_[t]) setFreeNeighbours(t, uint8_t(free_[t] - 1));
    }
    /// none when all are taken.
    uint32_t next()
    {
        for (; inOrder_ && order_ < taken_.size(); ++order_)
            if (!taken_[order_]) return order_;
        for (uint8_t n = 0; n < 4; ++n)
            for (auto& b = bucket_[n]; !b.empty();) {
                const uint32_t t = b.back();
                b.pop_back();
                if (!taken_[t] && free_[t] == n) return t;  // else an old entry
            }
        return none;
    }

private:
    bool inOrder_;
    uint32_t order_ = 0;
    std::vector<uint8_t> free_, taken_;
    std::vector<uint32_t> bucket_[4];
};

/// A strip as the sides by which its triangles are entered; for the first one the side whose two ends are the first two indices.
using Strip = std::deque<uint32_t>;

class Strips {
public:
    Strips(const Mesh& mesh, const Stripify& parameters);

    uint32_t nextStart() { return queue_.next(); }
    uint8_t freeNeighbours(uint32_t triangle) const { return queue_.freeNeighbours(triangle); }
    Strip longest(uint32_t start);
    /// Adds triangle number i of a strip to the result.
    void append(const Strip& strip, size_t i);
    void endStrip() { ++count_; }

    uint32_t faceOf(uint32_t triangle) const { return cut_.faces[triangle]; }
    uint32_t from(uint32_t side) const { return cut_.vertices[side]; }
    uint32_t to(uint32_t side) const { return cut_.vertices[sideAfter(side)]; }
    uint32_t across(uint32_t side) const { return cut_.vertices[sideBefore(side)]; }
    size_t count() const { return count_; }
    size_t triangles() const { return cut_.faces.size(); }
    size_t triangleListIndices() const { return cut_.vertices.size(); }
    size_t indices() const { return indices_.size(); }
    Table table() const;

private:
    Strip walk(uint32_t first);
    uint32_t free(uint32_t side) const;
    void release(uint32_t triangle);

    size_t faces_;
    Mesh::Triangulation cut_;
    Array<uint32_t> opposite_;
    StartQueue queue_;
    Array<uint32_t> visited_;  // by the walk of that number
    uint32_t walks_ = 0;
    std::vector<uint32_t> indices_;
    Array<double> stripOfFace_;
    size_t count_ = 0;
};

Strips::Strips(const Mesh& mesh, const Stripify& parameters)
    : faces_(mesh.faceCount()),
      cut_(mesh.triangulation()),
      opposite_(oppositeSidesOf(mesh.isTriangles() ? mesh : Mesh::triangles(mesh.positions(), cut_.vertices))),
      queue_(cut_.faces.size(), parameters.start == Stripify::Start::InOrder),
      visited_(cut_.faces.size(), 0u),
      stripOfFace_(faces_, std::numeric_limits<double>::quiet_NaN())
{
    indices_.reserve(triangles() + triangles() / 3);
    for (uint32_t t = uint32_t(triangles()); t-- > 0;) {  // the lowest comes out first
        const uint32_t* o = &opposite_[3 * size_t(t)];
        queue_.setFreeNeighbours(t, uint8_t((o[0] != none) + (o[1] != none) + (o[2] != none)));
    }
}

/// The side against `side` if its triangle may be added to the present walk.
uint32_t Strips::free(uint32_t side) const
{
    const uint32_t o = opposite_[side];
    return o == none || queue_.isTaken(o / 3) || visited_[o / 3] == walks_ ? none : o;
}

/// The strip whose first triangle has its first two indices along side `first`: forwards, then backwards from the first triangle. In front goes
/// an even number only, for the first triangle must stay an even one.
Strip Strips::walk(uint32_t first)
{
    ++walks_;
    Strip strip{first};
    visited_[first / 3] = walks_;
    bool odd = true;
    for (uint32_t in = free(sideAfter(first)); in != none; odd = !odd) {
        visited_[in / 3] = walks_;
        strip.push_back(in);
        in = free(odd ? sideBefore(in) : sideAfter(in));
    }
    odd = true;
    for (uint32_t out = free(first); out != none; odd = !odd) {
        visited_[out / 3] = walks_;
        const uint32_t further = odd ? sideAfter(out) : sideBefore(out);
        strip.push_front(further);  // read forwards, this triangle is entered where the walk leaves it
        out = free(further);
    }
    if (!odd) strip.pop_front();
    return strip;
}

Strip Strips::longest(uint32_t start)
{
    Strip best;
    for (uint32_t side = 3 * start; side < 3 * start + 3; ++side) {
        Strip s = walk(side);
        if (s.size() > best.size()) best = std::move(s);
    }
    return best;
}

void Strips::release(uint32_t triangle)
{
    queue_.take(triangle);
    for (uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side)
        if (opposite_[side] != none) queue_.neighbourTaken(opposite_[side] / 3);
}

void Strips::append(const Strip& strip, size_t i)
{
    const uint32_t side = strip[i], triangle = side / 3;
    if (i == 0) {
        if (!indices_.empty()) indices_.push_back(restartIndex);
        indices_.push_back(from(side));
        indices_.push_back(to(side));
    }
    indices_.push_back(across(side));
    double& s = stripOfFace_[cut_.faces[triangle]];
    const bool isFirstOfFace = triangle == 0 || cut_.faces[triangle - 1] != cut_.faces[triangle];
    if (isFirstOfFace) s = double(count_);
    release(triangle);
}

Table Strips::table() const
{
    const double list = double(triangleListIndices()), used = double(indices_.size());
    Table t;
    t.rows = ElementKind::Face;
    t.columns.push_back({"strip", "", stripOfFace_, true});
    t.lists = {{"indices", indices_}};
    t.summary = {{"strips", double(count_)},
                 {"indices in strips", used},
                 {"indices in triangle list", list},
                 {"saved per cent", list > 0 ? 100 * (1 - used / list) : 0},
                 {"triangles a strip", count_ > 0 ? double(triangles()) / double(count_) : 0}};
    return t;
}

}  // namespace

Generator stripify(Mesh input, Stripify parameters, Stage<Table>& stage)
{
    Strips strips(input, parameters);
    stage.show([&] { return strips.table(); });
    size_t done = 0, pause = 0;
    const double all = double(strips.triangles());
    for (uint32_t start = strips.nextStart(); start != none; start = strips.nextStart()) {
        if (stage.watched())
            co_yield Step("start")
                .face(strips.faceOf(start), Role::Current, "t")
                .number("strip", double(strips.count()))
                .number("free neighbours", strips.freeNeighbours(start));
        const Strip strip = strips.longest(start);
        for (size_t i = 0; i < strip.size(); ++i) {
            strips.append(strip, i);
            ++done;
            if (stage.watched())
                co_yield Step("extend")
                    .face(strips.faceOf(strip[i] / 3), Role::New, "t")
                    .edge(strips.from(strip[i]), strips.to(strip[i]), Role::Current, "e")
                    .vertex(strips.across(strip[i]), Role::New, "s")
                    .number("i", double(i))
                    .number("turned", double(i % 2))
                    .number("vertex", strips.across(strip[i]))
                    .number("length", double(i + 1))
                    .number("indices", double(strips.indices()))
                    .progress(double(done) / all);
        }
        strips.endStrip();
        if (stage.watched() || (++pause & 255) == 0)
            co_yield Step("close")
                .number("length", double(strip.size()))
                .number("strips", double(strips.count()))
                .number("indices", double(strips.indices()))
                .number("saved", 100 * (1 - double(strips.indices()) / (3 * double(done))))
                .progress(double(done) / all);
    }
    stage.finish(strips.table());
}

Array<uint32_t> decodeStrips(std::span<const uint32_t> indices, uint32_t restart)
{
    Array<uint32_t> triangles;
    size_t start = 0;
    for (size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] == restart) {
            start = i + 1;
        } else if (i - start >= 2) {
            const bool odd = (i - start) % 2 == 1;
            triangles.insert(triangles.end(), {indices[i - (odd ? 1 : 2)], indices[i - (odd ? 2 : 1)], indices[i]});
        }
    }
    return triangles;
}

}  // namespace mw
