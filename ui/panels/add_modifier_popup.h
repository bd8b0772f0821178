// The searchable list of modifiers, by category, with a line about each.
#pragma once
#include <QFrame>
#include <functional>

#include "core/catalog/catalog.h"

namespace mw {

/// Opens below `anchor`; `chosen` is called with the operation picked. `note` gives a word beside its title ("about 14 s"), or nothing.
QFrame* showAddModifierPopup(QWidget* anchor, std::function<void(const Operation&)> chosen, std::function<QString(const Operation&)> note = {});

}  // namespace mw
