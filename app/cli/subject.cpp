#include "app/cli/subject.h"

#include <algorithm>

#include "app/cli/output.h"
#include "app/cli/value_file.h"
#include "core/catalog/lesson_scene.h"
#include "core/io/height_picture.h"
#include "core/io/io.h"
#include "core/scene/scene_pose.h"

namespace mw::cli {

namespace {

Mesh meshIn(const std::string& in, const Scene& scene, const std::optional<std::string>& object, Progress* progress)
{
    const std::vector<MeshId> meshes = scene.meshes();
    if (meshes.empty()) throw Error(in, "there is no mesh in it");
    std::string names;
    for (MeshId id : meshes) {
        const MeshObject& o = *scene.find(id);
        if (object ? o.name == *object : meshes.size() == 1) return evaluated(o, progress, nullptr, &scene);
        names += (names.empty() ? "" : ", ") + o.name;
    }
    throw Error(in,
                object ? "there is no mesh \"" + *object + "\"; there are: " + names : "there are several meshes; choose by --object NAME: " + names);
}

Value lessonSubjectOf(const Operation& op, Progress* progress)
{
    const Lesson* lesson = findLesson(op.id);
    if (!lesson) throw Error(op.id + " has no lesson and so nothing to be tried on; the input - is for sources, name a file");
    return lessonSubject(*lesson, progress);
}

std::string effectorOf(const OperationCall& call)
{
    const auto i = call.values.find("effector");
    return i == call.values.end() ? std::string() : std::get<std::string>(i->second);
}

bool hasJoint(const Pose& p, const std::string& name)
{
    return std::any_of(p.skeleton->joints.begin(), p.skeleton->joints.end(), [&](const Joint& j) { return j.name == name; });
}

}  // namespace

Pose skeletonIn(const std::string& file, const Scene& scene, const std::optional<std::string>& root, const std::string& joint)
{
    std::vector<Pose> all;
    std::string names;
    for (const NodeId top : skeletonRoots(scene)) {
        if (root && scene.node(top).name == *root) return poseOf(scene, top);
        names += (names.empty() ? "" : ", ") + scene.node(top).name;
        all.push_back(poseOf(scene, top));
    }
    if (all.empty()) throw Error(file, "there is no skeleton in it");
    if (root) throw Error(file, "there is no skeleton \"" + *root + "\"; there are: " + names);
    const auto bySize = [](const Pose& a, const Pose& b) { return a.size() < b.size(); };
    const auto named = std::find_if(all.begin(), all.end(), [&](const Pose& p) { return hasJoint(p, joint); });
    return named != all.end() ? *named : *std::max_element(all.begin(), all.end(), bySize);
}

Value subjectOf(const std::string& in, const OperationCall& call, const std::optional<std::string>& object, Progress* progress,
                const ImportOptions& options)
{
    const Operation& op = *call.operation;
    if (in == "-") return op.accepts == Kind::Nothing ? Value{} : lessonSubjectOf(op, progress);
    if (op.accepts == Kind::Curve) return readCurveFile(in);
    if (op.accepts == Kind::HeightMap) {
        std::vector<Warning> warnings;
        HeightMap map = readHeightMap(in, &warnings, progress);
        warn(in, warnings);
        return map;
    }
    const Input input = readInput(in, call, progress, options);
    if (op.accepts == Kind::Pose) return skeletonIn(in, input.scene, object, effectorOf(call));
    if (op.accepts == Kind::Mesh) return meshIn(in, input.scene, object, progress);
    throw Error(in, op.id + " works on " + kindName(op.accepts) + ", which no file holds; give - as input");
}

}  // namespace mw::cli
