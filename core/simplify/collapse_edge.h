// One edge collapsed: whether it may be, and why not. Book 3.1.3, Fig. 3.7 and 3.8. The tests are those of simplification (collapse_mesh.h).
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "core/mesh/mesh.h"
#include "core/simplify/collapse_mesh.h"
#include "core/steps/stage.h"

namespace mw {

enum class CollapsePlace { Optimal, Middle, First, Second };

/// Edges of one mesh, asked as often as wanted: while a pointer moves over it. Polygons are taken as their triangles.
class EdgeCollapser {
public:
    struct Judgement {
        uint32_t half = none;  ///< of the edge, from its first vertex if it is there; none: there is no such edge
        glm::dvec3 place{0};   ///< scaled, as CollapseMesh has it
        Verdict verdict;
        bool legal() const { return half != none && verdict.refusal == Refusal::None; }
    };

    explicit EdgeCollapser(Mesh mesh);
    Judgement judge(uint32_t a, uint32_t b, CollapsePlace place);
    /// The mesh after it. Only of what is legal; the collapser is used up.
    Mesh collapsed(const Judgement& j);
    CollapseMesh& mesh() { return mesh_; }

private:
    uint32_t halfEdge(uint32_t a, uint32_t b) const;
    glm::dvec3 placeOf(uint32_t half, uint32_t a, CollapsePlace place);

    CollapseMesh mesh_;
};

/// Why it may not be collapsed, for people: "its ends share another neighbour, and the surface would be pinched there". Empty when it may.
std::string reasonAgainst(const EdgeCollapser::Judgement& j);

struct CollapseEdge {
    std::string edge;
    CollapsePlace place = CollapsePlace::Optimal;
    template <class V>
    void describe(V& v)
    {
        v.text("edge", edge, {.title = "Edge", .help = "Its two vertices, as 3~7; empty: the first one that may be collapsed."});
        v.choice(
            "place", place, {"optimal", "middle", "first", "second"},
            {.title = "Place",
             .help = "Where the new vertex goes: nearest to the planes of both ends (on borders and seams it stays on them), to the middle, or to "
                     "the first or second vertex of the edge as written."});
    }
};

/// Both faces of the edge go, its ends become one vertex: V - 1, E - 3, F - 2; on the border V - 1, E - 2, F - 1. Polygons are cut into triangles
/// first. Throws Error with the reason when the edge may not be collapsed.
Generator collapseEdge(Mesh input, CollapseEdge parameters, Stage<Mesh>& stage);

}  // namespace mw
