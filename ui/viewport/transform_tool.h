// Move, Rotate, Scale: handles at the selection; a drag previews, release is one history entry. Nodes are edited by "transform", elements
// of a base mesh by "move-elements", so that history and shell can repeat it.
#pragma once
#include "ui/viewport/gizmo.h"
#include "ui/viewport/tool.h"

namespace mw {

/// What handles would move.
struct TransformSubject {
    struct Target {
        NodeId node;
        Transform start;  ///< local
        glm::dmat4 worldFromParent{1};
        glm::dvec3 origin{0};  ///< world
    };
    std::vector<Target> nodes;  ///< none is below another
    NodeId elementsOf;          ///< or: elements of this one
    ElementSet elements;
    std::vector<uint32_t> vertices;
    glm::dmat4 worldFromLocal{1};  ///< of `elementsOf`
    GizmoPlace place;
    QString obstacle;  ///< why there are no handles; empty: there are, or nothing is selected
    enum class Remedy { None, ShowBase, Rest } remedy = Remedy::None;
    bool empty() const { return !obstacle.isEmpty() || (nodes.empty() && !elementsOf); }
};
TransformSubject transformSubject(const Session& session, const ViewSettings& look, ToolKind tool);

/// The local transform of a target after a drag. Positions follow exactly; where a parent is scaled unevenly, a turn keeps the node's own scale.
Transform transformed(const TransformSubject::Target& target, ToolKind tool, const GizmoPlace& place, glm::dvec3 axis, glm::dvec3 value,
                      bool aboutPlace);
/// What a drag does to places in the world.
glm::dmat4 worldMatrix(ToolKind tool, const GizmoPlace& place, glm::dvec3 axis, glm::dvec3 value);

class TransformTool : public Tool {
public:
    TransformTool(ToolView& view, ToolKind kind) : Tool(view), kind_(kind) {}
    bool press(const PointerEvent& e) override;
    void move(const PointerEvent& e) override;
    void release(const PointerEvent& e) override;
    void hover(const PointerEvent& e) override;
    void leave() override;
    bool key(const QKeyEvent& e) override;
    bool abort() override;
    void decorate(Frame& frame) override;
    QString hint(Qt::KeyboardModifiers m) const override;
    Qt::CursorShape cursor() const override { return hot_ >= 0 ? Qt::SizeAllCursor : Qt::ArrowCursor; }
    bool marksHover() const override { return hot_ < 0; }
    /// The handles as they stand; none when nothing can be moved.
    std::optional<Gizmo> gizmo();

private:
    glm::dvec3 value() const;
    void preview();
    bool stillThere() const;
    std::vector<EditCall> calls() const;
    void apply(Scene& scene) const;
    void commit();

    const ToolKind kind_;
    int hot_ = -1;
    std::optional<HandleDrag> drag_;
    TransformSubject subject_;  // of the drag
    std::shared_ptr<const Scene> before_;
    bool snap_ = false;
    QString typed_;
};

}  // namespace mw
