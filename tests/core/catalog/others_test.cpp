// Further inputs of operations: who is asked, in which order, and what is said when there is nothing.
#include "core/catalog/others.h"

#include <gtest/gtest.h>

#include "core/catalog/entries.h"

using namespace mw;

namespace {

struct Both {
    OtherMesh other;
    template <class V>
    void describe(V& v)
    {
        v.object("other", other, {.title = "Other", .help = "A further mesh."});
    }
};

/// Yields the further mesh.
Generator exchange(Mesh, Both p, Stage<Mesh>& stage)
{
    co_yield Step("exchange");
    stage.finish(p.other.mesh);
}

Operation exchanging()
{
    return entry<Mesh, Both, Mesh>({.id = "exchange", .title = "Exchange", .summary = "", .category = "", .source = ""}, exchange);
}

Mesh triangle()
{
    return Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Array<uint32_t>{0, 1, 2});
}

TEST(Others, ComeFromTheCallerThenFromSources)
{
    const Operation op = exchanging();
    EXPECT_TRUE(needsOthers(op));
    EXPECT_FALSE(needsOthers(operation("smooth")));
    const FindMesh find = [](const std::string& name) { return name == "mine" ? std::optional<Mesh>(triangle()) : std::nullopt; };
    EXPECT_EQ(othersOf(op, {{"other", std::string("mine")}}, find).at("other").faceCount(), 1u);
    const Others made = othersOf(op, {{"other", std::string("icosphere:subdivisions=1")}}, find);
    EXPECT_EQ(made.at("other").faceCount(), 80u);
    const Mesh result = std::get<Mesh>(apply(op, triangle(), {{"other", std::string("icosphere:subdivisions=1")}}, nullptr, made));
    EXPECT_EQ(result.faceCount(), 80u);
}

TEST(Others, SayWhatIsMissing)
{
    Operation op = exchanging();
    EXPECT_THROW(othersOf(op, {}), Error) << "none named";
    for (Parameter& p : op.parameters) p.about.optional = true;
    EXPECT_TRUE(othersOf(op, {}).empty()) << "it can do without";
    EXPECT_THROW(othersOf(op, {{"other", std::string("nowhere")}}), Error);
    EXPECT_THROW(othersOf(op, {{"other", std::string("smooth")}}), Error) << "no source";
    EXPECT_THROW(othersOf(op, {{"other", std::string("icosphere:subdivisions=99")}}), Error);
}

}  // namespace
