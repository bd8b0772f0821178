// One description gives list, parser, printer, JSON and the filled struct.
#include "core/catalog/parameters.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/catalog/entries.h"

namespace mw {
namespace {

enum class Method { Laplacian, Taubin };
struct Example {
    int64_t iterations = 10;
    double lambda = 0.5;
    bool keep = false;
    Method method = Method::Taubin;
    glm::dvec3 axis{0, 1, 0};
    template <class V>
    void describe(V& v)
    {
        v.integer("iterations", iterations, {.title = "Iterations", .help = "Rounds.", .min = 1, .max = 1000});
        v.number("lambda", lambda, {.title = "Step", .help = "Share of the way.", .min = 0, .max = 1});
        v.flag("keep", keep, {.title = "Keep", .help = "Keep the boundary."});
        v.choice("method", method, {"laplacian", "taubin"}, {.title = "Method", .help = "Which."});
        v.point("axis", axis, {.title = "Axis", .help = "Direction."});
    }
};

const std::vector<Parameter> parameters = described<Example>();

std::string refusal(std::string_view text)
{
    try {
        parsed(parameters, text);
    } catch (const Error& e) {
        return e.what();
    }
    return "accepted";
}

TEST(Parameters, DefaultsAreListed)
{
    ASSERT_EQ(parameters.size(), 5u);
    EXPECT_EQ(parameters[3].choices[1], "taubin");
    EXPECT_EQ(std::get<std::string>(parameters[3].initial), "taubin");
    EXPECT_EQ(filled<Example>({}).iterations, 10);
}

TEST(Parameters, TextFillsTheStructAndComesBack)
{
    const char* text = "iterations=20,lambda=0.25,keep=true,method=laplacian,axis=1/-2/0.5";
    const ParameterValues v = parsed(parameters, text);
    const Example e = filled<Example>(v);
    EXPECT_EQ(e.iterations, 20);
    EXPECT_EQ(e.lambda, 0.25);
    EXPECT_TRUE(e.keep);
    EXPECT_EQ(e.method, Method::Laplacian);
    EXPECT_EQ(e.axis, glm::dvec3(1, -2, 0.5));
    EXPECT_EQ(printed(parameters, v), text);
    EXPECT_EQ(parametersFromJson(parameters, toJson(v)), v);
    EXPECT_EQ(printed(parameters, parsed(parameters, "iterations=10,method=taubin")), "");
    EXPECT_EQ(filled<Example>(parsed(parameters, "lambda=1")).lambda, 1.0);
    EXPECT_EQ(filled<Example>(parsed(parameters, "iterations=1e2")).iterations, 100);
}

struct Words {
    std::string with, name;
    template <class V>
    void describe(V& v)
    {
        v.text("with", with, {});
        v.object("name", name, {});
    }
};

TEST(Parameters, QuotedValuesHoldAnythingAndComeBack)
{
    const auto words = described<Words>();
    for (const char* text : {"a,b=c", "\"", "\\", "a\"b,", "x=1,y=\"a,b\"", ",,", "\n,", "a=1"})
        for (const char* name : {"plain", "with, comma"}) {
            const ParameterValues v{{"with", std::string(text)}, {"name", std::string(name)}};
            EXPECT_EQ(parsed(words, printed(words, v)), v) << printed(words, v);
        }
    EXPECT_EQ(printed(words, {{"with", std::string("faces=10,stop=\"a\"")}}), R"(with="faces=10,stop=\"a\"")");
    EXPECT_THROW(parsed(words, R"(with="a)"), Error);
    EXPECT_THROW(parsed(words, R"(with="a"b)"), Error);
    EXPECT_THROW(parsed(words, R"(with="a",with="b")"), Error);
    EXPECT_EQ(unlikeDefaults(parameters, parsed(parameters, "iterations=10,lambda=0.25")), parsed(parameters, "lambda=0.25"));
}

TEST(Parameters, WildValuesAreRefusedWithTheReason)
{
    EXPECT_EQ(refusal("lambda=2"), "parameter lambda=2: must be 0 to 1");
    EXPECT_EQ(refusal("lambda=nan"), "parameter lambda=nan: must be 0 to 1");
    EXPECT_EQ(refusal("lambda=1e400"), "parameter lambda=1e400: must be a number");
    EXPECT_EQ(refusal("iterations=0"), "parameter iterations=0: must be 1 to 1000");
    EXPECT_EQ(refusal("iterations=2.5"), "parameter iterations=2.5: must be a whole number");
    EXPECT_EQ(refusal("iterations=99999999999999999999"), "parameter iterations=99999999999999999999: must be a whole number");
    EXPECT_EQ(refusal("method=best"), "parameter method=best: must be one of laplacian, taubin");
    EXPECT_EQ(refusal("axis=1/2"), "parameter axis=1/2: must be three numbers x/y/z");
    EXPECT_EQ(refusal("axis=1/2/inf"), "parameter axis=inf: must be a finite number");
    EXPECT_EQ(refusal("keep"), "parameter \"keep\" has no value: write name=value");
    EXPECT_EQ(refusal("keep=true,keep=false"), "parameter keep is given twice");
    EXPECT_EQ(refusal("size=3"), "there is no parameter \"size\"; there are: iterations, lambda, keep, method, axis");
    EXPECT_THROW(parametersFromJson(parameters, nlohmann::json::parse(R"({"lambda":[1]})")), Error);
    EXPECT_THROW(parametersFromJson(parameters, nlohmann::json::parse(R"({"lambda":"much"})")), Error);
    EXPECT_THROW(parametersFromJson(parameters, nlohmann::json::parse("[]")), Error);
}

}  // namespace
}  // namespace mw
