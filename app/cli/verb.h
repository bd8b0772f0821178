// What a verb of the command line is. One verb a file; the explicit table of them is verbs.cpp.
#pragma once
#include <span>
#include <string_view>

#include "app/cli/arguments.h"

namespace mw::cli {

struct Verb {
    const char* name;
    const char* help;   ///< one line for the overview
    const char* usage;  ///< whole text of --help; its first line shows the arguments: "info FILE [--json]\n\n..."
    /// Takes what it knows from the arguments, then calls `finish()`, then works. Gives the exit status; throws UsageError (status 2),
    /// Error (status 1). Results go to standard output, everything else to standard error. Never touches Qt.
    int (*run)(Arguments&);
};

// One a file of the same name.
extern const Verb infoVerb, algorithmsVerb, processVerb, stepVerb, convertVerb, renderVerb, galleryVerb, lessonsVerb;
extern const Verb ikVerb, poseVerb, terrainVerb, editsVerb;

/// All verbs, in the order of the overview.
std::span<const Verb> verbs();
/// Null when there is none of that name.
const Verb* findVerb(std::string_view name);
/// Parses, runs, and turns whatever is thrown into a message and an exit status: 0 done, 1 could not, 2 wrong usage.
int runVerb(const Verb& verb, std::span<char* const> arguments);

}  // namespace mw::cli
