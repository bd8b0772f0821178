// Parameters as the printed references list them, of operations and of edits.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/catalog/parameters.h"

namespace mw::cli {

nlohmann::json parameterJson(const Parameter& p);
/// To standard output, one a line: name, default, range, help.
void printParameters(const std::vector<Parameter>& parameters);

}  // namespace mw::cli
