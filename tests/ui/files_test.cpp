// Files in the window: dropped, placed, exported, found again; shortcuts and search; proved by the document and by reading what was written.
#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDirIterator>
#include <QDockWidget>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>
#include <QTreeWidget>

#include "core/io/preflight.h"
#include "core/scene/samples.h"
#include "tests/ui/window_fixture.h"
#include "ui/banner.h"
#include "ui/command_search.h"
#include "ui/drop_target.h"
#include "ui/export_sheet.h"
#include "ui/file_commands.h"
#include "ui/shortcuts.h"
#include "ui/shortcuts_sheet.h"
#include "ui/stack_edits.h"
#include "ui/theme.h"
#include "ui/tool_bar.h"
#include "ui/viewport/viewport.h"
#include "ui/workspaces.h"

using namespace mw;

class FilesTest : public QObject, protected WindowFixture {
    Q_OBJECT

private:
    // A box of 2 x 4 x 6 in a text that says nothing of units.
    QString boxFile()
    {
        QFile f(path("box.obj"));
        if (!f.open(QIODevice::WriteOnly)) return {};
        f.write(
            "v 0 0 0\nv 2 0 0\nv 2 4 0\nv 0 4 0\nv 0 0 6\nv 2 0 6\nv 2 4 6\nv 0 4 6\n"
            "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
        return f.fileName();
    }
    void open(const QString& file)
    {
        QSignalSpy opened(&w_->files(), &FileCommands::opened);
        w_->files().open(file);
        QVERIFY(opened.wait(20000));
        settle();
    }
    glm::dvec3 size()
    {
        const Scene& s = document().scene();
        Bounds b;
        for (const NodeId n : s.nodes())
            if (s.node(n).mesh)
                for (const glm::vec3& p : s.find(s.node(n).mesh)->base.positions())
                    b.add(glm::dvec3(s.worldFromLocal(n) * glm::dvec4(glm::dvec3(p), 1)));
        return b.max - b.min;
    }

    // As the window system would bring it.
    void drop(const QStringList& files, QPoint at)
    {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& f : files) urls << QUrl::fromLocalFile(f);
        data.setUrls(urls);
        QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(w_.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDragMoveEvent move(at, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(w_.get(), &move);
        auto* frame = w_->findChild<DropFrame*>();
        QVERIFY(frame && frame->isVisible() && !frame->verb().isEmpty());
        QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(w_.get(), &event);
        QVERIFY(event.isAccepted());
        QVERIFY(!frame->isVisible());
    }
    QPoint onView() { return w_->viewport().mapTo(w_.get(), w_->viewport().rect().center()); }
    QPoint onBar()
    {
        auto* bar = w_->findChild<MainToolBar*>();
        return bar->mapTo(w_.get(), bar->rect().center());
    }

private slots:
    void init()
    {
        QSettings().clear();
        showWindow(1280, 800);
    }
    void cleanup() { w_.reset(); }

    void unitsAndUpAreAskedKeptAndUndone()
    {
        const QString file = boxFile();
        open(file);
        QVERIFY2(w_->banner().text().contains("metres, Y up (assumed)"), qPrintable(w_->banner().text()));
        QPushButton* change = nullptr;
        for (auto* b : w_->banner().findChildren<QPushButton*>())
            if (b->text() == "Change...") change = b;
        QVERIFY(change && change->isVisible());
        change->click();
        QWidget* card = QApplication::activePopupWidget();
        QVERIFY(card);
        card->findChild<QComboBox*>("placementUnit")->setCurrentText("Centimetres");
        card->findChild<QComboBox*>("placementUp")->setCurrentText("Z up");
        card->findChild<QAbstractButton*>("placementKeep")->click();
        card->findChild<QPushButton*>("placementApply")->click();
        const glm::dvec3 now = size();  // the 6 of z points up now
        QVERIFY(glm::length(now - glm::dvec3(0.02, 0.06, 0.04)) < 1e-6);
        QCOMPARE(document().history().size(), size_t(2));
        document().undo();
        QVERIFY(glm::length(size() - glm::dvec3(2, 4, 6)) < 1e-6);
        open(file);
        QVERIFY2(w_->banner().text().contains("centimetres, Z up (chosen"), qPrintable(w_->banner().text()));
        QVERIFY(glm::length(size() - glm::dvec3(0.02, 0.06, 0.04)) < 1e-6);
    }

    void droppedOnTheViewIsAddedOnTheBarOpened()
    {
        const QString file = boxFile();
        open(file);
        drop({file, file}, onView());
        settle();
        QCOMPARE(document().scene().roots().size(), size_t(3));
        document().saved({});  // nothing to ask about
        drop({file}, onBar());
        settle();
        QTRY_COMPARE(document().scene().roots().size(), size_t(1));
    }

    void aPictureIsAskedAbout()
    {
        open(boxFile());
        QImage grey(65, 65, QImage::Format_Grayscale8);
        for (int y = 0; y < 65; ++y)
            for (int x = 0; x < 65; ++x) grey.setPixel(x, y, qRgb(3 * x, 3 * x, 3 * x));
        grey.save(path("hills.png"));
        drop({path("hills.png")}, onView());
        settle();
        QVERIFY(w_->banner().text().contains("is a picture"));
        QVERIFY(document().scene().terrains().empty());
        for (auto* b : w_->banner().findChildren<QPushButton*>())
            if (b->text() == "New terrain from it") b->click();
        settle();
        QCOMPARE(document().scene().terrains().size(), size_t(1));
    }

    void exportsWhatTheSheetSays()
    {
        w_->files().openScene(sampleScene("mannequin"), "Open Mannequin");
        settle();
        w_->files().exportDialog();
        auto* sheet = w_->findChild<ExportSheet*>();
        QVERIFY(sheet && sheet->isVisible());
        auto* format = sheet->findChild<QComboBox*>("exportFormat");
        const auto choose = [&](const char* ending) {
            format->setCurrentIndex(format->findData(ending));
            emit format->activated(format->currentIndex());
        };
        const auto says = [&](const char* words) {
            auto* list = sheet->findChild<QTreeWidget*>("exportList");
            for (int i = 0; i < list->topLevelItemCount(); ++i)
                if (list->topLevelItem(i)->text(1).contains(words)) return true;
            return false;
        };
        sheet->findChild<QLineEdit*>("exportFile")->setText(path("figure.glb"));
        choose(".glb");
        QVERIFY(!says("skin is left out") && !says("clips are left out"));
        choose(".obj");
        QVERIFY(says("skin is left out") && says("clips are left out"));
        QVERIFY(sheet->findChild<QLineEdit*>("exportFile")->text().endsWith("figure.obj"));
        choose(".png");
        QVERIFY(says("no visible terrain"));
        QVERIFY(!sheet->findChild<QPushButton*>("exportRun")->isEnabled());
        choose(".ply");
        QSignalSpy done(&w_->files(), &FileCommands::notice);
        sheet->findChild<QPushButton*>("exportRun")->click();
        QVERIFY(done.wait(20000));
        const QString text = done.front().front().toString();
        const size_t faces = amountOf(document().scene(), [&](MeshId id) { return document().shownMesh(id); }).faces;
        QVERIFY2(text.contains(QLocale(QLocale::English).toString(qulonglong(faces)) + " faces"), qPrintable(text));
        const Imported back = readFile(path("figure.ply").toStdString());
        QCOMPARE(back.scene.find(back.scene.meshes().front())->base.faceCount(), faces);
    }

    void exportsOnlyWhatIsSelected()
    {
        open(boxFile());
        drop({boxFile()}, onView());
        settle();
        document().select({{document().scene().roots().front()}, {}, {}});
        w_->files().exportTo(path("one.ply"), {}, true);
        settle();
        const Imported back = readFile(path("one.ply").toStdString());
        QCOMPARE(back.scene.find(back.scene.meshes().front())->base.vertexCount(), size_t(8));
    }

    void everyCommandHasAnIdOfItsOwnAndKeysNobodyElseHas()
    {
        for (const QString& preset : Shortcuts::presets()) {
            w_->shortcuts().usePreset(preset);
            QMap<QString, QString> byId, byKey;
            for (const Shortcuts::Command& c : w_->shortcuts().commands()) {
                const QString id = c.action->objectName();
                QVERIFY2(!byId.contains(id), qPrintable(id + " is also " + byId.value(id)));
                byId[id] = c.title;
                QVERIFY2(!c.action->property("tip").toString().isEmpty(), qPrintable(id + " has no tooltip"));
                for (const QKeySequence& k : c.action->shortcuts()) {
                    const QString key = k.toString();
                    QVERIFY2(!byKey.contains(key), qPrintable(preset + ": " + key + " runs " + id + " and " + byKey.value(key)));
                    byKey[key] = id;
                }
            }
            QVERIFY(byId.size() > 60);
        }
    }

    void keysAreChangedInTheSheetAndKept()
    {
        const auto find = [&](const QString& title) -> const Shortcuts::Command& {
            for (const Shortcuts::Command& c : w_->shortcuts().commands())
                if (c.title == title) return c;
            qFatal("no command %s", qPrintable(title));
        };
        for (QAction* a : w_->findChildren<QAction*>())
            if (a->text() == "Shortcuts...") a->trigger();
        auto* sheet = w_->findChild<ShortcutsSheet*>();
        QVERIFY(sheet && sheet->isVisible());
        sheet->findChild<QLineEdit*>("shortcutsFilter")->setText("Invert");
        auto* keys = sheet->findChild<QLineEdit*>("shortcutsKeys");
        keys->setFocus();
        QTest::keyClick(keys, Qt::Key_J, Qt::ControlModifier | Qt::AltModifier);
        QCOMPARE(keysText(find("Invert").action), QString("Ctrl+Alt+J"));
        QVERIFY(find("Invert").action->toolTip().contains("Ctrl+Alt+J"));
        QTest::keyClick(keys, Qt::Key_S, Qt::ControlModifier);  // Save has it
        auto* conflict = sheet->findChild<QLabel*>("shortcutsConflict");
        QVERIFY2(conflict->text().contains("Save"), qPrintable(conflict->text()));
        QCOMPARE(keysText(find("Save").action), QString("Ctrl+S"));
        sheet->findChild<QPushButton*>("shortcutsKeep")->click();
        QCOMPARE(keysText(find("Save").action), QString("Ctrl+S"));
        keys->setFocus();
        QTest::keyClick(keys, Qt::Key_S, Qt::ControlModifier);
        sheet->findChild<QPushButton*>("shortcutsTake")->click();
        QCOMPARE(keysText(find("Save").action), QString());
        QCOMPARE(keysText(find("Invert").action), QString("Ctrl+S"));
        w_.reset();
        w_ = std::make_unique<MainWindow>();
        QCOMPARE(keysText(find("Invert").action), QString("Ctrl+S"));
        w_->shortcuts().resetAll();
        QCOMPARE(keysText(find("Save").action), QString("Ctrl+S"));
        QCOMPARE(keysText(find("Invert").action), QString("Ctrl+I"));
    }

    void searchFindsAndRuns()
    {
        open(boxFile());
        const Findable f{"x", "Loop subdivision", "Mesh > Subdivide", "Rounds a mesh", {}, {}, {}, {}, {}};
        int rank = 0;
        QCOMPARE(matchedLetters("sub", f, &rank), (std::vector<std::pair<int, int>>{{5, 3}}));
        QVERIFY(rank > 0);
        matchedLetters("rounds", f, &rank);
        QVERIFY(rank > 0);
        matchedLetters("lsbd", f, &rank);
        QVERIFY(rank >= 20);
        matchedLetters("catmull", f, &rank);
        QCOMPARE(rank, -1);
        QTest::keyClick(w_.get(), Qt::Key_K, Qt::ControlModifier);
        auto* popup = w_->findChild<CommandSearch*>();
        QVERIFY(popup);
        auto* field = popup->findChild<QLineEdit*>("searchQuery");
        field->setText("loop subdivision");
        const auto* list = popup->findChild<QListView*>("searchResults");
        QVERIFY(list->model()->data(list->currentIndex(), Qt::AccessibleTextRole).toString().startsWith("Loop subdivision"));
        QTest::keyClick(field, Qt::Key_Return, Qt::ControlModifier);
        QVERIFY(QApplication::clipboard()->text().contains("subdivide-loop"));
        QTest::keyClick(w_.get(), Qt::Key_K, Qt::ControlModifier);
        for (auto* p : w_->findChildren<CommandSearch*>())
            if (p->isVisible()) popup = p;
        field = popup->findChild<QLineEdit*>("searchQuery");
        field->setText("loop subdivision");
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(document().scene().find(document().scene().meshes().front())->stack.size(), size_t(1));
    }

    void aWorkspaceOfOnesOwn()
    {
        w_->workspaces().change("Mesh");
        w_->workspaces().show("plot");
        QString whyNot;
        QVERIFY(!w_->workspaces().saveAs("Mesh", &whyNot));
        QVERIFY(whyNot.contains("is there already"));
        QVERIFY(w_->workspaces().saveAs("Inspect", &whyNot));
        QCOMPARE(w_->workspaces().current(), QString("Inspect"));
        QCOMPARE(w_->workspaces().kind(), QString("Mesh"));
        w_->workspaces().change("Mesh");
        w_->workspaces().change("Inspect");
        QVERIFY(!w_->workspaces().dock("plot")->isHidden());
        w_->workspaces().remove("Inspect");
        QCOMPARE(w_->workspaces().current(), QString("Mesh"));
        QVERIFY(!w_->workspaces().all().contains("Inspect"));
    }

    void themesFollowTheChoice()
    {
        QPalette system;
        system.setColor(QPalette::Window, Qt::black);
        system.setColor(QPalette::WindowText, Qt::white);
        QVERIFY(isHighContrast(system));
        followSystemPalette(system);
        chooseTheme(*qApp, ThemeChoice::System);
        QCOMPARE(tokens().panel, QColor(Qt::black));
        QCOMPARE(currentTheme(), Theme::Dark);
        QVERIFY(!isHighContrast(QPalette(QColor("#efefef"))));
        chooseTheme(*qApp, ThemeChoice::Light);
        const QIcon quiet = icon("x", tokens().text2);
        const QColor before = quiet.pixmap(16, 16).toImage().pixelColor(8, 8);
        chooseTheme(*qApp, ThemeChoice::Dark);
        QVERIFY(before != quiet.pixmap(16, 16).toImage().pixelColor(8, 8));
    }

    void everyFileOfTheDataIsDropped()
    {
        const QString data = qEnvironmentVariable("MESHWRIGHT_DATA");
        if (data.isEmpty() || !QDir(data).exists()) QSKIP("MESHWRIGHT_DATA is not set");
        QStringList files;
        for (const char* part : {"meshes", "characters", "gltf", "bvh", "terrain", "malformed"}) {
            QDirIterator all(data + "/" + part, QDir::Files, QDirIterator::Subdirectories);
            while (all.hasNext()) files << all.next();
        }
        const Scene box = sceneOf(std::get<Mesh>(apply(operation("box"), {}, {})), "box");
        int opened = 0, refused = 0, asked = 0, barred = 0, seen = 0;
        for (const QString& file : files) {
            if (QFileInfo(file).size() > (8 << 20)) continue;                                     // large ones have tests of their own
            if (++seen % 4 != 1 && !qEnvironmentVariableIsSet("MESHWRIGHT_ALL_DROPS")) continue;  // all of them take four minutes
            for (const QPoint at : {onView(), onBar()}) {
                if (at == onBar() && ++barred % 8 != 1) continue;  // the toolbar goes the way of the Open dialog
                w_->files().openScene(box, "Open box");
                settle();
                const auto before = document().snapshot();
                w_->banner().hide();
                drop({file}, at);
                settle();
                QVERIFY2(!QApplication::activeModalWidget(), qPrintable(file));
                const bool changed = document().snapshot() != before;
                const QString said = w_->banner().isVisible() ? w_->banner().text() : QString();
                if (changed) {
                    ++opened;
                } else {
                    QVERIFY2(said.contains(QFileInfo(file).fileName()), qPrintable(file + " said: " + said));
                    (said.contains("is a picture") ? asked : refused)++;
                }
                const QString words = QString(said).remove(file);  // a name may say what it likes
                QVERIFY2(!words.contains("nvalid") && !words.contains("failed"), qPrintable(file + ": " + said));
            }
        }
        qInfo("%d drops opened or added, %d refused with a text, %d pictures asked about", opened, refused, asked);
        QVERIFY(opened > 25);
    }
};

int main(int argc, char** argv)
{
    return runTests<FilesTest>(argc, argv);
}

#include "files_test.moc"
