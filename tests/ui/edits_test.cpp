// Edits from the window: menus and keys, reasons why not, the history as a command line that a shell runs to the same scene.
#include <QAction>
#include <QClipboard>
#include <QMenu>
#include <QProcess>
#include <QPushButton>
#include <QTest>
#include <QTreeView>

#include "core/io/io.h"
#include "core/scene/command_line.h"
#include "tests/ui/window_fixture.h"
#include "ui/edit_commands.h"
#include "ui/file_commands.h"
#include "ui/stack_edits.h"
#include "ui/terrain_edits.h"
#include "ui/viewport/viewport.h"

using namespace mw;

class EditsTest : public QObject, protected WindowFixture {
    Q_OBJECT

private:
    NodeId node(const char* name) { return nodeOf(document().scene(), name); }
    void select(const char* names) { document().select({nodesOf(document().scene(), names), {}, {}}); }
    void openSphere()
    {
        const QString file = folder_.filePath("it's a sphere.ply");
        writeFile(sceneOf(std::get<Mesh>(apply(operation("icosphere"), {}, {{"subdivisions", int64_t(3)}})), "sphere"), file.toStdString());
        w_->files().open(file);
        QTRY_COMPARE_WITH_TIMEOUT(document().file().filename().string(), std::string("it's a sphere.ply"), 20000);
        settle();
        if (document().scene().nodes().size() == 1) edits::rename(document(), document().scene().nodes()[0], "ball");
    }
    // Runs a copied line by a shell and reads what it wrote.
    Scene run(QString line)
    {
        const QString out = folder_.filePath("result.glb");
        QFile::remove(out);
        line.replace("-o result.glb", "--project -o result.glb");
        QProcess shell;
        shell.setWorkingDirectory(folder_.path());
        shell.start("sh", {"-c", QString("meshwright() { '%1' \"$@\"; }\n").arg(MESHWRIGHT_PROGRAM) + line});
        if (!shell.waitForFinished(60000) || shell.exitCode() != 0) qWarning("%s\n%s", qPrintable(line), shell.readAllStandardError().constData());
        return QFile::exists(out) ? readFile(out.toStdString()).scene : Scene();
    }

private slots:
    void init() { showWindow(1280, 800); }
    void cleanup() { w_.reset(); }

    void duplicatesJoinsAndTakesApart()
    {
        openSphere();
        select("ball");
        action("Duplicate")->trigger();
        QCOMPARE(document().scene().nodes().size(), size_t(2));
        QCOMPARE(document().selection().active(), node("ball 2"));
        commitEdit(document(), parsedEdit("transform:node=ball 2,position=3/0/0"));
        select("ball+ball 2");
        action("Join")->trigger();
        settle();
        QCOMPARE(document().scene().nodes().size(), size_t(1));
        QCOMPARE(document().scene().find(document().scene().meshes()[0])->base.faceCount(), size_t(2560));
        QCOMPARE(QString::fromStdString(document().undoName()), QString("ball 2: join 2 meshes"));
        action("Separate by components")->trigger();
        settle();
        QCOMPARE(document().scene().nodes().size(), size_t(2));
        action("Group")->trigger();
        QCOMPARE(document().scene().roots().size(), size_t(1));
        document().goTo(0);
        QCOMPARE(document().scene().nodes().size(), size_t(1));
    }

    void saysWhyNot()
    {
        openSphere();
        select("ball");
        QVERIFY(!action("Join")->isEnabled());
        QVERIFY(action("Join")->toolTip().startsWith("Select two or more meshes to join."));
        QVERIFY(!action("Separate selection")->isEnabled());
        QCOMPARE(action("Make own copy")->toolTip(), QString("No selected node shares its mesh."));
        edits::addModifier(document(), document().scene().meshes()[0], operation("smooth"));
        QCOMPARE(action("Separate by components")->toolTip(), QString("The mesh has modifiers: apply its stack first."));
        document().select({});
        QVERIFY(!action("Delete")->isEnabled());
        QVERIFY(!action("Duplicate")->isEnabled());
    }

    void deleteMeansElementsWhenSomeAreSelected()
    {
        openSphere();
        document().select({{node("ball")}, node("ball"), {ElementKind::Face, {0, 1, 2, 7}}});
        w_->findChild<Viewport*>()->setFocus();
        QTest::keyClick(w_->findChild<Viewport*>(), Qt::Key_Delete);
        QCOMPARE(document().scene().find(document().scene().meshes()[0])->base.faceCount(), size_t(1276));
        QCOMPARE(QString::fromStdString(document().undoName()), QString("ball: delete 4 faces"));
        select("ball");
        QTest::keyClick(w_->findChild<Viewport*>(), Qt::Key_Delete);
        QVERIFY(document().scene().nodes().empty());
    }

    void historyIsACommandLineThatGivesTheSame()
    {
        openSphere();
        const MeshId mesh = document().scene().meshes()[0];
        edits::addModifier(document(), mesh, operation("decimate-quadric"), {{"stop", std::string("faces")}, {"faces", int64_t(300)}});
        edits::commitValues(document(), mesh, 0, {{"stop", std::string("faces")}, {"faces", int64_t(400)}}, "faces 400");
        QCOMPARE(QString::fromStdString(document().undoName()), QString("Simplify by quadrics: faces 400"));
        settle();
        select("ball");
        action("Duplicate")->trigger();
        edits::rename(document(), node("ball 2"), "say \"it's, two\"");
        edits::applyStack(w_->session(), mesh, 1);
        settle();
        edits::newTerrain(w_->session(), operation("diamond-square"), {{"size", int64_t(33)}});
        settle();
        action("Copy history as command line")->trigger();
        const QString line = QApplication::clipboard()->text();
        QVERIFY2(line.startsWith("meshwright process '"), qPrintable(line));
        const Scene again = run(line);
        QCOMPARE(contentHash(again), contentHash(document().scene()));
        // One entry, and one action that was not made.
        edits::copyCommand(w_->session(), 2, edits::Copied::Entry);
        QVERIFY(QApplication::clipboard()->text().contains("--op decimate-quadric:stop=faces,faces=300") ||
                QApplication::clipboard()->text().contains("op=decimate-quadric"));
        document().select({{document().scene().nodes()[0]}, {}, {}});
        QVERIFY(edits::commandOf(w_->session(), action("Delete")).contains("--do delete:nodes=ball"));
        QVERIFY(edits::commandOf(w_->session(), action("Quit")).isEmpty());
    }

    void aHeavyEditGoesOnWhatThereIsNow()
    {
        openSphere();
        edits::run(w_->session(), parsedEdit("add:with=subdivisions=5,name=other"));
        edits::rename(document(), node("ball"), "renamed meanwhile");
        settle();
        QVERIFY(document().scene().find(node("other")));
        QVERIFY(document().scene().find(node("renamed meanwhile")));
    }

    void importsSeveralFilesEachAsOneEdit()
    {
        openSphere();
        const QString a = folder_.filePath("a.obj"), b = folder_.filePath("b.obj");
        for (const QString& f : {a, b}) writeFile(sceneOf(std::get<Mesh>(apply(operation("icosphere"), {}, {})), "part"), f.toStdString());
        const size_t entries = document().history().size();
        w_->files().import({a, folder_.filePath("missing.obj"), b});
        QTRY_COMPARE_WITH_TIMEOUT(document().history().size(), entries + 2, 20000);
        QCOMPARE(document().history().back().calls.size(), size_t(1));
        QVERIFY(QString::fromStdString(document().undoName()).contains(".obj"));
    }

    // To be looked at: MESHWRIGHT_PICTURES names a folder.
    void pictures()
    {
        const QString folder = qEnvironmentVariable("MESHWRIGHT_PICTURES");
        if (folder.isEmpty()) QSKIP("MESHWRIGHT_PICTURES is not set");
        edits::run(w_->session(), parsedEdit("add:with=subdivisions=8,name=sphere"));
        settle();
        select("sphere");
        const MeshId mesh = document().scene().meshes()[0];
        edits::addModifier(document(), mesh, operation("smooth"), {{"iterations", int64_t(200)}});
        edits::addModifier(document(), mesh, operation("decimate-quadric"));
        QTest::qWait(1500);
        w_->grab().save(folder + "/edits-running.png");
        w_->evaluations().cancel(mesh);
        auto* add = w_->findChild<QPushButton*>("addModifier");
        QTest::mouseClick(add, Qt::LeftButton);
        QTest::qWait(300);
        for (QWidget* top : QApplication::topLevelWidgets())
            if (top->isVisible() && top->objectName() == "popup") top->grab().save(folder + "/edits-popup.png");
        if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
        for (QMenu* m : w_->findChildren<QMenu*>())
            if (m->title() == "Edit") {
                m->popup(w_->mapToGlobal(QPoint(40, 40)));
                QTest::qWait(200);
                m->grab().save(folder + "/edits-menu.png");
                m->close();
            }
    }
};

int main(int argc, char** argv)
{
    return runTests<EditsTest>(argc, argv);
}

#include "edits_test.moc"
