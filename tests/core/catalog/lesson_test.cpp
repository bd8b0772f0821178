// Lessons: all that are compiled in can be read; slips are found.
#include "core/catalog/lesson.h"

#include <gtest/gtest.h>

#include "core/catalog/resources.h"

using namespace mw;

namespace {

const char* const small = R"({"id":"a","title":"A","section":"3.1","intro":"x","scene":{"source":"icosphere"},"plot":"n",
    "phases":[{"id":"p","title":"P","sentence":"{n} at {v|current}","numbers":[{"name":"n","title":"N","format":"3 significant","log":true}]}]})";

std::string changed(std::string text, const std::string& from, const std::string& to)
{
    return text.replace(text.find(from), from.size(), to);
}

TEST(Lesson, AllThatAreCompiledInAreRight)
{
    ASSERT_FALSE(lessons().empty());
    for (const Lesson& l : lessons()) {
        EXPECT_EQ(findLesson(l.id), &l);
        EXPECT_FALSE(resourceText("resources/lessons/" + l.id + ".json").empty()) << "file and id differ: " << l.id;
    }
}

TEST(Lesson, IsRead)
{
    const Lesson l = parseLesson(small);
    ASSERT_NE(l.phase("p"), nullptr);
    EXPECT_EQ(l.phase("q"), nullptr);
    ASSERT_NE(l.number("p", "n"), nullptr);
    EXPECT_TRUE(l.number("p", "n")->log);
    EXPECT_EQ(l.scene.source, "icosphere");
}

TEST(Lesson, SlipsAreFound)
{
    EXPECT_THROW(parseLesson("{"), Error);
    EXPECT_THROW(parseLesson(changed(small, "\"title\":\"A\",", "")), Error);
    EXPECT_THROW(parseLesson(changed(small, "current", "currant")), Error);
    EXPECT_THROW(parseLesson(changed(small, "{n}", "{n")), Error);
    EXPECT_THROW(parseLesson(changed(small, "3 significant", "three")), Error);
    EXPECT_THROW(parseLesson(changed(small, "\"plot\":\"n\"", "\"plot\":\"m\"")), Error);
    EXPECT_THROW(parseLesson(changed(small, "\"plot\":\"n\"", "\"plot\":\"n\",\"plotOver\":\"m\"")), Error);
    EXPECT_THROW(parseLesson(changed(small, "\"section\"", "\"sektion\"")), Error);
}

TEST(Resources, AreFoundByLongerPathsToo)
{
    const std::string_view text = resourceText("resources/lessons/decimate-quadric.json");
    EXPECT_FALSE(text.empty());
    EXPECT_EQ(resourceText("/somewhere/else/resources/lessons/decimate-quadric.json"), text);
    EXPECT_TRUE(resourceText("xresources/lessons/decimate-quadric.json").empty());
    EXPECT_TRUE(resourceText("").empty());
}

}  // namespace
