// Painting on terrains: what lies under the pointer, the stroke that goes on, and the ring that shows its reach.
#pragma once
#include <QTimer>

#include "ui/viewport/tool.h"

namespace mw {

class BrushTool : public Tool {
public:
    explicit BrushTool(ToolView& view);

    /// The nearest ground along a ray of the world, with the level of detail of its patch there.
    std::optional<ViewState::GroundPlace> under(const Ray& ray) const;

    /// False where there is no ground: the drag then orbits. Ctrl lowers instead of raises.
    bool press(const PointerEvent& e) override;
    void move(const PointerEvent& e) override;
    void release(const PointerEvent& e) override;  ///< one history entry
    bool abort() override;                         ///< as before the stroke; false when there is none
    void decorate(Frame& frame) override;          ///< ring, needle, and for a while the numbers
    QString hint(Qt::KeyboardModifiers m) const override;
    Qt::CursorShape cursor() const override { return session().view.ground ? Qt::BlankCursor : Qt::ArrowCursor; }
    bool marksHover() const override { return false; }
    void tell();  ///< the numbers, beside the ring

private:
    bool painting() const { return node_.value != 0; }
    void dab(glm::dvec2 to);
    Brush brush() const;
    QTimer told_;  // numbers are shown while it runs
    NodeId node_;
    TerrainObject object_;
    glm::dvec2 last_{0};
    std::vector<glm::dvec2> way_;  // of the stroke so far
    Brush painted_;                // as it was when the stroke began
    double carry_ = -1;
    bool inverted_ = false;
};

/// "raise" or "lower": for hints and history.
const char* verbOf(Brush::Kind kind);

}  // namespace mw
