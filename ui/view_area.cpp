#include "ui/viewport/viewport.h"
// epoxy comes before Qt's own OpenGL headers
#include <QGridLayout>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/evaluation_service.h"
#include "ui/variants.h"
#include "ui/view_area.h"

namespace mw {

ViewArea::ViewArea(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), heats_(std::make_shared<HeatService>(session.jobs)), grid_(new QGridLayout(this))
{
    setObjectName("viewArea");
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setSpacing(1);
    connect(&session_.view, &ViewState::viewsChanged, this, &ViewArea::refresh);
    for (auto signal : {&ViewState::changed, &ViewState::viewsChanged}) connect(&session_.view, signal, this, &ViewArea::keepVariants);
    // Levels and variants are those of meshes of one document: another one's mean nothing.
    subscription_ = session_.document.subscribe([this](const Change& c) {
        if (!(c.aspects & Aspect::File) || session_.document.history().size() != 1) return;
        for (int i = 0; i < session_.view.views(); ++i) {
            if (i != session_.view.activeView()) session_.view.of(i).shownLevel.clear();
            session_.view.of(i).variant.clear();
        }
    });
    add();
    arrange();
}

ViewArea::~ViewArea() = default;

Viewport& ViewArea::active() const
{
    return at(std::min(session_.view.activeView(), count() - 1));
}

void ViewArea::add()
{
    Pane p{new QFrame(this), nullptr, nullptr};
    p.frame->setObjectName("viewPane");
    auto* box = new QVBoxLayout(p.frame);
    box->setContentsMargins(0, 0, 0, 0);
    box->setSpacing(0);
    p.view = new Viewport(session_, heats_, count(), p.frame);
    box->addWidget(p.view, 1);
    p.view->setContextMenu(menu_);
    connect(p.view, &Viewport::hint, this, &ViewArea::hint);
    connect(p.view, &Viewport::failed, this, &ViewArea::failed);
    if (huds_) huds_(*p.view);
    panes_.push_back(p);
}

void ViewArea::split(int count)
{
    count = count >= 4 ? 4 : count >= 2 ? 2 : 1;
    if (count == this->count()) return;
    if (count < this->count()) first().setFocus();
    while (this->count() > count) {  // views go before their settings
        session_.view.activate(0);
        delete panes_.back().frame;
        panes_.pop_back();
    }
    session_.view.setViews(count);
    while (this->count() < count) add();
    arrange();
    refresh();
    active().setFocus();
}

void ViewArea::arrange()
{
    for (Pane& p : panes_) grid_->removeWidget(p.frame);
    for (size_t i = 0; i < panes_.size(); ++i) {
        Pane& p = panes_[i];
        grid_->addWidget(p.frame, int(i) / 2, int(i) % 2);
        if (panes_.size() > 1 && !p.header && header_) {
            p.header = header_(*p.view, p.frame);
            static_cast<QVBoxLayout*>(p.frame->layout())->insertWidget(0, p.header);
        }
        if (p.header) p.header->setVisible(panes_.size() > 1);
        p.frame->show();
    }
    for (int i = 0; i < 2; ++i) {
        grid_->setColumnStretch(i, i == 0 || count() > 1);
        grid_->setRowStretch(i, i == 0 || count() > 2);
    }
}

void ViewArea::refresh()
{
    for (const Pane& p : panes_) {
        if (!p.header) continue;
        p.header->setProperty("active", p.view->view() == session_.view.activeView());
        p.header->update();
    }
}

void ViewArea::compareWithBase(MeshId mesh)
{
    session_.view.linked = true;
    split(2);
    for (int i = 0; i < 2; ++i) {
        auto& levels = session_.view.of(i).shownLevel;
        if (i == 0)
            levels.erase(mesh);
        else
            levels[mesh] = 0;
    }
    session_.view.touch();
}

void ViewArea::keepVariants()
{
    if (!session_.evaluations) return;
    std::vector<std::pair<MeshId, Modifier>> shown;
    for (int i = 0; i < session_.view.views(); ++i)
        for (const auto& [mesh, variant] : session_.view.of(i).variant)
            if (showsVariant(session_.view.of(i), mesh)) shown.emplace_back(mesh, variant);
    session_.evaluations->variants().keep(shown);
}

void ViewArea::compareVariants(MeshId mesh)
{
    const MeshObject* object = session_.document.scene().find(mesh);
    const std::optional<size_t> last = object ? lastModifier(*object) : std::nullopt;
    if (!last) return;
    const std::vector<Modifier> others = variantsOf(object->stack[*last]);
    if (others.empty()) return;
    const ViewSettings look = session_.view;
    session_.view.linked = true;
    split(others.size() == 1 ? 2 : 4);
    for (int i = 0; i < count(); ++i) {
        ViewSettings& view = session_.view.of(i);
        view.colourBy = look.colourBy;
        view.options = look.options;
        view.camera = look.camera;
        view.variant.erase(mesh);
        view.shownLevel.erase(mesh);
        if (i > 0 && size_t(i) <= others.size()) {
            view.variant[mesh] = others[size_t(i) - 1];
            view.shownLevel[mesh] = variantLevel;
        } else if (i > 0) {
            view.shownLevel[mesh] = *last;  // what they all start from
        }
    }
    session_.view.touch();
    QTimer::singleShot(0, this, [this] { first().frameAll(false); });  // the views have their sizes by then
}

void ViewArea::setContextMenu(QMenu* menu)
{
    menu_ = menu;
    for (const Pane& p : panes_) p.view->setContextMenu(menu);
}

void ViewArea::setFurnisher(std::function<QWidget*(Viewport&, QWidget*)> header, std::function<void(Viewport&)> huds)
{
    header_ = std::move(header);
    huds_ = std::move(huds);
    for (const Pane& p : panes_) huds_(*p.view);
}

}  // namespace mw
