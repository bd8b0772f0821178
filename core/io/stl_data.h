// What an STL file says, before it becomes a scene. Between stl_text.cpp, stl_binary.cpp and stl_reader.cpp.
#pragma once
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/io/file.h"
#include "core/io/findings.h"
#include "core/io/placement.h"
#include "core/io/text.h"
#include "core/steps/progress.h"

namespace mw {

struct StlData {
    Filling<glm::vec3> corners;
    Filling<uint32_t> faceStart;  ///< empty: all are triangles
    Filling<int32_t> solid;       ///< of each facet; empty when no solid has a name
    std::vector<std::string> solidNames;
    Array<glm::vec3> colors;  ///< of facets; empty or one each
    Stated stated;            ///< by the header of a binary file
    Findings findings;
};

inline constexpr size_t stlHeader = 84, stlFacet = 50;

/// Throw Error, Cancelled.
void parseStlText(const FileBytes& bytes, const std::string& file, StlData& data, Progress* progress);
void parseStlBinary(const FileBytes& bytes, const std::string& file, StlData& data, Progress* progress);

}  // namespace mw
