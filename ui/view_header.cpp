#include "ui/view_header.h"

#include <QAction>
#include <QComboBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

#include "render/terrain_levels.h"
#include "ui/actions.h"
#include "ui/stack_edits.h"
#include "ui/theme.h"
#include "ui/viewport/viewport.h"
#include "ui/words.h"

namespace mw {
namespace {

QToolButton* buttonOf(QAction* action, QWidget* parent, int size = 28)
{
    auto* b = new QToolButton(parent);
    b->setDefaultAction(action);
    b->setToolButtonStyle(Qt::ToolButtonIconOnly);
    b->setFixedSize(size + 2, size - 2);
    b->setFocusPolicy(Qt::TabFocus);
    b->setAccessibleName(action->text());
    return b;
}

QFrame* bar(QWidget* parent)
{
    auto* line = new QFrame(parent);
    line->setObjectName("divider");
    line->setFixedSize(1, 20);
    return line;
}

QComboBox* colourBy(Session& session, QWidget* parent)
{
    auto* combo = new QComboBox(parent);
    combo->setObjectName("colourBy");
    combo->setAccessibleName("Colour by");
    combo->setMinimumWidth(150);
    combo->setFocusPolicy(Qt::TabFocus);
    combo->addItem("Material", QString());
    for (const Operation& op : catalog())
        if (op.accepts == Kind::Mesh && op.yields == Kind::Table) {
            combo->addItem(QString::fromStdString(op.title), QString::fromStdString(op.id));
            combo->setItemData(combo->count() - 1, QString::fromStdString(op.summary), Qt::ToolTipRole);
        }
    combo->setToolTip("What the colours of meshes say");
    QObject::connect(combo, &QComboBox::currentIndexChanged, combo, [&session, combo] {
        session.view.colourBy = combo->currentData().toString();
        session.view.touch();
    });
    QObject::connect(&session.view, &ViewState::changed, combo, [&session, combo] {
        const QSignalBlocker quiet(combo);
        combo->setCurrentIndex(std::max(0, combo->findData(session.view.colourBy)));
    });
    return combo;
}

/// What is drawn over terrains; away while there is none.
QWidget* groundOverlay(Session& session, QWidget* parent)
{
    auto* holder = new QWidget(parent);
    auto* line = new QHBoxLayout(holder);
    line->setContentsMargins(8, 0, 0, 0);
    line->setSpacing(6);
    line->addWidget(new QLabel("Overlay", holder));
    auto* combo = new QComboBox(holder);
    combo->setObjectName("groundOverlay");
    combo->setAccessibleName("Overlay on terrains");
    combo->setToolTip("What is drawn over the ground: patch borders, their level of detail, or the slope from 0 to 60\u00b0");
    combo->setFocusPolicy(Qt::TabFocus);
    combo->addItems({"None", "Patch borders", "Level of detail", "Slope"});
    line->addWidget(combo);
    QObject::connect(combo, &QComboBox::activated, combo, [&session](int i) {
        session.view.groundOverlay = DrawTerrain::Overlay(i);
        session.view.touch();
    });
    const auto refresh = [&session, holder, combo] {
        holder->setVisible(!session.document.scene().terrains().empty());
        combo->setCurrentIndex(int(session.view.groundOverlay));
    };
    QObject::connect(&session.view, &ViewState::changed, holder, refresh);
    holder->setProperty("token", QVariant::fromValue(session.document.subscribe([refresh](const Change&) { refresh(); })));
    refresh();
    return holder;
}

QComboBox* showWhat(Session& session, QWidget* parent)
{
    auto* combo = new QComboBox(parent);
    combo->setObjectName("showWhat");
    combo->setAccessibleName("Show");
    combo->setFocusPolicy(Qt::TabFocus);
    combo->addItems({"Mesh and bones", "Mesh", "Bones"});
    combo->setToolTip("What is drawn of characters");
    QObject::connect(combo, &QComboBox::activated, combo, [&session](int i) {
        session.view.showMeshes = i != 2;
        session.view.showBones = i != 1;
        session.view.touch();
    });
    const auto refresh = [&session, combo] {
        const QSignalBlocker quiet(combo);
        combo->setCurrentIndex(!session.view.showBones ? 1 : session.view.showMeshes ? 0 : 2);
    };
    QObject::connect(&session.view, &ViewState::changed, combo, refresh);
    refresh();
    return combo;
}

/// A label and its combo, shown or hidden together by the workspace.
QWidget* group(const char* name, const QString& label, QComboBox* combo, QWidget* parent)
{
    auto* g = new QWidget(parent);
    g->setObjectName(name);
    auto* line = new QHBoxLayout(g);
    line->setContentsMargins(0, 0, 8, 0);
    line->addWidget(new QLabel(label, g));
    line->addWidget(combo);
    return g;
}

}  // namespace

QWidget* makeViewHeader(Session& session, Viewport& viewport, Actions& a, QWidget* parent)
{
    auto* header = new QWidget(parent);
    header->setObjectName("viewHeader");
    header->setAttribute(Qt::WA_StyledBackground);
    header->setFixedHeight(34);
    auto* line = new QHBoxLayout(header);
    line->setContentsMargins(8, 0, 8, 0);
    line->setSpacing(2);
    for (QAction* action : a.pickKinds) line->addWidget(buttonOf(action, header));
    line->addSpacing(6);
    line->addWidget(bar(header));
    line->addSpacing(6);
    for (QAction* action : a.shadings) line->addWidget(buttonOf(action, header));
    line->addWidget(buttonOf(a.wireOverlay, header));
    line->addSpacing(6);
    line->addWidget(bar(header));
    line->addSpacing(8);
    line->addWidget(group("colourByGroup", "Colour by", colourBy(session, header), header));
    line->addWidget(group("showGroup", "Show", showWhat(session, header), header));
    line->addWidget(groundOverlay(session, header));
    line->addStretch(1);
    auto* camera = new QComboBox(header);
    camera->setAccessibleName("Camera");
    camera->setFocusPolicy(Qt::TabFocus);
    camera->addItems({"Perspective", "Parallel", "Front", "Right", "Top", "Back", "Left", "Bottom"});
    QObject::connect(camera, &QComboBox::activated, camera, [&session, &viewport, camera](int i) {
        if (i < 2) {
            session.view.camera.perspective = i == 0;
            session.view.touch();
        } else {
            viewport.lookFrom(camera->itemText(i).toLower());
        }
        camera->setCurrentIndex(session.view.camera.perspective ? 0 : 1);
    });
    QObject::connect(&session.view, &ViewState::changed, camera,
                     [&session, camera] { camera->setCurrentIndex(session.view.camera.perspective ? 0 : 1); });
    line->addWidget(camera);
    line->addWidget(buttonOf(a.frameSelection, header));
    line->addWidget(buttonOf(a.picture, header));
    return header;
}

QWidget* makeToolStrip(Actions& a, QWidget* parent)
{
    auto* strip = new QWidget(parent);
    strip->setObjectName("toolStrip");
    strip->setAttribute(Qt::WA_StyledBackground);
    strip->setFixedWidth(38);
    auto* box = new QVBoxLayout(strip);
    box->setContentsMargins(4, 6, 4, 6);
    for (QAction* action : a.tools) {
        auto* b = buttonOf(action, strip, 30);
        b->setFixedSize(30, 30);
        b->setIconSize({20, 20});
        box->addWidget(b);
    }
    box->addStretch(1);
    return strip;
}

QWidget* makeGroundHud(Session& session, Viewport& viewport)
{
    auto* hud = new QFrame(&viewport);
    hud->setObjectName("hud");
    auto* line = new QHBoxLayout(hud);
    line->setContentsMargins(10, 6, 10, 6);
    auto* text = new QLabel(hud);
    text->setObjectName("groundCounts");
    line->addWidget(text);
    const auto refresh = [&session, &viewport, hud, text] {
        const Scene& scene = session.document.scene();
        const bool shown = !scene.terrains().empty() && !session.steps.isOpen();
        hud->setVisible(shown);
        if (!shown) return;
        const Terrain& t = scene.find(scene.terrains().front())->terrain;
        const glm::ivec2 patches = patchesOf(t);
        QString said =
            QString("Triangles <b>%1</b> &nbsp; %2 patches").arg(grouped(viewport.trianglesDrawn()), grouped(size_t(patches.x) * size_t(patches.y)));
        if (const auto& g = session.view.ground) said += QString(" &nbsp; Height at cursor <b>%1 m</b>").arg(g->local.y, 0, 'f', 1);
        if (said == text->text()) return;
        text->setText(said);
        hud->adjustSize();
        hud->move(12, 12);
    };
    for (auto signal : {&ViewState::groundChanged, &ViewState::changed}) QObject::connect(&session.view, signal, hud, refresh);
    QObject::connect(&viewport, &Viewport::painted, hud, refresh, Qt::QueuedConnection);
    refresh();
    return hud;
}

QWidget* makeLevelHud(Session& session, QWidget* parent)
{
    auto* hud = new QFrame(parent);
    hud->setObjectName("hud");
    auto* line = new QHBoxLayout(hud);
    line->setContentsMargins(10, 4, 6, 4);
    auto* eye = new IconLabel("eye", &Tokens::accentText, hud);
    auto* text = new QLabel(hud);
    auto* back = new QPushButton("Show result", hud);
    back->setFocusPolicy(Qt::TabFocus);
    line->addWidget(eye);
    line->addWidget(text);
    line->addWidget(back);
    const auto refresh = [&session, hud, text] {
        const MeshId mesh = edits::activeMesh(session.document);
        const auto level = session.view.shownLevel.find(mesh);
        const MeshObject* object = session.document.scene().find(mesh);
        const bool other = object && level != session.view.shownLevel.end() && level->second < object->stack.size() && !session.steps.isOpen();
        hud->setVisible(other);
        if (!other) return;
        const QString name = level->second == 0 ? "Base mesh" : edits::titleOf(object->stack[level->second - 1]);
        text->setText(QString("Showing <b>%1</b>, level %2 of %3").arg(name.toHtmlEscaped()).arg(level->second).arg(object->stack.size()));
        hud->adjustSize();
        hud->move(12, 12);
    };
    QObject::connect(back, &QPushButton::clicked, hud, [&session] {
        session.view.shownLevel.erase(edits::activeMesh(session.document));
        session.view.touch();
    });
    QObject::connect(&session.view, &ViewState::changed, hud, refresh);
    hud->setProperty("token", QVariant::fromValue(session.document.subscribe([refresh](const Change&) { refresh(); })));
    refresh();
    return hud;
}

}  // namespace mw
