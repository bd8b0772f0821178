// Tables and selections as .csv or .json.
#pragma once
#include <string>
#include <vector>

#include "core/catalog/catalog.h"

namespace mw::cli {

struct NamedResult {
    std::string mesh;  ///< name of the mesh object it is about
    Value value;       ///< Table or ElementSet
};

/// By ending. CSV: a header and one row an element, with a first column "mesh" when there are several; NaN is an empty field.
/// JSON: everything, lists and summary included. All or nothing. Throws Error.
void writeTableFile(const std::string& file, const std::string& operation, const std::vector<NamedResult>& results);

}  // namespace mw::cli
