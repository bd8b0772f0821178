// Painting on terrains: what lies under the pointer, the stroke that goes on, and the ring that shows its reach.
#pragma once
#include <optional>

#include "render/camera.h"
#include "ui/session.h"

namespace mw {

class BrushTool {
public:
    explicit BrushTool(Session& session) : session_(session) {}

    /// The nearest ground along a ray of the world, with the level of detail of its patch there.
    std::optional<ViewState::GroundPlace> under(const Ray& ray) const;

    /// False when the ray meets no ground: the drag is then another tool's. `inverted`: lower instead of raise.
    bool press(const Ray& ray, bool inverted);
    void move(const Ray& ray);
    void release();  ///< one history entry
    bool abort();    ///< as before the stroke; false when there is none
    bool painting() const { return node_.value != 0; }

    /// Ring, needle, and while `told` the numbers, at a place.
    void decorate(Frame& frame, const ViewState::GroundPlace& place, bool told) const;

private:
    void dab(glm::dvec2 to);
    Brush brush() const;
    Session& session_;
    NodeId node_;
    TerrainObject object_;
    glm::dvec2 last_{0};
    double carry_ = -1;
    bool inverted_ = false;
};

/// "raise" or "lower": for hints and history.
const char* verbOf(Brush::Kind kind);

}  // namespace mw
