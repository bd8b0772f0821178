#include "ui/workspaces.h"

#include <QDockWidget>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QResizeEvent>
#include <QSettings>
#include <QTimer>
#include <QToolButton>
#include <algorithm>

#include "ui/panel.h"
#include "ui/theme.h"

namespace mw {
namespace {

constexpr int layoutVersion = 5;
constexpr int narrowBelow = 1400;  // logical pixels; there docks share cells

struct Cell {
    Qt::DockWidgetArea area;
    QStringList tabs;  // the first one is in front
    int height;        // 0: takes the rest
    int width;
};

// The table of ui/UI.md 1; panels that do not exist are passed over.
QList<Cell> cellsOf(const QString& workspace, bool narrow)
{
    const auto left = Qt::LeftDockWidgetArea, right = Qt::RightDockWidgetArea, bottom = Qt::BottomDockWidgetArea;
    if (workspace == "Learn") {
        if (narrow)
            return {{left, {"lessons", "outliner", "lesson-text"}, 0, 276},
                    {right, {"step-player", "records", "lab", "inspector"}, 0, 340},
                    {bottom, {"source", "plot"}, 200, 0}};
        return {{left, {"lessons", "outliner"}, 456, 292},
                {left, {"lesson-text"}, 0, 292},
                {right, {"step-player", "records", "lab", "inspector"}, 0, 392},
                {bottom, {"source"}, 250, 0},
                {bottom, {"plot"}, 250, 368}};
    }
    if (workspace == "Character")
        return {{left, {"outliner", "history"}, 0, 236},
                {right, {"retarget", "properties"}, 0, narrow ? 336 : 430},
                {bottom, {"timeline", "plot"}, narrow ? 220 : 266, 0}};
    if (workspace == "Terrain") {
        if (narrow)
            return {
                {left, {"painter", "outliner"}, 0, 276}, {right, {"terrain", "properties"}, 430, 322}, {right, {"generators", "history"}, 0, 322}};
        return {{left, {"painter", "outliner"}, 0, 300}, {right, {"terrain", "properties"}, 462, 322}, {right, {"generators", "history"}, 0, 322}};
    }
    if (narrow)
        return {{left, {"outliner", "history"}, 200, 276},
                {left, {"inspector", "records", "uv"}, 0, 276},
                {right, {"modifiers", "properties", "jobs"}, 0, 336}};
    return {{left, {"outliner"}, 214, 304},
            {left, {"inspector", "records", "uv"}, 0, 304},
            {right, {"modifiers", "properties"}, 0, 356},
            {right, {"history", "jobs"}, 176, 356}};
}

QWidget* titleBar(QDockWidget* dock)
{
    auto* bar = new QWidget(dock);
    bar->setObjectName("dockTitle");
    bar->setAttribute(Qt::WA_StyledBackground);
    bar->setFixedHeight(std::max(28, bar->fontMetrics().height() + 8));
    auto* line = new QHBoxLayout(bar);
    line->setContentsMargins(10, 0, 4, 0);
    line->addWidget(new QLabel("<b>" + dock->windowTitle() + "</b>", bar), 1);
    auto* menu = new QToolButton(bar);
    menu->setIcon(icon("dots", tokens().text2));
    menu->setAccessibleName("Menu of " + dock->windowTitle());
    menu->setToolTip("Float or close this panel");
    menu->setFocusPolicy(Qt::TabFocus);
    QObject::connect(menu, &QToolButton::clicked, dock, [dock, menu] {
        auto* m = new QMenu(dock);
        m->setAttribute(Qt::WA_DeleteOnClose);
        if (dock->features() & QDockWidget::DockWidgetFloatable)
            m->addAction(dock->isFloating() ? "Dock" : "Float", dock, [dock] { dock->setFloating(!dock->isFloating()); });
        m->addAction("Close", dock, &QDockWidget::close);
        m->popup(menu->mapToGlobal(QPoint(0, menu->height())));
    });
    line->addWidget(menu);
    return bar;
}

}  // namespace

Workspaces::Workspaces(Session& session, QMainWindow* window) : QObject(window), session_(session), window_(window)
{
    // There a floating dock cannot be docked again by dragging (Qt 6.4).
    floats_ = !QGuiApplication::platformName().startsWith("wayland");
    window_->installEventFilter(this);
    window_->setDockNestingEnabled(true);
    window_->setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    window_->setDocumentMode(true);
    for (auto [corner, area] : {std::pair{Qt::TopLeftCorner, Qt::LeftDockWidgetArea},
                                {Qt::BottomLeftCorner, Qt::LeftDockWidgetArea},
                                {Qt::TopRightCorner, Qt::RightDockWidgetArea},
                                {Qt::BottomRightCorner, Qt::RightDockWidgetArea}})
        window_->setCorner(corner, area);
    for (const PanelEntry& p : panels()) makeDock(p);
}

void Workspaces::makeDock(const PanelEntry& p)
{
    auto* dock = new QDockWidget(p.title, window_);
    dock->setObjectName("dock-" + p.id);
    dock->setMinimumWidth(236);
    dock->toggleViewAction()->setToolTip(p.tip);
    dock->setTitleBarWidget(titleBar(dock));
    // A panel is made when it is first seen: what is never looked at costs nothing.
    if (!floats_) dock->setFeatures(dock->features() & ~QDockWidget::DockWidgetFloatable);
    connect(dock, &QDockWidget::visibilityChanged, this, [this, dock](bool visible) {
        if (visible && !dock->widget()) fillDock(dock);
    });
    for (auto signal : {&QDockWidget::visibilityChanged, &QDockWidget::topLevelChanged})
        connect(dock, signal, this, [this] { QTimer::singleShot(0, this, [this] { retitle(); }); });
    docks_[p.id] = dock;
    window_->addDockWidget(Qt::LeftDockWidgetArea, dock);
    dock->hide();
}

void Workspaces::fillDock(QDockWidget* dock)
{
    for (const PanelEntry& p : panels())
        if (docks_.value(p.id) == dock) dock->setWidget(p.make(session_, dock));
}

void Workspaces::remakePanels()
{
    for (QDockWidget* d : docks_) {
        if (!d->widget()) continue;
        delete d->widget();
        if (d->isVisible()) fillDock(d);
    }
}

void Workspaces::retitle()
{
    for (QDockWidget* d : docks_) {
        const bool tabbed = !d->isFloating() && !window_->tabifiedDockWidgets(d).isEmpty();
        QWidget* bar = d->titleBarWidget();
        if (bar && bar->property("empty").toBool() != tabbed) {
            auto* next = tabbed ? new QWidget(d) : titleBar(d);
            next->setProperty("empty", tabbed);
            if (tabbed) next->setFixedHeight(0);
            d->setTitleBarWidget(next);
            bar->deleteLater();
        }
    }
}

void Workspaces::build(const QString& name)
{
    for (QDockWidget* d : docks_) {
        d->setFloating(false);
        window_->removeDockWidget(d);
    }
    // Bottom corners belong to the side docks, in Character to the bottom dock.
    const bool wide = name == "Character";
    window_->setCorner(Qt::BottomLeftCorner, wide ? Qt::BottomDockWidgetArea : Qt::LeftDockWidgetArea);
    window_->setCorner(Qt::BottomRightCorner, wide ? Qt::BottomDockWidgetArea : Qt::RightDockWidgetArea);
    QList<QDockWidget*> columns, rows;
    QList<int> widths, heights;
    QList<QDockWidget*> fronts;
    const QList<Cell> cells = cellsOf(name, window_->width() < narrowBelow);
    // What is left of a column: Qt shares heights out in proportion, so the sum has to be the column's.
    const auto rest = [&](Qt::DockWidgetArea area) {
        int height = window_->height() - 96;  // menus, toolbar, status bar
        for (const Cell& c : cells)
            if (c.area == area) height -= c.height;
        return std::max(100, height);
    };
    for (const Cell& c : cells) {
        QDockWidget* front = nullptr;
        for (const QString& id : c.tabs) {
            QDockWidget* d = docks_.value(id);
            if (!d) continue;
            if (front)
                window_->tabifyDockWidget(front, d);
            else
                window_->addDockWidget(c.area, d, c.area == Qt::BottomDockWidgetArea ? Qt::Horizontal : Qt::Vertical);
            d->show();
            if (!front) front = d;
        }
        if (!front) continue;
        fronts << front;
        if (c.width) columns << front, widths << c.width;
        rows << front, heights << (c.height ? c.height : rest(c.area));
    }
    window_->resizeDocks(columns, widths, Qt::Horizontal);
    window_->resizeDocks(rows, heights, Qt::Vertical);
    for (QDockWidget* d : fronts) d->raise();
    // The others get a place, too, for whoever asks for them: a layout says nothing of docks that stand nowhere.
    for (QDockWidget* d : docks_) {
        if (window_->dockWidgetArea(d) != Qt::NoDockWidgetArea) continue;
        window_->addDockWidget(Qt::RightDockWidgetArea, d);
        d->hide();
    }
}

QStringList Workspaces::all() const
{
    return names() + QSettings().value("workspaces/own").toStringList();
}

QString Workspaces::kind() const
{
    return names().contains(current_) ? current_ : QSettings().value("workspaces/kind/" + current_, "Mesh").toString();
}

QString Workspaces::key() const
{
    return "layout/" + current_ + (narrow_ ? "/narrow" : "/wide");
}

void Workspaces::restore()
{
    for (QDockWidget* d : docks_) d->hide();  // a saved layout says nothing of docks that were in none
    const QByteArray state = QSettings().value(key()).toByteArray();
    if (state.isEmpty() || !window_->restoreState(state, layoutVersion)) build(kind());
    QTimer::singleShot(0, this, [this] { retitle(); });
}

void Workspaces::change(const QString& name)
{
    if (name == current_ || !all().contains(name)) return;
    if (!current_.isEmpty()) store();
    current_ = name;
    narrow_ = window_->width() < narrowBelow;
    restore();
    emit changed();
}

void Workspaces::reset()
{
    build(kind());
    QTimer::singleShot(0, this, [this] { retitle(); });
}

void Workspaces::store()
{
    if (beforeHiding_.isEmpty()) QSettings().setValue(key(), window_->saveState(layoutVersion));
}

bool Workspaces::saveAs(const QString& name, QString* whyNot)
{
    const QString plain = name.simplified();
    if (plain.isEmpty() || all().contains(plain, Qt::CaseInsensitive) || plain.contains('/')) {
        *whyNot = plain.isEmpty()       ? "Give it a name."
                  : plain.contains('/') ? "A name has no slash."
                                        : plain + " is there already. Choose another name.";
        return false;
    }
    const QString from = kind();
    QSettings().setValue("workspaces/own", QSettings().value("workspaces/own").toStringList() << plain);
    QSettings().setValue("workspaces/kind/" + plain, from);
    store();
    current_ = plain;
    store();
    emit listChanged();
    emit changed();
    return true;
}

void Workspaces::remove(const QString& name)
{
    if (names().contains(name)) return;
    if (current_ == name) change(kind());
    QStringList own = QSettings().value("workspaces/own").toStringList();
    own.removeAll(name);
    QSettings().setValue("workspaces/own", own);
    for (const char* k : {"workspaces/kind/", "layout/"}) QSettings().remove(k + name);
    emit listChanged();
}

// A window that becomes narrow, or wide again, has the layout for that.
bool Workspaces::eventFilter(QObject* o, QEvent* e)
{
    if (o == window_ && e->type() == QEvent::Resize && !current_.isEmpty() && window_->isVisible()) {
        const auto* size = static_cast<QResizeEvent*>(e);
        const bool narrow = size->size().width() < narrowBelow;
        if (narrow != narrow_) {
            narrow_ = narrow;
            QTimer::singleShot(0, this, [this] { restore(); });
        }
    }
    return QObject::eventFilter(o, e);
}

void Workspaces::toggleAll()
{
    if (!beforeHiding_.isEmpty()) {
        window_->restoreState(std::exchange(beforeHiding_, {}), layoutVersion);
        return;
    }
    beforeHiding_ = window_->saveState(layoutVersion);
    for (QDockWidget* d : docks_) d->hide();
}

void Workspaces::show(const QString& id)
{
    if (QDockWidget* d = docks_.value(id)) {
        d->show();
        d->raise();
    }
}

void Workspaces::fillMenu(QMenu* menu) const
{
    for (const PanelEntry& p : panels()) menu->addAction(docks_[p.id]->toggleViewAction());
}

}  // namespace mw
