// What every entry of the catalog must hold, run over the whole list: whoever adds an operation gets these tests without writing them.
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

#include "core/catalog/catalog.h"
#include "core/catalog/lesson.h"
#include "core/steps/stepper.h"

namespace mw {
namespace {

// A grid of quads on a wave, open, with every kind of attribute: what an operation carries can be told from the places.
Mesh testMesh(bool triangles)
{
    const uint32_t n = 9;
    Array<glm::vec3> positions;
    for (uint32_t y = 0; y <= n; ++y)
        for (uint32_t x = 0; x <= n; ++x) positions.push_back({float(x) / n, 0.1f * std::sin(float(x + 2 * y)), float(y) / n});
    Array<uint32_t> start{0u}, corners;
    const auto face = [&](std::initializer_list<uint32_t> vertices) {
        corners.insert(corners.end(), vertices);
        start.push_back(uint32_t(corners.size()));
    };
    for (uint32_t y = 0; y < n; ++y)
        for (uint32_t x = 0; x < n; ++x) {
            const uint32_t a = y * (n + 1) + x, b = a + n + 1;
            if (triangles) {
                face({a, b, b + 1});
                face({a, b + 1, a + 1});
            } else {
                face({a, b, b + 1, a + 1});
            }
        }
    const Mesh bare(positions, start, corners);
    Array<float> texcoord, place;
    for (uint32_t v : bare.cornerVertex()) texcoord.insert(texcoord.end(), {positions[v].x, positions[v].z});
    for (const glm::vec3& p : positions) place.insert(place.end(), {p.x, p.y, p.z});
    Array<int32_t> material;
    for (size_t f = 0; f < bare.faceCount(); ++f) material.push_back(bare.positions()[bare.face(f)[0]].x < 0.5f ? 0 : 1);
    return bare.with(floatAttribute("texcoord", Domain::Corner, 2, texcoord))
        .with(floatAttribute("place", Domain::Vertex, 3, place))
        .with(integerAttribute("material", Domain::Face, 1, material));
}

// A chain of five joints with a twig, each turned out of its rest, and a target within reach of the last one.
Pose testPose()
{
    auto skeleton = std::make_shared<Skeleton>();
    Pose p;
    for (uint32_t i = 0; i < 6; ++i) {
        Joint j;
        j.name = "joint" + std::to_string(i);
        j.parent = i == 0 ? none : i == 5 ? 2 : i - 1;
        j.rest.translation = {i ? 0.5 : 0, 0, 0};
        skeleton->joints.push_back(j);
        Transform t = j.rest;
        t.rotation = aboutAxis(int(i % 3), 0.3 * (i + 1));
        p.locals.push_back(t);
    }
    p.skeleton = std::move(skeleton);
    p.targets = {{4, {0.4, 0.6, 0.5}}};
    return p;
}

Curve testCurve()
{
    return {{{0, 0, 0}, {1, 2, 0}, {2, -1, 0}, {3, 1, 1}, {4, 0, 0}}, {}, false};
}

HeightMap testHeights()
{
    Array<float> rows;
    for (int y = 0; y < 17; ++y)
        for (int x = 0; x < 17; ++x) rows.push_back(0.5f + 0.3f * std::sin(0.7f * float(x)) * std::cos(0.4f * float(y)));
    return HeightMap(17, 17, rows);
}

Rotations testRotations()
{
    Rotations r;
    r.to = aboutAxis(1, 1.2);
    r.paths = {{"slerp", {{0, r.from, {0, 0, 0}}, {1, r.to, {0, 1.2, 0}}}}};
    return r;
}

Value inputFor(const Operation& op)
{
    switch (op.accepts) {
        case Kind::Mesh:
            if (op.id == "embed-spherical") return apply(operation("fill-holes"), testMesh(true), {});  // wants a closed one
            return testMesh(true);
        case Kind::Pose:
            return testPose();
        case Kind::Curve:
            return testCurve();
        case Kind::HeightMap:
            return testHeights();
        case Kind::Rotations:
            return testRotations();
        default:
            return std::monostate{};
    }
}

/// Any mesh will do: operations that cannot work with it say so.
Others othersFor(const Operation& op)
{
    Others others;
    for (const Parameter& p : op.parameters)
        if (p.type == ParameterType::Object) others.emplace(p.name, testMesh(true));
    return others;
}

class Contract : public testing::TestWithParam<const Operation*> {};

TEST_P(Contract, IsDescribed)
{
    const Operation& op = *GetParam();
    EXPECT_FALSE(op.title.empty());
    EXPECT_FALSE(op.summary.empty());
    EXPECT_FALSE(op.category.empty());
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(MESHWRIGHT_SOURCE_DIR) / op.source)) << op.source;
    std::set<std::string> names;
    for (const Parameter& p : op.parameters) {
        EXPECT_TRUE(names.insert(p.name).second) << p.name;
        EXPECT_FALSE(p.about.title.empty()) << p.name;
        EXPECT_FALSE(p.about.help.empty()) << p.name;
        EXPECT_NO_THROW(checked(op.parameters, {{p.name, p.initial}})) << p.name;
    }
}

TEST_P(Contract, ParametersSurviveJsonAndText)
{
    const Operation& op = *GetParam();
    ParameterValues values;
    for (const Parameter& p : op.parameters) {
        values[p.name] = p.initial;
        if (p.type == ParameterType::Choice) values[p.name] = p.choices.back();
        if (p.type == ParameterType::Flag) values[p.name] = !std::get<bool>(p.initial);
        if (p.type == ParameterType::Number && std::isfinite(p.about.max)) values[p.name] = p.about.max;
    }
    EXPECT_EQ(parametersFromJson(op.parameters, nlohmann::json::parse(toJson(values).dump())), values);
    const std::string text = printed(op.parameters, values);
    EXPECT_EQ(printed(op.parameters, parsed(op.parameters, text)), text);
}

TEST_P(Contract, SteppedEqualsRunInOneGo)
{
    const Operation& op = *GetParam();
    const Value input = inputFor(op);
    const uint64_t before = contentHash(input);
    const uint64_t atOnce = contentHash(apply(op, input, {}, nullptr, othersFor(op)));
    Stepper s(stepping(op, input, {}, othersFor(op)));
    while (s.forward()) EXPECT_FALSE(s.step().phase.empty());
    EXPECT_EQ(contentHash(valueOf(s.value())), atOnce);
    EXPECT_EQ(contentHash(apply(op, input, {}, nullptr, othersFor(op))), atOnce) << "twice the same";
    EXPECT_EQ(contentHash(input), before) << "the input is never changed";
}

TEST_P(Contract, BackAndForthGivesTheSameState)
{
    const Operation& op = *GetParam();
    Stepper s(stepping(op, inputFor(op), {}, othersFor(op)), size_t(1) << 20);
    std::vector<uint64_t> hashes{contentHash(valueOf(s.value()))};
    while (hashes.size() < 60 && s.forward()) hashes.push_back(contentHash(valueOf(s.value())));
    for (size_t i = hashes.size(); i-- > 0;) {
        s.seek(i);
        EXPECT_EQ(contentHash(valueOf(s.value())), hashes[i]) << "step " << i;
    }
    s.seek(hashes.size() - 1);
    EXPECT_EQ(contentHash(valueOf(s.value())), hashes.back());
}

TEST_P(Contract, CancellingAndLettingGoLeavesNothingBehind)
{
    const Operation& op = *GetParam();
    const Value input = inputFor(op);
    const uint64_t before = contentHash(input);
    Progress cancelled;
    cancelled.cancelled = true;
    try {
        apply(op, input, {}, &cancelled, othersFor(op));  // one without any pause may end
    } catch (const Cancelled&) {
    }
    const std::unique_ptr<mw::Run> run = stepping(op, input, {}, othersFor(op))(true);
    for (int i = 0; i < 7 && run->advance(); ++i) run->snapshot();
    EXPECT_EQ(contentHash(input), before);
}

TEST_P(Contract, OddMeshesGiveAResultOrAnError)
{
    const Operation& op = *GetParam();
    if (op.accepts != Kind::Mesh) return;  // not about it
    const Array<glm::vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    const Mesh odd[] = {
        Mesh(),
        Mesh(points, Array<uint32_t>{0u}, Array<uint32_t>{}),
        Mesh::triangles(points, Array<uint32_t>{0, 1, 2, 0, 1, 3, 0, 1, 4}),                 // three faces on an edge
        Mesh::triangles(points, Array<uint32_t>{0, 0, 1, 1, 1, 1, 2, 3, 4}),                 // degenerate ones
        Mesh::triangles(points, Array<uint32_t>{0, 1, 2, 0, 1, 2, 2, 1, 0}),                 // doubled, and turned round
        Mesh(points, Array<uint32_t>{0, 2, 3, 8}, Array<uint32_t>{0, 1, 2, 0, 1, 2, 3, 4}),  // two corners, one corner, five corners
        testMesh(false),
    };
    for (const Mesh& m : odd) {
        try {
            const Value v = apply(op, m, {}, nullptr, othersFor(op));
            EXPECT_EQ(kindOf(v), op.yields);
        } catch (const Error& e) {
            EXPECT_GT(std::string(e.what()).size(), 10u) << "an error says what, where and what to do";
        }
    }
}

TEST_P(Contract, EmptyValuesGiveAResultOrAnError)
{
    const Operation& op = *GetParam();
    const std::map<Kind, Value> empty{{Kind::Pose, Pose{}}, {Kind::Curve, Curve{}}, {Kind::HeightMap, HeightMap{}}, {Kind::Rotations, Rotations{}}};
    const auto input = empty.find(op.accepts);
    if (input == empty.end()) return;  // not about it
    try {
        EXPECT_EQ(kindOf(apply(op, input->second, {}, nullptr, othersFor(op))), op.yields);
    } catch (const Error& e) {
        EXPECT_GT(std::string(e.what()).size(), 10u);
    }
}

TEST_P(Contract, StepsSpeakOfElementsThatAreThere)
{
    const Operation& op = *GetParam();
    if (!op.steps) return;  // not about it
    Stepper s(stepping(op, inputFor(op), {}, othersFor(op)));
    for (int i = 0; i < 500 && s.forward(); ++i) {
        const Value now = valueOf(s.value());
        const size_t joints = kindOf(now) == Kind::Pose ? std::get<Pose>(now).size() : 0;
        const size_t points = kindOf(now) == Kind::Curve ? std::get<Curve>(now).points.size() : 0;
        const HeightMap* map = std::get_if<HeightMap>(&now);
        for (const Focus& f : s.step().focus) {
            if (f.kind == ElementKind::Joint) {
                EXPECT_LT(f.index, joints) << s.step().phase;
            } else if (f.kind == ElementKind::Vertex && points) {
                EXPECT_LT(f.index, points) << s.step().phase;
            } else if (f.kind == ElementKind::Vertex && map) {
                EXPECT_LT(f.index, map->width() * map->height()) << s.step().phase;
            } else if (f.kind == ElementKind::Cell) {
                ASSERT_TRUE(map);
                EXPECT_LT(f.index, (map->width() - 1) * (map->height() - 1)) << s.step().phase;
            }
        }
    }
}

TEST_P(Contract, EachPhaseHasItsWordsAndNumbers)
{
    const Operation& op = *GetParam();
    if (!op.steps) return;  // not about it
    const Lesson* lesson = findLesson(op.id);
    ASSERT_NE(lesson, nullptr);
    Stepper s(stepping(op, inputFor(op), {}, othersFor(op)));
    for (int i = 0; i < 3000 && s.forward(); ++i) {
        if (s.atEnd()) break;
        const LessonPhase* phase = lesson->phase(s.step().phase);
        ASSERT_NE(phase, nullptr) << s.step().phase;
        for (const Number& n : s.step().numbers) EXPECT_NE(lesson->number(phase->id, n.name), nullptr) << phase->id << ": " << n.name;
    }
}

TEST_P(Contract, AttributesAreCarriedAsStated)
{
    const Operation& op = *GetParam();
    if (op.accepts != Kind::Mesh || op.yields != Kind::Mesh) return;  // not about it
    const Mesh out = std::get<Mesh>(apply(op, inputFor(op), {}, nullptr, othersFor(op)));
    const auto expectKept = [&](Carried c, const char* name, Domain d) {
        if (c == Carried::NotApplicable) return;
        const Attribute* a = out.find(name, d);
        EXPECT_EQ(a != nullptr, c != Carried::Dropped) << name;
        if (a) {
            EXPECT_EQ(a->size(), out.count(d)) << name;
        }
    };
    ASSERT_NE(op.attributes.vertex, Carried::NotApplicable);
    expectKept(op.attributes.vertex, "place", Domain::Vertex);
    expectKept(op.attributes.corner, "texcoord", Domain::Corner);
    expectKept(op.attributes.face, "material", Domain::Face);
    // "place" began as the position; whatever is mixed as positions are stays it, whatever is read off the surface stays near it.
    const Attribute* place = out.find("place", Domain::Vertex);
    if (place && op.attributes.vertex == Carried::Same) {
        const Mesh input = testMesh(true);
        const Attribute& before = *input.find("place");
        for (size_t v = 0; v < out.vertexCount(); ++v)
            for (int k = 0; k < 3; ++k) ASSERT_EQ(place->at(v, k), before.at(v, k)) << "vertex " << v;
    } else if (place) {
        const double tolerance = op.attributes.vertex == Carried::Stencil ? 1e-5 : 0.1;
        for (size_t v = 0; v < out.vertexCount(); ++v)
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(place->at(v, k), out.positions()[v][k], tolerance) << "vertex " << v;
    }
    // "texcoord" began as x, z. Where corners stay, so do their values, wherever the positions go.
    // An operation that makes texture coordinates carries none.
    const Attribute* t = op.attributes.corner == Carried::NotApplicable ? nullptr : out.find("texcoord", Domain::Corner);
    if (t && op.attributes.corner == Carried::Same) {
        const Mesh input = testMesh(true);
        const Attribute& before = *input.find("texcoord");
        for (size_t c = 0; c < out.cornerCount(); ++c)
            for (int k = 0; k < 2; ++k) ASSERT_EQ(t->at(c, k), before.at(c, k)) << "corner " << c;
    } else if (t) {
        for (size_t c = 0; c < out.cornerCount(); ++c) {
            const glm::vec3 p = out.positions()[out.cornerVertex()[c]];
            EXPECT_NEAR(t->at(c, 0), p.x, 0.15) << "corner " << c;
            EXPECT_NEAR(t->at(c, 1), p.z, 0.15) << "corner " << c;
        }
    }
    if (const Attribute* m = out.find("material", Domain::Face)) {
        EXPECT_TRUE(m->integral());
    }
}

TEST_P(Contract, ALessonExistsForWhateverHasSteps)
{
    const Operation& op = *GetParam();
    const auto file = std::filesystem::path(MESHWRIGHT_SOURCE_DIR) / "resources/lessons" / (op.id + ".json");
    EXPECT_EQ(op.steps, std::filesystem::exists(file)) << file;
}

std::vector<const Operation*> all()
{
    std::vector<const Operation*> list;
    for (const Operation& op : catalog()) list.push_back(&op);
    return list;
}

std::string testName(const testing::TestParamInfo<const Operation*>& info)
{
    std::string name = info.param->id;
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Catalog, Contract, testing::ValuesIn(all()), testName);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Contract);

TEST(Catalog, IdsAreUniqueAndUnknownOnesAreExplained)
{
    std::set<std::string> ids;
    for (const Operation& op : catalog()) EXPECT_TRUE(ids.insert(op.id).second) << op.id;
    EXPECT_THROW(operation("no-such-thing-at-all"), Error);
}

}  // namespace
}  // namespace mw
