// Pictures of what belongs to the window itself (welcome, every workspace, sheets, search, shortcuts) in both themes, to be looked at beside
// the design: MESHWRIGHT_PICTURES=FOLDER tests/ui/run_xvfb.sh build/bin/ui_window_pictures [NAME...]
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QTest>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "core/mesh/select.h"
#include "core/scene/samples.h"
#include "ui/actions.h"
#include "ui/application.h"
#include "ui/drop_target.h"
#include "ui/evaluation_service.h"
#include "ui/file_commands.h"
#include "ui/main_window.h"
#include "ui/panels/record_tables.h"
#include "ui/sheet.h"
#include "ui/stack_edits.h"
#include "ui/theme.h"
#include "ui/viewport/viewport.h"
#include "ui/workspaces.h"

using namespace mw;

namespace {

void settle(MainWindow& w)
{
    QElapsedTimer clock;
    clock.start();
    QTest::qWait(300);
    while ((!w.evaluations().idle() || w.session().jobs.busy()) && clock.elapsed() < 60000) QTest::qWait(50);
    QTest::qWait(400);
}

// The window, and what floats over it.
void shoot(MainWindow& w, const QString& folder, const QString& name)
{
    QImage picture = w.grab().toImage();
    QPainter p(&picture);
    for (QWidget* top : QApplication::topLevelWidgets())
        if (top != &w && top->isVisible()) {
            QPixmap part = top->grab();
            p.drawPixmap(w.mapFromGlobal(top->pos()), part);
        }
    p.end();
    const QString theme = currentTheme() == Theme::Dark ? "dark" : "light";
    picture.save(QString("%1/%2-%3-%4x%5.png").arg(folder, name, theme).arg(w.width()).arg(w.height()));
    std::printf("%s\n", qPrintable(name));
}

void closePopups(MainWindow& w)
{
    for (QWidget* top : QApplication::topLevelWidgets())
        if (top != &w && top->isVisible()) top->close();
    QTest::qWait(50);
}

QAction* command(MainWindow& w, const QString& text)
{
    for (QAction* a : w.findChildren<QAction*>())
        if (a->text() == text) return a;
    qFatal("no command %s", qPrintable(text));
}

// The Records panel at a half-edge, at the answer of a query, at a triangle-adjacency primitive.
void shootRecords(MainWindow& w, const QString& folder)
{
    Document& document = w.session().document;
    Scene scene;
    MeshObject object;
    object.name = "Ball";
    object.base = std::get<Mesh>(apply(operation("damaged-sphere"), std::monostate{}, {{"subdivisions", int64_t(2)}, {"turned", 0.}}));
    Node n;
    n.name = "Ball";
    n.mesh = scene.add(object);
    const NodeId node = scene.add(n);
    document.open(scene, {}, "New");
    w.session().view.options.wireOverlay = true;
    w.session().view.options.shading = Shading::Flat;
    auto* dock = w.findChild<QDockWidget*>("dock-records");
    dock->show();
    dock->raise();
    settle(w);
    const ElementSet border = boundary(object.base, ElementKind::Edge);
    const uint32_t vertex = border.indices[0];
    Camera& camera = w.session().view.camera;
    const glm::vec3 at = object.base.positions()[vertex];
    camera.azimuth = std::atan2(at.x, at.z) + 0.3;
    camera.elevation = std::asin(at.y / glm::length(at)) + 0.2;
    camera.distance *= 0.45;
    camera.target = glm::dvec3(0.6f * at);
    w.session().view.pickKind = PickKind::Edge;
    const ElementSet edges = converted(object.base, grown(object.base, {ElementKind::Vertex, {vertex}}), ElementKind::Edge);
    const std::pair<RecordDrawing, int> states[] = {{RecordDrawing::Halfedge, -1},
                                                    {RecordDrawing::WingedEdge, -1},
                                                    {RecordDrawing::FaceBased, -1},
                                                    {RecordDrawing::Primitive, -1},
                                                    {RecordDrawing::Answer, 4}};
    for (const auto& [drawing, query] : states) {
        if (drawing == RecordDrawing::Primitive)
            document.select(
                {{node}, node, converted(object.base, {ElementKind::Edge, {border.indices[0], border.indices[1]}}, ElementKind::Face, true)});
        else
            document.select({{node}, node, {ElementKind::Edge, {edges.indices[2], edges.indices[3]}}});
        auto* combo = w.findChild<QComboBox*>("records-drawing");
        if (query >= 0) w.findChild<QPushButton*>(QString("records-query-%1").arg(query))->click();
        combo->setCurrentIndex(int(drawing));
        emit combo->activated(int(drawing));
        settle(w);
        shoot(w, folder, QString("records-%1").arg(int(drawing)));
        camera.distance *= 6;  // a small element
        w.session().view.touch();
        settle(w);
        shoot(w, folder, QString("records-%1-far").arg(int(drawing)));
        camera.distance /= 6;
    }
}

void tour(MainWindow& w, const QString& folder, const QStringList& only)
{
    const auto wanted = [&](const char* name) { return only.isEmpty() || only.contains(name); };
    w.showWelcome();
    settle(w);
    if (wanted("welcome")) shoot(w, folder, "welcome");
    w.files().openScene(samples().front().make(), "Open Blossom");
    const MeshId mesh = edits::activeMesh(w.session().document);
    edits::addModifier(w.session().document, mesh, operation("decimate-quadric"), {{"ratio", 0.2}});
    settle(w);
    for (const QString& name : Workspaces::names())
        if (wanted("workspaces")) {
            w.workspaces().change(name);
            settle(w);
            shoot(w, folder, "workspace-" + name.toLower());
        }
    w.workspaces().change("Mesh");
    if (wanted("records")) shootRecords(w, folder);
    if (wanted("sheets")) {
        for (const char* name : {"Search commands and settings", "Save layout as workspace...", "Export...", "Shortcuts...", "Keyboard reference"}) {
            command(w, name)->trigger();
            QTest::qWait(200);
            if (auto* query = w.findChild<QLineEdit*>("searchQuery")) query->setText("sub");
            QTest::qWait(100);
            shoot(w, folder, "sheet-" + QString(name).left(6).toLower());
            closePopups(w);
            for (Sheet* s : w.findChildren<Sheet*>()) delete s;
        }
        DropFrame frame(&w);
        frame.showOn(QRect(w.viewport().mapTo(&w, QPoint(0, 0)), w.viewport().size()), "Add bunny.ply");
        shoot(w, folder, "drop");
    }
}

}  // namespace

int main(int argc, char** argv)
{
    const QString folder = qEnvironmentVariable("MESHWRIGHT_PICTURES", "pictures");
    QDir().mkpath(folder);
    prepareApplication();
    QApplication app(argc, argv);
    if (const int percent = qEnvironmentVariableIntValue("MESHWRIGHT_TEXT_PERCENT")) {
        QFont font = app.font();
        font.setPointSizeF(font.pointSizeF() * percent / 100);
        app.setFont(font);
    }
    dressApplication(app);
    const QStringList only = app.arguments().mid(1);
    for (const QSize& size : {QSize(1600, 1000), QSize(1280, 800)}) {
        MainWindow w;
        w.resize(size);
        w.show();
        if (!QTest::qWaitForWindowExposed(&w)) return 1;
        tour(w, folder, only);
        command(w, "Light theme")->trigger();  // live: what was built in the dark is looked at in the light
        settle(w);
        tour(w, folder, only);
        command(w, "Dark theme")->trigger();
    }
    return 0;
}
