// Wires over surfaces, and what belongs to no face: loose lines, points, needles of normals.
#include <algorithm>

#include "render/draw_context.h"
#include "render/heat_values.h"

namespace mw {
namespace {

void drawWire(DrawContext& c, const DrawObject& o, glm::vec4 color)
{
    SurfaceWants wants;
    wants.normals = wants.colors = false;
    const BoundSurface s = bindSurface(c, o, wants);
    const GLuint flags = edgeFlagTexture(c.gpu.cache, o.mesh, *s.layout);
    if (flags) c.texture(edgeFlagUnit, GL_TEXTURE_BUFFER, flags);
    c.use(ProgramId::Wire, flags ? variant::edgeFlags : 0);
    ObjectBlock block = c.blockOf(o.worldFromLocal);
    block.mark = color;
    if (o.dimmed) block.mark.a *= 0.35f;
    block.stroke.x = 1.2f;
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-0.5f, -2);
    const Renderer::Counts before = c.counts;  // the same triangles again
    for (const SurfaceLayout::Run& run : s.layout->runs) drawRun(c, s, run, block);
    c.counts = before;
    glDisable(GL_POLYGON_OFFSET_FILL);
}

/// Wires alone: what faces away is paler, so that near and far can be told apart.
void drawWireShading(DrawContext& c)
{
    const ThemeColors& theme = themeColors(c.frame.options.theme);
    glEnable(GL_CULL_FACE);
    glDepthMask(GL_FALSE);
    for (const bool front : {false, true}) {
        glCullFace(front ? GL_BACK : GL_FRONT);
        for (const DrawObject& o : c.frame.objects) {
            const glm::vec3 color = o.selected ? selectedColor : o.hovered ? theme.text : theme.text2;
            if (o.mesh.faceCount()) drawWire(c, o, {color, front ? 0.95f : 0.28f});
        }
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_CULL_FACE);
}

void drawLooseLines(DrawContext& c, const DrawObject& o)
{
    const Shared<uint32_t>& lines = o.mesh.lines();
    if (lines.empty()) return;
    const ThemeColors& theme = themeColors(c.frame.options.theme);
    c.use(ProgramId::Line);
    c.clearAttributes();
    gl::attribute({0, c.positions(o)});
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, c.gpu.cache.buffer(lines));
    ObjectBlock b = c.blockOf(o.worldFromLocal);
    b.mark = glm::vec4(o.selected ? selectedColor : theme.text2, o.dimmed ? 0.35f : 1.f);
    b.stroke.x = 1.5f;
    c.setObject(b);
    glDrawElements(GL_LINES, GLsizei(lines.size()), GL_UNSIGNED_INT, nullptr);
    c.counts.vertices += lines.size();
}

void drawPoints(DrawContext& c, const DrawObject& o)
{
    if (!hasLoosePoints(o.mesh)) return;
    const ThemeColors& theme = themeColors(c.frame.options.theme);
    ObjectBlock b = c.blockOf(o.worldFromLocal);
    b.mark = glm::vec4(o.selected ? selectedColor : theme.text2, o.dimmed ? 0.35f : 1.f);
    b.stroke = {o.mesh.vertexCount() > 20000 ? 3.f : 5.f, 0, 0, 1};
    c.clearAttributes();
    gl::attribute({0, c.positions(o)});
    const Attribute* color = o.selected ? nullptr : o.mesh.find(names::color, Domain::Vertex);
    const Shared<float>* values = color ? std::get_if<Shared<float>>(&color->values) : nullptr;
    if (values) {
        gl::attribute({1, c.gpu.cache.buffer(*values), std::min(color->components, 4), 4 * color->components});
        b.mark = glm::vec4(1);
    }
    c.use(ProgramId::Disc, values ? variant::pointColor : 0);
    c.setObject(b);
    glDrawArrays(GL_POINTS, 0, GLsizei(o.mesh.vertexCount()));
    c.counts.vertices += o.mesh.vertexCount();
}

constexpr uint64_t useFaceNeedles = 400;

/// Their colour; their length is a share of the size of the mesh.
void setNeedles(DrawContext& c, const DrawObject& o, glm::vec3 color)
{
    ObjectBlock b = c.blockOf(o.worldFromLocal);
    b.mark = glm::vec4(color, 0.9f);
    b.stroke = {1, 0, 0, float(0.02 * o.mesh.bounds().diagonal() * glm::length(glm::dvec3(o.worldFromLocal[0])))};
    c.setObject(b);
}

void drawNeedles(DrawContext& c, const DrawObject& o)
{
    const Bounds bounds = o.mesh.bounds();
    if (bounds.empty || o.mesh.faceCount() == 0) return;
    c.use(ProgramId::Needle);
    c.clearAttributes();
    SurfaceBuffers rest;
    rest.positions = c.gpu.cache.buffer(o.mesh.positions());
    const Attribute* own = o.mesh.find(names::normal, Domain::Vertex);
    const Shared<float>* values = own && own->components == 3 ? std::get_if<Shared<float>>(&own->values) : nullptr;
    rest.normals = values ? c.gpu.cache.buffer(*values) : c.gpu.cache.buffer(o.mesh.vertexNormals());
    rest.vertices = o.mesh.vertexCount();
    const Posing::Buffers posed = c.gpu.posing.captured(c.gpu.cache, c.gpu.programs, o, {}, rest);
    gl::attribute({0, posed.positions, 3, 0, 0, 1});
    gl::attribute({1, posed.normals, 3, 0, 0, 1});
    setNeedles(c, o, hex(0x6CB2FF));
    glDrawArraysInstanced(GL_LINES, 0, 2, GLsizei(o.mesh.vertexCount()));
}

/// Of a mesh as it is: a posed one has no faces on this side of the graphics card.
void drawFaceNeedles(DrawContext& c, const DrawObject& o)
{
    const Mesh& m = o.mesh;
    if (o.pose || m.bounds().empty || m.faceCount() == 0) return;
    const GpuKey key{{m.positions().id(), m.cornerVertex().id(), m.faceStart().id()}, useFaceNeedles};
    const Owners owners{m.positions().owner(), m.cornerVertex().owner(), m.faceStart().owner()};
    const GLuint buffer = c.gpu.cache.made(key, owners, [&] {
        std::vector<glm::vec3> needles;  // middle and normal of each face
        needles.reserve(2 * m.faceCount());
        for (size_t f = 0; f < m.faceCount(); ++f) {
            glm::dvec3 sum(0);
            for (const uint32_t v : m.face(f)) sum += glm::dvec3(m.positions()[v]);
            needles.emplace_back(sum / double(std::max<size_t>(1, m.face(f).size())));
            needles.push_back(m.faceNormals()[f]);
        }
        return needles;
    });
    c.use(ProgramId::Needle);
    c.clearAttributes();
    gl::attribute({0, buffer, 3, 24, 0, 1});
    gl::attribute({1, buffer, 3, 24, 12, 1});
    setNeedles(c, o, hex(0xF2B84B));
    glDrawArraysInstanced(GL_LINES, 0, 2, GLsizei(m.faceCount()));
}

}  // namespace

bool hasLoosePoints(const Mesh& mesh)
{
    return mesh.faceCount() == 0 && mesh.lines().empty() && mesh.vertexCount() > 0;
}

void drawWires(DrawContext& c)
{
    glEnable(GL_DEPTH_TEST);
    c.blend();
    drawTerrainWires(c);
    if (c.frame.options.shading == Shading::Wire) return drawWireShading(c);
    if (!c.frame.options.wireOverlay) return;
    const ThemeColors& theme = themeColors(c.frame.options.theme);
    glDepthMask(GL_FALSE);
    for (const DrawObject& o : c.frame.objects)
        if (o.mesh.faceCount() && !heatOf(o, ElementKind::Edge)) drawWire(c, o, {theme.wire, o.heat ? 0.45f : 0.7f});
    glDepthMask(GL_TRUE);
}

void drawLoose(DrawContext& c)
{
    glEnable(GL_DEPTH_TEST);
    c.blend();
    for (const DrawObject& o : c.frame.objects) {
        drawLooseLines(c, o);
        drawPoints(c, o);
        if (c.frame.options.normalsNeedles) drawNeedles(c, o);
        if (c.frame.options.faceNeedles) drawFaceNeedles(c, o);
    }
}

}  // namespace mw
