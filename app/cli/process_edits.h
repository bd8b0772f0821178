// process with --do: edits and operations on a whole scene, in the order in which they are given.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "core/io/io.h"

namespace mw::cli {

struct EditJob {
    std::string in, out;
    std::vector<std::pair<std::string, std::string>> steps;  ///< "--op" or "--do", and what it says
    bool project = false, ascii = false;
    ImportOptions import = {};
    Placement placement = {};
};
/// Gives the exit status. Throws Error naming the step that did not go.
int processEdits(const EditJob& job);

}  // namespace mw::cli
