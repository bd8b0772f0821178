// A mesh of some of another's elements, with all their attributes.
#pragma once
#include <vector>

#include "core/mesh/table.h"

namespace mw {

/// What is kept: one entry an element. A face or line is kept only with all its vertices.
struct KeptElements {
    std::vector<bool> vertices, faces, lines;
    explicit KeptElements(const Mesh& mesh) : vertices(mesh.vertexCount(), true), faces(mesh.faceCount(), true), lines(mesh.lines().size() / 2, true)
    {}
};
/// Elements keep their order. Group names stay.
Mesh submesh(const Mesh& mesh, const KeptElements& kept);

/// Without some vertices, edges or faces: faces and lines at a deleted vertex or edge go, too, and so do vertices that only what went had used.
Mesh withoutElements(const Mesh& mesh, const ElementSet& elements);
/// Two meshes of one: the faces named, and the others with loose lines and vertices. `faces` ascending.
struct SplitMesh {
    Mesh named, others;
};
SplitMesh splitFaces(const Mesh& mesh, const std::vector<bool>& named);

}  // namespace mw
