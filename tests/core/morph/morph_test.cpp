// The operation morph: tori against their equation, equal connectivity, what auto takes, attributes, errors.
#include "core/morph/morph.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "core/catalog/lesson.h"
#include "core/catalog/others.h"
#include "core/character/skin.h"
#include "core/io/io.h"
#include "core/mesh/topology.h"
#include "core/morph/parametric_morph.h"
#include "core/morph/target.h"
#include "core/steps/stepper.h"
#include "tests/data.h"
#include "tests/mesh_checks.h"

namespace mw {
namespace {

Mesh morphedBy(const Mesh& mesh, const std::string& parameters, const Mesh& other = {})
{
    const Operation& op = operation("morph");
    const ParameterValues values = parsed(op.parameters, parameters);
    Others others = othersOf(op, values, [&](const std::string& name) { return name == "x" ? std::optional(other) : std::nullopt; });
    return std::get<Mesh>(apply(op, mesh, values, nullptr, others));
}

Mesh at(const Mesh& mesh, double t)
{
    return towardsTarget(mesh, t);
}

Mesh read(const std::filesystem::path& file)
{
    const Imported in = readFile(file);
    return in.scene.find(in.scene.meshes().front())->base;
}

double offTorus(const Mesh& mesh, double radius, double tube)
{
    double worst = 0;
    for (const glm::vec3& p : mesh.positions()) {
        const double ring = std::hypot(double(p.x), double(p.z)) - radius;
        worst = std::max(worst, std::abs(std::hypot(ring, double(p.y)) - tube));
    }
    return worst;
}

TEST(CylinderTorus, EndsOnTheTorus)
{
    const Mesh open = *meshOfSource("cylinder:caps=open,segments=24,rings=16,height=2");
    const Mesh m = morphedBy(open, "method=cylinder-torus,radius=1.5,tube=0.4");
    EXPECT_EQ(m.vertexCount(), open.vertexCount());
    EXPECT_EQ(m.faceCount(), open.faceCount());
    ASSERT_TRUE(m.find("morph:torus"));
    EXPECT_LT(offTorus(at(m, 1), 1.5, 0.4), 1e-5);
    // The outside stays the outside: the torus is closed but for the joined ends, so its volume is that of the polyhedron, above 0.
    const double full = 2 * std::pow(std::numbers::pi, 2) * 1.5 * 0.4 * 0.4;
    EXPECT_NEAR(enclosedVolume(at(m, 1)), full, 0.06 * full);
    // Both ends come to the inner ring, the middle to the outer one.
    for (size_t v = 0; v < m.vertexCount(); ++v) {
        const double y = double(open.positions()[v].y), ring = std::hypot(double(at(m, 1).positions()[v].x), double(at(m, 1).positions()[v].z));
        if (std::abs(std::abs(y) - 1) < 1e-6) {
            EXPECT_NEAR(ring, 1.1, 1e-5);
        }
        if (std::abs(y) < 1e-6) {
            EXPECT_NEAR(ring, 1.9, 1e-5);
        }
    }
}

TEST(CylinderTorus, LeavesCapsOut)
{
    const Mesh open = *meshOfSource("cylinder:caps=open,segments=12,rings=6");
    for (const char* caps : {"fan", "polygon"}) {
        const Mesh m = morphedBy(*meshOfSource(std::string("cylinder:segments=12,rings=6,caps=") + caps), "method=cylinder-torus");
        EXPECT_EQ(m.faceCount(), open.faceCount()) << caps;
        EXPECT_EQ(m.vertexCount(), open.vertexCount()) << caps;
        EXPECT_LT(offTorus(at(m, 1), 1, 0.35), 1e-5);
    }
    EXPECT_THROW(morphedBy(*meshOfSource("grid"), "method=cylinder-torus"), Error);
    EXPECT_THROW(morphedBy(open, "method=cylinder-torus,radius=1,tube=2"), Error);
}

void expectSphereTorus(const Mesh& sphere)
{
    const Mesh m = morphedBy(sphere, "method=sphere-torus,radius=1.2,tube=0.3"), torus = at(m, 1);
    EXPECT_TRUE(test::checkMesh(m));
    EXPECT_LT(offTorus(torus, 1.2, 0.3), 1e-5);
    EXPECT_NEAR(enclosedVolume(m), enclosedVolume(sphere), 1e-5 * enclosedVolume(sphere));
    EXPECT_NEAR(surfaceArea(m), surfaceArea(sphere), 1e-5 * surfaceArea(sphere));
    const double full = 2 * std::pow(std::numbers::pi, 2) * 1.2 * 0.3 * 0.3;
    EXPECT_NEAR(enclosedVolume(torus), full, 0.15 * full);
    const TopologyReport& t = m.topology();
    EXPECT_TRUE(t.manifold());
    EXPECT_TRUE(t.consistentlyOriented);
    EXPECT_EQ(t.boundaryLoops.size(), 2u) << "open at both poles";
    EXPECT_EQ(t.euler, 0);
    for (const auto& loop : t.boundaryLoops)
        for (const uint32_t v : loop) {
            EXPECT_NEAR(std::hypot(double(torus.positions()[v].x), double(torus.positions()[v].z)), 0.9, 1e-5) << "on the inner ring";
            EXPECT_NEAR(std::hypot(double(m.positions()[v].x), double(m.positions()[v].z)), 0, 1e-5) << "at the pole";
        }
}

TEST(SphereTorus, IsCutOpenAtVerticesEdgesAndFaces)
{
    expectSphereTorus(*meshOfSource("uv-sphere:segments=24,rings=16"));                                           // poles at vertices
    for (int n = 1; n < 4; ++n) expectSphereTorus(*meshOfSource("icosphere:subdivisions=" + std::to_string(n)));  // in the middle of edges
    const Mesh ico = *meshOfSource("icosphere:subdivisions=3");
    Array<glm::vec3> p;
    for (const glm::vec3& v : ico.positions()) p.push_back({v.x, 0.98f * v.y - 0.199f * v.z, 0.199f * v.y + 0.98f * v.z});
    expectSphereTorus(ico.withPositions(p));  // inside faces
}

TEST(Torus, IsReadOffTheOtherMesh)
{
    const TorusShape t = torusThrough(*meshOfSource("torus:radius=2.5,tube=0.75,segments=11,sides=7"));
    EXPECT_NEAR(t.radius, 2.5, 1e-5);
    EXPECT_NEAR(t.tube, 0.75, 1e-5);
    EXPECT_THROW(torusThrough(*meshOfSource("box:segments=3")), Error);
    const Mesh m = morphedBy(*meshOfSource("uv-sphere"), "other=torus:radius=2");
    EXPECT_LT(offTorus(at(m, 1), 2, 0.35), 1e-5) << "auto takes sphere-torus";
    EXPECT_LT(offTorus(at(morphedBy(*meshOfSource("cylinder:caps=open,rings=8"), "other=torus"), 1), 1, 0.35), 1e-5);
}

TEST(Corresponding, GoesVertexToVertex)
{
    const Mesh a = *meshOfSource("icosphere:subdivisions=2"), b = *meshOfSource("icosphere:subdivisions=2,radius=3");
    const Mesh m = morphedBy(a, "other=x", b);
    EXPECT_EQ(m.faceCount(), a.faceCount());
    for (size_t v = 0; v < a.vertexCount(); ++v)
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(at(m, 1).positions()[v][k], b.positions()[v][k], 1e-6);
    EXPECT_THROW(morphedBy(a, "other=x,method=corresponding", *meshOfSource("box")), Error);
}

TEST(Morph, KeepsTargetsThatAreThere)
{
    const Mesh a = *meshOfSource("icosphere:subdivisions=2");
    const Mesh twice = morphedBy(morphedBy(morphedBy(a, "other=box"), "other=uv-sphere"), "other=x", a);
    size_t targets = 0;
    for (const Attribute& t : twice.attributes()) targets += t.name.starts_with(names::morph);
    EXPECT_EQ(targets, 3u);
    const Attribute* box = twice.find("morph:box");
    ASSERT_TRUE(box);
    Array<glm::vec3> p(twice.positions().begin(), twice.positions().end());
    for (size_t v = 0; v < p.size(); ++v)
        for (int k = 0; k < 3; ++k) p[v][k] += float(box->at(v, k));
    EXPECT_NEAR(enclosedVolume(twice.withPositions(p)), 1, 1e-5);
    const Mesh same = morphedBy(morphedBy(a, "other=box"), "other=box");
    EXPECT_TRUE(same.find("morph:box"));
    EXPECT_TRUE(same.find("morph:box 2"));
}

/// Red, green and blue by x, y and z: linear, so that places between the vertices have theirs, too.
glm::dvec3 colourAt(const glm::dvec3& p)
{
    return 0.5 + 0.2 * p;
}

Mesh coloured(const Mesh& mesh, Domain domain)
{
    Array<float> c;
    for (size_t i = 0; i < mesh.count(domain); ++i) {
        const glm::dvec3 colour = colourAt(glm::dvec3(mesh.positions()[domain == Domain::Corner ? mesh.cornerVertex()[i] : i]));
        for (int k = 0; k < 3; ++k) c.push_back(float(colour[k]));
    }
    return mesh.with(floatAttribute("color", domain, 3, std::move(c)));
}

/// At weight t every element has the colour of its place there, or white where the mesh of that end had none.
void expectColours(const Mesh& m, double t, bool white)
{
    MeshPose pose;
    pose.morphWeights = {float(t)};
    const Mesh there = posed(m, pose);
    const Attribute* c = there.find("color");
    ASSERT_TRUE(c);
    for (size_t i = 0; i < c->size(); ++i) {
        const glm::dvec3 want =
            white ? glm::dvec3(1) : colourAt(glm::dvec3(there.positions()[c->domain == Domain::Corner ? there.cornerVertex()[i] : i]));
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(c->at(i, k), want[k], 1e-5);
    }
}

TEST(Morph, ColoursOfBothEnds)
{
    const Mesh box = *meshOfSource("box"), ball = *meshOfSource("icosphere:subdivisions=1"),
               other = *meshOfSource("icosphere:subdivisions=1,radius=2");
    for (const Domain d : {Domain::Vertex, Domain::Corner}) {
        const Mesh both = morphedBy(coloured(box, Domain::Vertex), "other=x", coloured(ball, d));
        EXPECT_EQ(both.find("color")->domain, d);
        expectColours(both, 0, false);
        expectColours(both, 1, false);
        const Mesh second = morphedBy(box, "other=x", coloured(ball, d));
        expectColours(second, 0, true);
        expectColours(second, 1, false);
        const Mesh same = morphedBy(coloured(ball, Domain::Corner), "other=x", coloured(other, d));
        expectColours(same, 0, false);
        expectColours(same, 1, false);
    }
    const Mesh first = morphedBy(coloured(box, Domain::Vertex), "other=x", ball);
    expectColours(first, 0, false);
    EXPECT_FALSE(first.find("morph-color:x"));
}

TEST(Morph, SaysWhyNothingFits)
{
    const auto why = [](const Mesh& a, const std::string& parameters, const Mesh& b) -> std::string {
        try {
            morphedBy(a, parameters, b);
        } catch (const Error& e) {
            return e.what();
        }
        return {};
    };
    const Mesh sphere = *meshOfSource("icosphere"), torus = *meshOfSource("torus"), grid = *meshOfSource("grid");
    EXPECT_NE(why(torus, "other=x", sphere).find("handle"), std::string::npos);
    EXPECT_NE(why(grid, "other=x", sphere).find("disk"), std::string::npos);
    EXPECT_NE(why(sphere, "", {}).find("choose the other mesh"), std::string::npos);
    EXPECT_NE(why(sphere, "other=x", {}).find("no faces"), std::string::npos);
    EXPECT_NE(why(grid, "method=projective,other=x", sphere).find("closed"), std::string::npos);
}

TEST(Morph, InterpolatesAttributesOnTheSurface)
{
    const Mesh ball = *meshOfSource("icosphere:subdivisions=3");
    Array<float> place, corner;
    Array<int32_t> face;
    for (const glm::vec3& p : ball.positions()) place.insert(place.end(), {p.x, p.y, p.z});
    for (const uint32_t v : ball.cornerVertex()) corner.insert(corner.end(), {ball.positions()[v].x, ball.positions()[v].y});
    for (size_t f = 0; f < ball.faceCount(); ++f) face.push_back(int32_t(f));
    const Mesh with = ball.with(floatAttribute("place", Domain::Vertex, 3, place))
                          .with(floatAttribute("texcoord", Domain::Corner, 2, corner))
                          .with(integerAttribute("number", Domain::Face, 1, face));
    const Mesh m = morphedBy(with, "other=box:segments=7");
    EXPECT_TRUE(test::checkMesh(m));
    const Attribute *p = m.find("place"), *t = m.find("texcoord"), *n = m.find("number");
    for (size_t v = 0; v < m.vertexCount(); ++v)
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(p->at(v, k), m.positions()[v][k], 1e-6);
    for (size_t c = 0; c < m.cornerCount(); ++c)
        for (int k = 0; k < 2; ++k) ASSERT_NEAR(t->at(c, k), m.positions()[m.cornerVertex()[c]][k], 1e-6);
    for (size_t f = 0; f < m.faceCount(); ++f) {  // each piece lies in the face it says
        const auto of = ball.face(size_t(n->at(f, 0)));
        const glm::dvec3 normal(m.faceNormals()[f]), old(ball.faceNormals()[size_t(n->at(f, 0))]);
        for (const uint32_t v : m.face(f)) ASSERT_NEAR(glm::dot(glm::dvec3(m.positions()[v] - ball.positions()[of[0]]), old), 0, 1e-6);
        EXPECT_GT(glm::dot(normal, old), 0.5);
    }
}

TEST(Morph, StepsOfEveryMethodAreInTheLessonAndChangeNothing)
{
    const Operation& op = operation("morph");
    const Lesson* lesson = findLesson("morph");
    ASSERT_TRUE(lesson);
    const std::pair<const char*, const char*> cases[] = {
        {"icosphere:subdivisions=1", "other=box,method=projective"}, {"icosphere:subdivisions=1", "other=box,method=spherical"},
        {"grid:columns=3,rows=2", "other=grid,method=barycentric"},  {"icosphere:subdivisions=1", "method=sphere-torus"},
        {"cylinder:caps=open,rings=4", "method=cylinder-torus"},     {"box", "other=\"box:width=2\""}};
    for (const auto& [source, words] : cases) {
        const ParameterValues values = parsed(op.parameters, words);
        const Mesh mesh = *meshOfSource(source);
        Stepper s(stepping(op, mesh, values, othersOf(op, values)));
        while (s.forward() && !s.atEnd()) {
            const LessonPhase* phase = lesson->phase(s.step().phase);
            ASSERT_TRUE(phase) << s.step().phase;
            for (const Number& n : s.step().numbers) EXPECT_TRUE(lesson->number(phase->id, n.name)) << phase->id << ": " << n.name;
            const Mesh now = std::get<Mesh>(valueOf(s.value()));
            for (const Focus& f : s.step().focus) {
                if (f.kind == ElementKind::Vertex) {
                    EXPECT_LT(f.index, now.vertexCount()) << phase->id;
                }
                if (f.kind == ElementKind::Face) {
                    EXPECT_LT(f.index, now.faceCount()) << phase->id;
                }
            }
        }
        EXPECT_EQ(contentHash(valueOf(s.value())), contentHash(apply(op, mesh, values, nullptr, othersOf(op, values)))) << words;
    }
}

TEST(Morph, SausagesOfEqualFaces)
{
    MESHWRIGHT_DATA_OR_SKIP(data);
    const auto mesh = [&](const char* name) { return read(data / "meshes/morph_pairs" / name); };
    const Mesh a = mesh("sausage_base_0.obj"), b = mesh("sausage_wiggle_20.obj"), m = morphedBy(a, "other=x", b);
    EXPECT_EQ(m.faceCount(), a.faceCount());
    EXPECT_NEAR(enclosedVolume(at(m, 1)), enclosedVolume(b), 1e-5 * enclosedVolume(b));
}

}  // namespace
}  // namespace mw
