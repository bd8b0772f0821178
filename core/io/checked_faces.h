// The last step of the mesh readers: what a file says about vertices and faces is brought into the form that Mesh promises.
#pragma once
#include <functional>

#include "core/io/findings.h"
#include "core/mesh/mesh.h"

namespace mw {

/// Puts each position that is not finite at the centre of the others' box, so that indices and bounds stay, and lists it.
std::vector<uint32_t> mendPositions(Array<glm::vec3>& positions);

/// The faces of a file and which of them remain.
struct CheckedFaces {
    Array<uint32_t> faceStart, cornerVertex;
    bool all = true;                                        ///< nothing was left out: `faces` and `corners` are empty
    Array<uint32_t> faces, corners;                         ///< old index of each that remained
    Array<uint32_t> take(Array<uint32_t> perCorner) const;  ///< values of the corners that remained
};

/// Leaves out faces with an index that is not below `vertexCount`, or at a vertex of `broken` (ascending). `leftOut(face, corner)` is told each, with
/// its first such corner. `start` has one entry more than there are faces.
CheckedFaces checkedFaces(Array<uint32_t> start, Array<uint32_t> cornerVertex, size_t vertexCount, const std::vector<uint32_t>& broken,
                          const std::function<void(uint32_t face, uint32_t corner)>& leftOut);

/// A text for people: "vertex 99 of 4" with `first` the index of the first vertex in the file's counting.
std::string vertexPlace(int64_t index, size_t count);

}  // namespace mw
