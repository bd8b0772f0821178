// What tests of the whole window share: the window, waiting until it is at rest, its commands by name, and main().
#pragma once
#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "ui/application.h"
#include "ui/evaluation_service.h"
#include "ui/main_window.h"
#include "ui/viewport/viewport.h"

namespace mw {

class WindowFixture {
protected:
    std::unique_ptr<MainWindow> w_;
    QTemporaryDir folder_;

    void showWindow(int width, int height)
    {
        w_ = std::make_unique<MainWindow>();
        w_->resize(width, height);
        w_->show();
        QVERIFY(QTest::qWaitForWindowExposed(w_.get()));
    }
    Document& document() { return w_->session().document; }
    Session& session() { return w_->session(); }
    Viewport& view() { return w_->viewport(); }
    QString path(const QString& name) { return folder_.filePath(name); }

    bool busy() { return !w_->evaluations().idle() || session().jobs.busy(); }
    /// Until nothing runs, three times in a row: the end of one job may begin another.
    void settle(int mostMilliseconds = 120000)
    {
        QElapsedTimer clock;
        clock.start();
        for (int quiet = 0; quiet < 3; quiet = busy() ? 0 : quiet + 1) {
            QVERIFY(clock.elapsed() < mostMilliseconds);
            QTest::qWait(1);
        }
    }
    /// Until the view has drawn nothing for a while: flights and what loads by and by have ended.
    void settleView()
    {
        QElapsedTimer still;
        still.start();
        for (size_t drawn = 0; still.elapsed() < 250; QTest::qWait(10))
            if (view().framesDrawn() != drawn || busy()) drawn = view().framesDrawn(), still.restart();
    }
    /// Null when there is none.
    QAction* action(const QString& text)
    {
        for (QAction* a : w_->findChildren<QAction*>())
            if (a->text() == text) return a;
        return nullptr;
    }
};

/// Its terrains in few triangles, so that the software renderer keeps up.
inline Scene drawnCoarsely(Scene scene)
{
    for (const TerrainId id : scene.terrains()) {
        TerrainObject object = *scene.find(id);
        object.terrain.detail = {8, 16, 4, 80, 900, true};
        scene.set(id, std::move(object));
    }
    return scene;
}

/// Without multisampling, unless asked for: the software renderer is twice as quick, and most tests are about other things.
template <class Test>
int runTests(int argc, char** argv, int samples = 0)
{
    prepareApplication();
    QSurfaceFormat format = QSurfaceFormat::defaultFormat();
    format.setSamples(samples);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication app(argc, argv);
    dressApplication(app);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

}  // namespace mw
