#include "ui/actions.h"

#include <QActionGroup>
#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenuBar>
#include <QSettings>
#include <algorithm>

#include "core/io/io.h"
#include "ui/file_commands.h"
#include "ui/stack_edits.h"
#include "ui/steps/step_player.h"
#include "ui/steps/step_subject.h"
#include "ui/terrain_edits.h"
#include "ui/theme.h"
#include "ui/viewport/viewport.h"

namespace mw {
namespace {

std::vector<NodeId> allNodes(const Session& s)
{
    return s.document.scene().nodes();
}

// The elements of the active mesh: all of the pick kind.
void selectAllElements(Session& s, bool invert)
{
    const PickKind kind = s.view.pickKind;
    const Selection old = s.document.selection();
    if (kind == PickKind::Object) {
        Selection next;
        for (NodeId n : allNodes(s))
            if (!invert || !old.has(n)) next.nodes.push_back(n);
        return s.document.select(next);
    }
    const Node* n = s.document.scene().find(old.active());
    if (!n || !n->mesh) return;
    const Mesh mesh = shownMesh(s, n->mesh);
    ElementSet set{kind == PickKind::Vertex ? ElementKind::Vertex : kind == PickKind::Edge ? ElementKind::Edge : ElementKind::Face, {}};
    const bool edges = set.kind == ElementKind::Edge;
    const size_t count = edges ? mesh.edges().size() / 2 : set.kind == ElementKind::Vertex ? mesh.vertexCount() : mesh.faceCount();
    std::set<std::pair<uint32_t, uint32_t>> had;
    if (invert && old.elements.kind == set.kind)
        for (size_t i = 0; i < old.elements.indices.size(); i += edges ? 2 : 1)
            had.insert({old.elements.indices[i], edges ? old.elements.indices[i + 1] : 0});
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t a = edges ? mesh.edges()[2 * i] : i, b = edges ? mesh.edges()[2 * i + 1] : 0;
        if (had.count({a, b})) continue;
        set.indices.push_back(a);
        if (edges) set.indices.push_back(b);
    }
    s.document.select({old.nodes, old.active(), std::move(set)});
}

}  // namespace

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
    a->setToolTip((tip.isEmpty() ? plain : tip) + (key.isEmpty() ? QString() : " · " + a->shortcut().toString(QKeySequence::NativeText)));
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

Actions::Actions(Session& session, FileCommands& files, Viewport& viewport, QWidget* window, QWidget* viewArea)
    : s_(session), files_(files), viewport_(viewport), window_(window), viewArea_(viewArea)
{
    open = make("Open...", "open", "Ctrl+O", "Open a file in place of the scene", [this] { files_.openDialog(); });
    import = make("Import...", "plus", "Ctrl+I", "Add files to the scene", [this] { files_.importDialog();
});
import->setShortcuts({QKeySequence("Ctrl+Shift+O")});
save = make("Save", "save", "Ctrl+S", "Save the project with its modifiers", [this] { files_.save(); });
saveAs = make("Save as...", "", "Ctrl+Shift+S", "Save the project under another name", [this] { files_.saveDialog(); });
exportAs = make("Export...", "export", "Ctrl+E", "Write the evaluated scene; the ending chooses the format", [this] { files_.exportDialog(); });
quit = make("Quit", "", "Ctrl+Q", "", [this] { window_->close(); });
makeEdit();
makeSelect();
makeView();
makeCatalog();
makeTerrain();
refresh();
}  // namespace mw

void Actions::makeEdit()
{
    Document& d = s_.document;
    undo = make("Undo", "undo", "Ctrl+Z", "", [&d] { d.undo(); });
    redo = make("Redo", "redo", "Ctrl+Shift+Z; Ctrl+Y", "", [&d] { d.redo(); });
    remove = make(
        "Delete", "", "Del", "Delete the selected nodes", [&d] { edits::removeNodes(d, d.selection().nodes); }, true);
    rename = make(
        "Rename...", "", "F2", "Rename the active node",
        [this, &d] {
            const Node* n = d.scene().find(d.selection().active());
            if (!n) return;
            bool ok = false;
            const QString name = QInputDialog::getText(window_, "Rename", "Name", QLineEdit::Normal, QString::fromStdString(n->name), &ok);
            if (ok) edits::rename(d, d.selection().active(), name);
        },
        true);
}

void Actions::makeSelect()
{
    Session& s = s_;
    selectAll = make(
        "All", "", "A", "Select everything of the kind that is picked", [&s] { selectAllElements(s, false); }, true);
    selectNone = make("None", "", "Ctrl+Shift+A", "Select nothing", [&s] { s.document.select({}); });
    invert = make("Invert", "", "Ctrl+I", "Select what is not selected", [&s] { selectAllElements(s, true); });
    hide = make(
        "Hide", "eye-off", "H", "Hide the selected nodes", [&s] { edits::setVisible(s.document, s.document.selection().nodes, false); }, true);
    hideOthers = make(
        "Hide others", "", "Shift+H", "Hide what is not selected",
        [&s] {
            std::vector<NodeId> others;
            for (NodeId n : allNodes(s))
                if (!s.document.selection().has(n) && s.document.scene().node(n).children.empty()) others.push_back(n);
            edits::setVisible(s.document, others, false);
        },
        true);
    showAll = make("Show all", "eye", "Ctrl+H", "Show every node", [&s] { edits::setVisible(s.document, allNodes(s), true); });
    auto* group = new QActionGroup(window_);
    const struct {
        const char *text, *icon, *tip;
        PickKind kind;
    } kinds[] = {{"Pick objects", "object", "Clicks pick whole objects", PickKind::Object},
                 {"Pick vertices", "vertex", "Clicks pick vertices", PickKind::Vertex},
                 {"Pick edges", "edge", "Clicks pick edges", PickKind::Edge},
                 {"Pick faces", "face", "Clicks pick faces", PickKind::Face},
                 {"Pick joints", "bone", "Clicks pick the joints of skeletons, hidden ones too", PickKind::Joint}};
    for (const auto& k : kinds) {
        auto* a = make(k.text, k.icon, QString("Ctrl+%1").arg(pickKinds.size() + 1), k.tip, [&s, kind = k.kind] {
            s.view.pickKind = kind;
            s.view.touch();
        });
        a->setCheckable(true);
        group->addAction(a);
        pickKinds << a;
    }
}

void Actions::makeView()
{
    Session& s = s_;
    Viewport& v = viewport_;
    frameSelection = make(
        "Frame selection", "frame", "F", "Show the selection as large as it fits", [&v] { v.frameSelection(); }, true);
    frameAll = make(
        "Frame all", "", "Shift+F", "Show everything", [&v] { v.frameAll(); }, true);
    for (const auto& [key, name] : {std::pair{"1", "front"}, {"3", "right"}, {"7", "top"}})
        views << make(
            QString(name).replace(0, 1, QString(name[0]).toUpper()) + " view", "", key, "Look from there; again: from the other side",
            [&v, name = QString(name)] { v.lookFrom(name); }, true);
    perspective = make(
        "Perspective", "", "5", "Perspective or parallel projection",
        [&s] {
            s.view.camera.perspective = !s.view.camera.perspective;
            s.view.touch();
        },
        true);
    perspective->setCheckable(true);
    auto* group = new QActionGroup(window_);
    const struct {
        const char *text, *icon, *tip;
        Shading shading;
    } kinds[] = {{"Smooth", "smooth", "Normals vary over faces", Shading::Smooth},
                 {"Flat", "flat", "One normal a face", Shading::Flat},
                 {"Wire", "wire", "Edges only", Shading::Wire}};
    for (const auto& k : kinds) {
        auto* a = make(k.text, k.icon, "", k.tip, [&s, shading = k.shading] {
            s.view.options.shading = shading;
            s.view.touch();
        });
        a->setCheckable(true);
        group->addAction(a);
        shadings << a;
    }
    wireOverlay = toggle("Wire overlay", "overlay", "Z", "Edges over the surface", &ViewOptions::wireOverlay);
    xray = toggle("X-ray", "xray", "X", "See, and pick, through the surface", &ViewOptions::xray);
    grid = toggle("Grid", "grid", "G", "The ground in metres", &ViewOptions::grid);
    normals = toggle("Normals", "", "", "A needle at each vertex", &ViewOptions::normalsNeedles);
    bones = make(
        "Bones", "bone", "", "The joints of skeletons, through what hides them",
        [&s] {
            s.view.showBones = !s.view.showBones;
            s.view.touch();
        },
        true);
    bones->setCheckable(true);
    orientation = toggle("Orientation marker", "", "", "Where X, Y and Z point", &ViewOptions::orientationMarker);
    legend = toggle("Legend", "", "", "What the colours mean", &ViewOptions::legend);
    picture = make("Save picture...", "picture", "", "Save what the view shows as PNG", [this, &v] {
        const QString file = QFileDialog::getSaveFileName(window_, "Save picture", "view.png", "PNG (*.png)");
        if (!file.isEmpty()) v.grabFramebuffer().save(QFileInfo(file).suffix().isEmpty() ? file + ".png" : file);
    });
    const auto theme = [this](Theme t) {
        QSettings().setValue("view/theme", t == Theme::Dark ? "dark" : "light");
        applyTheme(*qApp, t);
        s_.view.options.theme = t;
        s_.view.touch();
    };
    darkTheme = make("Dark theme", "", "", "", [theme] { theme(Theme::Dark); });
    lightTheme = make("Light theme", "", "", "", [theme] { theme(Theme::Light); });
    auto* toolGroup = new QActionGroup(window_);
    tools << make(
        "Select", "select", "Q", "Click picks, drag orbits",
        [&v] {
            if (!v.abortDrag()) v.setBoxTool(false);
        },
        true);
    tools << make(
        "Box select", "box", "B", "Drag a box over what is to be selected", [&v] { v.setBoxTool(true); }, true);
    tools << make(
        "Brush", "brush", "M", "Drag paints on terrains", [&v] { v.setBrushTool(); }, true);
    QObject::connect(&s.view, &ViewState::brushChanged, window_, [this, &s, &v] {
        tools[s.view.brushInHand ? 2 : v.boxTool() ? 1 : 0]->setChecked(true);
    });
    for (QAction* a : tools) {
        a->setCheckable(true);
        toolGroup->addAction(a);
    }
    tools[0]->setShortcuts({QKeySequence("Q"), QKeySequence("Esc")});
    tools[0]->setChecked(true);
}

void Actions::makeCatalog()
{
    for (const Operation& op : catalog()) {
        const QString title = QString::fromStdString(op.title), summary = QString::fromStdString(op.summary);
        if (op.accepts == Kind::Mesh && op.yields == Kind::Mesh) {
            auto* a = make(title, "", "", summary, [this, &op] {
                if (const MeshId m = edits::activeMesh(s_.document)) edits::addModifier(s_.document, m, op);
            });
            a->setData(QString::fromStdString(op.category));
            addModifiers << a;
        }
        if (op.accepts == Kind::Nothing && op.yields == Kind::Mesh)
            addSources << make(title, "mesh", "", summary, [this, &op] {
                s_.jobs.start("Make " + QString::fromStdString(op.title), [this, &op](Progress& p) -> std::function<void()> {
                    Mesh mesh = std::get<Mesh>(apply(op, {}, {}, &p));
                    return [this, &op, mesh] {
                        Scene next = s_.document.scene();
                        const auto roots = next.merge(sceneOf(mesh, op.title));
                        s_.document.commit("Add " + op.title, std::move(next), {roots, {}, {}});
                        s_.view.frameNodes({});
                    };
                });
            });
        if (op.steps) {
            auto* a = make("Step through: " + title, "step", "", summary, [this, &op] { stepThrough(s_, op); });
            a->setData(QString::fromStdString(op.id));
            stepThroughs << a;
        }
    }
}

void Actions::makeTerrain()
{
    Session& s = s_;
    const auto said = [this](const QString& text) {
        if (!text.isEmpty()) emit files_.trouble(text);
    };
    const QString pictures = "Height maps (*.png *.tga *.pgm)";
    terrainActions << make("New terrain", "terrain", "", "Add a terrain by diamond-square", [&s] { edits::newTerrain(s); });
    terrainActions << make("New terrain from picture...", "picture", "", "Add a terrain whose heights are a grey picture",
                           [this, &s, said, pictures] {
                               const QString file = QFileDialog::getOpenFileName(window_, "New terrain from picture", {}, pictures);
                               if (!file.isEmpty()) edits::importPicture(s, file, true, said);
                           });
    terrainEdits << make("Import height map...", "open", "", "A picture in place of the active terrain's map", [this, &s, said, pictures] {
        const QString file = QFileDialog::getOpenFileName(window_, "Import a height map", {}, pictures);
        if (!file.isEmpty()) edits::importPicture(s, file, false, said);
    });
    terrainEdits << make("Export height map...", "export", "", "The active terrain's map as a grey PNG of 16 bits", [this, &s, said] {
        QString file = QFileDialog::getSaveFileName(window_, "Export the height map", "heights.png", "PNG, 16 bits (*.png)");
        if (file.isEmpty()) return;
        if (!file.endsWith(".png", Qt::CaseInsensitive)) file += ".png";
        edits::exportPicture(s, edits::activeTerrain(s.document), file, said);
    });
    terrainEdits << make("Terrain to mesh", "mesh", "", "A mesh that follows the active terrain, beside it",
                         [&s] { edits::terrainToMesh(s, edits::activeTerrain(s.document), 100'000); });
    const auto brush = [this, &s](const char* text, const char* iconName, const char* tip, Brush::Kind kind) {
        terrainEdits << make(text, iconName, "", tip, [&s, kind] {
            s.view.brush.kind = kind;
            s.view.brushInHand = true;
            s.view.touchBrush();
        });
    };
    brush("Raise the ground", "raise", "Take the brush that lifts", Brush::Kind::Raise);
    brush("Lower the ground", "lower", "Take the brush that digs", Brush::Kind::Lower);
    const auto key = [this, &s](const char* text, const char* keys, const char* tip, double factor, double add) {
        terrainEdits << make(
            text, "", keys, tip,
            [&s, factor, add] {
                s.view.brush.radius = std::clamp(s.view.brush.radius * factor, 0.1, 10000.0);
                s.view.brush.strength = std::clamp(s.view.brush.strength + add, 0.01, 1.0);
                s.view.touchBrush();
            },
            true);
    };
    key("Smaller brush", "[", "Radius down by a tenth", 1 / 1.1, 0);
    key("Larger brush", "]", "Radius up by a tenth", 1.1, 0);
    key("Weaker brush", "Shift+[; {", "Strength down by 0.05", 1, -0.05);
    key("Stronger brush", "Shift+]; }", "Strength up by 0.05", 1, 0.05);
}

void Actions::fillRecent()
{
    recent->clear();
    for (const QString& file : files_.recent()) {
        auto* a = recent->addAction(QFileInfo(file).fileName(), [this, file] { files_.whenSaved([this, file] { files_.open(file); }); });
        a->setToolTip(file);
        a->setEnabled(QFileInfo::exists(file));
    }
    recent->setEnabled(!recent->isEmpty());
}

void Actions::fill(QMenuBar* bar, QMenu** windowMenu, QMenu** helpMenu)
{
    auto* file = bar->addMenu("File");
    file->addAction(open);
    recent = file->addMenu("Open recent");
    fillRecent();
    QObject::connect(&files_, &FileCommands::recentChanged, window_, [this] { fillRecent(); });
    file->addAction(import);
    file->addSeparator();
    file->addActions({save, saveAs, exportAs});
    file->addSeparator();
    file->addAction(quit);
    auto* edit = bar->addMenu("Edit");
    edit->addActions({undo, redo});
    edit->addSeparator();
    edit->addActions({rename, remove});
    auto* select = bar->addMenu("Select");
    select->addActions({selectAll, selectNone, invert});
    select->addSeparator();
    select->addActions(pickKinds);
    select->addSeparator();
    select->addActions({hide, hideOthers, showAll});
    auto* view = bar->addMenu("View");
    view->addActions({frameSelection, frameAll});
    view->addActions(views);
    view->addAction(perspective);
    view->addSeparator();
    view->addActions(shadings);
    auto* overlays = view->addMenu("Overlays");
    overlays->addActions({wireOverlay, xray, grid, normals, bones, orientation, legend});
    view->addSeparator();
    view->addActions({darkTheme, lightTheme});
    view->addSeparator();
    view->addAction(picture);
    auto* mesh = bar->addMenu("Mesh");
    auto* sources = mesh->addMenu("Add");
    sources->addActions(addSources);
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
    m->addActions({frameSelection, frameAll});
    m->addSeparator();
    m->addActions({hide, hideOthers, showAll});
    m->addSeparator();
    m->addActions(pickKinds);
    m->addSeparator();
    m->addActions({rename, remove});
    return m;
}

void Actions::refresh()
{
    const Document& d = s_.document;
    undo->setEnabled(d.canUndo());
    redo->setEnabled(d.canRedo());
    const QString undoName = QString::fromStdString(d.undoName()), redoName = QString::fromStdString(d.redoName());
    undo->setText(d.canUndo() ? "Undo " + undoName : "Undo");
    redo->setText(d.canRedo() ? "Redo " + redoName : "Redo");
    undo->setToolTip(d.canUndo() ? "Undo: " + undoName + " · Ctrl+Z" : "Nothing to undo");
    redo->setToolTip(d.canRedo() ? "Redo: " + redoName + " · Ctrl+Shift+Z" : "Nothing to redo");
    const bool any = !d.selection().nodes.empty();
    const bool mesh = edits::activeMesh(d).value != 0;
    for (QAction* a : {remove, rename, hide, hideOthers}) a->setEnabled(any);
    for (QAction* a : addModifiers) a->setEnabled(mesh);
    for (QAction* a : stepThroughs) {
        const Operation& op = operation(a->data().toString().toStdString());
        const QString whyNot = whyNotSteppable(s_, op);
        a->setEnabled(whyNot.isEmpty());
        a->setToolTip(whyNot.isEmpty() ? QString::fromStdString(op.summary) : whyNot);
    }
    const bool ground = edits::activeTerrain(d).value != 0;
    for (QAction* a : terrainEdits) a->setEnabled(ground);
    for (const auto& [a, flag] : flags_) a->setChecked(s_.view.options.*flag);
    perspective->setChecked(s_.view.camera.perspective);
    bones->setChecked(s_.view.showBones);
    pickKinds[int(s_.view.pickKind)]->setChecked(true);
    shadings[int(s_.view.options.shading)]->setChecked(true);
}

}  // namespace mw
