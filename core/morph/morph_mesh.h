// A mesh made ready to be overlaid: triangles without loose vertices, and where each of its elements comes from.
#pragma once
#include <optional>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/morph/overlay.h"

namespace mw {

struct MorphMesh {
    /// An old element or, with t > 0, a point between two.
    struct Mix {
        uint32_t a = none, b = none;
        double t = 0;
    };
    Mesh source;
    std::vector<glm::dvec3> positions;
    std::vector<uint32_t> corners;        ///< three a triangle
    std::vector<Mix> vertexOf, cornerOf;  ///< vertices and corners of the source
    std::vector<uint32_t> faceOf;

    /// Polygons cut, faces that name a vertex twice left out.
    static MorphMesh of(const Mesh& mesh);
    size_t triangles() const { return corners.size() / 3; }
    Mesh mesh() const;
};

/// A vertex attribute of either mesh at the vertices of the overlay; precondition: its source has it.
Attribute carriedVertexAttribute(const Overlay& overlay, int in, const MorphMesh& mesh, std::string_view name);
/// The overlay as a mesh: places of the first, attributes of its source.
Mesh overlaid(const Overlay& overlay, const MorphMesh& first);
/// From there to the places of the second, three numbers a vertex.
Array<float> displacement(const Overlay& overlay);
/// The colours of mesh `in` on the overlay, by vertex or corner; null when its source has none.
std::optional<Attribute> colorOn(const Overlay& overlay, int in, const MorphMesh& mesh);
/// Both, the second as the target `name`.
Mesh morphed(const Overlay& overlay, const MorphMesh& first, const std::string& name);

}  // namespace mw
