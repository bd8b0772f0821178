// What the command search finds: the commands of the menus, and with them lessons, parameters of the selected stack, nodes and workspaces.
#pragma once
#include "ui/command_search.h"
#include "ui/session.h"
#include "ui/shortcuts.h"

namespace mw {

class Workspaces;

std::vector<Findable> findables(Session& session, const Shortcuts& shortcuts, Workspaces& workspaces);

}  // namespace mw
