// Cutting a mesh open from the menu: along the selected edges, and to a disk.
#include <QDir>
#include <glm/geometric.hpp>

#include "core/catalog/catalog.h"
#include "core/mesh/rings.h"
#include "core/mesh/select.h"
#include "tests/ui/window_fixture.h"
#include "ui/file_commands.h"
#include "ui/stack_edits.h"
#include "ui/viewport/cut_tool.h"

using namespace mw;

namespace {

Mesh made(const char* op, const ParameterValues& values = {}, const Value& input = {})
{
    return std::get<Mesh>(apply(operation(op), input, values));
}

/// V - E + F.
int64_t characteristic(const Mesh& m)
{
    return int64_t(m.vertexCount()) - int64_t(m.edges().size() / 2) + int64_t(m.faceCount());
}

/// Four vertices along edges, none twice: three edges.
std::array<uint32_t, 4> walk(const Mesh& m)
{
    std::array<uint32_t, 4> way{0, 0, 0, 0};
    for (size_t i = 1; i < 4; ++i)
        for (const uint32_t n : m.rings().neighboursOf(way[i - 1]))
            if (std::find(way.begin(), way.begin() + ptrdiff_t(i), n) == way.begin() + ptrdiff_t(i)) {
                way[i] = n;
                break;
            }
    return way;
}

double length(const Mesh& m, std::span<const uint32_t> way)
{
    double sum = 0;
    for (size_t i = 0; i + 1 < way.size(); ++i) sum += glm::distance(glm::dvec3(m.positions()[way[i]]), glm::dvec3(m.positions()[way[i + 1]]));
    return sum;
}

/// By relaxing every edge until nothing gets shorter.
double shortestLength(const Mesh& m, uint32_t from, uint32_t to)
{
    std::vector<double> far(m.vertexCount(), INFINITY);
    far[from] = 0;
    for (bool changed = true; changed;) {
        changed = false;
        for (size_t e = 0; e < m.edges().size(); e += 2)
            for (const auto& [a, b] : {std::pair(m.edges()[e], m.edges()[e + 1]), std::pair(m.edges()[e + 1], m.edges()[e])}) {
                const uint32_t ends[] = {a, b};
                const double there = far[a] + length(m, ends);
                if (there < far[b]) far[b] = there, changed = true;
            }
    }
    return far[to];
}

ElementSet edgesOf(const std::array<uint32_t, 4>& way)
{
    ElementSet out{ElementKind::Edge, {}};
    std::vector<std::pair<uint32_t, uint32_t>> pairs;
    for (size_t i = 0; i < 3; ++i) pairs.emplace_back(std::min(way[i], way[i + 1]), std::max(way[i], way[i + 1]));
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [a, b] : pairs) out.indices.insert(out.indices.end(), {a, b});
    return out;
}

}  // namespace

class CutTest : public QObject, protected WindowFixture {
    Q_OBJECT

private:
    MeshId mesh() { return document().scene().meshes().front(); }
    NodeId node() { return document().scene().nodes().front(); }
    void open(const Mesh& m)
    {
        w_->files().openScene(sceneOf(m, "thing"), "Open");
        settle();
        document().select({{node()}, {}, {}});
        w_->viewport().frameAll(false);
    }
    CutTool& tool() { return static_cast<CutTool&>(view().tool(ToolKind::Cut)); }
    QPoint pixelOf(const Mesh& m, uint32_t vertex)
    {
        const glm::dvec3 p = view().look().camera.project(glm::dvec3(m.positions()[vertex]), view().logicalSize());
        return {int(std::lround(p.x)), int(std::lround(p.y))};
    }
    /// The vertex in view nearest to a place of the picture, as shares of its size.
    uint32_t near(const Mesh& m, double x, double y)
    {
        const glm::dvec3 eye = view().look().camera.eye();
        const QPoint wanted(int(x * view().width()), int(y * view().height()));
        uint32_t best = 0;
        double least = INFINITY;
        for (uint32_t v = 0; v < m.vertexCount(); ++v) {
            const glm::dvec3 p(m.positions()[v]);
            const QPoint off = pixelOf(m, v) - wanted;
            const double d = std::hypot(off.x(), off.y());
            if (glm::dot(glm::normalize(p), glm::normalize(eye - p)) > 0.3 && d < least) least = d, best = v;
        }
        return best;
    }
    void hoverAt(QPoint p)
    {
        QTest::mouseMove(&view(), p + QPoint(1, 1));
        QTest::mouseMove(&view(), p);
    }
    void click(const Mesh& m, uint32_t v) { QTest::mouseClick(&view(), Qt::LeftButton, {}, pixelOf(m, v)); }
    void picture(const char* name)
    {
        const QString folder = qEnvironmentVariable("MESHWRIGHT_PICTURES");
        if (!folder.isEmpty()) w_->grab().save(QDir(folder).filePath(name));
    }

private slots:
    void init() { showWindow(1600, 1000); }
    void cleanup() { w_.reset(); }

    void cutsAlongSelectedEdges()
    {
        const Mesh sphere = made("icosphere", {{"subdivisions", int64_t(2)}});
        open(sphere);
        QVERIFY(!action("Cut along selection")->isEnabled());
        QVERIFY(action("Cut along selection")->toolTip().startsWith("Select edges first"));
        document().select({{node()}, node(), {ElementKind::Face, {3}}});
        QVERIFY(!action("Cut along selection")->isEnabled());
        document().select({{node()}, node(), edgesOf(walk(sphere))});
        QVERIFY(action("Cut along selection")->isEnabled());
        const size_t entries = document().history().size();
        action("Cut along selection")->trigger();
        settle();
        QCOMPARE(document().history().size(), entries + 1);
        const auto& stack = document().scene().find(mesh())->stack;
        QCOMPARE(stack.size(), size_t(1));
        QCOMPARE(stack[0].operation, std::string("cut"));
        // A way of three edges has two vertices inside, which are doubled, and becomes a hole of six edges.
        const Mesh cut = document().shownMesh(mesh());
        QCOMPARE(cut.vertexCount(), sphere.vertexCount() + 2);
        QCOMPARE(cut.faceCount(), sphere.faceCount());
        QCOMPARE(boundary(cut, ElementKind::Edge).indices.size(), size_t(12));
        QVERIFY(document().selection().elements.indices.empty());
        document().undo();
        QVERIFY(document().scene().find(mesh())->stack.empty());
    }

    void cutsBehindTheLevelInView()
    {
        const Mesh sphere = made("icosphere", {{"subdivisions", int64_t(1)}});
        open(sphere);
        edits::addModifier(document(), mesh(), operation("subdivide-loop"));
        settle();
        session().view.shownLevel[mesh()] = 0;
        session().view.touch();
        document().select({{node()}, node(), edgesOf(walk(sphere))});
        action("Cut along selection")->trigger();
        settle();
        const auto& stack = document().scene().find(mesh())->stack;
        QCOMPARE(stack.size(), size_t(2));
        QCOMPARE(stack[0].operation, std::string("cut"));
        QCOMPARE(boundary(document().shownMesh(mesh()), ElementKind::Edge).indices.size(), size_t(24));  // each edge is two
    }

    void cutsOpenToADisk()
    {
        const Mesh torus = made("torus");
        QCOMPARE(characteristic(torus), int64_t(0));
        open(torus);
        const size_t entries = document().history().size();
        action("Cut open to a disk")->trigger();
        settle();
        QCOMPARE(document().history().size(), entries + 1);
        QCOMPARE(characteristic(document().shownMesh(mesh())), int64_t(1));
        document().select({});
        QVERIFY(!action("Cut open to a disk")->isEnabled());
        QVERIFY(action("Cut open to a disk")->toolTip().startsWith("Select a mesh first"));
    }

    void cutsFromClickedVertexToClickedVertex()
    {
        const Mesh sphere = made("icosphere", {{"subdivisions", int64_t(3)}});
        open(sphere);
        QTest::keyClick(&view(), Qt::Key_K);
        QVERIFY(session().view.tool == ToolKind::Cut);
        const uint32_t a = near(sphere, 0.42, 0.42), b = near(sphere, 0.58, 0.45), c = near(sphere, 0.52, 0.62);
        click(sphere, a);
        QCOMPARE(tool().stops().size(), size_t(1));
        QTest::keyClick(&view(), Qt::Key_Return);  // from where to where?
        QVERIFY(document().scene().find(mesh())->stack.empty());
        click(sphere, b);
        QCOMPARE(tool().stops().size(), size_t(2));
        QVERIFY(std::abs(length(sphere, tool().stops()[1].way) - shortestLength(sphere, a, b)) < 1e-9);
        hoverAt(pixelOf(sphere, c));
        QTRY_VERIFY(!tool().way().empty() && tool().way().back() == c);
        QCOMPARE(tool().way().front(), b);
        QVERIFY(std::abs(length(sphere, tool().way()) - shortestLength(sphere, b, c)) < 1e-9);
        picture("cut-tool.png");
        click(sphere, c);
        QTest::keyClick(&view(), Qt::Key_Backspace);
        QCOMPARE(tool().stops().size(), size_t(2));
        click(sphere, c);
        size_t edges = 0;
        for (const CutTool::Stop& s : tool().stops()) edges += s.way.empty() ? 0 : s.way.size() - 1;
        const size_t entries = document().history().size();
        QTest::keyClick(&view(), Qt::Key_Return);
        settle();
        QCOMPARE(document().history().size(), entries + 1);
        QVERIFY(tool().stops().empty());
        const auto& stack = document().scene().find(mesh())->stack;
        QCOMPARE(stack.size(), size_t(1));
        QCOMPARE(std::get<std::string>(stack[0].values.at("vertices")), std::to_string(a) + ";" + std::to_string(b) + ";" + std::to_string(c));
        // A way that does not cross itself: each edge becomes two, each vertex inside it as well.
        const Mesh cut = document().shownMesh(mesh());
        QCOMPARE(cut.vertexCount(), sphere.vertexCount() + edges - 1);
        QCOMPARE(boundary(cut, ElementKind::Edge).indices.size(), 4 * edges);
        picture("cut-tool-after.png");
    }

    void clearsAndCutsByADoubleClick()
    {
        const Mesh sphere = made("icosphere", {{"subdivisions", int64_t(3)}});
        open(sphere);
        QTest::keyClick(&view(), Qt::Key_K);
        const uint32_t a = near(sphere, 0.42, 0.42), b = near(sphere, 0.58, 0.45);
        click(sphere, a);
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(tool().stops().empty());
        QVERIFY(session().view.tool == ToolKind::Cut);
        click(sphere, a);
        click(sphere, b);
        QTest::mouseDClick(&view(), Qt::LeftButton, {}, pixelOf(sphere, b));  // the press alone
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, pixelOf(sphere, b));
        QCOMPARE(document().scene().find(mesh())->stack.size(), size_t(1));
        settle();
        // Undone while another cut is begun: its vertices may mean others now.
        const Mesh cut = document().shownMesh(mesh());
        click(cut, near(cut, 0.5, 0.6));
        QCOMPARE(tool().stops().size(), size_t(1));
        document().undo();
        settle();
        hoverAt(pixelOf(sphere, b));
        QTRY_VERIFY(tool().stops().empty());
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(session().view.tool == ToolKind::Select);
    }

    // Ways over a large mesh are looked for by a job: a click meanwhile is kept.
    void keepsAClickWhileWaysAreLookedFor()
    {
        const Mesh sphere = made("icosphere", {{"subdivisions", int64_t(6)}});
        open(sphere);
        QTest::keyClick(&view(), Qt::Key_K);
        const uint32_t a = near(sphere, 0.42, 0.42), b = near(sphere, 0.58, 0.45);
        click(sphere, a);
        click(sphere, b);
        QCOMPARE(tool().stops().size(), size_t(1));
        QVERIFY(tool().hint({}).startsWith("Preparing"));
        QTRY_COMPARE_WITH_TIMEOUT(tool().stops().size(), size_t(2), 20000);
        QCOMPARE(tool().stops()[1].way.front(), a);
        QCOMPARE(tool().stops()[1].way.back(), b);
        QTest::keyClick(&view(), Qt::Key_Return);
        settle();
        QVERIFY(boundary(document().shownMesh(mesh()), ElementKind::Edge).indices.size() > 4);
    }
};

int main(int argc, char** argv)
{
    return runTests<CutTest>(argc, argv);
}

#include "cut_test.moc"
