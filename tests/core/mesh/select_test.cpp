// Sets of elements: text and back.
#include "core/mesh/select.h"

#include <gtest/gtest.h>
#include <random>
#include <set>

#include "core/error.h"

#include "shapes.h"

using namespace mw;
using namespace mw::test;

namespace {

using Indices = std::vector<uint32_t>;

ElementSet vertices(Indices i)
{
    return {ElementKind::Vertex, std::move(i)};
}

}  // namespace

TEST(ElementText, RangesAreCompact)
{
    EXPECT_EQ(elementText(vertices({})), "");
    EXPECT_EQ(elementText(vertices({7})), "7");
    EXPECT_EQ(elementText(vertices({0, 1, 2, 3, 9, 20, 21})), "0-3;9;20-21");
    EXPECT_EQ(elementText({ElementKind::Edge, {3, 7, 3, 9, 4, 5}}), "3~7;3~9;4~5");
}

TEST(ElementText, AnyOrderAndRepetitionGiveTheSet)
{
    EXPECT_EQ(parsedElements(ElementKind::Face, "9;0-3;2-5;9;;1").indices, (Indices{0, 1, 2, 3, 4, 5, 9}));
    EXPECT_EQ(parsedElements(ElementKind::Edge, "9~3;3~7;7~3").indices, (Indices{3, 7, 3, 9}));
    EXPECT_TRUE(parsedElements(ElementKind::Vertex, "").indices.empty());
}

TEST(ElementText, RandomSetsComeBack)
{
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        std::set<uint32_t> indices;
        std::set<std::pair<uint32_t, uint32_t>> edges;
        const uint32_t n = 1 + random() % 300;
        for (uint32_t i = random() % 200; i > 0; --i) indices.insert(random() % n);
        for (uint32_t i = random() % 50; i > 0; --i)
            if (const uint32_t a = random() % n, b = random() % n; a != b) edges.insert(std::minmax(a, b));
        const ElementSet set{round % 2 ? ElementKind::Face : ElementKind::Vertex, Indices(indices.begin(), indices.end())};
        ElementSet pairs{ElementKind::Edge, {}};
        for (const auto& [a, b] : edges) pairs.indices.push_back(a), pairs.indices.push_back(b);
        EXPECT_EQ(parsedElements(set.kind, elementText(set), n).indices, set.indices);
        EXPECT_EQ(parsedElements(ElementKind::Edge, elementText(pairs), n).indices, pairs.indices);
        EXPECT_EQ(elementText(set).find_first_of(",+ "), std::string::npos);
    }
}

TEST(ElementText, WhatDoesNotFitIsNamed)
{
    const auto refused = [](ElementKind kind, const std::string& text, const std::string& word) {
        try {
            parsedElements(kind, text, 100);
            ADD_FAILURE() << text;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
        }
    };
    refused(ElementKind::Vertex, "3;100", "\"100\"");
    refused(ElementKind::Vertex, "0-4294967295", "below 100");
    refused(ElementKind::Vertex, "99999999999999999999", "below 100");
    refused(ElementKind::Vertex, "5-2", "backwards");
    refused(ElementKind::Vertex, "1,2", "no index");
    refused(ElementKind::Vertex, "-5", "no index");
    refused(ElementKind::Vertex, "5-", "no index");
    refused(ElementKind::Vertex, "+5", "no index");
    refused(ElementKind::Vertex, "3~7", "no index");
    refused(ElementKind::Edge, "5", "no edge");
    refused(ElementKind::Edge, "5~5", "the same");
    refused(ElementKind::Edge, "5~6~7", "no index");
    refused(ElementKind::Corner, "5", "only vertices");
}

TEST(ElementText, OverlappingRangesCostNothing)
{
    std::string text;
    for (int i = 0; i < 20000; ++i) text += "0-999999;";
    EXPECT_EQ(parsedElements(ElementKind::Vertex, text, 1'000'000).indices.size(), 1'000'000u);
}
