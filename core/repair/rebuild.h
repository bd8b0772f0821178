// A mesh put together from parts of another one: the way in which repairs carry attributes.
#pragma once
#include "core/mesh/mesh.h"

namespace mw {

/// Where each new element comes from. Faces have the corners faceStart[f] .. faceStart[f+1]-1, at new vertices.
struct Parts {
    Array<uint32_t> vertexFrom;                   ///< old vertex of each new one
    Array<uint32_t> faceStart{0u}, cornerVertex;  ///< the new faces
    Array<uint32_t> cornerFrom, faceFrom;         ///< old corner of each new one, old face of each new one
    Array<uint32_t> lines;                        ///< pairs of new vertices
    void addCorner(uint32_t newVertex, uint32_t oldCorner)
    {
        cornerVertex.push_back(newVertex);
        cornerFrom.push_back(oldCorner);
    }
    void endFace(uint32_t oldFace)
    {
        faceStart.push_back(uint32_t(cornerVertex.size()));
        faceFrom.push_back(oldFace);
    }
};

/// Positions and all attributes gathered, groups kept.
Mesh rebuilt(const Mesh& mesh, Parts parts);

/// The mesh without the faces marked in `dropped` (empty: none). Vertices stay.
Mesh withoutFaces(const Mesh& mesh, const std::vector<uint8_t>& dropped);
/// The mesh without vertices that no face and no line uses.
Mesh withoutLooseVertices(const Mesh& mesh);

}  // namespace mw
