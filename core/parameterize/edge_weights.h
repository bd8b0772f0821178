// Spring constants of edges: how strongly a vertex is drawn to each neighbour when a mesh is laid out. Book 3.3.2, box 3.1.
#pragma once
#include "core/mesh/mesh.h"

namespace mw {

enum class EdgeWeights { Uniform, Wachspress, Harmonic, MeanValue };

/// K_ij beside rings().neighbour of a mesh of triangles: for edge ij of length r with the far corners k and l of its two triangles
///   Uniform     1 (Tutte 1963)
///   Wachspress  (cot ijk + cot ijl) / r^2, angles at j (Wachspress 1975)
///   Harmonic    cot ikj + cot ilj, angles at k and l (Pinkall and Polthier 1993)
///   MeanValue   (tan jik/2 + tan jil/2) / r, angles at i (Floater 2003)
/// Uniform and mean value are above 0; the others are below 0 across obtuse angles. Only the harmonic one has K_ij = K_ji besides the uniform. All
/// but the uniform reproduce a planar ring: sum over j of K_ij (P_i - P_j) = 0. Angles nearer to 0 or 180 degrees than a millionth are taken for
/// that. O(n).
Array<double> edgeWeights(const Mesh& triangles, EdgeWeights kind);

/// True when K_ij = K_ji.
inline bool symmetric(EdgeWeights kind)
{
    return kind == EdgeWeights::Uniform || kind == EdgeWeights::Harmonic;
}
/// True when K_ij may be below 0, so that faces may fold over.
inline bool mayBeNegative(EdgeWeights kind)
{
    return kind == EdgeWeights::Wachspress || kind == EdgeWeights::Harmonic;
}

}  // namespace mw
