// The line below the menus: workspaces, files, undo, search. It cannot be moved or hidden.
#pragma once
#include <QToolBar>

class QHBoxLayout;
class QPushButton;
class QActionGroup;

namespace mw {

class Workspaces;
struct Actions;

class MainToolBar : public QToolBar {
    Q_OBJECT

public:
    MainToolBar(Actions& actions, Workspaces& workspaces, QWidget* window);
    QPushButton* searchField() const { return search_; }
    /// A small popup asks for the name of a new workspace.
    void askForName();

private:
    void fillTabs();
    Workspaces& workspaces_;
    QWidget* tabs_;
    QHBoxLayout* line_;
    QWidget* plus_ = nullptr;
    QPushButton* search_;
};

}  // namespace mw
