#include "ui/panels/painter.h"

#include <QButtonGroup>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/catalog/entries.h"
#include "ui/look.h"
#include "ui/parameter_form.h"
#include "ui/terrain_edits.h"
#include "ui/theme.h"

namespace mw {
namespace {

constexpr size_t meshTriangles = 100'000;

struct BrushForm {
    double radius = 85, strength = 0.45, spacing = 20;
    template <class V>
    void describe(V& v)
    {
        v.number("radius", radius,
                 {.title = "Radius",
                  .help = "How far the brush reaches on the ground. Keys [ and ].",
                  .unit = "m",
                  .min = 0.1,
                  .max = 10000,
                  .softMin = 5,
                  .softMax = 400,
                  .logarithmic = true});
        v.number("strength", strength,
                 {.title = "Strength",
                  .help = "At 1 one dab moves the middle by a fiftieth of the maximum height. Keys Shift+[ and Shift+].",
                  .min = 0.01,
                  .max = 1});
        v.number("spacing", spacing,
                 {.title = "Spacing",
                  .help = "Way between two dabs, as a share of the radius.",
                  .unit = "%",
                  .min = 1,
                  .max = 200,
                  .softMin = 5,
                  .softMax = 100});
    }
};

struct LayerForm {
    double sandTo = 20, grassTo = 48, snowFrom = 55, rockSlope = 32;
    template <class V>
    void describe(V& v)
    {
        const auto share = [](const char* title, const char* help) {
            return About{.title = title, .help = help, .unit = "%", .min = -100, .max = 200, .softMin = 0, .softMax = 100};
        };
        v.number("snowFrom", snowFrom, share("Snow from", "Height, as a share of the maximum height, from which snow lies."));
        v.number("rockSlope", rockSlope,
                 {.title = "Rock from slope", .help = "Ground steeper than this is bare rock.", .unit = "\u00b0", .min = 0, .max = 90});
        v.number("grassTo", grassTo, share("Grass to", "Height, as a share of the maximum height, up to which grass grows."));
        v.number("sandTo", sandTo, share("Sand to", "Height, as a share of the maximum height, up to which there is sand."));
    }
};

/// 55 and not 55.00000000000001.
double percentOf(double share)
{
    return std::round(1e8 * share) / 1e6;
}

/// The profile of a falloff from border to border.
QIcon falloffIcon(Brush::Falloff f, const QColor& color, qreal ratio)
{
    QPixmap map(QSize(48, 26) * ratio);
    map.setDevicePixelRatio(ratio);
    map.fill(Qt::transparent);
    QPainter p(&map);
    p.setRenderHint(QPainter::Antialiasing);
    QPolygonF line;
    for (int i = 0; i <= 88; ++i) {
        const double x = -1.1 + 2.2 * i / 88, d = std::abs(x);
        line << QPointF(24 + 20 * x, 23 - 20 * (d > 1 ? 0 : falloffAt(f, d)));
    }
    p.setPen(QPen(color, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    p.drawPolyline(line);
    return map;
}

class PainterPanel : public QWidget {
public:
    PainterPanel(Session& session, QWidget* parent) : QWidget(parent), session_(session)
    {
        auto* outer = new QVBoxLayout(this);
        outer->setContentsMargins(0, 0, 0, 0);
        outer->setSpacing(0);
        empty_ = look::emptyState(this, &sentence_, &remedy_);
        sentence_->setText("There is no terrain to paint on.");
        remedy_->setText("New terrain");
        remedy_->setToolTip("Add a terrain by diamond-square");
        connect(remedy_, &QPushButton::clicked, this, [this] { edits::newTerrain(session_); });
        outer->addWidget(empty_);
        area_ = new QScrollArea(this);
        area_->setWidgetResizable(true);
        auto* inside = new QWidget(area_);
        box_ = new QVBoxLayout(inside);
        box_->setContentsMargins(8, 8, 8, 8);
        box_->setSpacing(6);
        makeTools(inside);
        makeBrush(inside);
        makeFalloff(inside);
        makeLayers(inside);
        box_->addStretch(1);
        area_->setWidget(inside);
        look::keepWide(area_);
        outer->addWidget(area_, 1);
        outer->addWidget(makeFiles());
        subscription_ = session_.document.subscribe([this](const Change&) { refresh(); });
        connect(&session_.view, &ViewState::brushChanged, this, [this] { refresh(); });
        refresh();
    }

private:
    void heading(QWidget* parent, const QString& title, QLabel** beside = nullptr)
    {
        auto* line = new QHBoxLayout;
        line->setContentsMargins(0, 6, 0, 0);
        line->setSpacing(6);
        line->addWidget(new QLabel("<b>" + title + "</b>", parent));
        auto* more = new QLabel(parent);
        more->setProperty("secondary", true);
        line->addWidget(more, 1);
        if (beside) *beside = more;
        box_->addLayout(line);
    }

    void makeTools(QWidget* parent)
    {
        auto* line = new QHBoxLayout;
        line->setSpacing(6);
        tools_ = new QButtonGroup(this);
        const struct {
            const char *text, *icon, *tip;
            Brush::Kind kind;
        } kinds[] = {{"Raise", "raise", "Lift the ground under the brush; Ctrl lowers it", Brush::Kind::Raise},
                     {"Lower", "lower", "Dig into the ground under the brush; Ctrl raises it", Brush::Kind::Lower}};
        for (const auto& k : kinds) {
            auto* b = new QToolButton(parent);
            b->setObjectName(QString("brush") + k.text);
            b->setText(k.text);
            b->setIcon(icon(k.icon));
            b->setIconSize({22, 22});
            b->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
            b->setCheckable(true);
            b->setToolTip(QString(k.tip) + " \u00b7 M takes the brush in hand");
            b->setFocusPolicy(Qt::TabFocus);
            b->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
            b->setFixedHeight(std::max(52, b->sizeHint().height()));
            b->setProperty("tile", true);
            tools_->addButton(b, int(k.kind));
            line->addWidget(b);
        }
        connect(tools_, &QButtonGroup::idClicked, this, [this](int id) {
            session_.view.brush.kind = Brush::Kind(id);
            session_.view.take(ToolKind::Brush);
        });
        box_->addLayout(line);
    }

    void makeBrush(QWidget* parent)
    {
        brush_ = new ParameterForm(described<BrushForm>(), brushValues(), parent);
        const auto take = [this](const ParameterValues& v) {
            const auto f = filled<BrushForm>(v);
            Brush& b = session_.view.brush;
            b.radius = f.radius;
            b.strength = f.strength;
            b.spacing = f.spacing / 100;
            session_.view.touchBrush();
        };
        connect(brush_, &ParameterForm::edited, this, take);
        connect(brush_, &ParameterForm::committed, this, [take](const ParameterValues& v, const QString&) { take(v); });
        box_->addWidget(brush_);
    }

    ParameterValues brushValues() const
    {
        const Brush& b = session_.view.brush;
        return {{"radius", b.radius}, {"strength", b.strength}, {"spacing", percentOf(b.spacing)}};
    }

    void makeFalloff(QWidget* parent)
    {
        heading(parent, "Falloff", &falloffName_);
        auto* line = new QHBoxLayout;
        line->setSpacing(6);
        falloffs_ = new QButtonGroup(this);
        for (int i = 0; i < 4; ++i) {
            auto* b = new QToolButton(parent);
            b->setIcon(falloffIcon(Brush::Falloff(i), tokens().text, devicePixelRatioF()));
            b->setIconSize({48, 26});
            b->setCheckable(true);
            b->setToolTip(QString(names_[i]) + " falloff: the strength from the middle of the brush to its border");
            b->setAccessibleName(QString(names_[i]) + " falloff");
            b->setFocusPolicy(Qt::TabFocus);
            b->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
            b->setFixedHeight(36);
            b->setProperty("tile", true);
            falloffs_->addButton(b, i);
            line->addWidget(b);
        }
        connect(falloffs_, &QButtonGroup::idClicked, this, [this](int id) {
            session_.view.brush.falloff = Brush::Falloff(id);
            session_.view.touchBrush();
        });
        box_->addLayout(line);
    }

    void makeLayers(QWidget* parent)
    {
        QLabel* beside = nullptr;
        heading(parent, "Texture layers", &beside);
        beside->setText("by height, then slope");
        const struct {
            const char *name, *color;
        } rows[] = {{"Snow", "#EEF3F7"}, {"Rock", "#7F7972"}, {"Grass", "#557838"}, {"Sand", "#A08D66"}, {"Water", "#3E78A8"}};
        for (int i = 0; i < 5; ++i) {
            auto* line = new QHBoxLayout;
            line->setSpacing(8);
            auto* swatch = new QLabel(parent);
            swatch->setFixedSize(18, 18);
            swatch->setStyleSheet(QString("background: %1; border-radius: 3px;").arg(rows[i].color));
            line->addWidget(swatch);
            line->addWidget(new QLabel(rows[i].name, parent), 1);
            bands_[i] = new QLabel(parent);
            bands_[i]->setProperty("secondary", true);
            line->addWidget(bands_[i]);
            box_->addLayout(line);
        }
        layers_ = new ParameterForm(described<LayerForm>(), {}, parent);
        layers_->setObjectName("layerForm");
        const auto changed = [this](const ParameterValues& v) {
            Terrain t = edits::terrainOf(session_.document, node_)->terrain;
            const auto f = filled<LayerForm>(v);
            t.layers = {f.sandTo / 100, f.grassTo / 100, f.snowFrom / 100, f.rockSlope};
            return t;
        };
        connect(layers_, &ParameterForm::edited, this, [this, changed](const ParameterValues& v) {
            if (edits::terrainOf(session_.document, node_)) edits::previewTerrain(session_.document, node_, changed(v));
        });
        connect(layers_, &ParameterForm::committed, this, [this, changed](const ParameterValues& v, const QString& what) {
            if (edits::terrainOf(session_.document, node_)) edits::commitTerrain(session_.document, node_, changed(v), what);
        });
        box_->addWidget(layers_);
    }

    QWidget* makeFiles()
    {
        files_ = new QWidget(this);
        auto* column = new QVBoxLayout(files_);
        column->setContentsMargins(8, 6, 8, 8);
        trouble_ = new QLabel(files_);
        trouble_->setWordWrap(true);
        trouble_->setStyleSheet("color: " + tokens().error.name());
        trouble_->hide();
        column->addWidget(trouble_);
        auto* line = new QHBoxLayout;
        const auto button = [&](const char* text, const char* tip) {
            auto* b = new QPushButton(text, files_);
            b->setToolTip(tip);
            b->setFocusPolicy(Qt::TabFocus);
            line->addWidget(b);
            return b;
        };
        const auto said = [this](const QString& text) {
            trouble_->setText(text);
            trouble_->setVisible(!text.isEmpty());
        };
        connect(button("Import...", "A picture in place of the height map: PNG of 8 or 16 bits, TGA, PGM"), &QPushButton::clicked, this,
                [this, said] {
                    const QString file = QFileDialog::getOpenFileName(window(), "Import a height map", {}, "Height maps (*.png *.tga *.pgm)");
                    if (!file.isEmpty()) edits::importPicture(session_, file, false, said);
                });
        connect(button("Export...", "The height map as a grey PNG of 16 bits"), &QPushButton::clicked, this, [this, said] {
            QString file = QFileDialog::getSaveFileName(window(), "Export the height map", "heights.png", "PNG, 16 bits (*.png)");
            if (file.isEmpty()) return;
            if (!file.endsWith(".png", Qt::CaseInsensitive)) file += ".png";
            edits::exportPicture(session_, node_, file, said);
        });
        line->addStretch(1);
        auto* mesh = button("To mesh", "");
        mesh->setToolTip("A mesh of at most " + look::count(meshTriangles) + " triangles that follows the surface, beside the terrain");
        connect(mesh, &QPushButton::clicked, this, [this] { edits::terrainToMesh(session_, node_, meshTriangles); });
        column->addLayout(line);
        return files_;
    }

    void refresh()
    {
        node_ = edits::activeTerrain(session_.document);
        const TerrainObject* object = edits::terrainOf(session_.document, node_);
        empty_->setVisible(!object);
        area_->setVisible(object);
        files_->setVisible(object);
        if (!object) return;
        const Brush& b = session_.view.brush;
        tools_->setExclusive(false);
        for (QAbstractButton* t : tools_->buttons()) t->setChecked(session_.view.tool == ToolKind::Brush && tools_->id(t) == int(b.kind));
        falloffs_->button(int(b.falloff))->setChecked(true);
        falloffName_->setText(names_[int(b.falloff)]);
        brush_->setValues(brushValues());
        const Terrain& t = object->terrain;
        const auto percent = [](double share) { return look::number(percentOf(share)); };
        bands_[0]->setText("above " + percent(t.layers.snowFrom) + " %");
        bands_[1]->setText("steeper than " + look::number(t.layers.rockSlope) + "\u00b0");
        bands_[2]->setText(percent(t.layers.sandTo) + " to " + percent(t.layers.grassTo) + " %");
        bands_[3]->setText("below " + percent(t.layers.sandTo) + " %");
        bands_[4]->setText("below " + look::number(t.waterLevel) + " m");
        layers_->setValues({{"sandTo", percentOf(t.layers.sandTo)},
                            {"grassTo", percentOf(t.layers.grassTo)},
                            {"snowFrom", percentOf(t.layers.snowFrom)},
                            {"rockSlope", t.layers.rockSlope}});
    }

    static constexpr const char* names_[] = {"Smooth", "Linear", "Sphere", "Constant"};
    Session& session_;
    std::shared_ptr<void> subscription_;
    NodeId node_;
    QWidget *empty_ = nullptr, *files_ = nullptr;
    QLabel *sentence_ = nullptr, *falloffName_ = nullptr, *trouble_ = nullptr;
    QPushButton* remedy_ = nullptr;
    QScrollArea* area_ = nullptr;
    QVBoxLayout* box_ = nullptr;
    QButtonGroup *tools_ = nullptr, *falloffs_ = nullptr;
    ParameterForm *brush_ = nullptr, *layers_ = nullptr;
    QLabel* bands_[5] = {};
};

}  // namespace

QWidget* makePainterPanel(Session& session, QWidget* parent)
{
    return new PainterPanel(session, parent);
}

}  // namespace mw
