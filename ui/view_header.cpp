#include "ui/view_header.h"

#include <QAction>
#include <QComboBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <vector>

#include "ui/actions.h"
#include "ui/elided.h"
#include "ui/stack_edits.h"
#include "ui/theme.h"
#include "ui/variant_popup.h"
#include "ui/variants.h"
#include "ui/view_area.h"
#include "ui/viewport/viewport.h"

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

/// Larger text makes the line higher.
int headerHeight(const QWidget* header)
{
    return std::max(34, header->fontMetrics().height() + 12);
}

QFrame* bar(QWidget* parent)
{
    auto* line = new QFrame(parent);
    line->setObjectName("divider");
    line->setFixedSize(1, 20);
    return line;
}

QComboBox* colourBy(Session& session, Viewport& view, QWidget* parent)
{
    auto* combo = new ElidedComboBox(parent);
    combo->setObjectName("colourBy");
    combo->setAccessibleName("Colour by");
    combo->setFocusPolicy(Qt::TabFocus);
    combo->addItem("Material", QString());
    for (const Operation& op : catalog())
        if (op.accepts == Kind::Mesh && op.yields == Kind::Table) {
            // One that compares with another mesh is asked about the base.
            combo->addItem(QString::fromStdString(op.title).replace("another mesh", "the base mesh"), QString::fromStdString(op.id));
            combo->setItemData(combo->count() - 1, QString::fromStdString(op.summary), Qt::ToolTipRole);
        }
    combo->setToolTip("What the colours of meshes say");
    QObject::connect(combo, &QComboBox::currentIndexChanged, combo, [&session, &view, combo] {
        const QString chosen = combo->currentData().toString();
        session.view.activate(view.view());
        view.look().colourBy = chosen;
        session.view.touch();
    });
    const auto refresh = [&view, combo] {
        const QSignalBlocker quiet(combo);
        combo->setCurrentIndex(std::max(0, combo->findData(view.look().colourBy)));
    };
    QObject::connect(&session.view, &ViewState::changed, combo, refresh);
    refresh();
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
    auto* combo = new ElidedComboBox(holder);
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
    auto* combo = new ElidedComboBox(parent);
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
    line->setSpacing(6);
    line->addWidget(new QLabel(label, g));
    line->addWidget(combo);
    return g;
}

/// Leaves away what there is no room for, while it is shown otherwise.
QWidget* slot(QWidget* inside, QWidget* parent)
{
    auto* s = new QWidget(parent);
    auto* line = new QHBoxLayout(s);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(inside);
    return s;
}

/// Shading and wires of one view; the buttons look like those of the actions, which serve the active one.
void addShading(QHBoxLayout* line, Session& session, Viewport& view, Actions& a, QWidget* parent)
{
    const auto button = [&](QAction* like, const QString& name, auto isOn, auto choose) {
        auto* b = new QToolButton(parent);
        b->setObjectName(name);
        b->setIcon(like->icon());
        b->setToolTip(like->toolTip());
        b->setAccessibleName(like->text());
        b->setCheckable(true);
        b->setFixedSize(30, 26);
        b->setFocusPolicy(Qt::TabFocus);
        QObject::connect(like, &QAction::changed, b, [b, like] {
            b->setIcon(like->icon());
            b->setToolTip(like->toolTip());
        });
        QObject::connect(b, &QToolButton::clicked, b, [&session, &view, choose] {
            session.view.activate(view.view());
            choose(view.look().options);
            session.view.touch();
        });
        const auto refresh = [b, &view, isOn] { b->setChecked(isOn(view.look().options)); };
        QObject::connect(&session.view, &ViewState::changed, b, refresh);
        refresh();
        line->addWidget(b);
    };
    for (int i = 0; i < a.shadings.size(); ++i)
        button(
            a.shadings[i], "shade" + a.shadings[i]->text(), [i](const ViewOptions& o) { return int(o.shading) == i; },
            [i](ViewOptions& o) { o.shading = Shading(i); });
    button(
        a.wireOverlay, "shadeOverlay", [](const ViewOptions& o) { return o.wireOverlay; }, [](ViewOptions& o) { o.wireOverlay = !o.wireOverlay; });
}

QComboBox* cameraOf(Session& session, Viewport& view, QWidget* parent)
{
    auto* camera = new ElidedComboBox(parent);
    camera->setAccessibleName("Camera");
    camera->setToolTip("Projection, or where to look from");
    camera->setFocusPolicy(Qt::TabFocus);
    camera->addItems({"Perspective", "Parallel", "Front", "Right", "Top", "Back", "Left", "Bottom"});
    QObject::connect(camera, &QComboBox::activated, camera, [&session, &view, camera](int i) {
        session.view.activate(view.view());
        if (i < 2) {
            view.look().camera.perspective = i == 0;
            session.view.touch();
        } else {
            view.lookFrom(camera->itemText(i).toLower());
        }
        camera->setCurrentIndex(view.look().camera.perspective ? 0 : 1);
    });
    const auto refresh = [&view, camera] { camera->setCurrentIndex(view.look().camera.perspective ? 0 : 1); };
    QObject::connect(&session.view, &ViewState::changed, camera, refresh);
    refresh();
    return camera;
}

constexpr int resultItem = -1, variantItem = -2, chooseItem = -3;  // beside levels, 0 the base

/// What a view can show of a mesh, as words and what they stand for.
std::vector<std::pair<QString, int>> shownChoices(const MeshObject* object, const Modifier* variant)
{
    std::vector<std::pair<QString, int>> out{{"Base mesh", 0}};
    if (!object || object->stack.empty()) return out;
    for (size_t i = 0; i + 1 < object->stack.size(); ++i)
        out.emplace_back(QString("%1 %2").arg(i + 1).arg(edits::titleOf(object->stack[i])), int(i + 1));
    out.emplace_back("Result", resultItem);
    const std::optional<size_t> last = lastModifier(*object);
    if (!last) return out;
    if (variant) out.emplace_back(variantName(*variant, object->stack[*last]), variantItem);
    out.emplace_back("Variant...", chooseItem);
    return out;
}

int shownItem(const ViewSettings& look, MeshId mesh)
{
    const auto level = look.shownLevel.find(mesh);
    if (level == look.shownLevel.end()) return resultItem;
    return level->second == variantLevel ? variantItem : int(level->second);
}

void showChoice(Session& session, Viewport& view, int choice)
{
    const MeshId mesh = edits::activeMesh(session.document);
    session.view.activate(view.view());
    if (choice == chooseItem)
        showVariantPopup(session, view, mesh);
    else if (choice == resultItem)
        view.look().shownLevel.erase(mesh);
    else
        view.look().shownLevel[mesh] = choice == variantItem ? variantLevel : size_t(choice);
    session.view.touch();
}

/// Which level of the active mesh this view shows, or what in place of its last modifier.
QComboBox* levelOf(Session& session, Viewport& view, QWidget* parent)
{
    auto* combo = new ElidedComboBox(parent);
    combo->setObjectName("shownLevel");
    combo->setAccessibleName("Shows");
    combo->setToolTip("What this view shows of the active mesh: its base, a level between, the result, or a variant of the last modifier");
    combo->setFocusPolicy(Qt::TabFocus);
    const auto refresh = [&session, &view, combo] {
        const QSignalBlocker quiet(combo);
        const MeshId mesh = edits::activeMesh(session.document);
        const MeshObject* object = session.document.scene().find(mesh);
        const auto variant = view.look().variant.find(mesh);
        const auto choices = shownChoices(object, variant == view.look().variant.end() ? nullptr : &variant->second);
        QStringList wanted, now;
        for (const auto& [text, item] : choices) wanted << text;
        for (int i = 0; i < combo->count(); ++i) now << combo->itemText(i);
        if (now != wanted) combo->clear();
        for (const auto& [text, item] : choices)
            if (now != wanted) combo->addItem(text, item);
        const int at = combo->findData(shownItem(view.look(), mesh));
        combo->setCurrentIndex(at >= 0 ? at : std::max(0, combo->findData(resultItem)));
        combo->setEnabled(object && !object->stack.empty());
    };
    QObject::connect(combo, &QComboBox::activated, combo, [&session, &view, combo, refresh](int i) {
        showChoice(session, view, combo->itemData(i).toInt());
        refresh();  // "Variant..." itself is never what is shown
    });
    QObject::connect(&session.view, &ViewState::changed, combo, refresh);
    combo->setProperty("token", QVariant::fromValue(session.document.subscribe([refresh](const Change&) { refresh(); })));
    refresh();
    return combo;
}

/// What one view has for itself, in the header while there is only one.
QWidget* viewControls(Session& session, Viewport& view, Actions& a, QWidget* parent)
{
    auto* controls = new QWidget(parent);
    auto* line = new QHBoxLayout(controls);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(2);
    auto* shading = new QWidget(controls);
    shading->setObjectName("shadingGroup");
    auto* buttons = new QHBoxLayout(shading);
    buttons->setContentsMargins(0, 0, 0, 0);
    buttons->setSpacing(2);
    addShading(buttons, session, view, a, shading);
    buttons->addSpacing(6);
    buttons->addWidget(bar(shading));
    buttons->addSpacing(8);
    line->addWidget(shading);
    line->addWidget(group("colourByGroup", "Colour by", colourBy(session, view, controls), controls));
    return controls;
}

/// Axes and pivot of the handles, while a tool that has some is in hand.
QWidget* handleControls(Session& session, Actions& a, QWidget* parent)
{
    auto* holder = new QWidget(parent);
    holder->setObjectName("handleControls");
    auto* line = new QHBoxLayout(holder);
    line->setContentsMargins(8, 0, 0, 0);
    line->setSpacing(4);
    const struct {
        QAction* action;
        const char *off, *on;
    } both[] = {{a.localAxes, "World axes", "Local axes"}, {a.pivotCentre, "Own origins", "Middle"}};
    for (const auto& one : both) {
        auto* b = new QToolButton(holder);
        b->setFocusPolicy(Qt::TabFocus);
        b->setToolTip(one.action->toolTip());
        b->setAccessibleName(one.action->text());
        int widest = 0;
        for (const char* text : {one.off, one.on}) {
            b->setText(text);
            widest = std::max(widest, b->sizeHint().width());
        }
        b->setMinimumWidth(widest);
        QObject::connect(b, &QToolButton::clicked, one.action, &QAction::trigger);
        const auto refresh = [b, one] { b->setText(one.action->isChecked() ? one.on : one.off); };
        QObject::connect(one.action, &QAction::changed, b, refresh);
        refresh();
        line->addWidget(b);
    }
    const auto refresh = [&session, holder] {
        const ToolKind t = session.view.tool;
        holder->setVisible(t == ToolKind::Move || t == ToolKind::Rotate || t == ToolKind::Scale);
    };
    QObject::connect(&session.view, &ViewState::toolChanged, holder, refresh);
    refresh();
    return holder;
}

/// The line above the views. Where there is no room for all, its boxes become narrow first; then labels leave, which the tooltips say as well,
/// and what the menus have, too.
class ViewHeader : public QWidget {
public:
    using QWidget::QWidget;
    std::vector<QWidget*> leaves;  ///< in this order

    QSize minimumSizeHint() const override
    {
        QSize size = QWidget::minimumSizeHint();
        for (const QWidget* w : leaves)
            if (!w->isHidden()) size.rwidth() -= roomOf(w);
        return size;
    }

protected:
    void resizeEvent(QResizeEvent* e) override
    {
        QWidget::resizeEvent(e);
        fit();
    }
    bool event(QEvent* e) override
    {
        const bool handled = QWidget::event(e);
        if (e->type() == QEvent::LayoutRequest) fit();
        return handled;
    }

private:
    int roomOf(const QWidget* w) const
    {
        for (const QWidget* p = w->parentWidget(); p != this; p = p->parentWidget())
            if (p->isHidden()) return 0;
        return w->minimumSizeHint().width() + w->parentWidget()->layout()->spacing();
    }
    void fit()
    {
        int needed = layout()->minimumSize().width();
        for (const QWidget* w : leaves)
            if (w->isHidden()) needed += roomOf(w);
        for (QWidget* w : leaves) {
            const bool stays = needed <= width();
            if (!stays) needed -= roomOf(w);
            if (w->isHidden() != stays) continue;
            w->setVisible(stays);
            for (QWidget* p = w->parentWidget(); p != this; p = p->parentWidget()) p->layout()->activate();
        }
    }
};

/// Two pixels of accent under the header of the active view. A narrow one leaves to the menus what else there is: the camera, then the shading.
class PaneHeader : public QFrame {
public:
    using QFrame::QFrame;
    QWidget *shading = nullptr, *camera = nullptr;

protected:
    void resizeEvent(QResizeEvent* e) override
    {
        QFrame::resizeEvent(e);
        camera->setVisible(width() >= 600);
        shading->setVisible(width() >= 440);
        layout()->activate();  // it was laid out before they came or went, and would keep their room
    }
    void paintEvent(QPaintEvent* e) override
    {
        QFrame::paintEvent(e);
        QPainter p(this);
        p.fillRect(0, height() - 2, width(), 2, property("active").toBool() ? tokens().accentText : tokens().border);
    }
};

}  // namespace

QWidget* makeViewHeader(Session& session, ViewArea& views, Actions& a, QWidget* parent)
{
    auto* header = new ViewHeader(parent);
    header->setObjectName("viewHeader");
    header->setAttribute(Qt::WA_StyledBackground);
    header->setFixedHeight(headerHeight(header));
    auto* line = new QHBoxLayout(header);
    line->setContentsMargins(8, 0, 8, 0);
    line->setSpacing(2);
    for (QAction* action : a.pickKinds) line->addWidget(buttonOf(action, header));
    line->addSpacing(6);
    line->addWidget(bar(header));
    line->addSpacing(6);
    QWidget* controls = viewControls(session, views.first(), a, header);
    QWidget* camera = cameraOf(session, views.first(), header);
    QWidget* frame = buttonOf(a.frameSelection, header);
    QWidget* link = buttonOf(a.linkCameras, header);
    line->addWidget(controls);
    QWidget* show = group("showGroup", "Show", showWhat(session, header), header);
    QWidget* overlay = groundOverlay(session, header);
    QWidget* handles = slot(handleControls(session, a, header), header);
    QWidget* cameraSlot = slot(camera, header);
    for (QWidget* w : {show, overlay, handles}) line->addWidget(w);
    line->addStretch(1);
    for (QWidget* w : {cameraSlot, frame, link}) line->addWidget(w);
    for (QWidget* g : {controls, show, overlay})
        for (QWidget* label : g->findChildren<QLabel*>()) header->leaves.push_back(label);
    for (QWidget* w : {cameraSlot, controls->findChild<QWidget*>("shadingGroup"), handles}) header->leaves.push_back(w);
    line->addWidget(buttonOf(a.split, header));
    line->addWidget(buttonOf(a.picture, header));
    const auto refresh = [&session, controls, camera, link] {
        const bool one = session.view.views() == 1;
        for (QWidget* w : {controls, camera}) w->setVisible(one);
        link->setVisible(!one);
    };
    QObject::connect(&session.view, &ViewState::viewsChanged, header, refresh);
    refresh();
    return header;
}

QWidget* makePaneHeader(Session& session, ViewArea& views, Viewport& view, Actions& a, QWidget* parent)
{
    auto* header = new PaneHeader(parent);
    header->setObjectName("viewHeader");
    header->setAttribute(Qt::WA_StyledBackground);
    header->setFixedHeight(headerHeight(header));
    auto* line = new QHBoxLayout(header);
    line->setContentsMargins(6, 0, 6, 2);
    line->setSpacing(2);
    header->shading = new QWidget(header);
    auto* shading = new QHBoxLayout(header->shading);
    shading->setContentsMargins(0, 0, 4, 0);
    shading->setSpacing(2);
    addShading(shading, session, view, a, header->shading);
    line->addWidget(header->shading);
    QComboBox* camera = cameraOf(session, view, header);
    header->camera = camera;
    const std::pair<QComboBox*, int> combos[] = {{colourBy(session, view, header), 8}, {levelOf(session, view, header), 10}, {camera, 12}};
    for (const auto& [combo, share] : combos) {
        combo->setMinimumWidth(60);
        combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        combo->setMinimumContentsLength(4);
        combo->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        combo->setMaximumWidth(170);
        line->addWidget(combo, share);
    }
    line->addStretch(1);
    auto* close = new QToolButton(header);
    close->setIcon(icon("x", tokens().text2));
    close->setToolTip("Back to one view");
    close->setAccessibleName("Close split");
    // Later: the button is a part of what goes.
    QObject::connect(
        close, &QToolButton::clicked, &views, [&views] { views.split(1); }, Qt::QueuedConnection);
    close->setProperty("small", true);
    close->setFixedSize(24, 26);
    close->setFocusPolicy(Qt::TabFocus);
    line->addWidget(close);
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
        b->setProperty("small", true);
        b->setFixedSize(30, 30);
        b->setIconSize({20, 20});
        box->addWidget(b);
    }
    box->addStretch(1);
    return strip;
}

}  // namespace mw
