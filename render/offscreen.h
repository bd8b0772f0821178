// Pictures without a display: a surfaceless EGL context and a framebuffer read back. Never in a process that has Qt's OpenGL.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "render/renderer.h"

namespace mw {

/// RGBA, 8 bit, top row first.
struct Picture {
    int width = 0, height = 0;
    std::vector<uint8_t> rgba;
};

class Offscreen {
public:
    Offscreen();  ///< throws Error naming what is missing (driver, version)
    ~Offscreen();
    Renderer& renderer();
    Picture draw(const Frame& frame, int width, int height);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Throws Error.
void writePng(const Picture& picture, const std::string& file);

}  // namespace mw
