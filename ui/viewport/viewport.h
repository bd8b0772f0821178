// The view: draws the frame, turns pointer events into camera moves and selections. Repaints only when something has changed.
#pragma once
#include <epoxy/gl.h>
// epoxy comes before Qt's own OpenGL headers
#include <QElapsedTimer>
#include <QMenu>
#include <QOpenGLWidget>
#include <QTimer>
#include <QVariantAnimation>
#include <array>

#include "render/offscreen.h"
#include "ui/viewport/frame_builder.h"
#include "ui/viewport/tool.h"

namespace mw {

class BrushTool;
class RegionTool;

class Viewport : public QOpenGLWidget, public ToolView {
    Q_OBJECT

public:
    /// `view` is its place among the views of the session; `heats` may serve several.
    Viewport(Session& session, std::shared_ptr<HeatService> heats, int view = 0, QWidget* parent = nullptr);
    ~Viewport() override;

    void frameAll(bool fly = true);
    void frameSelection();
    void lookFrom(const QString& view);  ///< "front", ...; a second time the opposite
    bool abortDrag();                    ///< what a tool has under way: all is as before; false when there is nothing
    int view() const { return view_; }
    const ViewSettings& look() const override { return session_.view.of(view_); }
    ViewSettings& look() { return session_.view.of(view_); }
    Tool& tool(ToolKind kind) { return *tools_[size_t(kind)]; }
    Tool& tool() { return tool(session_.view.tool); }  ///< the one in hand
    // What tools ask.
    Session& session() override { return session_; }
    const Frame& seen() override;
    glm::dvec2 logicalSize() const override { return {width(), height()}; }
    double pixelRatio() const override { return devicePixelRatioF(); }
    std::optional<Pick> pick(glm::dvec2 at) override { return pickAt({at.x, at.y}); }
    std::vector<std::pair<NodeId, std::vector<uint32_t>>> visibleFaces(const Region& region) override;
    void redraw() override { update(); }
    const Renderer::Counts& drawn() const { return drawn_; }  ///< of the last frame
    void setContextMenu(QMenu* menu) { menu_ = menu; }
    size_t framesDrawn() const { return framesDrawn_; }
    const Frame& frame();
    /// Of any size, drawn off-screen by the same renderer. Throws Error when the driver cannot.
    Picture picture(const Frame& of, glm::ivec2 size);
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
    void mouseDoubleClickEvent(QMouseEvent* e) override;
    void wheelEvent(QWheelEvent* e) override;
    void leaveEvent(QEvent* e) override;
    void keyPressEvent(QKeyEvent* e) override;
    void focusInEvent(QFocusEvent* e) override;
    bool event(QEvent* e) override;

private:
    enum class Drag { None, Pending, Orbit, Pan, Zoom, Tool };
    void refresh();        // the frame is out of date
    Bounds focusBounds();  // of the step's focus, in the world
    void enterOrLeaveLab();
    void followFocus();                  // turns the camera when the focus cannot be seen
    Camera facing(const Bounds& focus);  // the present camera, turned to it from outside
    void showFrame(const Bounds& bounds, bool fly);
    void flyTo(const Camera& to);
    void beginDrag(QPointF at);
    void drag(QPointF at);
    void hover();
    void showValue(const std::optional<Pick>& pick);
    void pointAt(QPointF at);  // the ground there
    void moved();              // the camera
    void toolChanged();
    void showCursor();
    PointerEvent eventAt(QPointF at, Qt::KeyboardModifiers m) const { return {{at.x(), at.y()}, m}; }
    bool toolIdle() const;  // the tool in hand waits: nothing is stepped
    void say(Qt::KeyboardModifiers modifiers);
    QString markerView(QPointF at) const;  // "top" when a ball of the orientation marker is there
    Bounds boundsOfNodes(const std::vector<NodeId>& nodes);
    std::optional<Pick> pickAt(QPointF at);
    NodeId jointUnder(QPointF at, bool surface);  // when joints are picked, or nothing else is there
    glm::ivec2 deviceSize() const;

    Session& session_;
    std::shared_ptr<HeatService> heats_;
    const int view_;
    std::array<std::unique_ptr<Tool>, 10> tools_;  // by ToolKind
    BrushTool* brush_ = nullptr;
    Tool* dragTool_ = nullptr;  // whose drag goes on
    std::unique_ptr<Renderer> renderer_;
    std::shared_ptr<void> subscription_;
    Frame frame_;
    bool stale_ = true, toolKey_ = false;
    std::optional<Mark> hoverMark_;
    std::optional<Label> hoverValue_;  // of the heat map
    std::optional<Camera> beforeLab_;
    const Operation* labOf_ = nullptr;
    QMenu* menu_ = nullptr;

    Drag drag_ = Drag::None;
    Qt::MouseButton button_ = Qt::NoButton;
    Qt::KeyboardModifiers modifiers_;
    QPointF pressed_, last_;
    glm::dvec3 pivot_{0};
    QTimer hoverTimer_;
    QVariantAnimation flight_;
    size_t framesBuilt_ = 0, framesDrawn_ = 0;
    Renderer::Counts drawn_;
};

}  // namespace mw
