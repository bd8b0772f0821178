// Order, symbolic analysis, numeric factors, substitution: four passes over one tree of supernodes.
#include "core/parameterize/sparse_direct.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <string>
#include <tbb/parallel_for.h>

#include "core/error.h"
#include "core/mesh/large_pages.h"
#include "core/parameterize/dense_front.h"

namespace mw {
namespace {

constexpr uint32_t nobody = ~0u;
constexpr size_t leafSize = 32;
constexpr double worthThreads = 2e7;  // operations

/// Unknowns begin..end (by number) are eliminated together; `border` are the later ones they are joined to then.
struct Node {
    uint32_t begin = 0, end = 0, parent = nobody;
    size_t border = 0, borderEnd = 0;  ///< in Parts::border
    size_t ofParent = 0;               ///< how many of the border are the parent's own: the first ones
    size_t columns = 0;                ///< of L (and U), in Parts::lower
    double operations = 0, subtree = 0;
    uint32_t firstOfSubtree = 0;  ///< nodes firstOfSubtree..this one are the subtree
    uint32_t children[2] = {nobody, nobody};

    size_t own() const { return end - begin; }
    size_t rest() const { return borderEnd - border; }
    size_t rows() const { return own() + rest(); }
};

/// An unknown while sets of them are cut: they are moved along, so that every pass reads memory in order.
struct Placed {
    glm::vec3 at;
    float reach;  ///< distance of the farthest unknown it is joined to
    uint32_t unknown;
};

/// Where a cut is short: of a few directions the one across which the fewest of a sample lie near the middle. The greatest spread (by power
/// iteration) is among them and is taken at once for small sets; about round ones it says nothing.
glm::vec3 directionAcross(std::span<const Placed> set)
{
    const size_t stride = 1 + set.size() / 64;
    glm::vec3 mean(0), squares(0), products(0);  // xx, yy, zz; xy, xz, yz
    float n = 0;
    for (size_t i = 0; i < set.size(); i += stride, ++n) mean += set[i].at;
    mean /= n;
    for (size_t i = 0; i < set.size(); i += stride) {
        const glm::vec3 d = set[i].at - mean;
        squares += d * d;
        products += glm::vec3(d.x * d.y, d.x * d.z, d.y * d.z);
    }
    glm::vec3 axis(1, 0.9f, 0.8f);
    float spread = 0;
    for (int i = 0; i < 8; ++i) {
        axis = squares * axis + glm::vec3(products.x * axis.y + products.y * axis.z, products.x * axis.x + products.z * axis.z,
                                          products.y * axis.x + products.z * axis.y);
        spread = glm::length(axis);
        if (!(spread > 0)) return {1, 0, 0};
        axis /= spread;
    }
    if (set.size() < 1024) return axis;
    constexpr float h = 0.70710678f;
    const glm::vec3 directions[] = {axis, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {h, h, 0}, {h, -h, 0}, {h, 0, h}, {h, 0, -h}, {0, h, h}, {0, h, -h}};
    const float width = 0.3f * std::sqrt(spread / n);
    size_t fewest = set.size();
    const size_t fine = 1 + set.size() / 512;
    for (const glm::vec3& d : directions) {
        size_t count = 0;
        const float middle = glm::dot(mean, d);
        for (size_t i = 0; i < set.size(); i += fine) count += std::abs(glm::dot(set[i].at, d) - middle) < width;
        if (count >= fewest) continue;
        fewest = count;
        axis = d;
    }
    return axis;
}

/// All in a box of -1 to 1, its middle for those that are no numbers.
Array<Placed> placedUnknowns(const SparsePattern& pattern, std::span<const glm::vec3> places)
{
    const auto isPlace = [](const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
    glm::dvec3 least(std::numeric_limits<double>::max()), most(-least);
    for (const glm::vec3& p : places) {
        if (!isPlace(p)) continue;
        least = glm::min(least, glm::dvec3(p));
        most = glm::max(most, glm::dvec3(p));
    }
    const glm::dvec3 centre = 0.5 * (least + most), size = most - least;
    const double scale = 2 / std::max({size.x, size.y, size.z, 1e-300});
    Array<Placed> out(places.size());
    for (uint32_t i = 0; i < out.size(); ++i) {
        const glm::dvec3 at = isPlace(places[i]) ? (glm::dvec3(places[i]) - centre) * scale : glm::dvec3(0);
        out[i] = {glm::vec3(at), 0, i};
    }
    for (uint32_t i = 0; i < out.size(); ++i) {
        float farthest = 0;
        for (uint32_t k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
            const glm::vec3 d = out[pattern.column[k]].at - out[i].at;
            farthest = std::max(farthest, glm::dot(d, d));
        }
        out[i].reach = std::sqrt(farthest);
    }
    return out;
}

}  // namespace

struct SparseDirect::Parts {
    SparsePattern pattern;
    Array<uint32_t> order, number;  // number to unknown, unknown to number

    // Ordering: sets still to be cut, and the parts of the set at hand.
    struct Set {
        uint32_t begin, end, parent;
    };
    enum Part : uint8_t { First, Second, Separator };
    std::vector<Set> sets;
    Array<Placed> placed, moved;
    Array<float> key;        // of the members of the set: how far along the main direction
    Array<Part> part;        // of the members
    Array<uint32_t> near;    // members that may touch the other half
    Array<uint32_t> halfOf;  // of unknowns: 2 * node + half, where it is the node's set that they were near the cut of last
    size_t ordered = 0;
    std::vector<Node> nodes;  // created from the top down, then sorted: children before parents

    // Analysis.
    size_t analysed = 0;
    Array<uint32_t> border, parentRow;  // numbers, ascending, and the rows they have in the parent's front
    Array<uint32_t> entryRow;           // beside pattern.column: row in the front of the unknown's node; nobody where the other one comes first
    Array<uint32_t> mirror;             // beside pattern.column: the entry across the diagonal
    Array<uint32_t> stamp, row;         // while analysing
    double operations = 0;
    size_t entries = 0;

    // Factors.
    SparseValues values;
    Array<double> lower, upper;
    std::vector<Array<double>> updates;
    std::vector<std::pair<uint32_t, uint32_t>> packets;  // of nodes: subtrees for one thread each, then the others one by one
    size_t done = 0, packetsDone = 0;
    double operationsDone = 0;

    void cut(const Set& set);
    void halve(std::span<const Placed> set);
    void halveExactly(std::span<const Placed> set);
    void separate(std::span<const Placed> set, uint32_t node);
    void finishOrder();
    void analyse(uint32_t t);
    void place(uint32_t t);
    void choosePackets();
    void factor(uint32_t t, bool threads);
    void scatter(const Node& node);
    void addToOwn(const Node& node, uint32_t child);
    void addToRest(const Node& node, uint32_t child, double* rest);
    void eliminate(const Node& node, double* rest, bool threads);
};

SparseDirect::SparseDirect(SparsePattern pattern, std::span<const glm::vec3> places) : p_(std::make_unique<Parts>())
{
    Parts& p = *p_;
    p.pattern = std::move(pattern);
    const uint32_t n = uint32_t(p.pattern.size());
    p.placed = placedUnknowns(p.pattern, places);
    p.moved.resize(n);
    p.key.resize(n);
    p.part.resize(n);
    p.near.resize(n);
    p.halfOf = Array<uint32_t>(n, nobody);
    p.sets.push_back({0, n, nobody});
}
SparseDirect::~SparseDirect() = default;
SparseDirect::SparseDirect(SparseDirect&&) noexcept = default;
SparseDirect& SparseDirect::operator=(SparseDirect&&) noexcept = default;

/// Two halves across the main direction, about equal; those of one half that touch the other are the separator, numbered last.
void SparseDirect::Parts::cut(const Set& set)
{
    const uint32_t node = uint32_t(nodes.size()), size = set.end - set.begin;
    nodes.push_back({});
    nodes.back().parent = set.parent;
    nodes.back().end = set.end;
    nodes.back().begin = set.begin;
    if (size <= leafSize) {
        ordered += size;
        return;
    }
    Placed* members = placed.data() + set.begin;
    halve({members, size});
    separate({members, size}, node);
    uint32_t count[3] = {0, 0, 0};
    for (uint32_t i = 0; i < size; ++i) ++count[part[i]];
    const uint32_t first = count[First], both = first + count[Second];
    uint32_t next[3] = {0, first, both};
    for (uint32_t i = 0; i < size; ++i) moved[next[part[i]]++] = members[i];
    std::copy_n(moved.data(), size, members);
    nodes.back().begin = set.begin + both;
    ordered += size - both;
    if (both > first) sets.push_back({set.begin + first, set.begin + both, node});
    if (first > 0) sets.push_back({set.begin, set.begin + first, node});
}

/// Counted into slices along the main direction, and cut between the two in the middle. `near` are those that reach across.
void SparseDirect::Parts::halve(std::span<const Placed> set)
{
    const uint32_t size = uint32_t(set.size());
    const glm::vec3 axis = directionAcross(set);
    float least = std::numeric_limits<float>::max(), most = -least;
    for (uint32_t i = 0; i < size; ++i) {
        key[i] = glm::dot(set[i].at, axis);
        least = std::min(least, key[i]);
        most = std::max(most, key[i]);
    }
    constexpr uint32_t mostSlices = 256;
    const uint32_t slices = std::min(size, mostSlices);
    const float scale = float(slices - 1) / (most - least);
    if (!std::isfinite(scale)) return halveExactly(set);
    uint32_t count[mostSlices] = {};
    for (uint32_t i = 0; i < size; ++i) ++count[uint32_t((key[i] - least) * scale)];
    uint32_t middle = 0, below = 0;
    while (below + count[middle] / 2 < size / 2) below += count[middle++];
    if (below < size / 3 || size - below < size / 3) return halveExactly(set);
    const float at = float(middle) / scale, rounding = 1e-5f;
    near.resize(size);
    uint32_t found = 0;
    for (uint32_t i = 0; i < size; ++i) {
        part[i] = uint32_t((key[i] - least) * scale) < middle ? First : Second;
        near[found] = i;
        found += std::abs(key[i] - least - at) <= set[i].reach + rounding;
    }
    near.resize(found);
}

/// For places that slices do not tell apart: at the median, whatever lies there.
void SparseDirect::Parts::halveExactly(std::span<const Placed> set)
{
    near.resize(set.size());
    std::iota(near.begin(), near.end(), 0u);
    const auto middle = near.begin() + ptrdiff_t(set.size() / 2);
    std::nth_element(near.begin(), middle, near.end(), [&](uint32_t a, uint32_t b) { return key[a] != key[b] ? key[a] < key[b] : a < b; });
    for (auto i = near.begin(); i != near.end(); ++i) part[*i] = i < middle ? First : Second;
}

/// Of both halves' borders the shorter one.
void SparseDirect::Parts::separate(std::span<const Placed> set, uint32_t node)
{
    for (const uint32_t i : near) halfOf[set[i].unknown] = 2 * node + part[i];
    uint32_t touching[2] = {0, 0}, kept = 0;
    for (const uint32_t i : near) {
        const uint32_t v = set[i].unknown, other = halfOf[v] ^ 1;
        bool at = false;
        for (uint32_t k = pattern.start[v]; k < pattern.start[v + 1] && !at; ++k) at = halfOf[pattern.column[k]] == other;
        touching[part[i]] += at;
        near[kept] = i;
        kept += at;
    }
    near.resize(kept);
    const Part shorter = touching[Second] < touching[First] ? Second : First;
    for (const uint32_t i : near)
        if (part[i] == shorter) part[i] = Separator;
}

/// Children before parents; the sets of a subtree lie side by side, so sorting by place is enough.
void SparseDirect::Parts::finishOrder()
{
    std::vector<uint32_t> sorted(nodes.size()), rank(nodes.size());
    for (uint32_t i = 0; i < nodes.size(); ++i) sorted[i] = i;
    std::sort(sorted.begin(), sorted.end(), [&](uint32_t a, uint32_t b) {
        return nodes[a].begin != nodes[b].begin ? nodes[a].begin < nodes[b].begin
               : nodes[a].end != nodes[b].end   ? nodes[a].end < nodes[b].end
                                                : a > b;
    });
    std::vector<Node> childrenFirst;
    for (uint32_t i = 0; i < sorted.size(); ++i) rank[sorted[i]] = i;
    for (const uint32_t i : sorted) {
        childrenFirst.push_back(nodes[i]);
        if (nodes[i].parent != nobody) childrenFirst.back().parent = rank[nodes[i].parent];
    }
    nodes = std::move(childrenFirst);
    for (uint32_t t = 0; t < nodes.size(); ++t) {
        nodes[t].firstOfSubtree = std::min(t, nodes[t].children[0] == nobody ? t : nodes[nodes[t].children[0]].firstOfSubtree);
        if (nodes[t].parent == nobody) continue;
        uint32_t* children = nodes[nodes[t].parent].children;
        children[children[0] == nobody ? 0 : 1] = t;
    }
    const uint32_t n = uint32_t(pattern.size());
    order.resize(n);
    number.resize(n);
    for (uint32_t i = 0; i < n; ++i) number[order[i] = placed[i].unknown] = i;
    placed = moved = {};
    key = {};
    part = {};
    near = halfOf = {};
    stamp = Array<uint32_t>(order.size(), nobody);
    row.resize(order.size());
    entryRow = Array<uint32_t>(pattern.column.size(), nobody);
    mirror.resize(pattern.column.size());
    Array<uint32_t> cursor(pattern.start.begin(), pattern.start.end());
    for (uint32_t i = 0; i < pattern.size(); ++i)
        for (uint32_t k = pattern.start[i]; k < pattern.start[i + 1]; ++k) mirror[k] = cursor[pattern.column[k]]++;
}

bool SparseDirect::order(double work)
{
    Parts& p = *p_;
    while (!p.sets.empty() && work > 0) {
        const Parts::Set set = p.sets.back();
        p.sets.pop_back();
        work -= set.end - set.begin;
        p.cut(set);
        if (p.sets.empty()) p.finishOrder();
    }
    return !p.sets.empty();
}

/// Border of a node: later neighbours of its own unknowns, and what its children leave.
void SparseDirect::Parts::analyse(uint32_t t)
{
    Node& node = nodes[t];
    node.border = border.size();
    const auto add = [&](uint32_t i) {
        if (i < node.end || stamp[i] == t) return;
        stamp[i] = t;
        border.push_back(i);
    };
    for (uint32_t j = node.begin; j < node.end; ++j)
        for (uint32_t k = pattern.start[order[j]]; k < pattern.start[order[j] + 1]; ++k) add(number[pattern.column[k]]);
    for (const uint32_t c : node.children) {
        if (c == nobody) continue;
        for (size_t k = nodes[c].border; k < nodes[c].borderEnd; ++k) add(border[k]);
        node.subtree += nodes[c].subtree;
        node.firstOfSubtree = std::min(node.firstOfSubtree, nodes[c].firstOfSubtree);
    }
    node.borderEnd = border.size();
    std::sort(border.begin() + ptrdiff_t(node.border), border.end());
    parentRow.resize(border.size());
    const double k = double(node.own()), m = double(node.rows());
    node.operations = k * (m * m - m * k + k * k / 3) / 2 + k * m;
    node.subtree += node.operations;
    operations += node.operations;
    node.columns = entries;
    entries += node.rows() * node.own() + frontPadding;
    place(t);
}

/// Where the entries of the matrix and of the children's updates go in the front of a node.
void SparseDirect::Parts::place(uint32_t t)
{
    const Node& node = nodes[t];
    for (uint32_t j = node.begin; j < node.end; ++j) row[j] = j - node.begin;
    for (size_t k = node.border; k < node.borderEnd; ++k) row[border[k]] = uint32_t(node.own() + k - node.border);
    for (uint32_t j = node.begin; j < node.end; ++j)
        for (uint32_t k = pattern.start[order[j]]; k < pattern.start[order[j] + 1]; ++k) {
            const uint32_t i = number[pattern.column[k]];
            if (i > j) entryRow[k] = row[i];
        }
    for (const uint32_t c : node.children) {
        if (c == nobody) continue;
        for (size_t k = nodes[c].border; k < nodes[c].borderEnd; ++k) {
            parentRow[k] = row[border[k]];
            nodes[c].ofParent += border[k] < node.end;
        }
    }
}

bool SparseDirect::analyse(double work)
{
    Parts& p = *p_;
    for (; p.analysed < p.nodes.size() && work > 0; ++p.analysed) {
        p.analyse(uint32_t(p.analysed));
        work -= double(p.nodes[p.analysed].rows()) + 8.0 * double(p.nodes[p.analysed].own());
    }
    if (p.analysed < p.nodes.size()) return true;
    p.stamp = {};
    p.row = {};
    return false;
}

/// Subtrees of about a thirtieth of the work, then what is above them.
void SparseDirect::Parts::choosePackets()
{
    packets.clear();
    const double most = operations / 30;
    const auto small = [&](uint32_t t) { return nodes[t].subtree <= most; };
    for (uint32_t t = 0; t < nodes.size(); ++t)
        if (small(t) && (nodes[t].parent == nobody || !small(nodes[t].parent))) packets.push_back({nodes[t].firstOfSubtree, t + 1});
    for (uint32_t t = 0; t < nodes.size(); ++t)
        if (!small(t)) packets.push_back({t, t + 1});
}

void SparseDirect::begin(SparseValues values, size_t mostBytes)
{
    Parts& p = *p_;
    // Updates that wait for their parents are at most about as large as the factors.
    const size_t bytes = p.entries * sizeof(double) * (values.symmetric ? 2 : 3);
    if (bytes > mostBytes)
        throw Error("the factors of " + std::to_string(p.order.size()) + " unknowns would need " + std::to_string(bytes >> 20) +
                    " MB of memory; simplify the mesh, or choose an iterative solver");
    p.values = std::move(values);
    if (p.lower.empty()) p.lower = largeArray<double>(p.entries);
    if (p.upper.empty() && !p.values.symmetric) p.upper = largeArray<double>(p.entries);
    p.updates.clear();
    p.updates.resize(p.nodes.size());
    p.done = p.packetsDone = 0;
    p.operationsDone = 0;
    p.choosePackets();
}

void SparseDirect::Parts::scatter(const Node& node)
{
    const size_t rows = node.rows();
    double *l = lower.data() + node.columns, *u = values.symmetric ? nullptr : upper.data() + node.columns;
    std::fill(l, l + rows * node.own() + frontPadding, 0.0);
    if (u) std::fill(u, u + rows * node.own() + frontPadding, 0.0);
    for (uint32_t j = node.begin; j < node.end; ++j) {
        const size_t column = (j - node.begin) * rows;
        l[column + (j - node.begin)] = values.diagonal[order[j]];
        for (uint32_t k = pattern.start[order[j]]; k < pattern.start[order[j] + 1]; ++k) {
            if (entryRow[k] == nobody) continue;
            l[column + entryRow[k]] = values.off[mirror[k]];
            if (u) u[column + entryRow[k]] = values.off[k];
        }
    }
}

/// What a child left goes into own columns and rows...
void SparseDirect::Parts::addToOwn(const Node& node, uint32_t child)
{
    const Node& from = nodes[child];
    const size_t n = from.rest(), rows = node.rows(), ownRows = from.ofParent;
    const uint32_t* at = parentRow.data() + from.border;
    double *l = lower.data() + node.columns, *u = values.symmetric ? nullptr : upper.data() + node.columns;
    const double* update = updates[child].data();
    for (size_t j = 0; j < ownRows; ++j)
        for (size_t i = j; i < n; ++i) l[at[j] * rows + at[i]] += update[j * n + i];
    for (size_t j = 0; u && j < n; ++j)
        for (size_t i = 0; i < std::min(j, ownRows); ++i) u[at[i] * rows + at[j]] += update[j * n + i];
}

/// ... and into what this node leaves.
void SparseDirect::Parts::addToRest(const Node& node, uint32_t child, double* rest)
{
    const Node& from = nodes[child];
    const size_t n = from.rest(), own = node.own(), restRows = node.rest(), ownRows = from.ofParent;
    const uint32_t* at = parentRow.data() + from.border;
    const double* update = updates[child].data();
    for (size_t j = ownRows; j < n; ++j) {
        double* to = rest + (at[j] - own) * restRows - own;
        for (size_t i = values.symmetric ? j : ownRows; i < n; ++i) to[at[i]] += update[j * n + i];
    }
    updates[child] = {};
}

void SparseDirect::Parts::eliminate(const Node& node, double* rest, bool threads)
{
    const size_t rows = node.rows(), own = node.own(), n = node.rest();
    double *l = lower.data() + node.columns, *u = values.symmetric ? nullptr : upper.data() + node.columns;
    size_t failed = 0;
    if (!(u ? factorColumns(l, u, rows, own, failed) : factorColumns(l, rows, own, failed)))
        throw Error("the linear system has no stable solution: at unknown " + std::to_string(order[node.begin + failed]) +
                    (u ? " the pivot is 0" : " the matrix is not positive definite"));
    if (n == 0) return;
    const double *a = l + own, *b = (u ? u : l) + own;
    const auto update = [&](size_t first, size_t last) {
        const size_t above = u ? 0 : first;
        subtractProduct(rest + first * n + above, n, n - above, last - first, a + above, b + first, rows, own, !u, true);
    };
    constexpr size_t block = 96;
    if (threads && double(own) * double(n) * double(n) > worthThreads)
        tbb::parallel_for(size_t(0), (n + block - 1) / block, [&](size_t k) { update(k * block, std::min(n, (k + 1) * block)); });
    else
        update(0, n);
}

void SparseDirect::Parts::factor(uint32_t t, bool threads)
{
    const Node& node = nodes[t];
    scatter(node);
    for (const uint32_t c : node.children)
        if (c != nobody) addToOwn(node, c);
    updates[t] = Array<double>(node.rest() * node.rest());
    eliminate(node, updates[t].data(), threads);
    for (const uint32_t c : node.children)
        if (c != nobody) addToRest(node, c, updates[t].data());
}

bool SparseDirect::factor(double work, bool threads)
{
    Parts& p = *p_;
    if (!threads || p.operations < worthThreads) {
        for (; p.done < p.nodes.size() && work > 0; ++p.done) {
            p.factor(uint32_t(p.done), false);
            work -= p.nodes[p.done].operations + 500;
            p.operationsDone += p.nodes[p.done].operations;
        }
        return p.done < p.nodes.size();
    }
    size_t last = p.packetsDone;
    double planned = 0;
    const auto isSubtree = [&](size_t k) { return p.nodes[p.packets[k].second - 1].subtree <= p.operations / 30; };
    for (; last < p.packets.size() && (planned < work || last == p.packetsDone) && (last == p.packetsDone || isSubtree(last)); ++last)
        planned += isSubtree(last) ? p.nodes[p.packets[last].second - 1].subtree : p.nodes[p.packets[last].first].operations;
    if (isSubtree(p.packetsDone))
        tbb::parallel_for(
            p.packetsDone, last,
            [&](size_t k) {
                for (uint32_t t = p.packets[k].first; t < p.packets[k].second; ++t) p.factor(t, false);
            },
            tbb::simple_partitioner());
    else
        p.factor(p.packets[p.packetsDone].first, true);
    for (; p.packetsDone < last; ++p.packetsDone) p.done += p.packets[p.packetsDone].second - p.packets[p.packetsDone].first;
    p.operationsDone += planned;
    return p.packetsDone < p.packets.size();
}

void SparseDirect::solve(std::span<glm::dvec2> io) const
{
    const Parts& p = *p_;
    const size_t n = p.order.size();
    size_t most = 0;
    for (const Node& node : p.nodes) most = std::max(most, node.rows());
    Array<double> x(n), y(n), fx(most + frontPadding), fy(most + frontPadding);
    for (size_t i = 0; i < n; ++i) {
        x[i] = io[p.order[i]].x;
        y[i] = io[p.order[i]].y;
    }
    const double* upper = (p.values.symmetric ? p.lower : p.upper).data();
    for (const Node& node : p.nodes) {
        const size_t own = node.own(), rows = node.rows();
        std::copy_n(x.data() + node.begin, own, fx.data());
        std::copy_n(y.data() + node.begin, own, fy.data());
        std::fill_n(fx.data() + own, rows - own, 0.0);
        std::fill_n(fy.data() + own, rows - own, 0.0);
        forwardFront(p.lower.data() + node.columns, rows, own, !p.values.symmetric, fx.data(), fy.data());
        std::copy_n(fx.data(), own, x.data() + node.begin);
        std::copy_n(fy.data(), own, y.data() + node.begin);
        for (size_t i = own; i < rows; ++i) {
            const uint32_t at = p.border[node.border + i - own];
            x[at] += fx[i];
            y[at] += fy[i];
        }
    }
    for (size_t t = p.nodes.size(); t-- > 0;) {
        const Node& node = p.nodes[t];
        const size_t own = node.own(), rows = node.rows();
        std::copy_n(x.data() + node.begin, own, fx.data());
        std::copy_n(y.data() + node.begin, own, fy.data());
        for (size_t i = own; i < rows; ++i) {
            fx[i] = x[p.border[node.border + i - own]];
            fy[i] = y[p.border[node.border + i - own]];
        }
        backwardFront(upper + node.columns, p.lower.data() + node.columns, rows, own, fx.data(), fy.data());
        std::copy_n(fx.data(), own, x.data() + node.begin);
        std::copy_n(fy.data(), own, y.data() + node.begin);
    }
    for (size_t i = 0; i < n; ++i) io[p.order[i]] = {x[i], y[i]};
}

size_t SparseDirect::supernodes() const
{
    return p_->nodes.size();
}
SparseDirect::Supernode SparseDirect::supernode(size_t i) const
{
    const Node& node = p_->nodes[i];
    return {{p_->order.data() + node.begin, node.own()}, node.rest(), node.operations};
}
size_t SparseDirect::factored() const
{
    return p_->done;
}
double SparseDirect::operations() const
{
    return p_->operations;
}
size_t SparseDirect::factorEntries() const
{
    return p_->entries;
}
double SparseDirect::progress() const
{
    const Parts& p = *p_;
    if (!p.sets.empty()) return double(p.ordered) / double(std::max<size_t>(p.pattern.size(), 1));
    if (p.analysed < p.nodes.size()) return double(p.analysed) / double(p.nodes.size());
    return p.operations > 0 ? p.operationsDone / p.operations : 1;
}

}  // namespace mw
