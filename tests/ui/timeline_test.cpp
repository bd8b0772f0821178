// The timeline as a person uses it: playing, scrubbing, tracks, clips. The scene is an arm of two joints that bends by 90 degrees in 2 seconds.
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QMenu>
#include <QTest>
#include <QToolButton>
#include <QTreeView>
#include <QWheelEvent>

#include "tests/ui/thread_time.h"
#include "tests/ui/window_fixture.h"
#include "ui/file_commands.h"
#include "ui/panels/timeline_tracks.h"
#include "ui/playback.h"
#include "ui/viewport/viewport.h"
#include "ui/workspaces.h"

using namespace mw;

namespace {

struct Arm {
    Scene scene;
    NodeId upper, lower, mesh;
};

/// A bar from (0, 0, 0) to (0, 2, 0), its upper half bound to the lower joint at (0, 1, 0).
Arm arm()
{
    Arm a;
    Array<glm::vec3> p;
    Array<int32_t> jointSlots;
    Array<float> weights;
    for (int i = 0; i < 12; ++i) {
        const int level = i / 4, corner = i % 4;
        p.emplace_back(corner & 1 ? 0.1f : -0.1f, float(level), corner & 2 ? 0.1f : -0.1f);
        jointSlots.insert(jointSlots.end(), {level == 0 ? 0 : 1, 0, 0, 0});
        weights.insert(weights.end(), {1, 0, 0, 0});
    }
    Array<uint32_t> triangles;
    for (uint32_t l = 0; l < 2; ++l)
        for (const auto& [m, n] : {std::pair{0u, 1u}, {1u, 3u}, {3u, 2u}, {2u, 0u}}) {
            const uint32_t i = 4 * l + m, j = 4 * l + n;
            triangles.insert(triangles.end(), {i, j, j + 4, i, j + 4, i + 4});
        }
    MeshObject object;
    object.name = "Bar";
    object.base = Mesh::triangles(std::move(p), std::move(triangles))
                      .with(integerAttribute("joints", Domain::Vertex, 4, std::move(jointSlots)))
                      .with(floatAttribute("weights", Domain::Vertex, 4, std::move(weights)));
    Node upper, lower, end, shown;
    upper.name = "upper";
    lower.name = "lower";
    end.name = "hand";
    upper.joint = lower.joint = Node::Joint::Joint;
    end.joint = Node::Joint::EndSite;
    lower.local.translation = end.local.translation = {0, 1, 0};
    a.upper = a.scene.add(upper);
    a.lower = a.scene.add(lower, a.upper);
    a.scene.add(end, a.lower);
    Skin skin;
    skin.joints = {a.upper, a.lower};
    skin.inverseBind = {glm::dmat4(1), glm::dmat4(1)};
    skin.inverseBind[1][3] = {0, -1, 0, 1};
    shown.name = "Bar";
    shown.mesh = a.scene.add(std::move(object));
    shown.skin = a.scene.add(std::move(skin));
    a.mesh = a.scene.add(shown);

    Channel bend;
    bend.node = a.lower;
    bend.path = Channel::Path::Rotation;
    bend.components = 4;
    bend.times = Array<double>{0, 1, 2};
    const double h = std::sqrt(0.5), q = std::sin(M_PI / 8), c = std::cos(M_PI / 8);
    bend.values = Array<double>{0, 0, 0, 1, 0, 0, q, c, 0, 0, h, h};
    Channel lift;
    lift.node = a.upper;
    lift.path = Channel::Path::Translation;
    lift.interpolation = Channel::Interpolation::Step;
    lift.times = Array<double>{0, 0.5};
    lift.values = Array<double>{0, 0, 0, 0, 0, 0};
    Clip clip;
    clip.name = "Bend";
    clip.channels = {std::make_shared<Channel>(bend), std::make_shared<Channel>(lift)};
    a.scene.add(std::move(clip));
    return a;
}

}  // namespace

class TimelineTest : public QObject, protected WindowFixture {
    Q_OBJECT

private:
    Arm arm_;

    Playback& play() { return *w_->session().playback; }
    TimelineTracks& tracks() { return *w_->findChild<TimelineTracks*>("timelineTracks"); }
    QPoint atKeys(double seconds, int row)
    {
        return {int(std::lround(tracks().xOf(seconds))), TimelineTracks::rulerHeight + row * TimelineTracks::rowHeight + 11};
    }
    void click(QPoint at) { QTest::mouseClick(tracks().viewport(), Qt::LeftButton, {}, at); }

private slots:
    void init()
    {
        showWindow(1280, 800);
        w_->workspaces().change("Character");
        arm_ = arm();
        w_->files().openScene(arm_.scene, "Open arm");
        QTRY_VERIFY(w_->findChild<TimelineTracks*>("timelineTracks"));
        QTest::qWait(50);
    }
    void cleanup() { w_.reset(); }

    void standsReadyToPlay()
    {
        QVERIFY(play().clip());
        QCOMPARE(play().clip()->name, std::string("Bend"));
        QCOMPARE(play().time(), 0.0);
        QVERIFY(!play().playing());
        QCOMPARE(play().frameRate(), 24.0);
        QVERIFY(w_->workspaces().dock("timeline")->isVisible());
        QCOMPARE(w_->findChild<QLabel*>("timeline-seconds")->text(), QString("24 fps, 0.000 s of 2.000 s"));
        QCOMPARE(tracks().tracks().size(), size_t(3));  // summary, upper, lower
        QCOMPARE(tracks().tracks()[0].keys.size(), size_t(4));
        QCOMPARE(tracks().tracks()[1].word, QString("step"));
        QCOMPARE(tracks().tracks()[2].word, QString("sph"));
    }

    void spacePlaysAtTheClocksPace()
    {
        w_->activateWindow();
        w_->viewport().setFocus();
        QTRY_VERIFY(w_->viewport().hasFocus());
        QElapsedTimer clock;
        clock.start();
        QTest::keyClick(&w_->viewport(), Qt::Key_Space);
        QVERIFY(play().playing());
        QTest::qWait(700);
        QTest::keyClick(&w_->viewport(), Qt::Key_Space);
        const double passed = 1e-3 * double(clock.elapsed());
        QVERIFY(!play().playing());
        QVERIFY2(play().time() > 0.4 && play().time() <= passed + 0.02, qPrintable(QString("%1 of %2").arg(play().time()).arg(passed)));
    }

    void loopsOrStops()
    {
        play().setSpeed(4);
        play().setTime(1.9);
        play().play();
        QTest::qWait(200);
        QVERIFY(play().playing());
        QVERIFY(play().time() < 1.9);
        play().setLoop(false);
        QTRY_VERIFY_WITH_TIMEOUT(!play().playing(), 3000);
        QCOMPARE(play().time(), 2.0);
        play().play();  // from the start again
        QVERIFY(play().time() < 0.5);
        play().pause();
    }

    void rulerScrubs()
    {
        QTest::mousePress(tracks().viewport(), Qt::LeftButton, {}, {int(tracks().xOf(0.5)), 10});
        QVERIFY(std::abs(play().time() - tracks().timeAt(int(tracks().xOf(0.5)))) < 1e-9);
        QMouseEvent move(QEvent::MouseMove, QPointF(tracks().xOf(1.25), 60), tracks().viewport()->mapToGlobal(QPointF(tracks().xOf(1.25), 60)),
                         Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(tracks().viewport(), &move);
        QVERIFY(std::abs(play().time() - 1.25) < 1e-9);
        QTest::mouseRelease(tracks().viewport(), Qt::LeftButton, {}, {int(tracks().xOf(1.25)), 60});
        QCOMPARE(w_->findChild<QDoubleSpinBox*>("timeline-frame")->value(), 30.0);
        QVERIFY(!document().modified());
    }

    void stepsToFramesAndKeys()
    {
        play().setTime(0.51);  // frame 12.24
        play().stepFrames(1);
        QVERIFY(std::abs(play().frame() - 13) < 1e-9);
        play().stepFrames(-1);
        QVERIFY(std::abs(play().frame() - 12) < 1e-9);
        play().nextKey();
        QVERIFY(std::abs(play().time() - 1) < 1e-9);
        play().lastKey();
        QVERIFY(std::abs(play().time() - 0.5) < 1e-9);
        w_->findChild<QToolButton*>("timeline-last-frame")->click();
        QCOMPARE(play().time(), 2.0);
    }

    void posesWhatIsDrawn()
    {
        play().setTime(2);
        const Frame& f = w_->viewport().frame();
        QCOMPARE(f.objects.size(), size_t(1));
        QVERIFY(f.objects[0].pose);
        // A quarter turn about Z takes the hand from (0, 2, 0) to (-1, 1, 0).
        const auto hand = std::find_if(f.bones.begin(), f.bones.end(), [this](const DrawBone& b) { return b.node == arm_.lower; });
        QVERIFY(hand != f.bones.end());
        QVERIFY(glm::distance(hand->tail, glm::vec3(-1, 1, 0)) < 1e-6);
        const Mesh moved = posed(f.objects[0].mesh, *f.objects[0].pose);
        QVERIFY(glm::distance(moved.positions()[8], glm::vec3(-1, 0.9f, -0.1f)) < 1e-6);
    }

    void tracksAndBonesSelectEachOther()
    {
        click({60, atKeys(0, 2).y()});
        QCOMPARE(document().selection().active(), arm_.lower);
        for (const DrawBone& b : w_->viewport().frame().bones) QCOMPARE(b.selected, b.node == arm_.lower);
        auto* tree = w_->workspaces().dock("outliner")->findChild<QTreeView*>();
        QCOMPARE(tree->currentIndex().data().toString(), QString("lower"));
        // A click on the joint in the view.
        w_->session().view.pickKind = PickKind::Joint;
        w_->session().view.touch();
        w_->viewport().frameAll(false);
        const glm::dvec3 at = w_->session().view.camera.project({0, 0, 0}, {w_->viewport().width(), w_->viewport().height()});
        w_->viewport().click({at.x + 4, at.y}, {});
        QCOMPARE(document().selection().active(), arm_.upper);
        w_->viewport().click({3, w_->viewport().height() - 3.0}, {});
        QVERIFY(document().selection().nodes.empty());
    }

    void doubleClickOnAKeyGoesThere()
    {
        QTest::mouseDClick(tracks().viewport(), Qt::LeftButton, {}, atKeys(1, 2) + QPoint(2, 0));
        QCOMPARE(play().time(), 1.0);
    }

    void zoomsAtTheCursor()
    {
        const double x = tracks().xOf(1.5), whole = tracks().xOf(2) - tracks().xOf(0);
        QWheelEvent wheel(QPointF(x, 80), tracks().viewport()->mapToGlobal(QPointF(x, 80)), {}, {0, 240}, Qt::NoButton, Qt::ControlModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(tracks().viewport(), &wheel);
        QVERIFY(std::abs(tracks().timeAt(x) - 1.5) < 1e-6);
        QVERIFY(tracks().xOf(2) - tracks().xOf(0) > 1.4 * whole);
        w_->activateWindow();
        tracks().setFocus();
        QTRY_VERIFY(tracks().hasFocus());
        QTest::keyClick(&tracks(), Qt::Key_Home);
        QVERIFY(std::abs(tracks().xOf(2) - tracks().xOf(0) - whole) < 1e-6);
    }

    void clipsAreEditedAndUndone()
    {
        const auto trigger = [&](const QString& entry) {
            w_->findChild<QToolButton*>("timeline-clip-menu")->click();
            QTRY_VERIFY(w_->findChild<QMenu*>("clipMenu"));
            auto* menu = w_->findChild<QMenu*>("clipMenu");
            for (QAction* a : menu->actions())
                if (a->text() == entry) a->trigger();
            menu->close();
            QTRY_VERIFY(!w_->findChild<QMenu*>("clipMenu"));
        };
        trigger("Duplicate");
        QCOMPARE(document().scene().clips().size(), size_t(2));
        QCOMPARE(play().clip()->name, std::string("Bend copy"));
        QCOMPARE(w_->findChild<QComboBox*>("timeline-clips")->currentText(), QString("Bend copy"));
        trigger("Delete");
        QCOMPARE(document().scene().clips().size(), size_t(1));
        QCOMPARE(play().clip()->name, std::string("Bend"));
        trigger("Delete");
        QVERIFY(!play().clip());
        QVERIFY(!w_->viewport().frame().bones.empty());  // at rest
        document().undo();
        QVERIFY(play().clip());
        document().undo();
        document().undo();
        QCOMPARE(document().scene().clips().size(), size_t(1));
        QVERIFY(!document().canUndo());
    }

    void rangeBoundsPlaying()
    {
        w_->findChild<QDoubleSpinBox*>("timeline-from")->setValue(12);
        w_->findChild<QDoubleSpinBox*>("timeline-to")->setValue(24);
        QCOMPARE(play().rangeFrom(), 0.5);
        QCOMPARE(play().rangeTo(), 1.0);
        play().play();
        for (int i = 0; i < 8; ++i) {
            QTest::qWait(100);
            QVERIFY(play().time() >= 0.5 && play().time() <= 1.0);
        }
    }

    void thousandsOfKeysAreDrawnAtOnce()
    {
        Scene scene;
        Clip clip;
        Array<double> times, values;
        for (int i = 0; i < 20'000; ++i) {
            times.push_back(i / 120.0);
            values.insert(values.end(), {0, 0, 0, 1});
        }
        const Shared<double> sharedTimes(std::move(times)), sharedValues(std::move(values));
        for (int j = 0; j < 200; ++j) {
            Channel c;
            Node n;
            n.joint = Node::Joint::Joint;
            c.node = scene.add(n);
            c.path = Channel::Path::Rotation;
            c.components = 4;
            c.times = sharedTimes;
            c.values = sharedValues;
            clip.channels.push_back(std::make_shared<Channel>(c));
        }
        clip.name = "Long";
        scene.add(std::move(clip));
        double begin = threadMilliseconds();
        w_->files().openScene(std::move(scene), "Open long");
        const double opened = threadMilliseconds() - begin;
        QVERIFY2(opened < 3000, qPrintable(QString::number(opened)));
        begin = threadMilliseconds();
        for (int i = 0; i < 5; ++i) {
            tracks().zoom(3, 700);
            tracks().viewport()->grab();
        }
        const double zoomed = threadMilliseconds() - begin;
        QVERIFY2(zoomed < 1000, qPrintable(QString::number(zoomed)));
    }

    void saysWhatToDoWithoutAClip()
    {
        w_->files().openScene(Scene(), "New");
        QVERIFY(!play().clip());
        QVERIFY(!tracks().isVisible());
    }
};

int main(int argc, char** argv)
{
    return runTests<TimelineTest>(argc, argv);
}

#include "timeline_test.moc"
