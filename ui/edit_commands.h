// How the window runs edits of the list: quick ones at once, heavy ones as jobs. Every change of the scene goes this way.
#pragma once
#include <QAction>
#include <QString>
#include <functional>

#include "core/scene/edit.h"
#include "ui/session.h"

namespace mw::edits {

/// `then` is called in the window's thread after the commit, `failed` with the reason when there is none; without
/// it session.trouble says it. A heavy
/// edit works on the scene as it was; when that has changed meanwhile, it is run again on what there is now, at most three times.
void run(Session& session, const EditCall& call, std::function<void(const EditRun&)> then = {}, std::function<void(const QString& text)> failed = {});
/// A quick edit where there is no session at hand; false, and nothing done, when it cannot be.
bool runQuick(Document& document, const EditCall& call);

/// Why an edit of the selection cannot be made now; empty when it can. For tooltips of actions that are off.
enum class SelectionEdit { Duplicate, Join, SeparateFaces, SeparateParts, SeparateMaterials, Delete, Group, OwnCopy };
QString whyNot(const Document& document, SelectionEdit edit);
void run(Session& session, SelectionEdit edit, bool linked = false);

/// What that would be as a call.
EditCall callOf(const Document& document, SelectionEdit edit, bool linked = false);

/// Which edit an action makes, so that its command line can be copied (Ctrl+Enter in the command search).
void setCall(QAction* action, std::function<EditCall()> call);
/// Empty when the action is no edit, or is off.
QString commandOf(const Session& session, const QAction* action);
/// The command line of a history entry alone, or of all up to it, to the clipboard. What cannot be said is told.
enum class Copied { Entry, AllUpTo };
void copyCommand(Session& session, size_t position, Copied what);
/// Of one modifier as it stands.
void copyModifier(Session& session, MeshId mesh, size_t index);

}  // namespace mw::edits
