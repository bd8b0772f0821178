// See step_subject.h.
#include "ui/steps/step_subject.h"

#include <QObject>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/catalog/lesson_scene.h"
#include "core/character/kinematic_chain.h"

namespace mw {

namespace {

NodeId meshNode(const Session& s)
{
    const NodeId active = s.document.selection().active();
    const Node* n = s.document.scene().find(active);
    return n && n->mesh ? active : NodeId{};
}

ScenePose atPlayhead(const Session& s)
{
    const Clip* clip = s.document.scene().find(s.view.clip);
    return clip ? poseAt(s.document.scene(), *clip, s.view.time) : ScenePose();
}

QString lower(const std::string& s)
{
    return QString::fromStdString(s).toLower();
}

/// The selected joint; else a hand, a wrist, or the last joint of an arm; else the one furthest to the side.
uint32_t endJoint(const Pose& p, NodeId selected)
{
    const std::vector<Joint>& joints = p.skeleton->joints;
    for (uint32_t i = 1; i < joints.size(); ++i)
        if (joints[i].node == selected && joints[i].parent != none) return i;
    std::vector<int> depth(joints.size());
    for (uint32_t i = 0; i < joints.size(); ++i) depth[i] = joints[i].parent == none ? 0 : depth[joints[i].parent] + 1;
    const std::vector<glm::dvec3> places = jointPlaces(p);
    const auto aside = [&](uint32_t i) { return std::hypot(places[i].x - places[0].x, places[i].z - places[0].z); };
    uint32_t deepest = uint32_t(joints.size() - 1);
    for (uint32_t i = 1; i < joints.size(); ++i)
        if (aside(i) > aside(deepest)) deepest = i;
    for (const char* word : {"hand", "wrist"})
        for (uint32_t i = 1; i < joints.size(); ++i)
            if (lower(joints[i].name).contains(word)) return i;
    bool arm = false;
    for (uint32_t i = 1; i < joints.size(); ++i)
        if (lower(joints[i].name).contains("arm") && (!arm || depth[i] > depth[deepest])) deepest = i, arm = true;
    return deepest;
}

bool solves(const Operation& op)
{
    return std::any_of(op.parameters.begin(), op.parameters.end(), [](const Parameter& p) { return p.name == "effector"; });
}

void aimAt(StepSubject& s, const Pose& pose, NodeId selected)
{
    if (pose.size() < 2) return;
    ChainAim aim;
    const auto text = [&](const char* name) {
        const auto i = s.values.find(name);
        return i == s.values.end() ? std::string() : std::get<std::string>(i->second);
    };
    aim.effector = text("effector");
    aim.root = text("root");
    if (aim.effector.empty()) aim.effector = calledBy(*pose.skeleton, endJoint(pose, selected));
    s.values["effector"] = aim.effector;
    try {
        s.values.try_emplace("target", chainOf(pose, aim).target);
    } catch (const Error&) {  // said when it starts
    }
}

StepSubject ofLesson(const Operation& op, ParameterValues values)
{
    StepSubject s;
    s.values = std::move(values);
    const Lesson* lesson = findLesson(op.id);
    if (!lesson) return s;
    s.values.merge(parsed(op.parameters, lesson->scene.parameters));
    if (op.accepts == Kind::Nothing) return s;
    s.value = lessonSubject(*lesson);
    s.name = QString::fromStdString(lesson->scene.source.substr(0, lesson->scene.source.find(':')));
    return s;
}

StepSubject ofCharacter(const Session& session, NodeId top, const Operation& op, ParameterValues values)
{
    const Scene& scene = session.document.scene();
    StepSubject s;
    s.node = top;
    s.values = std::move(values);
    const Pose pose = poseOf(scene, top, atPlayhead(session));
    if (solves(op)) aimAt(s, pose, session.document.selection().active());
    s.value = pose;
    s.name = QString::fromStdString(scene.node(top).name);
    return s;
}

}  // namespace

NodeId characterOf(const Scene& scene, NodeId node)
{
    if (!scene.find(node)) return {};
    const std::vector<NodeId> tops = skeletonRoots(scene);
    const std::set<NodeId> known(tops.begin(), tops.end());
    const auto above = [&](NodeId id) {
        while (id && !known.contains(id)) id = scene.find(id) ? scene.node(id).parent : NodeId{};
        return id;
    };
    if (const NodeId top = above(node)) return top;
    std::vector<NodeId> open{node};
    while (!open.empty()) {
        const NodeId id = open.back();
        open.pop_back();
        const Node& n = scene.node(id);
        if (known.contains(id)) return id;
        const Skin* skin = scene.find(n.skin);
        if (skin && !skin->joints.empty())
            if (const NodeId top = above(skin->joints.front())) return top;
        open.insert(open.end(), n.children.begin(), n.children.end());
    }
    return {};
}

QString whyNotSteppable(const Session& session, const Operation& op)
{
    if (op.accepts == Kind::Mesh && !meshNode(session)) return QObject::tr("Select a mesh first.");
    return {};
}

NodeId subjectNode(const Session& session, const Operation& op)
{
    if (op.accepts == Kind::Mesh) return meshNode(session);
    return op.accepts == Kind::Pose ? characterOf(session.document.scene(), session.document.selection().active()) : NodeId{};
}

StepSubject stepSubject(const Session& session, const Operation& op, ParameterValues values)
{
    const Scene& scene = session.document.scene();
    if (op.accepts == Kind::Mesh) {
        StepSubject s;
        s.whyNot = whyNotSteppable(session, op);
        s.values = std::move(values);
        if (!s.whyNot.isEmpty()) return s;
        s.node = meshNode(session);
        s.value = session.document.shownMesh(scene.node(s.node).mesh);
        s.name = QString::fromStdString(scene.node(s.node).name);
        return s;
    }
    const NodeId active = session.document.selection().active();
    if (op.accepts == Kind::Pose)
        if (const NodeId top = characterOf(scene, active)) return ofCharacter(session, top, op, std::move(values));
    const Node* n = scene.find(active);
    const TerrainObject* terrain = n ? scene.find(n->terrain) : nullptr;
    if (op.accepts == Kind::HeightMap && terrain) return {{}, terrain->terrain.map, std::move(values), QString::fromStdString(n->name), {}};
    return ofLesson(op, std::move(values));
}

ScenePose shownPose(const Session& session, const ScenePose& played)
{
    const Pose* pose = session.steps.node() && session.steps.value() ? std::get_if<Pose>(session.steps.value()) : nullptr;
    if (!pose || !pose->skeleton) return played;
    ScenePose shown = atPlayhead(session);
    for (size_t i = 0; i < pose->size(); ++i) shown.locals[pose->skeleton->joints[i].node] = pose->locals[i];
    return shown;
}

}  // namespace mw
