#include "ui/panels/terrain.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "core/catalog/entries.h"
#include "core/scene/terrain_values.h"
#include "ui/look.h"
#include "ui/parameter_form.h"
#include "ui/terrain_edits.h"
#include "ui/theme.h"

namespace mw {
namespace {

class TerrainPanel : public QWidget {
public:
    TerrainPanel(Session& session, QWidget* parent) : QWidget(parent), session_(session)
    {
        auto* outer = new QVBoxLayout(this);
        outer->setContentsMargins(0, 0, 0, 0);
        QPushButton* remedy = nullptr;
        empty_ = look::emptyState(this, &sentence_, &remedy);
        sentence_->setText("There is no terrain in this scene.");
        remedy->setText("New terrain");
        remedy->setToolTip("Add a terrain by diamond-square");
        connect(remedy, &QPushButton::clicked, this, [this] { edits::newTerrain(session_); });
        outer->addWidget(empty_);
        area_ = new QScrollArea(this);
        area_->setWidgetResizable(true);
        auto* inside = new QWidget(area_);
        auto* box = new QVBoxLayout(inside);
        box->setContentsMargins(8, 8, 8, 8);
        box->setSpacing(6);
        map_ = new QLabel(inside);
        map_->setObjectName("heightMapLine");
        map_->setWordWrap(true);
        box->addWidget(map_);
        ground_ = new ParameterForm(described<TerrainGround>(), {}, inside);
        ground_->setObjectName("groundForm");
        box->addWidget(ground_);
        auto* title = new QLabel("<b>Level of detail</b>", inside);
        title->setContentsMargins(0, 8, 0, 0);
        box->addWidget(title);
        detail_ = new ParameterForm(described<TerrainDetail>(), {}, inside);
        detail_->setObjectName("detailForm");
        box->addWidget(detail_);
        card_ = new QLabel(inside);
        card_->setObjectName("formulaCard");
        card_->setTextFormat(Qt::RichText);
        card_->setWordWrap(true);
        card_->setStyleSheet(QString("QLabel#formulaCard { background: %1; border: 1px solid %2; border-radius: 4px; padding: 8px; }")
                                 .arg(tokens().field.name(), tokens().border.name()));
        card_->setToolTip("Tessellation level of a patch by the distance d of its centre from the eye (5.1), between the near and the far level");
        box->addWidget(card_);
        box->addStretch(1);
        area_->setWidget(inside);
        look::keepWide(area_);
        outer->addWidget(area_, 1);
        join(ground_, [](Terrain& t, const ParameterValues& v) {
            const auto f = filled<TerrainGround>(v);
            t.extent = f.extent;
            t.maximumHeight = f.maximumHeight;
            t.waterLevel = f.waterLevel;
        });
        join(detail_, [](Terrain& t, const ParameterValues& v) {
            const auto f = filled<TerrainDetail>(v);
            t.detail = {int(f.patches), f.nearLevel, f.farLevel, f.nearDistance, f.farDistance, f.edges == TerrainDetail::Edges::Corrected};
        });
        subscription_ = session_.document.subscribe([this](const Change&) { refresh(); });
        connect(&session_.view, &ViewState::groundChanged, this, [this] { refreshCard(); });
        refresh();
    }

private:
    /// A form's values go into the terrain: shown while they change, one history entry when they are set.
    void join(ParameterForm* form, std::function<void(Terrain&, const ParameterValues&)> put)
    {
        const auto with = [this, put](const ParameterValues& v) {
            Terrain t = edits::terrainOf(session_.document, node_)->terrain;
            put(t, v);
            return t;
        };
        connect(form, &ParameterForm::edited, this, [this, with](const ParameterValues& v) {
            if (edits::terrainOf(session_.document, node_)) edits::previewTerrain(session_.document, node_, with(v));
        });
        connect(form, &ParameterForm::committed, this, [this, with](const ParameterValues& v, const QString& what) {
            if (edits::terrainOf(session_.document, node_)) edits::commitTerrain(session_.document, node_, with(v), what);
        });
    }

    void refresh()
    {
        node_ = edits::activeTerrain(session_.document);
        const TerrainObject* object = edits::terrainOf(session_.document, node_);
        empty_->setVisible(!object);
        area_->setVisible(object);
        if (!object) return;
        const Terrain& t = object->terrain;
        map_->setText(
            QString("<b>Height map</b> &nbsp;<span style='color:%1'>%2, %3 \u00d7 %4</span>")
                .arg(tokens().text2.name(), QString::fromStdString(t.name).toHtmlEscaped(), look::count(t.map.width()), look::count(t.map.height())));
        ground_->setValues(groundValues(t));
        detail_->setValues(detailValues(t.detail));
        refreshCard();
    }

    void refreshCard()
    {
        const QString formula =
            "<table cellspacing=0 cellpadding=0><tr><td style='font-family: serif; font-size: 115%'>"
            "<i>L</i> = <i>L</i><sub>n</sub> + (<i>L</i><sub>f</sub> \u2212 <i>L</i><sub>n</sub>) "
            "(<i>d</i> \u2212 <i>d</i><sub>n</sub>) / (<i>d</i><sub>f</sub> \u2212 <i>d</i><sub>n</sub>)</td></tr></table>";
        const auto& g = session_.view.ground;
        const QString here = g && g->node == node_ ? QString("Under cursor: <i>d</i> %1 m, <i>L</i> %2, %3")
                                                         .arg(look::number(g->distance))
                                                         .arg(g->level)
                                                         .arg(look::counted(g->triangles, "triangle", "triangles"))
                                                   : QString("Point at a patch to see its level.");
        card_->setText(formula + QString("<div style='color:%1'>%2</div>").arg(tokens().text2.name(), here));
    }

    Session& session_;
    std::shared_ptr<void> subscription_;
    NodeId node_;
    QWidget* empty_ = nullptr;
    QLabel *sentence_ = nullptr, *map_ = nullptr, *card_ = nullptr;
    QScrollArea* area_ = nullptr;
    ParameterForm *ground_ = nullptr, *detail_ = nullptr;
};

}  // namespace

QWidget* makeTerrainPanel(Session& session, QWidget* parent)
{
    return new TerrainPanel(session, parent);
}

}  // namespace mw
