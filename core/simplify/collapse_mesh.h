// A triangle mesh whose edges can be collapsed: flat tables of corners and their twins, which edges must stay (borders, seams, creases), the tests
// whether a collapse is legal, and the way back to a payload with every attribute.
#pragma once
#include <glm/vec3.hpp>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/simplify/carried.h"
#include "core/simplify/live_rank.h"
#include "core/simplify/refusal.h"

namespace mw {

/// What the tests found out, for the lesson.
struct Verdict {
    Refusal refusal = Refusal::None;
    int common = 0, allowed = 0;  ///< neighbours shared by the two rings
    double turn = 1;              ///< least cosine between a face's normal before and after
    double deviation = 0;         ///< largest distance of the new point to a plane it leaves
};

/// Half-edge h = 3f + k runs from corner k of triangle f to the next one; its twin runs back, `none` at a border.
///
///            tip                Collapsing h = (v, w): faces of h and of its twin go, w becomes v at the new
///           /   \               place, the two outer sides of each face become one edge.
///     prev /  h  \ next
///         v ----> w
///
/// Positions are centred and scaled to a box diagonal of 1. Vertices have a kind: a free one may go anywhere, one on a curve (border, seam, edge
/// between materials, crease) only along it, an end or meeting of curves stays, a locked one (where the input is no surface) takes no part.
class CollapseMesh {
public:
    enum Kind : uint8_t { Free, Curve, Corner, Locked };
    struct Options {
        double featureAngle = 180;  ///< degrees; edges that bend more are weighed like borders
        double turnCosine = 0.2;
    };

    CollapseMesh(Mesh input, const Options& options, bool watched);

    static uint32_t next(uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static uint32_t prev(uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
    uint32_t from(uint32_t h) const { return vertex_[h]; }
    uint32_t to(uint32_t h) const { return vertex_[next(h)]; }
    uint32_t twin(uint32_t h) const { return twin_[h]; }
    /// The name of an edge: the lower of its half-edges.
    uint32_t edgeOf(uint32_t h) const { return twin_[h] < h ? twin_[h] : h; }
    bool alive(uint32_t face) const { return vertex_[3 * face] != none; }
    size_t faces() const { return faces_; }
    size_t faceSlots() const { return vertex_.size() / 3; }
    size_t vertexSlots() const { return place_.size(); }
    const glm::dvec3& at(uint32_t v) const { return place_[v]; }
    Kind kind(uint32_t v) const { return Kind(kind_[v]); }
    /// On a border, seam or crease, or bent enough to be weighed like one.
    bool weighed(uint32_t h) const { return twin_[h] == none || sharp_[h] != 0; }
    bool onCurve(uint32_t h) const { return twin_[h] == none || (sharp_[h] & rule); }
    /// False when the kinds of its ends forbid a collapse whatever the place.
    bool collapsible(uint32_t h) const;

    /// Twice the area times the unit normal.
    glm::dvec3 areaNormal(uint32_t face) const;
    /// Corners at the two ends of h, of the faces that stay: those that a collapse changes. Lives until the next call.
    const std::vector<uint32_t>& star(uint32_t h);
    /// Of the edge last given to star().
    Verdict test(uint32_t h, const glm::dvec3& p);
    /// The corner of a surviving face at the vertex that stays.
    uint32_t collapse(uint32_t h, const glm::dvec3& p);
    /// Half-edges out of the origin of h, in order; open ones end with the border. False when there are more than `most`.
    bool fan(uint32_t h, std::vector<uint32_t>& out, bool& open) const;

    // As the payload numbers them now.
    uint32_t vertexIndex(uint32_t v) const { return vertexRank_(v); }
    uint32_t faceIndex(uint32_t f) const { return faceRank_(f); }
    glm::vec3 position(const glm::dvec3& scaled) const { return glm::vec3(scaled * scale_ + centre_); }
    /// The mesh as it stands. Attributes of vertices and corners are read off the old surface at the nearest point that went into the vertex.
    Mesh payload() const;

private:
    static constexpr uint8_t rule = 1, bend = 2;
    static constexpr size_t mostFan = 1024;

    void readTriangles();
    void scalePositions();
    void findTwins();
    void lockOddVertices();
    void markSeams(const SeamTest& seams);
    void markBends(double angle);
    void joinWedges();
    void classify();
    Refusal linkRefusal(uint32_t h, Verdict& v);
    Refusal shapeRefusal(uint32_t h, const glm::dvec3& p, Verdict& v) const;
    bool foldedBefore(uint32_t h, size_t i, size_t j, uint32_t rim) const;
    void closeFace(uint32_t h);
    void unite(std::vector<uint32_t>& parent, uint32_t a, uint32_t b);

    Mesh input_;
    Options options_;
    std::vector<uint32_t> vertex_, twin_;
    OldTriangles old_;
    std::vector<uint8_t> sharp_, kind_;
    std::vector<float> crease_;  // by half-edge; empty when there are none
    std::vector<glm::dvec3> place_;
    std::vector<uint32_t> into_;   // the vertex this one went into, itself while it is there
    std::vector<uint32_t> wedge_;  // by corner: corners that share their values, as a forest; empty when corners carry nothing
    size_t faces_ = 0;
    glm::dvec3 centre_{0};
    double scale_ = 1;
    LiveRank vertexRank_, faceRank_;
    // Of the last star().
    std::vector<uint32_t> star_, fanV_, fanW_;
    bool openV_ = false, openW_ = false, tooMany_ = false;
    std::vector<glm::dvec3> before_;
    std::vector<uint32_t> stamp_;
    uint32_t stampNow_ = 0;
    bool watched_;
};

}  // namespace mw
