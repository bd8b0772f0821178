// The order of the passes, and the state they share.
#include "render/renderer.h"

#include "core/error.h"
#include "render/draw_context.h"
#include "render/heat_values.h"
#include "render/id_buffer.h"
#include "render/kept_picture.h"
#include "render/overlay.h"

namespace mw {

struct Renderer::Impl {
    GpuState gpu;
    IdBuffer ids;
    KeptPicture kept;
    Canvas canvas;
    Counts counts;
};

namespace {

/// A window's toolkit leaves its own state behind; nothing of it is taken for granted.
void cleanState(GLuint vertexArray, unsigned target, glm::ivec2 size)
{
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, size.x, size.y);
    glBindVertexArray(vertexArray);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LEQUAL);
    glDepthRange(0, 1);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void clear(const Frame& frame)
{
    const bool transparent = frame.options.transparentBackground;
    glClearColor(0, 0, 0, transparent ? 0.f : 1.f);
    glClearDepth(1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/// All that stays while the pointer moves.
void drawScene(DrawContext& c, unsigned target)
{
    c.gpu.terrains.beginFrame();
    c.gpu.posing.beginFrame();
    drawShadowMap(c, target);
    clear(c.frame);
    drawBackground(c);
    drawSurfaces(c);
    drawTerrains(c);
    drawGroundShadow(c);
    drawGrid(c);
    drawWires(c);
    drawEdgeHeat(c);
    drawLoose(c);
    drawOutlines(c, target);
    drawBones(c);
}

}  // namespace

Renderer::Renderer() : impl_(std::make_unique<Impl>())
{
    if (epoxy_gl_version() < 41)
        throw Error("the graphics driver offers OpenGL " + std::to_string(epoxy_gl_version() / 10) + "." + std::to_string(epoxy_gl_version() % 10) +
                    ", 4.1 is needed; install or update Mesa (package libgl1-mesa-dri)");
    makeHeatTable(impl_->gpu.heatTable);
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &impl_->gpu.maxTextureBuffer);
}

Renderer::~Renderer() = default;

void Renderer::draw(const Frame& frame, unsigned target, glm::ivec2 size)
{
    if (size.x < 1 || size.y < 1) return;
    GpuState& gpu = impl_->gpu;
    gpu.cache.beginFrame();
    gpu.layouts.forgetDead();
    DrawContext c(gpu, frame, size);
    cleanState(gpu.vertexArray.id(), target, size);
    uploadFrameBlocks(c);
    if (!impl_->kept.restore(c, target)) {
        drawScene(c, target);
        impl_->kept.keep(c, target);
    }
    drawMarks(c);
    drawLabels(c, impl_->canvas);
    drawLegend(c, impl_->canvas);
    drawMarker(c, impl_->canvas);
    drawFlats(c, impl_->canvas);
    impl_->canvas.flush(c);
    impl_->counts = c.counts;
    impl_->counts.uploadedBytes = gpu.cache.uploadedBytes() + gpu.terrains.uploadedBytes();
    glBindVertexArray(0);
    glUseProgram(0);
}

std::optional<Pick> Renderer::pick(const Frame& frame, glm::ivec2 size, glm::dvec2 pixel)
{
    if (size.x < 1 || size.y < 1) return {};
    DrawContext c(impl_->gpu, frame, size);
    cleanState(impl_->gpu.vertexArray.id(), 0, size);
    return pickAt(c, impl_->ids, pixel);
}

std::vector<std::pair<NodeId, std::vector<uint32_t>>> Renderer::visibleFaces(const Frame& frame, glm::ivec2 size, const Region& region)
{
    if (size.x < 1 || size.y < 1) return {};
    DrawContext c(impl_->gpu, frame, size);
    cleanState(impl_->gpu.vertexArray.id(), 0, size);
    return facesIn(impl_->ids.read(c, glm::min(region.low, region.high), glm::max(region.low, region.high)), region);
}

Renderer::Counts Renderer::counts() const
{
    return impl_->counts;
}

}  // namespace mw
