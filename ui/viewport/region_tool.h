// Box and lasso: a drag draws a region, release selects what is in it. Shift adds, Ctrl removes, nothing replaces.
#pragma once
#include "ui/viewport/region_select.h"

namespace mw {

class RegionTool : public Tool {
public:
    RegionTool(ToolView& view, bool lasso) : Tool(view), lasso_(lasso) {}
    /// A quick one, from the Select tool by Shift or Ctrl+Shift: it adds, or removes when only Ctrl is held at the end.
    void beginQuick(const PointerEvent& e);

    bool beginDrag(const PointerEvent& e) override;
    void move(const PointerEvent& e) override;
    void release(const PointerEvent& e) override;
    bool abort() override;
    void decorate(Frame& frame) override;
    QString hint(Qt::KeyboardModifiers m) const override;
    Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

private:
    Region region() const;
    bool lasso_, quick_ = false;
    std::vector<glm::dvec2> line_;  // of the lasso; of the box two corners; empty: no drag
};

/// A rectangle between two places in logical pixels.
Region boxRegion(const ToolView& view, glm::dvec2 a, glm::dvec2 b);

}  // namespace mw
