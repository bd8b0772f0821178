// ik FILE --effector JOINT --target x,y,z -o OUT: a skeleton reaches for a point; the way there becomes a clip.
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/clip_options.h"
#include "app/cli/output.h"
#include "app/cli/subject.h"
#include "app/cli/verb.h"
#include "core/character/kinematic_chain.h"
#include "core/io/io.h"
#include "core/scene/scene_pose.h"

namespace mw::cli {

namespace {

struct Job {
    std::string in, out, effector, solver;
    std::optional<std::string> root, skeleton;
    glm::dvec3 target{0};
    ParameterValues values;
    ClipOptions start;
    double seconds = 1;
    bool project = false, json = false;
};

double numberIn(const std::string& option, std::string_view text, double least, double most)
{
    double v = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), v);
    if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(v) || v < least || v > most)
        throw UsageError(option + " does not take \"" + std::string(text) + "\"");
    return v;
}

glm::dvec3 pointIn(std::string_view text)
{
    glm::dvec3 p(0);
    const std::string whole(text);
    for (int k = 0; k < 3; ++k) {
        const size_t comma = text.find(',');
        if ((comma == text.npos) != (k == 2)) throw UsageError("--target wants x,y,z in metres, not \"" + whole + "\"");
        p[k] = numberIn("--target", text.substr(0, comma), -1e9, 1e9);
        text = comma == text.npos ? std::string_view() : text.substr(comma + 1);
    }
    return p;
}

Job parse(Arguments& arguments)
{
    Job job;
    const std::optional<std::string> effector = arguments.value("--effector"), target = arguments.value("--target"),
                                     solver = arguments.value("--solver"), out = arguments.value("--output", "-o"),
                                     tolerance = arguments.value("--tolerance"), seconds = arguments.value("--duration");
    job.root = arguments.value("--root");
    job.skeleton = arguments.value("--object");
    const std::optional<long> iterations = arguments.number("--iterations", 1, 100000);
    job.start = takeClipOptions(arguments);
    job.project = arguments.flag("--project");
    job.json = arguments.flag("--json");
    job.in = arguments.finish({"FILE"})[0];
    if (!effector || effector->empty()) throw UsageError("say which joint is to reach the target: --effector JOINT");
    if (!target) throw UsageError("say where it is to go: --target x,y,z");
    if (!out || out->empty()) throw UsageError("-o OUT is missing");
    job.effector = *effector;
    job.target = pointIn(*target);
    job.out = *out;
    job.solver = solver.value_or("fabrik");
    if (job.solver != "ccd" && job.solver != "fabrik") throw UsageError("--solver wants ccd or fabrik, not \"" + job.solver + "\"");
    job.values["tolerance"] = tolerance ? numberIn("--tolerance", *tolerance, 0, 1e6) : 1e-4;
    job.values["iterations"] = int64_t(iterations.value_or(1000));
    if (seconds) job.seconds = numberIn("--duration", *seconds, 1e-3, 1e5);
    return job;
}

/// The joint's number in the pose. "#INDEX" counts the joints as info lists them: nodes between joints are none.
uint32_t effectorIn(const Scene& scene, const Pose& pose, const std::string& name)
{
    Skeleton listed = *pose.skeleton;
    for (Joint& j : listed.joints) j.end = scene.node(j.node).joint != Node::Joint::Joint;
    return jointOf(listed, name);
}

struct Solution {
    Pose from, to;
    std::string effector;
    double error = 0, distance = 0, reach = 0;
    Reach within = Reach::Yes;
};

Solution solve(const Job& job, const Scene& scene, Progress* progress)
{
    Solution s;
    s.from = skeletonIn(job.in, scene, job.skeleton, job.effector);
    const uint32_t end = effectorIn(scene, s.from, job.effector);
    if (job.start) {
        const NodeId top = s.from.skeleton->joints[0].node;
        s.from = poseOf(scene, top, poseAt(scene, clipOf(job.in, scene, job.start), job.start.time.value_or(0)));
    }
    const Skeleton& skeleton = *s.from.skeleton;
    s.effector = skeleton.joints[end].name;
    ParameterValues values = job.values;
    values["effector"] = calledBy(skeleton, end);
    if (job.root) values["root"] = calledBy(skeleton, effectorIn(scene, s.from, *job.root));
    values["target"] = job.target;
    values["aim"] = std::string("point");
    s.to = std::get<Pose>(apply(operation(job.solver), s.from, values, progress));
    s.error = glm::distance(jointPlaces(s.to)[end], job.target);

    ChainAim aim;
    aim.effector = std::get<std::string>(values["effector"]);
    if (job.root) aim.root = std::get<std::string>(values["root"]);
    const std::vector<glm::dvec3> places = chainOf(s.from, aim).places(s.from);
    const std::vector<double> lengths = linkLengths(places);
    for (const double d : lengths) s.reach += d;
    s.distance = glm::distance(places.front(), job.target);
    s.within = reachOf(lengths, s.distance);
    return s;
}

void say(const Job& job, const Solution& s, bool reached)
{
    if (job.json) {
        static constexpr const char* words[] = {"yes", "too far", "too near"};
        printJson({{"file", job.out},
                   {"solver", job.solver},
                   {"effector", s.effector},
                   {"target", {job.target.x, job.target.y, job.target.z}},
                   {"error", finite(s.error)},
                   {"reached", reached},
                   {"within_reach", words[size_t(s.within)]}});
        return;
    }
    std::cout << job.out << ": \"" << s.effector << "\" is " << shown(s.error) << " m from the target";
    if (s.within == Reach::TooFar)
        std::cout << ": out of reach, the target is " << shown(s.distance) << " m from the root of the chain and its links are " << shown(s.reach)
                  << " m";
    else if (s.within == Reach::TooNear)
        std::cout << ": out of reach, the target is only " << shown(s.distance) << " m from the root and one link is longer than all others";
    else if (!reached)
        std::cout << ": not reached; try more --iterations or a --root further up";
    std::cout << '\n';
}

int run(Arguments& arguments)
{
    const Job job = parse(arguments);
    std::vector<Warning> lost;
    Solution s;
    {
        Working working("reading " + job.in);
        Imported in = readFile(job.in, working.progress());
        warn(job.in, in.warnings);
        working.now(job.solver);
        try {
            s = solve(job, in.scene, working.progress());
        } catch (const Error& e) {
            if (!e.file().empty()) throw;
            throw Error(job.in, e.reason());
        }
        for (const ClipId id : in.scene.clips()) in.scene.remove(id);
        in.scene.add(keyed(s.from, s.to, job.seconds, "IK " + s.effector));
        working.now("writing " + job.out);
        lost = writeFile(in.scene, job.out, {.project = job.project}, working.progress());
    }
    warn(job.out, lost);
    say(job, s, s.error <= std::get<double>(job.values.at("tolerance")));
    return 0;
}

}  // namespace

const Verb ikVerb{"ik", "a skeleton reaches for a point; the way there becomes a clip",
                  "ik FILE --effector JOINT --target x,y,z [--solver ccd|fabrik] -o OUT [--root JOINT] [--clip C] [--time S]\n"
                  "   [--duration S] [--tolerance M] [--iterations N] [--object ROOT] [--project] [--json]\n\n"
                  "OUT holds exactly one clip: from the pose it begins with to the solution, which is its last key.\n"
                  "  --effector JOINT   the joint that is to reach the target: its name, or #INDEX as info --json lists joints\n"
                  "  --target x,y,z     world space of FILE as it is exported: metres, +Y up\n"
                  "  --solver NAME      fabrik unless said\n"
                  "  --root JOINT       where the chain begins; unless said as far up as no joint branches off\n"
                  "  --clip, --time     the pose to begin with; unless said the skeleton at rest\n"
                  "  --duration S       of the clip, 1 second unless said\n"
                  "  --tolerance M      metres from the target that will do, 0.0001 unless said\n"
                  "  --iterations N     most rounds, 1000 unless said\n"
                  "  --object ROOT      which skeleton, by its topmost joint\n"
                  "A target out of reach is told, and the chain points to it; that is no failure.\n",
                  run};

}  // namespace mw::cli
