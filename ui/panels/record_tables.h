// What the Records panel shows and draws at a place of a mesh: tables of links, arrows with letters, answers. No widgets.
#pragma once
#include <QString>
#include <memory>
#include <vector>

#include "core/mesh/adjacency.h"
#include "core/mesh/records.h"
#include "ui/view_state.h"

namespace mw {

/// A mesh and its half-edges, made together on a worker: the first walk of a large mesh builds the view.
struct RecordMesh {
    explicit RecordMesh(const Mesh& m) : mesh(m), walk(m) {}
    Mesh mesh;
    HalfedgeWalk walk;
};

/// One field: its name (and the letter of the book's figure), and what it names.
struct RecordCell {
    QString name;
    RecordLink link;
    QString missing = {};  ///< in place of a link
};
/// Cells stand two a line.
struct RecordTable {
    QString id, title;
    std::vector<RecordCell> cells;
};

/// "v12", "e7", "f5", "h14"; for people: "Half-edge 14, from vertex 3 to 9".
QString handleOf(RecordLink link);
QString wordsOf(const RecordMesh& m, RecordLink link);
/// As elements of the payload: vertices, faces, an edge for edges and half-edges; empty for nothing.
ElementSet elementsOf(const RecordMesh& m, RecordLink link);
/// The link of the first element of a selection; nothing when the mesh has it not.
RecordLink linkOf(const RecordMesh& m, const ElementSet& elements);

/// Half-edge, winged-edge and face-based records and the triangle-adjacency primitive at a place.
std::vector<RecordTable> recordTables(const RecordMesh& m, const RecordPlace& place);
/// The element of a place that a query asks about; nothing where there is none.
RecordLink askedAt(const RecordPlace& place, Adjacency::Query query);
ElementSet answerOf(const RecordMesh& m, RecordLink asked, Adjacency::Query query);
/// Handles of the elements, the first `most` of them: "v12, v15, and 4 more".
QString handlesOf(const RecordMesh& m, const ElementSet& elements, size_t most);

enum class RecordDrawing { Halfedge, WingedEdge, FaceBased, Primitive, Answer, Nothing };
/// Arrows set inwards, anticlockwise, with the letters of figures 2.7, 2.9, 2.10 and 2.15.
ViewState::Sketch sketchOf(const RecordMesh& m, const RecordPlace& place, RecordDrawing drawing, NodeId node, const glm::dmat4& world);
ViewState::Sketch sketchOfAnswer(const RecordMesh& m, RecordLink asked, const ElementSet& answer, NodeId node, const glm::dmat4& world);

}  // namespace mw
