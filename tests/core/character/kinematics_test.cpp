// CCD and FABRIK against what must hold whatever they do: lengths kept, closed forms of two links, distances that never grow, targets reached.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>
#include <random>

#include "core/catalog/catalog.h"
#include "core/character/ccd.h"
#include "core/character/fabrik.h"
#include "core/error.h"
#include "core/steps/stepper.h"

namespace mw {
namespace {

Pose planeChain(std::string parameters)
{
    const Operation& op = operation("joint-chain");
    return std::get<Pose>(apply(op, {}, parsed(op.parameters, parameters)));
}

Pose solved(const char* solver, const Pose& pose, const std::string& parameters = {})
{
    const Operation& op = operation(solver);
    return std::get<Pose>(apply(op, pose, parsed(op.parameters, parameters)));
}

double errorOf(const Pose& p)
{
    return glm::distance(jointPlaces(p)[p.targets.at(0).joint], p.targets[0].at);
}

std::vector<double> boneLengths(const Pose& p)
{
    const std::vector<glm::dvec3> at = jointPlaces(p);
    std::vector<double> d;
    for (size_t i = 0; i < p.size(); ++i)
        if (p.skeleton->joints[i].parent != none) d.push_back(glm::distance(at[i], at[p.skeleton->joints[i].parent]));
    return d;
}

/// A chain of random links and turns in space, under a parent that turns, scales and moves, with a twig on each joint.
Pose randomChain(uint32_t seed, int links, double targetShare, bool mirrored = false)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1), length(0.3, 1.5);
    const auto vector = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
    const auto rotation = [&] { return glm::normalize(glm::dquat(unit(random), unit(random), unit(random), unit(random))); };
    auto s = std::make_shared<Skeleton>();
    Pose p;
    const auto add = [&](uint32_t parent, glm::dvec3 offset) {
        Joint j;
        j.name = "j" + std::to_string(p.size());
        j.parent = parent;
        Transform t;
        t.translation = offset;
        t.rotation = rotation();
        t.scale = glm::dvec3(parent == none ? 0.4 : 1);
        if (parent == none && mirrored) t.scale.x = -t.scale.x;
        s->joints.push_back(j);
        p.locals.push_back(t);
        return uint32_t(p.size() - 1);
    };
    Transform world;
    world.translation = vector();
    world.rotation = rotation();
    world.scale = glm::dvec3(2.5);
    p.worldFromParent = world.matrix();
    uint32_t last = add(none, vector());
    const uint32_t root = last;
    for (int i = 0; i < links; ++i) {
        const uint32_t next = add(last, length(random) * glm::normalize(vector()));
        add(last, 0.3 * vector());
        last = next;
    }
    p.skeleton = s;
    double reach = 0;
    const std::vector<glm::dvec3> at = jointPlaces(p);
    for (uint32_t j = last; j != root; j = s->joints[j].parent) reach += glm::distance(at[j], at[s->joints[j].parent]);
    p.targets = {{last, at[root] + targetShare * reach * glm::normalize(vector())}};
    return p;
}

std::string rootAndEnd(const Pose& p)
{
    return "root=j0,effector=j" + std::to_string(p.targets[0].joint);
}

TEST(Kinematics, BoneLengthsStay)
{
    for (uint32_t seed = 0; seed < 60; ++seed)
        for (const char* solver : {"fabrik", "ccd"}) {
            const Pose before = randomChain(seed, 2 + int(seed % 7), seed % 3 ? 0.6 : 1.4, seed % 5 == 0);
            const Pose after = solved(solver, before, rootAndEnd(before));
            const std::vector<double> a = boneLengths(before), b = boneLengths(after);
            for (size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-6) << solver << ", seed " << seed;
            for (size_t i = 0; i < before.size(); ++i) {
                EXPECT_EQ(before.locals[i].translation, after.locals[i].translation);  // turns alone
                EXPECT_EQ(before.locals[i].scale, after.locals[i].scale);
            }
        }
}

// The angle at the middle joint follows from the law of cosines, whatever the start.
TEST(Kinematics, TwoLinksHaveAClosedForm)
{
    for (const char* solver : {"fabrik", "ccd"})
        for (const double distance : {0.5, 1.0, 1.6, 2.1}) {
            const Pose p = planeChain("links=2,lengths=1.3 0.9,angles=20 70,target=" + std::to_string(distance * 0.6) + "/" +
                                      std::to_string(distance * 0.8) + "/0");
            const Pose s = solved(solver, p, "tolerance=1e-9,iterations=3000");
            const std::vector<glm::dvec3> at = jointPlaces(s);
            EXPECT_LT(errorOf(s), 1e-6) << solver << ' ' << distance;
            const double inner = glm::dot(glm::normalize(at[0] - at[1]), glm::normalize(at[2] - at[1]));
            EXPECT_NEAR(inner, (1.3 * 1.3 + 0.9 * 0.9 - distance * distance) / (2 * 1.3 * 0.9), 1e-5) << solver << ' ' << distance;
            for (const glm::dvec3& place : at) EXPECT_NEAR(place.z, 0, 1e-9) << "a plane chain stays in its plane";
        }
}

TEST(Kinematics, BothReachWhatCanBeReached)
{
    for (uint32_t seed = 0; seed < 100; ++seed) {
        // At least three links and not too far out: no link is then longer than the others together with the distance.
        const Pose p = randomChain(seed, 4 + int(seed % 5), 0.65, seed % 4 == 0);
        const std::string chain = rootAndEnd(p);
        EXPECT_LT(errorOf(solved("fabrik", p, chain + ",tolerance=1e-5,iterations=2000")), 1e-5) << "seed " << seed;
        EXPECT_LT(errorOf(solved("ccd", p, chain + ",tolerance=1e-4,iterations=5000")), 1e-4) << "seed " << seed;
    }
}

TEST(Kinematics, CcdNeverLosesGround)
{
    for (uint32_t seed = 0; seed < 100; ++seed) {
        const Pose p = randomChain(seed, 3 + int(seed % 6), 0.3 + 0.01 * seed, seed % 4 == 0);
        const Operation& op = operation("ccd");
        Stepper s(stepping(op, p, parsed(op.parameters, rootAndEnd(p) + ",iterations=30" + (seed % 2 ? ",limit=12" : ""))));
        double before = errorOf(p);
        while (s.forward()) {
            if (s.step().phase == "bend") continue;
            const double now = errorOf(std::get<Pose>(valueOf(s.value())));
            EXPECT_LE(now, before + 1e-9) << "seed " << seed << ", step " << s.position();
            before = now;
        }
    }
}

TEST(Kinematics, BeyondReachTheChainIsStraight)
{
    const Pose p = planeChain("links=4,lengths=1 0.8 0.6 0.4,angles=30,target=4/3/0");
    for (const char* solver : {"fabrik", "ccd"}) {
        const Pose s = solved(solver, p, "iterations=20000");
        EXPECT_NEAR(errorOf(s), 5 - 2.8, 1e-3) << solver;
        const glm::dvec3 tip = jointPlaces(s).back();
        EXPECT_NEAR(tip.x, 2.8 * 0.8, 0.05) << solver;
        EXPECT_NEAR(tip.y, 2.8 * 0.6, 0.05) << solver;
    }
    EXPECT_NEAR(errorOf(solved("fabrik", p)), 2.2, 1e-12);
}

TEST(Kinematics, AChainInLineWithItsTargetIsBentFirst)
{
    for (const char* target : {"1.5/0/0", "-1.5/0/0", "0.2/0/0"})
        for (const char* solver : {"fabrik", "ccd"}) {
            const Pose p = planeChain("links=3,angles=0,target=" + std::string(target));
            EXPECT_LT(errorOf(solved(solver, p, "tolerance=1e-4,iterations=5000")), 1e-4) << solver << " to " << target;
        }
}

TEST(Kinematics, ASingleLinkPointsToItsTarget)
{
    const Pose p = planeChain("links=1,lengths=2,angles=10,target=0/5/0");
    for (const char* solver : {"fabrik", "ccd"}) {
        EXPECT_NEAR(errorOf(solved(solver, p)), 3, 1e-6) << solver;
        EXPECT_NEAR(errorOf(solved(solver, p, "target=0/-1/0")), 1, 1e-3) << solver;  // too near
    }
}

TEST(Kinematics, LinksOfNoLengthAreNoTrouble)
{
    const Pose p = planeChain("links=4,lengths=1 0 1 0,angles=30,target=0.5/1.2/0");
    for (const char* solver : {"fabrik", "ccd"}) EXPECT_LT(errorOf(solved(solver, p, "iterations=2000")), 1e-3) << solver;
}

TEST(Kinematics, TheChainEndsWhereOthersBranchOff)
{
    // hip - spine - (arm - elbow - hand, other)
    auto s = std::make_shared<Skeleton>();
    const uint32_t parents[] = {none, 0, 1, 2, 3, 1};
    const char* names[] = {"hip", "spine", "arm", "elbow", "hand", "other"};
    Pose p;
    for (size_t i = 0; i < 6; ++i) {
        s->joints.push_back({names[i], parents[i], {}, {}, false});
        Transform t;
        t.translation = {0, 1, 0};
        p.locals.push_back(t);
    }
    p.skeleton = s;
    ChainAim aim;
    aim.effector = "hand";
    EXPECT_EQ(chainOf(p, aim).joints, (std::vector<uint32_t>{2, 3, 4}));
    aim.root = "hip";
    EXPECT_EQ(chainOf(p, aim).joints, (std::vector<uint32_t>{0, 1, 2, 3, 4}));
    aim.root.clear();
    aim.effector = "arm";  // at least one link
    EXPECT_EQ(chainOf(p, aim).joints, (std::vector<uint32_t>{1, 2}));
    EXPECT_NEAR(glm::distance(chainOf(p, aim).target, {0, 2, 0}), 1, 1e-12);  // what one link can reach
    aim.effector = "hip";
    EXPECT_THROW(chainOf(p, aim), Error);
    aim.effector = "hand";
    aim.root = "other";
    EXPECT_THROW(chainOf(p, aim), Error);
    EXPECT_THROW(chainOf(Pose{}, {}), Error);
}

TEST(Kinematics, TheTargetAskedForIsTheOneTaken)
{
    const Pose p = planeChain("links=3");
    EXPECT_EQ(solved("fabrik", p).targets[0].at, p.targets[0].at);
    EXPECT_EQ(solved("fabrik", p, "target=1/1/0").targets[0].at, glm::dvec3(1, 1, 0));
    EXPECT_EQ(solved("fabrik", p, "aim=point").targets[0].at, glm::dvec3(0));
}

TEST(Kinematics, FabrikShowsTheJointsWhereTheyAre)
{
    const Pose p = planeChain("links=3,target=1/1/0");
    const Operation& op = operation("fabrik");
    Stepper s(stepping(op, p, {}));
    ASSERT_TRUE(s.seekWhere([](const StepRecord& r) { return r.phase == "to target"; }));
    const Pose put = std::get<Pose>(valueOf(s.value()));
    EXPECT_LT(glm::distance(jointPlaces(put).back(), glm::dvec3(1, 1, 0)), 1e-12);
    EXPECT_LT(glm::distance(jointPlaces(put)[2], jointPlaces(p)[2]), 1e-12) << "the others have not moved yet";
    ASSERT_TRUE(s.seekWhere([](const StepRecord& r) { return r.phase == "to root"; }));
    const std::vector<glm::dvec3> at = jointPlaces(std::get<Pose>(valueOf(s.value())));
    EXPECT_LT(glm::length(at[0]), 1e-12);
    EXPECT_NEAR(glm::distance(at[1], at[2]), 1, 1e-9);  // the forward pass left these links as long as they were
    EXPECT_NEAR(glm::distance(at[2], at[3]), 1, 1e-9);
}

TEST(Kinematics, TurnsAreTheSmallest)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 a(unit(random), unit(random), unit(random)), b(unit(random), unit(random), unit(random));
        const glm::dquat q = smallestTurn(a, b);
        EXPECT_LT(glm::distance(glm::normalize(q * a), glm::normalize(b)), 1e-12);
        EXPECT_NEAR(2 * std::acos(std::min(1.0, std::abs(q.w))), std::acos(glm::dot(glm::normalize(a), glm::normalize(b))), 1e-6);
        const glm::dquat half = smallestTurn(a, -a);
        EXPECT_LT(glm::distance(half * a, -a), 1e-9);
    }
    const glm::dquat flat = smallestTurn({1, 2, 0}, {-1, -2, 0});
    EXPECT_NEAR(std::abs(flat.z), 1, 1e-12) << "half a turn within the plane";
    EXPECT_EQ(smallestTurn({0, 0, 0}, {1, 0, 0}).w, 1);
}

}  // namespace
}  // namespace mw
