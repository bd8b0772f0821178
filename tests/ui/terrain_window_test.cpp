// Terrains as a person makes, paints and saves them, proved by the state of the document and by files.
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QMenuBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <functional>

#include "core/io/height_picture.h"
#include "core/io/io.h"
#include "core/scene/edit.h"
#include "tests/ui/window_fixture.h"
#include "ui/file_commands.h"
#include "ui/parameter_form.h"
#include "ui/terrain_edits.h"
#include "ui/viewport/viewport.h"
#include "ui/workspaces.h"

using namespace mw;

class TerrainWindowTest : public QObject, protected WindowFixture {
    Q_OBJECT

private:
    NodeId node() { return edits::activeTerrain(document()); }
    const Terrain& terrain() { return edits::terrainOf(document(), node())->terrain; }

    // 257 x 257 by diamond-square.
    void makeTerrain()
    {
        const EditCall make{"new-terrain", {{"op", std::string("diamond-square")}, {"with", std::string("size=257,seed=3")}}};
        w_->files().openScene(drawnCoarsely(edited(Scene(), make)), "Open terrain");
        settle();
        QVERIFY(node());
        w_->workspaces().change("Terrain");
        view().frameAll(false);
        QTest::qWait(100);
    }
    QPoint pixelOf(double x, double z)
    {
        const glm::dvec3 p = w_->session().view.camera.project({x, terrain().heightAt(x, z), z}, {view().width(), view().height()});
        return {int(p.x), int(p.y)};
    }
    void stroke(QPoint from, QPoint to, Qt::KeyboardModifiers m = {})
    {
        QTest::mousePress(&view(), Qt::LeftButton, m, from);
        for (int i = 1; i <= 4; ++i) QTest::mouseMove(&view(), from + (to - from) * i / 4);
        QTest::mouseRelease(&view(), Qt::LeftButton, m, to);
    }
    static double sum(const HeightMap& map)
    {
        double s = 0;
        for (const float h : map.rows()) s += double(h);
        return s;
    }
    static size_t changedTiles(const HeightMap& a, const HeightMap& b)
    {
        size_t n = 0;
        for (uint32_t y = 0; y < a.tilesY(); ++y)
            for (uint32_t x = 0; x < a.tilesX(); ++x) n += a.tile(x, y).id() != b.tile(x, y).id();
        return n;
    }

private slots:
    void init() { showWindow(1280, 800); }
    void cleanup() { w_.reset(); }

    void emptyPanelsOfferATerrain()
    {
        w_->workspaces().change("Terrain");
        for (const char* id : {"painter", "terrain", "generators"}) {
            QWidget* panel = w_->workspaces().dock(id)->widget();
            QVERIFY2(panel, id);
            bool offered = false;
            for (QPushButton* b : panel->findChildren<QPushButton*>()) offered |= b->isVisibleTo(panel) && b->text() == "New terrain";
            QVERIFY2(offered, id);
        }
        QVERIFY(!action("Terrain to mesh")->isEnabled());
        action("New terrain")->trigger();
        settle();
        QCOMPARE(document().scene().terrains().size(), size_t(1));
        QCOMPARE(terrain().map.width(), 1025u);
        QCOMPARE(document().selection().active(), node());
        QVERIFY(action("Terrain to mesh")->isEnabled());
    }

    void generates()
    {
        makeTerrain();
        const HeightMap before = terrain().map;
        const size_t entries = document().history().size();
        QWidget* panel = w_->workspaces().dock("generators")->widget();
        auto* choice = panel->findChild<QComboBox*>("generator");
        const auto sources = edits::heightSources();
        QVERIFY(sources.size() >= 2);
        for (size_t i = 0; i < sources.size(); ++i)
            if (sources[i]->id == "perlin") choice->setCurrentIndex(int(i));
        QTest::mouseClick(panel->findChild<QPushButton*>("generate"), Qt::LeftButton);
        settle();
        QCOMPARE(document().history().size(), entries + 1);  // one entry
        QCOMPARE(edits::terrainOf(document(), node())->sourceOperation, std::string("perlin"));
        QVERIFY(contentHash(terrain().map) != contentHash(before));
        document().undo();
        QCOMPARE(contentHash(terrain().map), contentHash(before));
    }

    void paintsAndUndoesByStroke()
    {
        makeTerrain();
        w_->session().view.brush.radius = 60;
        const HeightMap before = terrain().map;
        const size_t entries = document().history().size();
        QVERIFY(w_->session().view.tool == ToolKind::Brush);  // the workspace's tool

        stroke(pixelOf(-150, -100), pixelOf(-120, -90));
        QCOMPARE(document().history().size(), entries + 1);
        QCOMPARE(QString::fromStdString(document().history().back().name), QString("Terrain: raise"));
        const HeightMap raised = terrain().map;
        QVERIFY(sum(raised) > sum(before));
        QVERIFY(changedTiles(before, raised) < 9);  // of 3 x 3

        stroke(pixelOf(100, 100), pixelOf(130, 110), Qt::ControlModifier);
        QCOMPARE(QString::fromStdString(document().history().back().name), QString("Terrain: lower"));
        QVERIFY(sum(terrain().map) < sum(raised));

        document().undo();
        QCOMPARE(changedTiles(terrain().map, raised), size_t(0));
        document().undo();
        QCOMPARE(changedTiles(terrain().map, before), size_t(0));
        document().redo();
        QCOMPARE(changedTiles(terrain().map, raised), size_t(0));
    }

    void escapeTakesAStrokeBack()
    {
        makeTerrain();
        const HeightMap before = terrain().map;
        const size_t entries = document().history().size();
        const QPoint at = pixelOf(0, 0);
        QTest::mousePress(&view(), Qt::LeftButton, {}, at);
        QTest::mouseMove(&view(), at + QPoint(20, 5));
        QVERIFY(changedTiles(terrain().map, before) > 0);
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_Escape);
        QCOMPARE(changedTiles(terrain().map, before), size_t(0));
        QVERIFY(w_->session().view.tool == ToolKind::Brush);  // the first Esc ends the stroke, not the tool
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, at + QPoint(20, 5));
        QCOMPARE(document().history().size(), entries);
    }

    void besideTheGroundADragOrbits()
    {
        makeTerrain();
        const size_t entries = document().history().size();
        const double azimuth = w_->session().view.camera.azimuth;
        stroke({20, view().height() - 20}, {120, view().height() - 20});
        QCOMPARE(document().history().size(), entries);
        QVERIFY(std::abs(w_->session().view.camera.azimuth - azimuth) > 0.1);
    }

    void keysOfTheBrush()
    {
        makeTerrain();
        view().setFocus();
        Brush& b = w_->session().view.brush;
        b.radius = 100;
        b.strength = 0.5;
        QTest::keyClick(&view(), Qt::Key_BracketRight);
        QVERIFY(std::abs(b.radius - 110) < 1e-9);
        QTest::keyClick(&view(), Qt::Key_BracketLeft);
        QVERIFY(std::abs(b.radius - 100) < 1e-9);
        QTest::keyClick(&view(), Qt::Key_Q);
        QVERIFY(w_->session().view.tool != ToolKind::Brush);
        QTest::keyClick(&view(), Qt::Key_M);
        QVERIFY(w_->session().view.tool == ToolKind::Brush);
    }

    void waterLevelIsOneEntry()
    {
        makeTerrain();
        const size_t entries = document().history().size();
        auto* form = w_->workspaces().dock("terrain")->widget()->findChild<ParameterForm*>("groundForm");
        auto* box = qobject_cast<NumberBox*>(form->field("waterLevel"));
        box->setValue(40);
        QCOMPARE(document().history().size(), entries + 1);
        QCOMPARE(terrain().waterLevel, 40.0);
        QCOMPARE(QString::fromStdString(document().undoName()), QString("Terrain: water level 40 m"));
    }

    void thePatchUnderThePointerIsTold()
    {
        makeTerrain();
        QTest::mouseMove(&view(), pixelOf(40, 50));  // the first one enters the view
        QTest::qWait(50);
        QTest::mouseMove(&view(), pixelOf(50, 60));
        QTRY_VERIFY(w_->session().view.ground.has_value());
        const auto& g = *w_->session().view.ground;
        QCOMPARE(g.node, node());
        QVERIFY(std::abs(g.local.y - terrain().heightAt(g.local.x, g.local.z)) < 1e-6);
        QVERIFY(g.level >= 4 && g.level <= 16);
    }

    void exportsPictureAndMesh()
    {
        makeTerrain();
        QString said = "?";
        edits::exportPicture(w_->session(), node(), path("out.png"), [&](const QString& text) { said = text; });
        settle();
        QCOMPARE(said, QString());
        const HeightMap back = readHeightMap(path("out.png").toStdString());
        QCOMPARE(back.width(), 257u);
        for (uint32_t y = 0; y < 257; y += 16)
            for (uint32_t x = 0; x < 257; x += 16) QVERIFY(std::abs(back.at(x, y) - std::clamp(terrain().map.at(x, y), 0.f, 1.f)) <= 0.51f / 65535);
        edits::terrainToMesh(w_->session(), node(), 5000);
        settle();
        QCOMPARE(document().scene().meshes().size(), size_t(1));
        const Mesh& mesh = document().scene().find(document().scene().meshes().front())->base;
        QVERIFY(mesh.faceCount() > 2000 && mesh.faceCount() <= 5000);
    }

    void importsAPicture()
    {
        makeTerrain();
        std::vector<float> ramp;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) ramp.push_back(float(x) / 63);
        writeHeightMap(HeightMap(64, 64, ramp), path("ramp.png").toStdString());
        edits::importPicture(w_->session(), path("ramp.png"), false, [](const QString&) {});
        settle();
        QCOMPARE(terrain().map.width(), 64u);
        QVERIFY(std::abs(terrain().map.at(63, 5) - 1) < 1e-4);
        QCOMPARE(document().scene().terrains().size(), size_t(1));
        QString said;
        edits::importPicture(w_->session(), path("absent.png"), false, [&](const QString& text) { said = text; });
        settle();
        QVERIFY(said.contains("absent.png"));
        QCOMPARE(terrain().map.width(), 64u);
    }

    void projectKeepsTheMap()
    {
        makeTerrain();
        stroke(pixelOf(-150, -100), pixelOf(-120, -90));
        const uint64_t content = contentHash(terrain());
        QSignalSpy saved(&w_->files(), &FileCommands::notice);
        w_->files().saveTo(path("painted.glb"));
        QVERIFY(saved.wait(60000));
        QSignalSpy opened(&w_->files(), &FileCommands::opened);
        w_->files().open(path("painted.glb"));
        QVERIFY(opened.wait(60000));
        settle();
        QVERIFY(node());
        QCOMPARE(contentHash(terrain()), content);
    }

    void nothingIsDrawnWhileNothingHappens()
    {
        makeTerrain();
        settleView();
        const size_t drawn = view().framesDrawn();
        QTest::qWait(500);
        QCOMPARE(view().framesDrawn(), drawn);
    }
};

int main(int argc, char** argv)
{
    return runTests<TerrainWindowTest>(argc, argv);
}

#include "terrain_window_test.moc"
