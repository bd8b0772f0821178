// The list of operations, in menu order: one entry each.
#include "core/catalog/entries.h"
#include "core/character/ccd.h"
#include "core/character/fabrik.h"
#include "core/character/interpolate_rotation.h"
#include "core/character/joint_chain.h"
#include "core/mesh/primitives.h"
#include "core/mesh/sample_curve.h"
#include "core/mesh/stripify.h"
#include "core/metrics/valence.h"
#include "core/repair/smooth.h"
#include "core/repair/weld.h"
#include "core/simplify/decimate_quadric.h"
#include "core/subdivide/subdivide_curve.h"
#include "core/subdivide/subdivide_loop.h"
#include "core/terrain/diamond_square.h"
#include "core/terrain/perlin.h"
#include "core/terrain/sinusoids.h"

namespace mw {

std::span<const Operation> catalog()
{
    static const std::vector<Operation> operations = {
        entry<Icosphere, Mesh>({.id = "icosphere",
                                .title = "Icosphere",
                                .section = "2.3",
                                .summary = "A sphere of nearly equal triangles, from the icosahedron.",
                                .category = "Primitives",
                                .source = "core/mesh/primitives.cpp"},
                               icosphere),
        entry<Mesh, DecimateQuadric, Mesh>({.id = "decimate-quadric",
                                            .title = "Simplify by quadrics",
                                            .section = "3.1",
                                            .summary = "Collapses the edges that matter least, each to the point nearest to the planes around it.",
                                            .category = "Simplify",
                                            .steps = true,
                                            .attributes = {Carried::Surface, Carried::Surface, Carried::Gathered},
                                            .source = "core/simplify/decimate_quadric.cpp"},
                                           decimateQuadric),
        entry<Mesh, SubdivideLoop, Mesh>({.id = "subdivide-loop",
                                          .title = "Loop subdivision",
                                          .section = "3.2",
                                          .summary = "Every triangle becomes four, and the surface smooth.",
                                          .category = "Subdivide",
                                          .steps = true,
                                          .attributes = {Carried::Stencil, Carried::Surface, Carried::Gathered},
                                          .source = "core/subdivide/subdivide_loop.cpp"},
                                         subdivideLoop),
        entry<Mesh, Weld, Mesh>({.id = "weld",
                                 .title = "Weld vertices",
                                 .summary = "Vertices at the same place, or near it, become one.",
                                 .category = "Repair",
                                 .attributes = {Carried::Gathered, Carried::Same, Carried::Same},
                                 .source = "core/repair/weld.cpp"},
                                weld),
        entry<Mesh, VertexValence, Table>({.id = "vertex-valence",
                                           .title = "Valence of vertices",
                                           .section = "2.3",
                                           .summary = "How many edges meet at each vertex.",
                                           .category = "Query",
                                           .source = "core/metrics/valence.cpp"},
                                          vertexValence),
        entry<Mesh, Stripify, Table>({.id = "stripify",
                                      .title = "Triangle strips",
                                      .section = "2.1",
                                      .summary = "Puts all triangles into few long strips and tells how many indices that saves.",
                                      .category = "Query",
                                      .steps = true,
                                      .source = "core/mesh/stripify.cpp"},
                                     stripify),
        entry({.id = "smooth",
               .title = "Smooth",
               .section = "",
               .summary = "Moves every vertex towards the mean of its ring, keeping the size of the shape (Taubin) or not (Laplacian).",
               .category = "Smooth",
               .steps = true,
               .attributes = {Carried::Same, Carried::Same, Carried::Same},
               .source = "core/repair/smooth.cpp"},
              smooth),
        entry({.id = "diamond-square",
               .title = "Diamond-square",
               .section = "5.3",
               .summary = "A landscape by displacing the middles of squares and of their sides, each round half as far.",
               .category = "Terrain",
               .steps = true,
               .source = "core/terrain/diamond_square.cpp"},
              diamondSquare),
        entry({.id = "perlin",
               .title = "Perlin noise",
               .section = "5.3",
               .summary = "Hills of several sizes: random vectors at growing density, interpolated and added.",
               .category = "Terrain",
               .steps = true,
               .source = "core/terrain/perlin.cpp"},
              perlin),
        entry({.id = "sinusoids",
               .title = "Sum of sine waves",
               .section = "5.3",
               .summary = "Even hills: sine waves of doubled frequency and halved height, added along both axes.",
               .category = "Terrain",
               .source = "core/terrain/sinusoids.cpp"},
              sinusoids),
        entry<SampleCurve, Curve>({.id = "sample-curve",
                                   .title = "Sample curve",
                                   .section = "3.2",
                                   .summary = "A polygon to begin a curve with: a shape, or points given one by one.",
                                   .category = "Curve",
                                   .source = "core/mesh/sample_curve.cpp"},
                                  sampleCurve),
        entry<Curve, SubdivideCurve, Curve>({.id = "subdivide-curve",
                                             .title = "Subdivide curve",
                                             .section = "3.2",
                                             .summary = "Every segment becomes two, and the polygon a curve through its points or near them.",
                                             .category = "Curve",
                                             .steps = true,
                                             .source = "core/subdivide/subdivide_curve.cpp"},
                                            subdivideCurve),
        entry<InterpolateRotation, Rotations>({.id = "interpolate-rotation",
                                               .title = "Interpolate rotations",
                                               .section = "6.5",
                                               .summary = "The ways from one orientation to another: by Euler angles, NLERP and SLERP.",
                                               .category = "Rotation",
                                               .steps = true,
                                               .source = "core/character/interpolate_rotation.cpp"},
                                              interpolateRotation),
        entry<JointChain, Pose>({.id = "joint-chain",
                                 .title = "Joint chain",
                                 .section = "8.1",
                                 .summary = "A chain of links in the plane, with a target for its end.",
                                 .category = "Character",
                                 .source = "core/character/joint_chain.cpp"},
                                jointChain),
        entry<Pose, Ccd, Pose>(
            {.id = "ccd",
             .title = "CCD",
             .section = "8.2.1",
             .summary = "Turns one joint after the other so that the end of a chain comes to a target (cyclic coordinate descent).",
             .category = "Character",
             .steps = true,
             .source = "core/character/ccd.cpp"},
            ccd),
        entry<Pose, Fabrik, Pose>(
            {.id = "fabrik",
             .title = "FABRIK",
             .section = "8.2.3",
             .summary = "Draws the joints of a chain along lines, from the target to the root and back, until its end is there.",
             .category = "Character",
             .steps = true,
             .source = "core/character/fabrik.cpp"},
            fabrik),
    };
    return operations;
}

}  // namespace mw
