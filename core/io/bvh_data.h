// What a BVH file says, before it becomes a scene. Between bvh_parser.cpp and bvh.cpp; the writer knows the channels' names from here, too.
#pragma once
#include <string_view>

#include "core/character/clip.h"
#include "core/error.h"
#include "core/io/file.h"
#include "core/mesh/mesh.h"
#include "core/steps/progress.h"

namespace mw {

struct BvhData {
    struct Joint {
        std::string name;
        uint32_t parent = none;  ///< always before its children
        bool end = false;
        glm::dvec3 offset{0};
        std::vector<Channel::Path> channels;
    };
    std::vector<Joint> joints;
    size_t channels = 0;   ///< of all joints
    Array<double> values;  ///< rows times channels, a row a frame; finite
    size_t rows = 0;
    double frameTime = 0;  ///< seconds, positive when there are rows
    std::vector<Warning> warnings;
};

/// Throws Error, Cancelled. `bytes` is UTF-8 with '\n' as line end.
BvhData parseBvh(const FileBytes& bytes, const std::string& file, Progress* progress);

/// In the order of Channel::Path, from PositionX on.
inline constexpr std::string_view bvhChannelNames[] = {"Xposition", "Yposition", "Zposition", "Xrotation", "Yrotation", "Zrotation"};
inline constexpr double defaultFrameTime = 1.0 / 30;  ///< seconds

}  // namespace mw
