// The gradient behind everything, and the ground.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "render/draw_context.h"

namespace mw {
namespace {

constexpr int halfLines = 36;  // to each side of the middle

/// Lines of one spacing round the middle as pairs of ends; the axes themselves are left out.
void addLines(std::vector<glm::vec3>& out, glm::dvec3 middle, double spacing, bool skipTenth)
{
    const double x0 = std::round(middle.x / spacing), z0 = std::round(middle.z / spacing), reach = halfLines * spacing;
    for (int i = -halfLines; i <= halfLines; ++i) {
        for (const bool alongX : {false, true}) {
            const double line = (alongX ? z0 : x0) + i;
            if (line == 0 || (skipTenth && std::fmod(line, 10) == 0)) continue;
            const double at = line * spacing;
            const glm::dvec3 a = alongX ? glm::dvec3(middle.x - reach, 0, at) : glm::dvec3(at, 0, middle.z - reach);
            const glm::dvec3 b = alongX ? glm::dvec3(middle.x + reach, 0, at) : glm::dvec3(at, 0, middle.z + reach);
            out.emplace_back(a - middle);
            out.emplace_back(b - middle);
        }
    }
}

struct GridLook {
    glm::dvec3 middle;
    double reach;
};

void drawLines(DrawContext& c, const GridLook& look, std::span<const glm::vec3> points, glm::vec4 color, float width)
{
    if (points.empty() || color.a <= 0.01f) return;
    ObjectBlock b = c.blockOf(glm::translate(glm::dmat4(1), look.middle));
    b.mark = color;
    b.stroke = {width, 0, 1, 0};
    b.heat = glm::vec4(1 / look.reach, glm::vec3(c.viewFromWorld * glm::dvec4(look.middle, 1)));
    c.setObject(b);
    gl::stream(c.gpu.transient, points);
    c.clearAttributes();
    gl::attribute({0, c.gpu.transient.get()});
    glDrawArrays(GL_LINES, 0, GLsizei(points.size()));
}

}  // namespace

void drawBackground(DrawContext& c)
{
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    if (c.frame.options.transparentBackground) return;
    c.use(ProgramId::Background);
    c.clearAttributes();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void drawGrid(DrawContext& c)
{
    const ViewOptions& options = c.frame.options;
    if ((!options.grid && !options.axes) || !c.frame.terrains.empty()) return;  // a terrain is the ground
    // Spacing follows the distance in powers of ten; the finer lines fade in as one comes closer.
    const double scale = std::log10(c.camera.distance * 0.45), level = std::floor(scale), fine = std::pow(10, level - 1);
    const double closeness = 1 - (scale - level);
    const glm::dvec3 middle(c.camera.target.x, 0, c.camera.target.z);
    const GridLook look{middle, 2.6 * c.camera.distance};
    const ThemeColors& theme = themeColors(options.theme);
    const bool fromBelow = c.camera.eye().y < 0;
    // Seen from below or edge on it steps back.
    const float strength = (fromBelow ? 0.25f : 1.f) * float(glm::smoothstep(0.0, 0.2, std::abs(std::sin(c.camera.elevation))));

    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    c.blend();
    c.use(ProgramId::Line);
    std::vector<glm::vec3> points;
    if (options.grid) {
        addLines(points, middle, fine, true);
        drawLines(c, {middle, std::min(look.reach, halfLines * fine)}, points, {theme.grid, 0.6f * strength * float(closeness)}, 1);
        points.clear();
        addLines(points, middle, 10 * fine, false);
        drawLines(c, look, points, {theme.grid, 0.8f * strength}, 1);
    }
    if (options.axes) {
        const double reach = look.reach;
        const std::vector<glm::vec3> x{glm::vec3(-middle.x - reach, 0, -middle.z), glm::vec3(-middle.x + reach, 0, -middle.z)};
        const std::vector<glm::vec3> z{glm::vec3(-middle.x, 0, -middle.z - reach), glm::vec3(-middle.x, 0, -middle.z + reach)};
        drawLines(c, look, x, {hex(0xC4525A), 0.85f * strength}, 1.4f);
        drawLines(c, look, z, {hex(0x4A7FC4), 0.85f * strength}, 1.4f);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace mw
