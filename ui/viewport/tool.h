// What a tool of the view is: plain pointer events in; edits of the document, and marks over the picture, out.
#pragma once
#include <QKeyEvent>
#include <QString>
#include <optional>

#include "ui/session.h"

namespace mw {

/// Places in logical pixels of the view, from its top left.
struct PointerEvent {
    glm::dvec2 at{0};
    Qt::KeyboardModifiers modifiers;
    bool shift() const { return modifiers & Qt::ShiftModifier; }
    bool control() const { return modifiers & Qt::ControlModifier; }
    bool alt() const { return modifiers & Qt::AltModifier; }
};

/// The view a tool works in. Frames and picks are of what is on screen now.
class ToolView {
public:
    virtual ~ToolView() = default;
    virtual Session& session() = 0;
    virtual const ViewSettings& look() const = 0;
    virtual const Frame& seen() = 0;
    virtual glm::dvec2 logicalSize() const = 0;
    virtual double pixelRatio() const = 0;
    virtual std::optional<Pick> pick(glm::dvec2 at) = 0;
    virtual std::vector<std::pair<NodeId, std::vector<uint32_t>>> visibleFaces(const Region& region) = 0;
    virtual void redraw() = 0;
    Ray ray(glm::dvec2 at) const { return look().camera.ray(at, logicalSize()); }
};

class Tool {
public:
    explicit Tool(ToolView& view) : view_(view) {}
    virtual ~Tool() = default;
    Tool(const Tool&) = delete;

    /// True: this press begins a drag of the tool at once (a handle, a brush); move() and release() follow.
    virtual bool press(const PointerEvent&) { return false; }
    /// True: a drag that has just left the place of its press is the tool's. `e` is that place.
    virtual bool beginDrag(const PointerEvent&) { return false; }
    virtual void move(const PointerEvent&) {}
    virtual void release(const PointerEvent&) {}
    /// True: the click was used; else it picks.
    virtual bool click(const PointerEvent&) { return false; }
    virtual void hover(const PointerEvent&) {}
    virtual void rest(const PointerEvent&) {}  ///< the pointer has moved and is slow enough for a pick
    virtual void leave() {}
    /// Keys while the focus is in the view; true: used, no shortcut hears it.
    virtual bool key(const QKeyEvent&) { return false; }
    /// Ends what goes on and takes it back; false when there is nothing.
    virtual bool abort() { return false; }
    /// What it shows over the picture.
    virtual void decorate(Frame&) {}
    virtual QString hint(Qt::KeyboardModifiers) const = 0;
    virtual Qt::CursorShape cursor() const { return Qt::ArrowCursor; }
    /// Elements under the pointer light up while it is in hand.
    virtual bool marksHover() const { return true; }

protected:
    Session& session() const { return view_.session(); }
    ToolView& view_;
};

}  // namespace mw
