// Collapsing edges by hand: the edge under the pointer shows where it would go, or why it may not; a click adds the collapse to the modifiers.
#pragma once
#include "core/simplify/collapse_edge.h"
#include "ui/viewport/prepared.h"
#include "ui/viewport/tool.h"

namespace mw {

class CollapseTool : public Tool {
public:
    explicit CollapseTool(ToolView& view);
    bool click(const PointerEvent& e) override;
    void rest(const PointerEvent& e) override;
    void leave() override;
    void decorate(Frame& frame) override;
    QString hint(Qt::KeyboardModifiers m) const override;
    Qt::CursorShape cursor() const override;
    bool marksHover() const override { return false; }

    /// What is under the pointer: empty text for a legal collapse.
    struct Hover {
        NodeId node;
        uint32_t a = none, b = none;
        glm::dvec3 first{0}, second{0}, to{0};  ///< world
        bool legal = false;
        bool preparing = false;  ///< whether it is legal is known as soon as the tables of the mesh are there
        QString reason;
        glm::dvec2 pointer{0};
    };
    const std::optional<Hover>& hovered() const { return hover_; }

private:
    std::optional<Hover> at(const PointerEvent& e);
    QString obstacle(NodeId node) const;  ///< what keeps the node's edges from being collapsed; empty: nothing

    std::optional<Hover> hover_;
    PointerEvent last_;
    Prepared<EdgeCollapser> collapser_;
};

}  // namespace mw
