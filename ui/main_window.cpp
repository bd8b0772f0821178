#include "ui/main_window.h"

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDropEvent>
#include <QGridLayout>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QToolBar>
#include <QToolButton>

#include "ui/actions.h"
#include "ui/banner.h"
#include "ui/command_search.h"
#include "ui/evaluation_service.h"
#include "ui/file_commands.h"
#include "ui/panels/timeline.h"
#include "ui/playback.h"
#include "core/scene/samples.h"
#include "ui/status_strip.h"
#include "ui/steps/transport_strip.h"
#include "ui/theme.h"
#include "ui/view_header.h"
#include "ui/viewport/viewport.h"
#include "ui/welcome.h"
#include "ui/workspaces.h"

namespace mw {

MainWindow::MainWindow()
    : jobs_(std::make_unique<Jobs>()),
      view_(std::make_unique<ViewState>()),
      steps_(std::make_unique<StepSession>(document_, *jobs_)),
      evaluations_(std::make_unique<EvaluationService>(document_, *jobs_)),
      playback_(std::make_unique<Playback>(document_, *view_)),
      session_{document_, *jobs_, *view_, *steps_, evaluations_.get(), playback_.get()}
{
    setObjectName("mainWindow");
    setMinimumSize(1100, 700);
    resize(1600, 1000);
    setAcceptDrops(true);
    view_->options.theme = currentTheme();
    files_ = new FileCommands(session_, this);
    makeCentre();
    makeMenus();
    makeToolBar();
    status_ = new StatusStrip(session_, this);
    setStatusBar(status_);
    listen();
    refreshTitle();
}

MainWindow::~MainWindow()
{
    steps_->close();
    delete takeCentralWidget();  // panels and view go before the services they listen to
    for (QObject* child : QObjectList(children()))
        if (qobject_cast<QDockWidget*>(child)) delete child;
    jobs_.reset();
}

void MainWindow::makeCentre()
{
    centre_ = new QWidget(this);
    centre_->setObjectName("centralWidget");
    centre_->setAttribute(Qt::WA_StyledBackground);
    viewport_ = new Viewport(session_, centre_);
    banner_ = new Banner(centre_);
    actions_ = std::make_unique<Actions>(session_, *files_, *viewport_, this, centre_);
    viewport_->setContextMenu(actions_->contextMenu(this));
    header_ = makeViewHeader(session_, *viewport_, *actions_, centre_);
    makeLevelHud(session_, viewport_);
    makeGroundHud(session_, *viewport_);
    auto* grid = new QGridLayout(centre_);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(1);
    grid->addWidget(header_, 0, 0, 1, 2);
    grid->addWidget(banner_, 1, 0, 1, 2);
    grid->addWidget(makeToolStrip(*actions_, centre_), 2, 0);
    grid->addWidget(viewport_, 2, 1);
    grid->setRowStretch(2, 1);
    grid->setColumnStretch(1, 1);
    QWidget* strip = makeTransportStrip(session_, centre_);
    grid->addWidget(strip, 3, 0, 1, 2);
    installTransportShortcuts(session_.steps, viewport_);
    installPlaybackShortcuts(session_, viewport_);
    setCentralWidget(centre_);
}

void MainWindow::makeMenus()
{
    QMenu *windowMenu = nullptr, *help = nullptr;
    actions_->fill(menuBar(), &windowMenu, &help);
    workspaces_ = new Workspaces(session_, this);
    workspaces_->fillMenu(windowMenu);
    windowMenu->addSeparator();
    windowMenu->addAction("Hide or show all docks", QKeySequence("Ctrl+\\"), workspaces_, &Workspaces::toggleAll);
    windowMenu->addAction("Reset layout", workspaces_, &Workspaces::reset);
    windowMenu->addAction("Full screen", QKeySequence("F11"), this, [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
    help->addAction(icon("help"), "Welcome", this, [this] {
        if (!welcome_) return showWelcome();
        welcome_->show();
        welcome_->raise();
    });
    help->addAction("About Meshwright", this, [this] {
        QMessageBox::about(this, "About Meshwright",
                           "<b>Meshwright</b> edits meshes, and shows how its algorithms work, step by step.<br><br>"
                           "Free software under the GNU General Public License, version 3 or later.");
    });
    auto* search = new QAction("Search commands", this);
    search->setShortcut(QKeySequence("Ctrl+K"));
    connect(search, &QAction::triggered, this, &MainWindow::searchCommands);
    addAction(search);
}

void MainWindow::makeToolBar()
{
    auto* bar = addToolBar("Main");
    bar->setObjectName("mainToolBar");
    bar->setMovable(false);
    bar->toggleViewAction()->setVisible(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    bar->setFixedHeight(40);
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto* group = new QActionGroup(this);
    int n = 0;
    for (const QString& name : Workspaces::names()) {
        auto* a = new QAction(name, this);
        a->setCheckable(true);
        a->setToolTip(QString("%1 workspace: its own layout of docks over the same scene").arg(name));
        group->addAction(a);
        auto* b = new QToolButton(bar);
        b->setDefaultAction(a);
        b->setObjectName("workspaceTab");
        b->setFocusPolicy(Qt::TabFocus);
        bar->addWidget(b);
        connect(a, &QAction::triggered, this, [this, name] { workspaces_->change(name); });
        connect(workspaces_, &Workspaces::changed, a, [this, a, name] { a->setChecked(workspaces_->current() == name); });
        ++n;
    }
    bar->addSeparator();
    bar->addActions({actions_->open, actions_->save, actions_->exportAs});
    bar->addSeparator();
    bar->addActions({actions_->undo, actions_->redo});
    for (QAction* a : {actions_->undo, actions_->redo})
        if (auto* b = qobject_cast<QToolButton*>(bar->widgetForAction(a))) b->setToolButtonStyle(Qt::ToolButtonIconOnly);
    for (QAction* a : {actions_->open, actions_->save, actions_->exportAs}) a->setIconText(a->text().remove("..."));
    for (auto* b : bar->findChildren<QToolButton*>()) b->setFocusPolicy(Qt::TabFocus);
    auto* stretch = new QWidget(bar);
    stretch->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(stretch);
    auto* search = new QPushButton(icon("search", tokens().text2), " Search commands        Ctrl+K", bar);
    search->setObjectName("searchField");
    search->setFixedWidth(270);
    search->setFocusPolicy(Qt::TabFocus);
    connect(search, &QPushButton::clicked, this, &MainWindow::searchCommands);
    bar->addWidget(search);
    search_ = search;
    for (const auto& [key, by] : {std::pair{"Ctrl+PgDown", 1}, {"Ctrl+PgUp", n - 1}}) {
        auto* a = new QAction(this);
        a->setShortcut(QKeySequence(key));
        connect(a, &QAction::triggered, this, [this, n, by = by] {
            workspaces_->change(Workspaces::names().at((int(Workspaces::names().indexOf(workspaces_->current())) + by) % n));
        });
        addAction(a);
    }
}

void MainWindow::listen()
{
    subscription_ = document_.subscribe([this](const Change&) {
        actions_->refresh();
        refreshTitle();
    });
    connect(view_.get(), &ViewState::changed, this, [this] { actions_->refresh(); });
    connect(workspaces_, &Workspaces::changed, this, [this] {
        const bool terrain = workspaces_->current() == "Terrain";
        centre_->findChild<QWidget*>("toolStrip")->setHidden(terrain);
        view_->brushInHand = terrain;
        view_->touchBrush();
    });
    connect(viewport_, &Viewport::hint, status_, &StatusStrip::setHint);
    connect(viewport_, &Viewport::failed, banner_, &Banner::trouble);
    connect(status_, &StatusStrip::jobsClicked, this, [this] { workspaces_->show("jobs"); });
    connect(files_, &FileCommands::trouble, banner_, &Banner::trouble);
    connect(files_, &FileCommands::notice, this,
            [this](const QString& text, const std::vector<Warning>& warnings) { banner_->notice(text, warnings); });
    connect(files_, &FileCommands::opened, this, [this] { viewport_->frameAll(false); });
    connect(files_, &FileCommands::added, this, [this] { viewport_->frameAll(); });
    connect(steps_.get(), &StepSession::opened, this, [this] { workspaces_->change("Learn"); });
    connect(steps_.get(), &StepSession::opened, playback_.get(), &Playback::pause);
    connect(workspaces_, &Workspaces::changed, this, [this] {
        const bool character = workspaces_->current() == "Character";
        view_->showBones = character;
        view_->showMeshes = true;
        for (const auto& [name, shown] : {std::pair{"colourByGroup", !character && workspaces_->current() != "Terrain"}, {"showGroup", character}})
            if (auto* group = header_->findChild<QWidget*>(name)) group->setVisible(shown);
        view_->touch();
    });
    status_->setHint("Click picks · Drag orbits · Shift+drag boxes · Right-drag pans · F frames");
}

void MainWindow::refreshTitle()
{
    setWindowTitle(files_->title() + "[*] - Meshwright");
    setWindowModified(document_.modified());
}

void MainWindow::searchCommands()
{
    QList<QAction*> all;
    const auto collect = [&](auto&& self, QMenu* menu) -> void {
        for (QAction* a : menu->actions())
            if (a->menu())
                self(self, a->menu());
            else if (!a->isSeparator())
                all << a;
    };
    for (QAction* a : menuBar()->actions()) collect(collect, a->menu());
    showCommandSearch(search_, all);
}

void MainWindow::showWelcome()
{
    if (document_.scene().nodes().empty()) files_->openScene(samples().front().make(), "Welcome scene");
    if (!welcome_) welcome_ = new WelcomeCard(session_, *files_, viewport_);
    welcome_->show();
}

void MainWindow::showEvent(QShowEvent* e)
{
    QMainWindow::showEvent(e);
    if (workspaces_->current().isEmpty()) workspaces_->change("Mesh");
    viewport_->frameAll(false);
    viewport_->setFocus();
}

void MainWindow::closeEvent(QCloseEvent* e)
{
    if (!closing_ && document_.modified()) {
        e->ignore();
        files_->whenSaved([this] {
            closing_ = true;
            close();
        });
        return;
    }
    workspaces_->store();
    e->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* e)
{
    if (!e->mimeData()->hasUrls()) return;
    status_->say(e->position().y() < header_->mapTo(this, QPoint(0, 0)).y() ? "Drop here to open" : "Drop here to add to the scene");
    e->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* e)
{
    QStringList names;
    for (const QUrl& url : e->mimeData()->urls())
        if (url.isLocalFile()) names << url.toLocalFile();
    if (names.isEmpty()) return;
    if (welcome_) welcome_->hide();
    const bool onBar = e->position().y() < header_->mapTo(this, QPoint(0, 0)).y();
    if (onBar || document_.scene().nodes().empty())
        files_->whenSaved([this, file = names.front()] { files_->open(file); });
    else
        files_->import(names);
    e->acceptProposedAction();
}

}  // namespace mw
