// Bones: octahedra with a dark halo, and a disc at each joint, over everything that hides them. They hide each other by depth.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "render/draw_context.h"

namespace mw {
namespace {

constexpr float widest = 0.12f;      // where along a bone it is widest
constexpr float thickness = 0.085f;  // half the width there, of the length
constexpr double frontShare = 0.02;  // of the depth range: before everything else

struct Corner {
    glm::vec3 at;
    glm::vec4 color;  // linear
};

struct Shapes {
    std::vector<Corner> triangles, joints;
    std::vector<glm::vec3> edges;
};

glm::vec3 shownColor(const DrawBone& b)
{
    if (b.selected) return selectedColor;
    return b.hovered ? glm::mix(glm::vec3(b.color), glm::vec3(1), 0.6f) : glm::vec3(b.color);
}

/// Four corners round the widest place, in turn.
void ring(glm::vec3 head, glm::vec3 along, glm::vec3 out[4])
{
    const glm::vec3 d = glm::normalize(along), side = std::abs(d.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 u = glm::normalize(glm::cross(d, side)), v = glm::cross(d, u);
    const float r = thickness * glm::length(along);
    const glm::vec3 middle = head + widest * along;
    for (int i = 0; i < 4; ++i) out[i] = middle + r * (i == 0 ? u : i == 1 ? v : i == 2 ? -u : -v);
}

void addOctahedron(Shapes& shapes, glm::vec3 head, glm::vec3 tail, glm::vec4 color)
{
    if (glm::distance(head, tail) < 1e-9f) return;
    glm::vec3 r[4];
    ring(head, tail - head, r);
    for (int i = 0; i < 4; ++i) {
        const glm::vec3 a = r[i], b = r[(i + 1) % 4];
        for (const glm::vec3 p : {head, b, a, tail, a, b}) shapes.triangles.push_back({p, color});
        for (const glm::vec3 p : {head, a, a, tail, a, b}) shapes.edges.push_back(p);
    }
}

/// Relative to the camera's target, where floats are fine.
Shapes shapesOf(const Frame& frame, glm::dvec3 origin)
{
    Shapes s;
    for (const DrawBone& b : frame.bones) {
        const glm::vec3 head(glm::dvec3(b.head) - origin), tail(glm::dvec3(b.tail) - origin);
        const glm::vec4 color(linearOf(shownColor(b)), 1);
        addOctahedron(s, head, tail, color);
        s.joints.push_back({head, b.selected ? color : glm::mix(color, glm::vec4(1), 0.35f)});
    }
    return s;
}

void drawHalos(DrawContext& c, const Shapes& s, ObjectBlock block)
{
    block.mark = glm::vec4(haloColor, 0.9f);
    block.stroke.x = 0.4f;
    c.setObject(block);
    c.clearAttributes();
    gl::stream(c.gpu.transient, std::span<const glm::vec3>(s.edges));
    gl::attribute({0, c.gpu.transient.get()});
    c.use(ProgramId::Line, variant::halo);
    glDrawArrays(GL_LINES, 0, GLsizei(s.edges.size()));
}

void bindCorners(DrawContext& c, const std::vector<Corner>& corners, GLuint colorLocation)
{
    gl::stream(c.gpu.transient, std::span<const Corner>(corners));
    c.clearAttributes();
    gl::attribute({0, c.gpu.transient.get(), 3, sizeof(Corner)});
    gl::attribute({colorLocation, c.gpu.transient.get(), 4, sizeof(Corner), offsetof(Corner, color)});
}

}  // namespace

void drawBones(DrawContext& c)
{
    if (c.frame.bones.empty()) return;
    const glm::dvec3 origin = c.camera.target;
    const Shapes shapes = shapesOf(c.frame, origin);
    ObjectBlock block = c.blockOf(glm::translate(glm::dmat4(1), origin));
    block.look = {0, 0.94f, 0, 0};
    block.baseColor = glm::vec4(1.15f);
    block.surface = {0, 0.6f, 0.06f, -1};
    c.blend();
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glDepthRange(0, frontShare);
    glDepthMask(GL_FALSE);
    if (!shapes.edges.empty()) drawHalos(c, shapes, block);
    glDepthMask(GL_TRUE);
    bindCorners(c, shapes.triangles, 2);
    c.use(ProgramId::Surface, variant::flat | variant::color);
    c.setObject(block);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(shapes.triangles.size()));
    glDepthMask(GL_FALSE);
    bindCorners(c, shapes.joints, 1);
    block.mark = glm::vec4(1);
    block.stroke = {5, 0, 0, 0};
    c.use(ProgramId::Disc, variant::pointColor);
    c.setObject(block);
    glDrawArrays(GL_POINTS, 0, GLsizei(shapes.joints.size()));
    glDepthMask(GL_TRUE);
    glDepthRange(0, 1);
}

}  // namespace mw
