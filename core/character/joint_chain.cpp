#include "core/character/joint_chain.h"

#include <charconv>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "core/error.h"
#include "core/math/rotations.h"

namespace mw {

namespace {

std::vector<double> numbersIn(const char* what, std::string_view text)
{
    std::vector<double> all;
    while (true) {
        const size_t begin = text.find_first_not_of(' ');
        if (begin == text.npos) break;
        text.remove_prefix(begin);
        const std::string_view word = text.substr(0, text.find(' '));
        double v = 0;
        const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), v);
        if (failure != std::errc() || end != word.data() + word.size() || !std::isfinite(v))
            throw Error(std::string("parameter ") + what + ": \"" + std::string(word.substr(0, 32)) +
                        "\" is no number; write numbers with spaces between");
        all.push_back(v);
        text.remove_prefix(word.size());
    }
    if (all.empty()) throw Error(std::string("parameter ") + what + " is empty: write one number, or one for each link");
    return all;
}

}  // namespace

Generator jointChain(JointChain p, Stage<Pose>& stage)
{
    const std::vector<double> lengths = numbersIn("lengths", p.lengths), angles = numbersIn("angles", p.angles);
    const auto of = [](const std::vector<double>& all, size_t i) { return all[std::min(i, all.size() - 1)]; };
    const auto links = size_t(p.links);
    auto skeleton = std::make_shared<Skeleton>();
    Pose pose;
    for (size_t i = 0; i <= links; ++i) {
        Joint j;
        j.name = i == links ? "tip" : "joint " + std::to_string(i);
        j.parent = i ? uint32_t(i - 1) : none;
        j.end = i == links;
        const double length = i ? of(lengths, i - 1) : 0;
        if (length < 0) throw Error("parameter lengths: a link cannot be shorter than 0");
        j.rest.translation = {length, 0, 0};
        Transform local = j.rest;
        if (i < links) local.rotation = aboutAxis(2, glm::radians(of(angles, i)));
        skeleton->joints.push_back(std::move(j));
        pose.locals.push_back(local);
    }
    pose.skeleton = std::move(skeleton);
    pose.targets = {{uint32_t(links), p.target}};
    stage.finish(std::move(pose));
    co_return;
}

}  // namespace mw
