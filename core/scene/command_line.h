// The history as a command line: what a shell has to say to get the same scene.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/edit.h"

namespace mw {

/// One word of a POSIX shell: in single quotes when it has to be.
std::string shellQuoted(std::string_view word);

/// The edits between what the document was opened from and a history entry. Throws Error naming the entry that no command line can repeat.
std::vector<EditCall> callsUpTo(const Document& document, size_t position);

/// "meshwright process bunny.obj --do 'join:nodes=a+b' -o result.glb": the source and all edits up to an entry of the history. Modifiers added to
/// the only mesh there is are said shorter: --op decimate-quadric:faces=20000. Throws Error when that cannot be said.
std::string commandLine(const Document& document, size_t position);
/// The same with the edits of that entry alone.
std::string entryCommand(const Document& document, size_t position);
/// The same with one call that has not been made.
std::string callCommand(const Document& document, const EditCall& call);

/// All calls in turn. Throws Error that says which one did not go. `run` is told the sum; the selection after the last.
Scene replayed(Scene scene, std::span<const EditCall> calls, EditRun& run);

}  // namespace mw
