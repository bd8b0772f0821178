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
    remove = make(
        "Delete", "", "Del", "Delete the selected nodes", [&d] { edits::removeNodes(d, d.selection().nodes); }, true);
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
