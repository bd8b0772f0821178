// The overlay of two triangle meshes on one domain: all vertices of both, all crossings of their edges, and triangles between them.
#pragma once
#include <array>

#include "core/mesh/attribute.h"
#include "core/morph/trace.h"

namespace mw {

/// A mesh to overlay: its map, where its vertices stand, and what a corner weighs against the others when a place within a triangle is mixed
/// from them (1: as in the map; 1/r makes it the true central projection of a vertex at distance r).
struct OverlayInput {
    DomainMesh map;
    std::vector<glm::dvec3> positions;
    std::vector<double> mass;
};

/// A place in a mesh: a vertex, a point of an edge (`share` from tail to head of half-edge `index`), a point of a triangle.
struct OverlayPlace {
    Location at;
    glm::dvec3 weights{0};  ///< of the triangle's corners; of an edge x and y, tail and head
};

/// Vertices: those of the first mesh in their order, then those of the second that lie on none of them, then the crossings. All decisions are
/// exact, so the result is a manifold also where vertices and edges of the two coincide.
class Overlay {
public:
    /// Throws Error when a map is folded or does not cover its domain once.
    Overlay(OverlayInput first, OverlayInput second);

    // The stages, in this order; those with a range can be done in parts.
    void locate();                                          ///< the first vertex of each mesh in the other
    bool locateMore(int of, size_t most);                   ///< the rest, from neighbour to neighbour; false when all are
    void trace(int of, uint32_t firstEdge, uint32_t last);  ///< edges of mesh `of` through the other, in order
    bool connect();                                         ///< crossings are matched, pieces of edges joined at their ends; false when all are
    bool fill(size_t most);                                 ///< triangles; false when all are there

    const OverlayInput& input(int of) const { return input_[of]; }
    /// Where a vertex of mesh `of` lies in the other.
    const Location& where(int of, uint32_t vertex) const { return where_[of][vertex]; }
    std::span<const Hop> hops(int of, uint32_t edge) const
    {
        return {hops_[of].data() + hopStart_[of][edge], hopStart_[of][edge + 1] - hopStart_[of][edge]};
    }
    size_t crossingsSoFar(int of) const { return crossings_[of]; }
    size_t reached(int of) const { return reached_[of]; }
    /// A vertex of mesh `of` in the other, once located.
    OverlayPlace placeInOther(int of, uint32_t vertex) const { return placed(1 - of, where_[of][vertex], input_[of].map.at(vertex)); }
    /// Where edge `by` of the other mesh crosses an edge of mesh `in`.
    OverlayPlace crossed(int in, uint32_t edge, uint32_t by) const;
    glm::dvec3 mixed(int in, const OverlayPlace& p) const;
    /// The weights of the corners of triangle f at a place that lies in it.
    glm::dvec3 weightsOf(int in, uint32_t f, const OverlayPlace& p) const;

    // After connect():
    size_t vertices() const { return vertices_; }
    size_t crossings() const { return crossings_[0]; }
    size_t coincident() const { return coincident_; }
    uint32_t firstCrossing() const { return uint32_t(vertices_ - crossings_[0]); }
    /// The vertex of the overlay that a vertex of mesh `of` has become.
    uint32_t vertexOf(int of, uint32_t vertex) const { return of == 0 ? vertex : second_[vertex]; }
    const OverlayPlace& place(int in, uint32_t vertex) const { return places_[in][vertex]; }
    glm::dvec3 position(int in, uint32_t vertex) const { return positions_[in][vertex]; }
    // After fill():
    const std::vector<uint32_t>& corners() const { return corners_; }  ///< three a triangle
    uint32_t triangleOf(int in, size_t triangle) const { return from_[in][triangle]; }
    /// The edge of mesh `of` along which the side from corner c to the next runs; none when it runs along none.
    uint32_t edgeAlong(int of, size_t corner) const { return line_[of][corner]; }
    glm::dvec3 weightsIn(int in, uint32_t f, uint32_t vertex) const { return weightsOf(in, f, places_[in][vertex]); }

private:
    struct Piece {  // half-edge 2s runs from a to b, 2s+1 back
        uint32_t a, b, towardA, towardB;
        std::array<uint32_t, 2> line;         // edge of each mesh that it lies on
        std::array<uint32_t, 2> left, right;  // triangles of each mesh beside it
    };
    struct Side {
        uint32_t vertex;
        std::array<uint32_t, 2> line;  // of the side from here to the next
    };
    uint32_t origin(uint32_t half) const { return half & 1 ? pieces_[half / 2].b : pieces_[half / 2].a; }
    uint32_t toward(uint32_t half) const { return half & 1 ? pieces_[half / 2].towardA : pieces_[half / 2].towardB; }
    const Direction& direction(uint32_t vertex) const;
    void placeVertices();
    void placeCrossings();
    OverlayPlace placed(int in, const Location& at, const Direction& d) const;
    void addPieces(int of);
    void sortOut();
    bool link(size_t most);
    void sortAround(uint32_t vertex, std::span<uint32_t> halves) const;
    void sortAtCrossing(std::span<uint32_t> halves) const;
    void triangulate(std::vector<Side>& polygon, std::array<uint32_t, 2> from);
    double quality(uint32_t a, uint32_t b, uint32_t c) const;
    void emit(const Side& a, const Side& b, const Side& c, std::array<uint32_t, 2> lastLine, std::array<uint32_t, 2> from);

    OverlayInput input_[2];
    std::vector<Location> where_[2];
    std::vector<uint32_t> queue_[2];
    size_t reached_[2] = {0, 0};
    std::vector<Hop> hops_[2];
    std::vector<uint32_t> hopStart_[2];
    size_t crossings_[2] = {0, 0};
    size_t vertices_ = 0, coincident_ = 0;
    std::vector<uint32_t> second_;                   // vertex of the second mesh to vertex of the overlay
    std::vector<uint32_t> secondOf_;                 // and back, for those that are new
    std::vector<std::array<uint32_t, 2>> cross_;     // the two edges of each crossing
    std::vector<uint32_t> crossStart_, crossOrder_;  // crossings by edge of the second mesh, sorted by edge of the first
    std::vector<OverlayPlace> places_[2];
    std::vector<glm::dvec3> positions_[2];
    std::vector<Piece> pieces_;
    int part_ = 0;                          // of connect()
    std::vector<uint32_t> outStart_, out_;  // half-edges by their origin, while they are linked
    uint32_t linked_ = 0;                   // vertices
    std::vector<uint32_t> nextHalf_;
    std::vector<bool> filled_;
    uint32_t fillAt_ = 0;
    std::vector<uint32_t> corners_, from_[2], line_[2];
};

}  // namespace mw
