// A panel is a widget made from a Session; the window keeps a list of them and knows no panel's inside.
#pragma once
#include <QString>
#include <QWidget>
#include <functional>
#include <vector>

#include "ui/session.h"

namespace mw {

struct PanelEntry {
    QString id, title, tip;                                   ///< "outliner", "Outliner", one line
    std::function<QWidget*(Session&, QWidget* parent)> make;  ///< called when the dock is first shown
};

/// Every panel, one line each (ui/panels.cpp).
const std::vector<PanelEntry>& panels();

}  // namespace mw
