// What must be true of drawn terrains: no crack along an edge of patches, levels as (5.1) has them, uploads of touched tiles only.
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <set>

#include "core/terrain/brush.h"
#include "render/colors.h"
#include "render/draw_context.h"
#include "render/shaders.h"
#include "render/terrain_levels.h"

#include "offscreen_test.h"
#include "shapes.h"

namespace mw {
namespace {

using namespace test;

constexpr int width = 480, height = 300;

class TerrainPictures : public OffscreenTest<width, height> {};

/// Hills of several sizes, and roughness from sample to sample: the worst for cracks.
HeightMap hills(uint32_t side)
{
    std::vector<float> rows;
    std::minstd_rand random(5);
    for (uint32_t y = 0; y < side; ++y) {
        for (uint32_t x = 0; x < side; ++x) {
            const double u = double(x) / (side - 1), v = double(y) / (side - 1);
            const double h = 0.5 + 0.2 * std::sin(9 * u) * std::cos(7 * v) + 0.12 * std::sin(31 * u + 17 * v) + 0.04 * std::sin(90 * v);
            rows.push_back(float(h + 0.03 * (double(random()) / 2147483647.0 - 0.5)));
        }
    }
    return HeightMap(side, side, rows);
}

DrawTerrain hilly(uint32_t side = 257)
{
    DrawTerrain d;
    d.node = NodeId{7};
    d.terrain.map = hills(side);
    d.terrain.waterLevel = -10;
    d.terrain.detail = {8, 24, 2, 100, 700, true};
    return d;
}

Frame frameOfTerrain(DrawTerrain d)
{
    Frame f = frameWith({});
    f.objects.clear();
    f.terrains.push_back(std::move(d));
    return f;
}

TEST(TerrainLevel, FormulaAndItsLimits)
{
    Terrain::Detail d;  // 64 at 80 m, 4 at 900 m
    EXPECT_DOUBLE_EQ(tessellationLevel(d, 0), 64);
    EXPECT_DOUBLE_EQ(tessellationLevel(d, 80), 64);
    EXPECT_DOUBLE_EQ(tessellationLevel(d, 490), 34);  // half way
    EXPECT_DOUBLE_EQ(tessellationLevel(d, 900), 4);
    EXPECT_DOUBLE_EQ(tessellationLevel(d, 5000), 4);
    d.farDistance = d.nearDistance;
    EXPECT_DOUBLE_EQ(tessellationLevel(d, 79), 64);
    EXPECT_DOUBLE_EQ(tessellationLevel(d, 81), 4);
}

TEST(TerrainLevel, BothPatchesOfAnEdgeHaveItsLevel)
{
    DrawTerrain d = hilly();
    d.terrain.detail.patches = 13;
    for (int k = 0; k < 40; ++k) {
        const TerrainLevels l = levelsOf(d.terrain, glm::dmat4(1), {-600 + 31.7 * k, 60 + 5 * k, 400 - 22.3 * k});
        ASSERT_EQ(l.columns, 13);
        ASSERT_EQ(l.rows, 13);
        for (int row = 0; row < l.rows; ++row) {
            for (int column = 0; column < l.columns; ++column) {
                const int* here = &l.outer[4 * l.patch(column, row)];
                if (column > 0) {
                    EXPECT_EQ(here[0], l.outer[4 * l.patch(column - 1, row) + 2]);
                }
                if (row > 0) {
                    EXPECT_EQ(here[1], l.outer[4 * l.patch(column, row - 1) + 3]);
                }
                EXPECT_EQ(l.inner[l.patch(column, row)], int(std::ceil(tessellationLevel(d.terrain.detail, l.distance[l.patch(column, row)]))));
            }
        }
    }
}

TEST(TerrainLevel, PatchesFollowTheShape)
{
    Terrain t;
    t.map = HeightMap::flat(513, 129, 0.5f);
    EXPECT_EQ(patchesOf(t), glm::ivec2(16, 4));
    t.detail.patches = 1;
    EXPECT_EQ(patchesOf(t), glm::ivec2(1, 1));
}

/// The points of the tessellated patches, as the card computes them: triangles of all patches, captured behind the evaluation shader.
class Captured {
public:
    explicit Captured(const DrawTerrain& d, const TerrainLevels& levels)
    {
        std::string chunks;
        for (const char* chunk : {"camera.glsl", "object.glsl", "terrain.glsl"}) chunks += std::string(shaderFile(chunk)) + "\n";
        const GLuint program = glCreateProgram();
        for (const auto& [stage, file] :
             {std::pair{GL_VERTEX_SHADER, "terrain.vert"}, {GL_TESS_CONTROL_SHADER, "terrain.tesc"}, {GL_TESS_EVALUATION_SHADER, "terrain.tese"}}) {
            const std::string text = "#version 410 core\n" + chunks + std::string(shaderFile(file));
            const char* source = text.c_str();
            const GLuint shader = glCreateShader(GLenum(stage));
            glShaderSource(shader, 1, &source, nullptr);
            glCompileShader(shader);
            glAttachShader(program, shader);
            glDeleteShader(shader);
        }
        const char* varyings[] = {"local"};
        glTransformFeedbackVaryings(program, 1, varyings, GL_INTERLEAVED_ATTRIBS);
        glLinkProgram(program);
        GLint good = 0;
        glGetProgramiv(program, GL_LINK_STATUS, &good);
        EXPECT_TRUE(good);
        glUseProgram(program);
        glUniformBlockBinding(program, glGetUniformBlockIndex(program, "Terrain"), terrainBlock);
        glUniformBlockBinding(program, glGetUniformBlockIndex(program, "Object"), objectBlock);
        glUniform1i(glGetUniformLocation(program, "heightMap"), heightUnit);
        bind(d, levels);
        for (int row = 0; row < levels.rows; ++row)
            for (int column = 0; column < levels.columns; ++column) patches.push_back(capture(levels, column, row));
        glUseProgram(0);
        glDeleteProgram(program);
    }
    std::vector<std::vector<glm::vec3>> patches;

private:
    void bind(const DrawTerrain& d, const TerrainLevels& levels)
    {
        glActiveTexture(GL_TEXTURE0 + heightUnit);
        texture_.show(d.terrain.map);
        glActiveTexture(GL_TEXTURE0 + heightUnit);
        glBindTexture(GL_TEXTURE_2D, texture_.id());
        const glm::dvec2 size = d.terrain.size();
        std::vector<glm::vec4> block(6, glm::vec4(0));
        block[0] = {size.x, size.y, d.terrain.maximumHeight, d.terrain.waterLevel};
        block[1] = {texture_.size().x, texture_.size().y, d.terrain.map.width() - 1, d.terrain.map.height() - 1};
        block[3] = {levels.columns, levels.rows, 0, 1};
        gl::stream(block_, std::span<const glm::vec4>(block), GL_UNIFORM_BUFFER);
        glBindBufferBase(GL_UNIFORM_BUFFER, terrainBlock, block_.get());
        const ObjectBlock object;
        gl::stream(object_, std::span(&object, 1), GL_UNIFORM_BUFFER);
        glBindBufferBase(GL_UNIFORM_BUFFER, objectBlock, object_.get());
        glBindVertexArray(vertexArray_.id());
        glBindRenderbuffer(GL_RENDERBUFFER, pixels_.id());  // without a surface even what is thrown away needs one
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 4, 4);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels_.get());
    }
    std::vector<glm::vec3> capture(const TerrainLevels& l, int column, int row)
    {
        const size_t p = l.patch(column, row);
        constexpr glm::ivec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        std::vector<glm::vec4> points;
        for (size_t i = 0; i < 4; ++i) points.emplace_back(glm::ivec2(column, row) + corners[i], l.outer[4 * p + i], l.inner[p]);
        gl::stream(points_, std::span<const glm::vec4>(points));
        gl::attribute({0, points_.get(), 4});
        std::vector<glm::vec3> out(3 * l.triangles(p) + 64);
        glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, captured_.id());
        glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, GLsizeiptr(out.size() * sizeof(glm::vec3)), nullptr, GL_STREAM_READ);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, captured_.get());
        GLuint query = 0;
        glGenQueries(1, &query);
        glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, query);
        glEnable(GL_RASTERIZER_DISCARD);
        glPatchParameteri(GL_PATCH_VERTICES, 4);
        glBeginTransformFeedback(GL_TRIANGLES);
        glDrawArrays(GL_PATCHES, 0, 4);
        glEndTransformFeedback();
        glDisable(GL_RASTERIZER_DISCARD);
        glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
        GLuint written = 0;
        glGetQueryObjectuiv(query, GL_QUERY_RESULT, &written);
        glDeleteQueries(1, &query);
        out.resize(3 * size_t(written));
        glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, GLsizeiptr(out.size() * sizeof(glm::vec3)), out.data());
        return out;
    }
    HeightTexture texture_;
    gl::Buffer block_, object_, points_, captured_;
    gl::VertexArray vertexArray_;
    gl::Renderbuffer pixels_;
    gl::Framebuffer framebuffer_;
};

/// Different points of a patch on the line where one coordinate has a value, by the other coordinate.
std::vector<glm::vec3> along(const std::vector<glm::vec3>& points, int fixedAxis, float value)
{
    std::vector<glm::vec3> out;
    for (const glm::vec3& p : points)
        if (p[fixedAxis] == value) out.push_back(p);
    const int free = 2 - fixedAxis;
    std::sort(out.begin(), out.end(), [free](glm::vec3 a, glm::vec3 b) { return a[free] < b[free]; });
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

TEST_F(TerrainPictures, PointsOfBothPatchesAlongAnEdgeAreTheSame)
{
    DrawTerrain d = hilly();
    size_t edges = 0, points = 0;
    for (int k = 0; k < 3; ++k) {
        const TerrainLevels l = levelsOf(d.terrain, glm::dmat4(1), {-300 + 290.0 * k, 90, 350 - 330.0 * k});
        const Captured captured(d, l);
        const auto border = [&](int n, int of) { return (float(n) / float(of) - 0.5f) * float(d.terrain.extent); };
        for (int row = 0; row < l.rows; ++row) {
            for (int column = 0; column < l.columns; ++column) {
                const size_t p = l.patch(column, row);
                EXPECT_EQ(captured.patches[p].size(), 3 * l.triangles(p));  // what the formula counts is what the card makes
                for (const int axis : {0, 2}) {
                    if ((axis == 0 ? column : row) == 0) continue;
                    const size_t other = axis == 0 ? l.patch(column - 1, row) : l.patch(column, row - 1);
                    const float at = border(axis == 0 ? column : row, axis == 0 ? l.columns : l.rows);
                    const auto mine = along(captured.patches[p], axis, at), theirs = along(captured.patches[other], axis, at);
                    EXPECT_EQ(mine, theirs) << column << ", " << row;  // to the bit
                    EXPECT_EQ(mine.size(), size_t(l.outer[4 * p + (axis == 0 ? 0 : 1)]) + 1);
                    // And they are on the map, by its own sampling.
                    for (const glm::vec3& q : mine) EXPECT_NEAR(q.y, d.terrain.heightAt(q.x, q.z), 1e-3);
                    ++edges;
                    points += mine.size();
                }
            }
        }
    }
    EXPECT_EQ(edges, 3u * 2 * 7 * 8);
    EXPECT_GT(points, 1000u);
}

/// A picture of the terrain over bright red, seen from above so that it fills the view; red pixels are holes.
size_t redPixels(Offscreen& offscreen, bool corrected, int k)
{
    DrawTerrain d = hilly();
    d.terrain.detail = {16, 20, 1, 60, 500, corrected};
    Frame f = frameOfTerrain(d);
    Mesh red = plane(1);
    Array<glm::vec3> p;
    for (const glm::vec3& v : red.positions()) p.emplace_back(2000 * v.x, -60, -2000 * v.y);
    red = red.withPositions(std::move(p)).with(floatAttribute("color", Domain::Vertex, 3, {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}));
    f.objects.push_back({});
    f.objects[0].node = NodeId{8};
    f.objects[0].mesh = red;
    f.camera.azimuth = 0.45 * k;
    f.camera.elevation = 1.0 + 0.02 * k;
    f.camera.distance = 240 + 8 * k;
    f.camera.target = {-120 + 11.0 * k, 50, 110 - 10.0 * k};
    const Picture picture = offscreen.draw(f, width, height);
    size_t n = 0;
    for (size_t i = 0; i < picture.rgba.size(); i += 4)
        n += picture.rgba[i] > 90 && picture.rgba[i] > 2 * std::max(picture.rgba[i + 1], picture.rgba[i + 2]);
    return n;
}

TEST_F(TerrainPictures, NoCrackOnAPathOfCamerasAndSomeWithoutCorrection)
{
    size_t torn = 0;
    for (int k = 0; k < 24; ++k) {
        EXPECT_EQ(redPixels(*offscreen_, true, k), 0u) << "camera " << k;
        torn += redPixels(*offscreen_, false, k) > 0;
    }
    EXPECT_GE(torn, 12u);  // else the test would see nothing at all
}

TEST_F(TerrainPictures, AStrokeUploadsTheTilesItTouches)
{
    DrawTerrain d = hilly(1024);
    d.terrain.detail = {8, 4, 1, 100, 700, true};
    Frame f = frameOfTerrain(d);
    f.camera.frame(boundsOf(f), 1.6);
    draw(f);
    EXPECT_GE(offscreen_->renderer().counts().uploadedBytes, size_t(1024) * 1024 * 4);
    draw(f);
    EXPECT_EQ(offscreen_->renderer().counts().uploadedBytes, 0u);

    // In the middle of a tile of 125 m: that tile and its coarser levels, 4/3 of 64 KiB.
    Brush brush;
    brush.radius = 30;
    double carry = -1;
    const glm::dvec2 middle(-500 + 1.5 * 1000.0 * 128 / 1023, -500 + 2.5 * 1000.0 * 128 / 1023);
    f.terrains[0].terrain.map = stroked(d.terrain, brush, std::span(&middle, 1), carry);
    draw(f);
    const size_t one = offscreen_->renderer().counts().uploadedBytes;
    EXPECT_GE(one, size_t(128 * 128 * 4));
    EXPECT_LE(one, size_t(128 * 128 * 4 * 4 / 3 + 64));

    // On a corner of four tiles: four.
    carry = -1;
    const glm::dvec2 corner(-500 + 3 * 1000.0 * 128 / 1023, -500 + 4 * 1000.0 * 128 / 1023);
    f.terrains[0].terrain.map = stroked(f.terrains[0].terrain, brush, std::span(&corner, 1), carry);
    draw(f);
    EXPECT_EQ(offscreen_->renderer().counts().uploadedBytes, 4 * one);
    draw(f);
    EXPECT_EQ(offscreen_->renderer().counts().uploadedBytes, 0u);
}

TEST_F(TerrainPictures, TrianglesAreCounted)
{
    DrawTerrain d = hilly();
    d.terrain.detail = {8, 6, 6, 10, 20, true};
    Frame f = frameOfTerrain(d);
    f.camera.elevation = 1.2;
    f.camera.frame(boundsOf(f), 1.6);
    draw(f);
    EXPECT_EQ(offscreen_->renderer().counts().triangles, 64u * 2 * 6 * 6);  // all of one level: 2 n^2 a patch
    // What is not in view is not drawn.
    f.camera.target = {-400, 60, -400};
    f.camera.distance = 40;
    draw(f);
    EXPECT_LT(offscreen_->renderer().counts().triangles, 8u * 2 * 6 * 6);
    EXPECT_GT(offscreen_->renderer().counts().triangles, 0u);
}

TEST_F(TerrainPictures, PickMeetsTheGround)
{
    Frame f = frameOfTerrain(hilly());
    f.camera.elevation = 0.6;
    f.camera.frame(boundsOf(f), 1.6);
    for (const glm::dvec2 place : {glm::dvec2(0, 0), {-200, 150}, {310, 280}}) {
        const glm::dvec3 world(place.x, f.terrains[0].terrain.heightAt(place.x, place.y), place.y);
        const glm::dvec3 pixel = f.camera.project(world, {width, height});
        const auto pick = offscreen_->renderer().pick(f, {width, height}, glm::dvec2(pixel));
        ASSERT_TRUE(pick);
        EXPECT_EQ(pick->node, NodeId{7});
        EXPECT_EQ(pick->face, none);
        const glm::dvec3 eye = f.camera.eye();  // something nearer may hide the place
        EXPECT_LE(glm::distance(eye, pick->atWorld), glm::distance(eye, world) + 0.5);
        EXPECT_NEAR(pick->atWorld.y, f.terrains[0].terrain.heightAt(pick->atWorld.x, pick->atWorld.z), 1e-3);
    }
    EXPECT_FALSE(offscreen_->renderer().pick(f, {width, height}, {2, 2}));
    const auto seen = offscreen_->renderer().visibleFaces(f, {width, height}, {{0, 0}, {width, height}});
    ASSERT_EQ(seen.size(), 1u);
    EXPECT_EQ(seen[0].first, NodeId{7});
    EXPECT_TRUE(seen[0].second.empty());
}

TEST_F(TerrainPictures, WaterIsBlueAndHighGroundWhite)
{
    DrawTerrain d;
    d.node = NodeId{7};
    std::vector<float> ramp;
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) ramp.push_back(float(x) / 127);
    d.terrain.map = HeightMap(128, 128, ramp);
    d.terrain.maximumHeight = 100;  // a slope of 6 degrees
    d.terrain.waterLevel = 18;
    Frame f = frameOfTerrain(d);
    f.camera.elevation = 1.2;
    f.camera.frame(boundsOf(f), 1.6);
    const Picture p = draw(f);
    const auto seen = [&](double share) {
        const double x = (share - 0.5) * 1000, y = std::max(18.0, 100 * share);
        return at(p, f.camera, {x, y, 0});
    };
    const glm::ivec4 water = seen(0.08), grass = seen(0.35), snow = seen(0.9);
    EXPECT_GT(water.z, water.x + 30);
    EXPECT_GT(grass.y, grass.x);
    EXPECT_GT(grass.y, grass.z + 30);
    EXPECT_GT(std::min({snow.x, snow.y, snow.z}), 170);
}

TEST_F(TerrainPictures, EveryStyleWithoutComplaint)
{
    Frame f = frameOfTerrain(hilly());
    f.camera.elevation = 0.5;
    f.camera.frame(boundsOf(f), 1.6);
    f.terrains[0].terrain.waterLevel = 50;
    f.terrains[0].brush = DrawTerrain::BrushMark{{0, 0}, 85, 40};
    for (const Shading shading : {Shading::Smooth, Shading::Flat, Shading::Wire}) {
        for (const auto overlay :
             {DrawTerrain::Overlay::None, DrawTerrain::Overlay::PatchBorders, DrawTerrain::Overlay::Level, DrawTerrain::Overlay::Slope}) {
            f.options.shading = shading;
            f.terrains[0].overlay = overlay;
            f.terrains[0].selected = overlay == DrawTerrain::Overlay::Level;
            f.options.wireOverlay = overlay == DrawTerrain::Overlay::Slope;
            const Picture p = draw(f);
            std::set<uint32_t> colours;
            for (size_t i = 0; i < p.rgba.size(); i += 4) colours.insert(uint32_t(p.rgba[i]) << 16 | uint32_t(p.rgba[i + 1]) << 8 | p.rgba[i + 2]);
            EXPECT_GT(colours.size(), 100u);
        }
    }
    f.terrains[0].terrain.map = {};  // nothing to draw, and no complaint
    EXPECT_NO_THROW(draw(f));
}

TEST_F(TerrainPictures, SameMapSamePicture)
{
    Frame f = frameOfTerrain(hilly());
    f.camera.elevation = 0.5;
    f.camera.frame(boundsOf(f), 1.6);
    const Picture a = draw(f);
    EXPECT_EQ(draw(f).rgba, a.rgba);
    Offscreen other(false);
    EXPECT_EQ(other.draw(f, width, height).rgba, a.rgba);
}

}  // namespace
}  // namespace mw
