// The defects of a mesh in words, each with the command that mends it.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/repair/defects.h"

namespace mw::cli {

/// Every check: id, count of offenders, and the operation that mends it as --op takes it (null when none does).
nlohmann::json defectsJson(const std::vector<Defect>& defects);
/// Those found, worst first. False when there are none.
bool printWorklist(const Mesh& mesh, const std::vector<Defect>& defects);
/// "repair", "repair:weld=true", ...: what mends all of it, each once, in an order in which none undoes another.
std::vector<std::string> repairCalls(const std::vector<Defect>& defects);

}  // namespace mw::cli
