// A closed mesh without holes laid out on the unit sphere. Book 3.3.3.
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/parameterize/edge_weights.h"
#include "core/steps/stage.h"

namespace mw {

struct EmbedSpherical {
    enum class Start { Hierarchy, Projection };
    enum class Output { Texture, Sphere };

    EdgeWeights weights = EdgeWeights::Uniform;
    Start start = Start::Hierarchy;
    int64_t iterations = 50;
    double tolerance = 1e-4;
    Output output = Output::Texture;

    template <class V>
    void describe(V& v)
    {
        v.choice("weights", weights, {"uniform", "wachspress", "harmonic", "mean-value"},
                 {.title = "Weights", .help = "Strength of the spring along each edge while the vertices are relaxed."});
        v.choice(
            "start", start, {"hierarchy", "projection"},
            {.title = "Start",
             .help =
                 "Hierarchy: a coarse mesh on the sphere to which all vertices come back; nothing folds over. Projection: every vertex straight from "
                 "the centre, as in the book; shapes with arms fold over and may stay so."});
        v.integer("iterations", iterations,
                  {.title = "Rounds", .help = "How often every vertex is relaxed at most.", .min = 0, .max = 1000000, .softMax = 500});
        v.number("tolerance", tolerance,
                 {.title = "Tolerance",
                  .help = "Ends when no vertex moves farther in a round; the sphere has radius 1.",
                  .min = 1e-14,
                  .max = 1,
                  .softMin = 1e-9,
                  .softMax = 0.01,
                  .logarithmic = true});
        v.choice("output", output, {"texture", "sphere"},
                 {.title = "Result", .help = "Texture coordinates from longitude and latitude, or the mesh itself as a sphere of its own area."});
    }
};

/// Every vertex moves to the weighted mean of its ring and back out to the sphere (3.49), then all so that their mean is the centre (3.50), round
/// by round. From the hierarchy (sphere_hierarchy.h) no step may turn a face over, or make one smaller than a ten thousandth of the mean; from the
/// projection the steps are the book's as they stand. Texture: "texcoord" is (alpha / 2 pi, delta / pi + 1/2); corners of a face on the seam go
/// beyond 1 together, a corner at a pole has the mean of the others. Sphere: positions, too, normals and tangents dropped. Faces turned over have 1
/// in the face attribute "folded", which is dropped when there are none. Throws Error when the mesh is not closed, of one piece and genus 0.
Generator embedSpherical(Mesh input, EmbedSpherical parameters, Stage<Mesh>& stage);

/// Places on the unit sphere of all vertices of a closed, oriented manifold of genus 0 in one piece (else Error), without fold-overs: for every
/// triangle of mesh.triangulation() P_a . (P_b x P_c) > 0. Vertices of no face are at 0. About a second for 50,000 vertices at 50 rounds.
std::vector<glm::dvec3> sphericalEmbedding(const Mesh& mesh, EdgeWeights weights = EdgeWeights::Uniform, int64_t rounds = 50);
/// The same in parts, for callers that show progress and hear cancels; weights, start, rounds and tolerance of `how`. `places` is set at the end.
Generator sphericalEmbedding(Mesh mesh, EmbedSpherical how, std::vector<glm::dvec3>& places);

/// Longitude (from +Z towards +X, 0 to 2 pi) and latitude (-pi/2 to pi/2) of a direction. (3.48)
glm::dvec2 sphericalCoordinates(const glm::dvec3& direction);

/// Triangles of mesh.triangulation() with P_a . (P_b x P_c) <= 0, as faces, each once.
std::vector<uint32_t> foldedFaces(const Mesh& mesh, std::span<const glm::dvec3> places);

}  // namespace mw
