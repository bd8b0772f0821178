// How a mesh goes to the graphics card: vertices as they are where that is enough, split where normals, colours or texture coordinates
// differ between the corners of a vertex; triangles in runs of one material each.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "render/gpu_cache.h"
#include "render/renderer.h"

namespace mw {

/// What is wanted of a mesh beyond its shape.
struct SurfaceWants {
    bool normals = true, colors = true;
    std::array<int, 2> texcoordSets{-1, -1};  ///< -1: none
    bool tangents = false;
    size_t slots = 1;  ///< materials of the object
};

/// Which payload vertex and corner each drawn vertex is, and the triangles between them.
struct SurfaceLayout {
    Shared<uint32_t> vertexOf, cornerOf;  ///< both empty: drawn vertex i is payload vertex i, corners do not matter
    Shared<uint32_t> indices;             ///< three a triangle
    Shared<uint32_t> triangleFace;        ///< empty: triangle i is face i
    struct Run {
        uint32_t slot;
        size_t first, count;  ///< triangles
    };
    std::vector<Run> runs;
    const Attribute *normal = nullptr, *color = nullptr, *tangent = nullptr;  ///< of the mesh; null: not there or not wanted
    std::array<const Attribute*, 2> texcoord{};
};

/// Layouts, kept by what they are made of.
class SurfaceLayouts {
public:
    std::shared_ptr<const SurfaceLayout> get(const Mesh& mesh, const SurfaceWants& wants);
    void forgetDead();

private:
    struct Entry {
        std::shared_ptr<const SurfaceLayout> layout;
        std::vector<std::weak_ptr<const void>> owners;
    };
    std::map<std::array<const void*, 8>, Entry> entries_;
};

/// The buffers of a layout, ready to be bound.
struct SurfaceBuffers {
    GLuint positions = 0, normals = 0, colors = 0, tangents = 0, indices = 0;
    std::array<GLuint, 2> texcoords{};
    int colorComponents = 4, colorStride = 0;
    std::array<int, 2> texcoordStride{};
    size_t vertices = 0;
};
SurfaceBuffers surfaceBuffers(GpuCache& cache, const Mesh& mesh, const SurfaceLayout& layout, const SurfaceWants& wants);

/// For each triangle of the layout the bits of its edges that are edges of the face; 0 when all are (a triangle mesh).
GLuint edgeFlagTexture(GpuCache& cache, const Mesh& mesh, const SurfaceLayout& layout);
/// For each triangle its face; 0 when they are the same.
GLuint triangleFaceTexture(GpuCache& cache, const SurfaceLayout& layout);

/// What keeps the array of an attribute alive.
std::shared_ptr<const void> ownerOf(const Attribute& a);

}  // namespace mw
