// Move, rotate and scale in the view: typed numbers, snapping, parents and children, pivots, elements; each drag is one edit that can be repeated.
#include <algorithm>

#include "tests/ui/tool_fixture.h"
#include "ui/stack_edits.h"

using namespace mw;

class TransformTest : public QObject, protected ToolFixture {
    Q_OBJECT

private:
    /// A ball under a parent that is turned and scaled unevenly, and a second one beside it.
    Scene family()
    {
        Scene s;
        MeshObject object;
        object.base = icosphere(2);
        const MeshId mesh = s.add(std::move(object));
        Node parent;
        parent.name = "parent";
        parent.local = {{1, 0, 0}, glm::angleAxis(0.7, glm::dvec3(0, 1, 0)), {2, 2, 2}};
        const NodeId p = s.add(parent);
        Node child;
        child.name = "child";
        child.mesh = mesh;
        child.local = {{0.5, 0.2, 0}, glm::angleAxis(0.3, glm::dvec3(0, 0, 1)), {1, 1, 1}};
        s.add(child, p);
        Node other;
        other.name = "other";
        other.mesh = mesh;
        other.local = {{-3, 0, 1}, {1, 0, 0, 0}, {1, 1, 1}};
        s.add(other);
        return s;
    }

private slots:
    void init() { showWindow(1100, 700); }
    void cleanup() { w_.reset(); }

    void typesNumbersSnapsAndSlows()
    {
        openSphere();
        selectNodes({"ball"});
        session().view.take(ToolKind::Move);
        const auto grabbed = [&](int axis) {
            const auto g = transformTool().gizmo();
            const Handle& h = handle(Handle::Kind::Axis, axis, *g);
            return std::pair{middle(h), glm::normalize(h.line[1] - h.line[0])};
        };
        auto [from, along] = grabbed(1);
        drag(point(from), point(from + 30.0 * along), {}, false);
        for (const char c : std::string("-1.25")) QTest::keyClick(&view(), c);
        QCOMPARE(node("ball").local.translation, glm::dvec3(0, -1.25, 0));  // shown while typing
        const QString viewBefore = QString::number(view().look().camera.azimuth);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, point(from + 30.0 * along));
        QCOMPARE(node("ball").local.translation, glm::dvec3(0, -1.25, 0));
        QCOMPARE(QString::number(view().look().camera.azimuth), viewBefore);  // 1, 2 and 5 are views at other times
        document().undo();

        std::tie(from, along) = grabbed(0);
        drag(point(from), point(from + 47.0 * along));
        const double free = node("ball").local.translation.x;
        document().undo();
        drag(point(from), point(from + 47.0 * along), Qt::ControlModifier);
        const double snapped = node("ball").local.translation.x;
        QCOMPARE(snapped, std::round(10 * free) / 10);
        document().undo();
        drag(point(from), point(from + 47.0 * along), Qt::ShiftModifier);
        const double slow = node("ball").local.translation.x;
        QVERIFY(std::abs(slow - 0.1 * free) < 0.02 * free);
        document().undo();

        const size_t entries = document().history().size();
        drag(point(from), point(from + 47.0 * along), {}, false);
        QVERIFY(node("ball").local.translation.x > 0.05);
        QTest::keyClick(&view(), Qt::Key_Escape);
        QCOMPARE(node("ball").local.translation, glm::dvec3(0));
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, point(from));
        QCOMPARE(document().history().size(), entries);
        QVERIFY(session().view.tool == ToolKind::Move);  // Esc took the drag back, not the tool
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(session().view.tool == ToolKind::Select);
    }

    void typedTurnsAndFactors()
    {
        openSphere();
        selectNodes({"ball"});
        session().view.take(ToolKind::Rotate);
        auto g = transformTool().gizmo();
        const Handle& ring = handle(Handle::Kind::Ring, 1, *g);
        glm::dvec2 at = middle(ring);
        for (const glm::dvec2& p : ring.line)
            if (g->handles()[size_t(std::max(0, g->at(p)))].axis == 1 && g->at(p) >= 0 && g->handles()[size_t(g->at(p))].kind == Handle::Kind::Ring)
                at = p;
        drag(point(at), point(at) + QPoint(9, 0), {}, false);
        for (const char c : std::string("30")) QTest::keyClick(&view(), c);
        QTest::keyClick(&view(), Qt::Key_Return);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, point(at));
        const glm::dquat turned = node("ball").local.rotation, expected = glm::angleAxis(glm::radians(30.0), glm::dvec3(0, 1, 0));
        QVERIFY(std::abs(glm::dot(turned, expected)) > 1 - 1e-12);
        session().view.take(ToolKind::Scale);
        g = transformTool().gizmo();
        at = middle(handle(Handle::Kind::Free, 0, *g));
        drag(point(at), point(at) + QPoint(20, 0), {}, false);
        for (const char c : std::string("2.5")) QTest::keyClick(&view(), c);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, point(at));
        QCOMPARE(node("ball").local.scale, glm::dvec3(2.5));
    }

    void parentsAndChildrenMoveOnce()
    {
        open(family());
        selectNodes({"parent", "child", "other"});
        const glm::dvec3 child = worldPlace("child"), other = worldPlace("other"), parent = worldPlace("parent");
        session().view.take(ToolKind::Move);
        const auto g = transformTool().gizmo();
        const glm::dvec2 at = middle(handle(Handle::Kind::Axis, 2, *g));
        const size_t entries = document().history().size();
        drag(point(at), point(at) + QPoint(8, 8), {}, false);
        QTest::keyClick(&view(), '2');
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, point(at));
        QCOMPARE(document().history().size(), entries + 1);
        QCOMPARE(document().history().back().calls.size(), size_t(2));  // not the child: it came along
        repeatsByItsCommand();
        for (const auto& [name, before] : {std::pair{"child", child}, {"other", other}, {"parent", parent}})
            QVERIFY2(glm::length(worldPlace(name) - before - glm::dvec3(0, 0, 2)) < 1e-12, name);
    }

    void aChildOfAScaledParentFollowsTheWorld()
    {
        open(family());
        selectNodes({"child"});
        const glm::dvec3 before = worldPlace("child");
        session().view.take(ToolKind::Move);
        auto g = transformTool().gizmo();
        glm::dvec2 at = middle(handle(Handle::Kind::Axis, 0, *g));
        drag(point(at), point(at) + QPoint(8, 8), {}, false);
        QTest::keyClick(&view(), '1');
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, point(at));
        QVERIFY(glm::length(worldPlace("child") - before - glm::dvec3(1, 0, 0)) < 1e-12);
        // About the world's X: each point of the ball turns about its origin.
        const glm::dmat4 world = document().scene().worldFromLocal(nodeOf(document().scene(), "child"));
        session().view.take(ToolKind::Rotate);
        g = transformTool().gizmo();
        const Handle& ring = handle(Handle::Kind::Ring, 0, *g);
        for (const glm::dvec2& p : ring.line)
            if (g->at(p) >= 0 && &g->handles()[size_t(g->at(p))] == &ring) at = p;
        drag(point(at), point(at) + QPoint(5, 5), {}, false);
        for (const char c : std::string("90")) QTest::keyClick(&view(), c);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, point(at));
        const glm::dmat4 after = document().scene().worldFromLocal(nodeOf(document().scene(), "child"));
        const glm::dmat3 quarter = glm::mat3_cast(glm::angleAxis(glm::radians(90.0), glm::dvec3(1, 0, 0)));
        const glm::dmat3 expected = quarter * glm::dmat3(world);
        for (int c = 0; c < 3; ++c) QVERIFY(glm::length(glm::dmat3(after)[c] - expected[c]) < 1e-9);
        QVERIFY(glm::length(glm::dvec3(after[3] - world[3])) < 1e-12);
    }

    void turnsAboutTheMiddleOfSeveral()
    {
        open(family());
        selectNodes({"parent", "other"});
        session().view.pivotCentre = true;
        session().view.take(ToolKind::Rotate);
        const auto g = transformTool().gizmo();
        const glm::dvec3 pivot = g->place().origin, before = worldPlace("other");
        const Handle& ring = handle(Handle::Kind::Ring, 1, *g);
        glm::dvec2 at = middle(ring);
        for (const glm::dvec2& p : ring.line)
            if (g->at(p) >= 0 && &g->handles()[size_t(g->at(p))] == &ring) at = p;
        drag(point(at), point(at) + QPoint(6, 0), {}, false);
        for (const char c : std::string("180")) QTest::keyClick(&view(), c);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, point(at));
        const glm::dvec3 expected(2 * pivot.x - before.x, before.y, 2 * pivot.z - before.z);
        QVERIFY(glm::length(worldPlace("other") - expected) < 1e-9);
    }

    void movesElementsOfTheBase()
    {
        openSphere(2);
        const Mesh before = document().scene().find(document().scene().meshes().front())->base;
        document().select({{firstNode()}, firstNode(), {ElementKind::Face, {0, 1, 2}}});
        session().view.take(ToolKind::Move);
        const auto g = transformTool().gizmo();
        QVERIFY(g.has_value());
        const glm::dvec2 at = middle(handle(Handle::Kind::Axis, 1, *g));
        drag(point(at), point(at) + QPoint(0, -12), {}, false);
        for (const char c : std::string("0.5")) QTest::keyClick(&view(), c);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, point(at));
        const Mesh after = document().scene().find(document().scene().meshes().front())->base;
        QCOMPARE(after.cornerVertex().id(), before.cornerVertex().id());
        const std::vector<uint32_t> moved = [&] {
            std::vector<uint32_t> v;
            for (const uint32_t f : {0u, 1u, 2u})
                for (const uint32_t i : before.face(f)) v.push_back(i);
            return v;
        }();
        for (uint32_t v = 0; v < before.vertexCount(); ++v) {
            const bool in = std::find(moved.begin(), moved.end(), v) != moved.end();
            QCOMPARE(after.positions()[v], before.positions()[v] + (in ? glm::vec3(0, 0.5f, 0) : glm::vec3(0)));
        }
        QCOMPARE(document().selection().elements.indices, (std::vector<uint32_t>{0, 1, 2}));
        QCOMPARE(QString::fromStdString(document().history().back().calls.at(0).id), QString("move-elements"));
        QCOMPARE(QString::fromStdString(document().undoName()), QString("ball: move faces"));
        repeatsByItsCommand();
        // With a modifier on top the elements on screen are none of the base.
        edits::addModifier(document(), document().scene().meshes().front(), operation("subdivide-loop"), {{"levels", int64_t(1)}});
        settle();
        document().select({{firstNode()}, firstNode(), {ElementKind::Face, {0}}});
        QVERIFY(!transformTool().gizmo());
        QVERIFY(!transformSubject(session(), view().look(), ToolKind::Move).obstacle.isEmpty());
        session().view.shownLevel[document().scene().meshes().front()] = 0;
        session().view.touch();
        QVERIFY(transformTool().gizmo().has_value());
    }
};

int main(int argc, char** argv)
{
    return runTests<TransformTest>(argc, argv);
}

#include "transform_test.moc"
