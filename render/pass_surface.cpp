// Shaded triangles: clay, vertex colours, textures and metal, or values as colours.
#include <algorithm>
#include <cmath>

#include "render/draw_context.h"
#include "render/image.h"

namespace mw {
namespace {

constexpr glm::vec4 clay{0.60f, 0.60f, 0.61f, 1};
constexpr size_t denseFaces = 200'000;  // from here on triangles are a few pixels at most, and light at the vertices is enough
constexpr float backFaceTint = 0.28f;
constexpr double undefinedValue = -1e38;

const HeatMap* heatOf(const DrawObject& o)
{
    const HeatMap* h = o.heat.get();
    if (!h || !h->table || h->column >= h->table->columns.size()) return nullptr;
    const size_t n = h->table->columns[h->column].values.size();
    const ElementKind rows = h->table->rows;
    const bool fits = (rows == ElementKind::Vertex && n == o.mesh.vertexCount()) || (rows == ElementKind::Face && n == o.mesh.faceCount());
    return fits ? h : nullptr;
}

float heatFloat(double v)
{
    return float(std::isfinite(v) ? std::clamp(v, -9e29, 9e29) : undefinedValue);
}

/// Values of a column for each drawn vertex, or each face.
GLuint heatBuffer(GpuCache& cache, const HeatMap& h, const Shared<uint32_t>& vertexOf, GpuKey& key)
{
    key = {{h.table.get(), vertexOf.id()}, 100 + h.column};
    return cache.made(key, {h.table, vertexOf.owner()}, [&] {
        const Array<double>& values = h.table->columns[h.column].values;
        Array<float> out(vertexOf.empty() ? values.size() : vertexOf.size());
        for (size_t i = 0; i < out.size(); ++i) out[i] = heatFloat(values[vertexOf.empty() ? i : vertexOf[i]]);
        return out;
    });
}

glm::vec4 heatUniform(const HeatMap& h)
{
    const double span = h.high - h.low;
    const HeatRow row = heatRow(h);
    const double scale = span > 0 ? 1 / span : 0;
    return {float(scale), float(span > 0 ? -h.low * scale : 0.5), row == categoryRow ? float(categoryCount) : 0.f, float(row)};
}

const Material* materialOf(const DrawObject& o, uint32_t slot)
{
    return slot < o.materials.size() ? o.materials[slot].get() : nullptr;
}

GLuint baseTexture(DrawContext& c, const DrawObject& o, uint32_t slot)
{
    if (slot >= o.baseImages.size() || !o.baseImages[slot] || !o.baseImages[slot]->bytes) return 0;
    const Material* m = materialOf(o, slot);
    return imageTexture(c.gpu.cache, *o.baseImages[slot], !m || m->baseColorTexture.repeat);
}

/// Which texture coordinates the object's materials ask for; -1 for none.
int texcoordSet(const DrawObject& o)
{
    for (uint32_t slot = 0; slot < o.materials.size(); ++slot)
        if (slot < o.baseImages.size() && o.baseImages[slot]) return o.materials[slot] ? o.materials[slot]->baseColorTexture.set : 0;
    return -1;
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

/// What a material changes; returns the variant bits it needs.
unsigned applyMaterial(DrawContext& c, const DrawObject& o, uint32_t slot, bool texcoords, ObjectBlock& b)
{
    const Material* m = materialOf(o, slot);
    if (!m) return 0;
    b.baseColor = m->baseColor;
    b.surface.x = float(m->metallic);
    b.surface.y = float(m->roughness);
    if (m->alpha == Material::Alpha::Mask) b.surface.w = float(m->alphaCutoff);
    if (m->alpha == Material::Alpha::Blend && !c.frame.options.xray) b.look.w = 1;
    const GLuint texture = texcoords ? baseTexture(c, o, slot) : 0;
    if (!texture && m->metallic < 0.01 && m->roughness > 0.35 && m->alpha == Material::Alpha::Opaque) return 0;
    b.surface.z = 1;
    c.texture(baseColorUnit, GL_TEXTURE_2D, texture ? texture : whiteTexture(c.gpu.cache));
    return variant::material;
}

struct Plan {
    const HeatMap* heat;
    SurfaceWants wants;
    unsigned variant = 0;
};

Plan planFor(const DrawContext& c, const DrawObject& o)
{
    Plan p;
    p.heat = heatOf(o);
    const bool flatShading = c.frame.options.shading == Shading::Flat;
    p.wants.normals = !flatShading;
    p.wants.colors = !p.heat;
    p.wants.texcoordSet = p.heat ? -1 : texcoordSet(o);
    p.wants.slots = p.heat ? 1 : std::max<size_t>(o.materials.size(), 1);
    if (flatShading) p.variant |= variant::flat;
    if (o.dimmed) p.variant |= variant::dimmed;
    if (p.heat) {
        const bool categories = heatRow(*p.heat) == categoryRow;
        p.variant |= p.heat->table->rows == ElementKind::Face ? variant::heatFace : categories ? variant::heatCategory : variant::heat;
    }
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

/// Opaque runs first over all objects, then what blends.
void drawObject(DrawContext& c, const DrawObject& o, bool blended)
{
    if (o.mesh.faceCount() == 0) return;
    Plan p = planFor(c, o);
    const BoundSurface s = bindSurface(c, o, p.wants);
    if (s.buffers.colors) p.variant |= variant::color;
    ObjectBlock block = objectBlockOf(c, o, p.heat);
    if (p.heat) bindHeat(c, p, s, block);
    for (const SurfaceLayout::Run& run : s.layout->runs) {
        ObjectBlock b = block;
        const unsigned extra = p.heat ? 0 : applyMaterial(c, o, run.slot, s.buffers.texcoords != 0, b);
        if ((c.frame.options.xray || b.look.w > 0.5f) != blended) continue;
        if (s.buffers.colors && !materialOf(o, run.slot)) b.baseColor = glm::vec4(1);
        const bool dense = o.mesh.faceCount() >= denseFaces && !(extra & variant::material) && !p.heat && !(p.variant & variant::flat);
        c.use(ProgramId::Surface, p.variant | extra | (dense ? variant::dense : 0));
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
    if (s.buffers.texcoords) gl::attribute({3, s.buffers.texcoords, 2, s.buffers.texcoordStride});
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
