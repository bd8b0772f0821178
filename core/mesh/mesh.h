// A mesh: immutable flat arrays that hold whatever a file holds (polygons, non-manifold edges, loose points and lines).
// Everything derived (half-edges, normals, rings, report) is made on first use, kept with the payload and shared by its copies.
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/attribute.h"

namespace mw {

class HalfedgeView;
struct TopologyReport;
struct Rings;

inline constexpr uint32_t none = ~0u;

struct Bounds {
    glm::dvec3 min{0}, max{0};
    bool empty = true;
    void add(glm::dvec3 p);
    void add(const Bounds& b);
    glm::dvec3 centre() const { return 0.5 * (min + max); }
    glm::dvec3 size() const { return max - min; }
    double diagonal() const;
};

/// Cheap to copy. Face f has corners faceStart[f] .. faceStart[f+1]-1; corner c is at vertex cornerVertex[c]. Counter-clockwise outside.
/// Preconditions, kept by every reader and operation: faceStart has faceCount()+1 ascending entries from 0, indices are in range,
/// positions are finite. A face may have fewer than 3 corners or a vertex twice (degenerate): it is kept and reported.
class Mesh {
public:
    Mesh();
    Mesh(Shared<glm::vec3> positions, Shared<uint32_t> faceStart, Shared<uint32_t> cornerVertex);
    static Mesh triangles(Shared<glm::vec3> positions, Shared<uint32_t> indices);

    size_t vertexCount() const { return positions_.size(); }
    size_t faceCount() const { return faceStart_.size() ? faceStart_.size() - 1 : 0; }
    size_t cornerCount() const { return cornerVertex_.size(); }
    size_t count(Domain d) const { return d == Domain::Vertex ? vertexCount() : d == Domain::Corner ? cornerCount() : faceCount(); }
    bool isTriangles() const;  ///< every face has three corners

    const Shared<glm::vec3>& positions() const { return positions_; }
    const Shared<uint32_t>& faceStart() const { return faceStart_; }
    const Shared<uint32_t>& cornerVertex() const { return cornerVertex_; }
    std::span<const uint32_t> face(size_t f) const { return {cornerVertex_.data() + faceStart_[f], faceStart_[f + 1] - faceStart_[f]}; }
    /// Pairs of vertices: loose line segments.
    const Shared<uint32_t>& lines() const { return lines_; }

    const std::vector<Attribute>& attributes() const { return attributes_; }
    const Attribute* find(std::string_view name) const;
    const Attribute* find(std::string_view name, Domain domain) const;
    const std::vector<std::string>& groupNames() const { return groupNames_; }

    // Changed copies. Arrays that stay are shared.
    Mesh withPositions(Shared<glm::vec3> positions) const;
    Mesh withLines(Shared<uint32_t> vertexPairs) const;
    Mesh with(Attribute a) const;  ///< replaces one of the same name and domain
    Mesh without(std::string_view name) const;
    Mesh withGroupNames(std::vector<std::string> names) const;

    // Derived; safe from any thread.
    const HalfedgeView& halfedges() const;           ///< core/mesh/halfedge.h
    const TopologyReport& topology() const;          ///< core/mesh/topology.h
    const Rings& rings() const;                      ///< core/mesh/rings.h: vertex to faces and vertex to vertices
    const Shared<glm::vec3>& faceNormals() const;    ///< unit, 0 where there is no area; polygons by Newell
    const Shared<glm::vec3>& vertexNormals() const;  ///< unit, weighted by area; of the positions alone, a file's own are an attribute
    /// Three vertices a triangle and, beside it, three corners a triangle and the face of each: polygons cut for drawing.
    struct Triangulation {
        Shared<uint32_t> vertices, corners, faces;
    };
    const Triangulation& triangulation() const;
    /// Each edge of all faces once, pairs of vertices with the lower first, in the order of first corner; none from a vertex to itself.
    const Shared<uint32_t>& edges() const;
    Bounds bounds() const;

    size_t bytes() const;

private:
    struct TopologyCache;
    struct GeometryCache;
    Shared<glm::vec3> positions_;
    Shared<uint32_t> faceStart_, cornerVertex_, lines_;
    std::vector<Attribute> attributes_;
    std::vector<std::string> groupNames_;
    std::shared_ptr<TopologyCache> topologyCache_;  // shared as long as faces are the same
    std::shared_ptr<GeometryCache> geometryCache_;  // shared as long as positions are the same, too
};

inline size_t byteSize(const Mesh& m)
{
    return m.bytes();
}
/// Of all arrays and names: equal content, equal hash.
uint64_t contentHash(const Mesh& m);

}  // namespace mw
