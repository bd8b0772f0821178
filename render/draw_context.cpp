// Uniform blocks and the small things every pass does.
#include "render/draw_context.h"

#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>

namespace mw {
namespace {

/// As in resources/shaders/camera.glsl.
struct CameraBlock {
    glm::mat4 clipFromView;
    glm::vec4 viewport, eye, skyTop, skyBottom;
};
}  // namespace

DrawContext::DrawContext(GpuState& state, const Frame& f, glm::ivec2 s) : gpu(state), frame(f), size(s), camera(f.camera)
{
    camera.fitClip(boundsOf(frame));
    viewFromWorld = camera.viewFromWorld();
    clipFromView = camera.clipFromView(double(size.x) / size.y);
}

const DrawObject* DrawContext::object(NodeId node) const
{
    for (const DrawObject& o : frame.objects)
        if (o.node == node) return &o;
    return nullptr;
}

const DrawTerrain* DrawContext::terrain(NodeId node) const
{
    for (const DrawTerrain& t : frame.terrains)
        if (t.node == node) return &t;
    return nullptr;
}

ObjectBlock DrawContext::blockOf(const glm::dmat4& worldFromLocal) const
{
    ObjectBlock b;
    const glm::dmat4 viewFromLocal = viewFromWorld * worldFromLocal;  // in double: things far from the origin do not tremble
    b.viewFromLocal = viewFromLocal;
    b.clipFromLocal = clipFromView * viewFromLocal;
    const glm::dmat3 m(viewFromLocal);
    b.normalFromLocal = std::abs(glm::determinant(m)) > 0 ? glm::dmat4(glm::inverseTranspose(m)) : glm::dmat4(m);
    return b;
}

void DrawContext::setObject(const ObjectBlock& block)
{
    gl::uploadBlock(gpu.objectBlock, mw::objectBlock, block);
}

void DrawContext::texture(TextureUnit unit, GLenum target, GLuint id) const
{
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(target, id);
}

GLuint DrawContext::positions(const DrawObject& o)
{
    SurfaceBuffers rest;
    rest.positions = gpu.cache.buffer(o.mesh.positions());
    rest.vertices = o.mesh.vertexCount();
    return gpu.posing.captured(gpu.cache, gpu.programs, o, {}, rest).positions;
}

void DrawContext::clearAttributes() const
{
    for (GLuint i = 0; i < 8; ++i) {
        glDisableVertexAttribArray(i);
        glVertexAttribDivisor(i, 0);
    }
}

void DrawContext::blend() const
{
    glEnable(GL_BLEND);
    if (frame.options.transparentBackground)
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    else
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
}

void uploadFrameBlocks(DrawContext& c)
{
    const ThemeColors& theme = themeColors(c.frame.options.theme);
    const bool perspective = c.camera.perspective;
    const double pixel = 2 * std::tan(0.5 * c.camera.fieldOfView) / c.size.y * (perspective ? 1 : c.camera.distance);
    CameraBlock block;
    block.clipFromView = c.clipFromView;
    block.viewport = {c.size.x, c.size.y, 1.0 / c.size.x, 1.0 / c.size.y};
    block.eye = {c.frame.options.pixelRatio, pixel, perspective ? 1 : 0, c.camera.nearClip};
    const float alpha = c.frame.options.transparentBackground ? 0.f : 1.f;
    const bool outdoors = !c.frame.terrains.empty();
    block.skyTop = glm::vec4(outdoors ? theme.skyTop : theme.top, alpha);
    block.skyBottom = glm::vec4(outdoors ? theme.skyBottom : theme.bottom, alpha);
    gl::uploadBlock(c.gpu.cameraBlock, cameraBlock, block);
    lightFrame(c);
}

}  // namespace mw
