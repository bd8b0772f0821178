// The outliner: it selects both ways, hides, renames, deletes, filters and frames; its tree is the scene's.
#include "ui/panels/outliner.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QTreeView>

#include "core/catalog/catalog.h"
#include "core/scene/edit.h"
#include "tests/ui/panel_desk.h"
#include "tests/ui/window_fixture.h"
#include "ui/words.h"

using namespace mw;

namespace {

constexpr int countColumn = 1, eyeColumn = 2;

/// arm: hand, sleeve; box.
struct Desk : PanelDesk {
    Desk()
    {
        Scene s;
        const auto add = [&](const char* name, NodeId parent = {}) {
            MeshObject object;
            object.name = name;
            object.base = std::get<Mesh>(apply(operation("box"), {}, {}));
            Node n;
            n.name = name;
            n.mesh = s.add(std::move(object));
            return s.add(n, parent);
        };
        const NodeId arm = add("arm");
        add("hand", arm);
        add("sleeve", arm);
        add("box");
        document.open(s, {}, "New");
        show(makeOutlinerPanel, 300, 400);
    }
    QTreeView* tree() const { return panel->findChild<QTreeView*>(); }
    NodeId called(const char* name) const { return nodeOf(document.scene(), name); }
    QModelIndex row(const QString& name, const QModelIndex& parent = {}) const
    {
        const QAbstractItemModel* m = tree()->model();
        for (int r = 0; r < m->rowCount(parent); ++r) {
            const QModelIndex i = m->index(r, 0, parent);
            if (i.data().toString() == name) return i;
            if (const QModelIndex below = row(name, i); below.isValid()) return below;
        }
        return {};
    }
    void click(const QModelIndex& i, Qt::KeyboardModifiers keys = {}) const
    {
        QTest::mouseClick(tree()->viewport(), Qt::LeftButton, keys, tree()->visualRect(i).center());
    }
    std::vector<NodeId> selected() const { return document.selection().nodes; }
};

}  // namespace

class OutlinerTest : public QObject {
    Q_OBJECT

private slots:
    void theTreeIsTheScenes()
    {
        Desk d;
        QCOMPARE(d.tree()->model()->rowCount(), 2);
        QCOMPARE(d.row("hand").parent(), d.row("arm"));
        QVERIFY(d.tree()->isExpanded(d.row("arm")));
        QCOMPARE(d.row("box").siblingAtColumn(countColumn).data().toString(),
                 countsText(d.document.shownMesh(d.document.scene().node(d.called("box")).mesh)));
        commitEdit(d.document, parsedEdit("reparent:nodes=box,to=hand"));
        QTRY_COMPARE(d.row("box").parent(), d.row("hand"));
        d.document.undo();
        QTRY_VERIFY(!d.row("box").parent().isValid());
    }

    void selectsBothWays()
    {
        Desk d;
        d.click(d.row("hand"));
        QCOMPARE(d.selected(), std::vector<NodeId>{d.called("hand")});
        d.click(d.row("box"), Qt::ControlModifier);
        QCOMPARE(d.selected(), (std::vector<NodeId>{d.called("hand"), d.called("box")}));  // the last one is active
        d.document.select({{d.called("sleeve")}, {}, {}});
        QVERIFY(d.tree()->selectionModel()->isSelected(d.row("sleeve")));
        QVERIFY(!d.tree()->selectionModel()->isSelected(d.row("box")));
    }

    void theEyeHides()
    {
        Desk d;
        d.click(d.row("hand").siblingAtColumn(eyeColumn));
        QVERIFY(!d.document.scene().node(d.called("hand")).visible);
        QTRY_COMPARE(d.row("hand").siblingAtColumn(eyeColumn).data(Qt::AccessibleTextRole).toString(), QString("hidden"));
        d.document.undo();
        QVERIFY(d.document.scene().node(d.called("hand")).visible);
    }

    void renamesInPlace()
    {
        Desk d;
        d.click(d.row("box"));
        d.tree()->setFocus();
        d.tree()->edit(d.row("box"));
        auto* field = d.tree()->viewport()->findChild<QLineEdit*>();
        QVERIFY(field);
        field->setText("crate");
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_VERIFY(d.row("crate").isValid());
        QCOMPARE(QString::fromStdString(d.document.undoName()), QString("box: rename to crate"));
        d.document.undo();
        QTRY_VERIFY(d.row("box").isValid());
    }

    void filtersByLettersAndKeepsWhatIsAbove()
    {
        Desk d;
        d.panel->findChild<QLineEdit*>()->setText("SLEE");
        QVERIFY(d.row("sleeve").isValid() && d.row("arm").isValid());
        QVERIFY(!d.row("hand").isValid() && !d.row("box").isValid());
    }

    void keysFrameAndDelete()
    {
        Desk d;
        d.click(d.row("hand"));
        QSignalSpy framed(&d.view, &ViewState::frameRequested);
        QTest::keyClick(d.tree(), Qt::Key_Return);
        QCOMPARE(framed.count(), 1);
        QTest::keyClick(d.tree(), Qt::Key_Delete);
        QTRY_VERIFY(!d.row("hand").isValid());
        QVERIFY(d.row("sleeve").isValid());
        d.document.undo();
        QTRY_VERIFY(d.row("hand").isValid());
    }

    void anEmptySceneSaysWhatToDo()
    {
        Desk d;
        d.document.open(Scene(), {}, "New");
        QTRY_VERIFY(!d.tree()->isVisible());
    }
};

int main(int argc, char** argv)
{
    return runTests<OutlinerTest>(argc, argv);
}

#include "outliner_test.moc"
