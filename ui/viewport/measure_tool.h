// Measuring by clicks: two points for a distance and its parts along the axes, a third for angle and area. Points snap to a vertex within
// 10 pixels, else to an edge within 7, else lie on the surface.
#pragma once
#include <functional>

#include "ui/viewport/tool.h"

namespace mw {

struct MeasuredPoint {
    enum class On { Vertex, Edge, Face, Ground, Joint } on = On::Face;
    glm::dvec3 at{0};  ///< world
    NodeId node;
    uint32_t vertex = none, face = none;
    glm::uvec2 edge{none, none};
    glm::uvec3 corners{none, none, none};  ///< of the triangle it lies in
    glm::dvec3 weights{0};                 ///< barycentric, in that triangle
};

class MeasureTool : public Tool {
public:
    using Tool::Tool;
    bool click(const PointerEvent& e) override;
    void rest(const PointerEvent& e) override;
    void leave() override;
    bool key(const QKeyEvent& e) override;  ///< Ctrl+C copies
    bool abort() override;                  ///< clears
    void decorate(Frame& frame) override;
    QString hint(Qt::KeyboardModifiers m) const override;
    Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
    bool marksHover() const override { return false; }

    const std::vector<MeasuredPoint>& points() const { return points_; }  ///< up to three
    QString report() const;                                               ///< for people, rich text; empty while there is nothing
    QString copyText() const;                                             ///< names and full numbers, a line each
    std::function<void()> changed;

private:
    std::optional<MeasuredPoint> pointAt(glm::dvec2 at);
    void tell();
    std::vector<MeasuredPoint> points_;
    std::optional<MeasuredPoint> hover_;
};

}  // namespace mw
