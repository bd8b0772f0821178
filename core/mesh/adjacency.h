// The nine adjacency queries of table 2.1, each walked one half-edge at a time. Book 2.6.
#pragma once
#include <string>

#include "core/mesh/table.h"
#include "core/steps/stage.h"

namespace mw {

struct Adjacency {
    /// From one kind of element to another: value / 3 is the kind asked about, value % 3 the kind found (vertex, edge, face).
    enum class Query {
        VertexVertices,
        VertexEdges,
        VertexFaces,
        EdgeVertices,
        EdgeEdges,
        EdgeFaces,
        FaceVertices,
        FaceEdges,
        FaceFaces
    } query = Query::VertexVertices;
    std::string element = "0";
    int64_t ring = 1;
    bool acrossVertices = false;
    template <class V>
    void describe(V& v)
    {
        v.choice("query", query,
                 {"vertex-vertices", "vertex-edges", "vertex-faces", "edge-vertices", "edge-edges", "edge-faces", "face-vertices", "face-edges",
                  "face-faces"},
                 {.title = "Query", .help = "Which neighbours of which kind of element: vertex-faces finds the faces around a vertex."});
        v.text("element", element,
               {.title = "Element", .help = "The one asked about: the index of a vertex or face, or the two vertices of an edge, as in 3~7."});
        v.integer("ring", ring,
                  {.title = "Rings",
                   .help = "1: the vertices one edge away (one-ring). 2: those and theirs (two-ring), and so on.",
                   .min = 1,
                   .max = 20,
                   .softMax = 4,
                   .when = "query=vertex-vertices"});
        v.flag("across-vertices", acrossVertices,
               {.title = "Across vertices",
                .help = "Faces that share a vertex with the face; else only those that share an edge.",
                .when = "query=face-faces"});
    }
};

ElementKind askedKind(Adjacency::Query query);
ElementKind foundKind(Adjacency::Query query);

/// The elements of one kind beside one element, itself left out. Edges beside an edge are all that meet one of its ends. Works on any soup: where
/// the half-edge view had to split a vertex or an edge all its parts are walked, and degenerate faces, which have no half-edges, are looked at
/// one by one. Throws Error when the mesh has no such element.
Generator adjacency(Mesh input, Adjacency parameters, Stage<ElementSet>& stage);

}  // namespace mw
