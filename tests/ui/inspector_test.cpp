// The inspector: its figures are those of the topology report, its rows select what they name.
#include "ui/panels/inspector.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>
#include <algorithm>

#include "core/catalog/catalog.h"
#include "core/mesh/topology.h"
#include "tests/ui/panel_desk.h"
#include "ui/panels/inspection.h"
#include "ui/panels/inspector_rows.h"
#include "ui/panels/valence_histogram.h"

using namespace mw;

namespace {

// A bowl of n x n squares of two triangles each, the middle square left out; one more vertex that no face uses. Convex: a lid crosses nothing.
Mesh sheetWithHole(uint32_t n)
{
    Array<glm::vec3> p;
    Array<uint32_t> t;
    for (uint32_t y = 0; y <= n; ++y)
        for (uint32_t x = 0; x <= n; ++x) {
            const float u = float(x) - float(n) / 2, v = float(y) - float(n) / 2;
            p.push_back({float(x), float(y), (u * u + v * v) / float(n)});
        }
    for (uint32_t y = 0; y < n; ++y)
        for (uint32_t x = 0; x < n; ++x) {
            if (x == n / 2 && y == n / 2) continue;
            const uint32_t a = y * (n + 1) + x, b = a + 1, c = a + n + 1, d = c + 1;
            for (uint32_t i : {a, b, d, a, d, c}) t.push_back(i);
        }
    p.push_back({-5, -5, -5});
    return Mesh::triangles(std::move(p), std::move(t));
}

struct Desk : PanelDesk {
    explicit Desk(const Mesh& mesh) : PanelDesk(mesh, "sheet", {10, 0, 0}) { show(makeInspectorPanel, 304, 600); }
    QTreeWidget* tree() const { return panel->findChild<QTreeWidget*>("inspect-list"); }
    QTreeWidgetItem* row(const QString& title) const
    {
        const auto found = tree()->findItems(title, Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.front();
    }
    QString figure(const char* name) const { return panel->findChild<QLabel*>(QString("inspect-") + name)->text(); }
    QPushButton* button(const char* name) const { return panel->findChild<QPushButton*>(name); }
    /// What the evaluation service does, at once.
    void evaluate()
    {
        const MeshId id = document.scene().node(node).mesh;
        document.setEvaluation(id, std::make_shared<const Evaluation>(Evaluator().evaluate(*document.scene().find(id))));
    }
    void click(QTreeWidgetItem* item) const
    {
        tree()->scrollToItem(item);
        QTest::mouseClick(tree()->viewport(), Qt::LeftButton, {}, tree()->visualItemRect(item).center());
    }
};

}  // namespace

class InspectorTest : public QObject {
    Q_OBJECT

private slots:
    void figuresAreThoseOfTheReport();
    void anOffenderIsSelectedAndFramed();
    void passedChecksSayWhatWasChecked();
    void aCleanMeshHasNothingToFix();
    void loopsThatTouchKeepTheirEdges();
    void manyOffendersAreCapped();
    void repairAddsTheModifier();
    void repairAllIsOneEntry();
    void downWalksTheOffenders();
    void largeMeshesAreMeasuredForIntersectionsOnDemand();
    void aNewerMeshCancelsTheOlderReport();
    void aBarSelectsItsVertices();
    void withoutAMeshItSaysSo();
};

void InspectorTest::figuresAreThoseOfTheReport()
{
    const Mesh mesh = sheetWithHole(8);
    const TopologyReport r = topologyOf(mesh);
    QCOMPARE(r.boundaryLoops.size(), size_t(2));
    Desk d(mesh);
    QTRY_VERIFY(d.row("Loop 1"));
    QCOMPARE(d.figure("vertices"), QString("%1 + 1").arg(r.vertices - 1));
    QCOMPARE(d.figure("edges"), QString::number(r.edges));
    QCOMPARE(d.figure("faces"), QString::number(r.faces));
    QCOMPARE(d.figure("euler"), QString::number(r.euler));
    QCOMPARE(d.figure("components"), QString::number(r.components));
    QCOMPARE(d.row("Holes")->text(1), QString("2 loops"));
    QCOMPARE(d.row("Holes")->toolTip(1), QString("2 loops, %1 edges").arg(r.boundaryEdges));
    QCOMPARE(d.row("Loop 1")->text(1), QString("32 edges"));
    QCOMPARE(d.row("Loop 2")->text(1), QString("4 edges"));
    QCOMPARE(d.row("Isolated vertices")->toolTip(1), QString("1 vertex"));
}

void InspectorTest::anOffenderIsSelectedAndFramed()
{
    Desk d(sheetWithHole(8));
    QTRY_VERIFY(d.row("Loop 2"));
    QSignalSpy framed(&d.view, &ViewState::boundsRequested);
    d.click(d.row("Loop 2"));
    const Selection& s = d.document.selection();
    QCOMPARE(s.elementsOf, d.node);
    QVERIFY(s.elements.kind == ElementKind::Edge);
    const std::vector<uint32_t> hole{40, 41, 40, 49, 41, 50, 49, 50};
    QCOMPARE(s.elements.indices, hole);
    QVERIFY(d.view.dimOthers);
    QCOMPARE(framed.count(), 0);
    d.tree()->setCurrentItem(d.row("Loop 2"));
    QTest::keyClick(d.tree(), Qt::Key_Return);
    QCOMPARE(framed.count(), 1);
    const auto bounds = framed[0][0].value<Bounds>();
    QCOMPARE(bounds.min.x, 14.0);  // in the world: the node is moved by 10
    QCOMPARE(bounds.max.x, 15.0);
    // Selecting something else undims.
    d.document.select({{d.node}, {}, {}});
    QVERIFY(!d.view.dimOthers);
}

void InspectorTest::passedChecksSayWhatWasChecked()
{
    Desk d(sheetWithHole(4));
    QTRY_VERIFY(d.row("Non-manifold edges"));
    QTreeWidgetItem* row = d.row("Non-manifold edges");
    QCOMPARE(row->childCount(), 1);
    QCOMPARE(row->child(0)->text(0), QString("No edge has more than two faces."));
    // What is wrong is said, too, and the worst comes first.
    QVERIFY(d.row("Holes")->child(0)->text(0).endsWith('.'));
    QVERIFY(d.row("Holes")->parent()->indexOfChild(d.row("Holes")) < d.row("Isolated vertices")->parent()->childCount());
}

void InspectorTest::aCleanMeshHasNothingToFix()
{
    Desk d(Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, Array<uint32_t>{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}));
    QTRY_VERIFY(d.row("Nothing to fix"));
    QCOMPARE(d.figure("genus"), QString("0"));
}

void InspectorTest::loopsThatTouchKeepTheirEdges()
{
    // Two triangles that share one vertex: their borders are one component that is no simple loop.
    const Mesh bow = Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, Array<uint32_t>{0, 1, 2, 0, 3, 4});
    const Inspection i = inspect(bow);
    for (const Finding& f : i.findings)
        if (f.id == "holes") QCOMPARE(f.all.indices.size(), size_t(12));
}

void InspectorTest::manyOffendersAreCapped()
{
    Array<glm::vec3> p(3000, glm::vec3(0));
    for (size_t i = 0; i < p.size(); ++i) p[i].x = float(i);
    const Inspection i = inspect(Mesh(std::move(p), Array<uint32_t>{0, 3}, Array<uint32_t>{0, 1, 2}));
    for (const Finding& f : i.findings)
        if (f.id == "isolated-vertices") {
            QCOMPARE(f.total, size_t(2997));
            QCOMPARE(f.offenders.size(), Inspection::maxOffenders);
            QCOMPARE(f.all.indices.size(), size_t(2997));
        }
}

void InspectorTest::repairAddsTheModifier()
{
    Desk d(sheetWithHole(8));
    QTRY_VERIFY(d.button("repair-holes"));
    const auto stack = [&] { return d.document.scene().find(d.document.scene().node(d.node).mesh)->stack; };
    QTest::mouseClick(d.button("repair-holes"), Qt::LeftButton);
    QTRY_COMPARE(stack().size(), size_t(1));
    QCOMPARE(stack()[0].operation, std::string("fill-holes"));
    QVERIFY(d.row("Holes")->font(0).strikeOut());
    QVERIFY(!d.button("repair-holes")->isEnabled());
    QVERIFY(!d.row("Isolated vertices")->font(0).strikeOut());
    // Taken back, the row stands as before.
    d.document.undo();
    QVERIFY(stack().empty());
    QVERIFY(!d.row("Holes")->font(0).strikeOut());
    QTRY_VERIFY(d.button("repair-holes")->isEnabled());  // the old row's button goes with the next event
    // The new report takes the row away.
    QTest::mouseClick(d.button("repair-holes"), Qt::LeftButton);
    QTRY_COMPARE(stack().size(), size_t(1));
    d.evaluate();
    QTRY_VERIFY(!d.button("repair-holes"));
    QTRY_COMPARE(d.row("Holes")->parent()->text(0), QString("Passed"));
    QCOMPARE(d.row("Isolated vertices")->toolTip(1), QString("1 vertex"));
}

void InspectorTest::repairAllIsOneEntry()
{
    const Mesh mesh = sheetWithHole(8);
    Desk d(mesh);
    QTRY_VERIFY(d.button("inspect-repair-all"));
    const size_t entries = d.document.history().size();
    QTest::mouseClick(d.button("inspect-repair-all"), Qt::LeftButton);
    auto* popup = QApplication::activePopupWidget();
    QVERIFY(popup);
    auto* list = popup->findChild<QListWidget*>("repair-all-list");
    auto* left = popup->findChild<QLabel*>("repair-all-left");
    QVERIFY(list && left);
    QCOMPARE(list->count(), 2);  // fill holes, repair
    QTRY_COMPARE(left->text(), QString("Then nothing is left to fix."));
    // What is foretold is what the operations do: checked against their own results.
    const Mesh filled = std::get<Mesh>(apply(operation("fill-holes"), mesh, {}));
    QVERIFY2(list->item(0)->text().contains(QString("+%1 faces").arg(filled.faceCount() - mesh.faceCount())), qPrintable(list->item(0)->text()));
    QVERIFY2(list->item(1)->text().contains(QString::fromUtf8("\u22121 vertex")), qPrintable(list->item(1)->text()));
    // Without the second one its finding stays.
    list->item(1)->setCheckState(Qt::Unchecked);
    QTRY_COMPARE(left->text(), QString("Still to fix then: Isolated vertices."));
    list->item(1)->setCheckState(Qt::Checked);
    QTest::mouseClick(popup->findChild<QPushButton*>("repair-all-go"), Qt::LeftButton);
    const Scene& s = d.document.scene();
    QCOMPARE(s.find(s.node(d.node).mesh)->stack.size(), size_t(2));
    QCOMPARE(d.document.history().size(), entries + 1);
    d.evaluate();
    QTRY_VERIFY(d.row("Nothing to fix"));
    QVERIFY(d.row("Nothing to fix")->data(0, InspectorRows::SectionFigure).toString().endsWith("checks passed"));
    d.document.undo();
    QVERIFY(d.document.scene().find(d.document.scene().node(d.node).mesh)->stack.empty());
}

void InspectorTest::downWalksTheOffenders()
{
    Desk d(sheetWithHole(8));
    QTRY_VERIFY(d.row("Loop 1"));
    d.panel->activateWindow();
    d.tree()->setFocus();
    QTRY_VERIFY(d.tree()->hasFocus());
    d.tree()->setCurrentItem(d.row("Holes"));
    const auto count = [&] { return d.document.selection().elements.indices.size() / 2; };
    QTRY_COMPARE(count(), size_t(36));  // all of them
    QTest::keyClick(d.tree(), Qt::Key_Down);
    QCOMPARE(d.tree()->currentItem(), d.row("Loop 1"));  // over the sentence
    QCOMPARE(count(), size_t(32));
    QTest::keyClick(d.tree(), Qt::Key_Down);
    QCOMPARE(count(), size_t(4));
    QTest::keyClick(d.tree(), Qt::Key_Up);
    QCOMPARE(count(), size_t(32));
}

void InspectorTest::largeMeshesAreMeasuredForIntersectionsOnDemand()
{
    Inspection i = inspect(sheetWithHole(400));  // 320,000 faces
    const auto find = [&] {
        return std::find_if(i.findings.begin(), i.findings.end(), [](const Finding& f) { return f.id == "self-intersections"; });
    };
    QVERIFY(find() != i.findings.end());
    QVERIFY(!find()->measured && !find()->passed() && !find()->toFix());
    QVERIFY(find()->explanation.contains(QString::number(300)));
    i = inspect(sheetWithHole(20));
    QVERIFY(find() == i.findings.end() || find()->measured);
}

void InspectorTest::aNewerMeshCancelsTheOlderReport()
{
    Desk d(sheetWithHole(300));
    Scene next = d.document.scene();
    MeshObject object = *next.find(next.node(d.node).mesh);
    object.base = sheetWithHole(4);
    next.set(next.node(d.node).mesh, object);
    d.document.commit("smaller", next);
    QTRY_COMPARE(d.figure("faces"), QString::number(30));
    QTRY_VERIFY(!d.jobs.busy());
    QCOMPARE(d.figure("faces"), QString::number(30));
}

void InspectorTest::aBarSelectsItsVertices()
{
    const Mesh mesh = sheetWithHole(8);
    Desk d(mesh);
    QTRY_VERIFY(d.panel->findChild<ValenceHistogram*>());
    auto* h = d.panel->findChild<ValenceHistogram*>();
    const auto valences = topologyOf(mesh).vertexValences;
    for (int i = 0; i < int(h->bars().size()); ++i) {
        const auto& bar = h->bars()[size_t(i)];
        if (bar.valence != 6) continue;
        QCOMPARE(bar.count, valences.at(6));
        QTest::mouseClick(h, Qt::LeftButton, {}, h->barCell(i).center());
    }
    QTRY_VERIFY(d.document.selection().elements.kind == ElementKind::Vertex && !d.document.selection().elements.indices.empty());
    QCOMPARE(d.document.selection().elements.indices.size(), valences.at(6));
    QVERIFY(d.row(QString("The valences add up to %1: every edge counts at both its ends, 2 × %2.")
                      .arg(QLocale().toString(qulonglong(2 * topologyOf(mesh).edges)), QLocale().toString(qulonglong(topologyOf(mesh).edges)))));
    QVERIFY(d.row("Corners of faces"));
}

void InspectorTest::withoutAMeshItSaysSo()
{
    Desk d(sheetWithHole(4));
    Scene empty;
    d.document.open(empty, {}, "New");
    bool said = false;
    for (const QLabel* l : d.panel->findChildren<QLabel*>()) said |= l->isVisible() && l->text() == "Select a mesh to inspect it.";
    QVERIFY(said);
}

QTEST_MAIN(InspectorTest)
#include "inspector_test.moc"
