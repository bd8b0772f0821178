// Collects polygons with a texture coordinate a corner; for code that makes meshes.
#pragma once
#include <glm/vec2.hpp>

#include "core/mesh/mesh.h"

namespace mw {

struct Polygons {
    Array<glm::vec3> positions;
    Array<uint32_t> faceStart{0u}, corners;
    Array<float> texcoords;

    void corner(uint32_t vertex, glm::dvec2 texcoord)
    {
        corners.push_back(vertex);
        texcoords.push_back(float(texcoord.x));
        texcoords.push_back(float(texcoord.y));
    }
    void endFace() { faceStart.push_back(uint32_t(corners.size())); }
    /// Takes what was collected.
    Mesh mesh()
    {
        const Mesh m(std::move(positions), std::move(faceStart), std::move(corners));
        return m.with(floatAttribute(std::string(names::texcoord), Domain::Corner, 2, std::move(texcoords)));
    }
};

}  // namespace mw
