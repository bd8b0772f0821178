// Every action of the window, made once and put into menus, buttons and the command search.
#pragma once
#include <QAction>
#include <QList>

#include "ui/edit_commands.h"
#include "ui/session.h"

class QMenuBar;
class QMenu;

namespace mw {

class FileCommands;
class ViewArea;
class Viewport;

struct Actions {
    Actions(Session& session, FileCommands& files, ViewArea& area, QWidget* window, QWidget* viewArea);

    QAction *open, *import, *save, *saveAs, *exportAs, *quit;
    QAction *undo, *redo, *remove, *rename, *duplicate, *duplicateLinked, *join, *separateFaces, *separateParts, *separateMaterials, *groupNodes,
        *ownCopy, *copyHistory, *cutSelection, *cutDisk;
    QAction *selectAll, *selectNone, *invert, *hide, *hideOthers, *showAll;
    QAction *frameSelection, *frameAll, *perspective, *grid, *wireOverlay, *xray, *orientation, *legend, *normals, *faceNormals, *bones, *picture,
        *resetCamera;
    QAction *reducedMotion, *nextPickKind, *shadows, *checker, *turnLight, *turntable;
    QList<QAction*> lights, matcaps;
    QList<QAction*> themes;
    QAction *split, *fourViews, *oneView, *linkCameras, *compareBase, *compareVariants, *localAxes, *pivotCentre, *copyMeasurement;
    QList<QAction*> pickKinds, shadings, views, tools, addModifiers, addSources, stepThroughs, terrainActions, terrainEdits;
    QList<QAction*> growths, conversions, searches, defects;  ///< of elements: from the selection, to another kind, in the whole mesh
    QMenu* recent = nullptr;

    /// A command: everything the window can do is made here and put into a menu, so that search and the list of shortcuts find it. `key` may
    /// name several, "Q; Esc". Keys of the view act only while it has the focus.
    QAction* make(const QString& text, const QString& icon, const QString& key, const QString& tip, std::function<void()> run, bool inView = false);

    /// Fills the bar; `windowMenu` gets its docks from the window. Help is left to the window, too.
    void fill(QMenuBar* bar, QMenu** windowMenu, QMenu** helpMenu);
    QMenu* contextMenu(QWidget* parent) const;
    std::function<void()> themeChanged;  ///< set by the window: what captured colours is made anew
    /// Enabled or not, ticked or not, and the names of undo and redo.
    void refresh();

private:
    QAction* toggle(const QString& text, const QString& icon, const QString& key, const QString& tip, bool ViewOptions::*flag);
    void makeEdit();
    void makeCut();
    void refreshCut();
    void makeSelect();
    void makeSelectElements();
    void fillSelectElements(QMenu* menu);
    void refreshSelectElements();
    void makeView();
    void makeTools();
    void makeViews();
    void refreshCompare();
    Viewport& viewport() const;  // the active one
    void makeLight();
    void refreshLight();
    void makeCatalog();
    void makeTerrain();
    void fillRecent();

    Session& s_;
    FileCommands& files_;
    ViewArea& views_;
    QWidget *window_, *viewArea_;
    std::vector<std::pair<QAction*, bool ViewOptions::*>> flags_;
    struct OfSelection {
        QAction* action;
        edits::SelectionEdit edit;
        QString tip;
    };
    std::vector<OfSelection> ofSelection_;  // off with the reason in the tooltip
};

}  // namespace mw
