// Shadows of the key light: the map, seen from it, and what falls on the ground plane.
#include <algorithm>
#include <cmath>

#include "render/draw_context.h"
#include "render/materials.h"

namespace mw {
namespace {

void makeMap(GpuState& gpu)
{
    if (gpu.shadowMap) return;
    glActiveTexture(GL_TEXTURE0 + shadowUnit);
    glBindTexture(GL_TEXTURE_2D, gpu.shadowMap.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, shadowSide, shadowSide, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_BORDER);
    constexpr float nothing[] = {1, 1, 1, 1};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, nothing);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glBindFramebuffer(GL_FRAMEBUFFER, gpu.shadowFramebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, gpu.shadowMap.get(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
}

void cast(DrawContext& c, const DrawObject& o)
{
    if (o.mesh.faceCount() == 0) return;
    SurfaceWants wants;
    wants.normals = wants.colors = false;
    wants.texcoordSets = maskSets(o);
    wants.slots = wants.texcoordSets[0] >= 0 ? std::max<size_t>(o.materials.size(), 1) : 1;
    const BoundSurface s = bindSurface(c, o, wants);
    for (const SurfaceLayout::Run& run : s.layout->runs) {
        ObjectBlock block = c.blockOf(o.worldFromLocal);
        block.clipFromLocal = c.light.shadowFromWorld * o.worldFromLocal;
        if (wants.slots == 1 && wants.texcoordSets[0] < 0) {
            c.use(ProgramId::Shadow);
        } else {
            c.use(ProgramId::Shadow, applyMask(c, o, run.slot, wants.texcoordSets, block));
        }
        const Renderer::Counts before = c.counts;
        drawRun(c, s, run, block);
        c.counts = before;  // what is seen counts
    }
}

/// The piece of the plane y = 0 that the box of the map falls on, in world space; nothing when the light comes from below or grazes it.
std::vector<glm::dvec3> piece(const DrawContext& c)
{
    const glm::dmat4 worldFromShadow = glm::inverse(c.light.shadowFromWorld);
    std::vector<glm::dvec3> out;
    if (c.light.key.y < 0.08) return out;
    const double soft = 1 + 4.0 * softOnGround / shadowSide;
    for (const glm::dvec2 corner : {glm::dvec2(-1, -1), {1, -1}, {-1, 1}, {1, 1}}) {
        const glm::dvec3 p(worldFromShadow * glm::dvec4(corner * soft, 0, 1));
        out.push_back(p - c.light.key * (p.y / c.light.key.y));
    }
    return out;
}

}  // namespace

void drawShadowMap(DrawContext& c, unsigned target)
{
    if (!c.light.shadows) return;
    makeMap(c.gpu);
    glBindFramebuffer(GL_FRAMEBUFFER, c.gpu.shadowFramebuffer.get());
    glViewport(0, 0, shadowSide, shadowSide);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glClearDepth(1);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5f, 2);
    for (const DrawObject& o : c.frame.objects) cast(c, o);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, c.size.x, c.size.y);
    c.texture(shadowUnit, GL_TEXTURE_2D, c.gpu.shadowMap.get());
}

void drawGroundShadow(DrawContext& c)
{
    if (!c.light.shadows || !c.frame.terrains.empty() || c.camera.eye().y < 0) return;
    const std::vector<glm::dvec3> corners = piece(c);
    if (corners.empty()) return;
    const glm::dvec3 middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    std::vector<glm::vec3> points;
    for (const glm::dvec3& p : corners) points.emplace_back(p - middle);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    c.blend();
    glEnable(GL_POLYGON_OFFSET_FILL);  // a floor that lies in the plane hides it
    glPolygonOffset(1, 8);
    c.use(ProgramId::GroundShadow);
    ObjectBlock b = c.blockOf(glm::translate(glm::dmat4(1), middle));
    b.mark = {0, 0, 0, c.light.groundShade};
    c.setObject(b);
    gl::stream(c.gpu.transient, std::span<const glm::vec3>(points));
    c.clearAttributes();
    gl::attribute({0, c.gpu.transient.get()});
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace mw
