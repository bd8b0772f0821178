// A framebuffer of any size in the present context, drawn into and read back.
#pragma once
#include <functional>
#include <memory>

#include "render/offscreen.h"

namespace mw {

class PictureTarget {
public:
    PictureTarget();
    ~PictureTarget();
    /// With the samples the frame asks for. Leaves another framebuffer bound. Throws Error when the driver cannot make one so large.
    Picture draw(Renderer& renderer, const Frame& frame, int width, int height);
    /// The same with anything that draws into a framebuffer.
    Picture draw(const std::function<void(unsigned framebuffer, glm::ivec2 size)>& into, int samples, int width, int height);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace mw
