// How attributes get onto the faces that a subdivision makes.
#pragma once
#include <functional>

#include "core/mesh/mesh.h"

namespace mw {

/// Faces that are cut: triangles into three at their corners and one in the middle, or into quads around their centre as all others are.
struct FaceCut {
    std::span<const uint32_t> faceStart = {};  ///< empty: every face has `size` corners
    size_t faces = 0;
    uint32_t size = 3;
    bool fourTriangles = true;

    uint32_t first(size_t f) const { return faceStart.empty() ? uint32_t(f) * size : faceStart[f]; }
    bool intoTriangles(uint32_t corners) const { return fourTriangles && corners == 3; }
    /// Old corners, new faces, new corners.
    size_t corners() const { return first(faces); }
    size_t newFaces() const;
    size_t newCorners() const;
};

/// Linear within each face: its own corners decide, so that seams stay.
Attribute cutCorners(const Attribute& a, const FaceCut& cut);
/// Sharpness goes to both halves of a side: all of it, or what is 1 or more, or 1 less. What lies inside a face is smooth.
enum class Creases { Kept, Lasting, Fading };
Attribute cutCrease(const Attribute& crease, const FaceCut& cut, Creases creases);
/// Sharpness of the side of each corner; empty when there is no such attribute.
Array<float> creaseOf(const Mesh& mesh);
/// The old face of each new one.
Array<uint32_t> cutFaces(const FaceCut& cut);

/// What an operation knows of its new elements; each is asked only when there is such an attribute.
struct Origins {
    std::function<Stencils()> vertexRows;
    std::function<Attribute(const Attribute&)> corner, crease;
    std::function<Array<uint32_t>()> faces;
};
std::vector<Attribute> carried(const std::vector<Attribute>& old, const Origins& origins);
Mesh withAttributes(Mesh mesh, const std::vector<Attribute>& attributes);

/// Throws Error when `faces` are more than 100 million.
void checkResultSize(double faces, const std::string& parameter);

/// The input with its faces of more than `most` corners cut into triangles, attributes on them. What that adds is no crease. Faces of fewer than
/// three corners are left out.
Mesh polygonsCut(const Mesh& input, size_t most);
Mesh asTriangles(const Mesh& input);
/// The input without faces of fewer than three corners.
Mesh withoutTinyFaces(const Mesh& input);

}  // namespace mw
