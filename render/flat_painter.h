// Flat pictures without a scene: what was put on the canvas, over nothing, read back. For sheets that are put together from several views.
#pragma once
#include <memory>

#include "render/canvas.h"
#include "render/offscreen.h"

namespace mw {

class FlatPainter {
public:
    /// Draws in the offscreen's context, which must live longer.
    explicit FlatPainter(Offscreen& offscreen);
    ~FlatPainter();
    Canvas& canvas();
    /// What was put since the last picture, in device pixels; colours are multiplied by their alpha, for overlay().
    Picture draw(int width, int height);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Puts a picture whose colours are multiplied by alpha over another at a place; what lies outside is cut off.
void overlay(Picture& under, const Picture& over, int left, int top);

}  // namespace mw
