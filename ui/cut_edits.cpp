#include "ui/cut_edits.h"

#include <algorithm>

#include "ui/repair_edits.h"

namespace mw::edits {

size_t levelInView(const Session& session, MeshId mesh)
{
    const size_t all = session.document.scene().find(mesh)->stack.size();
    const auto level = session.view.shownLevel.find(mesh);
    return level == session.view.shownLevel.end() ? all : std::min(all, level->second);
}

void addCut(Session& session, NodeId node, const ParameterValues& values)
{
    const MeshId mesh = session.document.scene().node(node).mesh;
    const size_t level = levelInView(session, mesh);
    session.document.select({session.document.selection().nodes, {}, {}});
    insertModifiers(session.document, node, level, {Modifier{{}, "cut", values}});
    session.view.shownLevel.erase(mesh);
    session.view.touch();
}

}  // namespace mw::edits
