// Undo, names, what is deleted.
#include <QInputDialog>

#include "ui/actions.h"
#include "ui/stack_edits.h"

namespace mw {

void Actions::makeEdit()
{
    Document& d = s_.document;
    undo = make("Undo", "undo", "Ctrl+Z", "", [&d] { d.undo(); });
    redo = make("Redo", "redo", "Ctrl+Shift+Z; Ctrl+Y", "", [&d] { d.redo(); });
    const auto ofSelection = [this](const char* text, const char* iconName, const char* key, const char* tip, edits::SelectionEdit edit,
                                    bool linked = false) {
        auto* a = make(
            text, iconName, key, tip, [this, edit, linked] { edits::run(s_, edit, linked); }, true);
        edits::setCall(a, [this, edit, linked] { return edits::callOf(s_.document, edit, linked); });
        ofSelection_.push_back({a, edit, a->toolTip()});
        return a;
    };
    using enum edits::SelectionEdit;
    remove = ofSelection("Delete", "", "Del", "Delete the selected elements, or else the selected nodes", Delete);
    duplicate = ofSelection("Duplicate", "copy", "Shift+D", "Copy the selected nodes with what is below them", Duplicate);
    duplicateLinked = ofSelection("Duplicate linked", "", "Alt+D", "Copy the selected nodes; the copies show the same meshes", Duplicate, true);
    join = ofSelection("Join", "", "Ctrl+J", "Make the selected meshes one, in the space of the active one", Join);
    separateFaces = ofSelection("Separate selection", "", "P", "Put the selected faces into a node of their own", SeparateFaces);
    separateParts = ofSelection("Separate by components", "", "", "Put each connected part into a node of its own", SeparateParts);
    separateMaterials = ofSelection("Separate by material", "", "", "Put the faces of each material into a node of their own", SeparateMaterials);
    groupNodes = ofSelection("Group", "", "Ctrl+G", "Put the selected nodes below a new one", Group);
    ownCopy = ofSelection("Make own copy", "", "", "Give the selected nodes meshes of their own", OwnCopy);
    copyHistory = make("Copy history as command line", "copy", "", "What a shell has to say to get the present scene",
                       [this] { edits::copyCommand(s_, s_.document.historyPosition(), edits::Copied::AllUpTo); });
    rename = make(
        "Rename...", "", "F2", "Rename the active node",
        [this, &d] {
            const Node* n = d.scene().find(d.selection().active());
            if (!n) return;
            bool ok = false;
            const QString name = QInputDialog::getText(window_, "Rename", "Name", QLineEdit::Normal, QString::fromStdString(n->name), &ok);
            if (ok) edits::rename(d, d.selection().active(), name);
        },
        true);
}

}  // namespace mw
