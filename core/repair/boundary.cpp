// At each end of a boundary side the fan of faces there has a second boundary side: following these pairs gives the loops.
#include "core/repair/boundary.h"

#include <algorithm>

#include "core/mesh/connectivity.h"
#include "core/repair/fans.h"

namespace mw {

namespace {

/// An end of a boundary side: its start (0) or its end (1).
struct End {
    uint32_t fan, side;
    uint8_t last;
};

struct Passed {
    uint32_t side;
    bool backwards;  // from its end to its start, as the hole runs beside a face
};

class Tracer {
public:
    explicit Tracer(const Mesh& mesh) : mesh_(mesh), fans_(mesh) {}
    std::vector<BoundaryLoop> run();

private:
    void collect();
    void pairEnds();
    void pairWithin(std::span<const End> ends);
    void link(const End& a, const End& b);
    std::vector<Passed> walk(uint32_t side);
    void takeApart(const std::vector<Passed>& walk, std::vector<BoundaryLoop>& out) const;
    BoundaryLoop loopOf(std::vector<Passed> passed) const;

    uint32_t vertexFrom(const Passed& p) const { return mesh_.cornerVertex()[p.backwards ? fans_.next(p.side) : p.side]; }

    const Mesh& mesh_;
    CornerFans fans_;
    Array<uint32_t> face_;  // of each corner
    std::vector<uint32_t> sides_;
    Array<uint32_t> partner_[2];  // of the start and of the end of a side: 2 * side + end
    std::vector<uint8_t> seen_;
};

void Tracer::collect()
{
    const std::vector<uint8_t> degenerate = degenerateFacesOf(mesh_);
    const EdgeSides edges = edgeSidesOf(mesh_, degenerate);
    for (size_t e = 0; e < edges.size(); ++e) {
        const auto sides = edges.sides(e);
        if (sides.size() == 1) sides_.push_back(sides[0]);
        for (size_t i = 1; i < sides.size(); ++i) fans_.join(sides[0], sides[i]);
    }
    std::sort(sides_.begin(), sides_.end());
}

void Tracer::link(const End& a, const End& b)
{
    partner_[a.last][a.side] = 2 * b.side + b.last;
    partner_[b.last][b.side] = 2 * a.side + a.last;
}

/// A start with an end as long as there are both, then what is left among itself.
void Tracer::pairWithin(std::span<const End> ends)
{
    std::vector<End> starts, lasts;
    for (const End& e : ends) (e.last ? lasts : starts).push_back(e);
    const size_t both = std::min(starts.size(), lasts.size());
    for (size_t i = 0; i < both; ++i) link(starts[i], lasts[i]);
    for (const auto* rest : {&starts, &lasts})
        for (size_t i = both; i + 1 < rest->size(); i += 2) link((*rest)[i], (*rest)[i + 1]);
}

void Tracer::pairEnds()
{
    std::vector<End> ends;
    for (const uint32_t s : sides_) {
        ends.push_back({fans_.fanOf(s), s, 0});
        ends.push_back({fans_.fanOf(fans_.next(s)), s, 1});
    }
    std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.fan < b.fan; });
    for (auto& p : partner_) p.assign(mesh_.cornerCount(), none);
    for (size_t i = 0, j = 0; i < ends.size(); i = j) {
        while (j < ends.size() && ends[j].fan == ends[i].fan) ++j;
        pairWithin({ends.data() + i, j - i});
    }
}

/// From a side backwards until it comes round; empty when it ends somewhere.
std::vector<Passed> Tracer::walk(uint32_t side)
{
    std::vector<Passed> out;
    Passed now{side, true};
    while (!seen_[now.side]) {
        seen_[now.side] = 1;
        out.push_back(now);
        const uint32_t ahead = partner_[now.backwards ? 0 : 1][now.side];
        if (ahead == none) return {};
        now = {ahead / 2, ahead % 2 == 1};
    }
    return now.side == side ? out : std::vector<Passed>();
}

BoundaryLoop Tracer::loopOf(std::vector<Passed> passed) const
{
    size_t backwards = 0;
    for (const Passed& p : passed) backwards += p.backwards;
    if (2 * backwards < passed.size()) {
        std::reverse(passed.begin(), passed.end());
        for (Passed& p : passed) p.backwards = !p.backwards;
    }
    BoundaryLoop loop;
    for (const Passed& p : passed) {
        loop.vertices.push_back(vertexFrom(p));
        loop.faces.push_back(face_[p.side]);
        loop.corners.push_back(p.backwards ? fans_.next(p.side) : p.side);
    }
    return loop;
}

/// Whenever the walk is back at a vertex, what lies between is a loop of its own.
void Tracer::takeApart(const std::vector<Passed>& walk, std::vector<BoundaryLoop>& out) const
{
    std::vector<Passed> open;
    std::vector<uint32_t> vertices;
    for (const Passed& p : walk) vertices.push_back(vertexFrom(p));
    std::vector<uint32_t> sorted = vertices;
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    std::vector<uint32_t> depth(sorted.size(), none);
    const auto number = [&](uint32_t v) { return size_t(std::lower_bound(sorted.begin(), sorted.end(), v) - sorted.begin()); };
    const auto close = [&](size_t from) {
        std::vector<Passed> loop(open.begin() + long(from), open.end());
        for (const Passed& p : loop) depth[number(vertexFrom(p))] = none;
        open.resize(from);
        if (loop.size() >= 3) out.push_back(loopOf(std::move(loop)));
    };
    for (size_t i = 0; i < walk.size(); ++i) {
        const size_t v = number(vertices[i]);
        if (depth[v] != none) close(depth[v]);
        depth[v] = uint32_t(open.size());
        open.push_back(walk[i]);
    }
    close(0);
}

std::vector<BoundaryLoop> Tracer::run()
{
    face_ = cornerFacesOf(mesh_);
    collect();
    pairEnds();
    seen_.assign(mesh_.cornerCount(), 0);
    std::vector<BoundaryLoop> out;
    for (const uint32_t s : sides_)
        if (!seen_[s]) takeApart(walk(s), out);
    return out;
}

}  // namespace

std::vector<BoundaryLoop> boundaryLoopsOf(const Mesh& mesh)
{
    return Tracer(mesh).run();
}

}  // namespace mw
