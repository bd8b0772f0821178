// Order, symbolic analysis, numeric factors, substitution: four passes over one tree of supernodes.
#include "core/parameterize/sparse_direct.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <tbb/parallel_for.h>

#include "core/error.h"
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
    size_t columns = 0;                ///< of L (and U), in Parts::lower
    double operations = 0, subtree = 0;
    uint32_t firstOfSubtree = 0;  ///< nodes firstOfSubtree..this one are the subtree
    uint32_t children[2] = {nobody, nobody};

    size_t own() const { return end - begin; }
    size_t rest() const { return borderEnd - border; }
    size_t rows() const { return own() + rest(); }
};

/// Direction of the greatest spread of a sample of places, by power iteration.
glm::vec3 mainDirection(std::span<const uint32_t> set, std::span<const glm::vec3> places)
{
    const size_t stride = 1 + set.size() / 256;
    glm::dvec3 mean(0);
    double n = 0;
    for (size_t i = 0; i < set.size(); i += stride, ++n) mean += glm::dvec3(places[set[i]]);
    mean /= n;
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    for (size_t i = 0; i < set.size(); i += stride) {
        const glm::dvec3 d = glm::dvec3(places[set[i]]) - mean;
        xx += d.x * d.x;
        xy += d.x * d.y;
        xz += d.x * d.z;
        yy += d.y * d.y;
        yz += d.y * d.z;
        zz += d.z * d.z;
    }
    glm::dvec3 axis(1, 0.9, 0.8);
    for (int i = 0; i < 16; ++i) {
        axis = {xx * axis.x + xy * axis.y + xz * axis.z, xy * axis.x + yy * axis.y + yz * axis.z, xz * axis.x + yz * axis.y + zz * axis.z};
        const double length = glm::length(axis);
        if (!(length > 0)) return {1, 0, 0};
        axis /= length;
    }
    return glm::vec3(axis);
}

}  // namespace

struct SparseDirect::Parts {
    SparsePattern pattern;
    Array<glm::vec3> places;
    Array<uint32_t> order, number;  // number to unknown, unknown to number

    // Ordering: sets still to be cut, and where each unknown stands in the set at hand.
    struct Set {
        uint32_t begin, end, parent;
    };
    std::vector<Set> sets;
    Array<uint32_t> side;
    Array<std::pair<float, uint32_t>> keys;
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
    void finishOrder();
    void analyse(uint32_t t);
    void place(uint32_t t);
    void choosePackets();
    void factor(uint32_t t, bool threads);
    void scatter(const Node& node);
    void addUpdate(const Node& node, uint32_t child, double* rest);
    void eliminate(const Node& node, double* rest, bool threads);
};

SparseDirect::SparseDirect(SparsePattern pattern, std::span<const glm::vec3> places) : p_(std::make_unique<Parts>())
{
    Parts& p = *p_;
    p.pattern = std::move(pattern);
    const uint32_t n = uint32_t(p.pattern.size());
    p.places.assign(places.begin(), places.end());
    p.order.resize(n);
    for (uint32_t i = 0; i < n; ++i) p.order[i] = i;
    p.number = Array<uint32_t>(n, 0u);
    p.side = Array<uint32_t>(n, nobody);
    p.keys.resize(n);
    p.sets.push_back({0, n, nobody});
}
SparseDirect::~SparseDirect() = default;
SparseDirect::SparseDirect(SparseDirect&&) noexcept = default;
SparseDirect& SparseDirect::operator=(SparseDirect&&) noexcept = default;

/// Two halves at the median along the main direction; those of one half that touch the other are the separator, numbered last.
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
    const std::span<uint32_t> members(order.data() + set.begin, size);
    const glm::vec3 axis = mainDirection(members, places);
    for (uint32_t i = 0; i < size; ++i) keys[i] = {glm::dot(places[members[i]], axis), members[i]};
    const uint32_t half = size / 2;
    std::nth_element(keys.begin(), keys.begin() + half, keys.begin() + size);
    for (uint32_t i = 0; i < size; ++i) side[keys[i].second] = 2 * node + (i < half ? 0 : 1);
    // 0 inside, 1 at the cut; of both halves.
    uint32_t touching[2] = {0, 0};
    for (uint32_t i = 0; i < size; ++i) {
        const uint32_t v = keys[i].second, other = side[v] ^ 1;
        bool at = false;
        for (uint32_t k = pattern.start[v]; k < pattern.start[v + 1] && !at; ++k) at = side[pattern.column[k]] == other;
        keys[i].first = at ? 1.f : 0.f;
        touching[i < half ? 0 : 1] += at;
    }
    const bool second = touching[1] < touching[0];
    const auto isSeparator = [&](uint32_t i) { return keys[i].first > 0 && (i < half) != second; };
    uint32_t next = 0;
    for (uint32_t i = 0; i < half; ++i)
        if (!isSeparator(i)) members[next++] = keys[i].second;
    const uint32_t first = next;
    for (uint32_t i = half; i < size; ++i)
        if (!isSeparator(i)) members[next++] = keys[i].second;
    const uint32_t both = next;
    for (uint32_t i = 0; i < size; ++i)
        if (isSeparator(i)) members[next++] = keys[i].second;
    nodes.back().begin = set.begin + both;
    ordered += size - both;
    for (uint32_t i = both; i < size; ++i) side[members[i]] = nobody;
    if (both > first) sets.push_back({set.begin + first, set.begin + both, node});
    if (first > 0) sets.push_back({set.begin, set.begin + first, node});
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
    for (uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i;
    side = {};
    keys = {};
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
    for (const uint32_t c : node.children)
        if (c != nobody)
            for (size_t k = nodes[c].border; k < nodes[c].borderEnd; ++k) parentRow[k] = row[border[k]];
}

bool SparseDirect::analyse(double work)
{
    Parts& p = *p_;
    for (; p.analysed < p.nodes.size() && work > 0; ++p.analysed) {
        p.analyse(uint32_t(p.analysed));
        work -= double(p.nodes[p.analysed].rows()) + 8.0 * double(p.nodes[p.analysed].own());
    }
    if (!p.sets.empty()) return double(p.ordered) / double(std::max<size_t>(p.order.size(), 1));
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
    p.lower.resize(p.entries);
    if (!p.values.symmetric) p.upper.resize(p.entries);
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

/// What a child left goes into own columns and rows, or into the update of this node.
void SparseDirect::Parts::addUpdate(const Node& node, uint32_t child, double* rest)
{
    const Node& from = nodes[child];
    const size_t n = from.rest(), rows = node.rows(), own = node.own(), restRows = node.rest();
    const uint32_t* at = parentRow.data() + from.border;
    const size_t ownRows = size_t(std::lower_bound(at, at + n, uint32_t(own)) - at);
    double *l = lower.data() + node.columns, *u = values.symmetric ? nullptr : upper.data() + node.columns;
    const double* update = updates[child].data();
    for (size_t j = 0; j < n; ++j) {
        const double* column = update + j * n;
        double* to = j < ownRows ? l + at[j] * rows : rest + (at[j] - own) * restRows - own;
        for (size_t i = u && j >= ownRows ? ownRows : j; i < n; ++i) to[at[i]] += column[i];
        if (u)
            for (size_t i = 0; i < std::min(j, ownRows); ++i) u[at[i] * rows + at[j]] += column[i];
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
    if (own == 0 || n == 0) return;
    const double *a = l + own, *b = (u ? u : l) + own;
    const auto part = [&](size_t first, size_t last) {
        const size_t above = u ? 0 : first;
        subtractProduct(rest + first * n + above, n, n - above, last - first, a + above, b + first, rows, own, !u);
    };
    constexpr size_t block = 64;
    if (threads && double(own) * double(n) * double(n) > worthThreads)
        tbb::parallel_for(size_t(0), (n + block - 1) / block, [&](size_t k) { part(k * block, std::min(n, (k + 1) * block)); });
    else
        part(0, n);
}

void SparseDirect::Parts::factor(uint32_t t, bool threads)
{
    const Node& node = nodes[t];
    scatter(node);
    updates[t] = Array<double>(node.rest() * node.rest(), 0.0);
    for (const uint32_t c : node.children)
        if (c != nobody) addUpdate(node, c, updates[t].data());
    eliminate(node, updates[t].data(), threads);
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
    if (!p.sets.empty()) return double(p.ordered) / double(std::max<size_t>(p.order.size(), 1));
    if (p.analysed < p.nodes.size()) return double(p.analysed) / double(p.nodes.size());
    return p.operations > 0 ? p.operationsDone / p.operations : 1;
}

}  // namespace mw
