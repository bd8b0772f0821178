#include "ui/viewport/transform_tool.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/math/euler.h"
#include "core/mesh/select.h"
#include "core/scene/edit.h"
#include "core/scene/move_elements.h"
#include "ui/playback.h"
#include "ui/words.h"

namespace mw {
namespace {

const char* verbOf(ToolKind tool)
{
    return tool == ToolKind::Move ? "move" : tool == ToolKind::Rotate ? "rotate" : "scale";
}

const char* nameOf(ElementKind kind, bool many)
{
    if (kind == ElementKind::Face) return many ? "faces" : "face";
    if (kind == ElementKind::Edge) return many ? "edges" : "edge";
    return many ? "vertices" : "vertex";
}

bool drives(const Channel& c, ToolKind tool)
{
    using Path = Channel::Path;
    switch (c.path) {
        case Path::Rotation:
        case Path::EulerX:
        case Path::EulerY:
        case Path::EulerZ:
            return tool == ToolKind::Rotate;
        case Path::Scale:
            return tool == ToolKind::Scale;
        case Path::Translation:
            return tool == ToolKind::Move;
        default:
            return false;  // places of BVH files are added to the node's own
    }
}

/// A skinned mesh stands by its joints: what holds these is moved in its place.
NodeId movedFor(const Scene& scene, NodeId node)
{
    const Skin* skin = scene.find(scene.node(node).skin);
    if (!skin || skin->joints.empty() || !scene.find(skin->joints.front())) return node;
    NodeId root = skin->joints.front();
    while (scene.node(root).parent && scene.node(scene.node(root).parent).joint != Node::Joint::No) root = scene.node(root).parent;
    const NodeId above = scene.node(root).parent;
    return above ? above : root;
}

std::vector<NodeId> topmost(const Scene& scene, const std::vector<NodeId>& selected)
{
    std::vector<NodeId> nodes;
    for (const NodeId n : selected) {
        const NodeId moved = scene.find(n) ? movedFor(scene, n) : NodeId{};
        if (moved && std::find(nodes.begin(), nodes.end(), moved) == nodes.end()) nodes.push_back(moved);
    }
    std::vector<NodeId> top;
    for (const NodeId n : nodes) {
        bool below = false;
        for (NodeId a = scene.node(n).parent; a && !below; a = scene.node(a).parent) below = std::find(nodes.begin(), nodes.end(), a) != nodes.end();
        if (!below) top.push_back(n);
    }
    return top;
}

glm::dmat3 axesOf(const glm::dmat4& world)
{
    return glm::mat3_cast(transformOf(world).rotation);
}

void takeElements(const Session& s, const ViewSettings& look, const std::map<NodeId, glm::dmat4>& worlds, ToolKind tool, TransformSubject& out)
{
    const Scene& scene = s.document.scene();
    const Selection& selection = s.document.selection();
    const Node& node = scene.node(selection.elementsOf);
    const MeshObject* object = scene.find(node.mesh);
    if (!object) return;
    const auto level = look.shownLevel.find(node.mesh);
    const bool base = object->stack.empty() || (level != look.shownLevel.end() && level->second == 0);
    if (!base) {
        out.obstacle = QString("These are elements of the result: %1 made them. Those of the base mesh can be moved.")
                           .arg(object->stack.size() == 1 ? QString("a modifier") : QString("%1 modifiers").arg(object->stack.size()));
        out.remedy = TransformSubject::Remedy::ShowBase;
        return;
    }
    const ScenePose pose = s.playback ? s.playback->pose() : ScenePose();
    if (meshPose(scene, selection.elementsOf, object->base, pose, worlds)) {
        out.obstacle = "This mesh is moved by joints or morphs; elements can be moved on meshes at rest.";
        return;
    }
    out.vertices = verticesOf(object->base, selection.elements);
    if (out.vertices.empty()) return;
    out.elementsOf = selection.elementsOf;
    out.elements = selection.elements;
    out.worldFromLocal = worlds.at(selection.elementsOf);
    glm::dvec3 sum(0);
    for (const uint32_t v : out.vertices) sum += glm::dvec3(object->base.positions()[v]);
    out.place.origin = glm::dvec3(out.worldFromLocal * glm::dvec4(sum / double(out.vertices.size()), 1));
    if (s.view.localAxes) out.place.axes = axesOf(out.worldFromLocal);
    if (std::abs(glm::determinant(glm::dmat3(out.worldFromLocal))) < 1e-30) {
        out.obstacle = QString("\"%1\" is scaled to nothing; give it a scale first.").arg(nodeName(scene, selection.elementsOf));
        out.elementsOf = {};
    }
    (void)tool;
}

/// The middle of what the targets show.
glm::dvec3 middleOf(const Scene& scene, const std::vector<TransformSubject::Target>& targets, const std::map<NodeId, glm::dmat4>& worlds)
{
    Bounds all;
    for (const auto& t : targets) {
        const MeshObject* object = scene.find(scene.node(t.node).mesh);
        const Bounds b = object && !scene.find(scene.node(t.node).skin) ? object->base.bounds() : Bounds();
        for (int i = 0; i < 8 && !b.empty; ++i)
            all.add(glm::dvec3(worlds.at(t.node) * glm::dvec4(i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z, 1)));
        if (b.empty) all.add(t.origin);
    }
    return all.centre();
}

}  // namespace

TransformSubject transformSubject(const Session& s, const ViewSettings& look, ToolKind tool)
{
    TransformSubject out;
    const Scene& scene = s.document.scene();
    const Selection& selection = s.document.selection();
    if (selection.nodes.empty() || s.steps.isOpen()) return out;
    const std::map<NodeId, glm::dmat4> worlds = worldMatrices(scene, s.playback ? s.playback->pose() : ScenePose());
    if (selection.elementsOf && !selection.elements.indices.empty() && scene.find(selection.elementsOf)) {
        takeElements(s, look, worlds, tool, out);
        return out;
    }
    const Clip* clip = s.playback ? s.playback->clip() : nullptr;
    for (const NodeId n : topmost(scene, selection.nodes)) {
        const Node& node = scene.node(n);
        const bool driven = clip && std::any_of(clip->channels.begin(), clip->channels.end(),
                                                [&](const auto& c) { return c->node == n && c->keys() > 0 && drives(*c, tool); });
        if (driven) {
            const QString name = clip->name.empty() ? QString("the clip") : QString("the clip \"%1\"").arg(QString::fromStdString(clip->name));
            out.obstacle = QString("\"%1\" follows %2: keys say how it stands. At rest it can be moved.").arg(nodeName(scene, n), name);
            out.remedy = TransformSubject::Remedy::Rest;
            out.nodes.clear();
            return out;
        }
        const glm::dmat4 parent = node.parent ? worlds.at(node.parent) : glm::dmat4(1);
        if (std::abs(glm::determinant(glm::dmat3(parent))) < 1e-30) {
            out.obstacle = QString("What \"%1\" hangs on is scaled to nothing; give that a scale first.").arg(nodeName(scene, n));
            out.nodes.clear();
            return out;
        }
        out.nodes.push_back({n, node.local, parent, glm::dvec3(worlds.at(n)[3])});
    }
    if (out.nodes.empty()) return out;
    const auto& active = out.nodes.back();
    out.place.origin = s.view.pivotCentre ? middleOf(scene, out.nodes, worlds) : active.origin;
    if (s.view.localAxes || tool == ToolKind::Scale) out.place.axes = axesOf(worlds.at(active.node));  // scales lie along a node's own axes
    return out;
}

glm::dmat4 worldMatrix(ToolKind tool, const GizmoPlace& place, glm::dvec3 axis, glm::dvec3 value)
{
    if (tool == ToolKind::Move) return glm::translate(glm::dmat4(1), place.axes * value);
    glm::dmat4 m(1);
    if (tool == ToolKind::Rotate) m = glm::rotate(m, value.x, axis);
    if (tool == ToolKind::Scale) {
        const glm::dmat3 scale(glm::dvec3(value.x, 0, 0), glm::dvec3(0, value.y, 0), glm::dvec3(0, 0, value.z));
        m = glm::dmat4(place.axes * scale * glm::transpose(place.axes));
    }
    return glm::translate(glm::dmat4(1), place.origin) * m * glm::translate(glm::dmat4(1), -place.origin);
}

Transform transformed(const TransformSubject::Target& t, ToolKind tool, const GizmoPlace& place, glm::dvec3 axis, glm::dvec3 value, bool aboutPlace)
{
    Transform out = t.start;
    const glm::dmat3 parentFromWorld = glm::inverse(glm::dmat3(t.worldFromParent));
    if (aboutPlace || tool == ToolKind::Move) {
        const glm::dvec3 to(worldMatrix(tool, place, axis, value) * glm::dvec4(t.origin, 1));
        out.translation += parentFromWorld * (to - t.origin);
    }
    if (tool == ToolKind::Scale) out.scale *= value;
    if (tool != ToolKind::Rotate) return out;
    const Transform parent = transformOf(t.worldFromParent);
    glm::dquat turn = glm::conjugate(parent.rotation) * glm::angleAxis(value.x, axis) * parent.rotation;
    if (parent.scale.x < 0) turn = glm::dquat(turn.w, turn.x, -turn.y, -turn.z);  // seen in a mirror
    out.rotation = glm::normalize(turn * t.start.rotation);
    return out;
}

std::optional<Gizmo> TransformTool::gizmo()
{
    TransformSubject s = transformSubject(session(), view_.look(), kind_);
    if (drag_) s.place.axes = kind_ == ToolKind::Rotate ? subject_.place.axes : s.place.axes;
    if (s.empty()) return std::nullopt;
    return Gizmo(kind_, view_.look().camera, view_.logicalSize(), s.place);
}

bool TransformTool::press(const PointerEvent& e)
{
    if (e.alt()) return false;
    const auto g = gizmo();
    const int handle = g ? g->at(e.at) : -1;
    if (handle < 0) return false;
    subject_ = transformSubject(session(), view_.look(), kind_);
    before_ = session().document.snapshot();
    drag_.emplace(*g, handle, e.at);
    hot_ = handle;
    typed_.clear();
    snap_ = false;
    return true;
}

glm::dvec3 TransformTool::value() const
{
    const auto typed = typed_.isEmpty() ? std::nullopt : drag_->typed(typed_);
    glm::dvec3 v = typed ? *typed : drag_->value(snap_);
    if (kind_ == ToolKind::Scale)
        for (int a = 0; a < 3; ++a)
            if (std::abs(v[a]) < 1e-4) v[a] = v[a] < 0 ? -1e-4 : 1e-4;  // flat things could not be opened again
    return v;
}

std::vector<EditCall> TransformTool::calls() const
{
    const glm::dvec3 axis = drag_->gizmo().ringAxis(drag_->handle()), v = value();
    if (subject_.elementsOf) {
        const glm::dmat4 m = glm::inverse(subject_.worldFromLocal) * worldMatrix(kind_, subject_.place, axis, v) * subject_.worldFromLocal;
        return {{"move-elements",
                 {{"node", nodeText(*before_, subject_.elementsOf)},
                  {"kind", std::string(nameOf(subject_.elements.kind, false))},
                  {"elements", elementText(subject_.elements)},
                  {"x", glm::dvec3(m[0])},
                  {"y", glm::dvec3(m[1])},
                  {"z", glm::dvec3(m[2])},
                  {"by", glm::dvec3(m[3])}}}};
    }
    std::vector<EditCall> all;
    for (const auto& t : subject_.nodes) {
        const Transform to = transformed(t, kind_, subject_.place, axis, v, session().view.pivotCentre);
        all.push_back({"transform",
                       {{"node", nodeText(*before_, t.node)},
                        {"position", to.translation},
                        {"rotation", glm::degrees(eulerAnglesOf(to.rotation))},
                        {"scale", to.scale}}});
    }
    return all;
}

/// Undo in the middle of a drag takes away what it began with.
bool TransformTool::stillThere() const
{
    const Document& d = session().document;
    return d.history()[d.historyPosition()].scene == before_;
}

void TransformTool::preview()
{
    if (!stillThere()) return drag_.reset();
    Scene next = *before_;
    const glm::dvec3 axis = drag_->gizmo().ringAxis(drag_->handle()), v = value();
    try {
        if (subject_.elementsOf) {
            const glm::dmat4 m = glm::inverse(subject_.worldFromLocal) * worldMatrix(kind_, subject_.place, axis, v) * subject_.worldFromLocal;
            moveVertices(next, subject_.elementsOf, subject_.vertices, m);
        }
        for (const auto& t : subject_.nodes) {
            Node n = next.node(t.node);
            n.local = transformed(t, kind_, subject_.place, axis, v, session().view.pivotCentre);
            next.set(t.node, std::move(n));
        }
    } catch (const Error&) {
        return;  // out of the range of numbers: the last place stays
    }
    Document& document = session().document;
    const Selection selection = document.selection();
    document.preview(std::move(next));
    if (!document.selection().elementsOf && selection.elementsOf) document.select(selection);  // the base under a stack: the drag goes on
}

void TransformTool::move(const PointerEvent& e)
{
    if (!drag_) return;
    drag_->move(e.at, e.shift());
    snap_ = e.control();
    if (typed_.isEmpty()) preview();
}

void TransformTool::release(const PointerEvent&)
{
    if (drag_) commit();
}

void TransformTool::commit()
{
    Document& document = session().document;
    const glm::dvec3 still = kind_ == ToolKind::Scale ? glm::dvec3(1) : glm::dvec3(0);
    const std::vector<EditCall> edits = value() == still || !stillThere() ? std::vector<EditCall>() : calls();
    drag_.reset();
    view_.redraw();
    if (edits.empty()) return document.cancelPreview();
    const Selection selection = document.selection();
    Scene next = *before_;
    try {
        for (const EditCall& call : edits) next = edited(next, call);
    } catch (const Error&) {
        return document.cancelPreview();
    }
    const std::string what = subject_.elementsOf          ? before_->node(subject_.elementsOf).name
                             : subject_.nodes.size() == 1 ? before_->node(subject_.nodes[0].node).name
                                                          : std::to_string(subject_.nodes.size()) + " nodes";
    const std::string name = what + ": " + verbOf(kind_) + (subject_.elementsOf ? std::string(" ") + nameOf(subject_.elements.kind, true) : "");
    document.commit(name, std::move(next), selection, edits);
}

bool TransformTool::abort()
{
    if (!drag_) return false;
    drag_.reset();
    session().document.cancelPreview();
    view_.redraw();
    return true;
}

bool TransformTool::key(const QKeyEvent& e)
{
    if (!drag_) return false;
    const QString text = e.text();
    if (e.key() == Qt::Key_Return || e.key() == Qt::Key_Enter) {
        commit();
        return true;
    }
    if (e.key() == Qt::Key_Backspace)
        typed_.chop(1);
    else if (text.size() == 1 && (text[0].isDigit() || QString("-.,").contains(text[0])) && typed_.size() < 24)
        typed_ += text;
    else
        return false;
    preview();
    return true;
}

void TransformTool::hover(const PointerEvent& e)
{
    const auto g = gizmo();
    const int now = g ? g->at(e.at) : -1;
    if (now == hot_) return;
    hot_ = now;
    view_.redraw();
}

void TransformTool::leave()
{
    if (drag_ || hot_ < 0) return;
    hot_ = -1;
    view_.redraw();
}

void TransformTool::decorate(Frame& frame)
{
    const auto g = gizmo();
    if (!g) return;
    if (drag_ && drag_->index() < int(g->handles().size()) && g->handles().size() == drag_->gizmo().handles().size()) {
        g->draw(drag_->index(), true, frame.flats);
        Flat number;
        number.kind = Flat::Kind::Text;
        number.at = {glm::vec2(g->anchor(drag_->index())) + glm::vec2(12, 24)};
        number.text = (typed_.isEmpty() ? drag_->text(value()) : typed_ + "_  " + drag_->text(value())).toStdString();
        frame.flats.push_back(std::move(number));
    } else {
        g->draw(drag_ ? -1 : hot_, false, frame.flats);
    }
}

QString TransformTool::hint(Qt::KeyboardModifiers m) const
{
    const char* const grid = kind_ == ToolKind::Rotate ? "steps of 5\u00b0" : kind_ == ToolKind::Move ? "steps of 0.1 m" : "steps of 0.1";
    if (drag_) return QString("Type a number \u00b7 Ctrl %1 \u00b7 Shift ten times slower \u00b7 Enter takes it \u00b7 Esc as before").arg(grid);
    if (session().document.selection().nodes.empty()) return QString("Click something to %1 it \u00b7 Drag orbits").arg(verbOf(kind_));
    if (m & Qt::ShiftModifier) return "Shift+click adds \u00b7 Shift+drag boxes, adding";
    if (m & Qt::ControlModifier) return QString("Ctrl+click toggles \u00b7 Ctrl while dragging a handle: %1").arg(grid);
    return QString("Drag a handle to %1 \u00b7 type the number while dragging \u00b7 Click picks \u00b7 Drag beside it orbits").arg(verbOf(kind_));
}

}  // namespace mw
