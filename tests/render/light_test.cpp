// Light on materials: what is known in closed form. Furnaces, Lambert's cosine, textures of each kind, shadows.
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <numbers>

#include "render/colors.h"
#include "render/environment.h"
#include "render/image.h"
#include "render/matcap.h"

#include "offscreen_test.h"
#include "shapes.h"

namespace mw {
namespace {

using namespace test;

constexpr int width = 320, height = 240;

class Light : public OffscreenTest<width, height> {};

glm::dvec3 linearColor(glm::ivec4 c)
{
    return glm::dvec3(linearOf(glm::vec3(c) / 255.f));
}

/// Half a step of 8 bits at a linear value.
double step(double linear)
{
    return 0.004 + 0.012 * std::sqrt(std::max(linear, 0.0));
}

std::shared_ptr<Material> material(glm::dvec4 base, double metallic, double roughness)
{
    auto m = std::make_shared<Material>();
    m->baseColor = base;
    m->metallic = metallic;
    m->roughness = roughness;
    return m;
}

Frame litBy(const char* environment, Mesh mesh, std::shared_ptr<const Material> m, double distance = 3)
{
    Frame f = frameWith(std::move(mesh), distance);
    f.options.lighting = Lighting::Environment;
    f.options.environment = environment;
    f.objects[0].materials = {std::move(m)};
    return f;
}

EncodedPicture encoded(const Picture& p)
{
    const std::string file = testing::TempDir() + "light_test.png";
    writePng(p, file);
    auto bytes = std::make_shared<std::vector<uint8_t>>();
    FILE* in = std::fopen(file.c_str(), "rb");
    for (int c; (c = std::fgetc(in)) != EOF;) bytes->push_back(uint8_t(c));
    std::fclose(in);
    return bytes;
}

/// A picture of one colour.
EncodedPicture oneColour(glm::ivec4 c)
{
    return encoded({1, 1, {uint8_t(c.x), uint8_t(c.y), uint8_t(c.z), uint8_t(c.w)}});
}

/// The unit plane with texture coordinates: set 0 over it once, set 1 constant.
Mesh texturedPlane(glm::vec2 second = {0.5f, 0.5f})
{
    return plane(1)
        .with(floatAttribute("texcoord", Domain::Corner, 2, {0, 0, 1, 0, 1, 1, 0, 1}))
        .with(floatAttribute("texcoord1", Domain::Corner, 2, {second.x, second.y, second.x, second.y, second.x, second.y, second.x, second.y}));
}

TEST_F(Light, AWhiteFurnaceSendsAllLightBack)
{
    for (const double metallic : {0.0, 0.5, 1.0})
        for (const double roughness : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const Picture p = draw(litBy("even", sphere(5), material(glm::dvec4(1), metallic, roughness)));
            // From the middle nearly to the rim: all angles of view.
            for (int x = width / 2; x < width / 2 + 84; x += 7) {
                const glm::dvec3 c = linearColor(at(p, x, height / 2));
                for (int k = 0; k < 3; ++k) {
                    EXPECT_GT(c[k], 0.985) << metallic << " " << roughness << " at " << x;
                    EXPECT_LE(c[k], 1.0);
                }
            }
        }
}

TEST_F(Light, AGreyFurnaceNeverSendsMoreThanItGets)
{
    for (const double metallic : {0.0, 1.0})
        for (const double roughness : {0.1, 0.6, 1.0}) {
            const Picture p = draw(litBy("even", sphere(5), material({0.5, 0.5, 0.5, 1}, metallic, roughness)));
            const double middle = linearColor(at(p, width / 2, height / 2)).g;
            // Head on a dielectric mirrors 4 % and scatters half of the rest; a metal mirrors its colour (a little less where it is rough).
            const double expected = metallic > 0 ? 0.5 : 0.04 + 0.96 * 0.5;
            EXPECT_LT(middle, expected + 0.02) << metallic << " " << roughness;
            EXPECT_GT(middle, expected - (metallic > 0 ? 0.2 * roughness : 0.012))
                << metallic << " " << roughness;  // each bounce among its facets takes half
        }
}

TEST_F(Light, ReflectanceTableAgainstAnotherQuadrature)
{
    // The same integral over the hemisphere of light directions on a grid of angles, weighted by solid angle.
    const std::vector<glm::vec2> table = reflectanceTable();
    const auto byGrid = [](double nv, double roughness) {
        const double a2 = std::pow(roughness, 4), pi = std::numbers::pi;
        const glm::dvec3 v(std::sqrt(1 - nv * nv), 0, nv);
        glm::dvec2 sum(0);
        constexpr int rows = 400, columns = 400;
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < columns; ++j) {
                const double theta = 0.5 * pi * (i + 0.5) / rows, phi = 2 * pi * (j + 0.5) / columns;
                const glm::dvec3 l(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)), h = glm::normalize(l + v);
                const double nh = h.z, nl = l.z, vh = glm::dot(v, h), d = a2 / (pi * std::pow(nh * nh * (a2 - 1) + 1, 2));
                const auto lambda = [&](double c) { return (std::sqrt(1 + a2 * (1 - c * c) / (c * c)) - 1) / 2; };
                const double g = 1 / (1 + lambda(nl) + lambda(nv)),
                             f = d * g / (4 * nl * nv) * nl * std::sin(theta) * (0.5 * pi / rows) * (2 * pi / columns);
                const double grazing = std::pow(1 - vh, 5);
                sum += f * glm::dvec2(1 - grazing, grazing);
            }
        return sum;
    };
    for (const int x : {6, 15, 24, 31})
        for (const int y : {12, 20, 31}) {
            const glm::dvec2 expected = byGrid(x / 31.0, y / 31.0), seen(table[size_t(y * reflectanceSide + x)]);
            EXPECT_NEAR(seen.x, expected.x, 0.025) << x << " " << y;
            EXPECT_NEAR(seen.y, expected.y, 0.025) << x << " " << y;
        }
}

TEST_F(Light, HarmonicsOfKnownSkies)
{
    // Even light is 1 from all sides. A half-bright sky (1 above, 0 below) gives (1 + ny) / 2; nine numbers come within 6 % of it.
    for (const glm::vec3 n : {glm::vec3(0, 1, 0), glm::vec3(1, 0, 0), glm::normalize(glm::vec3(1, -2, 3))})
        EXPECT_NEAR(evaluate(harmonicsOf(*findEnvironment("even")), n).g, 1, 1e-3);
    Environment half = *findEnvironment("even");
    half.around = [](glm::vec3 d) { return glm::vec3(d.y > 0 ? 1.f : 0.f); };
    const auto h = harmonicsOf(half);
    for (double y = -1; y <= 1; y += 0.25) EXPECT_NEAR(evaluate(h, glm::vec3(std::sqrt(1 - y * y), y, 0)).g, 0.5 + 0.5 * y, 0.06) << y;
    EXPECT_NEAR(keyOf(*findEnvironment("sun")).g, 1, 1e-6);
}

TEST_F(Light, OneDirectionalLightFollowsTheCosine)
{
    // Head on a plane that turns away from the sun: albedo times cosine for the matt part, and what a rough dielectric mirrors,
    // by the formulas of glTF's appendix B.
    const glm::dvec3 sun(findEnvironment("sun")->keyDirection);
    const double albedo = 0.6, roughness = 0.9, pi = std::numbers::pi;
    for (double angle = 0; angle < 2 * pi; angle += pi / 7) {
        Frame f = litBy("sun", plane(1), material(glm::dvec4(glm::dvec3(albedo), 1), 0, roughness));
        f.camera.perspective = false;
        f.options.environmentTurn = angle;
        const glm::dvec3 l(std::cos(angle) * sun.x + std::sin(angle) * sun.z, sun.y, -std::sin(angle) * sun.x + std::cos(angle) * sun.z);
        const glm::dvec3 v(0, 0, 1), h = glm::normalize(l + v);
        const double nl = std::max(l.z, 0.0), a2 = std::pow(roughness, 4), nh = h.z, vh = glm::dot(v, h);
        const double fresnel = 0.04 + 0.96 * std::pow(1 - vh, 5), d = a2 / (pi * std::pow(nh * nh * (a2 - 1) + 1, 2));
        const double k = roughness * roughness / 2, g = nl > 0 ? nl / (nl * (1 - k) + k) : 0;  // Schlick's shadowing; 1 for the eye
        const double expected = nl > 0 ? albedo * (1 - fresnel) * nl + pi * nl * fresnel * d * g / (4 * nl) : 0;
        const double seen = linearColor(at(draw(f), f.camera, {0.1, 0.1, 0}))[1];
        EXPECT_NEAR(seen, expected, step(expected)) << angle;
    }
}

TEST_F(Light, EachPictureDoesItsPart)
{
    // Under even light a matt surface shows its colour.
    const auto shown = [&](const Material& m, const MaterialPictures& pictures, glm::vec2 second = {0.5f, 0.5f}) {
        Frame f = litBy("even", texturedPlane(second), std::make_shared<Material>(m));
        f.camera.perspective = false;
        f.objects[0].pictures = {pictures};
        return linearColor(at(draw(f), f.camera, {0.2, -0.3, 0}));
    };
    Material m;
    m.baseColor = {1, 1, 1, 1};
    m.roughness = 1;
    const double mirrored = 0.04;
    // Base colour is sRGB: 188 is half the light.
    glm::dvec3 c = shown(m, {oneColour({188, 188, 188, 255})});
    EXPECT_NEAR(c.g, mirrored + (1 - mirrored) * 0.503, 0.015);
    // Metallic-roughness are numbers: blue 255 is metal, so black mirrors nothing and sends nothing back.
    m.baseColor = {0, 0, 0, 1};
    m.metallic = 1;
    c = shown(m, {nullptr, oneColour({0, 128, 255, 255})});
    EXPECT_LT(c.g, 0.012);
    c = shown(m, {nullptr, oneColour({0, 128, 0, 255})});
    EXPECT_NEAR(c.g, mirrored, 0.012);
    // Occlusion, red alone, by its strength.
    m.baseColor = {1, 1, 1, 1};
    m.metallic = 0;
    m.occlusionStrength = 0.5;
    c = shown(m, {nullptr, nullptr, nullptr, oneColour({0, 255, 255, 255})});
    EXPECT_NEAR(c.g, 0.5, 0.015);
    // Emission is added, sRGB.
    m.baseColor = {0, 0, 0, 1};
    m.metallic = 1;
    m.emissive = {0.5, 1, 0};
    c = shown(m, {nullptr, nullptr, nullptr, nullptr, oneColour({255, 188, 255, 255})});
    EXPECT_NEAR(c.r, 0.5, 0.015);
    EXPECT_NEAR(c.g, 0.503, 0.015);
    EXPECT_NEAR(c.b, 0, 0.012);
    // The second set: one picture, black on the left and white on the right.
    m.emissive = {0, 0, 0};
    m.metallic = 0;
    m.baseColor = {1, 1, 1, 1};
    m.baseColorTexture.set = 1;
    m.baseColorTexture.repeat = false;
    const EncodedPicture sides = encoded({2, 1, {0, 0, 0, 255, 255, 255, 255, 255}});
    EXPECT_LT(shown(m, {sides}, {0.05f, 0.5f}).g, 0.06);
    EXPECT_GT(shown(m, {sides}, {0.95f, 0.5f}).g, 0.95);
}

/// The plane bent by a normal map that leans by 45 degrees to a side, under a sun from that side.
double bumpyLight(glm::vec2 leaning, bool withTangents, bool mirrored)
{
    const float u0 = mirrored ? 1.f : 0.f, u1 = 1 - u0;
    Mesh mesh = plane(1).with(floatAttribute("texcoord", Domain::Corner, 2, {u0, 0, u1, 0, u1, 1, u0, 1}));
    const float x = mirrored ? -1.f : 1.f;
    if (withTangents) {
        Array<float> t;
        for (int i = 0; i < 4; ++i)
            for (const float v : {x, 0.f, 0.f, x}) t.push_back(v);
        mesh = mesh.with(floatAttribute("tangent", Domain::Corner, 4, std::move(t)));
    }
    Frame f = litBy("sun", mesh, material(glm::dvec4(1), 0, 1));
    f.camera.perspective = false;
    const double s = std::numbers::sqrt2 / 2;
    f.objects[0].pictures = {
        {nullptr, nullptr,
         oneColour({int(std::lround(127.5 + 127.5 * s * leaning.x)), int(std::lround(127.5 + 127.5 * s * leaning.y)), int(127.5 + 127.5 * s), 255})}};
    Offscreen offscreen(false);
    return linearColor(at(offscreen.draw(f, width, height), f.camera, {0.2, -0.3, 0}))[1];
}

TEST_F(Light, NormalMapsLeanTheRightWay)
{
    const glm::dvec3 sun(findEnvironment("sun")->keyDirection);
    const double s = std::numbers::sqrt2 / 2;
    for (const bool tangents : {false, true})
        for (const bool mirrored : {false, true})
            for (const glm::vec2 lean : {glm::vec2(1, 0), glm::vec2(-1, 0), glm::vec2(0, 1), glm::vec2(0, -1)}) {
                // x leans along growing u, y (green) upwards in the picture, which is +Y here.
                const glm::dvec3 n(s * lean.x * (mirrored ? -1 : 1), s * lean.y, s);
                const double expected = std::max(glm::dot(n, sun), 0.0);
                EXPECT_NEAR(bumpyLight(lean, tangents, mirrored), expected, 0.06 + 0.02 * expected) << tangents << mirrored << lean.x << lean.y;
            }
}

TEST_F(Light, CutOutsAreHolesAndBlendingIsNot)
{
    const EncodedPicture half = encoded({2, 1, {255, 255, 255, 255, 255, 255, 255, 100}});
    auto m = material(glm::dvec4(1), 0, 1);
    m->alpha = Material::Alpha::Mask;
    m->baseColorTexture.repeat = false;
    Frame f = litBy("even", texturedPlane(), m);
    f.camera.perspective = false;
    f.objects[0].pictures = {{half}};
    Frame none = f;
    none.objects.clear();
    const Picture cut = draw(f), empty = draw(none);
    EXPECT_GT(linearColor(at(cut, f.camera, {-0.7, 0, 0})).g, 0.95);
    EXPECT_EQ(at(cut, f.camera, {0.7, 0, 0}), at(empty, f.camera, {0.7, 0, 0}));
    m->alpha = Material::Alpha::Blend;
    const glm::ivec4 through = at(draw(f), f.camera, {0.7, 0, 0}), behind = at(empty, f.camera, {0.7, 0, 0});
    EXPECT_NEAR(through.g, behind.g + (255 - behind.g) * 100.0 / 255, 3);
    m->alpha = Material::Alpha::Opaque;
    EXPECT_GT(linearColor(at(draw(f), f.camera, {0.7, 0, 0})).g, 0.95);
}

TEST_F(Light, DoubleSidedFacesAreNotDarkerFromBehind)
{
    auto m = material(glm::dvec4(1), 0, 1);
    Frame f = litBy("even", plane(1), m);
    f.camera.azimuth = std::numbers::pi;
    EXPECT_LT(linearColor(at(draw(f), f.camera, {0, 0, 0})).r, 0.8);
    m->doubleSided = true;
    EXPECT_GT(linearColor(at(draw(f), f.camera, {0, 0, 0})).r, 0.98);
}

TEST_F(Light, VertexColoursMultiplyTheBase)
{
    Array<float> c;
    for (int i = 0; i < 4; ++i)
        for (const float v : {0.5f, 1.f, 0.25f}) c.push_back(v);
    Frame f = litBy("even", plane(1).with(floatAttribute("color", Domain::Vertex, 3, std::move(c))), material({1, 0.5, 0.5, 1}, 0, 1));
    const glm::dvec3 seen = linearColor(at(draw(f), f.camera, {0, 0, 0}));
    EXPECT_NEAR(seen.r, 0.04 + 0.96 * 0.5, 0.02);
    EXPECT_NEAR(seen.g, 0.04 + 0.96 * 0.5, 0.02);
    EXPECT_NEAR(seen.b, 0.04 + 0.96 * 0.125, 0.03);
}

TEST_F(Light, ShadowsFallWhereTheSunDoesNotReach)
{
    // A small plate above a large one. Where its shadow falls is a line from the sun.
    const glm::dvec3 sun(findEnvironment("sun")->keyDirection);
    const auto level = [](float half, float y) {
        return Mesh(Array<glm::vec3>{{-half, y, -half}, {-half, y, half}, {half, y, half}, {half, y, -half}}, Array<uint32_t>{0u, 4u},
                    Array<uint32_t>{0u, 1u, 2u, 3u});
    };
    Frame f = litBy("sun", level(3, 0), material(glm::dvec4(1), 0, 1), 8);
    f.camera.elevation = 1.2;
    f.objects.push_back(f.objects[0]);
    f.objects[1].node = NodeId{8};
    f.objects[1].mesh = level(0.5f, 1);
    const glm::dvec3 shadowed = -sun / sun.y + glm::dvec3(0, 1, 0);  // from the middle of the plate down to y = 0
    const auto lightAt = [&](const Frame& of, glm::dvec3 p) { return linearColor(at(draw(of), of.camera, p)).g; };
    EXPECT_NEAR(lightAt(f, shadowed), sun.y, 0.06);
    f.options.shadows = true;
    EXPECT_LT(lightAt(f, shadowed), 0.01);
    EXPECT_LT(lightAt(f, shadowed + glm::dvec3(0.4, 0, 0.4)), 0.01);
    for (const glm::dvec3 beside : {glm::dvec3(0.65, 0, 0), glm::dvec3(-0.65, 0, 0), glm::dvec3(0, 0, 0.65), glm::dvec3(0, 0, -0.65)})
        EXPECT_NEAR(lightAt(f, shadowed + beside), sun.y, 0.06);
    EXPECT_NEAR(lightAt(f, {0, 1, 0}), sun.y, 0.06);  // the plate does not darken itself
    // Alone it darkens the ground, and only there.
    f.objects.erase(f.objects.begin());
    f.options.theme = Theme::Light;
    const Picture with = draw(f);
    f.options.shadows = false;
    const Picture without = draw(f);
    EXPECT_LT(linearColor(at(with, f.camera, shadowed)).g, 0.5 * linearColor(at(without, f.camera, shadowed)).g);
    EXPECT_EQ(at(with, f.camera, {2, 0, 2}), at(without, f.camera, {2, 0, 2}));
    // Light from everywhere casts none.
    f.options.environment = "even";
    const Picture even = draw(f);
    f.options.shadows = true;
    EXPECT_EQ(draw(f).rgba, even.rgba);
}

TEST_F(Light, AClosedThingInItsOwnShadowHasNoStripes)
{
    // A sphere under the sun: lit half as without shadows, dark half dark.
    Frame f = litBy("sun", sphere(5), material(glm::dvec4(1), 0, 1));
    const Picture without = draw(f);
    f.options.shadows = true;
    f.options.grid = false;
    const Picture with = draw(f);
    size_t differ = 0, seen = 0;
    for (int y = 40; y < height - 40; ++y)
        for (int x = 80; x < width - 80; ++x) {
            const glm::ivec4 a = at(without, x, y);
            if (a.x < 110) continue;  // near its terminator the soft edge may reach
            ++seen;
            differ += distance(a, at(with, x, y)) > 4;
        }
    EXPECT_GT(seen, 5000u);
    EXPECT_LT(differ, seen / 500);
}

TEST_F(Light, EnvironmentsStayWhenTheCameraTurnsAndTurnWithTheirOption)
{
    Frame f = litBy("sunset", sphere(5), material(glm::dvec4(1), 1, 0.3));
    const Picture here = draw(f);
    f.camera.azimuth += 0.9;
    const Picture moved = draw(f);
    EXPECT_NE(here.rgba, moved.rgba);
    f.options.environmentTurn = 0.9;  // what turns with the camera looks the same on a sphere
    const Picture turned = draw(f);
    double most = 0;
    for (int y = 40; y < height - 40; y += 3)
        for (int x = 100; x < width - 100; x += 3) most = std::max(most, double(distance(at(here, x, y), at(turned, x, y))));
    EXPECT_LE(most, 12);
}

TEST_F(Light, MatcapsShowTheirSphere)
{
    for (const Matcap& m : matcaps()) {
        Frame f = frameWith(sphere(6), 3);
        f.camera.perspective = false;
        f.options.shading = Shading::Matcap;
        f.options.matcap = m.name;
        const Picture p = draw(f);
        for (const glm::dvec2 xy : {glm::dvec2(0, 0), glm::dvec2(0.5, 0.2), glm::dvec2(-0.4, 0.6), glm::dvec2(0.1, -0.7)}) {
            const glm::dvec3 n(xy, std::sqrt(1 - glm::dot(xy, xy)));
            const glm::dvec3 expected = glm::clamp(glm::dvec3(m.shade(glm::vec3(n))), 0.0, 1.0), seen = linearColor(at(p, f.camera, n));
            // A pixel is wide enough for the stripes of one of them to change.
            const glm::dvec3 near(m.shade(glm::normalize(glm::vec3(n) + glm::vec3(0.012f, 0.012f, 0)))), change = glm::abs(near - expected);
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(seen[k], expected[k], 0.03 + 0.05 * expected[k] + change[k]) << m.name << " " << xy.x << " " << xy.y;
        }
    }
}

TEST_F(Light, CheckersFollowTextureCoordinates)
{
    Frame f = litBy("even", texturedPlane(), material(glm::dvec4(1), 0, 1));
    f.camera.perspective = false;
    f.options.checker = true;
    const Picture p = draw(f);
    int changes = 0;
    bool last = false;
    // Along a line in the middle of a row of squares: ten of them.
    for (double x = -0.98; x < 0.98; x += 0.01) {
        const bool light = linearColor(at(p, f.camera, {x, 0.1, 0})).g > 0.3;
        if (x > -0.98 && light != last) ++changes;
        last = light;
    }
    EXPECT_EQ(changes, 9);
    f.objects[0].mesh = plane(1);  // without coordinates it is drawn all the same
    EXPECT_GT(linearColor(at(draw(f), f.camera, {0, 0, 0})).g, 0.1);
}

}  // namespace
}  // namespace mw
