// Camera, shading, overlays, theme, tools.
#include <QActionGroup>
#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>

#include "ui/viewport/viewport.h"
// epoxy comes before Qt's own OpenGL headers
#include "ui/actions.h"
#include "ui/theme.h"

namespace mw {

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

}  // namespace mw
