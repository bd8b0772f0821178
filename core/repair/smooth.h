// Smoothing: every vertex moves towards the mean of its ring.
#pragma once
#include "core/mesh/mesh.h"
#include "core/steps/stage.h"

namespace mw {

/// Laplacian smoothing (the umbrella operator, Kobbelt et al. 1998) and Taubin's lambda-mu smoothing (Taubin 1995, "A signal processing
/// approach to fair surface design"), which puts a step of negative size behind each positive one so that the shape does not shrink.
/// All vertices of a round move at once, from the places of the round before. Any mesh; vertices without an edge stay. Topology, texture coordinates,
/// colours and all other attributes stay as they are, stored normals and tangents are dropped (they no longer fit). O(iterations * edges).
struct Smooth {
    enum class Method { Laplacian, Taubin };
    enum class Weights { Uniform, Cotangent };

    Method method = Method::Taubin;
    Weights weights = Weights::Uniform;
    int64_t iterations = 10;
    double lambda = 0.5;
    double passBand = 0.1;
    bool fixBoundary = true;

    template <class V>
    void describe(V& v)
    {
        v.choice("method", method, {"laplacian", "taubin"},
                 {.title = "Method", .help = "Laplacian shrinks the shape; Taubin keeps its size by inflating it after each round."});
        v.choice("weights", weights, {"uniform", "cotangent"},
                 {.title = "Weights", .help = "Uniform evens out the mesh as well; cotangent follows the shape and leaves the sampling alone."});
        v.integer("iterations", iterations, {.title = "Iterations", .help = "How often every vertex moves.", .min = 1, .max = 10000, .softMax = 100});
        v.number("lambda", lambda, {.title = "Step", .help = "Share of the way to the mean of the ring, in each round.", .min = 0, .max = 1});
        v.number("pass-band", passBand,
                 {.title = "Pass band",
                  .help = "Taubin: frequencies below it are kept; 1/lambda + 1/mu.",
                  .min = 0.001,
                  .max = 1,
                  .when = "method=taubin"});
        v.flag("fix-boundary", fixBoundary, {.title = "Fix boundary", .help = "Vertices on a boundary or non-manifold edge do not move."});
    }
};

Generator smooth(Mesh input, Smooth parameters, Stage<Mesh>& stage);

}  // namespace mw
