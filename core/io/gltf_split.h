// Corners to points: glTF has one index for all data of a point, so a vertex whose corners differ becomes several points.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"

namespace mw {

/// An attribute on its way out, as finite floats.
struct GltfSource {
    std::string semantic;
    Domain domain = Domain::Vertex;
    int components = 1;
    std::span<const float> values;
    Array<float> owned;  ///< what `values` looks at when the attribute is not of floats
    Scalar stored = Scalar::Float32;
};

/// Points of one primitive, ascending by vertex, and the points in the order of drawing.
struct GltfSplit {
    Array<uint32_t> vertex, corner;  ///< of each point; corner is `none` where there is no face
    Array<uint32_t> sequence;
};

/// Splits the corners named (with the vertex of each) wherever a source of the corner domain differs.
class GltfSplitter {
public:
    GltfSplitter(const Mesh& mesh, const std::vector<GltfSource>& sources);
    GltfSplit split(std::span<const uint32_t> vertices, std::span<const uint32_t> corners);

private:
    void byVertex(GltfSplit& s, std::span<const uint32_t> vertices, std::span<const uint32_t> corners);
    void byContent(GltfSplit& s, std::span<const uint32_t> vertices, std::span<const uint32_t> corners);
    std::vector<const GltfSource*> atCorners_;
    Array<uint32_t> pointOf_;
};

}  // namespace mw
