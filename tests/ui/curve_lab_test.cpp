// The lab's page for curves: points by hand and by number, undo within the page, schemes and masks, stepping, the command line.
// With MESHWRIGHT_PICTURES=FOLDER it also saves pictures of it, both themes.
#include "ui/panels/curve_lab.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>

#include "core/catalog/catalog.h"
#include "ui/application.h"
#include "ui/panels/curve_canvas.h"
#include "ui/parameter_form.h"
#include "ui/session.h"
#include "ui/theme.h"

using namespace mw;

namespace {

struct Desk {
    Document document;
    Jobs jobs;
    ViewState view;
    StepSession steps{document, jobs};
    Session session{document, jobs, view, steps};
    std::unique_ptr<QWidget> panel{makeCurveLabPanel(session, nullptr)};
    Desk()
    {
        panel->resize(380, 900);
        panel->show();
    }
    CurveCanvas* canvas() const { return panel->findChild<CurveCanvas*>("curveCanvas"); }
    QTableWidget* table() const { return panel->findChild<QTableWidget*>("curvePoints"); }
    QPoint place(glm::dvec2 p) const { return canvas()->placeOf(p).toPoint(); }
    void press(const char* name) const { panel->findChild<QPushButton*>(name)->click(); }
    void drag(glm::dvec2 from, glm::dvec2 to, Qt::KeyboardModifiers m = {}) const
    {
        QTest::mousePress(canvas(), Qt::LeftButton, m, place(from));
        for (const double t : {0.4, 0.8, 1.0}) {
            const QPointF at = canvas()->placeOf(glm::mix(from, to, t));
            QMouseEvent move(QEvent::MouseMove, at, canvas()->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, m);
            QApplication::sendEvent(canvas(), &move);
        }
        QTest::mouseRelease(canvas(), Qt::LeftButton, m, place(to));
    }
    void set(const QString& name, const ParameterValue& v) const
    {
        auto* form = panel->findChild<ParameterForm*>("curveForm");
        ParameterValues values = form->values();
        values[name.toStdString()] = v;
        form->setValues(values);
        emit form->committed(values, name);
    }
    QString trouble() const { return panel->findChild<QLabel*>("curveTrouble")->text(); }
};

bool near(glm::dvec2 a, glm::dvec2 b)
{
    return glm::distance(a, b) < 0.02;  // a pixel or two
}

}  // namespace

class CurveLabTest : public QObject {
    Q_OBJECT

private slots:
    void pointsByHand();
    void pointsByKeyAndNumber();
    void nothingIsHidden();
    void schemesAndMasks();
    void steppingAndCommand();
    void pictures();
};

void CurveLabTest::pointsByHand()
{
    Desk d;
    QVERIFY(QTest::qWaitForWindowActive(d.panel.get()));
    QCOMPARE(d.canvas()->points().size(), 4u);
    d.drag({1, 1}, {1.2, 1.1});
    QVERIFY(near(d.canvas()->points()[2], {1.2, 1.1}));
    d.drag({1.2, 1.1}, {1.3, 0.6}, Qt::ShiftModifier);
    QVERIFY(near(d.canvas()->points()[2], {1.2, 0.6}));  // the longer way, the other axis stays
    QTest::mouseClick(d.canvas(), Qt::LeftButton, {}, d.place({0.5, 0}));
    QCOMPARE(d.canvas()->points().size(), 5u);
    QVERIFY(near(d.canvas()->points()[1], {0.5, 0}));  // within the segment
    QTest::mouseClick(d.canvas(), Qt::LeftButton, Qt::AltModifier, d.place({0, 0}));
    QCOMPARE(d.canvas()->points().size(), 4u);
    QVERIFY(near(d.canvas()->points()[0], {0.5, 0}));
    d.canvas()->setFocus();
    for (int i = 0; i < 4; ++i) QTest::keyClick(d.canvas(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(d.canvas()->points(), (CurveCanvas::Points{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    QTest::keyClick(d.canvas(), Qt::Key_Z, Qt::ControlModifier);  // no further back
    QCOMPARE(d.canvas()->points().size(), 4u);
    QTest::keyClick(d.canvas(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(near(d.canvas()->points()[2], {1.2, 1.1}));
    QCOMPARE(d.document.history().size(), Document().history().size());  // the scene knows nothing of it
}

void CurveLabTest::pointsByKeyAndNumber()
{
    Desk d;
    QVERIFY(QTest::qWaitForWindowActive(d.panel.get()));
    d.canvas()->setFocus();
    QTest::keyClick(d.canvas(), Qt::Key_Period);
    QCOMPARE(d.canvas()->selected(), 0);
    QTest::keyClick(d.canvas(), Qt::Key_Right);
    QVERIFY(d.canvas()->points()[0].x > 0);
    QTest::keyClick(d.canvas(), Qt::Key_Insert);
    QCOMPARE(d.canvas()->points().size(), 5u);
    QCOMPARE(d.table()->rowCount(), 5);
    QTest::keyClick(d.canvas(), Qt::Key_Delete);
    QCOMPARE(d.canvas()->points().size(), 4u);
    d.table()->item(3, 1)->setText("-2.5");
    QCOMPARE(d.canvas()->points()[3], glm::dvec2(0, -2.5));
    d.table()->item(3, 1)->setText("nothing");  // is not taken
    QCOMPARE(d.canvas()->points()[3], glm::dvec2(0, -2.5));
    QCOMPARE(d.table()->item(3, 1)->text(), QString("-2.5"));
    d.press("curveReset");
    QCOMPARE(d.canvas()->points()[3], glm::dvec2(0, 1));
}

// What is typed far away comes into sight, and the legend goes where no point is.
void CurveLabTest::nothingIsHidden()
{
    Desk d;
    d.table()->item(3, 1)->setText("-250");
    QVERIFY(d.canvas()->rect().contains(d.place({0, -250})));
    d.press("curveReset");
    d.canvas()->grab();
    for (const glm::dvec2& p : d.canvas()->points()) QVERIFY(!d.canvas()->legend().contains(d.place(p)));
    const glm::dvec2 aside = d.canvas()->at(QPointF(d.canvas()->legend().center()));
    d.table()->item(3, 0)->setText(QString::number(aside.x));
    d.table()->item(3, 1)->setText(QString::number(aside.y));
    d.canvas()->grab();  // paints
    for (const glm::dvec2& p : d.canvas()->points()) {
        QVERIFY(d.canvas()->rect().contains(d.place(p)));
        QVERIFY(!d.canvas()->legend().contains(d.place(p)));
    }
    d.canvas()->setFocus();
    d.canvas()->setSelected(0);
    for (int i = 0; i < 100; ++i) QTest::keyClick(d.canvas(), Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(d.canvas()->rect().contains(d.place(d.canvas()->points()[0])));
}

void CurveLabTest::schemesAndMasks()
{
    Desk d;
    d.set("scheme", std::string("mask"));
    QVERIFY2(d.trouble().isEmpty(), qPrintable(d.trouble()));
    d.set("new", std::string("1/2 1/4"));
    QVERIFY(d.trouble().contains("sum to 0.75"));
    QVERIFY(!d.panel->findChild<QPushButton*>("curveStep")->isEnabled());
    d.set("new", std::string("-1/16 9/16 9/16 -1/16"));
    QVERIFY(d.trouble().isEmpty());
    while (d.canvas()->points().size() > 2) {
        d.canvas()->setSelected(0);
        QTest::keyClick(d.canvas(), Qt::Key_Delete);
    }
    QVERIFY(d.trouble().contains("three points"));
    d.panel->findChild<QCheckBox*>("curveClosed")->click();
    QVERIFY(d.trouble().isEmpty());
}

void CurveLabTest::steppingAndCommand()
{
    Desk d;
    d.set("scheme", std::string("b-spline"));
    d.press("curveCopy");
    const QString line = QApplication::clipboard()->text();
    QVERIFY2(line.contains("sample-curve:given=0,0 1,0 1,1 0,1,closed=true") && line.contains("subdivide-curve:scheme=b-spline"), qPrintable(line));
    d.press("curveStep");
    QVERIFY(d.steps.isOpen());
    QCOMPARE(QString::fromStdString(d.steps.operation()->id), QString("subdivide-curve"));
    QVERIFY(!d.steps.node());
    QTRY_VERIFY(d.steps.value() != nullptr);
    QCOMPARE(std::get<Curve>(*d.steps.value()).points.size(), 4u);
}

void CurveLabTest::pictures()
{
    const QString folder = qEnvironmentVariable("MESHWRIGHT_PICTURES");
    if (folder.isEmpty()) QSKIP("MESHWRIGHT_PICTURES is not set");
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        applyTheme(*qApp, theme);
        Desk d;
        d.drag({1, 1}, {1.3, 1.2});
        d.set("scheme", std::string("b-spline"));
        QTest::qWait(200);
        d.panel->grab().save(QDir(folder).filePath(theme == Theme::Dark ? "curve-lab-dark.png" : "curve-lab-light.png"));
    }
}

int main(int argc, char** argv)
{
    prepareApplication();
    QApplication app(argc, argv);
    dressApplication(app);
    CurveLabTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "curve_lab_test.moc"
