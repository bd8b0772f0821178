// Locating and tracing use exact side tests only; both meshes are traced through each other, so that the order of crossings along every edge is known
// without comparing where they are.
#include "core/morph/overlay.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.h"

namespace mw {

namespace {

constexpr size_t mostHops = 60'000'000;

std::string counted(size_t n, const char* one)
{
    return std::to_string(n) + " " + one + (n == 1 ? "" : "s");
}

void check(const DomainMesh& map, const char* which)
{
    if (const std::vector<uint32_t> folds = map.folds(); !folds.empty())
        throw Error("the map of the " + std::string(which) + " mesh turns " + counted(folds.size(), "triangle") +
                    " over; make its triangles more even (subdivide, smooth or simplify it) or choose another method");
}

}  // namespace

Overlay::Overlay(OverlayInput first, OverlayInput second) : input_{std::move(first), std::move(second)}
{
    for (int of = 0; of < 2; ++of) {
        const DomainMesh& map = input_[of].map;
        check(map, of == 0 ? "first" : "other");
        where_[of].assign(map.vertices(), {});
        hopStart_[of].assign(1, 0);
    }
}

void Overlay::locate()
{
    for (int of = 0; of < 2; ++of) {
        where_[of][0] = located(input_[1 - of].map, input_[of].map.at(0));
        queue_[of] = {0};
    }
}

bool Overlay::locateMore(int of, size_t most)
{
    const DomainMesh &map = input_[of].map, &other = input_[1 - of].map;
    const auto reach = [&](uint32_t u, uint32_t v) {
        if (where_[of][v].index != none) return;
        where_[of][v] = traced(other, map.at(u), map.at(v), where_[of][u], nullptr);
        queue_[of].push_back(v);
    };
    for (; reached_[of] < queue_[of].size() && most > 0; ++reached_[of], --most) {
        const uint32_t u = queue_[of][reached_[of]];
        for (const uint32_t h : map.outgoing(u)) {
            reach(u, map.to(h));
            reach(u, map.from(DomainMesh::previous(h)));
        }
    }
    return reached_[of] < queue_[of].size();
}

void Overlay::trace(int of, uint32_t firstEdge, uint32_t last)
{
    const DomainMesh& map = input_[of].map;
    for (uint32_t e = firstEdge; e < last; ++e) {
        const uint32_t h = map.half(e), u = map.from(h);
        const size_t before = hops_[of].size();
        traced(input_[1 - of].map, map.at(u), map.at(map.to(h)), where_[of][u], &hops_[of]);
        for (size_t i = before; i < hops_[of].size(); ++i) crossings_[of] += hops_[of][i].kind == Hop::Met::Edge;
        if (hops_[of].size() > mostHops)
            throw Error("the edges of the two meshes cross more than " + std::to_string(mostHops / 1'000'000) +
                        " million times; simplify them first");
        hopStart_[of].push_back(uint32_t(hops_[of].size()));
    }
}

glm::dvec3 Overlay::mixed(int in, const OverlayPlace& p) const
{
    const OverlayInput& m = input_[in];
    if (p.at.kind == Location::Kind::Vertex) return m.positions[p.at.index];
    if (p.at.kind == Location::Kind::Edge) return p.weights.x * m.positions[m.map.from(p.at.index)] + p.weights.y * m.positions[m.map.to(p.at.index)];
    glm::dvec3 sum(0);
    for (int k = 0; k < 3; ++k) sum += p.weights[k] * m.positions[m.map.corners()[3 * p.at.index + uint32_t(k)]];
    return sum;
}

glm::dvec3 Overlay::weightsOf(int in, uint32_t f, const OverlayPlace& p) const
{
    const DomainMesh& map = input_[in].map;
    if (p.at.kind == Location::Kind::Triangle) return p.weights;
    glm::dvec3 out(0);
    for (int k = 0; k < 3; ++k) {
        const uint32_t v = map.corners()[3 * f + uint32_t(k)];
        if (p.at.kind == Location::Kind::Vertex)
            out[k] = v == p.at.index ? 1 : 0;
        else
            out[k] = v == map.from(p.at.index) ? p.weights.x : v == map.to(p.at.index) ? p.weights.y : 0;
    }
    return out;
}

/// Mixes of corners by the determinants that the place makes with the others: exact up to the last rounding.
OverlayPlace Overlay::placed(int in, const Location& at, const Direction& d) const
{
    const OverlayInput& m = input_[in];
    OverlayPlace p{at, glm::dvec3(0)};
    if (at.kind == Location::Kind::Vertex) return p;
    if (at.kind == Location::Kind::Triangle) {
        const uint32_t h = 3 * at.index;
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t v = m.map.from(h + k), a = m.map.to(h + k), b = m.map.from(DomainMesh::previous(h + k));
            p.weights[int(k)] = double(determinant(d, m.map.at(a), m.map.at(b))) * m.mass[v];
        }
        p.weights /= p.weights.x + p.weights.y + p.weights.z;
        return p;
    }
    // On an edge: against the plane through the third corner and the centre, whose side is never 0 here.
    const uint32_t h = at.index, a = m.map.from(h), b = m.map.to(h), c = m.map.from(DomainMesh::previous(h));
    p.weights.x = double(determinant(d, m.map.at(b), m.map.at(c))) * m.mass[a];
    p.weights.y = double(determinant(d, m.map.at(c), m.map.at(a))) * m.mass[b];
    p.weights /= p.weights.x + p.weights.y;
    return p;
}

/// Shares from the sides of the ends.
OverlayPlace Overlay::crossed(int in, uint32_t edge, uint32_t by) const
{
    const OverlayInput& m = input_[in];
    const DomainMesh& other = input_[1 - in].map;
    const uint32_t h = m.map.half(edge), g = other.half(by), a = m.map.from(h), b = m.map.to(h);
    const double da = std::abs(double(determinant(other.at(other.from(g)), other.at(other.to(g)), m.map.at(a))));
    const double db = std::abs(double(determinant(other.at(other.from(g)), other.at(other.to(g)), m.map.at(b))));
    OverlayPlace p{{Location::Kind::Edge, h}, {db * m.mass[a], da * m.mass[b], 0}};
    p.weights /= p.weights.x + p.weights.y;
    return p;
}

void Overlay::placeVertices()
{
    const size_t n = input_[0].map.vertices(), k = input_[1].map.vertices();
    second_.resize(k);
    for (uint32_t v = 0; v < k; ++v) {
        if (where_[1][v].kind == Location::Kind::Vertex) {
            second_[v] = where_[1][v].index;
            ++coincident_;
        } else {
            second_[v] = uint32_t(n + secondOf_.size());
            secondOf_.push_back(v);
        }
    }
    vertices_ = n + secondOf_.size() + crossings_[0];
    if (vertices_ >= none / 8) throw Error("the overlay of the two meshes is too large; simplify them first");
    for (auto& p : places_) p.resize(vertices_);
    for (uint32_t v = 0; v < n; ++v) {
        places_[0][v] = {{Location::Kind::Vertex, v}, {}};
        places_[1][v] = placed(1, where_[0][v], input_[0].map.at(v));
    }
    for (size_t i = 0; i < secondOf_.size(); ++i) {
        const uint32_t v = secondOf_[i];
        places_[0][n + i] = placed(0, where_[1][v], input_[1].map.at(v));
        places_[1][n + i] = {{Location::Kind::Vertex, v}, {}};
    }
}

/// Crossings are numbered as the edges of the first mesh meet them; those of each edge of the second are kept sorted to be found again.
void Overlay::placeCrossings()
{
    const DomainMesh& b = input_[1].map;
    crossStart_.assign(b.edges() + 1, 0);
    for (uint32_t e = 0; e < input_[0].map.edges(); ++e)
        for (const Hop& hop : hops(0, e))
            if (hop.kind == Hop::Met::Edge) {
                cross_.push_back({e, b.edge(hop.met)});
                ++crossStart_[b.edge(hop.met) + 1];
            }
    for (size_t e = 0; e < b.edges(); ++e) crossStart_[e + 1] += crossStart_[e];
    crossOrder_.resize(cross_.size());
    std::vector<uint32_t> fill(crossStart_.begin(), crossStart_.end() - 1);
    for (uint32_t c = 0; c < cross_.size(); ++c) crossOrder_[fill[cross_[c][1]]++] = c;  // ascending in the edge of the first
    if (crossings_[0] != crossings_[1]) throw Error("the two maps do not agree on where their edges cross; one of them covers the domain twice");
    const uint32_t first = firstCrossing();
    for (uint32_t c = 0; c < cross_.size(); ++c) {
        places_[0][first + c] = crossed(0, cross_[c][0], cross_[c][1]);
        places_[1][first + c] = crossed(1, cross_[c][1], cross_[c][0]);
    }
}

const Direction& Overlay::direction(uint32_t vertex) const
{
    const size_t n = input_[0].map.vertices();
    return vertex < n ? input_[0].map.at(vertex) : input_[1].map.at(secondOf_[vertex - n]);
}

void Overlay::addPieces(int of)
{
    const DomainMesh &map = input_[of].map, &other = input_[1 - of].map;
    uint32_t crossing = firstCrossing();  // of the first mesh they come in order
    const auto met = [&](uint32_t e, const Hop& hop) {
        if (hop.kind == Hop::Met::Vertex) return vertexOf(1 - of, hop.met);
        if (of == 0) return crossing++;
        const uint32_t by = other.edge(hop.met);
        const auto begin = crossOrder_.begin() + crossStart_[e], end = crossOrder_.begin() + crossStart_[e + 1];
        const auto i = std::lower_bound(begin, end, by, [&](uint32_t c, uint32_t edge) { return cross_[c][0] < edge; });
        if (i == end || cross_[*i][0] != by) throw Error("the two maps do not agree on where their edges cross; one of them covers the domain twice");
        return firstCrossing() + *i;
    };
    pieces_.reserve(hops_[0].size() + hops_[1].size());
    for (uint32_t e = 0; e < map.edges(); ++e) {
        const uint32_t h = map.half(e), from = vertexOf(of, map.from(h)), to = vertexOf(of, map.to(h));
        uint32_t at = from;
        for (const Hop& hop : hops(of, e)) {
            const uint32_t end = hop.kind == Hop::Met::End ? to : met(e, hop);
            Piece p{at, end, from, to, {none, none}, {none, none}, {none, none}};
            p.line[of] = e;
            p.left[of] = map.triangleLeft(h);
            p.right[of] = map.triangleRight(h);
            p.left[1 - of] = p.right[1 - of] = hop.within;
            if (hop.along) {
                p.line[1 - of] = other.edge(hop.within);
                p.left[1 - of] = hop.along > 0 ? other.triangleLeft(hop.within) : other.triangleRight(hop.within);
                p.right[1 - of] = hop.along > 0 ? other.triangleRight(hop.within) : other.triangleLeft(hop.within);
            }
            if (of == 0 || !hop.along) pieces_.push_back(p);  // what runs along the first mesh is there already
            at = end;
        }
    }
}

/// Anticlockwise, by exact angles about a vertex of one of the meshes.
void Overlay::sortAround(uint32_t vertex, std::span<uint32_t> halves) const
{
    const Direction& o = direction(vertex);
    const Direction& zero = direction(toward(halves[0]));
    const uint32_t first = halves[0];
    const auto lower = [&](uint32_t h) { return h == first || side(o, zero, direction(toward(h))) > 0; };
    std::sort(halves.begin(), halves.end(), [&](uint32_t x, uint32_t y) {
        if (x == first || y == first) return x == first && y != first;
        const bool lx = lower(x), ly = lower(y);
        if (lx != ly) return lx;
        return side(o, direction(toward(x)), direction(toward(y))) > 0;
    });
}

void Overlay::sortAtCrossing(std::span<uint32_t> halves) const
{
    std::array<uint32_t, 2> along[2];
    size_t count[2] = {0, 0};
    for (const uint32_t h : halves) {
        const int of = pieces_[h / 2].line[0] != none ? 0 : 1;
        along[of][count[of]++] = h;
    }
    const Direction &p = direction(toward(along[0][1])), &q = direction(toward(along[0][0]));
    const bool left = side(p, q, direction(toward(along[1][0]))) > 0;
    halves[0] = along[0][0];
    halves[1] = along[1][left ? 0 : 1];
    halves[2] = along[0][1];
    halves[3] = along[1][left ? 1 : 0];
}

void Overlay::sortOut()
{
    const uint32_t halves = uint32_t(2 * pieces_.size());
    outStart_.assign(vertices_ + 1, 0);
    out_.resize(halves);
    for (uint32_t h = 0; h < halves; ++h) ++outStart_[origin(h) + 1];
    for (size_t v = 0; v < vertices_; ++v) outStart_[v + 1] += outStart_[v];
    std::vector<uint32_t> fill(outStart_.begin(), outStart_.end() - 1);
    for (uint32_t h = 0; h < halves; ++h) out_[fill[origin(h)]++] = h;
    nextHalf_.resize(halves);
    filled_.assign(halves, false);
}

/// The half-edges round every vertex in order; after a half-edge comes the one clockwise of its way back.
bool Overlay::link(size_t most)
{
    const uint32_t end = uint32_t(std::min(vertices_, linked_ + most));
    for (; linked_ < end; ++linked_) {
        const std::span<uint32_t> around(out_.data() + outStart_[linked_], outStart_[linked_ + 1] - outStart_[linked_]);
        if (around.empty()) continue;
        if (linked_ < firstCrossing())
            sortAround(linked_, around);
        else
            sortAtCrossing(around);
        for (size_t i = 0; i < around.size(); ++i) nextHalf_[around[i] ^ 1] = around[(i + around.size() - 1) % around.size()];
    }
    if (linked_ < vertices_) return true;
    outStart_ = out_ = {};
    return false;
}

bool Overlay::connect()
{
    constexpr size_t chunk = size_t(1) << 16;
    const auto mix = [this](int in) {
        positions_[in].resize(vertices_);
        for (uint32_t v = 0; v < vertices_; ++v) positions_[in][v] = mixed(in, places_[in][v]);
    };
    const std::function<void()> parts[] = {[this] { placeVertices(); }, [this] { placeCrossings(); }, [&] { mix(0); },      [&] { mix(1); },
                                           [this] { addPieces(0); },    [this] { addPieces(1); },     [this] { sortOut(); }};
    if (part_ == std::ssize(parts)) return link(chunk);
    parts[part_++]();
    return true;
}

}  // namespace mw
