// What the passes of one frame share: the fitted camera, caches, programs, and how a draw is set up.
#pragma once
#include <array>

#include "render/colors.h"
#include "render/gpu_cache.h"
#include "render/lights.h"
#include "render/posing.h"
#include "render/renderer.h"
#include "render/shaders.h"
#include "render/surface_geometry.h"
#include "render/terrain_textures.h"

namespace mw {

/// As in resources/shaders/object.glsl.
struct ObjectBlock {
    glm::mat4 clipFromLocal{1}, viewFromLocal{1}, normalFromLocal{1};
    glm::vec4 baseColor{0.6, 0.6, 0.6, 1}, surface{0, 0.6, 0, -1}, look{0, 1, 0, 0}, heat{0}, mark{1}, stroke{1, 0, 0, 0};
    glm::ivec4 ids{0};
    glm::vec4 emissive{0, 0, 0, 1}, maps{1, 0, 0, 0};
};

/// Lives as long as the renderer.
struct GpuState {
    GpuCache cache;
    SurfaceLayouts layouts;
    Posing posing;
    TerrainTextures terrains;
    Programs programs;
    EnvironmentTextures environments;
    gl::VertexArray vertexArray;
    gl::Buffer cameraBlock, lightsBlock, objectBlock, terrainBlock, transient, transientIndices;
    gl::Texture heatTable, mask, shadowMap;
    gl::Framebuffer maskFramebuffer, shadowFramebuffer;
    glm::ivec2 maskSize{0};
    GLint maxTextureBuffer = 65536;
};

struct DrawContext {
    DrawContext(GpuState& state, const Frame& frame, glm::ivec2 size);

    GpuState& gpu;
    const Frame& frame;
    glm::ivec2 size;
    Camera camera;  ///< with clip planes that hold the frame
    glm::dmat4 viewFromWorld, clipFromView;
    FrameLight light;
    Renderer::Counts counts;

    const DrawObject* object(NodeId node) const;
    const DrawTerrain* terrain(NodeId node) const;
    /// The transforms of an object; the rest of the block as it is by default.
    ObjectBlock blockOf(const glm::dmat4& worldFromLocal) const;
    void setObject(const ObjectBlock& block);
    void use(ProgramId program, unsigned variant = 0) { glUseProgram(gpu.programs.get(program, variant)); }
    void texture(TextureUnit unit, GLenum target, GLuint id) const;
    /// A place for each vertex of the mesh, posed: in a buffer, and in memory.
    GLuint positions(const DrawObject& o);
    Shared<glm::vec3> places(const DrawObject& o) { return gpu.posing.places(o); }
    /// Switches attributes 0..7 off, so that a pass states all it needs.
    void clearAttributes() const;
    /// Blending that leaves the mask in alpha alone, or adds up coverage when the background is transparent.
    void blend() const;
};

/// Camera and lights to the card; call once for a context.
void uploadFrameBlocks(DrawContext& c);

// The passes, in the order in which they draw.
void drawShadowMap(DrawContext& c, unsigned target);
void drawBackground(DrawContext& c);
void drawSurfaces(DrawContext& c);
void drawTerrains(DrawContext& c);
void drawTerrainWires(DrawContext& c);
void drawTerrainIds(DrawContext& c);  ///< into the id buffer
void drawWires(DrawContext& c);
void drawEdgeHeat(DrawContext& c);  ///< values of edges as coloured lines
void drawGroundShadow(DrawContext& c);
void drawGrid(DrawContext& c);
void drawLoose(DrawContext& c);  ///< lines and points that belong to no face, needles
/// A line round what is selected or under the pointer, from the mask in the picture's alpha; then alpha is 1 everywhere.
void drawOutlines(DrawContext& c, unsigned target);
void drawBones(DrawContext& c);
void drawMarks(DrawContext& c);

/// The surface of one object, bound: layout, buffers, winding. For passes that draw triangles.
struct BoundSurface {
    std::shared_ptr<const SurfaceLayout> layout;
    SurfaceBuffers buffers;
};
BoundSurface bindSurface(DrawContext& c, const DrawObject& o, const SurfaceWants& wants);
/// Draws one run of triangles; the block's `ids.y` is set to its first triangle.
void drawRun(DrawContext& c, const BoundSurface& s, const SurfaceLayout::Run& run, ObjectBlock block);
/// Vertices and lines of no face.
bool hasLoosePoints(const Mesh& mesh);

}  // namespace mw
