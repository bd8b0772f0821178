// The value of a heat map at a place of the surface: mixed within a face where it is of vertices, of the face, or of its nearest edge.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/renderer.h"

namespace mw {

struct ProbedValue {
    double value = 0;  ///< NaN where it is undefined
    std::string name, unit;
};
/// `weights` at the corners of a triangle of `face`, as places of the mesh. Nothing without a heat map that fits.
std::optional<ProbedValue> probed(const DrawObject& o, uint32_t face, const glm::uvec3& corners, const glm::dvec3& weights);

/// A number of the mesh's own at such a place, mixed: "color", "texcoord", ... of vertices or corners. Empty when the mesh has none.
std::vector<double> mixed(const Mesh& mesh, std::string_view attribute, const glm::uvec3& vertices, const glm::uvec3& corners,
                          const glm::dvec3& weights);

/// A triangle of a face: its vertices and corners, and the weights of a place in it.
struct TrianglePlace {
    glm::uvec3 vertices{none, none, none}, corners{none, none, none};
    glm::dvec3 weights{0};
};
/// The one that holds a world place best; nothing for a face without triangles that have an area.
std::optional<TrianglePlace> triangleAt(const DrawObject& o, uint32_t face, const glm::dvec3& world);
/// Places of the mesh as they are drawn: posed, in the world.
class WorldPlaces {
public:
    explicit WorldPlaces(const DrawObject& o);
    glm::dvec3 operator[](uint32_t v) const { return glm::dvec3(worldFromLocal_ * glm::dvec4(glm::dvec3(places_[v]), 1)); }

private:
    glm::dmat4 worldFromLocal_;
    Shared<glm::vec3> places_;
};

}  // namespace mw
