// What rows of attributes need beside an edge table: the edges at every vertex, and the share of creases.
#pragma once
#include "core/subdivide/face_edges.h"

namespace mw {

/// Edges at every vertex, ascending. An edge from a vertex to itself counts twice.
class EdgeRings {
public:
    template <class Edges>
    EdgeRings(size_t vertices, const Edges& edges) : start_(vertices + 2, 0)
    {
        for (const auto& k : edges) ++start_[k.a + 2], ++start_[k.b + 2];
        for (size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
        edge_.resize(start_.back());
        for (uint32_t e = 0; e < edges.size(); ++e) {
            edge_[start_[edges[e].a + 1]++] = e;
            edge_[start_[edges[e].b + 1]++] = e;
        }
    }
    std::span<const uint32_t> of(uint32_t v) const { return {edge_.data() + start_[v], start_[v + 1] - start_[v]}; }

private:
    Array<uint32_t> start_, edge_;
};

template <class Edge>
uint32_t otherEnd(const Edge& e, uint32_t v)
{
    return e.a == v ? e.b : e.a;
}

/// The parts of a row that creases make.
class CreaseRows {
public:
    CreaseRows(size_t vertices, size_t edges, const std::vector<SharpVertex>& creases, const std::vector<SharpEdge>& sharp)
        : creases_(creases), at_(vertices, none), sharpness_(edges, 0.f)
    {
        for (uint32_t i = 0; i < creases.size(); ++i) at_[creases[i].vertex] = i;
        for (const SharpEdge& s : sharp) sharpness_[s.edge] = s.sharpness;
    }
    /// How much of the smooth rule is left.
    double smoothShare(uint32_t v) const { return at_[v] == none ? 1 : 1 - double(creases_[at_[v]].share); }
    double smoothShareOfEdge(uint32_t e) const { return sharpness_[e] >= 1 ? 0 : 1 - double(sharpness_[e]); }
    /// What the vertex itself gets of its crease.
    double own(uint32_t v) const
    {
        if (at_[v] == none) return 0;
        const SharpVertex& s = creases_[at_[v]];
        return double(s.share) * (1 - 2 * double(s.side));
    }
    void addSides(uint32_t v, Stencils& rows) const
    {
        if (at_[v] == none || creases_[at_[v]].side == 0) return;
        const SharpVertex& s = creases_[at_[v]];
        rows.add(s.a, double(s.share) * double(s.side));
        rows.add(s.b, double(s.share) * double(s.side));
    }

private:
    const std::vector<SharpVertex>& creases_;
    Array<uint32_t> at_;
    Array<float> sharpness_;
};

}  // namespace mw
