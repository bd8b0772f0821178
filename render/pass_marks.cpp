// Marked elements: tinted or hatched faces, wide lines and discs with a dark halo. All halos come before all cores, so that joints of lines
// stay clean.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "render/draw_context.h"

namespace mw {
namespace {

uint64_t hashOf(const Mark& m, const Mesh& mesh)
{
    uint64_t h = 0x9e3779b97f4a7c15ull ^ (uint64_t(m.kind) << 56) ^ mesh.vertexCount();
    const auto mix = [&h](uint64_t x) {
        h = (h ^ x) * 0xff51afd7ed558ccdull;
        h ^= h >> 32;
    };
    for (const uint32_t i : m.indices) mix(i);
    mix(m.indices.size());
    return h | 1;
}

void addFace(const Mesh& mesh, uint32_t face, std::vector<uint32_t>& out)
{
    const Mesh::Triangulation& t = mesh.triangulation();
    const auto [first, last] = std::equal_range(t.faces.begin(), t.faces.end(), face);
    const size_t a = 3 * size_t(first - t.faces.begin()), b = 3 * size_t(last - t.faces.begin());
    out.insert(out.end(), t.vertices.begin() + a, t.vertices.begin() + b);
}

/// Vertex indices to draw; what the mesh does not have (any more) is left out.
std::vector<uint32_t> drawnIndices(const Mark& m, const Mesh& mesh)
{
    std::vector<uint32_t> out;
    const size_t vertices = mesh.vertexCount();
    if (m.kind == ElementKind::Face) {
        for (const uint32_t f : m.indices)
            if (f < mesh.faceCount()) addFace(mesh, f, out);
    } else if (m.kind == ElementKind::Edge) {
        for (size_t i = 0; i + 1 < m.indices.size(); i += 2)
            if (m.indices[i] < vertices && m.indices[i + 1] < vertices) out.insert(out.end(), {m.indices[i], m.indices[i + 1]});
    } else if (m.kind == ElementKind::Vertex) {
        for (const uint32_t v : m.indices)
            if (v < vertices) out.push_back(v);
    }
    return out;
}

struct Prepared {
    const Mark* mark;
    const DrawObject* object;
    GLuint indices;
    GLsizei count;
    ObjectBlock block;
};

Prepared prepare(DrawContext& c, const Mark& m, const DrawObject& o)
{
    Prepared p{&m, &o, 0, 0, c.blockOf(o.worldFromLocal)};
    const GpuKey key{{o.mesh.cornerVertex().id(), o.mesh.faceStart().id()}, hashOf(m, o.mesh)};
    p.indices = c.gpu.cache.made(key, {}, [&] { return drawnIndices(m, o.mesh); });
    p.count = GLsizei(c.gpu.cache.bytesOf(key) / sizeof(uint32_t));
    p.block.mark = m.color;
    const bool plus = m.style == Mark::Style::Plus;
    const float style = m.style == Mark::Style::Dashed ? 1.f : m.style == Mark::Style::Hatched ? 2.f : plus ? 3.f : 0.f;
    p.block.stroke = {m.width, style, m.through ? 1.f : 0.f, 0};
    return p;
}

void draw(DrawContext& c, const Prepared& p, GLenum primitive)
{
    if (p.count == 0) return;
    c.clearAttributes();
    gl::attribute({0, c.positions(*p.object)});
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, p.indices);
    glDepthFunc(p.mark->through ? GL_ALWAYS : GL_LEQUAL);
    c.setObject(p.block);
    glDrawElements(primitive, p.count, GL_UNSIGNED_INT, nullptr);
}

void drawFaces(DrawContext& c, const std::vector<Prepared>& marks)
{
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1, -2);
    c.use(ProgramId::FaceMark);
    for (const Prepared& p : marks)
        if (p.mark->kind == ElementKind::Face) draw(c, p, GL_TRIANGLES);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void drawEdges(DrawContext& c, const std::vector<Prepared>& marks)
{
    for (const bool halo : {true, false}) {
        c.use(ProgramId::Line, halo ? variant::halo : 0);
        for (const Prepared& p : marks)
            if (p.mark->kind == ElementKind::Edge) draw(c, p, GL_LINES);
    }
}

void drawVertices(DrawContext& c, const std::vector<Prepared>& marks)
{
    c.use(ProgramId::Disc);
    for (const Prepared& p : marks)
        if (p.mark->kind == ElementKind::Vertex) draw(c, p, GL_POINTS);
}

/// Points and segments given by place. Relative to the camera's target, where floats are fine.
void drawPlaces(DrawContext& c)
{
    const glm::dvec3 origin = c.camera.target;
    const auto one = [&](const MarkPoint& m, unsigned variant, ProgramId program, GLenum primitive, std::span<const glm::vec3> at, float width) {
        ObjectBlock b = c.blockOf(glm::translate(glm::dmat4(1), origin));
        b.mark = m.color;
        b.stroke = {width, m.dashed && primitive == GL_LINES ? 1.f : 0.f, m.through ? 1.f : 0.f, 0};
        c.use(program, variant);
        c.setObject(b);
        gl::stream(c.gpu.transient, at);
        c.clearAttributes();
        gl::attribute({0, c.gpu.transient.get()});
        glDepthFunc(m.through ? GL_ALWAYS : GL_LEQUAL);
        glDrawArrays(primitive, 0, GLsizei(at.size()));
    };
    for (const MarkPoint& m : c.frame.points) {
        const glm::vec3 at(glm::dvec3(m.atWorld) - origin);
        if (!m.toWorld) {
            one(m, 0, ProgramId::Disc, GL_POINTS, std::span(&at, 1), m.diameter);
            continue;
        }
        const glm::vec3 ends[] = {at, glm::vec3(glm::dvec3(*m.toWorld) - origin)};
        one(m, variant::halo, ProgramId::Line, GL_LINES, ends, m.diameter);
        one(m, 0, ProgramId::Line, GL_LINES, ends, m.diameter);
    }
}

}  // namespace

void drawMarks(DrawContext& c)
{
    std::vector<Prepared> marks;
    for (const Mark& m : c.frame.marks) {
        const DrawObject* o = m.indices.empty() ? nullptr : c.object(m.node);
        if (o) marks.push_back(prepare(c, m, *o));
    }
    if (marks.empty() && c.frame.points.empty()) return;
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    c.blend();
    drawFaces(c, marks);
    drawEdges(c, marks);
    drawVertices(c, marks);
    drawPlaces(c);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LEQUAL);
}

}  // namespace mw
