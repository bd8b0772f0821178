#include "ui/repair_edits.h"

#include "core/scene/edit.h"
#include "ui/stack_edits.h"

namespace mw::edits {

void insertModifiers(Document& document, NodeId node, size_t level, std::vector<Modifier> modifiers)
{
    Scene next = document.scene();
    const std::string what = modifiers.size() == 1 ? titleOf(modifiers[0]).toStdString() : std::to_string(modifiers.size()) + " modifiers";
    std::vector<EditCall> calls;
    for (const Modifier& m : modifiers) {
        const std::string with = printed(operation(m.operation).parameters, m.values);
        calls.push_back({"modify", {{"node", nodeText(next, node)}, {"op", m.operation}, {"with", with}, {"at", int64_t(++level)}}});
        next = edited(next, calls.back());
    }
    const std::string name = document.scene().node(node).name + ": add " + what;
    document.commit(name, std::move(next), std::move(calls));
}

}  // namespace mw::edits
