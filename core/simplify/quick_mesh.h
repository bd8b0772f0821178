// The tables of the quick decimation: one cache line a vertex, half a line a face, in the order of a space-filling curve, so that what is near on the
// surface is near in memory. The rules of which edges must stay are those of collapse_mesh.h, the layout is made for millions of faces.
#pragma once
#include <atomic>
#include <memory>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/simplify/carried.h"
#include "core/simplify/large_buffer.h"
#include "core/simplify/live_rank.h"
#include "core/simplify/quick_quadric.h"

namespace mw::quick {

/// Half-edge h = 4 * face + k runs from corner k of a face to the next one; below 0: none.
constexpr int next(int h)
{
    return (h & 3) == 2 ? h - 2 : h + 1;
}
constexpr int prev(int h)
{
    return (h & 3) == 0 ? h + 2 : h - 1;
}

/// A free vertex may go anywhere, one on a curve (border, seam, crease) only along it, an end or meeting of curves stays, a locked one takes no part.
enum Kind : uint32_t { Free, Curve, Corner, Locked };

struct alignas(64) Vertex {
    static constexpr uint32_t kindBits = 3, nearWall = 4;
    Float4 place;       ///< in the unit box; the fourth is 0
    Symmetric quadric;  ///< about that place
    uint32_t flag;      ///< its Kind, and whether an edge at it is weighed
    int parent;         ///< the vertex it went into, itself while it is there
    uint32_t old;       ///< index in the input
    uint32_t faces;     ///< how many there are around it

    Kind kind() const { return Kind(flag & kindBits); }
};

struct alignas(32) Face {
    int v[3];       ///< v[0] < 0: gone
    uint32_t bits;  ///< of its half-edges, three bits each: in the queue, on a curve, bent
    int twin[3];
    uint32_t old;  ///< index of the triangle in the input

    static constexpr int curve = 3, bent = 6;
    bool queued(int h) const { return bits >> (h & 3) & 1; }
    void setQueued(int h) { bits |= 1u << (h & 3); }
    void clearQueued(int h) { bits &= ~(1u << (h & 3)); }
};

struct Rules {
    float turn = 0.2f;      ///< least cosine between the normals of a face before and after
    float wall = 10;        ///< weight of borders, seams and bends against faces
    float bend = -1;        ///< edges whose normals have a lower cosine are weighed
    bool endsOnly = false;  ///< no new places
    float deviation = -1;   ///< how far the surface may move (in the unit box); below 0: any
};

/// Vertices [first, last) whose faces a worker may touch.
struct Range {
    int first, last;
    MW_INLINE bool holds(int v) const { return uint32_t(v - first) < uint32_t(last - first); }
};

/// A piece of the mesh that one worker has for itself: vertices, and the faces whose least vertex is one of them. Fixed by the mesh alone, so that
/// the result is the same with any number of threads.
struct Region {
    Range vertices;
    int firstFace, lastFace;
};

class Tables {
public:
    Tables(Mesh input, const Rules& rules, bool watched);

    int from(int h) const { return faces[size_t(h >> 2)].v[h & 3]; }
    int to(int h) const { return from(next(h)); }
    int twin(int h) const { return faces[size_t(h >> 2)].twin[h & 3]; }
    bool alive(int h) const { return faces[size_t(h >> 2)].v[0] >= 0; }
    bool onCurve(int h) const { return twin(h) < 0 || (faces[size_t(h >> 2)].bits >> (Face::curve + (h & 3)) & 1); }
    bool weighed(int h) const { return twin(h) < 0 || (faces[size_t(h >> 2)].bits >> (h & 3) & (1u << Face::curve | 1u << Face::bent)); }
    Float4 normal(int face) const
    {
        const Face& f = faces[size_t(face)];
        const Float4 a = vertices[size_t(f.v[0])].place;
        return cross(vertices[size_t(f.v[1])].place - a, vertices[size_t(f.v[2])].place - a);
    }
    /// A plane on a side of a face that holds it where it is.
    Symmetric wallOf(int h, Float4 normal) const;
    /// Adds what a face gives to the quadrics of its vertices, or with -1 takes it back.
    void give(int face, float sign);
    /// False when the kinds of its ends forbid a collapse whatever the place.
    bool collapsible(int h) const
    {
        const Kind a = vertices[size_t(from(h))].kind(), b = vertices[size_t(to(h))].kind();
        if (a == Locked || b == Locked || (a == Corner && b == Corner)) return false;
        return a == Free || b == Free || onCurve(h);
    }
    /// Where the edge would go and at what cost. An end on a curve, or at the end of one, holds the other.
    MW_INLINE Target target(int h) const
    {
        const Vertex &a = vertices[size_t(from(h))], &b = vertices[size_t(to(h))];
        if (__builtin_expect(((a.flag ^ b.flag) & Vertex::kindBits) != 0 || rules.endsOnly, 0)) return endTarget(a, b);
        return bestTarget(a.quadric, b.quadric, b.place - a.place);
    }

    /// What the collapse of h changes beside places and faces; h as it was.
    void uniteWedges(int h);
    void closeFace(int h);

    // As the payload numbers them now.
    uint32_t vertexIndex(int v) const { return vertexRank_(vertices[size_t(v)].old); }
    bool watched() const { return watched_; }
    void noteRemoved(int vertex, int face, int other);
    uint32_t faceIndex(int f) const { return faceRank_(faces[size_t(f)].old); }
    Float4 scaled(const glm::vec3& p) const;
    glm::vec3 position(Float4 place) const;
    glm::vec3 position(const Vertex& v) const;  ///< the input's own where it has not moved
    const Mesh& input() const { return input_; }
    const OldTriangles& old() const { return old_; }
    double scale() const { return scale_; }
    /// The mesh as it stands.
    Mesh payload() const;

    std::vector<Region> regions;
    LargeBuffer<Vertex> vertices;
    LargeBuffer<Face> faces;
    std::vector<uint32_t> rank;    ///< of a vertex of the input
    std::vector<float> deviation;  ///< by vertex: how far the surface has moved there; empty unless it is limited
    Rules rules;

private:
    void measure();
    void orderVertices();
    std::vector<uint32_t> orderFaces();
    void findTwins(const std::vector<uint32_t>& facesUpTo);
    void twinsOf(int v, uint64_t* first, uint64_t* last);
    void lock(int v);
    void lockOddOnes();
    void markSeams(const SeamTest& seams);
    void joinWedges();
    void unite(uint32_t a, uint32_t b);
    void makeRegions(const uint32_t* facesBefore);
    void markBends();
    void classify();
    void gatherQuadrics();
    Target endTarget(const Vertex& a, const Vertex& b) const;
    uint32_t oldCorner(int h) const { return 3 * faces[size_t(h >> 2)].old + uint32_t(h & 3); }
    uint32_t wedgeOf(uint32_t corner) const;
    void numberWedges(Collapsed& c) const;

    Mesh input_;
    OldTriangles old_;
    glm::dvec3 centre_{0};
    double scale_ = 1;
    std::atomic<bool> anyCurve_ = false;
    std::vector<float> crease_;  // by half-edge; empty when there are none
    // Corners that share their values, as a forest over the old corners. A vertex that was free has one value for all of its corners and stands for
    // them; when it comes onto a curve it joins a corner there.
    mutable std::vector<uint32_t> wedge_;
    std::vector<uint32_t> joined_;  // by vertex: that corner
    LiveRank vertexRank_, faceRank_;
    bool watched_;
};

}  // namespace mw::quick
