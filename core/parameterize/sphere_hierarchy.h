// A first embedding of a closed mesh on the sphere without fold-overs: vertices are taken out until a tetrahedron is left, which is put on the
// sphere, and come back one by one where they have most room.
#pragma once
#include <glm/vec3.hpp>
#include <span>

#include "core/mesh/mesh.h"

namespace mw {

/// Neighbours of each vertex of a closed, oriented triangle mesh, anticlockwise seen from outside.
std::vector<std::vector<uint32_t>> orderedRings(const Mesh& triangles);

/// Praun and Hoppe 2003, with the independent sets of Dobkin and Kirkpatrick 1985 as levels. Half-edge collapses keep the mesh a triangulated
/// sphere (at each vertex taken out, the vertex it goes into and the vertex itself have two common neighbours only). A vertex comes back in the
/// kernel of its ring, at the middle of the largest circle there; between levels all vertices are evened out without turning a face over. O(n) for
/// meshes of bounded valence.
class SphereHierarchy {
public:
    explicit SphereHierarchy(const Mesh& triangles);

    /// Takes one vertex out; false when four are left. Throws Error when the mesh is no sphere.
    bool removeNext();
    /// Puts one back; false when all are there. Does first what evenOut() has left.
    bool insertNext();
    /// After the last one of a level all vertices are evened out, a few thousand a call; false when none are left.
    bool evenOut();

    size_t left() const { return left_; }      ///< vertices that are not taken out
    uint32_t vertex() const { return last_; }  ///< of the last removal or insertion
    std::span<const uint32_t> ring() const { return lastRing_; }
    double room() const { return room_; }  ///< angle of the largest circle in its ring, radians
    /// Of all vertices; those that are out lie where they went into.
    std::vector<glm::dvec3> places() const;
    std::vector<glm::dvec3> takePlaces() { return std::move(places_); }

private:
    struct Removal {
        uint32_t vertex, level;
        std::vector<uint32_t> ring;  ///< of the vertex; the first is the one it went into
    };
    void beginLevel();
    bool remove(uint32_t u);
    void putTetrahedron();

    std::vector<std::vector<uint32_t>> rings_;
    std::vector<uint32_t> queue_;  // of this level
    size_t next_ = 0;
    std::vector<uint8_t> blocked_;
    std::vector<Removal> removed_;
    size_t left_ = 0;
    uint32_t level_ = 0, last_ = 0;
    std::vector<uint32_t> present_, lastRing_;
    std::vector<glm::dvec3> places_;
    bool based_ = false;
    size_t toEven_ = 0;  // moves that are still to be made between two levels
    double room_ = 0;
};

/// Moves a vertex of the sphere towards a target, or a part of the way, so that no face of its ring turns over or gets smaller than
/// `least` (twice the area of a flat triangle) unless it was. How far it went.
double moveOnSphere(std::vector<glm::dvec3>& places, uint32_t vertex, std::span<const uint32_t> ring, const glm::dvec3& target, double least);

}  // namespace mw
