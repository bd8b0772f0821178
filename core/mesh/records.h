// What the three mesh data structures of the book store for one element: face-based, winged-edge, half-edge. Book 2.5.
#pragma once
#include <string>
#include <vector>

#include "core/mesh/halfedge_walk.h"

namespace mw {

/// What a field of a record names. Vertices and faces are the payload's; half-edges those of the half-edge view, edge e has the two half-edges
/// 2e and 2e + 1.
struct RecordLink {
    enum class To { Nothing, Vertex, Edge, Face, Halfedge } to = To::Nothing;
    uint32_t index = 0;
    bool operator==(const RecordLink&) const = default;
};

struct Record {
    std::string type;  ///< as in the book: "Triangle", "W_edge", "H_edge", "Vertex", "Face"
    RecordLink of;     ///< the element it is the record of
    struct Field {
        std::string name;   ///< as in the book: "left_prev"
        std::string label;  ///< of the book's figure: "a"; empty where there is none
        RecordLink link;
    };
    std::vector<Field> fields;
};

/// Where in the mesh the records are looked at: a half-edge tells a vertex (its source), an edge and a face beside.
struct RecordPlace {
    uint32_t halfedge = none, vertex = none, face = none;  ///< none where there is no such thing
};
RecordPlace placeOf(const HalfedgeWalk& walk, RecordLink link);
RecordPlace placeOfEdge(const HalfedgeWalk& walk, uint32_t from, uint32_t to);  ///< nothing when no edge joins them

/// Figure 2.7, for polygons of any size: p1, p2, ... and the faces t1, t2, ... across p1 p2, p2 p3, ...
Record faceRecord(const HalfedgeWalk& walk, const Mesh& mesh, uint32_t face);

/// Figure 2.9. Edge e runs from the source P to the target Q of half-edge 2e. Both faces are gone round clockwise: on the left a comes before PQ
/// and meets it at Q, b comes after and meets it at P; on the right c comes before at P and d after at Q.
Record wingedEdgeRecord(const HalfedgeWalk& walk, uint32_t edge);
Record wingedVertexRecord(const HalfedgeWalk& walk, uint32_t vertex);
Record wingedFaceRecord(const HalfedgeWalk& walk, uint32_t face);

/// Figure 2.10. Half-edge PQ: the vertex Q it leads to, the face L on its left, prev a, next b anticlockwise, and its pair QP.
Record halfedgeRecord(const HalfedgeWalk& walk, uint32_t halfedge);
Record halfedgeVertexRecord(const HalfedgeWalk& walk, uint32_t vertex);
Record halfedgeFaceRecord(const HalfedgeWalk& walk, uint32_t face);

}  // namespace mw
