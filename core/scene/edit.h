// Edits: everything that changes a scene, described once. The window's actions, the history as a command line and `process --do` run the
// same list; an edit that is not in it cannot be repeated from a shell.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/scene/document.h"

namespace mw {

/// What an edit may use while it runs, and what it tells.
struct EditRun {
    Progress* progress = nullptr;
    Evaluator* evaluator = nullptr;  ///< may know results of the stacks already; null: they are computed
    std::vector<NodeId> made = {};   ///< told: to be selected afterwards; empty: the selection stays
    std::vector<ClipId> clips = {};  ///< told: motions that came
    std::vector<Warning> warnings = {};
};

struct Edit {
    std::string id, title, summary;  ///< "rename", "Rename", one line
    std::vector<Parameter> parameters = {};
    /// `values` have been checked(). Throws Error (the scene is then dropped), Cancelled.
    std::function<void(Scene&, const ParameterValues&, EditRun&)> apply = {};
    /// Of the history entry, object first: "bunny: hide". Of the scene before the edit.
    std::function<std::string(const Scene&, const ParameterValues&)> name = {};
    bool heavy = false;  ///< may take long: the window runs it as a job
};

/// All edits, in the order of the printed reference.
std::span<const Edit> editList();
const Edit* findEdit(std::string_view id);
const Edit& editOf(std::string_view id);  ///< throws Error that lists what there is

/// The scene after one edit. Throws Error, Cancelled.
Scene edited(const Scene& scene, const EditCall& call, EditRun& run);
Scene edited(const Scene& scene, const EditCall& call);
/// Runs and commits one edit: one history entry that knows its command line. Nothing when the scene would stay as it is.
void commitEdit(Document& document, const EditCall& call);
/// Commits an edit that was run elsewhere, on `before`, which must be the present entry's scene still; false when it is not.
bool commitEdited(Document& document, const EditCall& call, const Scene& before, Scene next, const EditRun& run);
/// Several edits, one after the other, as one history entry. None of them when one throws.
void commitEdits(Document& document, std::string name, const std::vector<EditCall>& calls);
/// What the history entry of an edit is called.
std::string editName(const Scene& before, const EditCall& call);

/// "transform:node=bunny,position=0/1/0", and back. Throws Error.
std::string commandText(const EditCall& call);
EditCall parsedEdit(std::string_view text);

/// Nodes as a parameter has them: names joined by '+', or #7 where a name is not unique or not plain. Ids are the same again when the same
/// edits are repeated on the same file.
std::string nodeText(const Scene& scene, const std::vector<NodeId>& nodes);
inline std::string nodeText(const Scene& scene, NodeId node)
{
    return nodeText(scene, std::vector<NodeId>{node});
}
std::vector<NodeId> nodesOf(const Scene& scene, std::string_view text);  ///< throws Error naming what is not there
NodeId nodeOf(const Scene& scene, std::string_view text);                ///< exactly one

}  // namespace mw
