// The window: menus, toolbar, docks and the view around one document. Actions, docks and files have files of their own.
#pragma once
#include <QMainWindow>
#include <memory>

#include "ui/session.h"

class QMenu;

namespace mw {

class Banner;
class EvaluationService;
class FileCommands;
class MainToolBar;
class StatusStrip;
class ViewArea;
class Viewport;
class WelcomeCard;
class DropTarget;
class Shortcuts;
class Workspaces;
struct Actions;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    MainWindow();
    ~MainWindow() override;

    Session& session() { return session_; }
    FileCommands& files() { return *files_; }
    ViewArea& views() { return *views_; }
    Viewport& viewport() { return *viewport_; }  ///< the first
    Workspaces& workspaces() { return *workspaces_; }
    Banner& banner() { return *banner_; }
    EvaluationService& evaluations() { return *evaluations_; }
    Shortcuts& shortcuts() { return *shortcuts_; }
    void showWelcome();  ///< the scene the program makes, and the card over it

protected:
    void closeEvent(QCloseEvent* e) override;
    void showEvent(QShowEvent* e) override;

private:
    void makeCentre();
    void makeMenus();
    void fillWindowMenu(QMenu* menu);
    void fillHelpMenu(QMenu* menu);
    void listen();
    void refreshTitle();
    void searchCommands();
    void followWorkspace();
    void aimAboveWelcome();
    void keepThumbnail(const QString& file);
    void stepWorkspace(int by);
    void focusPanel(int by);
    void offerPlacement(const QString& file, const struct Placement& placement, bool fromFile, const std::vector<NodeId>& roots);

    Document document_;
    std::unique_ptr<Jobs> jobs_;
    std::unique_ptr<ViewState> view_;
    std::unique_ptr<StepSession> steps_;
    std::unique_ptr<EvaluationService> evaluations_;
    std::unique_ptr<Playback> playback_;
    Session session_;
    std::unique_ptr<Actions> actions_;
    FileCommands* files_ = nullptr;
    Workspaces* workspaces_ = nullptr;
    ViewArea* views_ = nullptr;
    Viewport* viewport_ = nullptr;
    Banner* banner_ = nullptr;
    StatusStrip* status_ = nullptr;
    WelcomeCard* welcome_ = nullptr;
    MainToolBar* bar_ = nullptr;
    Shortcuts* shortcuts_ = nullptr;
    QWidget *header_ = nullptr, *centre_ = nullptr;
    std::shared_ptr<void> subscription_;
    bool closing_ = false;
};

}  // namespace mw
