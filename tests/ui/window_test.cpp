// The window as a person uses it, proved by the state of the document.
#include <QCheckBox>
#include <QDockWidget>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>

#include "core/io/io.h"
#include "core/scene/samples.h"
#include "tests/ui/window_fixture.h"
#include "ui/banner.h"
#include "ui/file_commands.h"
#include "ui/parameter_form.h"
#include "ui/stack_edits.h"
#include "ui/steps/step_player.h"
#include "ui/viewport/viewport.h"
#include "ui/workspaces.h"

using namespace mw;

class WindowTest : public QObject, protected WindowFixture {
    Q_OBJECT

private:
    MeshId mesh() { return document().scene().meshes().front(); }
    const MeshObject& object() { return *document().scene().find(mesh()); }
    size_t resultFaces() { return document().evaluation(mesh()) ? document().evaluation(mesh())->result().faceCount() : 0; }

    // A sphere of 1,280 triangles in a file.
    QString sphereFile()
    {
        const QString file = path("sphere.ply");
        writeFile(sceneOf(std::get<Mesh>(apply(operation("icosphere"), {}, {{"subdivisions", int64_t(3)}})), "sphere"), file.toStdString());
        return file;
    }
    void openSphere()
    {
        QSignalSpy opened(&w_->files(), &FileCommands::opened);
        w_->files().open(sphereFile());
        QVERIFY(opened.wait(20000));
        QTRY_VERIFY_WITH_TIMEOUT(w_->evaluations().idle(), 20000);
    }

private slots:
    void init() { showWindow(1280, 800); }
    void cleanup() { w_.reset(); }

    void opensAFileAndSelectsIt()
    {
        openSphere();
        QCOMPARE(object().base.faceCount(), size_t(1280));
        QCOMPARE(document().selection().nodes.size(), size_t(1));
        QCOMPARE(document().history().size(), size_t(1));
        QVERIFY(!document().modified());
        QVERIFY(w_->windowTitle().startsWith("sphere.ply"));
    }

    void brokenFileLeavesTheScene()
    {
        openSphere();
        const auto before = document().snapshot();
        QFile broken(path("broken.ply"));
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.write("ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nend_header\nxx");
        broken.close();
        QSignalSpy trouble(&w_->files(), &FileCommands::trouble);
        w_->files().open(broken.fileName());
        QVERIFY(trouble.wait(20000));
        QCOMPARE(document().snapshot(), before);
        QVERIFY(w_->banner().isVisible());
        QVERIFY(w_->banner().text().contains("broken.ply"));
    }

    void aLabHidesTheSceneAndGivesItBack()
    {
        openSphere();
        w_->session().view.camera.azimuth = 1.1;
        const Camera before = w_->session().view.camera;
        const auto scene = document().snapshot();
        document().select({});
        QVERIFY(stepThrough(w_->session(), operation("fabrik")));
        w_->session().steps.seek(4);
        QTRY_COMPARE(w_->session().steps.position(), size_t(4));
        QVERIFY(w_->viewport().frame().objects.empty());
        QVERIFY(w_->viewport().frame().bones.size() >= 4);
        QVERIFY(!w_->session().view.camera.perspective);  // it lies in a plane
        const glm::dvec2 size(w_->viewport().width(), w_->viewport().height());
        for (const DrawBone& b : w_->viewport().frame().bones) {
            const glm::dvec3 at = w_->session().view.camera.project(glm::dvec3(b.tail), size);
            QVERIFY(at.x > 0 && at.y > 0 && at.x < size.x && at.y < size.y);
        }
        w_->viewport().click({size.x / 2, size.y / 2}, {});
        QVERIFY(document().selection().nodes.empty());
        QVERIFY(stepThrough(w_->session(), operation("interpolate-rotation")));
        QVERIFY(w_->session().view.camera.perspective);
        w_->session().steps.close();
        const Camera& after = w_->session().view.camera;
        QCOMPARE(after.azimuth, before.azimuth);
        QCOMPARE(after.distance, before.distance);
        QCOMPARE(after.perspective, before.perspective);
        QCOMPARE(after.target, before.target);
        QCOMPARE(w_->viewport().frame().objects.size(), size_t(1));
        QCOMPARE(document().snapshot(), scene);
    }

    void picksInTheView()
    {
        openSphere();
        document().select({});
        w_->viewport().frameAll(false);
        const QPointF middle(w_->viewport().width() / 2.0, w_->viewport().height() / 2.0);
        w_->viewport().click(middle, {});
        QCOMPARE(document().selection().nodes.size(), size_t(1));
        w_->session().view.pickKind = PickKind::Face;
        w_->viewport().click(middle, {});
        QCOMPARE(document().selection().elements.kind, ElementKind::Face);
        QCOMPARE(document().selection().elements.indices.size(), size_t(1));
        w_->viewport().selectBox(QRect(0, 0, w_->viewport().width(), w_->viewport().height()), {});
        const size_t visible = document().selection().elements.indices.size();
        QVERIFY2(visible > 300 && visible < 800, qPrintable(QString::number(visible)));  // about half of 1,280
        w_->session().view.pickKind = PickKind::Object;
        w_->viewport().click({3, 3}, {});
        QVERIFY(document().selection().nodes.empty());
    }

    void addsAModifierFromThePopup()
    {
        openSphere();
        auto* add = w_->findChild<QPushButton*>("addModifier");
        QVERIFY(add && add->isEnabled());
        add->click();
        auto* list = w_->findChild<QListWidget*>("modifierChoices");
        QVERIFY(list);
        QList<QListWidgetItem*> items = list->findItems(QString::fromStdString(operation("subdivide-loop").title), Qt::MatchExactly);
        QCOMPARE(items.size(), 1);
        emit list->itemClicked(items.front());
        QCOMPARE(object().stack.size(), size_t(1));
        settle();
        QVERIFY(resultFaces() >= 4 * 1280);
        NumberBox* levels = nullptr;
        for (auto* form : w_->findChildren<ParameterForm*>())
            if (auto* field = qobject_cast<NumberBox*>(form->field("levels"))) levels = field;
        QVERIFY(levels);
        levels->setValue(2);
        settle();
        QCOMPARE(resultFaces(), size_t(16 * 1280));
    }

    void changesAModifierWhileItRuns()
    {
        openSphere();
        edits::addModifier(document(), mesh(), operation("subdivide-loop"), {{"levels", int64_t(5)}});
        QVERIFY(!w_->evaluations().idle());
        edits::commitValues(document(), mesh(), 0, {{"levels", int64_t(1)}}, "levels 1");
        settle();
        QCOMPARE(resultFaces(), size_t(4 * 1280));
        int cancelled = 0;
        for (const Job& j : w_->session().jobs.jobs()) cancelled += j.state == Job::State::Cancelled;
        QVERIFY(cancelled >= 1);
    }

    void oneDragIsOneHistoryEntry()
    {
        openSphere();
        edits::addModifier(document(), mesh(), operation("subdivide-loop"), {{"levels", int64_t(1)}});
        settle();
        const size_t before = document().history().size();
        for (int64_t l : {2, 3, 2}) edits::previewValues(document(), mesh(), 0, {{"levels", l}});
        QCOMPARE(document().history().size(), before);
        edits::commitValues(document(), mesh(), 0, {{"levels", int64_t(2)}}, "levels 2");
        QCOMPARE(document().history().size(), before + 1);
        document().undo();
        QCOMPARE(valueOf(operation("subdivide-loop").parameters[0], object().stack[0].values), ParameterValue(int64_t(1)));
    }

    void undoesAndRedoes()
    {
        openSphere();
        edits::addModifier(document(), mesh(), operation("subdivide-loop"), {{"levels", int64_t(1)}});
        settle();
        QTest::keyClick(w_.get(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(object().stack.size(), size_t(0));
        settle();
        QCOMPARE(resultFaces(), size_t(1280));
        QTest::keyClick(w_.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(object().stack.size(), size_t(1));
        settle();
        QCOMPARE(resultFaces(), size_t(4 * 1280));
    }

    void savesLoadsAndExports()
    {
        openSphere();
        edits::addModifier(document(), mesh(), operation("subdivide-loop"), {{"levels", int64_t(1)}});
        settle();
        QVERIFY(document().modified());
        bool saved = false;
        w_->files().saveTo(path("project.glb"), [&] { saved = true; });
        QTRY_VERIFY_WITH_TIMEOUT(saved, 20000);
        QVERIFY(!document().modified());
        w_->files().exportTo(path("out.obj"));
        settle();
        QCOMPARE(readFile(path("out.obj").toStdString()).scene.find(readFile(path("out.obj").toStdString()).scene.meshes().front())->base.faceCount(),
                 size_t(4 * 1280));
        QSignalSpy opened(&w_->files(), &FileCommands::opened);
        w_->files().open(path("project.glb"));
        QVERIFY(opened.wait(20000));
        QCOMPARE(object().base.faceCount(), size_t(1280));
        QCOMPARE(object().stack.size(), size_t(1));
    }

    void floatsAndDocksAPanel()
    {
        openSphere();
        QDockWidget* dock = w_->workspaces().dock("outliner");
        QVERIFY(dock && dock->isVisible());
        dock->setFloating(true);
        QTRY_VERIFY(dock->isFloating());
        QTest::qWait(100);
        dock->setFloating(false);
        QTRY_VERIFY(!dock->isFloating());
        QVERIFY(dock->widget()->findChild<QTreeView*>()->model()->rowCount() == 1);
        const size_t drawn = w_->viewport().framesDrawn();
        w_->session().view.touch();
        QTRY_VERIFY(w_->viewport().framesDrawn() > drawn);
    }

    void drawsOnlyWhenSomethingChanged()
    {
        openSphere();
        settleView();
        // A busy machine tells the window late that it is active, so that one of several waits may see a frame.
        bool still = false;
        for (int attempt = 0; attempt < 5 && !still; ++attempt) {
            const size_t drawn = w_->viewport().framesDrawn();
            QTest::qWait(500);
            still = w_->viewport().framesDrawn() == drawn;
        }
        QVERIFY(still);
    }

    void welcomeSceneHasAModifierThatRuns()
    {
        w_->showWelcome();
        settle();
        QCOMPARE(document().scene().meshes().size(), size_t(1));
        QVERIFY(!document().modified());
        QVERIFY(resultFaces() > object().base.faceCount());
        for (const Sample& s : samples()) QVERIFY(!s.make().nodes().empty());
    }
};

int main(int argc, char** argv)
{
    return runTests<WindowTest>(argc, argv);
}

#include "window_test.moc"
