// Meshes moved by joints and morph weights. For drawing this happens on the graphics card, once a pose: places and normals are captured in
// buffers that all passes bind instead of those at rest. The mesh at rest is sent once, a new pose sends its matrices.
#pragma once
#include <list>
#include <map>
#include <memory>
#include <vector>

#include "render/shaders.h"
#include "render/surface_geometry.h"

namespace mw {

class Posing {
public:
    /// Lets go of what was not asked for during some frames.
    void beginFrame();

    struct Buffers {
        GLuint positions = 0, normals = 0;
    };
    /// `rest` holds the buffers of the layout as the mesh rests; its normals may be 0. Leaves program and vertex array as they were.
    Buffers captured(GpuCache& cache, Programs& programs, const DrawObject& o, const SurfaceLayout& layout, const SurfaceBuffers& rest);
    /// The same on the CPU, for picking: a place for each vertex.
    Shared<glm::vec3> places(const DrawObject& o);

private:
    struct Captured {
        MeshPose pose;
        gl::Buffer data, positions, normals;
        gl::Texture dataTexture;
        std::weak_ptr<const void> rest, layout;
        uint64_t lastUse = 0;
    };
    /// Displacements of all morph targets in one buffer.
    struct Deltas {
        std::vector<const void*> arrays;
        std::vector<std::weak_ptr<const void>> owners;
        gl::Buffer buffer;
        gl::Texture texture;
        size_t elements = 0;
        uint64_t lastUse = 0;
    };
    struct Placed {
        std::weak_ptr<const void> rest;
        const void* id;
        MeshPose pose;
        Shared<glm::vec3> places;
    };
    using Key = std::array<const void*, 4>;
    void capture(GpuCache& cache, Programs& programs, const DrawObject& o, const SurfaceLayout& layout, const SurfaceBuffers& rest, Captured& to);
    Deltas& deltas(GpuCache& cache, const Mesh& mesh, bool normals, Domain domain);

    std::map<Key, Captured> captured_;
    std::list<Deltas> deltas_;
    std::list<Placed> placed_;  // most recent first
    gl::VertexArray vertexArray_;
    gl::Buffer block_;
    uint64_t frame_ = 0;
};

/// The box of an object in the world, large enough at its pose: each joint moves the box of what follows it.
Bounds worldBounds(const DrawObject& o);
bool operator==(const MeshPose& a, const MeshPose& b);

}  // namespace mw
