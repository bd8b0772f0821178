// The window without a mouse and for a screen reader: a whole piece of work by keys alone, and every control of every panel by its name.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QSettings>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>
#include <QTreeView>

#include "core/io/io.h"
#include "core/scene/samples.h"
#include "tests/ui/window_fixture.h"
#include "ui/command_search.h"
#include "ui/export_sheet.h"
#include "ui/file_commands.h"
#include "ui/panel.h"
#include "ui/parameter_form.h"
#include "ui/stack_edits.h"
#include "ui/steps/step_player.h"
#include "ui/viewport/viewport.h"
#include "ui/workspaces.h"

using namespace mw;

class AccessTest : public QObject, protected WindowFixture {
    Q_OBJECT

private:
    const MeshObject& object() { return *document().scene().find(document().scene().meshes().front()); }

    QWidget* focus() { return QApplication::focusWidget(); }
    void key(int k, Qt::KeyboardModifiers m = {})
    {
        QWidget* on = QApplication::activePopupWidget() ? QApplication::activePopupWidget()->focusWidget() : focus();
        QTest::keyClick(on ? on : w_.get(), Qt::Key(k), m);
        QTest::qWait(20);
    }
    void type(const QString& text)
    {
        QWidget* on = QApplication::activePopupWidget() ? QApplication::activePopupWidget()->focusWidget() : focus();
        QTest::keyClicks(on, text);
        QTest::qWait(20);
    }
    // By Ctrl+K, words, Enter.
    void command(const QString& words)
    {
        key(Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(QApplication::activePopupWidget());
        type(words);
        key(Qt::Key_Return);
        QTest::qWait(120);
    }

    static QString nameOf(QWidget* w)
    {
        const QAccessibleInterface* i = QAccessible::queryAccessibleInterface(w);
        return i ? i->text(QAccessible::Name) : QString();
    }
    // Its own, or that of the row it is part of: Qt shows that, too.
    static bool hasTip(const QWidget* w)
    {
        for (; w && !w->isWindow(); w = w->parentWidget())
            if (!w->toolTip().isEmpty()) return true;
        return false;
    }
    static bool isControl(const QWidget* w)
    {
        return qobject_cast<const QAbstractButton*>(w) || qobject_cast<const QComboBox*>(w) || qobject_cast<const QLineEdit*>(w) ||
               qobject_cast<const QAbstractSpinBox*>(w) || qobject_cast<const QAbstractSlider*>(w) || qobject_cast<const QAbstractItemView*>(w);
    }
    // Parts that Qt makes for itself: the field inside a spin box, buttons of tab bars, scroll bars.
    static bool isPart(const QWidget* w)
    {
        if (QString(w->metaObject()->className()) == "QScrollBar" || w->objectName().startsWith("qt_")) return true;
        for (const QWidget* p = w->parentWidget(); p; p = p->parentWidget())
            if (qobject_cast<const QAbstractSpinBox*>(p) || qobject_cast<const QComboBox*>(p) || qobject_cast<const QTabBar*>(p) ||
                QString(p->metaObject()->className()).contains("Private") || (qobject_cast<const QLineEdit*>(p)))
                return true;
        return false;
    }
    void collect(QWidget* top, const QString& where, QStringList* offenders)
    {
        for (QWidget* w : top->findChildren<QWidget*>()) {
            if (!w->isVisible() || !isControl(w) || isPart(w)) continue;
            QString place = where;
            for (QWidget* p = w; p; p = p->parentWidget())
                if (auto* d = qobject_cast<QDockWidget*>(p)) place += "/" + d->windowTitle();
            const QString what = QString("%1: %2 '%3' '%4'").arg(place, w->metaObject()->className(), w->objectName(), nameOf(w));
            if (nameOf(w).isEmpty()) *offenders << what + " has no name";
            if (!hasTip(w) && !qobject_cast<QAbstractItemView*>(w)) *offenders << what + " has no tooltip";
        }
    }

private slots:
    void init()
    {
        QSettings().clear();
        showWindow(1600, 1000);
        QVERIFY(QTest::qWaitForWindowActive(w_.get()));
    }
    void cleanup() { w_.reset(); }

    void everyControlHasANameAndATooltip()
    {
        QStringList offenders;
        for (const char* sample : {"blossom", "mannequin", "terrain"}) {
            w_->files().openScene(drawnCoarsely(sampleScene(sample)), "Open sample");
            settle();
            for (const QString& name : Workspaces::names()) {
                w_->workspaces().change(name);
                QTest::qWait(30);
                collect(w_.get(), QString("%1, %2").arg(sample, name), &offenders);
            }
            for (const PanelEntry& p : panels()) {  // also those that stand in none
                w_->workspaces().show(p.id);
                QTest::qWait(30);
                collect(w_->workspaces().dock(p.id), sample, &offenders);
            }
        }
        w_->files().exportDialog();
        collect(w_->findChild<ExportSheet*>(), "Export", &offenders);
        w_->showWelcome();
        collect(w_->findChild<QWidget*>("card"), "Welcome", &offenders);
        offenders.removeDuplicates();
        QStringList once;
        QSet<QString> seen;
        for (const QString& o : offenders) {
            const QString rest = o.section(": ", 1);
            if (!seen.contains(rest)) once << o;
            seen << rest;
        }
        for (const QString& o : once) qWarning("%s", qPrintable(o));
        QCOMPARE(once.size(), 0);
        QCOMPARE(nameOf(&w_->viewport()), QString("View"));
    }

    void panelsAreReachedInTurn()
    {
        w_->files().openScene(sampleScene("blossom"), "Open Blossom");
        settle();
        w_->workspaces().change("Mesh");
        w_->viewport().setFocus();
        QStringList met;
        for (int i = 0; i < 12; ++i) {
            key(Qt::Key_F6);
            for (QWidget* p = focus(); p; p = p->parentWidget())
                if (auto* d = qobject_cast<QDockWidget*>(p)) met << d->windowTitle();
            if (focus() == &w_->viewport()) met << "View";
        }
        for (const char* wanted : {"Outliner", "Inspector", "Modifiers", "View"}) QVERIFY2(met.contains(wanted), qPrintable(met.join(", ")));
        const QString there = met.back();
        key(Qt::Key_F6, Qt::ShiftModifier);
        key(Qt::Key_F6);
        QVERIFY(focus());
    }

    void aPieceOfWorkByKeysAlone()
    {
        const QString in = folder_.filePath("ball.ply"), out = folder_.filePath("out.obj");
        writeFile(sceneOf(std::get<Mesh>(apply(operation("icosphere"), {}, {{"subdivisions", int64_t(3)}})), "ball"), in.toStdString());
        QSettings().setValue("export/folder", folder_.path());
        w_->files().open(in);  // the dialog of the system is not ours to test
        settle();
        // Select in the outliner by its filter and arrows.
        document().select({});
        w_->viewport().setFocus();
        for (int i = 0; i < 12 && !qobject_cast<QLineEdit*>(focus()); ++i) key(Qt::Key_F6);
        QVERIFY(qobject_cast<QLineEdit*>(focus()));
        for (int i = 0; i < 6 && !qobject_cast<QTreeView*>(focus()); ++i) key(Qt::Key_Tab);
        QVERIFY(qobject_cast<QTreeView*>(focus()));
        key(Qt::Key_Down);
        if (document().selection().nodes.empty()) key(Qt::Key_Space);
        QCOMPARE(document().selection().nodes.size(), size_t(1));
        // A modifier by search, its value by search.
        command("loop subdivision mesh");
        settle();
        QCOMPARE(object().stack.size(), size_t(1));
        QCOMPARE(object().stack[0].operation, std::string("subdivide-loop"));
        command("levels parameter");
        QTRY_VERIFY(qobject_cast<QAbstractSpinBox*>(focus()) || (focus() && qobject_cast<QAbstractSpinBox*>(focus()->parentWidget())));
        key(Qt::Key_A, Qt::ControlModifier);
        type("2");
        key(Qt::Key_Return);
        settle();
        QCOMPARE(document().shownMesh(document().scene().meshes().front()).faceCount(), size_t(16 * 1280));
        key(Qt::Key_Z, Qt::ControlModifier);
        settle();
        QVERIFY(document().shownMesh(document().scene().meshes().front()).faceCount() < size_t(16 * 1280));
        key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        settle();
        // Export, by its key and the field.
        key(Qt::Key_E, Qt::ControlModifier);
        QTRY_VERIFY(w_->findChild<ExportSheet*>());
        for (int i = 0; i < 6 && (!focus() || focus()->objectName() != "exportFile"); ++i) key(Qt::Key_Tab);
        QCOMPARE(focus()->objectName(), QString("exportFile"));
        key(Qt::Key_A, Qt::ControlModifier);
        type(out);
        key(Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(out), 20000);
        settle();
        const Imported back = readFile(out.toStdString());
        QCOMPARE(back.scene.find(back.scene.meshes().front())->base.faceCount(), size_t(16 * 1280));
    }
};

int main(int argc, char** argv)
{
    return runTests<AccessTest>(argc, argv);
}

#include "access_test.moc"
