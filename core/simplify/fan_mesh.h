// A triangle mesh whose vertices can be taken out: the faces round one leave a hole, which other triangles of the same ring close.
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/simplify/live_rank.h"

namespace mw {

/// The faces round a vertex v: face i has the corners v, ring[i], ring[i + 1].
///
///      ring[2] --- ring[1]        The outline runs anticlockwise. Round an inner vertex it is closed: as many faces as ring vertices, the last face
///        /   \     /   \          ends at ring[0]. Round one of the border it is open: one ring vertex more than faces, and the edge from the last
///       /  1  \   /  0  \         to the first one is not there yet.
///   ring[3] --- v ---- ring[0]
struct VertexFan {
    std::vector<uint32_t> ring;
    std::vector<uint32_t> outline;  ///< half-edge ring[i] -> ring[i + 1], of face i
    bool open = false;
    size_t faces() const { return outline.size(); }
};

/// Half-edges as in CollapseMesh, whose tables it begins with: centred, scaled to a box diagonal of 1. What is no surface, and what lies on a seam,
/// a crease or between materials, is fixed.
class FanMesh {
public:
    enum class Place : uint8_t { Inside, Border, Fixed };
    using Triple = std::array<uint32_t, 3>;  ///< places in a ring

    FanMesh(Mesh input, bool watched);

    static uint32_t next(uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static uint32_t prev(uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
    size_t vertexSlots() const { return at_.size(); }
    size_t vertices() const { return vertices_; }
    size_t faces() const { return faces_; }
    size_t edges() const { return edges_; }
    bool alive(uint32_t v) const { return alive_[v] != 0; }
    Place place(uint32_t v) const { return place_[v]; }
    const glm::dvec3& at(uint32_t v) const { return at_[v]; }
    uint32_t twin(uint32_t h) const { return twin_[h]; }
    uint32_t from(uint32_t h) const { return vertex_[h]; }
    uint32_t to(uint32_t h) const { return vertex_[next(h)]; }
    /// Twice the area times the unit normal.
    glm::dvec3 areaNormal(uint32_t face) const;

    /// False when there are none or more than `most` faces.
    bool fan(uint32_t v, VertexFan& out) const;
    static constexpr size_t most = 64;
    /// Whether an edge joins them; true as well where both lie on what is no surface, so that nobody can tell.
    bool joined(uint32_t a, uint32_t b) const;

    /// Takes v and its faces out.
    void open(uint32_t v, const VertexFan& fan);
    /// Closes the hole last opened with triangles of its ring that run as it does. Two fewer than ring vertices; none where only two are left.
    void close(const VertexFan& fan, const std::vector<Triple>& triangles);

    // As the payload numbers them now.
    uint32_t vertexIndex(uint32_t v) const { return vertexRank_(v); }
    uint32_t faceIndex(uint32_t f) const { return faceRank_(f); }
    glm::vec3 position(const glm::dvec3& scaled) const { return glm::vec3(scaled * scale_ + centre_); }
    double scale() const { return scale_; }
    /// The mesh as it stands; vertices and corners keep the values they had.
    Mesh payload() const;

private:
    void findCreases();
    void link(uint32_t h, uint32_t i, uint32_t j, const VertexFan& fan, std::vector<std::array<uint32_t, 3>>& waiting);
    Attribute carriedCreases(const Attribute& a, const std::vector<uint32_t>& corners) const;

    Mesh input_;
    std::vector<uint32_t> vertex_, twin_, any_;  // any_: by vertex a half-edge out of it
    std::vector<uint32_t> corner_, face_;        // where the values of a corner, of a face come from
    std::vector<uint32_t> crease_;               // by half-edge the corner that has its crease; empty when there are none
    std::vector<uint8_t> alive_, odd_;
    std::vector<Place> place_;
    std::vector<glm::dvec3> at_;
    std::vector<uint32_t> free_;  // slots of the hole
    std::vector<uint32_t> holeTwin_, holeCorner_, holeCrease_, holeFace_;
    size_t vertices_ = 0, faces_ = 0, edges_ = 0;
    glm::dvec3 centre_{0};
    double scale_ = 1;
    LiveRank vertexRank_, faceRank_;
    bool watched_;
};

}  // namespace mw
