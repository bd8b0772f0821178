// The pointer hits what it points at: faces, boxes, lassos, handles, corners, edges. CTest runs this at several device pixel ratios.
#include <QClipboard>
#include <QFile>
#include <random>

#include "core/mesh/select.h"
#include "tests/ui/tool_fixture.h"
#include "ui/viewport/collapse_tool.h"
#include "ui/viewport/measure_tool.h"

using namespace mw;

namespace {

/// The first face that a ray meets, by trying every triangle: what a pick has to find. `none`: nothing.
uint32_t firstHit(const Mesh& mesh, const glm::dmat4& worldFromLocal, const Ray& ray)
{
    const Mesh::Triangulation& t = mesh.triangulation();
    const auto world = [&](uint32_t v) { return glm::dvec3(worldFromLocal * glm::dvec4(glm::dvec3(mesh.positions()[v]), 1)); };
    double nearest = 1e300;
    uint32_t face = none;
    for (size_t i = 0; i < t.faces.size(); ++i) {
        const glm::dvec3 a = world(t.vertices[3 * i]), u = world(t.vertices[3 * i + 1]) - a, v = world(t.vertices[3 * i + 2]) - a;
        const glm::dvec3 p = glm::cross(ray.direction, v), s = ray.origin - a, q = glm::cross(s, u);
        const double det = glm::dot(u, p);
        if (det == 0) continue;
        const double x = glm::dot(s, p) / det, y = glm::dot(ray.direction, q) / det, d = glm::dot(v, q) / det;
        if (x < 0 || y < 0 || x + y > 1 || d <= 0 || d >= nearest) continue;
        nearest = d;
        face = t.faces[i];
    }
    return face;
}

}  // namespace

class PointerTest : public QObject, protected ToolFixture {
    Q_OBJECT

private:
    void clickFaces(const Mesh& mesh, size_t wanted)
    {
        session().view.pickKind = PickKind::Face;
        std::mt19937 random(5);
        std::uniform_real_distribution<double> x(2, view().width() - 3), y(2, view().height() - 3);
        const double ratio = view().pixelRatio();
        size_t tried = 0;
        for (int i = 0; i < 4000 && tried < wanted; ++i) {
            const glm::dvec2 at(std::floor(x(random)), std::floor(y(random)));
            // The face has to be the same over the pixel and those beside it: no matter how an edge is rounded.
            const auto face = [&](glm::dvec2 p) { return firstHit(mesh, glm::dmat4(1), view().ray(p)); };
            const uint32_t expected = face(at);
            const double pixel = 1 / ratio;
            if (expected == none || face(at + glm::dvec2(pixel, 0)) != expected || face(at + glm::dvec2(0, pixel)) != expected ||
                face(at - glm::dvec2(pixel, 0)) != expected || face(at - glm::dvec2(0, pixel)) != expected)
                continue;
            if (at.x > view().width() - 100 && at.y < 100) continue;  // the orientation marker
            ++tried;
            QTest::mouseClick(&view(), Qt::LeftButton, {}, point(at));
            QCOMPARE(document().selection().elements.kind, ElementKind::Face);
            QCOMPARE(document().selection().elements.indices, std::vector<uint32_t>{expected});
        }
        QVERIFY2(tried == wanted, qPrintable(QString::number(tried)));
    }

private slots:
    void init() { showWindow(1100, 700); }
    void cleanup() { w_.reset(); }

    void theRatioIsTheOneAskedFor()
    {
        const double asked = qEnvironmentVariable("QT_SCALE_FACTOR", "1").toDouble();
        QCOMPARE(view().pixelRatio(), asked);
    }

    void clicksTheFaceThatIsThere()
    {
        openSphere();
        clickFaces(document().scene().find(document().scene().meshes().front())->base, 40);
    }

    void clicksTheFaceOfAScan()
    {
        const QString file = qEnvironmentVariable("MESHWRIGHT_DATA") + "/meshes/closed_genus0/spot.obj";
        if (!QFile::exists(file)) QSKIP("MESHWRIGHT_DATA is not set");
        open(readFile(file.toStdString()).scene);
        clickFaces(document().scene().find(document().scene().meshes().front())->base, 25);
    }

    void boxTakesWhatLiesInIt()
    {
        openSphere(4);
        session().view.pickKind = PickKind::Vertex;
        QTest::keyClick(&view(), Qt::Key_B);
        QVERIFY(session().view.tool == ToolKind::Box);
        const QPoint c = point(pixelOf({0, 0, 0})), low = c - QPoint(40, 25), high = c + QPoint(50, 35);
        const Mesh& mesh = document().scene().find(document().scene().meshes().front())->base;
        const glm::dvec3 eye = view().look().camera.eye();
        // Each vertex but those within 1.5 pixels of the box's sides.
        const auto check = [&](bool hiddenToo) {
            drag(low, high);
            const std::vector<uint32_t> chosen = document().selection().elements.indices;
            QVERIFY(std::is_sorted(chosen.begin(), chosen.end()));
            size_t sure = 0;
            for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
                const glm::dvec3 p(mesh.positions()[v]);
                const glm::dvec2 at = pixelOf(p);
                const double within = std::min({at.x - low.x(), high.x() - at.x, at.y - low.y(), high.y() - at.y});
                if (std::abs(within) < 1.5) continue;
                const bool expected = within > 0 && (hiddenToo || glm::dot(p, eye - p) > 0);
                QVERIFY2(std::binary_search(chosen.begin(), chosen.end(), v) == expected, qPrintable(QString::number(v)));
                sure += expected;
            }
            QVERIFY2(sure > 10, qPrintable(QString::number(sure)));
        };
        check(false);
        session().view.options.xray = true;  // lets the far side in
        session().view.touch();
        check(true);
    }

    void lassoAddsAndRemoves()
    {
        openSphere(4);
        session().view.pickKind = PickKind::Face;
        QTest::keyClick(&view(), Qt::Key_L);
        QVERIFY(session().view.tool == ToolKind::Lasso);
        const QPoint c = point(pixelOf({0, 0, 0}));
        const auto triangle = [&](QPoint shift, Qt::KeyboardModifiers m) {  // pointing down
            const QPoint corners[] = {c + shift + QPoint(-60, -40), c + shift + QPoint(60, -40), c + shift + QPoint(0, 60),
                                      c + shift + QPoint(-60, -40)};
            QTest::mousePress(&view(), Qt::LeftButton, m, corners[0]);
            for (int k = 0; k < 3; ++k)
                for (int i = 1; i <= 10; ++i) {
                    const QPoint at = corners[k] + (corners[k + 1] - corners[k]) * i / 10;
                    QMouseEvent e(QEvent::MouseMove, at, view().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, m);
                    QApplication::sendEvent(&view(), &e);
                }
            QTest::mouseRelease(&view(), Qt::LeftButton, m, corners[3]);
            return document().selection().elements.indices;
        };
        const auto first = triangle({0, 0}, {});
        QVERIFY(first.size() > 10);
        // What the middle of a face says: inside the triangle means chosen, well outside means not.
        const Mesh& mesh = document().scene().find(document().scene().meshes().front())->base;
        const auto side = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); };
        const glm::dvec2 o(c.x(), c.y());
        size_t inside = 0;
        for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
            glm::dvec3 m(0);
            bool front = true, far = true;
            for (const uint32_t v : mesh.face(f)) {
                const glm::dvec3 p(mesh.positions()[v]);
                m += p / 3.0;
                front = front && glm::dot(p, view().look().camera.eye() - p) > 0;
                const glm::dvec2 at = pixelOf(p);
                far = far && (at.y < o.y - 42 || side(o + glm::dvec2(60, -40), o + glm::dvec2(0, 60), at) < -400 ||
                              side(o + glm::dvec2(0, 60), o + glm::dvec2(-60, -40), at) < -400);
            }
            const glm::dvec2 at = pixelOf(m);
            const bool in = at.y > o.y - 38 && side(o + glm::dvec2(60, -40), o + glm::dvec2(0, 60), at) > 300 &&
                            side(o + glm::dvec2(0, 60), o + glm::dvec2(-60, -40), at) > 300;
            const bool has = std::binary_search(first.begin(), first.end(), f);
            if (front && in) QVERIFY2(has, qPrintable(QString::number(f)));
            inside += front && in;
            if (!front || far) QVERIFY2(!has, qPrintable(QString::number(f)));
        }
        QVERIFY(inside > 10);
        const auto more = triangle({50, 0}, Qt::ShiftModifier);
        QVERIFY(std::includes(more.begin(), more.end(), first.begin(), first.end()) && more.size() > first.size());
        const auto less = triangle({0, 0}, Qt::ControlModifier);
        std::vector<uint32_t> expected;
        std::set_difference(more.begin(), more.end(), first.begin(), first.end(), std::back_inserter(expected));
        QCOMPARE(less, expected);
        // From the Select tool by Ctrl+Shift.
        QTest::keyClick(&view(), Qt::Key_Q);
        QCOMPARE(triangle({0, 0}, Qt::ControlModifier | Qt::ShiftModifier), more);
    }

    void everyHandleIsHitWhereItIsDrawn()
    {
        openSphere();
        selectNodes({"ball"});
        for (const ToolKind kind : {ToolKind::Move, ToolKind::Rotate, ToolKind::Scale}) {
            session().view.take(kind);
            const auto g = transformTool().gizmo();
            QVERIFY(g.has_value());
            QCOMPARE(g->handles().size(), kind == ToolKind::Rotate ? size_t(4) : size_t(7));
            for (const Handle& h : g->handles()) {
                glm::dvec2 at = middle(h);
                if (h.kind == Handle::Kind::Ring) {  // a place of its own: rings cross
                    for (const glm::dvec2& p : h.line)
                        if (&g->handles()[size_t(std::max(0, g->at(p)))] == &h) at = p;
                }
                const int found = g->at(at);
                QVERIFY(found >= 0);
                QCOMPARE(&g->handles()[size_t(found)], &h);
                hoverAt(point(at));
                QCOMPARE(view().cursor().shape(), Qt::SizeAllCursor);
            }
            // 90 pixels on screen at any distance, for an axis across the line of sight.
            session().view.camera.distance *= 3;
            const auto far = transformTool().gizmo();
            for (const Handle& h : far->handles())
                if (h.kind == Handle::Kind::Axis) QVERIFY(glm::distance(h.line[1], pixelOf({0, 0, 0})) < 97);
            session().view.camera.distance /= 3;
        }
    }

    void movesAlongAnAxisAsFarAsThePointerGoes()
    {
        openSphere();
        selectNodes({"ball"});
        QTest::keyClick(&view(), Qt::Key_W);
        QVERIFY(session().view.tool == ToolKind::Move);
        const auto g = transformTool().gizmo();
        const Handle& h = handle(Handle::Kind::Axis, 0, *g);
        const glm::dvec2 from = middle(h), along = glm::normalize(h.line[1] - h.line[0]);
        const size_t entries = document().history().size();
        const QPoint a = point(from), b = point(from + 60.0 * along);
        const double azimuth = view().look().camera.azimuth;
        drag(a, b);
        QCOMPARE(document().history().size(), entries + 1);
        QCOMPARE(QString::fromStdString(document().undoName()), QString("ball: move"));
        QCOMPARE(view().look().camera.azimuth, azimuth);
        const glm::dvec3 to = node("ball").local.translation;
        QVERIFY(to.x > 0.05 && to.y == 0 && to.z == 0);
        // The place that was grabbed is under the pointer again: it moved with the node, as seen.
        const Ray r = view().ray(from);
        const double bb = glm::dot(glm::dvec3(1, 0, 0), r.direction);
        const double t = (r.origin.x - glm::dot(r.origin, r.direction) * bb) / (1 - bb * bb);
        QVERIFY(glm::distance(pixelOf({t + to.x, 0, 0}), pixelOf({t, 0, 0}) + glm::dvec2(b.x() - a.x(), b.y() - a.y())) < 3);
        repeatsByItsCommand();
        document().undo();
        QCOMPARE(node("ball").local.translation, glm::dvec3(0));
    }

    void measuresACube()
    {
        open(sceneOf(std::get<Mesh>(apply(operation("box"), {}, {})), "box"));
        const Mesh& mesh = document().scene().find(document().scene().meshes().front())->base;
        QTest::keyClick(&view(), Qt::Key_D);
        auto& tool = static_cast<MeasureTool&>(view().tool(ToolKind::Measure));
        // Three corners of a face that is seen: the first such that all three are in front.
        const glm::dvec3 eye = view().look().camera.eye();
        std::array<glm::dvec3, 3> corners;
        bool found = false;
        for (uint32_t f = 0; f < mesh.faceCount() && !found; ++f) {
            const auto face = mesh.face(f);
            for (size_t i = 0; i < 3; ++i) corners[i] = glm::dvec3(mesh.positions()[face[i]]);
            found = glm::dot(glm::cross(corners[1] - corners[0], corners[2] - corners[0]), eye - corners[0]) > 0.2;
        }
        QVERIFY(found);
        for (const glm::dvec3& c : corners) {  // a little beside it: it snaps
            const glm::dvec2 inwards = glm::normalize(pixelOf((corners[0] + corners[1] + corners[2]) / 3.0) - pixelOf(c));
            QTest::mouseClick(&view(), Qt::LeftButton, {}, point(pixelOf(c) + 4.0 * inwards));
        }
        QCOMPARE(tool.points().size(), size_t(3));
        for (size_t i = 0; i < 3; ++i) {
            QVERIFY(tool.points()[i].on == MeasuredPoint::On::Vertex);
            QVERIFY(glm::length(tool.points()[i].at - corners[i]) < 1e-6);
        }
        const QString said = tool.copyText();
        const auto value = [&](const QString& name) { return said.section(name + "\t", 1, 1).section('\n', 0, 0).toDouble(); };
        const double a = glm::distance(corners[0], corners[1]), b = glm::distance(corners[1], corners[2]), c = glm::distance(corners[2], corners[0]);
        QVERIFY(std::abs(value("distance") - a) < 1e-6);
        QVERIFY(std::abs(value("angle") - std::acos((a * a + b * b - c * c) / (2 * a * b)) * 180 / M_PI) < 1e-5);  // law of cosines
        QVERIFY(std::abs(value("area") - 0.5 * a * b * std::sin(value("angle") * M_PI / 180)) < 1e-6);
        QTest::keyClick(&view(), Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(), said);
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(tool.points().empty());
        QVERIFY(session().view.tool == ToolKind::Measure);
        // Somewhere on a face: the weights make the point.
        const glm::dvec3 inside = 0.5 * corners[0] + 0.3 * corners[1] + 0.2 * corners[2];
        QTest::mouseClick(&view(), Qt::LeftButton, {}, point(pixelOf(inside)));
        const MeasuredPoint& p = tool.points().at(0);
        QVERIFY(p.on == MeasuredPoint::On::Face);
        glm::dvec3 mixed(0);
        for (int i = 0; i < 3; ++i) mixed += p.weights[i] * glm::dvec3(mesh.positions()[p.corners[i]]);
        QVERIFY(glm::length(mixed - p.at) < 1e-6);
        QVERIFY(glm::distance(pixelOf(p.at), glm::dvec2(point(pixelOf(inside)).x(), point(pixelOf(inside)).y())) < 1.0);
    }

    void collapsesAnEdgeByHand()
    {
        openSphere(2);
        const MeshId id = document().scene().meshes().front();
        const Mesh mesh = document().scene().find(id)->base;
        QTest::keyClick(&view(), Qt::Key_O);
        QVERIFY(session().view.tool == ToolKind::Collapse);
        auto& tool = static_cast<CollapseTool&>(view().tool(ToolKind::Collapse));
        const glm::dvec3 eye = view().look().camera.eye();
        glm::dvec3 nearest(0);
        for (size_t e = 0; e < mesh.edges().size(); e += 2) {
            const glm::dvec3 m = 0.5 * (glm::dvec3(mesh.positions()[mesh.edges()[e]]) + glm::dvec3(mesh.positions()[mesh.edges()[e + 1]]));
            if (nearest == glm::dvec3(0) || glm::distance(m, eye) < glm::distance(nearest, eye)) nearest = m;
        }
        const QPoint at = point(pixelOf(nearest));
        hoverAt(at);
        QTRY_VERIFY(tool.hovered() && tool.hovered()->legal);
        QVERIFY(tool.hovered()->reason.isEmpty());
        QTest::mouseClick(&view(), Qt::LeftButton, {}, at);
        settle();
        QCOMPARE(document().shownMesh(id).faceCount(), mesh.faceCount() - 2);
        QCOMPARE(document().scene().find(id)->stack.size(), size_t(1));
        document().undo();
        settle();
        QCOMPARE(document().shownMesh(id).faceCount(), mesh.faceCount());
    }
};

int main(int argc, char** argv)
{
    return runTests<PointerTest>(argc, argv);
}

#include "pointer_test.moc"
