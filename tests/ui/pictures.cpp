// Saves pictures of the window in its typical states into the folder MESHWRIGHT_PICTURES, to be looked at beside the design. An
// argument, "characters", "steps", "terrain" or "tools", asks for those alone.
#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QTest>
#include <cstdio>

#include "core/scene/samples.h"
#include "ui/application.h"
#include "ui/evaluation_service.h"
#include "ui/file_commands.h"
#include "ui/main_window.h"
#include "ui/playback.h"
#include "ui/stack_edits.h"
#include "ui/steps/step_player.h"
#include "ui/terrain_edits.h"
#include "ui/theme.h"
#include "ui/view_area.h"
#include "ui/viewport/transform_tool.h"
#include "ui/viewport/viewport.h"
#include "ui/workspaces.h"

using namespace mw;

namespace {

void settle(MainWindow& w)
{
    QElapsedTimer clock;
    clock.start();
    QTest::qWait(300);
    while ((!w.evaluations().idle() || w.session().jobs.busy() || w.session().steps.seeking()) && clock.elapsed() < 120000) QTest::qWait(50);
    QTest::qWait(500);
}

void shoot(MainWindow& w, const QString& folder, const QString& name)
{
    const QSize size = w.size();
    const QString file = QString("%1/%2-%3x%4.png").arg(folder, name).arg(size.width()).arg(size.height());
    w.grab().save(file);
    std::printf("%s\n", qPrintable(file));
}

void heat(MainWindow& w, const char* query)
{
    w.session().view.colourBy = query;
    w.session().view.touch();
    settle(w);
}

void drag(Viewport& view, QPoint from, QPoint to, Qt::KeyboardModifiers m = {})
{
    QTest::mousePress(&view, Qt::LeftButton, m, from);
    for (int i = 1; i <= 6; ++i) QTest::mouseMove(&view, from + (to - from) * i / 6);
    QTest::mouseRelease(&view, Qt::LeftButton, m, to);
}

/// A terrain from a picture of mountains when there is one, painted by hand.
void terrainTour(MainWindow& w, const QString& folder, const QString& name)
{
    Session& s = w.session();
    w.files().openScene(Scene(), "New scene");
    const QString mountains = qEnvironmentVariable("MESHWRIGHT_DATA") + "/terrain/MtCook.tga";
    if (QFile::exists(mountains))
        edits::importPicture(s, mountains, true, [](const QString&) {});
    else
        edits::newTerrain(s);
    settle(w);
    w.workspaces().change("Terrain");
    const NodeId node = edits::activeTerrain(s.document);
    Terrain t = edits::terrainOf(s.document, node)->terrain;
    t.waterLevel = 18.4;
    edits::commitTerrain(s.document, node, t, "water level 18.4 m");
    QTest::qWait(1500);  // the flight to the new terrain ends
    s.view.camera.azimuth = 0.15;
    s.view.camera.elevation = 0.5;
    s.view.camera.distance = 520;
    s.view.camera.target = {-20, 40, 60};
    s.view.groundOverlay = DrawTerrain::Overlay::PatchBorders;
    s.view.touch();
    settle(w);
    Viewport& view = w.viewport();
    const QPoint middle(view.width() / 2, view.height() / 2);
    drag(view, middle + QPoint(-150, 60), middle + QPoint(-60, 100));
    drag(view, middle + QPoint(150, 80), middle + QPoint(220, 60), Qt::ControlModifier);
    QTest::mouseMove(&view, middle + QPoint(-60, 90));
    settle(w);
    shoot(w, folder, name);
    w.workspaces().change("Mesh");
}

void tour(MainWindow& w, const QString& folder, const QString& dragon)
{
    w.showWelcome();
    settle(w);
    shoot(w, folder, "welcome");
    if (!dragon.isEmpty()) {
        w.files().open(dragon);
        settle(w);
        shoot(w, folder, "dragon");
        heat(w, "vertex-valence");
        shoot(w, folder, "heat");
        heat(w, "");
    }
    w.files().openScene(samples().front().make(), "Open Blossom");
    settle(w);
    const MeshId mesh = edits::activeMesh(w.session().document);
    edits::addModifier(w.session().document, mesh, operation("decimate-quadric"), {{"ratio", 0.2}});
    settle(w);
    w.session().steps.open(operation("decimate-quadric"), w.session().document.selection().active(), w.session().document.scene().find(mesh)->base,
                           checked(operation("decimate-quadric").parameters, {{"ratio", 0.2}}));
    settle(w);
    w.session().steps.seek(420);
    settle(w);
    w.viewport().frameAll(false);
    settle(w);
    shoot(w, folder, "stepping");
    w.session().steps.close();
    w.workspaces().change("Mesh");
}

/// What moves, in the workspace made for it.
void characters(MainWindow& w, const QString& folder, const QString& data)
{
    const struct {
        const char *file, *name;
        double part;  // of the clip
        bool playing;
    } all[] = {{"characters/cesium_man.gltf", "cesium", 0.3, false},
               {"characters/pab_arnaud.fbx", "arnaud", 0.4, false},
               {"characters/robot.glb", "robot", 0.5, true},
               {"bvh/Dance.bvh", "dancer", 0.35, false},
               {"gltf/AnimatedMorphCube/AnimatedMorphCube.gltf", "morph", 0.25, false}};
    w.workspaces().change("Character");
    for (const auto& one : all) {
        if (!QFile::exists(data + "/" + one.file)) continue;
        w.files().open(data + "/" + one.file);
        settle(w);
        Playback& play = *w.session().playback;
        play.setTime(one.part * play.end());
        w.viewport().frameAll(false);
        if (one.playing) play.play();
        settle(w);
        shoot(w, folder, one.name);
        play.pause();
    }
    for (const Sample& s : samples()) {
        if (QString(s.id) != "mannequin") continue;
        w.files().openScene(s.make(), "Open Mannequin");
        w.session().playback->setTime(0.3 * w.session().playback->end());
        const Scene& scene = w.session().document.scene();
        std::vector<NodeId> joints;
        for (const NodeId id : scene.nodes())
            if (scene.node(id).joint == Node::Joint::Joint) joints.push_back(id);
        if (joints.size() > 6) w.session().document.select({{joints[6]}, {}, {}});
        settle(w);
        w.viewport().frameAll(false);
        settle(w);
        shoot(w, folder, s.id);
    }
}

// Labs, and a solver on a character's arm.
void stepTour(MainWindow& w, const QString& folder, const QString& character)
{
    for (const char* id : {"fabrik", "ccd", "subdivide-curve", "interpolate-rotation", "diamond-square"}) {
        w.session().document.select({});
        stepThrough(w.session(), operation(id));
        settle(w);
        w.session().steps.seek(id == std::string("interpolate-rotation") ? 60 : id == std::string("diamond-square") ? 300 : 8);
        settle(w);
        shoot(w, folder, QString("lab-%1").arg(id));
    }
    w.session().steps.close();
    settle(w);
    shoot(w, folder, "lab-closed");
    if (character.isEmpty()) return;
    w.files().open(character);
    settle(w);
    w.session().document.select({{w.session().document.scene().roots().front()}, {}, {}});
    stepThrough(w.session(), operation("ccd"));
    settle(w);
    w.session().steps.seek(5);
    settle(w);
    shoot(w, folder, "character-ccd");
    w.session().steps.close();
    w.workspaces().change("Mesh");
}

/// Each tool of the view at work.
void toolTour(MainWindow& w, const QString& folder, const QString& data, const QString& theme)
{
    Session& s = w.session();
    Viewport& v = w.viewport();
    w.workspaces().change("Mesh");
    w.files().open(data + "/meshes/closed_genus0/spot.obj");
    settle(w);
    const auto centre = [&] { return glm::dvec2(v.look().camera.project(boundsOf(v.frame()).centre(), v.logicalSize())); };
    const auto at = [](glm::dvec2 p) { return QPoint(int(p.x), int(p.y)); };
    s.document.select({{s.document.scene().roots().back()}, {}, {}});
    for (const auto& [kind, name] : {std::pair{ToolKind::Move, "move"}, {ToolKind::Rotate, "rotate"}, {ToolKind::Scale, "scale"}}) {
        s.view.take(kind);
        QTest::qWait(200);
        shoot(w, folder, QString("tool-%1-%2").arg(name, theme));
        const auto gizmo = static_cast<TransformTool&>(v.tool()).gizmo();
        const Handle& h = gizmo->handles().back();
        const QPoint from = at(kind == ToolKind::Rotate ? h.line[20] : h.line[1]);
        QTest::mouseMove(&v, from + QPoint(1, 0));
        QTest::mouseMove(&v, from);
        QTest::mousePress(&v, Qt::LeftButton, {}, from);
        QTest::mouseMove(&v, from + QPoint(12, -14));
        QTest::mouseMove(&v, from + QPoint(25, -30));
        QTest::qWait(200);
        shoot(w, folder, QString("tool-%1-drag-%2").arg(name, theme));
        v.abortDrag();
        QTest::mouseRelease(&v, Qt::LeftButton, {}, from);
    }
    s.view.pickKind = PickKind::Face;
    s.view.take(ToolKind::Lasso);
    const glm::dvec2 c = centre();
    QTest::mousePress(&v, Qt::LeftButton, {}, at(c + glm::dvec2(90, 0)));
    for (int i = 1; i < 40; ++i) {
        const double a = 0.16 * i, r = 90 + 18 * std::sin(5 * a);
        QMouseEvent e(QEvent::MouseMove, QPointF(at(c + r * glm::dvec2(std::cos(a), std::sin(a)))), v.mapToGlobal(QPointF(0, 0)), Qt::NoButton,
                      Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&v, &e);
    }
    QTest::qWait(200);
    shoot(w, folder, "tool-lasso-drag-" + theme);
    QTest::mouseRelease(&v, Qt::LeftButton, {}, at(c + glm::dvec2(88, -5)));
    s.view.take(ToolKind::Move);
    QTest::qWait(200);
    shoot(w, folder, "tool-elements-" + theme);
    s.view.pickKind = PickKind::Object;
    s.view.take(ToolKind::Measure);
    for (const glm::dvec2 d : {glm::dvec2(-60, 20), {40, -50}, {30, 60}}) QTest::mouseClick(&v, Qt::LeftButton, {}, at(c + d));
    QTest::mouseMove(&v, at(c));
    QTest::qWait(300);
    shoot(w, folder, "tool-measure-" + theme);
    v.abortDrag();
    s.view.take(ToolKind::Select);
    const MeshId mesh = edits::activeMesh(s.document);
    edits::addModifier(s.document, mesh, operation("decimate-quadric"), {{"ratio", 0.1}});
    settle(w);
    w.views().compareWithBase(mesh);
    s.view.options.wireOverlay = true;
    s.view.touch();
    settle(w);
    for (int i = 0; i < 2; ++i) w.views().at(i).frameAll(false);
    settle(w);
    shoot(w, folder, "tool-split-" + theme);
    w.views().split(4);
    settle(w);
    shoot(w, folder, "tool-four-" + theme);
    w.views().split(1);
    s.view.options.wireOverlay = false;
    s.document.select({{s.document.scene().roots().back()}, s.document.scene().roots().back(), {ElementKind::Face, {0, 1, 2}}});
    s.view.take(ToolKind::Move);
    settle(w);
    shoot(w, folder, "tool-why-not-" + theme);
    s.view.take(ToolKind::Select);
    if (!QFile::exists(data + "/characters/cesium_man.gltf")) return;
    w.workspaces().change("Character");
    w.files().open(data + "/characters/cesium_man.gltf");
    settle(w);
    for (const NodeId id : s.document.scene().nodes())
        if (s.document.scene().node(id).joint == Node::Joint::Joint && s.document.scene().node(id).children.size() == 1)
            s.document.select({{id}, {}, {}});
    settle(w);
    shoot(w, folder, "tool-joint-driven-" + theme);
    s.playback->setClip({});
    settle(w);
    shoot(w, folder, "tool-joint-" + theme);
    w.workspaces().change("Mesh");
}

}  // namespace

int main(int argc, char** argv)
{
    const QString folder = qEnvironmentVariable("MESHWRIGHT_PICTURES", "pictures");
    QDir().mkpath(folder);
    prepareApplication();
    QApplication app(argc, argv);
    dressApplication(app);
    QString dragon = qEnvironmentVariable("MESHWRIGHT_DATA") + "/meshes/large/dragon_871k.ply";
    if (!QFile::exists(dragon)) dragon.clear();
    QString character = qEnvironmentVariable("MESHWRIGHT_DATA") + "/characters/cesium_man.gltf";
    if (!QFile::exists(character)) character.clear();
    for (const QSize& size : {QSize(1600, 1000), QSize(1280, 800)}) {
        MainWindow w;
        w.resize(size);
        w.show();
        if (!QTest::qWaitForWindowExposed(&w)) return 1;
        const QString only = argc > 1 ? argv[1] : "";  // "characters", "steps" or "terrain"
        if (only.isEmpty()) tour(w, folder, dragon);
        if (only.isEmpty() || only.startsWith("character")) characters(w, folder, qEnvironmentVariable("MESHWRIGHT_DATA"));
        if (only.isEmpty() || only.startsWith("step")) stepTour(w, folder, character);
        if (only.isEmpty() || only.startsWith("terrain")) terrainTour(w, folder, "terrain");
        if (only.startsWith("tools")) {
            if (size.width() != 1600) break;
            toolTour(w, folder, qEnvironmentVariable("MESHWRIGHT_DATA"), "dark");
            applyTheme(app, Theme::Light);
            MainWindow light;
            light.resize(size);
            light.show();
            if (!QTest::qWaitForWindowExposed(&light)) return 1;
            toolTour(light, folder, qEnvironmentVariable("MESHWRIGHT_DATA"), "light");
            break;
        }
        if (!only.isEmpty() && !only.startsWith("terrain")) continue;
        if (size.width() == 1600) {
            applyTheme(app, Theme::Light);
            MainWindow light;
            light.resize(size);
            light.show();
            if (!QTest::qWaitForWindowExposed(&light)) return 1;
            light.files().openScene(samples().front().make(), "Open Blossom");
            settle(light);
            heat(light, "vertex-valence");
            shoot(light, folder, "light");
            terrainTour(light, folder, "terrain-light");
            applyTheme(app, Theme::Dark);
        }
    }
    return 0;
}
