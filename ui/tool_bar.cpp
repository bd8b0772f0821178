#include "ui/tool_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>

#include "ui/actions.h"
#include "ui/elided.h"
#include "ui/theme.h"
#include "ui/workspaces.h"

namespace mw {

MainToolBar::MainToolBar(Actions& actions, Workspaces& workspaces, QWidget* window) : QToolBar("Main", window), workspaces_(workspaces)
{
    setObjectName("mainToolBar");
    setMovable(false);
    toggleViewAction()->setVisible(false);
    setContextMenuPolicy(Qt::PreventContextMenu);
    setIconSize({16, 16});
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    tabs_ = new QWidget(this);
    line_ = new QHBoxLayout(tabs_);
    line_->setContentsMargins(0, 0, 0, 0);
    line_->setSpacing(0);
    addWidget(tabs_);
    fillTabs();
    connect(&workspaces_, &Workspaces::listChanged, this, &MainToolBar::fillTabs);
    addSeparator();
    addActions({actions.open, actions.save, actions.exportAs});
    addSeparator();
    addActions({actions.undo, actions.redo});
    for (QAction* a : {actions.undo, actions.redo})
        if (auto* b = qobject_cast<QToolButton*>(widgetForAction(a))) b->setToolButtonStyle(Qt::ToolButtonIconOnly);
    for (QAction* a : {actions.open, actions.save, actions.exportAs}) a->setIconText(a->text().remove("..."));
    for (auto* b : findChildren<QToolButton*>()) b->setFocusPolicy(Qt::TabFocus);
    auto* stretch = new QWidget(this);
    stretch->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(stretch);
    search_ = new ElidedButton(icon("search", tokens().text2), " Search commands and settings", this);
    search_->setObjectName("searchField");
    search_->setAccessibleName("Search commands and settings");
    search_->setToolTip("Find any command, lesson, parameter or node by its words · Ctrl+K");
    search_->setMaximumWidth(std::max(270, search_->sizeHint().width()));
    search_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    search_->setFocusPolicy(Qt::TabFocus);
    addWidget(search_);
    // Larger text: higher tabs, with the air of the style above and below them.
    const QMargins air = layout()->contentsMargins();
    setFixedHeight(std::max(40, tabs_->sizeHint().height() + air.top() + air.bottom()));
}

void MainToolBar::fillTabs()
{
    while (QLayoutItem* item = line_->takeAt(0)) {
        if (item->widget()) item->widget()->deleteLater();
        delete item;
    }
    for (const QString& name : workspaces_.all()) {
        auto* b = new QToolButton(tabs_);
        b->setObjectName("workspaceTab");
        b->setText(name);
        b->setCheckable(true);
        b->setChecked(workspaces_.current() == name);
        b->setAccessibleName(name + " workspace");
        b->setToolTip(name + " workspace: its own layout of panels over the same scene · Ctrl+PgUp, Ctrl+PgDown");
        b->setFocusPolicy(Qt::TabFocus);
        connect(b, &QToolButton::clicked, this, [this, b, name] {
            workspaces_.change(name);
            b->setChecked(true);
        });
        connect(&workspaces_, &Workspaces::changed, b, [this, b, name] { b->setChecked(workspaces_.current() == name); });
        if (!Workspaces::names().contains(name)) {
            b->setContextMenuPolicy(Qt::ActionsContextMenu);
            auto* remove = new QAction("Remove workspace " + name, b);
            connect(remove, &QAction::triggered, this, [this, name] { workspaces_.remove(name); });
            b->addAction(remove);
        }
        line_->addWidget(b);
    }
    auto* plus = new QToolButton(tabs_);
    plus->setIcon(icon("plus", tokens().text2));
    plus->setAccessibleName("Save layout as a workspace");
    plus->setToolTip("Save the layout of panels as a workspace of your own");
    plus->setFocusPolicy(Qt::TabFocus);
    connect(plus, &QToolButton::clicked, this, &MainToolBar::askForName);
    line_->addWidget(plus);
    plus_ = plus;
}

void MainToolBar::askForName()
{
    auto* popup = new QFrame(window(), Qt::Popup);
    popup->setObjectName("popup");
    popup->setAttribute(Qt::WA_DeleteOnClose);
    auto* box = new QVBoxLayout(popup);
    auto* line = new QHBoxLayout;
    auto* field = new QLineEdit(popup);
    field->setPlaceholderText("Name of the workspace");
    field->setAccessibleName("Name of the workspace");
    field->setToolTip("A name for the tab, such as Inspect");
    field->setMinimumWidth(200);
    auto* save = new QPushButton("Save layout", popup);
    save->setToolTip("Keep the layout of panels under this name · Enter");
    save->setFocusPolicy(Qt::TabFocus);
    auto* trouble = new QLabel(popup);
    trouble->setProperty("bad", true);
    trouble->hide();
    line->addWidget(field);
    line->addWidget(save);
    box->addLayout(line);
    box->addWidget(trouble);
    const auto run = [this, popup, field, trouble] {
        QString whyNot;
        if (workspaces_.saveAs(field->text(), &whyNot)) return void(popup->close());
        trouble->setText(whyNot);
        trouble->show();
        popup->adjustSize();
    };
    connect(field, &QLineEdit::returnPressed, popup, run);
    connect(save, &QPushButton::clicked, popup, run);
    popup->adjustSize();
    popup->move(plus_->mapToGlobal(QPoint(0, plus_->height() + 2)));
    popup->show();
    field->setFocus();
}

}  // namespace mw
