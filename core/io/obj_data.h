// What the lines of an OBJ file say, before it becomes a scene. Between obj_parser.cpp and obj_reader.cpp.
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "core/io/file.h"
#include "core/io/findings.h"
#include "core/io/placement.h"
#include "core/io/text.h"
#include "core/steps/progress.h"

namespace mw {

/// From face `face` on, until the next run, faces are of this name.
struct ObjRun {
    uint32_t face, name;
};

struct ObjData {
    static constexpr uint32_t wrongIndex = none - 1;  ///< an index was given, but it cannot be right

    Filling<glm::vec3> positions, normals;
    Filling<glm::vec2> texcoords;
    Filling<glm::vec4> colors;  ///< empty or one a vertex
    bool alpha = false;
    Filling<uint32_t> faceStart, cornerVertex;
    Filling<uint32_t> cornerTexcoord, cornerNormal;  ///< empty or one a corner; `none` where the face has none
    Filling<uint32_t> lines;
    std::vector<ObjRun> groupRuns, materialRuns;
    std::vector<std::string> groupNames, materialNames, libraries;

    /// Faces that name a vertex which had not come yet when they did: it may come later. The first thousand.
    struct Early {
        uint32_t face;
        uint64_t line;
        int64_t index;
    };
    std::vector<Early> early;
    uint64_t firstFaceLine = 0;
    Stated stated;
    Findings findings;
};

/// Throws Error only for what cannot be numbered with 32 bits; Cancelled.
void parseObj(const FileBytes& bytes, const std::string& file, ObjData& data, Progress* progress);

}  // namespace mw
