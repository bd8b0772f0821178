// The last step of the mesh readers: what a file says about vertices and faces is brought into the form that Mesh promises.
#pragma once
#include <functional>

#include "core/io/findings.h"
#include "core/mesh/mesh.h"

namespace mw {

/// What the readers of meshes find odd.
namespace found {
inline constexpr Finding position{"nan-position", "vertex has no finite position: put at the centre, faces at it are left out",
                                  "vertices have no finite position: put at the centre, faces at them are left out"};
inline constexpr Finding brokenFace{"nan-face", "face uses a vertex without a finite position: left out",
                                    "faces use vertices without a finite position: left out"};
inline constexpr Finding faceIndex{"face-index", "face uses a vertex that is not there: left out", "faces use vertices that are not there: left out"};
inline constexpr Finding smallFace{"small-face", "face has fewer than three corners: kept as degenerate",
                                   "faces have fewer than three corners: kept as degenerate"};
inline constexpr Finding value{"nan-value", "colour, normal or texture coordinate is not finite: set to 0",
                               "colours, normals or texture coordinates are not finite: set to 0"};
}  // namespace found

/// From which number on a file counts its vertices and faces.
enum class CountsFrom : uint8_t { Zero, One };

/// Puts each position that is not finite at the centre of the others' box, so that indices and bounds stay, and lists it.
std::vector<uint32_t> mendPositions(Array<glm::vec3>& positions);
/// The same, told as found::position. Throws Error, naming `file`, when no position is finite.
std::vector<uint32_t> mendPositions(Array<glm::vec3>& positions, CountsFrom from, const std::string& file, Findings& findings);

/// The faces of a file and which of them remain.
struct CheckedFaces {
    Array<uint32_t> faceStart, cornerVertex;
    bool all = true;                                        ///< nothing was left out: `faces` and `corners` are empty
    Array<uint32_t> faces, corners;                         ///< old index of each that remained
    Array<uint32_t> take(Array<uint32_t> perCorner) const;  ///< values of the corners that remained
};

/// Leaves out faces with an index that is not below `vertexCount`, or at a vertex of `broken` (ascending). `leftOut(face, vertex)` is told each, with
/// its first such index. `start` has one entry more than there are faces.
CheckedFaces checkedFaces(Array<uint32_t> start, Array<uint32_t> cornerVertex, size_t vertexCount, const std::vector<uint32_t>& broken,
                          const std::function<void(uint32_t face, uint32_t vertex)>& leftOut);
/// The same, told as found::faceIndex and found::brokenFace, and small faces as found::smallFace. `place(face, vertex)` gives the text of a place;
/// `vertex` is `none` when only the face matters.
CheckedFaces checkedFaces(Array<uint32_t> start, Array<uint32_t> cornerVertex, size_t vertexCount, const std::vector<uint32_t>& broken,
                          Findings& findings, const std::function<std::string(uint32_t face, uint32_t vertex)>& place);
/// Of pairs of vertices those that are there and not of `broken`. `leftOut(pair)` is told each of the others.
Array<uint32_t> checkedLines(const Array<uint32_t>& pairs, size_t vertexCount, const std::vector<uint32_t>& broken,
                             const std::function<void(size_t pair)>& leftOut);

/// A text for people: "vertex 99 of 4", "vertex 99 of 4, counted from 0". `number` is in the file's counting.
std::string vertexPlace(int64_t number, size_t count, CountsFrom from);
/// "face 3 of the file", "face 2, counted from 0".
std::string facePlace(uint32_t face, CountsFrom from);

}  // namespace mw
