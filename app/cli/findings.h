// What is wrong with a mesh, in words: worst first, each with what helps.
#pragma once
#include <string>
#include <vector>

#include "core/error.h"
#include "core/mesh/mesh.h"
#include "core/mesh/topology.h"

namespace mw::cli {

struct Finding {
    Warning warning;      ///< elements: a sample
    size_t total = 0;     ///< how many elements are concerned
    const char* element;  ///< "edge", "vertex", "face"
    std::string remedy;
};

std::vector<Finding> findings(const Mesh& mesh, const TopologyReport& report);

}  // namespace mw::cli
