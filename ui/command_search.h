// Ctrl+K: one field that finds every action of the window by its words.
#pragma once
#include <QAction>
#include <QFrame>
#include <QList>

namespace mw {

/// Opens below `anchor` over the actions; Enter runs.
QFrame* showCommandSearch(QWidget* anchor, const QList<QAction*>& actions);

}  // namespace mw
