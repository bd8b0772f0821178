// The files of resources/shaders as they were when the program was built (made by embed_shaders.cmake).
#pragma once
#include <span>

namespace mw {

struct ShaderSource {
    const char *name, *text;
};
std::span<const ShaderSource> shaderSources();

}  // namespace mw
