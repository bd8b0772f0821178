// Shaded triangles: clay, vertex colours, textures and metal, or values as colours.
#include <algorithm>

#include "render/draw_context.h"
#include "render/heat_values.h"
#include "render/image.h"
#include "render/matcap.h"
#include "render/materials.h"

namespace mw {
namespace {

constexpr glm::vec4 clay{0.60f, 0.60f, 0.61f, 1};
constexpr size_t denseFaces = 200'000;  // from here on triangles are a few pixels at most, and light at the vertices is enough
constexpr float backFaceTint = 0.28f;

const HeatMap* surfaceHeat(const DrawObject& o)
{
    const HeatMap* vertices = heatOf(o, ElementKind::Vertex);
    return vertices ? vertices : heatOf(o, ElementKind::Face);
}

/// Everything of the block that is the same for all runs of an object.
ObjectBlock objectBlockOf(DrawContext& c, const DrawObject& o, const HeatMap* heat)
{
    ObjectBlock b = c.blockOf(o.worldFromLocal);
    const bool mask = !c.frame.options.transparentBackground;
    b.look = {o.dimmed ? 0.65f : 0.f, !mask ? 1.f : o.selected ? 0.f : o.hovered ? 0.7f : 1.f, backFaceTint, 0};
    b.baseColor = clay;
    b.surface = {0, 0.6f, heat ? 0.05f : 0.1f, -1};
    if (c.frame.options.xray) b.look.y = 0.30f;
    if (heat) b.heat = heatUniform(*heat);
    b.ids.x = int(o.node.value);
    return b;
}

struct Plan {
    const HeatMap* heat = nullptr;
    bool matcap = false, checker = false, pictures = false;
    SurfaceWants wants;
    unsigned variant = 0;
};

/// Which programs draw an object, as far as that is the same for all its materials.
unsigned variantOf(const DrawContext& c, const DrawObject& o, const Plan& p)
{
    unsigned v = 0;
    if (c.frame.options.shading == Shading::Flat) v |= variant::flat;
    if (o.dimmed) v |= variant::dimmed;
    if (p.heat) {
        const bool categories = heatRow(*p.heat) == categoryRow;
        v |= p.heat->table->rows == ElementKind::Face ? variant::heatFace : categories ? variant::heatCategory : variant::heat;
    }
    if (p.matcap) return v | variant::matcap;
    if (c.light.environment) v |= variant::environment;
    if (c.light.shadows) v |= variant::shadow;
    return v;
}

Plan planFor(const DrawContext& c, const DrawObject& o)
{
    const ViewOptions& options = c.frame.options;
    Plan p;
    p.heat = surfaceHeat(o);
    p.matcap = options.shading == Shading::Matcap && !p.heat;
    p.checker = options.checker && !p.heat && !p.matcap;
    p.pictures = !p.heat && !p.matcap && !p.checker;
    const bool flat = options.shading == Shading::Flat;
    p.wants.normals = !flat;
    p.wants.colors = p.pictures;
    if (p.pictures) p.wants.texcoordSets = pictureSets(o);
    if (p.checker) p.wants.texcoordSets[0] = std::max(pictureSets(o)[0], 0);
    p.wants.tangents = p.pictures && !flat && !o.pose && hasNormalMap(o);  // a pose moves places and normals alone
    p.wants.slots = p.pictures ? std::max<size_t>(o.materials.size(), 1) : 1;
    p.variant = variantOf(c, o, p);
    return p;
}

void bindHeat(DrawContext& c, const Plan& p, const BoundSurface& s, ObjectBlock& block)
{
    c.texture(heatUnit, GL_TEXTURE_2D, c.gpu.heatTable.get());
    GpuKey key;
    if (p.variant & variant::heatFace) {
        heatBuffer(c.gpu.cache, *p.heat, {}, key);
        c.texture(faceValueUnit, GL_TEXTURE_BUFFER, c.gpu.cache.bufferTexture(key, GL_R32F));
        const GLuint faces = triangleFaceTexture(c.gpu.cache, *s.layout);
        if (faces) c.texture(triangleFaceUnit, GL_TEXTURE_BUFFER, faces);
        block.ids.z = faces != 0;
        return;
    }
    gl::attribute({4, heatBuffer(c.gpu.cache, *p.heat, s.layout->vertexOf, key), 1});
}

void bindMatcap(DrawContext& c)
{
    constexpr int side = 256;
    const Matcap* m = findMatcap(c.frame.options.matcap);
    if (!m) m = &matcaps().front();
    c.texture(matcapUnit, GL_TEXTURE_2D, c.gpu.cache.picture({{m}, 1}, {}, [&] {
        const DecodedImage image{side, side, matcapPixels(*m, side)};
        return fillTexture(image, {.repeat = false, .color = true});
    }));
}

/// Light at the vertices alone where triangles are small, and nothing asks for more.
unsigned dense(const DrawObject& o, uint32_t slot, unsigned v)
{
    constexpr unsigned byPixel = variant::flat | variant::heat | variant::heatCategory | variant::heatFace | variant::shadow | variant::matcap |
                                 variant::checker | variant::mapBase | variant::mapRoughness | variant::mapNormal | variant::mapOcclusion |
                                 variant::mapEmissive;
    const Material* m = materialOf(o, slot);
    if ((v & byPixel) || ((v & variant::material) && m && !isPlain(*m))) return v;
    return (v & ~variant::material) | variant::dense;
}

/// Opaque runs first over all objects, then what blends.
void drawObject(DrawContext& c, const DrawObject& o, bool blended)
{
    if (o.mesh.faceCount() == 0) return;
    Plan p = planFor(c, o);
    const BoundSurface s = bindSurface(c, o, p.wants);
    TexcoordSets sets = p.wants.texcoordSets;
    for (size_t i = 0; i < 2; ++i)
        if (!s.buffers.texcoords[i]) sets[i] = -1;
    if (s.buffers.colors) p.variant |= variant::color;
    if (p.matcap) bindMatcap(c);
    ObjectBlock block = objectBlockOf(c, o, p.heat);
    if (p.heat) bindHeat(c, p, s, block);
    for (const SurfaceLayout::Run& run : s.layout->runs) {
        ObjectBlock b = block;
        unsigned v = p.variant;
        if (p.pictures) v |= applyMaterial(c, o, run.slot, sets, b);
        if (p.checker && sets[0] >= 0) v |= variant::checker;
        if ((v & variant::mapNormal) && s.buffers.tangents) v |= variant::tangent;
        if ((c.frame.options.xray || b.look.w > 0.5f) != blended) continue;
        if (s.buffers.colors && !materialOf(o, run.slot)) b.baseColor = glm::vec4(1);
        c.use(ProgramId::Surface, o.mesh.faceCount() >= denseFaces ? dense(o, run.slot, v) : v);
        drawRun(c, s, run, b);
    }
}

}  // namespace

BoundSurface bindSurface(DrawContext& c, const DrawObject& o, const SurfaceWants& wants)
{
    BoundSurface s;
    s.layout = c.gpu.layouts.get(o.mesh, wants);
    s.buffers = surfaceBuffers(c.gpu.cache, o.mesh, *s.layout, wants);
    const Posing::Buffers posed = c.gpu.posing.captured(c.gpu.cache, c.gpu.programs, o, *s.layout, s.buffers);
    s.buffers.positions = posed.positions;
    s.buffers.normals = posed.normals;
    c.clearAttributes();
    gl::attribute({0, s.buffers.positions, 3});
    if (s.buffers.normals) gl::attribute({1, s.buffers.normals, 3});
    if (s.buffers.colors) gl::attribute({2, s.buffers.colors, s.buffers.colorComponents, s.buffers.colorStride});
    if (s.buffers.texcoords[0]) gl::attribute({3, s.buffers.texcoords[0], 2, s.buffers.texcoordStride[0]});
    if (s.buffers.texcoords[1]) gl::attribute({5, s.buffers.texcoords[1], 2, s.buffers.texcoordStride[1]});
    if (s.buffers.tangents) gl::attribute({6, s.buffers.tangents, 4});
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, s.buffers.indices);
    glFrontFace(glm::determinant(glm::dmat3(o.worldFromLocal)) < 0 ? GL_CW : GL_CCW);
    return s;
}

void drawRun(DrawContext& c, const BoundSurface& s, const SurfaceLayout::Run& run, ObjectBlock block)
{
    block.ids.y = int(run.first);
    c.setObject(block);
    glDrawElements(GL_TRIANGLES, GLsizei(3 * run.count), GL_UNSIGNED_INT, reinterpret_cast<const void*>(12 * run.first));
    c.counts.triangles += run.count;
    c.counts.vertices += s.buffers.vertices;
}

void drawSurfaces(DrawContext& c)
{
    if (c.frame.options.shading == Shading::Wire) return;
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    for (const DrawObject& o : c.frame.objects) drawObject(c, o, false);
    c.blend();
    glDepthMask(GL_FALSE);
    glEnable(GL_CULL_FACE);
    for (const GLenum side : {GL_FRONT, GL_BACK}) {  // what is behind first
        glCullFace(side);
        for (const DrawObject& o : c.frame.objects) drawObject(c, o, true);
    }
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
}

}  // namespace mw
