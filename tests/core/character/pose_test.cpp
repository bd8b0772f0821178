// Joints by name and number.
#include "core/character/pose.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace mw {
namespace {

Skeleton named(std::initializer_list<const char*> names)
{
    Skeleton s;
    for (const char* n : names) s.joints.push_back({n, s.joints.empty() ? none : uint32_t(s.joints.size() - 1), {}, {}, false});
    return s;
}

std::string messageOf(const Skeleton& s, std::string_view name)
{
    try {
        jointOf(s, name);
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

TEST(JointOf, ByNameOrNumber)
{
    const Skeleton s = named({"hip", "LeftArm", "#0", "LeftHand"});
    EXPECT_EQ(jointOf(s, "LeftArm"), 1u);
    EXPECT_EQ(jointOf(s, "#3"), 3u);
    EXPECT_EQ(jointOf(s, "#0"), 2u);  // a name comes before a number
}

TEST(JointOf, EndSitesAreNumberedLast)
{
    Skeleton s = named({"hip", "end", "arm", "end"});
    s.joints[1].end = s.joints[3].end = true;
    EXPECT_EQ(jointOf(s, "#1"), 2u);
    EXPECT_EQ(jointOf(s, "#3"), 3u);
    EXPECT_NE(messageOf(s, "end").find("#2, #3"), std::string::npos);
    EXPECT_EQ(calledBy(s, 2), "arm");
    for (uint32_t i = 0; i < 4; ++i) EXPECT_EQ(jointOf(s, calledBy(s, i)), i);
}

TEST(JointOf, SaysWhatThereIs)
{
    const Skeleton s = named({"hip", "LeftArm", "LeftHand", "hip"});
    EXPECT_NE(messageOf(s, "left").find("LeftArm, LeftHand"), std::string::npos);
    EXPECT_NE(messageOf(s, "tail").find("#0, LeftArm"), std::string::npos);  // two are called hip: their numbers can be given
    EXPECT_NE(messageOf(s, "#4").find("#0 to #3"), std::string::npos);
    EXPECT_NE(messageOf(s, "#-1").find("#0 to #3"), std::string::npos);
    EXPECT_NE(messageOf(s, "hip").find("#0, #3"), std::string::npos);
    EXPECT_NE(messageOf({}, "a").find("empty"), std::string::npos);
}

}  // namespace
}  // namespace mw
