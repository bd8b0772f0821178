// Properties, materials and texture coordinates as panels: numbers in, scene changed, one history entry each; what they show is the scene.
// With MESHWRIGHT_PICTURES=FOLDER it also saves pictures of them in the window, both themes, two sizes.
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QTest>
#include <QToolButton>
#include <filesystem>

#include "core/io/io.h"
#include "core/math/srgb.h"
#include "core/metrics/uv_layout.h"
#include "core/scene/edit.h"
#include "core/scene/materials.h"
#include "tests/ui/panel_desk.h"
#include "tests/ui/thread_time.h"
#include "tests/ui/window_fixture.h"
#include "ui/file_commands.h"
#include "ui/look.h"
#include "ui/panels/axis_box.h"
#include "ui/panels/colour_field.h"
#include "ui/panels/fold.h"
#include "ui/panels/properties.h"
#include "ui/panels/texture_slot.h"
#include "ui/panels/uv.h"
#include "ui/panels/uv_canvas.h"
#include "ui/panels/uv_picture.h"
#include "ui/stack_edits.h"
#include "ui/theme.h"
#include "ui/viewport/viewport.h"
#include "ui/workspaces.h"

using namespace mw;

namespace {

QString dataFolder()
{
    const QString d = qEnvironmentVariable("MESHWRIGHT_DATA");
    return QDir(d).exists() ? d : QString();
}

// A 2 x 1 sheet of quads whose texture coordinates are its places; the third quad is folded back.
Mesh sheet()
{
    Array<glm::vec3> p;
    Array<float> uv;
    Array<uint32_t> start{0u}, corners;
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x) p.push_back({float(x), float(2 * y), 0});
    for (uint32_t x = 0; x < 3; ++x) {
        for (const uint32_t v : {x, x + 1, x + 5, x + 4}) {
            corners.push_back(v);
            const float u = p[v].x > 2 ? 1.5f : p[v].x;
            uv.insert(uv.end(), {u / 4, p[v].y / 4});
        }
        start.push_back(uint32_t(corners.size()));
    }
    return Mesh(std::move(p), std::move(start), std::move(corners)).with(floatAttribute("texcoord", Domain::Corner, 2, std::move(uv)));
}

struct Desk : PanelDesk {
    NodeId arm, first, second;

    explicit Desk(QWidget* (*make)(Session&, QWidget*), int width = 356)
    {
        Scene s;
        Node a;
        a.name = "arm";
        a.local.translation = {1, 0, 0};
        a.local.rotation = glm::dquat(glm::radians(glm::dvec3(0, 0, 90)));
        arm = s.add(a);
        Material clay;
        clay.name = "clay";
        MeshObject object;
        object.name = "sheet";
        object.base = sheet();
        object.materials = {s.add(clay)};
        Node n;
        n.name = "left";
        n.local.translation = {2, 0, 0};
        n.mesh = s.add(object);
        first = s.add(n, arm);
        n.name = "right";
        n.local.translation = {2, 5, 0};
        second = s.add(n);
        document.open(s, {}, "New");
        document.select({{first}, {}, {}});
        show(make, width, 900);
        QApplication::processEvents();
    }
    AxisBox* field(const char* name) const { return panel->findChild<AxisBox*>(name); }
    void type(AxisBox* box, const QString& text) const
    {
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, text);
        QTest::keyClick(box, Qt::Key_Return);
        QApplication::processEvents();
    }
    const Material& material() const
    {
        const Scene& s = document.scene();
        return *s.find(s.find(s.node(first).mesh)->materials.front());
    }
    UvCanvas* canvas() const { return panel->findChild<UvCanvas*>(); }
};

QString shownText(QWidget* panel)
{
    QString text;
    for (const QLabel* l : panel->findChildren<QLabel*>())
        if (l->isVisible()) text += l->text() + "\n";
    return text;
}

}  // namespace

class PanelsTest : public QObject {
    Q_OBJECT

private slots:
    void aTypedNumberIsOneEntry();
    void rotationKeepsItsNumbers();
    void aDragIsOneEntryAndEscLeavesIt();
    void severalNodesShowMixedAndTakeAll();
    void theProductOfMatricesIsTheWorldMatrix();
    void boundsAreThoseOfTheMesh();
    void coloursAreLinearInsideAndScreenOutside();
    void lightOfTheViewIsNoEdit();
    void slotsAssignAndShare();
    void aPictureByFileAndWhyNot();
    void theUvPanelSelectsWithTheView();
    void zoomKeepsThePointUnderThePointer();
    void withoutCoordinatesItSaysSo();
    void aFaceHasTheColourThatTheLegendGivesItsValue();
    void linesDoNotGreyDenseColours();
    void aSmallFoldIsRinged();
    void aLargeLayoutDoesNotHoldTheWindow();
    void nothingIsCutInANarrowDock();
    void pictures();
};

void PanelsTest::aTypedNumberIsOneEntry()
{
    Desk d(makePropertiesPanel);
    d.type(d.field("position-y"), "3.5");
    QCOMPARE(d.document.scene().node(d.first).local.translation.y, 3.5);
    QCOMPARE(d.document.history().size(), size_t(2));
    QCOMPARE(d.document.history()[1].calls.size(), size_t(1));
    d.document.undo();
    QApplication::processEvents();
    QCOMPARE(d.field("position-y")->value(), 0.0);
}

void PanelsTest::rotationKeepsItsNumbers()
{
    Desk d(makePropertiesPanel);
    // Past 90 about Y, and more than a turn about Z: a quaternion alone would give other numbers back.
    for (const auto& [name, text] : {std::pair("rotation-x", "20"), {"rotation-y", "120"}, {"rotation-z", "400"}}) d.type(d.field(name), text);
    QCOMPARE(d.field("rotation-x")->value(), 20.0);
    QCOMPARE(d.field("rotation-y")->value(), 120.0);
    QCOMPARE(d.field("rotation-z")->value(), 400.0);
    const glm::dquat q = d.document.scene().node(d.first).local.rotation;
    QVERIFY(std::abs(std::abs(glm::dot(q, glm::dquat(glm::radians(glm::dvec3(20, 120, 400))))) - 1) < 1e-9);
    QCOMPARE(d.document.history().size(), size_t(4));
}

void PanelsTest::aDragIsOneEntryAndEscLeavesIt()
{
    Desk d(makePropertiesPanel);
    QVERIFY(QTest::qWaitForWindowActive(d.panel.get()));  // only then a press gives the focus
    QLineEdit* line = d.field("position-x")->findChild<QLineEdit*>();
    const auto drag = [&](int by, bool release) {
        QTest::mousePress(line, Qt::LeftButton, {}, {10, 8});
        for (int i = 1; i <= 5; ++i) {
            QMouseEvent move(QEvent::MouseMove, QPointF(10 + by * i / 5, 8), line->mapToGlobal(QPointF(10 + by * i / 5, 8)), Qt::NoButton,
                             Qt::LeftButton, {});
            QApplication::sendEvent(line, &move);
        }
        if (release) QTest::mouseRelease(line, Qt::LeftButton, {}, {10 + by, 8});
        QApplication::processEvents();
    };
    drag(100, false);
    QVERIFY(std::abs(d.document.scene().node(d.first).local.translation.x - 3) < 1e-9);  // seen before it is released
    QCOMPARE(d.document.history().size(), size_t(1));
    QTest::keyClick(line, Qt::Key_Escape);
    QTest::mouseRelease(line, Qt::LeftButton, {}, {110, 8});
    QApplication::processEvents();
    QCOMPARE(d.document.scene().node(d.first).local.translation.x, 2.0);
    QCOMPARE(d.document.history().size(), size_t(1));
    drag(50, true);
    QVERIFY(std::abs(d.document.scene().node(d.first).local.translation.x - 2.5) < 1e-9);
    QCOMPARE(d.document.history().size(), size_t(2));
}

void PanelsTest::severalNodesShowMixedAndTakeAll()
{
    Desk d(makePropertiesPanel);
    d.document.select({{d.first, d.second}, {}, {}});
    QApplication::processEvents();
    QVERIFY(d.field("position-y")->mixed());
    QCOMPARE(d.field("position-y")->text().remove(" m"), QString("mixed"));
    QVERIFY(!d.field("position-x")->mixed());
    d.type(d.field("position-y"), "5");  // what the active one has already
    for (const NodeId id : {d.first, d.second}) QCOMPARE(d.document.scene().node(id).local.translation, glm::dvec3(2, 5, 0));
    QCOMPARE(d.document.history().size(), size_t(2));
    QCOMPARE(d.document.history()[1].calls.size(), size_t(2));
    QVERIFY(!d.field("position-y")->mixed());
    d.document.undo();
    QCOMPARE(d.document.scene().node(d.first).local.translation.y, 0.0);
}

void PanelsTest::theProductOfMatricesIsTheWorldMatrix()
{
    Desk d(makePropertiesPanel);
    for (Fold* f : d.panel->findChildren<Fold*>())
        if (f->head()->text() == "Matrices") f->head()->setChecked(true);
    QApplication::processEvents();
    auto* formula = d.panel->findChild<QLabel*>("matrixFormula");
    QVERIFY(formula);
    QCOMPARE(formula->text(), QString("M<sub>world</sub> = M<sub>arm</sub> · M<sub>left</sub>"));
    // A quarter turn about Z at (1, 0, 0), then 2 along its x: at (1, 2, 0).
    const auto place = [&] {
        QStringList cells;
        QRegularExpression cell("<td[^>]*>([^<]*)</td>");
        auto it = cell.globalMatch(d.panel->findChild<QLabel*>("matrixProduct")->text());
        while (it.hasNext()) cells << it.next().captured(1);
        return cells.size() == 16 ? QStringList{cells[3], cells[7], cells[11]} : cells;
    };
    QCOMPARE(place(), (QStringList{"1", "2.000", "0"}));
    // Live: a preview is seen at once.
    d.document.preview(edited(d.document.scene(), parsedEdit("transform:node=left,position=3/0/0")));
    QApplication::processEvents();
    QCOMPARE(place(), (QStringList{"1", "3.000", "0"}));
}

void PanelsTest::boundsAreThoseOfTheMesh()
{
    Desk d(makePropertiesPanel);
    QCOMPARE(d.panel->findChild<QLabel*>("boundsSizeX")->text(), QString("3"));
    QCOMPARE(d.panel->findChild<QLabel*>("boundsWorldSizeX")->text(), QString("2"));  // turned by the arm
}

void PanelsTest::coloursAreLinearInsideAndScreenOutside()
{
    QVERIFY(std::abs(srgbFromLinear(0.2140411) - 0.5) < 1e-6);  // half of the screen's range is a fifth of its light
    QCOMPARE(screenColour({1, 0.2158605, 0}).name(), QString("#ff8000"));
    for (int i = 0; i < 256; ++i) QCOMPARE(int(std::lround(255 * srgbFromLinear(linearFromSrgb(i / 255.0)))), i);
    Desk d(makePropertiesPanel);
    auto* field = d.panel->findChild<ColourField*>("baseColour");
    emit field->edited({0.5, 0.25, 0.125});
    QCOMPARE(glm::dvec3(d.material().baseColor), glm::dvec3(0.5, 0.25, 0.125));
    QCOMPARE(d.document.history().size(), size_t(1));
    field->openPopup();
    auto* hex = QApplication::activePopupWidget() ? QApplication::activePopupWidget()->findChild<QLineEdit*>("colourHex") : nullptr;
    QVERIFY(hex);
    hex->setFocus();
    hex->selectAll();
    QTest::keyClicks(hex, "#808080");
    QTest::keyClick(hex, Qt::Key_Return);
    QVERIFY(std::abs(d.material().baseColor.r - 0.2158605) < 1e-6);
    QCOMPARE(d.document.history().size(), size_t(2));
    QApplication::activePopupWidget()->close();
}

void PanelsTest::lightOfTheViewIsNoEdit()
{
    Desk d(makePropertiesPanel);
    auto* form = d.panel->findChild<ParameterForm*>("viewForm");
    QVERIFY(form);
    emit form->committed({{"light", std::string("environment")}, {"turn", 90.0}, {"shadows", true}}, "");
    QVERIFY(d.view.options.lighting == Lighting::Environment);
    QVERIFY(std::abs(d.view.options.environmentTurn - 1.5707963267948966) < 1e-12);
    QVERIFY(d.view.options.shadows);
    QVERIFY(!d.view.options.checker);
    d.view.options.checker = true;  // as a menu does
    d.view.touch();
    QCOMPARE(std::get<bool>(form->values().at("checker")), true);
    QCOMPARE(d.document.history().size(), size_t(1));
}

void PanelsTest::slotsAssignAndShare()
{
    Desk d(makePropertiesPanel);
    const auto button = [&](const QString& name) {
        for (auto* b : d.panel->findChildren<QPushButton*>())
            if (b->accessibleName() == name || b->objectName() == name) return b;
        return static_cast<QPushButton*>(nullptr);
    };
    button("New material")->click();
    auto* list = d.panel->findChild<QListWidget*>("materialSlots");
    QCOMPARE(list->count(), 2);
    QCOMPARE(list->currentRow(), 1);
    d.document.select({{d.first}, d.first, {ElementKind::Face, {1}}});
    QApplication::processEvents();
    button("assignMaterial")->click();
    const MeshObject& o = *d.document.scene().find(d.document.scene().node(d.first).mesh);
    const Attribute* a = o.base.find(names::material, Domain::Face);
    QVERIFY(a);
    QCOMPARE(a->at(0, 0), 0.0);
    QCOMPARE(a->at(1, 0), 1.0);
    // A second mesh with the same material: the panel says so and gives an own copy.
    commitEdit(d.document, parsedEdit("use-material:node=left,slot=1,material=clay"));
    QApplication::processEvents();
    QVERIFY(shownText(d.panel.get()).contains("2 users"));
    button("ownMaterial")->click();
    QApplication::processEvents();
    QVERIFY(!shownText(d.panel.get()).contains("users"));
    list->item(1)->setText("glass");
    QCOMPARE(d.document.scene().find(d.document.scene().find(d.document.scene().node(d.first).mesh)->materials[1])->name, std::string("glass"));
}

void PanelsTest::aPictureByFileAndWhyNot()
{
    Desk d(makePropertiesPanel);
    const QString folder = QDir::tempPath() + QString("/panels-%1").arg(QCoreApplication::applicationPid());
    QDir().mkpath(folder);
    QImage picture(8, 4, QImage::Format_RGB32);
    picture.fill(Qt::red);
    QVERIFY(picture.save(folder + "/red.png"));
    auto* slot = d.panel->findChild<TextureSlot*>("texture-base-color");
    slot->take(folder + "/red.png");
    QVERIFY(d.material().baseColorTexture.image);
    QVERIFY(shownText(d.panel.get()).contains("8 × 4, red.png"));
    slot->take(folder + "/none.png");
    QVERIFY(shownText(d.panel.get()).contains("none.png"));
    QCOMPARE(d.document.history().size(), size_t(2));
    d.document.undo();
    QApplication::processEvents();
    QVERIFY(!d.material().baseColorTexture.image);
    QDir(folder).removeRecursively();
}

void PanelsTest::theUvPanelSelectsWithTheView()
{
    Desk d(makeUvPanel, 304);
    QTRY_COMPARE(d.panel->findChild<QLabel*>("uvFolded")->text(), QString("1 face folded over"));
    d.panel->findChild<QPushButton*>("uvSelectFolded")->click();
    QCOMPARE(d.document.selection().elements.indices, std::vector<uint32_t>{2});
    const auto click = [&](double u, double v, Qt::KeyboardModifiers m = {}) {
        QTest::mouseClick(d.canvas(), Qt::LeftButton, m, d.canvas()->placeOf({u, v}).toPoint());
    };
    click(0.1, 0.2);
    QCOMPARE(d.document.selection().elementsOf, d.first);
    QCOMPARE(d.document.selection().elements.indices, std::vector<uint32_t>{0});
    click(0.3, 0.3, Qt::ShiftModifier);
    QCOMPARE(d.document.selection().elements.indices, (std::vector<uint32_t>{0, 1}));
    // Two faces lie on each other at 0.45: the same place again gives the other one.
    click(0.45, 0.3);
    QCOMPARE(d.document.selection().elements.indices, std::vector<uint32_t>{1});
    click(0.45, 0.3);
    QCOMPARE(d.document.selection().elements.indices, std::vector<uint32_t>{2});
    d.view.pickKind = PickKind::Vertex;
    d.view.touch();
    click(0.252, 0.003);
    QVERIFY(d.document.selection().elements.kind == ElementKind::Vertex);
    QCOMPARE(d.document.selection().elements.indices, std::vector<uint32_t>{1});
    click(0.9, 0.9);
    QVERIFY(d.document.selection().elements.indices.empty());
}

void PanelsTest::zoomKeepsThePointUnderThePointer()
{
    Desk d(makeUvPanel, 304);
    QTRY_VERIFY(d.panel->findChild<QLabel*>("uvFigures")->text().contains("seam"));  // measured, and fitted
    QTRY_VERIFY(d.canvas()->upToDate());
    const QPointF at(70, 40);
    const glm::dvec2 before = d.canvas()->coordinatesAt(at);
    QWheelEvent wheel(at, d.canvas()->mapToGlobal(at), {}, {0, 240}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    const double scale = d.canvas()->view().perUnit;
    QApplication::sendEvent(d.canvas(), &wheel);
    QVERIFY(d.canvas()->view().perUnit > 1.3 * scale);
    QVERIFY(glm::distance(d.canvas()->coordinatesAt(at), before) < 1e-9);
    QTest::keyClick(d.canvas(), Qt::Key_Home);
    QVERIFY(std::abs(d.canvas()->view().perUnit / scale - 1) < 1e-9);
}

void PanelsTest::withoutCoordinatesItSaysSo()
{
    Desk d(makeUvPanel, 304);
    Scene s = d.document.scene();
    MeshObject o = *s.find(s.node(d.first).mesh);
    o.base = o.base.without("texcoord");
    s.set(s.node(d.first).mesh, o);
    d.document.commit("bare", s);
    QApplication::processEvents();
    QVERIFY(shownText(d.panel.get()).contains("This mesh has no texture coordinates."));
    for (auto* b : d.panel->findChildren<QPushButton*>())
        if (b->text() == "Project from a box") b->click();
    QTRY_COMPARE(d.panel->findChild<QLabel*>("uvFigures")->text(), QString("0 seam edges"));  // all look the same way
    d.document.select({});
    QApplication::processEvents();
    QVERIFY(shownText(d.panel.get()).contains("Select a mesh"));
}

// Canvas, legend and, for angles, the 3D view: one value, one colour.
void PanelsTest::aFaceHasTheColourThatTheLegendGivesItsValue()
{
    const Mesh grid = std::get<Mesh>(apply(operation("grid"), {}, {}));
    const Bounds box = grid.bounds();
    const glm::vec3 low(box.min), size(box.max - box.min);
    Array<float> uv;
    for (const glm::vec3& p : grid.positions()) {  // the farther from the corner, the more it is spread
        const glm::vec3 t = (p - low) / glm::max(size, glm::vec3(1e-9f));
        const float a = t.x, b = size.y > size.z ? t.y : t.z;
        uv.insert(uv.end(), {a * a, b * std::sqrt(b)});
    }
    const Mesh mesh = grid.with(floatAttribute("texcoord", Domain::Vertex, 2, std::move(uv)));
    const UvSubject subject{mesh, uvLayoutOf(mesh, 0), std::get<Table>(apply(operation("uv-distortion"), mesh, {}))};
    Desk d(makeUvPanel, 304);
    Scene s = d.document.scene();
    MeshObject o = *s.find(s.node(d.first).mesh);
    o.base = mesh;
    s.set(s.node(d.first).mesh, o);
    d.document.commit("warped", s);
    auto* choice = d.panel->findChild<QComboBox*>("uvColour");
    for (const UvColour colour : {UvColour::Angle, UvColour::Area}) {
        choice->setCurrentIndex(int(colour));
        emit choice->activated(int(colour));
        // Until the job of this mesh is done the figures are those of the one before.
        const auto& sum = subject.distortion.summary;
        const QString figures = colour == UvColour::Angle ? QString("mean %1, most %2").arg(look::number(sum[0].second), look::number(sum[1].second))
                                                          : QString("%1 to %2").arg(look::number(sum[2].second), look::number(sum[3].second));
        QTRY_COMPARE(d.panel->findChild<QLabel*>("uvFigures")->text(), figures);
        QTRY_VERIFY(d.canvas()->upToDate());
        const QImage canvas = d.canvas()->grab().toImage(), legend = d.panel->findChild<QWidget*>("uvLegend")->grab().toImage();
        const Column& column = subject.distortion.columns[colour == UvColour::Angle ? 0 : 1];
        const UvRange range = uvRangeOf(subject, colour);
        const auto away = [](QColor a, QColor b) {
            return std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
        };
        size_t looked = 0;
        for (size_t f = 0; f < mesh.faceCount(); ++f) {
            glm::dvec2 middle(0);
            QPolygonF shape;
            for (size_t k = 0; k < mesh.face(f).size(); ++k) {
                const glm::dvec2 at = subject.layout.corners[mesh.faceStart()[f] + k];
                middle += at / double(mesh.face(f).size());
                shape << d.canvas()->placeOf(at);
            }
            if (shape.boundingRect().width() < 8 || shape.boundingRect().height() < 8) continue;  // its lines fill it
            const QColor shown = canvas.pixelColor(d.canvas()->placeOf(middle).toPoint());
            QCOMPARE(shown, uvColourOf(colour, column.values[f], range));
            const double share = colour == UvColour::Angle ? (column.values[f] - range.low) / (range.high - range.low)
                                                           : 0.5 + 0.5 * std::log(column.values[f]) / std::log(range.high);
            const int x = int(std::lround(std::clamp(share, 0.0, 1.0) * (legend.width() - 1)));
            QVERIFY(away(legend.pixelColor(x, 6), shown) <= 6);  // a pixel of the bar is about an entry of the table
            ++looked;
        }
        QVERIFY(looked > 10);
        if (colour == UvColour::Angle) QCOMPARE(std::pair(range.low, range.high), heatRange(column));  // as HeatService has it
    }
}

// A chart whose faces are a pixel wide: all of one stretch, so all of it has the colour of that stretch.
void PanelsTest::linesDoNotGreyDenseColours()
{
    const Mesh grid = std::get<Mesh>(apply(operation("subdivide-loop"), std::get<Mesh>(apply(operation("grid"), {}, {})), {{"levels", int64_t(3)}}));
    Array<float> uv;
    for (const glm::vec3& p : grid.positions()) uv.insert(uv.end(), {0.5f + 0.2f * p.x, 0.5f + 0.2f * (p.y + p.z)});
    const Mesh mesh = grid.with(floatAttribute("texcoord", Domain::Vertex, 2, std::move(uv)));
    const UvSubject subject{mesh, uvLayoutOf(mesh, 0), std::get<Table>(apply(operation("uv-distortion"), mesh, {}))};
    UvOptions options;
    options.colour = UvColour::Area;
    const QImage image = uvPicture(subject, {{0.5, 0.5}, 250}, options, {101, 101});
    const UvRange range = uvRangeOf(subject, UvColour::Area);
    for (const int y : {30, 50, 70})
        for (const int x : {30, 50, 70}) {
            const std::vector<uint32_t> there = facesAt(mesh, subject.layout, {0.5 + (x - 50) / 250.0, 0.5 - (y - 50) / 250.0});
            QVERIFY(!there.empty());
            const QColor wanted = uvColourOf(UvColour::Area, subject.distortion.columns[1].values[there[0]], range), shown = image.pixelColor(x, y);
            // The next face may have the next colour of the table.
            QVERIFY2(std::abs(wanted.red() - shown.red()) <= 8 && std::abs(wanted.blue() - shown.blue()) <= 8, qPrintable(shown.name()));
        }
}

void PanelsTest::aSmallFoldIsRinged()
{
    const UvSubject subject{sheet(), uvLayoutOf(sheet(), 0), std::get<Table>(apply(operation("uv-distortion"), sheet(), {}))};
    QCOMPARE(subject.layout.folded, std::vector<uint32_t>{2});
    UvOptions options;
    options.picture = false;
    glm::dvec2 middle(0);
    for (size_t c = 8; c < 12; ++c) middle += 0.25 * glm::dvec2(subject.layout.corners[c]);
    const auto redBeside = [&](double perUnit) {  // to the left of the face, where the ring of a small one passes
        const QImage image = uvPicture(subject, {middle, perUnit}, options, {101, 101});
        const QColor c = image.pixelColor(50 - 7, 50);
        return c.red() > 200 && c.green() < 140;
    };
    QVERIFY(redBeside(12));   // 2 x 6 pixels
    QVERIFY(!redBeside(30));  // 4 x 15: seen without
}

void PanelsTest::aLargeLayoutDoesNotHoldTheWindow()
{
    const uint32_t n = 224;  // 100,352 triangles
    Array<glm::vec3> p;
    Array<uint32_t> t;
    Array<float> uv;
    for (uint32_t y = 0; y <= n; ++y)
        for (uint32_t x = 0; x <= n; ++x) p.push_back({float(x), float(y), 0});
    for (uint32_t y = 0; y < n; ++y)
        for (uint32_t x = 0; x < n; ++x) {
            const uint32_t a = y * (n + 1) + x, b = a + 1, c = a + n + 1, e = c + 1;
            for (const uint32_t v : {a, b, e, a, e, c}) {
                t.push_back(v);
                uv.insert(uv.end(), {p[v].x / float(n), p[v].y / float(n)});
            }
        }
    Desk d(makeUvPanel, 304);
    Scene s = d.document.scene();
    MeshObject o = *s.find(s.node(d.first).mesh);
    o.base = Mesh::triangles(std::move(p), std::move(t)).with(floatAttribute("texcoord", Domain::Corner, 2, std::move(uv)));
    s.set(s.node(d.first).mesh, o);
    d.document.commit("large", s);
    double longest = 0;
    QTRY_VERIFY(d.panel->findChild<QLabel*>("uvFigures")->text().contains("seam"));
    for (int i = 0; i < 60; ++i) {  // panning, event by event
        const double begin = threadMilliseconds();
        QMouseEvent press(QEvent::MouseButtonPress, {100, 60}, d.canvas()->mapToGlobal(QPointF(100, 60)), Qt::RightButton, Qt::RightButton, {});
        QMouseEvent move(QEvent::MouseMove, {double(110 + i % 7), 66}, d.canvas()->mapToGlobal(QPointF(110, 66)), Qt::NoButton, Qt::RightButton, {});
        if (i == 0) QApplication::sendEvent(d.canvas(), &press);
        QApplication::sendEvent(d.canvas(), &move);
        QApplication::processEvents();
        longest = std::max(longest, threadMilliseconds() - begin);
        QTest::qWait(5);
    }
    QElapsedTimer clock;
    clock.start();
    QTRY_VERIFY(d.canvas()->upToDate());
    std::printf("100,352 faces: longest event while panning %.0f ms, picture there %lld ms later\n", longest, clock.elapsed());
    QVERIFY(longest < 50);
}

void PanelsTest::nothingIsCutInANarrowDock()
{
    Desk d(makePropertiesPanel, 236);
    QApplication::processEvents();
    auto* area = d.panel->findChild<QScrollArea*>();
    QVERIFY2(area->widget()->minimumSizeHint().width() <= area->viewport()->width(),
             qPrintable(QString("%1 in %2").arg(area->widget()->minimumSizeHint().width()).arg(area->viewport()->width())));
    Desk uv(makeUvPanel, 236);
    QVERIFY2(uv.panel->minimumSizeHint().width() <= 236, qPrintable(QString::number(uv.panel->minimumSizeHint().width())));
}

void PanelsTest::pictures()
{
    const QString folder = qEnvironmentVariable("MESHWRIGHT_PICTURES"), data = dataFolder();
    if (folder.isEmpty() || data.isEmpty()) QSKIP("no pictures wanted, or no data");
    QDir().mkpath(folder);
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        applyTheme(*qApp, theme);
        for (const QSize size : {QSize(1600, 1000), QSize(1280, 800)}) {
            MainWindow w;
            w.resize(size);
            w.session().view.options.theme = theme;
            w.show();
            QVERIFY(QTest::qWaitForWindowExposed(&w));
            const auto settle = [&] {
                QTest::qWait(300);
                QTRY_VERIFY_WITH_TIMEOUT(w.evaluations().idle() && !w.session().jobs.busy(), 60000);
                QTest::qWait(500);
            };
            const auto shoot = [&](const QString& name) {
                w.grab().save(QString("%1/%2-%3-%4.png").arg(folder, name, theme == Theme::Dark ? "dark" : "light").arg(size.width()));
            };
            const auto open = [&](const char* file) {
                w.files().open(data + "/" + file);
                settle();
                const Scene& s = w.session().document.scene();
                for (const NodeId id : s.nodes())
                    if (s.node(id).mesh) w.session().document.select({{id}, {}, {}});
                w.workspaces().show("uv");
                w.workspaces().show("properties");
                settle();
            };
            open("meshes/closed_genus0/spot.obj");
            const std::string node = nodeText(w.session().document.scene(), w.session().document.selection().active());
            if (w.session().document.scene().find(w.session().document.scene().meshes()[0])->materials.empty())
                commitEdit(w.session().document, {"new-material", {{"node", node}}});
            settle();
            shoot("spot");
            for (auto* c : w.findChildren<QComboBox*>("uvColour")) c->setCurrentIndex(1), emit c->activated(1);
            for (Fold* f : w.findChildren<Fold*>())
                if (f->head()->text() == "Matrices") f->head()->setChecked(true);
            settle();
            shoot("spot-angles");
            for (auto* c : w.findChildren<QComboBox*>("uvColour")) c->setCurrentIndex(2), emit c->activated(2);
            open("meshes/nonmanifold/spider.obj");
            shoot("spider-areas");
            for (auto* c : w.findChildren<QComboBox*>("uvColour")) c->setCurrentIndex(0), emit c->activated(0);
            open("characters/cesium_man.gltf");
            if (auto* select = w.findChild<QPushButton*>("uvSelectFolded")) select->click();
            settle();
            shoot("cesium");
            open("meshes/quads/suzanne.obj");
            shoot("suzanne");
            for (const char* weights : {"wachspress", "mean-value"}) {  // the first folds a few small faces
                open("meshes/disk/camelhead.off");
                edits::addModifier(w.session().document, w.session().document.scene().meshes()[0], operation("embed-planar"),
                                   {{"weights", std::string(weights)}});
                settle();
                for (const int colour : {0, 2}) {
                    for (auto* c : w.findChildren<QComboBox*>("uvColour")) c->setCurrentIndex(colour), emit c->activated(colour);
                    settle();
                    shoot(QString("camel-%1-%2").arg(weights).arg(colour));
                }
            }
        }
    }
}

int main(int argc, char** argv)
{
    return runTests<PanelsTest>(argc, argv);
}

#include "panels_test.moc"
