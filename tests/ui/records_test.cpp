// The Records panel: its links move the pick and follow it, back and forward, its queries answer in text and in the view, it stays right through
// changes of the mesh.
#include "ui/panels/records.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include "core/catalog/catalog.h"
#include "core/mesh/halfedge_walk.h"
#include "core/mesh/primitives.h"
#include "core/mesh/triangle_adjacency.h"
#include "tests/ui/panel_desk.h"
#include "ui/panels/record_tables.h"

using namespace mw;

namespace {

Mesh made(const char* id, const ParameterValues& values = {})
{
    return std::get<Mesh>(apply(operation(id), std::monostate{}, values));
}

// 4 x 4 squares of two triangles, open.
Mesh sheet()
{
    Array<glm::vec3> p;
    Array<uint32_t> t;
    for (uint32_t y = 0; y < 5; ++y)
        for (uint32_t x = 0; x < 5; ++x) p.push_back({float(x), float(y), 0});
    for (uint32_t y = 0; y < 4; ++y)
        for (uint32_t x = 0; x < 4; ++x) {
            const uint32_t a = 5 * y + x;
            for (const uint32_t i : {a, a + 1, a + 6, a, a + 6, a + 5}) t.push_back(i);
        }
    return Mesh::triangles(std::move(p), std::move(t));
}

struct Desk : PanelDesk {
    explicit Desk(const Mesh& mesh, bool untilInPlace = true) : PanelDesk(mesh) { show(makeRecordsPanel, 304, 700, untilInPlace); }
    void pick(ElementKind kind, std::vector<uint32_t> indices) { document.select({{node}, node, {kind, std::move(indices)}}); }
    QTableWidget* table() const { return panel->findChild<QTableWidget*>("records-table"); }
    QString title() const { return panel->findChild<QLabel*>("records-title")->text(); }
    QString answer() const { return panel->findChild<QLabel*>("records-answer")->text(); }
    /// The cell beside a name below a heading.
    QTableWidgetItem* cell(const QString& heading, const QString& name) const
    {
        bool below = false;
        for (int r = 0; r < table()->rowCount(); ++r) {
            if (table()->columnSpan(r, 0) == 4) below = table()->item(r, 0)->text().startsWith(heading);
            for (int c = 0; below && c < 4; c += 2)
                if (table()->item(r, c) && (table()->item(r, c)->text() == name || table()->item(r, c)->text().startsWith(name + ' ')))
                    return table()->item(r, c + 1);
        }
        return nullptr;
    }
    void click(QTableWidgetItem* item) const
    {
        table()->scrollToItem(item);
        QTest::mouseClick(table()->viewport(), Qt::LeftButton, {}, table()->visualItemRect(item).center());
    }
    void click(const char* button) const { QTest::mouseClick(panel->findChild<QAbstractButton*>(button), Qt::LeftButton); }
};

}  // namespace

class RecordsTest : public QObject {
    Q_OBJECT

private slots:
    void withoutAPickItSaysWhatToDo();
    void aClickOnNextWalksRoundTheFace();
    void backAndForward();
    void thePickInTheViewIsFollowed();
    void queriesAnswerInTextAndColours();
    void missingNeighboursAreMarked();
    void thePrimitiveIsThatOfTheTable();
    void hoveringFlashes();
    void itStaysRightThroughUndoAndModifiers();
    void aHiddenPanelDrawsNothing();
    void aLargeMeshIsAJob();
};

void RecordsTest::withoutAPickItSaysWhatToDo()
{
    Desk d(sheet());
    QVERIFY(!d.table()->isVisible());
    QPushButton* button = nullptr;
    for (QPushButton* b : d.panel->findChildren<QPushButton*>())
        if (b->isVisible()) button = b;
    QVERIFY(button);
    QCOMPARE(button->text(), QString("Pick vertices"));
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(d.view.pickKind, PickKind::Vertex);
    QTest::mouseClick(button, Qt::LeftButton);  // now: start at the first face
    QVERIFY(d.table()->isVisible());
    QCOMPARE(d.title(), QString("Face 0"));
}

void RecordsTest::aClickOnNextWalksRoundTheFace()
{
    Desk d(sheet());
    d.pick(ElementKind::Face, {9});
    d.click(d.cell("Half-edge", "next"));
    const QString first = d.title();
    QVERIFY(first.startsWith("Half-edge"));
    QStringList met{first};
    for (int i = 0; i < 3; ++i) {
        d.click(d.cell("Half-edge", "next"));
        met << d.title();
        QCOMPARE(d.cell("Half-edge", "face")->text(), QString("f9"));
    }
    QCOMPARE(met[3], first);  // a triangle: round after three
    QCOMPARE(met.removeDuplicates(), 1);
    QCOMPARE(d.document.selection().elements.kind, ElementKind::Edge);
    QCOMPARE(d.view.pickKind, PickKind::Edge);
    d.click(d.cell("Half-edge", "pair"));
    QVERIFY(d.cell("Half-edge", "face")->text() != "f9");
    d.click(d.cell("Half-edge", "pair"));
    QCOMPARE(d.title(), first);
}

void RecordsTest::backAndForward()
{
    Desk d(sheet());
    d.pick(ElementKind::Vertex, {12});
    d.click(d.cell("Winged-edge", "left"));
    const QString second = d.title();
    QVERIFY(second.startsWith("Face"));
    d.click("records-back");
    QCOMPARE(d.title(), QString("Vertex 12"));
    QCOMPARE(d.document.selection().elements.indices, std::vector<uint32_t>{12});
    QVERIFY(!d.panel->findChild<QToolButton*>("records-back")->isEnabled());
    d.click("records-forward");
    QCOMPARE(d.title(), second);
    d.table()->setFocus();
    QTest::keyClick(d.table(), Qt::Key_Left, Qt::AltModifier);
    QCOMPARE(d.title(), QString("Vertex 12"));
}

void RecordsTest::thePickInTheViewIsFollowed()
{
    Desk d(sheet());
    d.pick(ElementKind::Vertex, {7});
    QCOMPARE(d.title(), QString("Vertex 7"));
    d.pick(ElementKind::Edge, {6, 7});
    QVERIFY(d.title().contains("6 to 7"));
    d.pick(ElementKind::Face, {3});
    QCOMPARE(d.title(), QString("Face 3"));
    QCOMPARE(d.cell("Face-based", "p1")->text(), QString("v1"));
    d.pick(ElementKind::Vertex, {});
    QVERIFY(!d.table()->isVisible());
}

void RecordsTest::queriesAnswerInTextAndColours()
{
    Desk d(sheet());
    const QString expected[] = {"6 vertices", "6 edges", "6 faces", "2 vertices", "10 edges", "2 faces", "3 vertices", "3 edges", "3 faces"};
    const std::vector<std::vector<uint32_t>> picks{{12}, {12, 13}, {10}};
    const ElementKind kinds[] = {ElementKind::Vertex, ElementKind::Edge, ElementKind::Face};
    for (int q = 0; q < 9; ++q) {
        d.pick(kinds[q / 3], picks[size_t(q / 3)]);
        d.click(qPrintable(QString("records-query-%1").arg(q)));
        QVERIFY2(d.answer().contains(expected[q]), qPrintable(d.answer()));
        QCOMPARE(d.view.sketch.marks.size(), size_t(2));  // the answer, and what is asked about
        QCOMPARE(int(d.view.sketch.marks[0].kind), int(kinds[q % 3]));
        QCOMPARE(int(d.view.sketch.marks[1].kind), int(kinds[q / 3]));
        QVERIFY(!d.view.sketch.labels.empty());
    }
    d.pick(ElementKind::Vertex, {12});
    d.click("records-query-0");
    QVERIFY2(d.answer().contains("v6, v7, v11, v13, v17, v18"), qPrintable(d.answer()));
    d.click("records-select-answer");
    QCOMPARE(d.document.selection().elements.indices, (std::vector<uint32_t>{6, 7, 11, 13, 17, 18}));
}

void RecordsTest::missingNeighboursAreMarked()
{
    Desk d(sheet());
    d.pick(ElementKind::Face, {0});  // vertices 0, 1, 6: nothing beyond 0 1
    QCOMPARE(d.cell("Face-based", "t1")->text(), QString("none"));
    QVERIFY(d.cell("Face-based", "t2")->text().startsWith("f"));
    QCOMPARE(d.cell("Triangle adjacency", "V1")->text(), QString("none"));
    QVERIFY(d.cell("Triangle adjacency", "V1")->toolTip().contains("v0 stands again"));
    QCOMPARE(d.cell("Triangle adjacency", "V0")->text(), QString("v0"));
    const QString before = d.title();
    d.click(d.cell("Face-based", "t1"));  // no link
    QCOMPARE(d.title(), before);
    auto* drawing = d.panel->findChild<QComboBox*>("records-drawing");
    drawing->setCurrentIndex(int(RecordDrawing::Primitive));
    emit drawing->activated(drawing->currentIndex());
    int dashed = 0;
    for (const MarkPoint& p : d.view.sketch.points) dashed += p.dashed;
    QCOMPARE(dashed, 1);
    QStringList letters;
    for (const Label& l : d.view.sketch.labels) letters << QString::fromStdString(l.text);
    QVERIFY2(letters.contains("V1 = V0: none"), qPrintable(letters.join(", ")));
    QVERIFY(letters.contains("V3"));
}

void RecordsTest::thePrimitiveIsThatOfTheTable()
{
    for (const Mesh& mesh : {sheet(), made("icosphere", {{"subdivisions", int64_t(2)}})}) {
        const RecordMesh m(mesh);
        const Array<uint32_t> six = adjacencyIndices(mesh);
        for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
            const auto own = adjacencyOf(m.walk, m.mesh, f);
            QVERIFY(own);
            for (size_t k = 0; k < 6; ++k) QCOMPARE((*own)[k], six[6 * size_t(f) + k]);
        }
    }
}

void RecordsTest::hoveringFlashes()
{
    Desk d(sheet());
    d.pick(ElementKind::Vertex, {12});
    QTableWidgetItem* next = d.cell("Half-edge", "vert");
    const QPoint at = d.table()->visualItemRect(next).center();
    QTest::mouseMove(d.table()->viewport(), at - QPoint(3, 0));
    QTest::mouseMove(d.table()->viewport(), at);
    QTRY_COMPARE(d.view.flashes.size(), size_t(1));
    QCOMPARE(d.view.flashes[0].kind, ElementKind::Vertex);
}

void RecordsTest::itStaysRightThroughUndoAndModifiers()
{
    Desk d(sheet());
    d.pick(ElementKind::Vertex, {24});
    QCOMPARE(d.title(), QString("Vertex 24"));
    const MeshId id = d.document.scene().node(d.node).mesh;
    Scene s = d.document.scene();
    MeshObject object = *s.find(id);
    object.base = made("icosphere", {{"subdivisions", int64_t(0)}});
    s.set(id, object);
    d.document.commit("sheet: other mesh", s);
    d.pick(ElementKind::Vertex, {5});
    QCOMPARE(d.title(), QString("Vertex 5"));
    d.click("records-query-0");
    QVERIFY(d.answer().contains("5 vertices"));
    d.document.undo();
    d.pick(ElementKind::Vertex, {24});
    QCOMPARE(d.title(), QString("Vertex 24"));
    // A level of the stack: the panel is about what is shown.
    s = d.document.scene();
    object = *s.find(id);
    object.stack.push_back({{}, "subdivide-loop", {}, true});
    s.set(id, object);
    d.document.commit("sheet: Loop", s);
    d.document.setEvaluation(id, std::make_shared<const Evaluation>(Evaluator().evaluate(*d.document.scene().find(id))));
    d.pick(ElementKind::Face, {127});  // 32 faces before
    QCOMPARE(d.title(), QString("Face 127"));
    d.view.shownLevel[id] = 0;
    d.view.touch();
    QVERIFY(!d.table()->isVisible());  // the base has no such face
    d.view.shownLevel.erase(id);
    d.view.touch();
    QCOMPARE(d.title(), QString("Face 127"));
}

void RecordsTest::aHiddenPanelDrawsNothing()
{
    Desk d(sheet());
    d.pick(ElementKind::Vertex, {12});
    QVERIFY(!d.view.sketch.points.empty());
    d.panel->hide();
    QVERIFY(d.view.sketch.points.empty());
    d.pick(ElementKind::Vertex, {13});
    QVERIFY(d.view.sketch.points.empty());
    d.panel->show();
    QTRY_VERIFY(!d.view.sketch.points.empty());
    QCOMPARE(d.title(), QString("Vertex 13"));
}

void RecordsTest::aLargeMeshIsAJob()
{
    const Mesh mesh = made("icosphere", {{"subdivisions", int64_t(6)}});
    QVERIFY(mesh.faceCount() > 30'000);
    Desk d(mesh, false);
    d.pick(ElementKind::Face, {70'000});
    QVERIFY(!d.table()->isVisible());  // not made on this thread
    QVERIFY(d.jobs.busy());
    QTRY_VERIFY(d.table()->isVisible());
    QCOMPARE(d.title(), QString("Face 70000"));
}

QTEST_MAIN(RecordsTest)
#include "records_test.moc"
