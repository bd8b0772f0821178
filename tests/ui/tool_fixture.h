// What tests of the view's tools share: a scene in the view, the pointer over it, and the handles of the transform tools.
#pragma once
#include "core/io/io.h"
#include "core/scene/edit.h"
#include "tests/ui/window_fixture.h"
#include "ui/file_commands.h"
#include "ui/viewport/transform_tool.h"
#include "ui/viewport/viewport.h"

namespace mw {

inline Mesh icosphere(int64_t subdivisions)
{
    return std::get<Mesh>(apply(operation("icosphere"), {}, {{"subdivisions", subdivisions}}));
}

class ToolFixture : protected WindowFixture {
protected:
    NodeId firstNode() { return document().scene().nodes().front(); }
    const Node& node(const char* name) { return document().scene().node(nodeOf(document().scene(), name)); }
    glm::dvec2 pixelOf(glm::dvec3 world) { return glm::dvec2(view().look().camera.project(world, view().logicalSize())); }
    static QPoint point(glm::dvec2 p) { return {int(std::lround(p.x)), int(std::lround(p.y))}; }

    TransformTool& transformTool() { return static_cast<TransformTool&>(view().tool()); }

    void open(Scene scene)
    {
        w_->files().openScene(std::move(scene), "Open");
        settle();
        session().view.camera.azimuth = 0.5;
        session().view.camera.elevation = 0.4;
        view().frameAll(false);
    }
    void openSphere(int64_t subdivisions = 3) { open(sceneOf(icosphere(subdivisions), "ball")); }

    void hoverAt(QPoint p)
    {
        QTest::mouseMove(&view(), p + QPoint(1, 1));
        QTest::mouseMove(&view(), p);
    }
    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers m = {}, bool release = true)
    {
        hoverAt(from);
        QTest::mousePress(&view(), Qt::LeftButton, m, from);
        for (int i = 1; i <= 5; ++i) {
            const QPoint at = from + (to - from) * i / 5;
            QMouseEvent e(QEvent::MouseMove, at, view().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, m);
            QApplication::sendEvent(&view(), &e);
        }
        if (release) QTest::mouseRelease(&view(), Qt::LeftButton, m, to);
    }
    const Handle& handle(Handle::Kind kind, int axis, const Gizmo& g)
    {
        for (const Handle& h : g.handles())
            if (h.kind == kind && h.axis == axis) return h;
        throw std::runtime_error("no such handle");
    }
    static glm::dvec2 middle(const Handle& h)
    {
        if (h.kind == Handle::Kind::Axis) return glm::mix(h.line[0], h.line[1], 0.8);
        if (h.kind == Handle::Kind::Plane) return 0.25 * (h.line[0] + h.line[1] + h.line[2] + h.line[3]);
        return h.line[h.line.size() / 2];
    }
    glm::dvec3 worldPlace(const char* name) { return glm::dvec3(document().scene().worldFromLocal(nodeOf(document().scene(), name))[3]); }
    /// The text of the last entry's edits, read again, makes the same of the scene before.
    void repeatsByItsCommand()
    {
        const auto& history = document().history();
        QVERIFY(!history.back().calls.empty());
        Scene again = *history[history.size() - 2].scene;
        for (const EditCall& call : history.back().calls) again = edited(again, parsedEdit(commandText(call)));
        QCOMPARE(contentHash(again), contentHash(document().scene()));
    }
    void selectNodes(std::initializer_list<const char*> names)
    {
        Selection s;
        for (const char* n : names) s.nodes.push_back(nodeOf(document().scene(), n));
        document().select(s);
    }
};

}  // namespace mw
