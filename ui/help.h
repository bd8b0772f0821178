// Help where one is: F1 explains what is under the cursor or has the focus; the keyboard reference is made from the commands themselves.
#pragma once
#include <QWidget>

#include "ui/shortcuts.h"

namespace mw {

/// A card near `at` (global) that Esc or a click elsewhere closes.
QWidget* showHelp(QWidget* window, const QString& title, const QString& html, QPoint at);
/// On the widget under the cursor; on the one with the focus when the cursor is elsewhere.
QWidget* showHelpOnWidget(QWidget* window);
/// Every command that has keys, by menu, and what the mouse does in the view.
void showKeyboardReference(const Shortcuts& shortcuts, QWidget* over);

}  // namespace mw
