// Notes over a view: opaque little widgets, one below another from its top left.
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <algorithm>

#include "render/terrain_levels.h"
#include "ui/evaluation_service.h"
#include "ui/playback.h"
#include "ui/stack_edits.h"
#include "ui/theme.h"
#include "ui/variants.h"
#include "ui/view_header.h"
#include "ui/viewport/measure_tool.h"
#include "ui/viewport/transform_tool.h"
#include "ui/viewport/viewport.h"
#include "ui/words.h"

namespace mw {
namespace {

QFrame* newHud(Viewport& viewport)
{
    auto* hud = new QFrame(&viewport);
    hud->setObjectName("hud");
    hud->hide();
    return hud;
}

void place(Viewport& viewport)
{
    int y = 12;
    for (auto* hud : viewport.findChildren<QFrame*>("hud", Qt::FindDirectChildrenOnly)) {
        if (hud->isHidden()) continue;
        hud->adjustSize();
        hud->move(12, y);
        y += hud->height() + 6;
    }
}

void makeGroundHud(Session& session, Viewport& viewport)
{
    QFrame* hud = newHud(viewport);
    auto* line = new QHBoxLayout(hud);
    line->setContentsMargins(10, 6, 10, 6);
    auto* text = new QLabel(hud);
    text->setObjectName("groundCounts");
    line->addWidget(text);
    const auto refresh = [&session, &viewport, hud, text] {
        const Scene& scene = session.document.scene();
        const bool shown = !scene.terrains().empty() && !session.steps.isOpen();
        if (hud->isHidden() == shown) {
            hud->setVisible(shown);
            place(viewport);
        }
        if (!shown) return;
        const Terrain& t = scene.find(scene.terrains().front())->terrain;
        const glm::ivec2 patches = patchesOf(t);
        QString said =
            QString("Triangles <b>%1</b> &nbsp; %2 patches").arg(grouped(viewport.drawn().triangles), grouped(size_t(patches.x) * size_t(patches.y)));
        if (const auto& g = session.view.ground) said += QString(" &nbsp; Height at cursor <b>%1 m</b>").arg(g->local.y, 0, 'f', 1);
        if (said == text->text()) return;
        text->setText(said);
        place(viewport);
    };
    for (auto signal : {&ViewState::groundChanged, &ViewState::changed}) QObject::connect(&session.view, signal, hud, refresh);
    QObject::connect(&viewport, &Viewport::painted, hud, refresh, Qt::QueuedConnection);
    refresh();
}

/// What the result is compared with: the variant that some view shows.
const Modifier* comparedWith(const Session& session, MeshId mesh)
{
    for (int i = 0; i < session.view.views(); ++i)
        if (showsVariant(session.view.of(i), mesh)) return &session.view.of(i).variant.at(mesh);
    return nullptr;
}

QString variantText(const Session& session, MeshId mesh, const Modifier& variant, const Modifier& last)
{
    QString text = QString("Variant <b>%1</b>").arg(variantName(variant, last).toHtmlEscaped());
    if (!session.evaluations) return text;
    const VariantService::State s = session.evaluations->variants().state(mesh, variant);
    if (s.running) return text + ", computing";
    if (!s.failure.isEmpty()) text += QString(" could not run: %1").arg(s.failure.toHtmlEscaped());
    return text;
}

/// What a view says that does not show the result, or whose result others are compared with; empty: nothing.
QString levelText(const Session& session, const Viewport& viewport, MeshId mesh)
{
    const MeshObject* object = session.document.scene().find(mesh);
    if (!object || object->stack.empty() || session.steps.isOpen()) return {};
    const std::optional<size_t> last = lastModifier(*object);
    const auto& levels = viewport.look().shownLevel;
    const auto level = levels.find(mesh);
    if (last && showsVariant(viewport.look(), mesh)) return variantText(session, mesh, viewport.look().variant.at(mesh), object->stack[*last]);
    if (level != levels.end() && level->second < object->stack.size()) {
        const QString name = level->second == 0 ? "Base mesh" : edits::titleOf(object->stack[level->second - 1]);
        return QString("Showing <b>%1</b>, level %2 of %3").arg(name.toHtmlEscaped()).arg(level->second).arg(object->stack.size());
    }
    const Modifier* other = last ? comparedWith(session, mesh) : nullptr;
    return other ? QString("Result <b>%1</b>").arg(variantName(object->stack[*last], *other).toHtmlEscaped()) : QString();
}

/// In one line when the view is wide enough for it and `beside` more, else in several.
void setFitting(QLabel& label, const QString& text, int beside, const Viewport& viewport)
{
    label.setMinimumWidth(0);  // it would count
    label.setWordWrap(false);
    label.setText(text);
    constexpr int margin = 12, marker = 90;  // the axes at the top right
    const int wide = label.sizeHint().width(), room = std::max(120, viewport.width() - beside - 2 * margin - marker);
    label.setWordWrap(wide > room);
    label.setFixedWidth(std::min(wide, room));
}

void makeLevelHud(Session& session, Viewport& viewport)
{
    QFrame* hud = newHud(viewport);
    auto* line = new QHBoxLayout(hud);
    line->setContentsMargins(10, 4, 6, 4);
    auto* eye = new IconLabel("eye", &Tokens::accentText, hud);
    auto* text = new QLabel(hud);
    text->setObjectName("shownText");
    auto* back = new QPushButton("Show result", hud);
    back->setFocusPolicy(Qt::TabFocus);
    line->addWidget(eye);
    line->addWidget(text);
    line->addWidget(back);
    const auto refresh = [&session, &viewport, hud, text, back] {
        const MeshId mesh = edits::activeMesh(session.document);
        const QString said = levelText(session, viewport, mesh);
        hud->setVisible(!said.isEmpty());
        // The header of one of several views offers it among what it shows.
        back->setVisible(viewport.look().shownLevel.count(mesh) && session.view.views() == 1);
        setFitting(*text, said, 50 + (back->isHidden() ? 0 : back->sizeHint().width()), viewport);
        place(viewport);
    };
    QObject::connect(back, &QPushButton::clicked, hud, [&session, &viewport] {
        session.view.activate(viewport.view());
        session.view.shownLevel.erase(edits::activeMesh(session.document));
        session.view.touch();
    });
    QObject::connect(&session.view, &ViewState::changed, hud, refresh);
    QObject::connect(&viewport, &Viewport::resized, hud, refresh);
    if (session.evaluations) QObject::connect(&session.evaluations->variants(), &VariantService::changed, hud, refresh);
    hud->setProperty("token", QVariant::fromValue(session.document.subscribe([refresh](const Change&) { refresh(); })));
    refresh();
}

void makeMeasureHud(Session& session, Viewport& viewport)
{
    QFrame* hud = newHud(viewport);
    auto* line = new QHBoxLayout(hud);
    line->setContentsMargins(10, 6, 10, 6);
    auto* text = new QLabel(hud);
    text->setObjectName("measured");
    text->setAccessibleName("What is measured");
    line->addWidget(text);
    auto& tool = static_cast<MeasureTool&>(viewport.tool(ToolKind::Measure));
    const auto refresh = [&session, &viewport, &tool, hud, text] {
        const QString said = session.view.tool == ToolKind::Measure && !session.steps.isOpen() ? tool.report() : QString();
        text->setText(said);
        hud->setVisible(!said.isEmpty());
        place(viewport);
    };
    tool.changed = refresh;
    QObject::connect(&session.view, &ViewState::toolChanged, hud, refresh);
}

/// Why there is nothing to drag, and what would help.
void makeToolHud(Session& session, Viewport& viewport)
{
    QFrame* hud = newHud(viewport);
    auto* line = new QHBoxLayout(hud);
    line->setContentsMargins(10, 4, 6, 4);
    auto* text = new QLabel(hud);
    text->setObjectName("whyNoHandles");
    text->setTextFormat(Qt::PlainText);
    auto* help = new QPushButton(hud);
    help->setFocusPolicy(Qt::TabFocus);
    line->addWidget(text);
    line->addWidget(help);
    const auto subject = [&session, &viewport] { return transformSubject(session, viewport.look(), session.view.tool); };
    const auto refresh = [&session, &viewport, hud, text, help, subject] {
        const ToolKind t = session.view.tool;
        const bool moves = t == ToolKind::Move || t == ToolKind::Rotate || t == ToolKind::Scale;
        const TransformSubject s = moves ? subject() : TransformSubject();
        text->setText(s.obstacle);
        help->setVisible(s.remedy != TransformSubject::Remedy::None);
        help->setText(s.remedy == TransformSubject::Remedy::ShowBase ? "Show base" : "Stand at rest");
        hud->setVisible(!s.obstacle.isEmpty());
        place(viewport);
    };
    QObject::connect(help, &QPushButton::clicked, hud, [&session, &viewport, subject] {
        session.view.activate(viewport.view());
        if (subject().remedy == TransformSubject::Remedy::Rest) return session.playback->setClip({});
        const Selection s = session.document.selection();
        session.view.shownLevel[session.document.scene().node(s.elementsOf).mesh] = 0;
        session.document.select({s.nodes, {}, {}});  // those were elements of the result
        session.view.touch();
    });
    // Once after whatever happens in one go: a drag previews many times a second.
    auto* soon = new QTimer(hud);
    soon->setSingleShot(true);
    soon->setInterval(0);
    QObject::connect(soon, &QTimer::timeout, hud, refresh);
    const auto later = [soon] {
        if (!soon->isActive()) soon->start();
    };
    QObject::connect(&session.view, &ViewState::toolChanged, hud, later);
    QObject::connect(&session.view, &ViewState::changed, hud, later);
    QObject::connect(session.playback, &Playback::changed, hud, later);
    hud->setProperty("token", QVariant::fromValue(session.document.subscribe([later](const Change&) { later(); })));
}

}  // namespace

void makeHuds(Session& session, Viewport& viewport)
{
    makeLevelHud(session, viewport);
    if (viewport.view() == 0) makeGroundHud(session, viewport);
    makeMeasureHud(session, viewport);
    makeToolHud(session, viewport);
}

}  // namespace mw
