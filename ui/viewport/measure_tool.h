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
    glm::uvec3 corners{none, none, none};                   ///< vertices of the triangle it lies in
    glm::dvec3 weights{0};                                  ///< barycentric, in that triangle
    std::vector<std::pair<QString, QString>> carried = {};  ///< what the mesh carries there: colour, texture coordinates, the value shown
    glm::dvec3 triangle[3] = {};                            ///< world
};

/// The second point against the surface of the first one (3.4.1).
struct SurfaceMeasure {
    double plane = 0;     ///< signed distance to the plane of the first point's triangle
    bool inside = false;  ///< its foot there lies in the triangle
    bool other = false;   ///< the points lie on different things: then `surface` says something
    double surface = 0;   ///< distance to the whole surface the first one lies on
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
    void describe(MeasuredPoint& p);
    void measureSurface();
    void tell();
    std::vector<MeasuredPoint> points_;
    std::optional<SurfaceMeasure> toSurface_;
    std::optional<MeasuredPoint> hover_;
};

}  // namespace mw
