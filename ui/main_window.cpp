#include "ui/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QGridLayout>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <algorithm>

#include "core/scene/samples.h"
#include "ui/actions.h"
#include "ui/banner.h"
#include "ui/command_search.h"
#include "ui/drop_target.h"
#include "ui/evaluation_service.h"
#include "ui/export_sheet.h"
#include "ui/file_commands.h"
#include "ui/findables.h"
#include "ui/help.h"
#include "ui/panels/timeline.h"
#include "ui/placement_words.h"
#include "ui/playback.h"
#include "ui/shortcuts_sheet.h"
#include "ui/status_strip.h"
#include "ui/steps/transport_strip.h"
#include "ui/terrain_edits.h"
#include "ui/theme.h"
#include "ui/thumbnails.h"
#include "ui/tool_bar.h"
#include "ui/view_area.h"
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
    view_->options.theme = currentTheme();
    files_ = new FileCommands(session_, this);
    makeCentre();
    makeMenus();
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
    views_ = new ViewArea(session_, centre_);
    viewport_ = &views_->first();
    banner_ = new Banner(centre_);
    actions_ = std::make_unique<Actions>(session_, *files_, *views_, this, centre_);
    views_->setContextMenu(actions_->contextMenu(this));
    header_ = makeViewHeader(session_, *views_, *actions_, centre_);
    views_->setFurnisher([this](Viewport& v, QWidget* parent) { return makePaneHeader(session_, *views_, v, *actions_, parent); },
                         [this](Viewport& v) { makeHuds(session_, v); });
    auto* grid = new QGridLayout(centre_);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(1);
    grid->addWidget(header_, 0, 0, 1, 2);
    grid->addWidget(banner_, 1, 0, 1, 2);
    grid->addWidget(makeToolStrip(*actions_, centre_), 2, 0);
    grid->addWidget(views_, 2, 1);
    grid->setRowStretch(2, 1);
    grid->setColumnStretch(1, 1);
    QWidget* strip = makeTransportStrip(session_, centre_);
    grid->addWidget(strip, 3, 0, 1, 2);
    installTransportShortcuts(session_.steps, views_);
    installPlaybackShortcuts(session_, views_);
    setCentralWidget(centre_);
}

void MainWindow::makeMenus()
{
    QMenu *windowMenu = nullptr, *help = nullptr;
    actions_->fill(menuBar(), &windowMenu, &help);
    workspaces_ = new Workspaces(session_, this);
    fillWindowMenu(windowMenu);
    fillHelpMenu(help);
    for (QAction* menu : menuBar()->actions())
        if (menu->text() == "Edit") {
            menu->menu()->addSeparator();
            menu->menu()->addAction(actions_->make("Shortcuts...", "", "", "See and change the keys of every command",
                                                   [this] { (new ShortcutsSheet(*shortcuts_, centre_))->open(); }));
        }
    bar_ = new MainToolBar(*actions_, *workspaces_, this);
    addToolBar(bar_);
    connect(bar_->searchField(), &QPushButton::clicked, this, &MainWindow::searchCommands);
    auto* drops = new DropTarget(*files_, *banner_, this, bar_, centre_);
    connect(drops, &DropTarget::dropped, this, [this] {
        if (welcome_) welcome_->hide();
    });
    connect(drops, &DropTarget::heightMapWanted, this, [this](const QString& file) {
        edits::importPicture(session_, file, true, [this](const QString& why) {
            if (!why.isEmpty()) banner_->trouble(why);
        });
    });
    shortcuts_ = new Shortcuts(menuBar(), this);
    actions_->themeChanged = [this] { workspaces_->remakePanels(); };
}

void MainWindow::fillWindowMenu(QMenu* menu)
{
    workspaces_->fillMenu(menu);
    menu->addSeparator();
    Actions& a = *actions_;
    auto* spaces = menu->addMenu("Workspaces");
    for (const QString& name : Workspaces::names())
        spaces->addAction(
            a.make(name + " workspace", "", "", "Its own layout of panels over the same scene", [this, name] { workspaces_->change(name); }));
    spaces->addSeparator();
    spaces->addAction(a.make("Next workspace", "", "Ctrl+PgDown", "", [this] { stepWorkspace(1); }));
    spaces->addAction(a.make("Last workspace", "", "Ctrl+PgUp", "", [this] { stepWorkspace(-1); }));
    spaces->addAction(
        a.make("Save layout as workspace...", "plus", "", "Keep the layout of panels under a name of its own", [this] { bar_->askForName(); }));
    menu->addAction(a.make("Next panel", "", "F6", "The focus to the next panel, in reading order", [this] { focusPanel(1); }));
    menu->addAction(a.make("Last panel", "", "Shift+F6", "The focus to the panel before", [this] { focusPanel(-1); }));
    menu->addAction(a.make("Reset layout", "", "", "Panels where they were at first", [this] { workspaces_->reset(); }));
    menu->addSeparator();
    menu->addAction(a.make("Hide or show all panels", "", "Ctrl+\\", "The view alone, and back", [this] { workspaces_->toggleAll(); }));
    menu->addAction(a.make("Full screen", "", "F11", "The window over the whole screen, and back",
                           [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); }));
}

void MainWindow::fillHelpMenu(QMenu* menu)
{
    Actions& a = *actions_;
    menu->addAction(a.make("Search commands and settings", "search", "Ctrl+K", "Find anything by its words", [this] { searchCommands(); }));
    menu->addAction(a.make("Help on what is under the cursor", "help", "F1", "Says what it is and does", [this] { showHelpOnWidget(this); }));
    menu->addAction(a.make("Keyboard reference", "book", "", "Every key, and what the mouse does in the view",
                           [this] { showKeyboardReference(*shortcuts_, centre_); }));
    menu->addAction(a.make("Welcome", "help", "", "Recent files, samples and lessons over the view", [this] {
        if (!welcome_) return showWelcome();
        welcome_->show();
        welcome_->raise();
    }));
    menu->addAction(a.make("About Meshwright", "", "", "Version and licence", [this] {
        QMessageBox::about(this, "About Meshwright",
                           "<b>Meshwright</b> edits meshes, and shows how its algorithms work, step by step.<br><br>"
                           "Free software under the GNU General Public License, version 3 or later.");
    }));
}

void MainWindow::stepWorkspace(int by)
{
    const QStringList all = workspaces_->all();
    workspaces_->change(all.at((int(all.indexOf(workspaces_->current())) + by + int(all.size())) % int(all.size())));
}

void MainWindow::listen()
{
    subscription_ = document_.subscribe([this](const Change&) {
        actions_->refresh();
        refreshTitle();
    });
    connect(view_.get(), &ViewState::changed, this, [this] { actions_->refresh(); });
    connect(workspaces_, &Workspaces::changed, this, &MainWindow::followWorkspace);
    connect(views_, &ViewArea::hint, status_, &StatusStrip::setHint);
    connect(views_, &ViewArea::failed, banner_, &Banner::trouble);
    connect(status_, &StatusStrip::jobsClicked, this, [this] { workspaces_->show("jobs"); });
    connect(files_, &FileCommands::trouble, banner_, &Banner::trouble);
    session_.trouble = [this](const QString& text) { banner_->trouble(text); };
    session_.notice = [this](const QString& text) { banner_->notice(text, {}); };
    connect(files_, &FileCommands::notice, this,
            [this](const QString& text, const std::vector<Warning>& warnings) { banner_->notice(text, warnings); });
    connect(files_, &FileCommands::opened, this, [this] { views_->active().frameAll(false); });
    connect(files_, &FileCommands::added, this, [this] { views_->active().frameAll(); });
    connect(steps_.get(), &StepSession::opened, this, [this] { workspaces_->change("Learn"); });
    connect(steps_.get(), &StepSession::opened, playback_.get(), &Playback::pause);
    connect(files_, &FileCommands::placed, this, &MainWindow::offerPlacement);
    connect(files_, &FileCommands::exportWanted, this, [this] { (new ExportSheet(session_, *files_, centre_))->open(); });
    connect(files_, &FileCommands::opened, banner_, &QWidget::hide);  // it spoke of another scene
    connect(files_, &FileCommands::remembered, this, &MainWindow::keepThumbnail);
    status_->setHint("Click picks · Drag orbits · Shift+drag boxes · Right-drag pans · F frames");
}

// What header and tools have to offer is another thing for a terrain or a character.
void MainWindow::followWorkspace()
{
    const bool terrain = workspaces_->kind() == "Terrain", character = workspaces_->kind() == "Character";
    centre_->findChild<QWidget*>("toolStrip")->setHidden(terrain);
    view_->take(terrain ? ToolKind::Brush : character ? ToolKind::Rotate : ToolKind::Select);
    if (character || view_->pickKind == PickKind::Joint) view_->pickKind = character ? PickKind::Joint : PickKind::Object;
    view_->showBones = character;
    view_->showMeshes = true;
    for (const auto& [name, shown] : {std::pair{"colourByGroup", !character && !terrain}, {"showGroup", character}})
        if (auto* group = header_->findChild<QWidget*>(name)) group->setVisible(shown);
    view_->touch();
}

void MainWindow::refreshTitle()
{
    setWindowTitle(files_->title() + "[*] - Meshwright");
    setWindowModified(document_.modified());
}

void MainWindow::searchCommands()
{
    auto* search = new CommandSearch(findables(session_, *shortcuts_, *workspaces_), this);
    connect(search, &CommandSearch::said, status_, &StatusStrip::say);
    connect(search, &CommandSearch::helpWanted, this,
            [this](const QString& title, const QString& text) { showHelp(this, title, text, bar_->searchField()->mapToGlobal(QPoint(-100, 34))); });
    search->openBelow(bar_->searchField());
}

void MainWindow::showWelcome()
{
    if (document_.scene().nodes().empty())
        files_->openScene(samples().front().make(), "Welcome scene", QString("sample:%1").arg(samples().front().id));
    if (!welcome_) {
        welcome_ = new WelcomeCard(session_, *files_, viewport_);
        connect(welcome_, &WelcomeCard::newTerrainWanted, this, [this] {
            welcome_->hide();
            edits::newTerrain(session_);
            workspaces_->change("Terrain");
        });
        connect(welcome_, &WelcomeCard::lessonsWanted, this, [this] {
            workspaces_->change("Learn");
            workspaces_->show("lessons");
        });
        connect(welcome_, &WelcomeCard::hidden, this, [this] { viewport_->frameAll(); });
    }
    welcome_->show();
    welcome_->raise();
    QTimer::singleShot(0, this, &MainWindow::aimAboveWelcome);
}

// The model in the part of the view that the card leaves free.
void MainWindow::aimAboveWelcome()
{
    if (!welcome_ || !welcome_->isVisible()) return;
    viewport_->frameAll(false);
    Camera& c = view_->camera;
    const double whole = viewport_->height(), part = welcome_->freeHeight();
    if (part < 60 || part >= whole) return;
    c.distance *= whole / part;
    c.pan({0, -(whole - part) / 2}, {double(viewport_->width()), whole});
    viewport_->update();
}

// What is seen of a file just after it was opened stands for it in the list of recent files.
void MainWindow::keepThumbnail(const QString& file)
{
    QTimer::singleShot(700, this, [this, file] {
        const auto open = QString::fromStdU16String(document_.file().u16string());
        if (QFileInfo(open).absoluteFilePath() != QFileInfo(file).absoluteFilePath() || steps_->isOpen()) return;
        // Read where it is drawn anyway: a picture more would keep the window waiting.
        connect(
            viewport_, &Viewport::painted, this, [this, file] { thumbnails::keep(QFileInfo(file).absoluteFilePath(), viewport_->grabFramebuffer()); },
            Qt::ConnectionType(Qt::DirectConnection | Qt::SingleShotConnection));
        viewport_->update();
    });
}

void MainWindow::showEvent(QShowEvent* e)
{
    QMainWindow::showEvent(e);
    if (workspaces_->current().isEmpty()) workspaces_->change("Mesh");
    viewport_->frameAll(false);
    if (welcome_ && welcome_->isVisible()) aimAboveWelcome();
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

// Panels in reading order, the view among them; the focus goes to what had it there last, or the first that takes it.
void MainWindow::focusPanel(int by)
{
    std::vector<QWidget*> stops{viewport_};
    for (QDockWidget* d : findChildren<QDockWidget*>())
        if (d->isVisible() && d->widget() && !d->visibleRegion().isEmpty()) stops.push_back(d);
    std::sort(stops.begin(), stops.end(), [this](QWidget* a, QWidget* b) {
        const QPoint p = a->mapTo(this, QPoint()), q = b->mapTo(this, QPoint());
        return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y());
    });
    const QWidget* now = QApplication::focusWidget();
    size_t here = 0;
    for (size_t i = 0; i < stops.size(); ++i)
        if (now && (stops[i] == now || stops[i]->isAncestorOf(now))) here = i;
    for (size_t tried = 0; tried < stops.size(); ++tried) {
        here = (here + stops.size() + size_t(by + int(stops.size()))) % stops.size();
        QWidget* stop = stops[here];
        if (stop == viewport_) return viewport_->setFocus(Qt::ShortcutFocusReason);
        QWidget* const inside = static_cast<QDockWidget*>(stop)->widget();
        for (QWidget* w = inside; w; w = w->nextInFocusChain()) {
            if (w != inside && !inside->isAncestorOf(w)) break;
            if (w->isVisible() && w->isEnabled() && (w->focusPolicy() & Qt::TabFocus)) return w->setFocus(Qt::TabFocusReason);
        }
    }
}

void MainWindow::offerPlacement(const QString& file, const Placement& placement, bool, const std::vector<NodeId>& roots)
{
    banner_->offer("Change...", "Read its numbers in another unit, or with another axis up",
                   [this, file, placement, roots] { askForPlacement(session_, file, placement, roots, banner_); });
}

}  // namespace mw
