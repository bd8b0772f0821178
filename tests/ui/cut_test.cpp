// Cutting a mesh open from the menu: along the selected edges, and to a disk.
#include <QAction>
#include <QApplication>
#include <QTest>

#include "core/catalog/catalog.h"
#include "core/mesh/rings.h"
#include "core/mesh/select.h"
#include "ui/application.h"
#include "ui/evaluation_service.h"
#include "ui/file_commands.h"
#include "ui/main_window.h"
#include "ui/stack_edits.h"
#include "ui/viewport/viewport.h"

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

class CutTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<MainWindow> w_;

    Document& document() { return w_->session().document; }
    Session& session() { return w_->session(); }
    MeshId mesh() { return document().scene().meshes().front(); }
    NodeId node() { return document().scene().nodes().front(); }
    void settle()
    {
        QTest::qWait(50);
        QTRY_VERIFY_WITH_TIMEOUT(w_->evaluations().idle() && !session().jobs.busy(), 60000);
        QTest::qWait(50);
        QTRY_VERIFY_WITH_TIMEOUT(!session().jobs.busy(), 60000);
    }
    void open(const Mesh& m)
    {
        w_->files().openScene(sceneOf(m, "thing"), "Open");
        settle();
        document().select({{node()}, {}, {}});
        w_->viewport().frameAll(false);
    }
    QAction* action(const QString& text)
    {
        for (QAction* a : w_->findChildren<QAction*>())
            if (a->text() == text) return a;
        qFatal("there is no action \"%s\"", qPrintable(text));
    }

private slots:
    void init()
    {
        w_ = std::make_unique<MainWindow>();
        w_->resize(1600, 1000);
        w_->show();
        QVERIFY(QTest::qWaitForWindowExposed(w_.get()));
    }
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
};

int main(int argc, char** argv)
{
    prepareApplication();
    QApplication app(argc, argv);
    dressApplication(app);
    CutTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "cut_test.moc"
