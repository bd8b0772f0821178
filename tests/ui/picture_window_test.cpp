// Light, matcaps and pictures from the window.
#include <QAction>
#include <QFileInfo>
#include <QImage>
#include <QSignalSpy>
#include <QTest>

#include "core/scene/samples.h"
#include "tests/ui/window_fixture.h"
#include "ui/viewport/viewport.h"
// epoxy comes before Qt's own OpenGL headers
#include "ui/pictures.h"

using namespace mw;

class PictureWindowTest : public QObject, protected WindowFixture {
    Q_OBJECT

private:
    PictureWish small() { return {160, 120, false, false, 6, true}; }

private slots:
    void init()
    {
        showWindow(1100, 700);
        w_->session().document.commit("sample", sampleScene("mannequin"));
        settle();
    }
    void cleanup() { w_.reset(); }

    void menusChangeTheLight()
    {
        const ViewOptions& o = w_->session().view.options;
        const PictureWish wish = small();
        const auto shown = [&] { return view().picture(pictureFrame(w_->session(), view(), wish), {160, 120}).rgba; };
        const auto before = shown();
        for (const char* light : {"Studio", "Overcast sky", "Sunset", "Even light", "Sun alone"}) {
            QVERIFY(action(light));
            action(light)->trigger();
            QCOMPARE(int(o.lighting), int(Lighting::Environment));
            QVERIFY(action(light)->isChecked());
            QVERIFY(shown() != before);
        }
        const auto sun = shown();
        action("Shadows")->trigger();
        QVERIFY(o.shadows);
        QVERIFY(shown() != sun);
        action("Jade")->trigger();
        QCOMPARE(int(o.shading), int(Shading::Matcap));
        QCOMPARE(o.matcap, std::string("jade"));
        QVERIFY(action("Matcap")->isChecked());
        action("Three lights")->trigger();
        action("Shadows")->trigger();
        action("Smooth")->trigger();
        QVERIFY(shown() == before);
    }

    void aPictureOfAnySizeWithoutBackground()
    {
        PictureWish wish = small();
        wish.width = 333;
        wish.height = 211;
        wish.transparent = true;
        const QString file = folder_.filePath("p.png");
        savePicture(w_->session(), view(), wish, file);
        const QImage image(file);
        QCOMPARE(image.size(), QSize(333, 211));
        QCOMPARE(qAlpha(image.pixel(2, 2)), 0);
        int opaque = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) opaque += qAlpha(image.pixel(x, y)) == 255;
        QVERIFY(opaque > 1000);
    }

    void aTurntableIsAJobThatLeavesTheWindowAnswering()
    {
        PictureWish wish = small();
        wish.animated = false;
        Jobs& jobs = w_->session().jobs;
        saveTurntable(w_->session(), view(), wish, folder_.filePath("turn.png"));
        QVERIFY(jobs.busy());
        QTRY_VERIFY_WITH_TIMEOUT(!jobs.busy(), 60000);
        QCOMPARE(int(jobs.jobs().back().state), int(Job::State::Done));
        QImage first(folder_.filePath("turn-000.png")), other(folder_.filePath("turn-002.png"));
        QCOMPARE(first.size(), QSize(160, 120));
        QVERIFY(QFileInfo::exists(folder_.filePath("turn-005.png")));
        QVERIFY(!QFileInfo::exists(folder_.filePath("turn-006.png")));
        QVERIFY(first != other);
    }

    void aCancelledTurntableLeavesNoFile()
    {
        PictureWish wish = small();
        wish.count = 400;
        Jobs& jobs = w_->session().jobs;
        const QString file = folder_.filePath("never.apng");
        saveTurntable(w_->session(), view(), wish, file);
        QTest::qWait(150);
        QElapsedTimer clock;
        clock.start();
        jobs.cancel(jobs.jobs().back().id);
        QTRY_VERIFY_WITH_TIMEOUT(!jobs.busy(), 5000);
        QCOMPARE(int(jobs.jobs().back().state), int(Job::State::Cancelled));
        qInfo("cancelled in %lld ms", static_cast<long long>(clock.elapsed()));
        QVERIFY(!QFileInfo::exists(file));
        QTRY_VERIFY_WITH_TIMEOUT(!QFileInfo::exists(file + ".part"), 5000);  // the worker hears of it within a moment
    }
};

int main(int argc, char** argv)
{
    return runTests<PictureWindowTest>(argc, argv, 4);
}

#include "picture_window_test.moc"
