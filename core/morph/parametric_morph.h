// Morphs between shapes given by two parameters each: cylinder to torus, sphere to torus. Book 3.4, (3.57) to (3.62).
#pragma once
#include "core/mesh/mesh.h"
#include "core/morph/morph.h"

namespace mw {

/// A torus about +Y, its centre at the origin.
struct TorusShape {
    double radius = 1, tube = 0.35;
    /// (3.58): omega about the axis from +Z to +X, phi about the tube from its outside upwards; radians.
    glm::dvec3 at(double omega, double phi) const;
};

/// The torus that all vertices lie on; throws Error when they lie on none.
TorusShape torusThrough(const Mesh& mesh);

/// The mesh cut open where a pole of the +Y axis lies: at a vertex, inside an edge or a face. Each face there gets a vertex a spoke instead of the
/// pole, all at the same place. `pole` tells for each vertex which one it stands for: 0 none, 1 north, -1 south; `toward` the vertex whose longitude
/// it has.
struct CutSphere {
    Mesh mesh;
    std::vector<int8_t> pole;
    std::vector<uint32_t> toward;
};
CutSphere cutAtPoles(const Mesh& mesh);
/// Without the faces that lie wholly in the upper or lower end.
Mesh withoutCaps(const Mesh& mesh);

Generator cylinderTorus(Mesh input, Morph parameters, Stage<Mesh>& stage);
Generator sphereTorus(Mesh input, Morph parameters, Stage<Mesh>& stage);

}  // namespace mw
