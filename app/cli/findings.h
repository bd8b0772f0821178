// What is odd about a mesh, as warnings for scripts, worst first; the worklist (worklist.h) says it to people.
#pragma once
#include <string>
#include <vector>

#include "core/error.h"
#include "core/mesh/mesh.h"
#include "core/mesh/topology.h"

namespace mw::cli {

/// The text says of which kind the elements are; they are a sample.
std::vector<Warning> findings(const Mesh& mesh, const TopologyReport& report);

}  // namespace mw::cli
