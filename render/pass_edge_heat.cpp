// Values of edges as colours: thick lines over the shaded surface.
#include "render/draw_context.h"
#include "render/heat_values.h"

namespace mw {
namespace {

/// In pixels: few edges may be thick; many would cover each other.
float widthFor(size_t edges)
{
    return edges <= 4000 ? 4.f : edges <= 40'000 ? 2.6f : 1.5f;
}

void drawEdges(DrawContext& c, const DrawObject& o, const HeatMap& heat)
{
    const Array<uint32_t>& ends = heat.table->edges;
    if (ends.empty() || ends.size() / 2 > size_t(c.gpu.maxTextureBuffer)) return;
    GpuKey key;
    heatBuffer(c.gpu.cache, heat, {}, key);
    c.texture(heatUnit, GL_TEXTURE_2D, c.gpu.heatTable.get());
    c.texture(faceValueUnit, GL_TEXTURE_BUFFER, c.gpu.cache.bufferTexture(key, GL_R32F));
    const GLuint lines = c.gpu.cache.made({{heat.table.get(), nullptr}, 99}, {heat.table}, [&] {
        Array<uint32_t> out(ends.begin(), ends.end());
        for (uint32_t& v : out) v = v < o.mesh.vertexCount() ? v : 0;
        return out;
    });
    c.use(ProgramId::Line, variant::lineHeat);
    c.clearAttributes();
    gl::attribute({0, c.positions(o)});
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, lines);
    ObjectBlock b = c.blockOf(o.worldFromLocal);
    b.mark = glm::vec4(1, 1, 1, o.dimmed ? 0.35f : 1.f);
    b.stroke.x = widthFor(ends.size() / 2);
    b.heat = heatUniform(heat);
    c.setObject(b);
    glDrawElements(GL_LINES, GLsizei(ends.size()), GL_UNSIGNED_INT, nullptr);
    c.counts.vertices += ends.size();
}

}  // namespace

void drawEdgeHeat(DrawContext& c)
{
    glEnable(GL_DEPTH_TEST);
    c.blend();
    for (const DrawObject& o : c.frame.objects)
        if (const HeatMap* heat = heatOf(o, ElementKind::Edge)) drawEdges(c, o, *heat);
}

}  // namespace mw
