// One action for each operation of the catalog: sources, modifiers, what can be stepped.
#include "core/io/io.h"
#include "ui/actions.h"
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
            a->setData(QString::fromStdString(op.category));
            a->setProperty("command", "meshwright process FILE --op " + QString::fromStdString(op.id) + " -o OUT.glb");
            addModifiers << a;
        }
        if (op.accepts == Kind::Nothing && op.yields == Kind::Mesh)
            addSources << make(title, "mesh", "", summary, [this, &op] {
                s_.jobs.start("Make " + QString::fromStdString(op.title), [this, &op](Progress& p) -> std::function<void()> {
                    Mesh mesh = std::get<Mesh>(apply(op, {}, {}, &p));
                    return [this, &op, mesh] {
                        Scene next = s_.document.scene();
                        const auto roots = next.merge(sceneOf(mesh, op.title));
                        s_.document.commit("Add " + op.title, std::move(next), {roots, {}, {}});
                        s_.view.frameNodes({});
                    };
                });
            });
        if (op.steps) {
            auto* a = make("Step through: " + title, "step", "", summary, [this, &op] { stepThrough(s_, op); });
            a->setData(QString::fromStdString(op.id));
            stepThroughs << a;
        }
    }
}

}  // namespace mw
