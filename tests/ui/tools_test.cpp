// What tools and views say and show beyond where the pointer is: measures, refusals, errors against the base, linked views, a large mesh.
#include <QAbstractButton>
#include <QFile>
#include <QLabel>

#include "tests/ui/thread_time.h"
#include "tests/ui/tool_fixture.h"
#include "ui/stack_edits.h"
#include "ui/view_area.h"
#include "ui/viewport/collapse_tool.h"
#include "ui/viewport/measure_tool.h"

using namespace mw;

class ToolsTest : public QObject, protected ToolFixture {
    Q_OBJECT

private slots:
    void init() { showWindow(1100, 700); }
    void cleanup() { w_.reset(); }

    // A ball whose texture coordinates are x and y, and a small box in front of it: what is carried is mixed, the second point knows the first's
    // surface.
    void measuresWhatASurfaceCarriesAndHowFarItIs()
    {
        const Mesh ball = icosphere(4);
        Array<float> uv;
        for (const glm::vec3& v : ball.positions()) uv.insert(uv.end(), {v.x, v.y});
        Scene s = sceneOf(ball.with(floatAttribute("texcoord", Domain::Vertex, 2, uv)), "ball");
        MeshObject box;
        box.base = std::get<Mesh>(apply(operation("box"), {}, {{"width", 0.4}, {"height", 0.4}, {"depth", 0.4}}));
        Node n;
        n.name = "box";
        n.local.translation = {3, 0.5, 0};
        n.mesh = s.add(std::move(box));
        s.add(n);
        open(std::move(s));
        session().view.colourBy = "vertex-valence";
        session().view.touch();
        QTRY_VERIFY_WITH_TIMEOUT(view().frame().objects.at(0).heat && view().frame().objects.at(1).heat, 10000);
        QTest::keyClick(&view(), Qt::Key_D);
        auto& tool = static_cast<MeasureTool&>(view().tool(ToolKind::Measure));
        const glm::dvec3 eye = view().look().camera.eye();
        const glm::dvec3 aim = 0.5 * ball.bounds().size().x * glm::normalize(eye - glm::dvec3(0)) * 0.999;
        QTest::mouseClick(&view(), Qt::LeftButton, {}, point(pixelOf(aim)));
        QCOMPARE(tool.points().size(), size_t(1));
        const MeasuredPoint first = tool.points()[0];
        QVERIFY(first.corners.x != none);
        const auto carried = [&](const QString& title) {
            for (const auto& [name, value] : first.carried)
                if (name == title) return value;
            return QString();
        };
        const QStringList texture = carried("Texture").replace(QChar(0x2212), '-').split(", ");
        QCOMPARE(texture.size(), 2);
        QVERIFY(std::abs(texture[0].toDouble() - first.at.x) < 1e-3);
        QVERIFY(std::abs(texture[1].toDouble() - first.at.y) < 1e-3);
        const double valence = carried("valence").toDouble();
        QVERIFY(valence >= 5 && valence <= 6);
        QTest::mouseClick(&view(), Qt::LeftButton, {}, point(pixelOf({3, 0.5, 0})));
        QCOMPARE(tool.points().size(), size_t(2));
        const glm::dvec3 second = tool.points()[1].at;
        const QString said = tool.copyText();
        const double surface = said.section("to surface\t", 1, 1).section('\n', 0, 0).toDouble();
        const double radius = glm::length(glm::dvec3(ball.positions()[0]));
        QVERIFY2(std::abs(surface - (glm::length(second) - radius)) < 0.01 * radius, qPrintable(said));
        QVERIFY(tool.report().contains("to the surface of the first"));
        QVERIFY(said.contains("to plane"));
    }

    // The tables of a large mesh are made by a job; the edge under the pointer is judged when they are there.
    void preparesALargeMeshForCollapses()
    {
        openSphere(6);
        QTest::keyClick(&view(), Qt::Key_O);
        auto& tool = static_cast<CollapseTool&>(view().tool(ToolKind::Collapse));
        hoverAt(point(pixelOf({0, 0, 0})));
        QTRY_VERIFY(tool.hovered().has_value());
        QVERIFY(tool.hovered()->preparing && tool.hint({}).startsWith("Preparing"));
        QTRY_VERIFY_WITH_TIMEOUT(!tool.hovered()->preparing, 20000);
        QVERIFY(tool.hovered()->legal);
        QTest::keyClick(&view(), Qt::Key_Q);
    }

    void saysWhyAnEdgeStays()
    {
        const Mesh solid =
            Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, Array<uint32_t>{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
        open(sceneOf(solid, "tetrahedron"));
        const MeshId id = document().scene().meshes().front();
        QTest::keyClick(&view(), Qt::Key_O);
        auto& tool = static_cast<CollapseTool&>(view().tool(ToolKind::Collapse));
        const QPoint at = point(pixelOf({0.5, 0.5, 0}));
        hoverAt(at);
        QTRY_VERIFY(tool.hovered().has_value());
        QVERIFY(!tool.hovered()->legal);
        QVERIFY(!tool.hovered()->reason.isEmpty());
        QVERIFY(tool.cursor() == Qt::ForbiddenCursor);
        QTest::mouseClick(&view(), Qt::LeftButton, {}, at);
        QVERIFY(document().scene().find(id)->stack.empty());
        QTest::keyClick(&view(), Qt::Key_Q);
    }

    // Error against the base: the row of the modifiers says it, its button shows it.
    void showsTheErrorAgainstTheBase()
    {
        openSphere(4);
        const MeshId id = document().scene().meshes().front();
        document().select({{firstNode()}, {}, {}});
        edits::addModifier(document(), id, operation("decimate-quadric"), {{"ratio", 0.05}});
        settle();
        auto* text = w_->findChild<QLabel*>("baseErrorText");
        QVERIFY(text);
        QTRY_VERIFY_WITH_TIMEOUT(text->text().contains("Hausdorff"), 10000);
        auto* show = w_->findChild<QAbstractButton*>("showBaseError");
        QVERIFY(show);
        show->click();
        QCOMPARE(session().view.colourBy, QString("distance"));
        QTRY_VERIFY_WITH_TIMEOUT(view().frame().objects.at(0).heat != nullptr, 10000);
        const Table& t = *view().frame().objects[0].heat->table;
        QCOMPARE(t.columns[0].values.size(), document().shownMesh(id).vertexCount());
        show->click();
        QVERIFY(session().view.colourBy.isEmpty());
    }

    void twoViewsShareSceneAndSelection()
    {
        openSphere();
        edits::addModifier(document(), document().scene().meshes().front(), operation("subdivide-loop"), {{"levels", int64_t(1)}});
        settle();
        ViewArea& area = w_->views();
        area.compareWithBase(document().scene().meshes().front());
        QCOMPARE(area.count(), 2);
        Viewport &left = area.at(0), &right = area.at(1);
        QTRY_VERIFY(right.framesDrawn() > 0);
        QCOMPARE(left.frame().objects.at(0).mesh.faceCount(), size_t(4 * 1280));
        QCOMPARE(right.frame().objects.at(0).mesh.faceCount(), size_t(1280));
        // Orbiting one turns the other, while they are linked.
        const auto orbit = [](Viewport& v) {
            const QPoint from(v.width() - 12, v.height() - 12), to = from - QPoint(60, 0);
            QTest::mouseMove(&v, from);
            QTest::mousePress(&v, Qt::MiddleButton, {}, from);
            for (int i = 1; i <= 4; ++i) {
                const QPoint at = from + (to - from) * i / 4;
                QMouseEvent e(QEvent::MouseMove, at, v.mapToGlobal(at), Qt::NoButton, Qt::MiddleButton, Qt::NoModifier);
                QApplication::sendEvent(&v, &e);
            }
            QTest::mouseRelease(&v, Qt::MiddleButton, {}, to);
        };
        const double before = left.look().camera.azimuth;
        orbit(right);
        QCOMPARE(session().view.activeView(), 1);
        QVERIFY(std::abs(left.look().camera.azimuth - before) > 0.05);
        QCOMPARE(left.look().camera.azimuth, right.look().camera.azimuth);
        session().view.linked = false;
        const double still = left.look().camera.azimuth;
        orbit(right);
        QCOMPARE(left.look().camera.azimuth, still);
        QVERIFY(right.look().camera.azimuth != still);
        // Shading of the active one alone; the panels speak to it.
        session().view.options.shading = Shading::Flat;
        session().view.touch();
        QVERIFY(right.look().options.shading == Shading::Flat && left.look().options.shading == Shading::Smooth);
        // A click in one selects in both.
        session().view.pickKind = PickKind::Object;
        document().select({});
        left.click({left.width() / 2.0, left.height() / 2.0}, {});
        QCOMPARE(document().selection().nodes.size(), size_t(1));
        QVERIFY(left.frame().objects[0].selected && right.frame().objects[0].selected);
        area.split(1);
        QCOMPARE(area.count(), 1);
        QCOMPARE(session().view.activeView(), 0);
        QVERIFY(session().view.options.shading == Shading::Smooth);
        QTest::qWait(50);
        area.split(4);
        for (int i = 0; i < 4; ++i) QTRY_VERIFY(area.at(i).framesDrawn() > 0);
        area.split(1);
    }

    void allOfADragonIsChosenInTime()
    {
        const QString file = qEnvironmentVariable("MESHWRIGHT_DATA") + "/meshes/large/dragon_871k.ply";
        if (!QFile::exists(file)) QSKIP("MESHWRIGHT_DATA is not set");
        w_->files().openScene(readFile(file.toStdString()).scene, "Open");
        QTRY_VERIFY_WITH_TIMEOUT(w_->evaluations().idle() && !session().jobs.busy(), 120000);
        view().frameAll(false);
        QTest::qWait(300);
        session().view.pickKind = PickKind::Face;
        const glm::dvec2 all = view().logicalSize();
        const Region region = [&] {
            Region r;
            r.high = glm::ivec2(all);
            return r;
        }();
        QElapsedTimer clock;
        view().look().camera.azimuth += 0.01;
        clock.start();
        view().pick(0.5 * all);
        const double firstPick = clock.nsecsElapsed() / 1e6;
        clock.restart();
        view().pick(0.5 * all + glm::dvec2(3, 0));
        const double nextPick = clock.nsecsElapsed() / 1e6;
        double begin = threadMilliseconds();
        view().visibleFaces(region);
        const double readBack = threadMilliseconds() - begin;
        begin = threadMilliseconds();
        view().selectBox(view().rect(), {});
        const double box = threadMilliseconds() - begin;
        const size_t chosen = document().selection().elements.indices.size();
        qInfo("dragon: pick after a camera move %.0f ms, next %.1f ms; %zu faces boxed in %.0f ms, reading back %.0f ms of it", firstPick, nextPick,
              chosen, box, readBack);
        QVERIFY(chosen > 30000);
        QVERIFY2(box - readBack < 400, qPrintable(QString::number(box - readBack)));  // of the processor, so that a busy machine does not fail it
    }
};

int main(int argc, char** argv)
{
    return runTests<ToolsTest>(argc, argv);
}

#include "tools_test.moc"
