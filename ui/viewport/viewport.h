// The view: draws the frame, turns pointer events into camera moves and selections. Repaints only when something has changed.
#pragma once
#include <epoxy/gl.h>
// epoxy comes before Qt's own OpenGL headers
#include <QElapsedTimer>
#include <QMenu>
#include <QOpenGLWidget>
#include <QRubberBand>
#include <QTimer>
#include <QVariantAnimation>

#include "ui/viewport/brush_tool.h"
#include "ui/viewport/frame_builder.h"

namespace mw {

class Viewport : public QOpenGLWidget {
    Q_OBJECT

public:
    Viewport(Session& session, QWidget* parent = nullptr);
    ~Viewport() override;

    void frameAll(bool fly = true);
    void frameSelection();
    void lookFrom(const QString& view);  ///< "front", ...; a second time the opposite
    void setBoxTool(bool on);
    bool boxTool() const { return boxTool_; }
    void setBrushTool();
    bool abortDrag();  ///< a stroke: the ground is as before; false when there is none
    size_t trianglesDrawn() const { return trianglesDrawn_; }
    void setContextMenu(QMenu* menu) { menu_ = menu; }
    size_t framesDrawn() const { return framesDrawn_; }
    const Frame& frame();
    /// What a click at this place does; `point` in logical pixels.
    void click(QPointF point, Qt::KeyboardModifiers modifiers);
    void selectBox(const QRect& box, Qt::KeyboardModifiers modifiers);

signals:
    void hint(const QString& text);
    void failed(const QString& text);  ///< the driver cannot draw, or a query could not run
    void cameraMoved();
    void painted();

protected:
    void initializeGL() override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* e) override;
    void mouseMoveEvent(QMouseEvent* e) override;
    void mouseReleaseEvent(QMouseEvent* e) override;
    void wheelEvent(QWheelEvent* e) override;
    void leaveEvent(QEvent* e) override;
    bool event(QEvent* e) override;

private:
    enum class Drag { None, Pending, Orbit, Pan, Zoom, Box, Paint };
    void refresh();                      // the frame is out of date
    Bounds focusBounds();                // of the step's focus, in the world
    void enterOrLeaveLab();
    void followFocus();                  // turns the camera when the focus cannot be seen
    Camera facing(const Bounds& focus);  // the present camera, turned to it from outside
    void showFrame(const Bounds& bounds, bool fly);
    void flyTo(const Camera& to);
    void beginDrag(QPointF at);
    void drag(QPointF at);
    void hover();
    void pointAt(QPointF at);  // the ground there
    Ray rayAt(QPointF at) const { return session_.view.camera.ray({at.x(), at.y()}, logicalSize()); }
    void toolChanged();
    void say(Qt::KeyboardModifiers modifiers);
    QString markerView(QPointF at) const;  // "top" when a ball of the orientation marker is there
    Bounds boundsOfNodes(const std::vector<NodeId>& nodes);
    std::optional<Pick> pickAt(QPointF at);
    NodeId jointUnder(QPointF at, bool surface);  // when joints are picked, or nothing else is there
    glm::ivec2 deviceSize() const;
    glm::dvec2 logicalSize() const { return {width(), height()}; }

    Session& session_;
    HeatService heats_;
    BrushTool brush_;
    std::unique_ptr<Renderer> renderer_;
    std::shared_ptr<void> subscription_;
    Frame frame_;
    bool stale_ = true, boxTool_ = false, framedOnce_ = false;
    std::optional<Mark> hoverMark_;
    std::optional<Camera> beforeLab_;
    const Operation* labOf_ = nullptr;
    QMenu* menu_ = nullptr;

    Drag drag_ = Drag::None;
    Qt::MouseButton button_ = Qt::NoButton;
    Qt::KeyboardModifiers modifiers_;
    QPointF pressed_, last_;
    glm::dvec3 pivot_{0};
    QRubberBand* band_;
    QTimer hoverTimer_;
    QVariantAnimation flight_;
    QTimer brushTold_;  // its numbers are shown while it runs
    size_t framesDrawn_ = 0, trianglesDrawn_ = 0;
};

}  // namespace mw
