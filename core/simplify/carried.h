// What a simplified mesh carries over from the mesh it was made of, whichever method collapsed the edges: where values part (seams), and every
// attribute read off the old surface.
#pragma once
#include <glm/vec3.hpp>
#include <vector>

#include "core/mesh/mesh.h"

namespace mw {

/// The triangles of a mesh as read. Corner c = 3t + k of a triangle is corner `corner(c)` of the mesh, triangle t was cut from face `face(t)`.
struct OldTriangles {
    Shared<uint32_t> vertices, corners, faces;  ///< the latter two empty when the mesh is triangles

    OldTriangles() = default;
    explicit OldTriangles(const Mesh& mesh);
    size_t size() const { return vertices.size() / 3; }
    uint32_t corner(uint32_t c) const { return corners.empty() ? c : corners[c]; }
    uint32_t face(uint32_t t) const { return faces.empty() ? t : faces[t]; }
    static uint32_t next(uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; }
};

/// Edges along which corner values, materials, groups part, or that are creased: they stay curves. Keep mesh and triangles alive.
class SeamTest {
public:
    SeamTest(const Mesh& mesh, const OldTriangles& triangles);

    /// False when no edge can part.
    bool any() const { return !cornerValues_.empty() || !faceValues_.empty() || crease_; }
    /// Corners carry values beside creases.
    bool cornersCarry() const { return cornersCarry_; }
    bool creases() const { return crease_ != nullptr; }
    /// Of the edge from corner c to the next one and, in the triangle beyond, from d to the next one.
    bool parts(uint32_t c, uint32_t d) const;
    /// Of the side that leaves corner c; sides made by cutting polygons have none.
    float crease(uint32_t c) const;

private:
    struct Values {
        const Attribute* attribute;
        const float* floats;
        size_t components;
        bool normal;
    };
    bool differ(const Values& v, uint32_t a, uint32_t b) const;

    const Mesh* mesh_;
    const OldTriangles* triangles_;
    std::vector<Values> cornerValues_;
    std::vector<const Attribute*> faceValues_;
    const Attribute* crease_ = nullptr;
    bool cornersCarry_ = false;
};

/// What edge collapses made of a mesh. Vertices and triangles are named as in the old one.
struct Collapsed {
    std::vector<uint32_t> into;       ///< by vertex: the one it went into at last, itself while it is there
    std::vector<uint32_t> triangles;  ///< those that are left, ascending
    std::vector<uint32_t> corners;    ///< their vertices, three each
    Array<glm::vec3> positions;       ///< of the vertices that are there, in their order
    Array<float> creases;             ///< beside `corners`; empty when there are none
    /// By old corner: a number for corners that share their values; `none` where all corners of a vertex do. Empty: so everywhere.
    std::vector<uint32_t> wedge;
    uint32_t wedges = 0;  ///< how many numbers
};

/// The payload, with all that the old mesh has.
Mesh carried(const Mesh& mesh, const OldTriangles& triangles, Collapsed collapsed);

}  // namespace mw
