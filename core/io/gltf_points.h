// What the primitives of a glTF mesh have in common before they become a Mesh: "points" (the vertices of glTF) one after the other, with
// their data in streams as long as there are points.
#pragma once
#include <algorithm>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/io/gltf_document.h"
#include "core/mesh/mesh.h"

namespace mw {

/// Data of every point; points of primitives that do not have it get `fill`.
struct GltfStream {
    std::string name;
    int components = 1;
    bool ofVertex = false;  ///< points that differ in it are different vertices; else it goes to corners
    bool integral = false;
    Scalar stored = Scalar::Float32;
    float fill = 0;
    Array<float> floats;
    Array<int32_t> integers;

    size_t points() const { return (integral ? integers.size() : floats.size()) / size_t(components); }
};

struct GltfPoints {
    Array<glm::vec3> positions;
    std::vector<GltfStream> streams;
    Array<uint32_t> corners, faceMaterial, lines;      ///< three points a triangle; slot a triangle; two points a line
    std::vector<std::pair<uint32_t, uint32_t>> apart;  ///< ranges of points that were drawn as points: never welded
};

/// For each point its vertex; `representative` gets the first point of each vertex. Equal position and equal vertex streams make one
/// vertex of several points; only faces weld, so without any each point stays.
Array<uint32_t> weldedPoints(const GltfPoints& points, Array<uint32_t>& representative);
/// The mesh of them.
Mesh meshOf(GltfPoints points, GltfDocument& document, const std::string& pointer);

}  // namespace mw
