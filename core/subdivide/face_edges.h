// The edges of any faces, found once; and what sharp edges do to subdivision, the same for every scheme.
#pragma once
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "core/mesh/mesh.h"

namespace mw {

/// An edge that is a crease for as many levels as its sharpness says; the last part of a level counts partly.
struct SharpEdge {
    uint32_t edge;
    float sharpness;
};
inline constexpr float alwaysSharp = std::numeric_limits<float>::infinity();

/// A vertex on a crease or at a corner goes the share `share` of the way from its smooth place to (1 - 2 side) v + side (a + b).
struct SharpVertex {
    uint32_t vertex, a, b;
    float share, side;
};

struct Ends {
    uint32_t a, b;
};

/// Corner c has the half-edge half[c] = 2e + s of edge e, s = 0 where the corner runs in the edge's own direction a to b. Edges with more than two
/// faces have several corners with the same half-edge.
struct FaceEdges {
    Array<uint32_t> half;
    Array<Ends> ends;
    Array<Ends> corner;                      ///< a: that runs a to b, b: one that runs b to a; the same where there is none
    std::vector<SharpEdge> sharp;            ///< ascending
    std::vector<uint32_t> valence, facesAt;  ///< of each vertex: edges, corners

    size_t size() const { return ends.size(); }
};

/// Sharp are edges of one face or more than two, of two faces that run the same way, and those with `crease` (by corner, or empty) above 0. One
/// that is `lasting` or more never fades.
FaceEdges faceEdgesOf(const Mesh& mesh, std::span<const float> crease, float lasting);

/// What is left after a level: both halves of every edge whose sharpness is more than 1, less 1.
std::vector<SharpEdge> faded(const std::vector<SharpEdge>& sharp);

/// The rules for the ends of sharp edges: two make a crease, more a corner, one (a dart) nothing. Where fading changes the rule, both are mixed.
/// `fixed` vertices stay whatever their edges say. Ascending.
std::vector<SharpVertex> sharpVerticesOf(const std::vector<SharpEdge>& sharp, const std::vector<Ends>& ends, const std::vector<uint32_t>& fixed);

/// Of some edges by number.
template <class Edges>
std::vector<Ends> endsOf(const std::vector<SharpEdge>& sharp, const Edges& edges)
{
    std::vector<Ends> out;
    out.reserve(sharp.size());
    for (const SharpEdge& s : sharp) out.push_back({edges[s.edge].a, edges[s.edge].b});
    return out;
}

/// Mixes smooth places with what creases ask for.
inline void applySharp(const SharpVertex& s, const Array<glm::vec3>& old, glm::vec3& p)
{
    const double side = double(s.side), share = double(s.share);
    const glm::dvec3 rule = (1 - 2 * side) * glm::dvec3(old[s.vertex]) + side * (glm::dvec3(old[s.a]) + glm::dvec3(old[s.b]));
    p = glm::vec3(share >= 1 ? rule : (1 - share) * glm::dvec3(p) + share * rule);
}
inline void applySharp(float sharpness, Ends e, const Array<glm::vec3>& old, glm::vec3& p)
{
    const double share = sharpness >= 1 ? 1 : double(sharpness);
    const glm::dvec3 rule = 0.5 * (glm::dvec3(old[e.a]) + glm::dvec3(old[e.b]));
    p = glm::vec3(share >= 1 ? rule : (1 - share) * glm::dvec3(p) + share * rule);
}

}  // namespace mw
