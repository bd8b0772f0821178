// A disk laid out in the plane: its border on a convex outline, every inner vertex the weighted mean of its ring. Book 3.3.2.
#pragma once
#include <glm/vec2.hpp>

#include "core/parameterize/disk.h"
#include "core/parameterize/edge_weights.h"
#include "core/steps/stage.h"

namespace mw {

struct EmbedPlanar {
    enum class Solver { Direct, Jacobi, GaussSeidel };
    enum class Output { Texture, Flat };

    EdgeWeights weights = EdgeWeights::Uniform;
    PlanarOutline boundary = PlanarOutline::Circle;
    Solver solver = Solver::Direct;
    double tolerance = 1e-6;
    int64_t iterations = 10000;
    Output output = Output::Texture;

    template <class V>
    void describe(V& v)
    {
        v.choice(
            "weights", weights, {"uniform", "wachspress", "harmonic", "mean-value"},
            {.title = "Weights",
             .help = "Strength of the spring along each edge. Uniform and mean value never fold; harmonic keeps angles best; Wachspress and harmonic "
                     "may fold over next to obtuse angles."});
        v.choice(
            "boundary", boundary, {"circle", "square", "chord"},
            {.title = "Boundary",
             .help = "Where the border is pinned: on a circle in equal steps, on a square, or on a circle in steps by the length of the edges."});
        v.choice("solver", solver, {"direct", "jacobi", "gauss-seidel"},
                 {.title = "Solver",
                  .help = "Direct gives the exact solution at once; the others move all vertices to the mean of their rings again and "
                          "again."});
        v.number("tolerance", tolerance,
                 {.title = "Tolerance",
                  .help = "Jacobi and Gauss-Seidel end when no vertex moves farther in a sweep; the outline has radius 1.",
                  .min = 1e-14,
                  .max = 1,
                  .softMin = 1e-9,
                  .softMax = 0.01,
                  .logarithmic = true,
                  .when = "solver=jacobi|gauss-seidel"});
        v.integer("iterations", iterations,
                  {.title = "Sweeps at most",
                   .help = "Jacobi and Gauss-Seidel end after as many sweeps, come what may.",
                   .min = 1,
                   .max = 10000000,
                   .softMax = 100000,
                   .when = "solver=jacobi|gauss-seidel"});
        v.choice("output", output, {"texture", "flat"},
                 {.title = "Result", .help = "Texture coordinates from 0 to 1, or the mesh itself spread in the plane at its own area."});
    }
};

/// Faces stay as they are; polygons are cut for the weights only. Texture: the corner attribute "texcoord" is replaced, the rest stays. Flat:
/// positions too, in the plane Z = 0 of the box's centre, stored normals and tangents dropped. When faces are folded over (possible with
/// Wachspress and harmonic weights) the face attribute "folded" is 1 at them; it is dropped when there are none. Throws Error when the mesh is no
/// disk. The direct solution takes O(n^1.5) operations, a sweep of the others O(n), of which they need a number that grows with n.
Generator embedPlanar(Mesh input, EmbedPlanar parameters, Stage<Mesh>& stage);

/// Places of all vertices of a disk by the direct solver, the border (Disk::border) at `outline`, which must go round a convex outline
/// anticlockwise; vertices of no face at 0. The residual of (3.41) is below 1e-9 of the outline's size, else Error. No attributes are looked at.
std::vector<glm::dvec2> planarEmbedding(const Disk& disk, EdgeWeights weights, std::span<const glm::dvec2> outline);
/// The same for a mesh, on the outline of that kind. Throws Error when the mesh is no disk.
std::vector<glm::dvec2> planarEmbedding(const Mesh& mesh, EdgeWeights weights = EdgeWeights::Uniform, PlanarOutline outline = PlanarOutline::Circle);

/// Faces that are turned over or without area in the plane, polygons when one of their triangles is. `places` of all vertices.
std::vector<uint32_t> foldedFaces(const Mesh& mesh, std::span<const glm::dvec2> places);

}  // namespace mw
