// pose FILE --time S -o OUT: everything where it stands at one time of a clip, in world space.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/clip_options.h"
#include "app/cli/operation_call.h"
#include "app/cli/output.h"
#include "app/cli/placement_options.h"
#include "app/cli/verb.h"
#include "core/io/file.h"
#include "core/io/io.h"
#include "core/scene/scene_pose.h"

namespace mw::cli {

namespace {

/// The joints of all skeletons, one list. Those without a name are called by their number.
struct Joints {
    std::vector<std::string> names;
    std::vector<uint32_t> parents;
    std::vector<bool> ends;
    std::vector<glm::dvec3> places;
};

Joints jointsOf(const Scene& scene, const ScenePose& pose)
{
    Joints all;
    for (const NodeId root : skeletonRoots(scene)) {
        const Pose p = poseOf(scene, root, pose);
        const uint32_t first = uint32_t(all.names.size());
        for (const Joint& j : p.skeleton->joints) {
            all.parents.push_back(j.parent == none ? none : first + j.parent);
            all.ends.push_back(j.end);
            const std::string name = j.name.empty() ? "#" + std::to_string(all.names.size()) : j.name;
            all.names.push_back(j.end && j.parent != none ? all.names[first + j.parent] + " end" : name);
        }
        const std::vector<glm::dvec3> places = jointPlaces(p);
        all.places.insert(all.places.end(), places.begin(), places.end());
    }
    return all;
}

std::string ending(const std::string& file)
{
    std::string e = std::filesystem::path(file).extension().string();
    std::transform(e.begin(), e.end(), e.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return e;
}

std::string exact(double v)
{
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, v).ptr};
}

std::string quoted(const std::string& s)
{
    if (s.find_first_of(",\"\r\n") == s.npos) return s;
    std::string out = "\"";
    for (const char c : s) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

std::string csv(const Joints& joints)
{
    std::string text = "joint,x,y,z\n";
    for (size_t i = 0; i < joints.names.size(); ++i) {
        text += quoted(joints.names[i]);
        for (int k = 0; k < 3; ++k) text += "," + exact(joints.places[i][k]);
        text += "\n";
    }
    return text;
}

std::string json(const Joints& joints, const Clip* clip, double time)
{
    nlohmann::json rows = nlohmann::json::array();
    for (size_t i = 0; i < joints.names.size(); ++i) {
        const glm::dvec3& p = joints.places[i];
        nlohmann::json row = {{"joint", joints.names[i]}, {"parent", nullptr}, {"end", bool(joints.ends[i])}};
        if (joints.parents[i] != none) row["parent"] = joints.parents[i];
        row["x"] = p.x;
        row["y"] = p.y;
        row["z"] = p.z;
        rows.push_back(std::move(row));
    }
    nlohmann::json all = {{"clip", nullptr}, {"time", time}, {"joints", std::move(rows)}};
    if (clip) all["clip"] = clip->name;
    return all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// Joints as vertices, bones as loose lines: what a skeleton without a mesh leaves in mesh formats.
Mesh bonesOf(const Joints& joints)
{
    Array<glm::vec3> places(joints.places.begin(), joints.places.end());
    Array<uint32_t> lines;
    for (uint32_t i = 0; i < joints.parents.size(); ++i)
        if (joints.parents[i] != none) lines.insert(lines.end(), {joints.parents[i], i});
    return Mesh(std::move(places), {}, {}).withLines(std::move(lines));
}

struct Job {
    std::string in, out;
    ClipOptions clip;
    std::optional<std::string> motion;
    ImportOptions import = {};
    Placement placement = {};
    bool table() const { return ending(out) == ".csv" || ending(out) == ".json"; }
};

/// Gives what to say of it.
std::string writeTable(const Job& job, const Scene& scene, const ScenePose& pose, const Clip* clip, double time)
{
    const Joints joints = jointsOf(scene, pose);
    if (joints.names.empty()) throw Error(job.in, "there is no skeleton in it; name a mesh file (.glb, .gltf, .obj, .ply) for the posed meshes");
    OutputFile file(job.out);
    file.write(ending(job.out) == ".csv" ? csv(joints) : json(joints, clip, time));
    file.commit();
    return counted(joints.names.size(), "joint");
}

/// Gives what to say of it, and in `lost` what the format could not hold.
std::string writeMeshes(const Job& job, const Scene& scene, const ScenePose& pose, Working& working, std::vector<Warning>& lost)
{
    Scene still;
    size_t vertices = 0;
    if (scene.meshes().empty() && scene.terrains().empty()) {
        const Joints joints = jointsOf(scene, pose);
        if (joints.names.empty()) throw Error(job.in, "there is neither a mesh nor a skeleton in it");
        still = sceneOf(bonesOf(joints), std::filesystem::path(job.in).stem().string());
    } else {
        still = frozen(scene, pose, [&](MeshId id) { return evaluated(*scene.find(id), working.progress(), nullptr, &scene); });
    }
    working.now("writing " + job.out);
    lost = writeFile(still, job.out, {.placement = job.placement}, working.progress());
    for (const MeshId id : still.meshes()) vertices += still.find(id)->base.vertexCount();
    return counted(still.meshes().size(), "mesh", "meshes") + ", " + counted(vertices, "vertex", "vertices");
}

/// The time asked for, within the clip; that it lay outside is told.
double timeOf(const Job& job, const Clip& clip)
{
    const double time = *job.clip.time, last = duration(clip);
    if (time >= 0 && time <= last) return time;
    const std::string text =
        "clip \"" + clip.name + "\" lasts " + shown(last) + " s: its " + (time < 0 ? "first" : "last") + " pose is taken for " + shown(time) + " s";
    warn(job.in, std::vector<Warning>{{"time-outside", text, {}}});
    return std::clamp(time, 0.0, last);
}

void work(const Job& job)
{
    std::vector<Warning> lost;
    std::string written, when = ", at rest: there is no clip";
    {
        Working working("reading " + job.in);
        Imported in = readFile(job.in, working.progress(), job.import);
        if (job.motion) addMotion(in.scene, job.in, *job.motion, working.progress());
        warn(job.in, in.warnings);
        ScenePose pose;
        double time = 0;
        const Clip* clip = nullptr;
        if (job.clip.clip || !in.scene.clips().empty()) {
            clip = &clipOf(job.in, in.scene, job.clip);
            time = timeOf(job, *clip);
            pose = poseAt(in.scene, *clip, time);
            when = ", clip \"" + clip->name + "\" at " + shown(time) + " s";
        }
        working.now("posing");
        written = job.table() ? writeTable(job, in.scene, pose, clip, time) : writeMeshes(job, in.scene, pose, working, lost);
    }
    warn(job.out, lost);
    std::cout << job.out << ": " << written << when << '\n';
}

int run(Arguments& arguments)
{
    Job job;
    job.clip = takeClipOptions(arguments);
    job.motion = arguments.value("--motion");
    job.import = takeImportOptions(arguments);
    job.placement = takeOutPlacement(arguments);
    const std::optional<std::string> out = arguments.value("--output", "-o");
    job.in = arguments.finish({"FILE"})[0];
    if (!job.clip.time) throw UsageError("--time S is missing");
    if (!out || out->empty()) throw UsageError("-o OUT is missing");
    job.out = *out;
    if (ending(job.out) == ".bvh") throw Error(job.out, "one pose is no motion; name a .glb, .gltf, .obj, .ply, .csv or .json file");
    try {
        work(job);
    } catch (const Error& e) {
        if (!e.file().empty()) throw;
        throw Error(job.in, e.reason());  // of a modifier: it names no file
    }
    return 0;
}

}  // namespace

const Verb poseVerb{
    "pose", "a character or an animated scene as it stands at one time",
    "pose FILE [--clip NAME|#INDEX] [--motion FILE] --time S -o OUT [--unit UNIT] [--up y|z|x] [--out-unit UNIT] [--out-up y|z|x]\n\n"
    "Modifiers are evaluated, skins, morph targets and the motion of nodes applied; OUT holds what stands there, in world space, in\n"
    "metres where FILE says its unit (else in FILE's own), without skins and clips. A mesh file (.glb .gltf .obj .off .ply .stl) takes the\n"
    "meshes; of a skeleton without a mesh it takes joints as vertices and bones as lines. .csv and .json take the places of the\n"
    "joints: joint,x,y,z.\n"
    "  --clip    by name or by number from #0; the first one when left out. A file without clips stands at rest\n"
    "  --motion  also the clips of this file, made for the same skeleton (same names of joints)\n"
    "  --time    seconds from the start of the clip; outside of it its first or last pose is taken\n"
    "  --unit, --up, --out-unit, --out-up   how the numbers of FILE and OUT are meant; see meshwright convert --help\n\n"
    "  meshwright pose walk.bvh --time 0.5 -o joints.csv\n"
    "  meshwright pose cesium_man.gltf --time 1 -o step.ply\n",
    run};

}  // namespace mw::cli
