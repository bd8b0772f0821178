// What must be true of pictures: places and colours that are known in closed form.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

#include "core/io/io.h"
#include "render/colors.h"
#include "render/image.h"

#include "data.h"
#include "offscreen_test.h"
#include "shapes.h"

namespace mw {
namespace {

using namespace test;

constexpr int width = 640, height = 400;

class Pictures : public OffscreenTest<width, height> {};

double coveredPixels(const Picture& p)
{
    double sum = 0;
    for (size_t i = 3; i < p.rgba.size(); i += 4) sum += p.rgba[i] / 255.0;
    return sum;
}

glm::vec3 linearColor(glm::ivec4 c)
{
    return linearOf(glm::vec3(c) / 255.f);
}

TEST_F(Pictures, SilhouetteOfASphere)
{
    for (const bool perspective : {true, false}) {
        for (const int samples : {0, 4}) {
            Frame f = frameWith(sphere(5), 4);
            f.camera.perspective = perspective;
            f.options.transparentBackground = true;
            f.options.samples = samples;
            const double t = std::tan(0.5 * f.camera.fieldOfView);
            const double radius = 0.5 * height / t * (perspective ? std::tan(std::asin(1.0 / 4)) : 1.0 / 4);
            const double expected = std::numbers::pi * radius * radius;
            EXPECT_NEAR(coveredPixels(draw(f)) / expected, 1, 0.01) << perspective << samples;
        }
    }
}

TEST_F(Pictures, WithoutTransparencyEverythingIsOpaque)
{
    Frame f = frameWith(sphere(3));
    f.options.grid = f.options.axes = f.options.orientationMarker = f.options.legend = f.options.wireOverlay = true;
    f.options.samples = 4;
    f.objects[0].selected = true;
    const Picture p = draw(f);
    EXPECT_DOUBLE_EQ(coveredPixels(p), double(width) * height);
}

TEST_F(Pictures, HeatColoursAtKnownVertices)
{
    const Mesh m = plane(8);
    Table t;
    t.rows = ElementKind::Vertex;
    Column column{"x", "", Array<double>(m.vertexCount()), false};
    for (size_t v = 0; v < m.vertexCount(); ++v) column.values[v] = m.positions()[v].x;
    column.values[9 * 4 + 4] = std::nan("");  // the middle
    t.columns.push_back(column);
    Frame f = frameWith(m);
    HeatMap h{std::make_shared<Table>(t), 0, 0, 1};
    h.low = -2;  // not symmetric: viridis
    f.objects[0].heat = std::make_shared<HeatMap>(h);
    const Picture p = draw(f);
    const std::vector<uint8_t> table = heatTablePixels();
    for (const double x : {-0.75, -0.5, 0.5, 0.75}) {
        const size_t i = 4 * size_t(std::lround((x + 2) / 3 * 255));
        const glm::vec3 expected = linearOf(glm::vec3(table[i], table[i + 1], table[i + 2]) / 255.f);
        // Light scales the colour (and adds a little white); its direction in colour space stays.
        const glm::vec3 seen = linearColor(at(p, f.camera, {x, 0.75, 0}));
        EXPECT_GT(glm::dot(glm::normalize(seen), glm::normalize(expected)), 0.995) << x;
    }
    const glm::vec3 undefined = linearColor(at(p, f.camera, {0, 0, 0}));
    EXPECT_LT(std::abs(undefined.r - undefined.b), 0.06);
}

TEST_F(Pictures, HeatOnFacesOfPolygonsAndItsCategories)
{
    const Mesh m = plane(2);
    Table t;
    t.rows = ElementKind::Face;
    t.columns.push_back({"group", "", Array<double>{0, 1, 2, 27}, true});
    Frame f = frameWith(m);
    f.objects[0].heat = std::make_shared<HeatMap>(HeatMap{std::make_shared<Table>(t), 0, 0, 1});
    const Picture p = draw(f);
    const uint32_t expected[] = {0x60A8DE, 0xF0DE18, 0xDE1860, 0x18F0BA};  // the 27th is the third of 24 again
    const glm::dvec3 places[] = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {-0.5, 0.5, 0}, {0.5, 0.5, 0}};
    for (int i = 0; i < 4; ++i) {
        const glm::vec3 seen = linearColor(at(p, f.camera, places[i]));
        EXPECT_GT(glm::dot(glm::normalize(seen), glm::normalize(linearOf(hex(expected[i])))), 0.99) << i;
    }
}

// A line of four pixels along each edge, in the very colour of its value; beside it the surface as without values. Undefined ones are grey.
TEST_F(Pictures, HeatOnEdgesIsDrawnAsThickLines)
{
    const Mesh m = plane(2);
    Table t;
    t.rows = ElementKind::Edge;
    t.edges.assign(m.edges().begin(), m.edges().end());
    const size_t n = t.edges.size() / 2;
    Column column{"cost", "", Array<double>(n), false};
    for (size_t e = 0; e < n; ++e) column.values[e] = double(e) / double(n - 1);
    column.values[3] = std::nan("");
    t.columns.push_back(column);
    Frame f = frameWith(m);
    const Picture bare = draw(f);
    HeatMap h{std::make_shared<Table>(t), 0, 0, 1};
    f.objects[0].heat = std::make_shared<HeatMap>(h);
    const Picture p = draw(f);
    const std::vector<uint8_t> table = heatTablePixels();
    for (size_t e = 0; e < n; ++e) {
        const glm::dvec3 a = m.positions()[t.edges[2 * e]], b = m.positions()[t.edges[2 * e + 1]], middle = 0.5 * (a + b);
        const glm::vec3 seen = glm::vec3(at(p, f.camera, middle));
        const size_t i = 4 * size_t(std::lround(column.values[e] * 255));
        const glm::vec3 expected = e == 3 ? glm::vec3(0x8A, 0x8F, 0x96) : glm::vec3(table[i], table[i + 1], table[i + 2]);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(seen[k], expected[k], 3) << e;
    }
    for (const glm::dvec3 inFace : {glm::dvec3(-0.5, -0.5, 0), glm::dvec3(0.5, 0.5, 0)})
        EXPECT_LE(distance(at(bare, f.camera, inFace), at(p, f.camera, inFace)), 1);
}

TEST_F(Pictures, WiresShowEdgesOfPolygonsButNoDiagonals)
{
    Frame f = frameWith(quadCube(), 6);
    f.options.shading = Shading::Flat;
    const Picture bare = draw(f);
    f.options.wireOverlay = true;
    const Picture wired = draw(f);
    // The front face z = 1: along both diagonals nothing changes, on the edges it does.
    for (double s = -0.9; s <= 0.9; s += 0.05) {
        for (const double sign : {1.0, -1.0}) {
            const glm::dvec3 place{s, sign * s, 1};
            EXPECT_LE(distance(at(bare, f.camera, place), at(wired, f.camera, place)), 2) << s;
        }
        EXPECT_GT(distance(at(bare, f.camera, {s, 0.997, 1}), at(wired, f.camera, {s, 0.997, 1})), 25) << s;
    }
}

TEST_F(Pictures, SelectedObjectsAreOutlinedInOrangeOnly)
{
    Frame f = frameWith(sphere(4), 4);
    const auto orange = [](const Picture& p) {
        size_t n = 0;
        for (int y = 0; y < p.height; ++y)
            for (int x = 0; x < p.width; ++x) n += distance(at(p, x, y), {0xFF, 0x9A, 0x3C, 255}) < 12;
        return n;
    };
    EXPECT_EQ(orange(draw(f)), 0u);
    const Picture before = draw(f);
    f.objects[0].selected = true;
    const Picture after = draw(f);
    const double radius = 0.5 * height / std::tan(0.5 * f.camera.fieldOfView) * std::tan(std::asin(0.25));
    const double circumference = 2 * std::numbers::pi * radius;
    EXPECT_GT(orange(after), 0.6 * circumference);
    EXPECT_LT(orange(after), 3.5 * circumference);
    EXPECT_EQ(at(before, width / 2, height / 2), at(after, width / 2, height / 2));
    EXPECT_EQ(at(before, 5, 5), at(after, 5, 5));
}

TEST_F(Pictures, MarksAreHiddenUnlessDrawnThrough)
{
    Frame f = frameWith(quadCube(), 6);
    Mark m;
    m.node = NodeId{7};
    m.indices = {0};  // behind: (-1, -1, -1), inside the front face's outline
    m.color = {1, 0, 0, 1};
    m.width = 12;
    f.marks = {m};
    const glm::dvec3 place{-1, -1, -1};
    EXPECT_GT(distance(at(draw(f), f.camera, place), {255, 0, 0, 255}), 60);
    f.marks[0].through = true;
    EXPECT_LE(distance(at(draw(f), f.camera, place), {255, 0, 0, 255}), 2);
    f.marks[0].through = false;
    f.marks[0].indices = {4};  // in front: (-1, -1, 1)
    EXPECT_LE(distance(at(draw(f), f.camera, {-1, -1, 1}), {255, 0, 0, 255}), 2);
}

TEST_F(Pictures, MarkedEdgesAndFaces)
{
    Frame f = frameWith(quadCube(), 6);
    Mark edge;
    edge.node = NodeId{7};
    edge.kind = ElementKind::Edge;
    edge.indices = {4, 5, 99, 100};  // the second does not exist: left out
    edge.color = {0, 1, 0, 1};
    edge.width = 4;
    Mark face = edge;
    face.kind = ElementKind::Face;
    face.indices = {1};  // z = 1
    face.color = {0, 0, 1, 1};
    f.marks = {face, edge};
    const Picture p = draw(f);
    EXPECT_LE(distance(at(p, f.camera, {0, -1, 1}), {0, 255, 0, 255}), 2);
    EXPECT_LE(distance(at(p, f.camera, {0.3, 0.2, 1}), {0, 0, 255, 255}), 2);
    // The halo lies between the green line and the blue face.
    const glm::dvec3 line = f.camera.project({0, -1, 1}, {width, height});
    const glm::ivec4 halo = at(p, int(line.x), int(line.y) - 3);
    EXPECT_LT(halo.x + halo.y + halo.z, 200);
}

TEST_F(Pictures, PointCloudsAndLooseLinesAreDrawn)
{
    const Mesh points(Array<glm::vec3>{{0, 0, 0}, {1, 1, 0}}, {}, {});
    Frame f = frameWith(points);
    const Picture empty = draw(Frame{f.camera, 0, f.options, {}, {}, {}, {}});
    EXPECT_GT(distance(at(draw(f), f.camera, {1, 1, 0}), at(empty, f.camera, {1, 1, 0})), 60);
    f.objects[0].mesh = points.withLines(Array<uint32_t>{0u, 1u});
    const Picture line = draw(f);
    EXPECT_GT(distance(at(line, f.camera, {0.5, 0.5, 0}), at(empty, f.camera, {0.5, 0.5, 0})), 60);
    EXPECT_LE(distance(at(line, f.camera, {0.5, 0.2, 0}), at(empty, f.camera, {0.5, 0.2, 0})), 1);
}

TEST_F(Pictures, CornerColoursSplitVertices)
{
    const Mesh m = plane(2);
    Array<float> colors;
    for (uint32_t c = 0; c < m.cornerCount(); ++c) {
        const uint32_t face = c / 4;
        for (uint32_t k = 0; k < 3; ++k) colors.push_back(face == k ? 0.8f : 0.05f);  // the fourth is nearly black
    }
    Frame f = frameWith(m.with(floatAttribute("color", Domain::Corner, 3, std::move(colors))));
    const Picture p = draw(f);
    const glm::ivec4 red = at(p, f.camera, {-0.03, -0.03, 0}), green = at(p, f.camera, {0.03, -0.03, 0}), blue = at(p, f.camera, {-0.03, 0.03, 0});
    EXPECT_GT(red.x, red.y + 60);
    EXPECT_GT(green.y, green.x + 60);
    EXPECT_GT(blue.z, blue.x + 60);
}

TEST_F(Pictures, BaseColourPictureTheRightWayUp)
{
    // Rows from the top: red, green / blue, white.
    const Picture four{2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255}};
    const std::string file = testing::TempDir() + "four.png";
    writePng(four, file);
    std::vector<uint8_t> bytes;
    {
        FILE* in = std::fopen(file.c_str(), "rb");
        ASSERT_NE(in, nullptr);
        for (int c; (c = std::fgetc(in)) != EOF;) bytes.push_back(uint8_t(c));
        std::fclose(in);
    }
    EXPECT_EQ(decodeImage(bytes).rgba, four.rgba);
    bytes.resize(bytes.size() / 2);
    EXPECT_THROW(decodeImage(bytes), Error);
    EXPECT_THROW(decodeImage(std::vector<uint8_t>(100, 7)), Error);

    const Mesh quad = plane(1);
    auto image = std::make_shared<Image>();
    std::vector<uint8_t> whole;
    FILE* in = std::fopen(file.c_str(), "rb");
    for (int c; (c = std::fgetc(in)) != EOF;) whole.push_back(uint8_t(c));
    std::fclose(in);
    image->bytes = std::make_shared<std::vector<uint8_t>>(std::move(whole));
    auto material = std::make_shared<Material>();
    material->baseColor = glm::dvec4(1);
    material->baseColorTexture.repeat = false;
    Frame f = frameWith(quad.with(floatAttribute("texcoord", Domain::Corner, 2, {0, 0, 1, 0, 1, 1, 0, 1})));
    f.objects[0].materials = {material};
    f.objects[0].pictures = {{image->bytes}};
    const Picture p = draw(f);
    const glm::ivec4 red = at(p, f.camera, {-0.8, 0.8, 0}), green = at(p, f.camera, {0.8, 0.8, 0}), blue = at(p, f.camera, {-0.8, -0.8, 0});
    EXPECT_GT(red.x, red.y + 80);
    EXPECT_GT(green.y, green.x + 80);
    EXPECT_GT(blue.z, blue.x + 80);
}

TEST_F(Pictures, MaterialsByFace)
{
    const Mesh m = plane(2).with(integerAttribute("material", Domain::Face, 1, {1, 0, 1, 7}));  // 7 is out of range: the last
    auto red = std::make_shared<Material>(), green = std::make_shared<Material>();
    red->baseColor = {0.8, 0.02, 0.02, 1};
    green->baseColor = {0.02, 0.8, 0.02, 1};
    Frame f = frameWith(m);
    f.objects[0].materials = {red, green};
    const Picture p = draw(f);
    const glm::ivec4 first = at(p, f.camera, {-0.5, -0.5, 0}), second = at(p, f.camera, {0.5, -0.5, 0}), last = at(p, f.camera, {0.5, 0.5, 0});
    EXPECT_GT(first.y, first.x + 80);
    EXPECT_GT(second.x, second.y + 80);
    EXPECT_GT(last.y, last.x + 80);
}

TEST_F(Pictures, NothingIsUploadedTwice)
{
    Frame f = frameWith(sphere(4));
    f.options.wireOverlay = true;
    Mark m;
    m.node = NodeId{7};
    m.indices = {1, 2, 3};
    f.marks = {m};
    draw(f);
    draw(f);
    EXPECT_EQ(offscreen_->renderer().counts().uploadedBytes, 0u);
    EXPECT_EQ(offscreen_->renderer().counts().triangles, f.objects[0].mesh.faceCount());

    // Moved vertices: positions and normals go again, connectivity stays.
    Array<glm::vec3> p(f.objects[0].mesh.positions().begin(), f.objects[0].mesh.positions().end());
    for (glm::vec3& v : p) v *= 1.1f;
    f.objects[0].mesh = f.objects[0].mesh.withPositions(std::move(p));
    draw(f);
    EXPECT_EQ(offscreen_->renderer().counts().uploadedBytes, 2 * sizeof(glm::vec3) * f.objects[0].mesh.vertexCount());
    draw(f);
    EXPECT_EQ(offscreen_->renderer().counts().uploadedBytes, 0u);
}

// Marks over a scene that stays are drawn over what was kept of it; the picture is the same as one drawn anew.
TEST_F(Pictures, WhatLiesBeneathMarksIsKept)
{
    Frame f = frameWith(sphere(7));  // 327,680 triangles
    f.options.legend = f.options.orientationMarker = f.options.grid = true;
    f.objects[0].selected = true;
    Mark hidden{NodeId{7}, ElementKind::Vertex, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, glm::vec4(1), 15}, edges = hidden;
    edges.kind = ElementKind::Edge;
    edges.through = true;
    const auto kept = [&] { return offscreen_->renderer().counts().kept; };
    for (const int samples : {0, 4}) {
        SCOPED_TRACE(samples);
        f.options.samples = samples;
        f.marks.clear();
        f.scene = 0;
        const Picture bare = draw(f);
        EXPECT_FALSE(kept());
        f.marks = {hidden, edges};
        f.labels = {{glm::vec3(0, 1, 0), "label", glm::vec4(1)}};
        const Picture marked = draw(f);
        EXPECT_NE(marked.rgba, bare.rgba);

        f.scene = 1;
        EXPECT_EQ(draw(f).rgba, marked.rgba);
        EXPECT_FALSE(kept()) << "nothing was known of the frame before";
        EXPECT_EQ(draw(f).rgba, marked.rgba);
        EXPECT_TRUE(kept());
        EXPECT_EQ(offscreen_->renderer().counts().triangles, f.objects[0].mesh.faceCount());
        f.marks.clear();
        f.labels.clear();
        EXPECT_EQ(draw(f).rgba, bare.rgba) << "marks leave nothing behind";
        EXPECT_TRUE(kept());
    }
    const Picture before = draw(f);
    f.camera.azimuth = 0.5;
    EXPECT_NE(draw(f).rgba, before.rgba);
    EXPECT_FALSE(kept());
    f.scene = 2;
    draw(f);
    EXPECT_FALSE(kept());
    f.objects[0].mesh = sphere(3);  // as soon drawn as copied
    f.scene = 3;
    draw(f);
    draw(f);
    EXPECT_FALSE(kept());
}

TEST_F(Pictures, TheSameTwiceAndInAnotherContext)
{
    Frame f = frameWith(sphere(4));
    f.options = ViewOptions{};
    f.options.wireOverlay = true;
    f.objects[0].selected = true;
    f.labels = {{glm::vec3(0, 1, 0), "label \u2265 0.1", glm::vec4(1)}};
    const Picture a = draw(f), b = draw(f);
    EXPECT_EQ(a.rgba, b.rgba);
    Offscreen other(false);
    EXPECT_EQ(other.draw(f, width, height).rgba, a.rgba);
}

TEST_F(Pictures, EveryOptionWithoutComplaint)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const Mesh mesh = [&] {
        const Imported in = readFile(data / "meshes/nonmanifold/spider.obj");
        return in.scene.find(in.scene.meshes().front())->base;
    }();
    for (const Shading shading : {Shading::Smooth, Shading::Flat, Shading::Wire}) {
        for (const bool xray : {false, true}) {
            Frame f = frameWith(mesh);
            f.options = ViewOptions{};
            f.options.shading = shading;
            f.options.xray = xray;
            f.options.theme = xray ? Theme::Light : Theme::Dark;
            f.options.normalsNeedles = f.options.wireOverlay = true;
            f.options.pixelRatio = xray ? 2 : 1;
            f.objects[0].dimmed = xray;
            f.objects[0].hovered = true;
            f.camera.frame(boundsOf(f), 1.6);
            std::set<uint32_t> colours;
            const Picture p = draw(f);
            for (size_t i = 0; i < p.rgba.size(); i += 4) colours.insert(uint32_t(p.rgba[i]) << 16 | uint32_t(p.rgba[i + 1]) << 8 | p.rgba[i + 2]);
            EXPECT_GT(colours.size(), 100u);
        }
    }
}

TEST_F(Pictures, EmptyFramesAndOddSizes)
{
    Frame f;
    EXPECT_NO_THROW(offscreen_->draw(f, 1, 1));
    EXPECT_NO_THROW(offscreen_->draw(f, 33, 7));
    EXPECT_THROW(offscreen_->draw(f, 0, 7), Error);
    EXPECT_THROW(offscreen_->draw(f, 1000000, 7), Error);
    f.objects.push_back({});
    EXPECT_NO_THROW(draw(f));
}

}  // namespace
}  // namespace mw
