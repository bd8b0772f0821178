// Motion of one file on the character of another: the skeleton of the character then moves as the file's own does.
#include "core/scene/adopt_clips.h"

#include <gtest/gtest.h>

#include "core/scene/scene_pose.h"

namespace mw {
namespace {

Scene chain(double length, const char* second = "knee")
{
    Scene s;
    Node hip, knee;
    hip.name = "hip";
    knee.name = second;
    hip.joint = knee.joint = Node::Joint::Joint;
    knee.local.translation = {0, -length, 0};
    s.add(knee, s.add(hip));
    return s;
}

Scene moving(double length)
{
    Scene s = chain(length);
    Clip clip{"bend", {}, 0};
    for (const NodeId n : s.nodes()) {
        Channel c;
        c.node = n;
        c.path = Channel::Path::EulerX;
        c.components = 1;
        c.times = Array<double>{0, 1};
        c.values = Array<double>{0, 90};
        clip.channels.push_back(std::make_shared<const Channel>(c));
    }
    s.add(std::move(clip));
    return s;
}

TEST(AdoptClips, MovesTheCharacterAsTheFileMoves)
{
    const Scene motion = moving(0.4);
    Scene character;
    character.add(Node{});  // so that ids differ
    character.merge(chain(0.4));
    const std::vector<ClipId> added = adoptClips(character, motion);
    ASSERT_EQ(added.size(), 1u);
    EXPECT_EQ(character.find(added[0])->name, "bend");
    const auto knee = [](const Scene& s, const Clip& clip) {
        const auto worlds = worldMatrices(s, poseAt(s, clip, 0.5));
        return glm::dvec3(worlds.at(s.nodes().back())[3]);
    };
    const glm::dvec3 at = knee(character, *character.find(added[0]));
    EXPECT_LT(glm::distance(at, knee(motion, *motion.find(motion.clips()[0]))), 1e-12);
    EXPECT_NEAR(at.z, -0.4 * std::sqrt(0.5), 1e-12);  // 45 degrees about x
}

TEST(AdoptClips, LeavesWhatDoesNotFit)
{
    const Scene motion = moving(0.4);
    Scene longer = chain(0.6), other = chain(0.4, "elbow"), twice = chain(0.4);
    twice.merge(chain(0.4));
    for (Scene* s : {&longer, &other, &twice}) {
        EXPECT_TRUE(adoptClips(*s, motion).empty());
        EXPECT_TRUE(s->clips().empty());
    }
}

}  // namespace
}  // namespace mw
