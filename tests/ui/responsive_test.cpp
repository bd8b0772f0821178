// The window always answers: the longest time one event keeps its thread, painting apart, while large meshes are opened, simplified,
// subdivided, selected and saved; and how soon a cancel is acknowledged and obeyed. Printed; bounded by time of the processor, so that
// a busy machine does not fail it.
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include "core/io/io.h"
#include "tests/ui/thread_time.h"
#include "tests/ui/window_fixture.h"
#include "ui/file_commands.h"
#include "ui/stack_edits.h"
#include "ui/viewport/cut_tool.h"
#include "ui/viewport/viewport.h"

using namespace mw;

namespace {

struct Span {
    double wall = 0, processor = 0;
};

/// Times every event of the window's thread.
class TimedApplication : public QApplication {
public:
    using QApplication::QApplication;

    Span longest;
    QString culprit;
    void reset()
    {
        longest = {};
        culprit.clear();
        painting_ = {};
    }

    bool notify(QObject* receiver, QEvent* event) override
    {
        if (QThread::currentThread() != thread()) return QApplication::notify(receiver, event);
        const bool paints = event->type() == QEvent::Paint || event->type() == QEvent::UpdateRequest || event->type() == QEvent::UpdateLater ||
                            event->type() == QEvent::Expose;
        if (depth_ > 0 && !paints) return QApplication::notify(receiver, event);
        if (paints && inPaint_) return QApplication::notify(receiver, event);
        const QString what = QString("%1 to %2 %3").arg(int(event->type())).arg(receiver->metaObject()->className(), receiver->objectName());
        QElapsedTimer clock;
        clock.start();
        const double begin = threadMilliseconds();
        const Span before = painting_;
        if (paints) inPaint_ = true;
        ++depth_;
        const bool handled = QApplication::notify(receiver, event);
        --depth_;
        Span span{double(clock.nsecsElapsed()) * 1e-6, threadMilliseconds() - begin};
        if (paints) {
            inPaint_ = false;
            painting_.wall += span.wall;
            painting_.processor += span.processor;
            return handled;
        }
        span.wall -= painting_.wall - before.wall;
        span.processor -= painting_.processor - before.processor;
        longest.wall = std::max(longest.wall, span.wall);
        if (span.processor > longest.processor) {
            longest.processor = span.processor;
            culprit = what;
        }
        return handled;
    }

private:
    int depth_ = 0;
    bool inPaint_ = false;
    Span painting_;
};

TimedApplication& app()
{
    return *static_cast<TimedApplication*>(qApp);
}

}  // namespace

class ResponsiveTest : public QObject, protected WindowFixture {
    Q_OBJECT

private:
    MeshId mesh() { return document().scene().meshes().front(); }

    QString largeFile()
    {
        const QString dragon = qEnvironmentVariable("MESHWRIGHT_DATA") + "/meshes/large/dragon_871k.ply";
        if (QFile::exists(dragon)) return dragon;
        const QString file = folder_.filePath("sphere.ply");
        if (!QFile::exists(file))
            writeFile(sceneOf(std::get<Mesh>(apply(operation("icosphere"), {}, {{"subdivisions", int64_t(8)}})), "sphere"), file.toStdString());
        return file;
    }

    /// Lets the window run until it is idle; then no event may have taken long.
    void settleAndCheck(const char* doing, double limit = 50)
    {
        QElapsedTimer clock;
        clock.start();
        do QTest::qWait(20);
        while (busy() && clock.elapsed() < 240000);
        QTest::qWait(100);
        std::printf("%-34s longest event %6.1f ms (processor %5.1f ms: %s), %.1f s in all\n", doing, app().longest.wall, app().longest.processor,
                    qPrintable(app().culprit), 1e-3 * double(clock.elapsed()));
        std::fflush(stdout);
        QVERIFY2(!busy(), doing);
        const double longest = app().longest.processor;
        const QString culprit = app().culprit;
        app().reset();
        QVERIFY2(longest < limit, qPrintable(QString("%1: %2").arg(doing, culprit)));
    }

    /// As an event of the window, so that it is timed.
    void perform(const std::function<void()>& work)
    {
        QMetaObject::invokeMethod(w_.get(), work, Qt::QueuedConnection);
        QCoreApplication::processEvents();
    }

    void openLarge()
    {
        app().reset();
        QSignalSpy opened(&w_->files(), &FileCommands::opened);
        w_->files().open(largeFile());
        QVERIFY(opened.wait(120000));
    }

private slots:
    void init()
    {
        showWindow(1100, 700);
        QTest::qWait(200);
        app().reset();
    }
    void cleanup() { w_.reset(); }

    void whileALargeMeshIsOpenedChangedAndSaved()
    {
        openLarge();
        settleAndCheck("open");
        w_->session().view.pickKind = PickKind::Face;
        w_->session().view.touch();
        perform([this] { w_->viewport().selectBox(w_->viewport().rect().adjusted(10, 10, -10, -10), {}); });
        settleAndCheck("select by box", 1000);  // it draws and reads the id buffer: painting, on whatever draws
        for (QAction* a : w_->findChildren<QAction*>())
            if (a->text() == "All") {
                perform([a] { a->trigger(); });
                break;
            }
        settleAndCheck("select all faces");
        document().select({{document().scene().nodes().front()}, {}, {}});
        w_->session().view.pickKind = PickKind::Object;
        perform([this] { edits::addModifier(document(), mesh(), operation("decimate-quadric"), {{"ratio", 0.25}}); });
        settleAndCheck("simplify to a quarter");
        perform([this] { edits::addModifier(document(), mesh(), operation("subdivide-loop"), {{"levels", int64_t(1)}}); });
        settleAndCheck("subdivide");
        perform([this] { w_->files().saveTo(folder_.filePath("saved.glb")); });
        settleAndCheck("save the project");
        perform([this] { w_->files().exportTo(folder_.filePath("exported.ply")); });
        settleAndCheck("export");
        perform([this] { document().undo(); });
        perform([this] { document().undo(); });
        settleAndCheck("undo twice");
    }

    // The first pick after the camera has moved draws the id buffer; all that follow, and the marks over the scene, are cheap however large it is.
    void whileALargeMeshIsCut()
    {
        openLarge();
        Viewport& view = w_->viewport();
        view.frameAll(false);
        settleAndCheck("open");
        QTest::keyClick(&view, Qt::Key_K);
        const auto at = [&](int x, int y) { return view.rect().center() + QPoint(x, y); };
        perform([&] { view.pick({view.width() / 2.0, view.height() / 2.0}); });
        settleAndCheck("cut: first pick", 1000);
        const auto hover = [&](QPoint p, const char* doing) {
            const size_t drawn = view.framesDrawn();
            QTest::mouseMove(&view, p);
            QTRY_VERIFY_WITH_TIMEOUT(view.framesDrawn() > drawn, 20000);
            settleAndCheck(doing);
            QVERIFY2(view.drawn().kept, doing);
        };
        auto& tool = static_cast<CutTool&>(view.tool(ToolKind::Cut));
        hover(at(0, 30), "cut: hover");
        QTest::mouseClick(&view, Qt::LeftButton, {}, at(20, 30));
        settleAndCheck("cut: click");
        QCOMPARE(tool.stops().size(), size_t(1));
        hover(at(60, 30), "cut: hover for a way");
        QVERIFY(!tool.way().empty());
        hover(at(80, 40), "cut: hover for another");
        QVERIFY(!tool.way().empty());
        if (const QString folder = qEnvironmentVariable("MESHWRIGHT_PICTURES"); !folder.isEmpty()) w_->grab().save(folder + "/cut-large.png");
        QTest::mouseClick(&view, Qt::LeftButton, {}, at(80, 40));
        settleAndCheck("cut: second click");
        QCOMPARE(tool.stops().size(), size_t(2));
    }

    void cancelIsHeardAtOnce()
    {
        openLarge();
        QTRY_VERIFY_WITH_TIMEOUT(!busy(), 120000);
        const struct {
            const char* name;
            std::function<void()> start;
        } works[] = {
            {"simplify",
             [this] {
                 edits::addModifier(document(), mesh(), operation("decimate-quadric"), {{"ratio", 0.01}});
             }},
            {"subdivide",
             [this] {
                 edits::addModifier(document(), mesh(), operation("subdivide-loop"), {{"levels", int64_t(2)}});
             }},
            {"smooth",
             [this] {
                 edits::addModifier(document(), mesh(), operation("smooth"), {{"iterations", int64_t(200)}});
             }},
            {"open", [this] { w_->files().open(largeFile()); }},
            {"save", [this] { w_->files().saveTo(folder_.filePath("never.glb")); }},
        };
        for (const auto& work : works) {
            Jobs& jobs = w_->session().jobs;
            work.start();
            QTest::qWait(40);
            if (!jobs.busy() || jobs.jobs().back().progress->fraction > 0.8f) {  // it was quicker: nothing is cancelled
                QTRY_VERIFY_WITH_TIMEOUT(!busy(), 120000);
                QFile::remove(folder_.filePath("never.glb"));
                if (!document().scene().find(mesh())->stack.empty()) document().undo();
                QTRY_VERIFY_WITH_TIMEOUT(!busy(), 120000);
                continue;
            }
            const std::shared_ptr<Progress> progress = jobs.jobs().back().progress;
            const quint64 id = jobs.jobs().back().id;
            QElapsedTimer clock;
            clock.start();
            jobs.cancel(id);
            const double acknowledged = double(clock.nsecsElapsed()) * 1e-6;
            // The worker holds the other reference until it has let go.
            while (progress.use_count() > 2 && clock.elapsed() < 20000) QTest::qWait(1);
            std::printf("cancel %-10s acknowledged after %.2f ms, obeyed after %lld ms\n", work.name, acknowledged,
                        static_cast<long long>(clock.elapsed()));
            std::fflush(stdout);
            QVERIFY2(acknowledged < 100, work.name);
            QVERIFY2(clock.elapsed() < 10000, work.name);
            if (!document().scene().find(mesh())->stack.empty()) document().undo();
            QTRY_VERIFY_WITH_TIMEOUT(!busy(), 120000);
        }
        QVERIFY(!QFile::exists(folder_.filePath("never.glb")));
    }
};

int main(int argc, char** argv)
{
    prepareApplication();
    TimedApplication application(argc, argv);
    dressApplication(application);
    ResponsiveTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "responsive_test.moc"
