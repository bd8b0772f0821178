// See step_frame.h.
#include "ui/viewport/step_frame.h"

#include <glm/trigonometric.hpp>
#include <map>

#include "core/catalog/lesson.h"
#include "render/value_frame.h"

namespace mw {
namespace {

constexpr size_t edgesShownUpTo = 20'000;  // faces, while stepping

// What an algorithm does is done to faces and edges: they are shown, unless there are too many to tell apart.
void showEdges(Frame& frame, const Mesh& mesh)
{
    if (mesh.faceCount() == 0 || mesh.faceCount() > edgesShownUpTo) return;
    frame.options.wireOverlay = true;
    if (frame.options.shading == Shading::Smooth) frame.options.shading = Shading::Flat;
}

// What a query has found so far, as colours; the rest is undefined yet.
std::shared_ptr<const HeatMap> heatSoFar(const Value* value, const Mesh& mesh)
{
    const Table* table = value ? std::get_if<Table>(value) : nullptr;
    if (!table || table->columns.empty() || mesh.faceCount() > edgesShownUpTo) return nullptr;
    auto heat = std::make_shared<HeatMap>();
    std::tie(heat->low, heat->high) = heatRange(table->columns.front());
    heat->table = std::make_shared<Table>(*table);
    return heat;
}

// The scene was posed by the same joints already: their bones stay as they are coloured there. Others are added.
void markPose(const Session& s, Frame& frame, const Pose& pose)
{
    std::map<NodeId, glm::vec4> colors;
    for (const DrawBone& b : frame.bones) colors[b.node] = b.color;
    std::vector<NodeId> own;
    for (const Joint& j : pose.skeleton->joints) own.push_back(j.node);
    std::erase_if(frame.bones, [&](const DrawBone& b) { return std::find(own.begin(), own.end(), b.node) != own.end(); });
    addValue(frame, pose, s.steps.node(), glm::dmat4(1));
    for (DrawBone& b : frame.bones)
        if (const auto c = colors.find(b.node); c != colors.end()) b.color = c->second;
    addFocus(frame, s.steps.step(), pose, s.steps.node(), glm::dmat4(1));
}

}  // namespace

bool isLab(const StepSession& steps)
{
    return steps.isOpen() && !steps.node();
}

Frame labFrame(const Session& s, const ViewSettings& look)
{
    Frame frame;
    frame.camera = look.camera;
    frame.options = look.options;
    frame.options.grid = frame.options.axes = false;
    const Value* value = s.steps.value();
    if (!value) return frame;
    addValue(frame, *value, labNode, glm::dmat4(1));
    addFocus(frame, s.steps.step(), *value, labNode, glm::dmat4(1));
    for (const DrawObject& o : frame.objects) showEdges(frame, o.mesh);
    return frame;
}

void markStep(const Session& s, Frame& frame)
{
    const Value* value = s.steps.value();
    if (const Pose* pose = value ? std::get_if<Pose>(value) : nullptr; pose && pose->skeleton) return markPose(s, frame, *pose);
    for (DrawObject& o : frame.objects) {
        if (o.node != s.steps.node()) continue;
        if (const Mesh* mesh = value ? std::get_if<Mesh>(value) : nullptr) o.mesh = *mesh;
        o.pose = nullptr;  // places of a step are those of the mesh at rest
        o.worldFromLocal = s.document.scene().worldFromLocal(o.node);
        o.heat = heatSoFar(value, o.mesh);
        showEdges(frame, o.mesh);
        addFocus(frame, s.steps.step(), o.mesh, o.node, o.worldFromLocal);
    }
}

Bounds stepFocusBounds(const Session& s, const Frame& frame)
{
    const Value* value = s.steps.value();
    if (value && isDrawable(*value) && kindOf(*value) != Kind::Mesh) return focusBounds(s.steps.step(), *value, glm::dmat4(1));
    for (const DrawObject& o : frame.objects)
        if (o.node == s.steps.node()) return focusBounds(s.steps.step(), o.mesh, o.worldFromLocal);
    return {};
}

void lookAtLab(const Session& s, Camera& camera, double aspect)
{
    const Lesson* lesson = findLesson(s.steps.operation()->id);
    camera.azimuth = glm::radians(lesson ? lesson->scene.azimuth : 30);
    camera.elevation = glm::radians(lesson ? lesson->scene.elevation : 20);
    Frame frame = labFrame(s, s.view);
    Bounds bounds = boundsOf(frame), marked = bounds;
    for (const MarkPoint& p : frame.points) marked.add(glm::dvec3(p.atWorld));
    // A target's cross has an arm out of the plane; what it is a target of says whether there is a plane.
    const Bounds& shape = bounds.empty ? marked : bounds;
    const bool flat = !shape.empty && shape.size().z <= 1e-6 * shape.diagonal();
    bounds = marked;
    if (bounds.empty) {  // a source has made nothing yet: its unit square or sphere
        const bool sphere = s.steps.operation()->yields == Kind::Rotations;
        bounds.add(sphere ? glm::dvec3(-1) : glm::dvec3(-0.5, 0, -0.5));
        bounds.add(sphere ? glm::dvec3(1) : glm::dvec3(0.5, 0.35, 0.5));
    }
    camera.perspective = camera.azimuth != 0 || camera.elevation != 0 || !flat;
    // Chains swing round and curves overshoot: some room.
    const glm::dvec3 room = 0.25 * bounds.size();
    bounds.add(bounds.min - room);
    bounds.add(bounds.max + room);
    camera.frame(bounds, aspect);
}

}  // namespace mw
