// Pictures without a display: a surfaceless EGL context and a framebuffer read back. Never in a process that has Qt's OpenGL.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
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
    /// Throws Error naming what is missing (driver, version). With `debug`, the driver's complaints are collected.
    explicit Offscreen(bool debug = false);
    ~Offscreen();
    Renderer& renderer();
    const std::vector<std::string>& messages() const;  ///< errors and undefined behaviour the driver has reported
    Picture draw(const Frame& frame, int width, int height);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Throws Error.
void writePng(const Picture& picture, const std::string& file);

}  // namespace mw
