// Camera, shading, overlays, theme, tools.
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>

#include "ui/viewport/measure_tool.h"
#include "ui/viewport/viewport.h"
// epoxy comes before Qt's own OpenGL headers
#include "ui/actions.h"
#include "ui/shortcuts.h"
#include "ui/stack_edits.h"
#include "ui/theme.h"
#include "ui/variants.h"
#include "ui/view_area.h"

namespace mw {
namespace {

const char* const variantsTip =
    "Linked views with one scale of colours: the result, and the last modifier with other weights or another operation of its kind in place of it";

}  // namespace

void Actions::refreshCompare()
{
    const MeshObject* object = s_.document.scene().find(edits::activeMesh(s_.document));
    const std::optional<size_t> last = object ? lastModifier(*object) : std::nullopt;
    QString whyNot;
    if (!object)
        whyNot = "Select a mesh first";
    else if (!last)
        whyNot = "The mesh has no modifier that runs: add one first";
    else if (variantsOf(object->stack[*last]).empty())
        whyNot = edits::titleOf(object->stack[*last]) + " has no variants of its kind; a split view's Shows > Variant... compares it with any";
    compareVariants->setEnabled(whyNot.isEmpty());
    compareVariants->setProperty("whyNot", whyNot.isEmpty() ? QVariant() : QVariant(whyNot));
    setTip(compareVariants, whyNot.isEmpty() ? QString(variantsTip) : whyNot);
}

void Actions::makeView()
{
    Session& s = s_;
    frameSelection = make(
        "Frame selection", "frame", "F", "Show the selection as large as it fits", [this] { viewport().frameSelection(); }, true);
    frameAll = make(
        "Frame all", "", "Shift+F", "Show everything", [this] { viewport().frameAll(); }, true);
    for (const auto& [key, name] : {std::pair{"1", "front"}, {"3", "right"}, {"7", "top"}})
        views << make(
            QString(name).replace(0, 1, QString(name[0]).toUpper()) + " view", "", key, "Look from there; again: from the other side",
            [this, name = QString(name)] { viewport().lookFrom(name); }, true);
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
                 {"Wire", "wire", "Edges only", Shading::Wire},
                 {"Matcap", "matcap", "Lit as a sphere of one material is, whatever the lights; View > Matcap chooses which", Shading::Matcap}};
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
    faceNormals = toggle("Face normals", "", "", "A needle at the middle of each face", &ViewOptions::faceNeedles);
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
    makeLight();
    auto* themeGroup = new QActionGroup(window_);
    const struct {
        const char *text, *tip;
        ThemeChoice choice;
    } choices[] = {{"System theme", "Dark or light as the desktop had it when the program started; its own colours where they are high contrast",
                    ThemeChoice::System},
                   {"Dark theme", "Dark panels round the view", ThemeChoice::Dark},
                   {"Light theme", "Light panels round the view", ThemeChoice::Light}};
    for (const auto& c : choices) {
        auto* a = make(c.text, "", "", c.tip, [this, choice = c.choice] {
            chooseTheme(*qApp, choice);
            s_.view.options.theme = currentTheme();
            s_.view.touch();
            if (themeChanged) themeChanged();
        });
        a->setCheckable(true);
        a->setChecked(themeChoice() == c.choice);
        themeGroup->addAction(a);
        themes << a;
    }
    reducedMotion = make("Reduced motion", "", "", "The camera jumps in place of flying; nothing turns by itself",
                         [] { setReducedMotion(!mw::reducedMotion()); });
    reducedMotion->setCheckable(true);
    reducedMotion->setChecked(mw::reducedMotion());
    makeTools();
    makeViews();
}

void Actions::makeTools()
{
    Session& s = s_;
    auto* group = new QActionGroup(window_);
    const struct {
        const char *text, *icon, *key, *tip;
    } kinds[] = {{"Select", "select", "Q; Esc", "Click picks, drag orbits, Shift+drag boxes, Ctrl+Shift+drag draws a lasso"},
                 {"Box select", "box", "B", "Drag a box over what is to be selected"},
                 {"Lasso select", "lasso", "L", "Draw round what is to be selected"},
                 {"Move", "move", "W", "Drag an arrow, a plane or the middle; numbers can be typed while dragging (metres)"},
                 {"Rotate", "rotate", "E", "Drag a ring; numbers can be typed while dragging (degrees)"},
                 {"Scale", "scale", "R", "Drag a handle, or the middle for all axes; factors can be typed while dragging"},
                 {"Measure", "measure", "D", "Click two points for their distance, a third for angle and area"},
                 {"Brush", "brush", "M", "Drag paints on terrains"},
                 {"Collapse", "edge", "O", "Point at an edge: where it would go, or why it stays; a click collapses it"},
                 {"Cut", "cut", "K", "Click vertices: the mesh is opened along the shortest way from one to the next; Enter cuts"}};
    for (const auto& k : kinds) {
        const auto tool = ToolKind(tools.size());
        auto* a = make(
            k.text, k.icon, k.key, k.tip,
            [this, &s, tool] {
                if (tool != ToolKind::Select || !viewport().abortDrag()) s.view.take(tool);
                tools[int(s.view.tool)]->setChecked(true);
            },
            true);
        a->setCheckable(true);
        group->addAction(a);
        tools << a;
    }
    tools[0]->setChecked(true);
    QObject::connect(&s.view, &ViewState::toolChanged, window_, [this, &s] { tools[int(s.view.tool)]->setChecked(true); });
}

Viewport& Actions::viewport() const
{
    return views_.active();
}

void Actions::makeViews()
{
    const auto splitInto = [this](int count) { views_.split(count); };
    oneView = make("One view", "", "", "Close all views but the first", [splitInto] { splitInto(1); });
    split = make("Two views", "split", "Ctrl+Alt+Q", "Two views side by side, each with its own shading, colours and level; again: one view",
                 [this, splitInto] { splitInto(views_.count() == 2 ? 1 : 2); });
    split->setCheckable(true);
    fourViews = make("Four views", "", "", "Four views, each with its own camera once they are not linked", [splitInto] { splitInto(4); });
    linkCameras = make("Link cameras", "link", "", "Turning one view turns the others", [this] {
        s_.view.linked = !s_.view.linked;
        s_.view.touch();
    });
    linkCameras->setCheckable(true);
    compareBase = make("Compare base and result", "split", "", "Two linked views: the result on the left, the base mesh on the right",
                       [this] { views_.compareWithBase(edits::activeMesh(s_.document)); });
    compareVariants =
        make("Variants of the last modifier", "split", "", variantsTip, [this] { views_.compareVariants(edits::activeMesh(s_.document)); });
    localAxes = make("Local axes", "", "", "Handles along the axes of the node; else along those of the world", [this] {
        s_.view.localAxes = !s_.view.localAxes;
        s_.view.touch();
    });
    pivotCentre = make("Pivot in the middle of the selection", "", "",
                       "Turn and scale about the middle of what is selected; else each about its own origin", [this] {
                           s_.view.pivotCentre = !s_.view.pivotCentre;
                           s_.view.touch();
                       });
    for (QAction* a : {localAxes, pivotCentre}) a->setCheckable(true);
    copyMeasurement = make("Copy measurement", "copy", "", "What is measured, as text \u00b7 Ctrl+C while measuring", [this] {
        const QString text = static_cast<MeasureTool&>(viewport().tool(ToolKind::Measure)).copyText();
        if (!text.isEmpty()) QApplication::clipboard()->setText(text);
    });
}

}  // namespace mw
