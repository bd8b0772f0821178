// The handles of Move, Rotate and Scale: where they lie on screen, which one is near the pointer, and what a drag of it means. Numbers in,
// numbers out; the tool that owns them does the editing.
#pragma once
#include <optional>
#include <vector>

#include "ui/view_state.h"

namespace mw {

/// Where handles stand in the world; axes are unit and at right angles.
struct GizmoPlace {
    glm::dvec3 origin{0};
    glm::dmat3 axes{1};
};

struct Handle {
    enum class Kind {
        Axis,     ///< along one axis
        Plane,    ///< along both others
        Free,     ///< in the plane of the screen; of Scale: all axes alike
        Ring,     ///< about one axis
        ViewRing  ///< about the line of sight
    } kind = Kind::Axis;
    int axis = 0;
    std::vector<glm::dvec2> line;  ///< logical pixels; planes: their corners; free: the middle
};

class Gizmo {
public:
    /// Handles of `reach` logical pixels, whatever the zoom. None when the place is behind the eye.
    Gizmo(ToolKind tool, const Camera& camera, glm::dvec2 size, const GizmoPlace& place);
    static constexpr double reach = 90, grab = 8;  ///< logical pixels

    ToolKind tool() const { return tool_; }
    const GizmoPlace& place() const { return place_; }
    const std::vector<Handle>& handles() const { return handles_; }
    int at(glm::dvec2 pixel) const;       ///< the handle within `grab`; -1: none
    glm::dvec2 anchor(int handle) const;  ///< where its number is shown
    /// `hot` is white; while it is `held` the others are faint.
    void draw(int hot, bool held, std::vector<Flat>& out) const;

    /// What a pixel means on a handle. Move: metres along the three axes. Rotate: x is the angle, radians. Scale: metres along the axes, or
    /// for the free handle pixels to the right and up in x.
    std::optional<glm::dvec3> meaning(const Handle& handle, glm::dvec2 pixel) const;
    /// The line that a ring turns about.
    glm::dvec3 ringAxis(const Handle& handle) const;

private:
    void addAxis(int axis);
    void addPlane(int axis);
    void addRing(int axis);
    glm::dvec2 pixelOf(glm::dvec3 world) const { return glm::dvec2(camera_.project(world, size_)); }
    glm::dvec3 toEye() const;
    std::optional<glm::dvec3> onPlane(glm::dvec2 pixel, glm::dvec3 normal) const;

    ToolKind tool_;
    Camera camera_;
    glm::dvec2 size_;
    GizmoPlace place_;
    double unit_ = 0;  // metres a logical pixel, at the origin
    glm::dvec2 centre_{0};
    std::vector<Handle> handles_;
};

/// A drag of one handle: follows the pointer, at a tenth of its pace where asked, and rounds where asked.
class HandleDrag {
public:
    HandleDrag(const Gizmo& gizmo, int handle, glm::dvec2 pixel);
    void move(glm::dvec2 pixel, bool slow);
    /// Move: metres along the axes. Rotate: x is the angle, radians. Scale: factors. `snap`: to 0.1 m, 5 degrees, 0.1.
    glm::dvec3 value(bool snap) const;
    /// What a typed number, or two of them, mean on this handle: metres, degrees, factors. None: not a number.
    std::optional<glm::dvec3> typed(const QString& text) const;
    QString text(glm::dvec3 value) const;  ///< "X 0.25 m", "15\u00b0", "Y 1.2"
    const Gizmo& gizmo() const { return gizmo_; }
    const Handle& handle() const { return gizmo_.handles()[size_t(index_)]; }
    int index() const { return index_; }

private:
    bool involves(int axis) const;
    Gizmo gizmo_;
    int index_;
    glm::dvec3 start_{0}, last_{0}, value_{0};
};

}  // namespace mw
