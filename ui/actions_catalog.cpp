// One action for each operation of the catalog: sources, modifiers, what can be stepped.
#include "ui/actions.h"
#include "ui/edit_commands.h"
#include "ui/stack_edits.h"
#include "ui/steps/step_player.h"
#include "ui/steps/step_subject.h"

namespace mw {

void Actions::makeCatalog()
{
    for (const Operation& op : catalog()) {
        const QString title = QString::fromStdString(op.title), summary = QString::fromStdString(op.summary);
        if (op.accepts == Kind::Mesh && op.yields == Kind::Mesh) {
            auto* a = make(title, "", "", summary, [this, &op] {
                if (const MeshId m = edits::activeMesh(s_.document)) edits::addModifier(s_.document, m, op);
            });
            edits::setCall(a, [this, &op]() -> EditCall {
                return {"modify", {{"node", nodeText(s_.document.scene(), s_.document.selection().active())}, {"op", op.id}}};
            });
            a->setData(QString::fromStdString(op.category));
            a->setProperty("command", "meshwright process FILE --op " + QString::fromStdString(op.id) + " -o OUT.glb");
            addModifiers << a;
        }
        if (op.accepts == Kind::Nothing && op.yields == Kind::Mesh) {
            auto* a = make(title, "mesh", "", summary, [this, &op] {
                edits::run(s_, {"add", {{"op", op.id}}}, [this](const EditRun&) { s_.view.frameNodes({}); });
            });
            edits::setCall(a, [&op]() -> EditCall { return {"add", {{"op", op.id}}}; });
            addSources << a;
        }
        if (op.steps) {
            auto* a = make("Step through: " + title, "step", "", summary, [this, &op] { stepThrough(s_, op); });
            a->setData(QString::fromStdString(op.id));
            stepThroughs << a;
        }
    }
}

}  // namespace mw
