// The step session and the panels that show it, on an algorithm small enough to know every step of.
#include <QApplication>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>
#include <QTreeWidget>
#include <qcustomplot.h>
#include <thread>

#include "core/catalog/catalog.h"
#include "core/mesh/mesh.h"
#include "tests/ui/panel_desk.h"
#include "ui/parameter_form.h"
#include "ui/steps/plot_panel.h"
#include "ui/steps/source_panel.h"
#include "ui/steps/step_history.h"
#include "ui/steps/step_lists.h"
#include "ui/steps/step_player.h"
#include "ui/steps/step_subject.h"
#include "ui/steps/transport_strip.h"

using namespace mw;

namespace {

constexpr unsigned rounds = 40;

// Two phases in turn: every vertex rises, then the first one sinks; each seventh turn is refused.
Generator wave(const Mesh& mesh, Stage<Mesh>& stage, bool slow)
{
    std::vector<glm::vec3> p(mesh.positions().data(), mesh.positions().data() + mesh.vertexCount());
    auto now = [&] { return mesh.withPositions(Array<glm::vec3>(p.begin(), p.end())); };
    stage.show(now);
    co_yield Step("prepare").number("count", double(p.size()));
    for (unsigned i = 0; i < rounds; ++i) {
        if (slow) std::this_thread::sleep_for(std::chrono::milliseconds(20));
        for (auto& v : p) v.y += 0.25f;
        co_yield Step("rise").vertex(i % uint32_t(p.size()), Role::Current, "v").number("height", p.back().y).progress((i + 1.0) / rounds);
        p[0].y -= 0.5f;
        co_yield Step("sink").vertex(0, i % 7 == 6 ? Role::Rejected : Role::Removed).number("depth", p[0].y);
    }
    stage.finish(now());
}

Operation waveOperation(bool slow)
{
    Operation op;
    op.id = "test-wave", op.title = "Wave";
    op.accepts = op.yields = Kind::Mesh;
    op.steps = true;
    op.source = "tests/ui/steps_test.cpp";
    op.start = [slow](const Value& input, const ParameterValues&, const Others&, bool watched) -> std::unique_ptr<Run> {
        const Mesh& mesh = std::get<Mesh>(input);
        return std::make_unique<RunOf<Mesh>>(
            watched, [&](Stage<Mesh>& stage) { return wave(mesh, stage, slow); }, mesh);
    };
    return op;
}

Mesh tetrahedron()
{
    return Mesh::triangles(Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, Array<uint32_t>{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
}

struct Desk : PanelDesk {
    Operation quick = waveOperation(false), slow = waveOperation(true);

    Desk() : PanelDesk(tetrahedron(), "tetrahedron") {}
    void open(const Operation& op) { steps.open(op, node, Value{tetrahedron()}, {}); }
    uint64_t hash() const { return contentHash(*steps.value()); }
};

}  // namespace

class StepsTest : public QObject {
    Q_OBJECT

private slots:
    void forthAndBackGiveTheSameState();
    void aSlowStepDoesNotHoldTheWindow();
    void aLongSeekShowsAsJobAndCanBeCancelled();
    void runsToPhasesAndLines();
    void stepsByPhaseAndByOnePhase();
    void playsAndPauses();
    void playsAsFastAsItGoes();
    void editingAsksWhatToDo();
    void aFailureIsTold();
    void historyThinsOut();
    void theStripScrubsAndListensToKeys();
    void thePlayerShowsPhasesAndNumbers();
    void parametersStartAgain();
    void theSourceFollowsTheRunningLine();
    void thePlotHasTheSeries();
    void aResidualIsPlottedOverSweeps();
    void everyKindIsSteppedInALab();
    void aCharacterFollowsItsPose();
    void whatIsKeptIsAClip();
    void anAlgorithmSaysWhyItCannotRun();
};

void StepsTest::forthAndBackGiveTheSameState()
{
    Desk d;
    d.open(d.quick);
    QCOMPARE(d.steps.position(), size_t(0));
    QCOMPARE(d.hash(), contentHash(Value{tetrahedron()}));
    std::vector<uint64_t> forth{d.hash()};
    for (int i = 0; i < 30; ++i) {
        d.steps.forward();
        QTRY_COMPARE(d.steps.position(), size_t(i + 1));
        forth.push_back(d.hash());
    }
    for (int i = 29; i >= 0; --i) {
        d.steps.back();
        QTRY_COMPARE(d.steps.position(), size_t(i));
        QCOMPARE(d.hash(), forth[size_t(i)]);
    }
    d.steps.last();
    QTRY_VERIFY(d.steps.atEnd());
    QCOMPARE(d.steps.length(), size_t(2 * rounds + 3));
    QCOMPARE(d.hash(), contentHash(mw::valueOf([&] {
                 auto run = d.quick.start(Value{tetrahedron()}, {}, {}, false);
                 while (run->advance()) {
                 }
                 return run->snapshot();
             }())));
    d.steps.seek(17);
    QTRY_COMPARE(d.steps.position(), size_t(17));
    QCOMPARE(d.hash(), forth[17]);
}

void StepsTest::aSlowStepDoesNotHoldTheWindow()
{
    Desk d;
    d.open(d.slow);
    d.steps.seek(31);  // half a second
    QVERIFY(d.steps.seeking());
    QCOMPARE(d.steps.position(), size_t(0));  // the last state stays
    d.steps.forward();                        // waits its turn
    QTRY_COMPARE_WITH_TIMEOUT(d.steps.position(), size_t(32), 10000);
    QVERIFY(!d.steps.seeking());
}

void StepsTest::aLongSeekShowsAsJobAndCanBeCancelled()
{
    Desk d;
    d.open(d.slow);
    d.steps.last();
    QTRY_VERIFY_WITH_TIMEOUT(d.jobs.busy(), 3000);
    const quint64 id = d.jobs.jobs().back().id;
    d.jobs.cancel(id);
    QTRY_VERIFY_WITH_TIMEOUT(!d.steps.seeking(), 3000);
    QCOMPARE(d.steps.position(), size_t(0));
    // Where it broke off it goes on.
    d.steps.seek(3);
    QTRY_COMPARE_WITH_TIMEOUT(d.steps.position(), size_t(3), 5000);
    QCOMPARE(d.steps.step().phase, std::string("sink"));
}

void StepsTest::runsToPhasesAndLines()
{
    Desk d;
    d.open(d.quick);
    d.steps.toPhase("sink");
    QTRY_COMPARE(d.steps.position(), size_t(3));
    QCOMPARE(d.steps.step().phase, std::string("sink"));
    const unsigned sinks = d.steps.step().line;
    d.steps.forward();
    QTRY_COMPARE(d.steps.position(), size_t(4));
    d.steps.toLines(sinks, sinks);
    QTRY_COMPARE(d.steps.position(), size_t(5));
    QCOMPARE(d.steps.step().line, sinks);
    // A phase that does not come again: back to where it was.
    d.steps.toPhase("prepare");
    QTRY_COMPARE(d.steps.position(), size_t(1));
}

void StepsTest::stepsByPhaseAndByOnePhase()
{
    Desk d;
    d.open(d.quick);
    d.steps.setUnit(StepSession::Unit::Named, "rise");
    for (size_t expected : {2, 4, 6}) {
        d.steps.forward();
        QTRY_COMPARE(d.steps.position(), expected);
    }
    d.steps.back();
    QTRY_COMPARE(d.steps.position(), size_t(4));
    d.steps.setUnit(StepSession::Unit::Phase);
    d.steps.forward();
    QTRY_COMPARE(d.steps.position(), size_t(5));
    d.steps.nextPhase();
    QTRY_COMPARE(d.steps.position(), size_t(6));
    d.steps.lastPhase();
    QTRY_COMPARE(d.steps.position(), size_t(5));
}

void StepsTest::playsAndPauses()
{
    Desk d;
    d.open(d.quick);
    d.steps.setSpeed(64);
    d.steps.play();
    QVERIFY(d.steps.playing());
    QTRY_VERIFY(d.steps.position() > 4);
    d.steps.pause();
    QVERIFY(!d.steps.playing());
    QTRY_VERIFY(!d.steps.seeking());
    const size_t stopped = d.steps.position();
    QTest::qWait(80);
    QCOMPARE(d.steps.position(), stopped);
}

void StepsTest::playsAsFastAsItGoes()
{
    Desk d;
    d.open(d.quick);
    d.steps.setSpeed(0);
    d.steps.play();
    QTRY_VERIFY(d.steps.atEnd());
    QTRY_VERIFY(!d.steps.playing());
    QCOMPARE(d.steps.series("height").size(), size_t(rounds));  // none of those passed is missing
    QCOMPARE(d.steps.history().countOf("rise", d.steps.position()), size_t(rounds));
    QCOMPARE(d.steps.history().rejected().size(), size_t(rounds / 7));
}

void StepsTest::editingAsksWhatToDo()
{
    Desk d;
    d.open(d.quick);
    d.steps.seek(4);
    QTRY_COMPARE(d.steps.position(), size_t(4));
    Scene changed = d.document.scene();
    const MeshId id = changed.node(d.node).mesh;
    MeshObject object = *changed.find(id);
    object.base = object.base.withPositions(Array<glm::vec3>{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
    changed.set(id, object);
    d.document.commit("Stretch", changed);
    QVERIFY(d.steps.edited());
    d.document.undo();
    QVERIFY(!d.steps.edited());
    const uint64_t state = d.hash();
    d.steps.keepAsBase();
    QVERIFY(!d.steps.isOpen());
    QCOMPARE(contentHash(Value{d.document.scene().find(id)->base}), state);
    Scene gone = d.document.scene();
    d.open(d.quick);
    gone.remove(d.node);
    d.document.commit("Delete", gone);
    QVERIFY(!d.steps.isOpen());
}

void StepsTest::aFailureIsTold()
{
    Desk d;
    Operation broken = d.quick;
    broken.start = [](const Value&, const ParameterValues&, const Others&, bool) -> std::unique_ptr<Run> {
        throw Error("the mesh has no faces. Load another.");
    };
    d.open(broken);
    d.steps.forward();
    QTRY_VERIFY(!d.steps.error().isEmpty());
    QCOMPARE(d.steps.error(), QString("the mesh has no faces. Load another."));
    d.steps.forward();
    QTRY_VERIFY(!d.steps.seeking());
    d.open(d.quick);
    QVERIFY(d.steps.error().isEmpty());
}

void StepsTest::historyThinsOut()
{
    StepHistory h;
    h.add({});
    StepHistory more(1);
    StepRecord r;
    r.phase = "go";
    for (size_t i = 1; i <= 250'000; ++i) {
        r.index = i;
        r.numbers = {{"n", double(i)}};
        more.add(r);
    }
    h.append(more);
    QCOMPARE(h.end(), size_t(250'001));
    const auto& points = h.series("n");
    QVERIFY(points.size() <= 100'000 && points.size() > 10'000);
    for (const auto& [step, value] : points) QCOMPARE(double(step), value);
    QCOMPARE(h.countOf("go", 1000), size_t(1000));
    QCOMPARE(h.nextOf("go", 77), size_t(78));
    QCOMPARE(h.previousOf("go", 77), size_t(76));
}

void StepsTest::theStripScrubsAndListensToKeys()
{
    Desk d;
    QWidget window;
    window.resize(900, 60);
    QWidget* strip = makeTransportStrip(d.session, &window);
    strip->resize(900, 52);
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    QVERIFY(!strip->isVisible());
    d.open(d.quick);
    QVERIFY(strip->isVisible());
    d.steps.last();
    QTRY_VERIFY(d.steps.atEnd());
    auto* next = strip->findChild<QWidget*>("transport-step-forward");
    QVERIFY(!next->isEnabled() && !next->toolTip().isEmpty());
    auto* scrubber = strip->findChild<StepScrubber*>();
    QCOMPARE(scrubber->maximum(), int(2 * rounds + 2));
    QTest::mousePress(scrubber, Qt::LeftButton, {}, QPoint(scrubber->knobX(), 11));
    QTest::mouseMove(scrubber, QPoint(scrubber->width() / 2, 11));
    QTest::mouseRelease(scrubber, Qt::LeftButton, {}, QPoint(scrubber->width() / 2, 11));
    QTRY_VERIFY(!d.steps.seeking());
    QVERIFY(std::abs(int(d.steps.position()) - int(rounds + 1)) <= 1);
    QTRY_COMPARE(scrubber->value(), int(d.steps.position()));
    const size_t before = d.steps.position();
    scrubber->setFocus();
    QTest::keyClick(strip, Qt::Key_Right);
    QTRY_COMPARE(d.steps.position(), before + 1);
    QTest::keyClick(strip, Qt::Key_Home);
    QTRY_COMPARE(d.steps.position(), size_t(0));
    auto* where = strip->findChild<QLabel*>("transport-where");
    QVERIFY(where->text().contains("Step"));
    d.steps.close();
    QVERIFY(!strip->isVisible());
}

void StepsTest::thePlayerShowsPhasesAndNumbers()
{
    Desk d;
    std::unique_ptr<QWidget> panel(makeStepPlayerPanel(d.session, nullptr));
    panel->resize(392, 700);
    panel->show();
    d.open(d.quick);
    d.steps.seek(6);
    QTRY_COMPARE(d.steps.position(), size_t(6));
    auto* phases = panel->findChild<PhaseList*>();
    QCOMPARE(phases->count(), 3);
    QCOMPARE(phases->item(1)->data(Qt::CheckStateRole).toInt(), int(Qt::PartiallyChecked));
    QCOMPARE(phases->item(2)->data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
    QTest::mouseClick(phases->viewport(), Qt::LeftButton, {}, phases->visualItemRect(phases->item(2)).center());
    QTRY_COMPARE(d.steps.position(), size_t(7));
    auto* numbers = panel->findChild<NumberTable*>();
    const auto depths = numbers->findItems("depth", Qt::MatchExactly);
    QCOMPARE(depths.size(), 1);
    QCOMPARE(depths[0]->text(1), QString("−0.75"));
    QCOMPARE(depths[0]->text(2), QString("−0.5"));
}

void StepsTest::parametersStartAgain()
{
    Desk d;
    Operation op = d.quick;
    op.parameters = {{"lift", ParameterType::Number, 0.25, {.title = "Lift", .help = "How far it rises.", .min = 0, .max = 1}, {}}};
    std::unique_ptr<QWidget> panel(makeStepPlayerPanel(d.session, nullptr));
    panel->show();
    d.open(op);
    d.steps.seek(5);
    QTRY_COMPARE(d.steps.position(), size_t(5));
    auto* button = panel->findChild<QPushButton*>("step-parameters");
    QVERIFY(button->isEnabled());
    QTest::mouseClick(button, Qt::LeftButton);
    auto* form = panel->findChild<ParameterForm*>();
    QVERIFY(form && form->isVisible());
    emit form->committed({{"lift", 0.5}}, "lift 0.5");
    QCOMPARE(d.steps.position(), size_t(0));
    QCOMPARE(std::get<double>(d.steps.values().at("lift")), 0.5);
    QCOMPARE(std::get<double>(form->values().at("lift")), 0.5);
}

void StepsTest::theSourceFollowsTheRunningLine()
{
    const QString text = "int a;\n// no co_yield here\nco_yield Step(\"a\")\n    .number(\"x\", 1);\nb();\nco_yield Step(\"b\");\n";
    const auto yields = yieldsIn(text);
    QCOMPARE(yields.size(), size_t(2));
    QCOMPARE(yields[0].first, 3u);
    QCOMPARE(yields[0].last, 4u);
    SourceView view;
    view.resize(400, 120);
    view.setSource(text + QString("\n").repeated(200) + "co_yield Step(\"c\");\n");
    view.show();
    view.setRunning(4);
    QCOMPARE(view.runningLine(), 4u);
    QCOMPARE(view.extraSelections().size(), 2);  // the whole statement
    view.setRunning(207);
    const QRect line = view.cursorRect(QTextCursor(view.document()->findBlockByNumber(206)));
    QVERIFY(line.top() > 0 && line.bottom() < view.viewport()->height());
    QSignalSpy clicked(&view, &SourceView::yieldClicked);
    QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, line.center() + QPoint(10, 0));
    QCOMPARE(clicked.count(), 1);
    QCOMPARE(clicked[0][0].toUInt(), 207u);
}

void StepsTest::thePlotHasTheSeries()
{
    Desk d;
    std::unique_ptr<QWidget> panel(makePlotPanel(d.session, nullptr));
    panel->resize(368, 250);
    panel->show();
    d.open(d.quick);
    d.steps.last();
    QTRY_VERIFY(d.steps.atEnd());
    QCOMPARE(d.steps.plotted(), QStringList{"count"});
    d.steps.setPlotted({"height", "depth"});
    const QByteArray csv = seriesAsCsv(d.steps, d.steps.plotted());
    const auto lines = csv.split('\n');
    QCOMPARE(lines[0], QByteArray("step,height,depth"));
    QCOMPARE(lines[1], QByteArray("2,0.25,"));
    QCOMPARE(lines.size(), qsizetype(2 * rounds + 2));
    QVERIFY(panel->findChild<QWidget*>("plot")->isVisible());
}

// A sweep has as many steps as there are inner vertices: what a solver gains in a sweep is seen over the sweeps.
void StepsTest::aResidualIsPlottedOverSweeps()
{
    const Mesh sheet = std::get<Mesh>(apply(operation("grid"), {}, {}));
    for (const char* solver : {"jacobi", "gauss-seidel"}) {
        PanelDesk d(sheet);
        d.show(makePlotPanel, 368, 250);
        d.steps.open(operation("embed-planar"), d.node, Value{sheet}, {{"solver", std::string(solver)}});
        d.steps.forward();
        QTRY_COMPARE(d.steps.position(), size_t(1));
        QCOMPARE(d.steps.plotted(), QStringList{"residual"});  // which no step has given yet
        auto* plot = d.panel->findChild<QCustomPlot*>("plot");
        QVERIFY(!plot->isVisible());
        d.steps.last();
        QTRY_VERIFY_WITH_TIMEOUT(d.steps.atEnd(), 20000);
        QTRY_VERIFY(plot->isVisible());
        QCOMPARE(plot->xAxis->label(), QString("sweep"));
        QCOMPARE(plot->yAxis->scaleType(), QCPAxis::stLogarithmic);
        const StepHistory& history = d.steps.history();
        const size_t sweeps = history.countOf("sweep", history.end());
        QVERIFY(sweeps > 3);
        const auto curve = plot->graph(0)->data();
        QCOMPARE(size_t(curve->size()), sweeps + 1);  // and that of the result
        for (size_t i = 0; i < sweeps; ++i) {
            QCOMPARE(curve->at(int(i))->key, double(i + 1));
            QCOMPARE(curve->at(int(i))->value, d.steps.series("residual")[i].second);
        }
        QTest::qWait(20);  // it draws when there is time
        if (const QString folder = qEnvironmentVariable("MESHWRIGHT_PICTURES"); !folder.isEmpty())
            d.panel->grab().save(QDir(folder).filePath(QString("plot-%1.png").arg(solver)));
        // The cursor is dragged to a sweep.
        const int y = plot->height() / 2;
        const auto pixel = [&](double x) { return QPoint(int(std::lround(plot->xAxis->coordToPixel(x))), y); };
        QTest::mousePress(plot, Qt::LeftButton, {}, pixel(double(sweeps)));
        QTest::mouseMove(plot, pixel(3));
        QTest::mouseRelease(plot, Qt::LeftButton, {}, pixel(3));
        QTRY_VERIFY(!d.steps.atEnd());
        QTRY_COMPARE(history.phaseAt(d.steps.position()), std::string("sweep"));
        QCOMPARE(history.countOf("sweep", d.steps.position()), size_t(3));
        d.steps.setPlotted({"moved"});  // many a sweep
        QCOMPARE(plot->xAxis->label(), QString("step"));
    }
}

namespace {

// hip - spine - two arms of three joints each
void addCharacter(Desk& d)
{
    Scene scene = d.document.scene();
    const auto joint = [&](const char* name, NodeId parent, glm::dvec3 at) {
        Node n;
        n.name = name;
        n.joint = Node::Joint::Joint;
        n.local.translation = at;
        return scene.add(n, parent);
    };
    const NodeId hip = joint("hip", {}, {0, 1, 0}), spine = joint("spine", hip, {0, 0.5, 0});
    for (const double side : {-1.0, 1.0}) {
        const NodeId arm = joint(side < 0 ? "right arm" : "left arm", spine, {0.2 * side, 0, 0});
        const NodeId elbow = joint(side < 0 ? "right elbow" : "left elbow", arm, {0.3 * side, 0, 0});
        joint(side < 0 ? "right hand" : "left hand", elbow, {0.3 * side, 0, 0});
    }
    d.document.commit("Add a character", scene, {{hip}, {}, {}});
}

NodeId called(const Scene& scene, const std::string& name)
{
    for (const NodeId id : scene.nodes())
        if (scene.node(id).name == name) return id;
    return {};
}

}  // namespace

void StepsTest::everyKindIsSteppedInALab()
{
    Desk d;
    d.document.select({});
    const size_t entries = d.document.history().size();
    for (const char* id : {"fabrik", "ccd", "subdivide-curve", "interpolate-rotation", "diamond-square"}) {
        const Operation& op = operation(id);
        QVERIFY2(stepThrough(d.session, op), id);
        QVERIFY(d.steps.isOpen() && !d.steps.node());
        d.steps.seek(3);
        QTRY_COMPARE(d.steps.position(), size_t(3));
        QCOMPARE(kindOf(*d.steps.value()), op.yields);
        d.steps.last();
        QTRY_VERIFY_WITH_TIMEOUT(d.steps.atEnd(), 20000);
        QVERIFY(d.steps.error().isEmpty());
        QVERIFY(!d.steps.isOfCharacter());
        QVERIFY(!d.steps.keepAsClip());
    }
    d.steps.close();
    QCOMPARE(d.document.history().size(), entries);
}

void StepsTest::aCharacterFollowsItsPose()
{
    Desk d;
    addCharacter(d);
    QVERIFY(stepThrough(d.session, operation("ccd")));
    QCOMPARE(d.steps.node(), called(d.document.scene(), "hip"));
    QCOMPARE(std::get<std::string>(d.steps.values().at("effector")), std::string("right hand"));
    d.steps.last();
    QTRY_VERIFY(d.steps.atEnd());
    const ScenePose pose = shownPose(d.session, {});
    const auto worlds = worldMatrices(d.document.scene(), pose);
    const glm::dvec3 hand(worlds.at(called(d.document.scene(), "right hand"))[3]);
    QVERIFY(glm::distance(hand, std::get<glm::dvec3>(d.steps.values().at("target"))) < 2e-3);
    // A selected joint is the one that reaches; what is not in the chain stays.
    d.document.select({{called(d.document.scene(), "left elbow")}, {}, {}});
    QVERIFY(stepThrough(d.session, operation("fabrik")));
    QCOMPARE(std::get<std::string>(d.steps.values().at("effector")), std::string("left elbow"));
    d.steps.close();
    QVERIFY(shownPose(d.session, {}).locals.empty());
}

void StepsTest::whatIsKeptIsAClip()
{
    Desk d;
    addCharacter(d);
    QVERIFY(stepThrough(d.session, operation("fabrik")));
    std::unique_ptr<QWidget> strip(makeTransportStrip(d.session, nullptr));
    strip->show();
    d.steps.last();
    QTRY_VERIFY(d.steps.atEnd());
    const Pose solution = std::get<Pose>(*d.steps.value());
    auto* keep = strip->findChild<QPushButton*>("transport-keep");
    QVERIFY(keep && keep->isVisibleTo(strip.get()));
    QTest::mouseClick(keep, Qt::LeftButton);
    QVERIFY(!d.steps.isOpen());
    const Scene& scene = d.document.scene();
    QCOMPARE(scene.clips().size(), size_t(1));
    QCOMPARE(d.view.clip, scene.clips().front());
    const Clip& clip = *scene.find(scene.clips().front());
    QCOMPARE(duration(clip), 1.0);
    const Pose end = poseOf(scene, called(scene, "hip"), poseAt(scene, clip, 1));
    for (size_t i = 0; i < end.size(); ++i) QVERIFY(glm::distance(jointPlaces(end)[i], jointPlaces(solution)[i]) < 1e-6);
    d.document.undo();
    QVERIFY(d.document.scene().clips().empty());
}

void StepsTest::anAlgorithmSaysWhyItCannotRun()
{
    Desk d;
    QVERIFY(whyNotSteppable(d.session, operation("smooth")).isEmpty());
    d.document.select({});
    QVERIFY(!whyNotSteppable(d.session, operation("smooth")).isEmpty());
    QVERIFY(!stepThrough(d.session, operation("smooth")));
    QVERIFY(!d.steps.isOpen());
    QVERIFY(whyNotSteppable(d.session, operation("fabrik")).isEmpty());
}

QTEST_MAIN(StepsTest)
#include "steps_test.moc"
