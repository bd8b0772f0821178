#include "ui/actions.h"

#include <QFileInfo>
#include <QMenuBar>

#include "ui/file_commands.h"
#include "ui/shortcuts.h"
#include "ui/stack_edits.h"
#include "ui/steps/step_subject.h"
#include "ui/terrain_edits.h"
#include "ui/theme.h"
#include "ui/viewport/viewport.h"

namespace mw {

QAction* Actions::make(const QString& text, const QString& iconName, const QString& key, const QString& tip, std::function<void()> run, bool inView)
{
    auto* a = new QAction(text, window_);
    if (!iconName.isEmpty()) a->setIcon(icon(iconName));
    if (!key.isEmpty()) {
        a->setShortcuts(QKeySequence::listFromString(key));
        if (inView) a->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    }
    QString plain = text;
    plain.remove("...").remove('&');
    setTip(a, tip.isEmpty() ? plain : tip);
    QObject::connect(a, &QAction::triggered, window_, [run = std::move(run)] { run(); });
    (inView ? viewArea_ : window_)->addAction(a);
    return a;
}

QAction* Actions::toggle(const QString& text, const QString& iconName, const QString& key, const QString& tip, bool ViewOptions::*flag)
{
    auto* a = make(
        text, iconName, key, tip,
        [this, flag] {
            s_.view.options.*flag = !(s_.view.options.*flag);
            s_.view.touch();
        },
        true);
    a->setCheckable(true);
    flags_.push_back({a, flag});
    return a;
}

Actions::Actions(Session& session, FileCommands& files, ViewArea& area, QWidget* window, QWidget* viewArea)
    : s_(session), files_(files), views_(area), window_(window), viewArea_(viewArea)
{
    open = make("Open...", "open", "Ctrl+O", "Open a file in place of the scene", [this] { files_.openDialog(); });
    import = make("Import...", "plus", "Ctrl+Shift+O", "Add files to the scene", [this] { files_.importDialog();
});
save = make("Save", "save", "Ctrl+S", "Save the project with its modifiers", [this] { files_.save(); });
saveAs = make("Save as...", "", "Ctrl+Shift+S", "Save the project under another name", [this] { files_.saveDialog(); });
exportAs = make("Export...", "export", "Ctrl+E", "Write the evaluated scene; the ending chooses the format", [this] { files_.exportDialog(); });
quit = make("Quit", "", "Ctrl+Q", "", [this] { window_->close(); });
makeEdit();
makeCut();
makeSelect();
makeView();
makeCatalog();
makeTerrain();
refresh();
}  // namespace mw

void Actions::fillRecent()
{
    recent->clear();
    for (const QString& file : files_.recent()) {
        const bool there = QFileInfo::exists(file);
        const QString name = QFileInfo(file).fileName();
        auto* a = recent->addAction(there ? name : "Find " + name + "...", [this, file, there] {
            if (!there) return files_.findRecent(file);
            files_.whenSaved([this, file] { files_.open(file); });
        });
        a->setToolTip(there ? file : file + " is not there any more");
        a->setProperty("passing", true);  // no command of its own: no keys, not in the list of shortcuts
    }
    recent->setEnabled(!recent->isEmpty());
}

void Actions::fill(QMenuBar* bar, QMenu** windowMenu, QMenu** helpMenu)
{
    auto* file = bar->addMenu("File");
    file->addAction(open);
    recent = file->addMenu("Open recent");
    recent->menuAction()->setProperty("passing", true);
    fillRecent();
    QObject::connect(&files_, &FileCommands::recentChanged, window_, [this] { fillRecent(); });
    file->addAction(import);
    file->addSeparator();
    file->addActions({save, saveAs, exportAs});
    file->addSeparator();
    file->addAction(quit);
    auto* edit = bar->addMenu("Edit");
    edit->setToolTipsVisible(true);  // why one is off
    edit->addActions({undo, redo});
    edit->addSeparator();
    edit->addActions({duplicate, duplicateLinked, ownCopy});
    edit->addSeparator();
    edit->addActions({join, separateFaces, separateParts, separateMaterials, groupNodes});
    edit->addSeparator();
    edit->addActions({rename, remove});
    edit->addSeparator();
    edit->addAction(copyHistory);
    auto* select = bar->addMenu("Select");
    select->addActions({selectAll, selectNone, invert});
    select->addSeparator();
    fillSelectElements(select);
    select->addSeparator();
    select->addActions(pickKinds);
    select->addAction(nextPickKind);
    select->addSeparator();
    select->addActions({hide, hideOthers, showAll});
    auto* view = bar->addMenu("View");
    view->addActions({frameSelection, frameAll});
    view->addActions(views);
    view->addAction(perspective);
    view->addSeparator();
    view->addActions(shadings);
    auto* toolMenu = view->addMenu("Tool");
    toolMenu->addActions(tools);
    toolMenu->addSeparator();
    toolMenu->addActions({localAxes, pivotCentre, copyMeasurement});
    view->addMenu("Split")->addActions({oneView, split, fourViews, linkCameras});
    auto* compare = view->addMenu("Compare");
    compare->setToolTipsVisible(true);  // why one is off
    compare->addActions({compareBase, compareVariants});
    view->addMenu("Matcap")->addActions(matcaps);
    auto* light = view->addMenu("Light");
    light->addActions(lights);
    light->addSeparator();
    light->addActions({turnLight, shadows});
    auto* overlays = view->addMenu("Overlays");
    overlays->addActions({wireOverlay, xray, checker, grid, normals, faceNormals, bones, orientation, legend});
    view->addSeparator();
    view->addMenu("Theme")->addActions(themes);
    view->addAction(reducedMotion);
    view->addSeparator();
    view->addActions({picture, turntable});
    auto* mesh = bar->addMenu("Mesh");
    auto* sources = mesh->addMenu("Add");
    sources->addActions(addSources);
    mesh->setToolTipsVisible(true);  // why one is off
    mesh->addSeparator();
    mesh->addActions({cutSelection, cutDisk});
    mesh->addSeparator();
    std::map<QString, QMenu*> categories;
    for (QAction* a : addModifiers) {
        QMenu*& m = categories[a->data().toString()];
        if (!m) m = mesh->addMenu(a->data().toString());
        m->addAction(a);
    }
    auto* terrain = bar->addMenu("Terrain");
    terrain->addActions(terrainActions);
    terrain->addSeparator();
    terrain->addActions(terrainEdits);
    auto* steps = bar->addMenu("Steps");
    std::map<std::string, QMenu*> fields;
    for (QAction* a : stepThroughs) {
        const Operation& op = operation(a->data().toString().toStdString());
        QMenu*& m = fields[op.category];
        if (!m) m = steps->addMenu(QString::fromStdString(op.category));
        m->addAction(a);
    }
    *windowMenu = bar->addMenu("Window");
    *helpMenu = bar->addMenu("Help");
}

QMenu* Actions::contextMenu(QWidget* parent) const
{
    auto* m = new QMenu(parent);
    m->setToolTipsVisible(true);
    m->addActions({frameSelection, frameAll});
    m->addSeparator();
    m->addActions({hide, hideOthers, showAll});
    m->addSeparator();
    m->addActions(pickKinds);
    m->addSeparator();
    auto* tool = m->addMenu("Tool");
    tool->addActions(tools);
    tool->addSeparator();
    tool->addActions({localAxes, pivotCentre, copyMeasurement});
    m->addActions({duplicate, duplicateLinked, join});
    auto* separate = m->addMenu("Separate");
    separate->addActions({separateFaces, separateParts, separateMaterials});
    m->addAction(groupNodes);
    m->addSeparator();
    m->addActions({rename, remove});
    return m;
}

void Actions::refresh()
{
    const Document& d = s_.document;
    const auto enable = [](QAction* a, bool can, const char* whyNot) {
        a->setEnabled(can);
        a->setProperty("whyNot", can ? QVariant() : QVariant(whyNot));
    };
    enable(undo, d.canUndo(), "Nothing to undo");
    enable(redo, d.canRedo(), "Nothing to redo");
    const QString undoName = QString::fromStdString(d.undoName()), redoName = QString::fromStdString(d.redoName());
    undo->setText(d.canUndo() ? "Undo " + undoName : "Undo");
    redo->setText(d.canRedo() ? "Redo " + redoName : "Redo");
    setTip(undo, d.canUndo() ? "Undo: " + undoName : "Nothing to undo");
    setTip(redo, d.canRedo() ? "Redo: " + redoName : "Nothing to redo");
    const bool any = !d.selection().nodes.empty();
    const bool mesh = edits::activeMesh(d).value != 0;
    for (QAction* a : {rename, hide, hideOthers}) enable(a, any, "Select a node first");
    for (const OfSelection& o : ofSelection_) {
        const QString why = edits::whyNot(d, o.edit);
        o.action->setEnabled(why.isEmpty());
        setTip(o.action, why.isEmpty() ? o.tip : why);
    }
    for (QAction* a : addModifiers) enable(a, mesh, "Select a mesh first");
    for (QAction* a : stepThroughs) {
        const Operation& op = operation(a->data().toString().toStdString());
        const QString whyNot = whyNotSteppable(s_, op);
        enable(a, whyNot.isEmpty(), qPrintable(whyNot));
        setTip(a, whyNot.isEmpty() ? QString::fromStdString(op.summary) : whyNot);
    }
    refreshSelectElements();
    refreshCut();
    const bool ground = edits::activeTerrain(d).value != 0;
    for (QAction* a : terrainEdits) enable(a, ground, "Add a terrain first");
    for (const auto& [a, flag] : flags_) a->setChecked(s_.view.options.*flag);
    perspective->setChecked(s_.view.camera.perspective);
    compareBase->setEnabled(mesh);
    refreshCompare();
    split->setChecked(s_.view.views() == 2);
    linkCameras->setChecked(s_.view.linked);
    linkCameras->setEnabled(s_.view.views() > 1);
    localAxes->setChecked(s_.view.localAxes);
    pivotCentre->setChecked(s_.view.pivotCentre);
    bones->setChecked(s_.view.showBones);
    pickKinds[int(s_.view.pickKind)]->setChecked(true);
    shadings[int(s_.view.options.shading)]->setChecked(true);
    refreshLight();
}

}  // namespace mw
