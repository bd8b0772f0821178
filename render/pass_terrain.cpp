// Terrains: patches of the ground, tessellated by their distance, lifted by the height map, coloured by height and slope.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "render/draw_context.h"
#include "render/terrain_levels.h"

namespace mw {
namespace {

// A software renderer takes time by the square of what one draw makes of its patches.
constexpr size_t patchesADraw = 64, trianglesADraw = 16384;
constexpr glm::vec4 clay{0.60f, 0.60f, 0.61f, 1};

/// As in resources/shaders/terrain.glsl.
struct TerrainBlock {
    glm::vec4 ground, samples, bands, patches, brush, eyeAt;
};

/// A box of local space that no part of lies before the camera.
bool outside(const glm::dmat4& clipFromLocal, glm::dvec3 low, glm::dvec3 high)
{
    std::array<glm::dvec4, 8> corners;
    for (size_t i = 0; i < 8; ++i) corners[i] = clipFromLocal * glm::dvec4(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z, 1);
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0})
            if (std::all_of(corners.begin(), corners.end(), [&](const glm::dvec4& p) { return sign * p[axis] > p.w; })) return true;
    return false;
}

/// Least and greatest height within a rectangle of shares, by whole tiles.
std::pair<float, float> rangeIn(const HeightMap& map, glm::dvec2 low, glm::dvec2 high)
{
    const auto index = [](double share, uint32_t samples) { return uint32_t(share * (samples - 1)) / HeightMap::tileSize; };
    std::pair<float, float> r = map.range(index(low.x, map.width()), index(low.y, map.height()));
    for (uint32_t ty = index(low.y, map.height()); ty <= index(high.y, map.height()); ++ty)
        for (uint32_t tx = index(low.x, map.width()); tx <= index(high.x, map.width()); ++tx) {
            const auto [a, b] = map.range(tx, ty);
            r = {std::min(r.first, a), std::max(r.second, b)};
        }
    return r;
}

TerrainBlock blockOf(const DrawContext& c, const DrawTerrain& d, const HeightTexture& heights, const TerrainLevels& levels)
{
    const Terrain& t = d.terrain;
    const glm::dvec2 size = t.size();
    const double stride = heights.stride();
    TerrainBlock b;
    b.ground = {size.x, size.y, t.maximumHeight, t.waterLevel};
    b.samples = {heights.size().x, heights.size().y, (t.map.width() - 1) / stride, (t.map.height() - 1) / stride};
    b.bands = {t.layers.sandTo, t.layers.grassTo, t.layers.snowFrom, std::cos(t.layers.rockSlope * std::numbers::pi / 180)};
    b.patches = {levels.columns, levels.rows, int(d.overlay), d.textured ? 1 : 0};
    b.brush = d.brush ? glm::vec4(d.brush->at, d.brush->radius, d.brush->halfStrengthAt) : glm::vec4(0);
    const glm::dmat4 localFromWorld = glm::inverse(d.worldFromLocal);
    const glm::dvec3 eye(localFromWorld * glm::dvec4(c.camera.eye(), 1)), middle(localFromWorld * glm::dvec4(c.camera.target, 1));
    b.eyeAt = c.camera.perspective ? glm::vec4(eye, glm::distance(eye, middle)) : glm::vec4(glm::normalize(eye - middle), 0);
    return b;
}

/// One terrain, bound: what its patches are and which of them may be seen, the nearest first, so that they hide what lies behind.
struct BoundTerrain {
    TerrainLevels levels;
    std::vector<size_t> seen;
};

BoundTerrain bindTerrain(DrawContext& c, const DrawTerrain& d)
{
    BoundTerrain b;
    HeightTexture& heights = c.gpu.terrains.heights(d.node.value, d.terrain.map);
    b.levels = levelsOf(d.terrain, d.worldFromLocal, c.camera.eye());
    const glm::dmat4 clipFromLocal = c.clipFromView * c.viewFromWorld * d.worldFromLocal;
    const glm::dvec2 size = d.terrain.size(), patches(b.levels.columns, b.levels.rows);
    for (int row = 0; row < b.levels.rows; ++row) {
        for (int column = 0; column < b.levels.columns; ++column) {
            const glm::dvec2 low = glm::dvec2(column, row) / patches, high = glm::dvec2(column + 1, row + 1) / patches;
            const auto [least, most] = rangeIn(d.terrain.map, low, high);
            const double y0 = d.terrain.maximumHeight * least, y1 = d.terrain.maximumHeight * most, water = d.terrain.waterLevel;
            if (!outside(clipFromLocal, {(low.x - 0.5) * size.x, std::max(std::min(y0, y1), water), (low.y - 0.5) * size.y},
                         {(high.x - 0.5) * size.x, std::max({y0, y1, water}), (high.y - 0.5) * size.y}))
                b.seen.push_back(b.levels.patch(column, row));
        }
    }
    std::sort(b.seen.begin(), b.seen.end(),
              [&](size_t p, size_t q) { return std::pair(b.levels.distance[p], p) < std::pair(b.levels.distance[q], q); });
    const TerrainBlock block = blockOf(c, d, heights, b.levels);
    gl::stream(c.gpu.terrainBlock, std::span(&block, 1), GL_UNIFORM_BUFFER);
    glBindBufferBase(GL_UNIFORM_BUFFER, terrainBlock, c.gpu.terrainBlock.get());
    c.texture(heightUnit, GL_TEXTURE_2D, heights.id());
    glFrontFace(glm::determinant(glm::dmat3(d.worldFromLocal)) < 0 ? GL_CW : GL_CCW);
    return b;
}

/// Draws patches of a bound terrain with the program in use.
void drawPatches(DrawContext& c, const TerrainLevels& levels, std::span<const size_t> patches)
{
    constexpr std::array<glm::ivec2, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    if (patches.empty()) return;
    std::vector<glm::vec4> points;
    std::vector<GLint> first;
    std::vector<GLsizei> count;
    size_t drawn = trianglesADraw;
    for (const size_t p : patches) {
        if (drawn >= trianglesADraw || count.back() >= GLsizei(4 * patchesADraw)) {
            first.push_back(GLint(points.size()));
            count.push_back(0);
            drawn = 0;
        }
        count.back() += 4;
        drawn += levels.triangles(p);
        const glm::ivec2 at(int(p) % levels.columns, int(p) / levels.columns);
        for (size_t i = 0; i < 4; ++i) points.emplace_back(glm::ivec2(at + corners[i]), levels.outer[4 * p + i], levels.inner[p]);
        c.counts.triangles += levels.triangles(p);
    }
    c.counts.vertices += points.size();
    c.clearAttributes();
    gl::stream(c.gpu.transient, std::span<const glm::vec4>(points));
    gl::attribute({0, c.gpu.transient.get(), 4});
    glPatchParameteri(GL_PATCH_VERTICES, 4);
    glMultiDrawArrays(GL_PATCHES, first.data(), count.data(), GLsizei(first.size()));
}

unsigned variantOf(const DrawContext& c, const DrawTerrain& d)
{
    unsigned v = 0;
    if (c.frame.options.shading == Shading::Flat) v |= variant::flat;
    if (!d.textured || d.overlay == DrawTerrain::Overlay::Level || d.overlay == DrawTerrain::Overlay::Slope) v |= variant::plain;
    if (d.overlay == DrawTerrain::Overlay::PatchBorders || d.overlay == DrawTerrain::Overlay::Level) v |= variant::borders;
    if (d.brush) v |= variant::brush;
    return v;
}

/// Patches in groups that need the same of the program: wet ones, and those with a vertex a sample.
void drawSurface(DrawContext& c, const DrawTerrain& d, const ObjectBlock& block)
{
    const BoundTerrain b = bindTerrain(c, d);
    std::map<unsigned, std::vector<size_t>> groups;
    const unsigned common = variantOf(c, d);
    for (const size_t p : b.seen) {
        unsigned v = common;
        const glm::dvec2 low(int(p) % b.levels.columns, int(p) / b.levels.columns), patches(b.levels.columns, b.levels.rows);
        const auto [least, most] = rangeIn(d.terrain.map, low / patches, (low + 1.0) / patches);
        const double margin = 0.03 * std::abs(d.terrain.maximumHeight);  // damp ground above the shore
        if (!(v & variant::plain) && d.terrain.maximumHeight * least < d.terrain.waterLevel + margin) v |= variant::water;
        if (!(v & variant::flat) && 2 * b.levels.inner[p] * b.levels.columns >= int(d.terrain.map.width() - 1)) v |= variant::denseGround;
        groups[v].push_back(p);
    }
    c.setObject(block);
    for (const auto& [v, patches] : groups) {
        c.use(ProgramId::Terrain, v);
        drawPatches(c, b.levels, patches);
    }
}

void drawPlaces(DrawContext& c, const DrawTerrain& d, ProgramId program, const ObjectBlock& block)
{
    if (d.terrain.map.empty()) return;
    const BoundTerrain b = bindTerrain(c, d);
    c.use(program);
    c.setObject(block);
    drawPatches(c, b.levels, b.seen);
}

void drawWire(DrawContext& c, const DrawTerrain& d, glm::vec4 color)
{
    ObjectBlock block = c.blockOf(d.worldFromLocal);
    block.mark = color;
    block.stroke.x = 1.2f;
    const Renderer::Counts before = c.counts;  // the same triangles again
    drawPlaces(c, d, ProgramId::TerrainWire, block);
    if (c.frame.options.shading != Shading::Wire) c.counts = before;
}

/// Lines of the ground in front only: behind a hill there is nothing to be told by them.
void drawWireStyle(DrawContext& c, const DrawTerrain& d)
{
    const ThemeColors& theme = themeColors(c.frame.options.theme);
    const Renderer::Counts before = c.counts;
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1, 2);
    drawPlaces(c, d, ProgramId::TerrainIds, c.blockOf(d.worldFromLocal));
    glDisable(GL_POLYGON_OFFSET_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    c.counts = before;
    glDepthMask(GL_FALSE);
    drawWire(c, d, {d.selected ? selectedColor : d.hovered ? theme.text : theme.text2, 0.95f});
    glDepthMask(GL_TRUE);
}

}  // namespace

void drawTerrains(DrawContext& c)
{
    if (c.frame.terrains.empty() || c.frame.options.shading == Shading::Wire) return;
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    const bool mask = !c.frame.options.transparentBackground;
    for (const DrawTerrain& d : c.frame.terrains) {
        if (d.terrain.map.empty()) continue;
        c.texture(layerUnit, GL_TEXTURE_2D, c.gpu.terrains.layers());
        c.texture(heatUnit, GL_TEXTURE_2D, c.gpu.heatTable.get());
        ObjectBlock block = c.blockOf(d.worldFromLocal);
        block.baseColor = clay;
        block.look.y = !mask ? 1.f : d.selected ? 0.f : d.hovered ? 0.7f : 1.f;
        drawSurface(c, d, block);
    }
}

void drawTerrainWires(DrawContext& c)
{
    const ThemeColors& theme = themeColors(c.frame.options.theme);
    for (const DrawTerrain& d : c.frame.terrains) {
        if (c.frame.options.shading == Shading::Wire) {
            drawWireStyle(c, d);
        } else if (c.frame.options.wireOverlay) {
            glDepthMask(GL_FALSE);
            glEnable(GL_POLYGON_OFFSET_FILL);
            glPolygonOffset(-0.5f, -2);
            drawWire(c, d, {theme.wire, 0.7f});
            glDisable(GL_POLYGON_OFFSET_FILL);
            glDepthMask(GL_TRUE);
        }
    }
}

void drawTerrainIds(DrawContext& c)
{
    for (const DrawTerrain& d : c.frame.terrains) {
        ObjectBlock block = c.blockOf(d.worldFromLocal);
        block.ids.x = int(d.node.value);
        drawPlaces(c, d, ProgramId::TerrainIds, block);
    }
}

}  // namespace mw
