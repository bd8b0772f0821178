#include "ui/panels/material_section.h"

#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>

#include "core/mesh/select.h"
#include "core/scene/edit.h"
#include "core/scene/materials.h"
#include "ui/look.h"
#include "ui/panels/colour_field.h"
#include "ui/panels/fold.h"
#include "ui/panels/texture_slot.h"
#include "ui/parameter_form.h"
#include "ui/words.h"

namespace mw {
namespace {

constexpr int rowHeight = 26, mostRows = 5;

/// Those of the edit that the form shows; colours have fields of their own.
std::vector<Parameter> formParameters()
{
    std::vector<Parameter> out;
    for (const Parameter& p : editOf("material").parameters)
        if (p.name != "node" && p.name != "slot" && p.name != "color" && p.name != "emissive") out.push_back(p);
    return out;
}

/// How many faces each slot covers; those of slots that do not exist count for the first, as they are drawn.
std::vector<size_t> facesBySlot(const MeshObject& o)
{
    std::vector<size_t> n(std::max<size_t>(1, o.materials.size()), 0);
    const Attribute* a = o.base.find(names::material, Domain::Face);
    if (!a || !a->integral()) {
        n[0] = o.base.faceCount();
        return n;
    }
    for (const int32_t s : a->integers()) ++n[s >= 0 && size_t(s) < n.size() ? size_t(s) : 0];
    return n;
}

}  // namespace

MaterialSection::MaterialSection(Session& session, QWidget* parent) : QWidget(parent), session_(session)
{
    auto* box = new QVBoxLayout(this);
    box->setContentsMargins(0, 0, 0, 0);
    box->setSpacing(6);
    auto* fold = new Fold("Material", "material", true, this);
    box->addWidget(fold);
    makeSlots(fold);
    for (QWidget* w : {static_cast<QWidget*>(none_), static_cast<QWidget*>(slots_)}) fold->inside()->addWidget(w);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    buttons->addWidget(new_);
    buttons->addWidget(assign_);
    buttons->addStretch(1);
    buttons->addWidget(more_);
    fold->inside()->addLayout(buttons);
    fold->inside()->addWidget(sharedRow_);
    fold->inside()->addWidget(error_);
    makeValues();
    fold->inside()->addWidget(values_);
    textures_ = new Fold("Textures", "textures", true, this);
    box->addWidget(textures_);
    for (size_t k = 0; k < pictures_.size(); ++k) {
        pictures_[k] = new TextureSlot(session_, TextureKind(k), textures_);
        textures_->inside()->addWidget(pictures_[k]);
    }
}

void MaterialSection::makeSlots(QWidget* parent)
{
    none_ = new QLabel("No material: the mesh is shown in plain clay.", parent);
    none_->setProperty("secondary", true);
    none_->setWordWrap(true);
    slots_ = new QListWidget(parent);
    slots_->setObjectName("materialSlots");
    slots_->setAccessibleName("Material slots");
    slots_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    slots_->setUniformItemSizes(true);
    slots_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    slots_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(slots_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (filling_ || row < 0) return;
        slot_ = row;
        refresh();
    });
    connect(slots_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        if (filling_) return;
        run({"rename-material", {{"node", node()}, {"slot", int64_t(slots_->row(item))}, {"name", item->text().trimmed().toStdString()}}});
    });
    connect(slots_, &QListWidget::customContextMenuRequested, this, [this] { showMenu(); });
    new_ = new QPushButton("New", parent);
    new_->setToolTip("Add a slot with a material of its own");
    new_->setAccessibleName("New material");
    new_->setFocusPolicy(Qt::TabFocus);
    connect(new_, &QPushButton::clicked, this, [this] { newMaterial(-1); });
    assign_ = new QPushButton("Assign to faces", parent);
    assign_->setObjectName("assignMaterial");
    assign_->setFocusPolicy(Qt::TabFocus);
    connect(assign_, &QPushButton::clicked, this, [this] { assign(); });
    more_ = new QToolButton(parent);
    more_->setIcon(icon("dots", look::tone().text2));
    more_->setFocusPolicy(Qt::TabFocus);
    more_->setAccessibleName("More about materials");
    more_->setToolTip("Duplicate, use another, rename, remove the slot");
    connect(more_, &QToolButton::clicked, this, [this] { showMenu(); });
    sharedRow_ = new QWidget(parent);
    auto* line = new QHBoxLayout(sharedRow_);
    line->setContentsMargins(0, 0, 0, 0);
    shared_ = new QLabel(sharedRow_);
    shared_->setProperty("secondary", true);
    auto* own = new QPushButton("Make own copy", sharedRow_);
    own->setObjectName("ownMaterial");
    own->setFocusPolicy(Qt::TabFocus);
    own->setToolTip("This slot gets a copy; the others keep theirs");
    connect(own, &QPushButton::clicked, this, [this] { run({"own-material", {{"node", node()}, {"slot", slot_}}}); });
    line->addWidget(shared_, 1);
    line->addWidget(own);
    error_ = new QLabel(parent);
    error_->setProperty("bad", true);
    error_->setWordWrap(true);
    error_->hide();
}

void MaterialSection::makeValues()
{
    values_ = new QWidget(this);
    auto* box = new QVBoxLayout(values_);
    box->setContentsMargins(0, 0, 0, 0);
    box->setSpacing(4);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->setColumnMinimumWidth(0, 104);
    grid->setColumnStretch(1, 1);
    box->addLayout(grid);
    const auto field = [&](int row, const QString& title, bool glow, glm::dvec3 MaterialSection::*value) {
        auto* label = new QLabel(title, values_);
        auto* f = new ColourField(title, glow, values_);
        f->setObjectName(glow ? "emissive" : "baseColour");
        label->setBuddy(f);
        grid->addWidget(label, row, 0);
        grid->addWidget(f, row, 1);
        connect(f, &ColourField::edited, this, [this, value](glm::dvec3 c) {
            this->*value = c;
            try {
                session_.document.preview(edited(session_.document.scene(), valuesCall()));
            } catch (const Error&) {
            }  // the node went away; the next notice says so
        });
        connect(f, &ColourField::committed, this, [this, value](glm::dvec3 c) {
            this->*value = c;
            run(valuesCall());
        });
        return f;
    };
    colorField_ = field(0, "Base colour", false, &MaterialSection::color_);
    emissiveField_ = field(1, "Emissive", true, &MaterialSection::emissive_);
    form_ = new ParameterForm(formParameters(), {}, values_);
    form_->setObjectName("materialForm");
    box->addWidget(form_);
    connect(form_, &ParameterForm::edited, this, [this] {
        if (material()) session_.document.preview(edited(session_.document.scene(), valuesCall()));
    });
    connect(form_, &ParameterForm::committed, this, [this] { run(valuesCall()); });
}

const MeshObject* MaterialSection::object() const
{
    const Node* n = session_.document.scene().find(node_);
    return n ? session_.document.scene().find(n->mesh) : nullptr;
}

const Material* MaterialSection::material() const
{
    const MeshObject* o = object();
    return o && slot_ < int64_t(o->materials.size()) ? session_.document.scene().find(o->materials[size_t(slot_)]) : nullptr;
}

std::string MaterialSection::node() const
{
    return nodeText(session_.document.scene(), node_);
}

ParameterValues MaterialSection::valuesOf(const Material& m) const
{
    static const char* const modes[] = {"opaque", "mask", "blend"};
    return {{"metallic", m.metallic},           {"roughness", m.roughness},     {"alpha", std::string(modes[size_t(m.alpha)])},
            {"opacity", m.baseColor.a},         {"cutoff", m.alphaCutoff},      {"normal-scale", m.normalScale},
            {"occlusion", m.occlusionStrength}, {"double-sided", m.doubleSided}};
}

EditCall MaterialSection::valuesCall() const
{
    ParameterValues v = form_->values();
    v["node"] = node();
    v["slot"] = slot_;
    v["color"] = color_;
    v["emissive"] = emissive_;
    return {"material", std::move(v)};
}

void MaterialSection::run(const EditCall& call)
{
    error_->hide();
    try {
        commitEdit(session_.document, call);
    } catch (const Error& e) {
        error_->setText(QString::fromStdString(e.what()));
        error_->show();
    }
    refresh();
}

void MaterialSection::newMaterial(int64_t like)
{
    if (!object()) return;
    const int64_t made = int64_t(object()->materials.size());
    const Material* m = material();
    run({"new-material", {{"node", node()}, {"like", like}, {"name", like >= 0 && m ? m->name : std::string("Material")}}});
    slot_ = made;
    refresh();
}

void MaterialSection::assign()
{
    const Selection& s = session_.document.selection();
    std::string faces;
    if (s.elementsOf == node_ && s.elements.kind == ElementKind::Face) faces = elementText(s.elements);
    run({"assign-material", {{"node", node()}, {"slot", slot_}, {"faces", faces}}});
}

void MaterialSection::setNode(NodeId id)
{
    if (id != node_) slot_ = 0, error_->hide();
    node_ = id;
    refresh();
}

void MaterialSection::fillSlots()
{
    const Scene& scene = session_.document.scene();
    const MeshObject* o = object();
    const std::vector<size_t> faces = o ? facesBySlot(*o) : std::vector<size_t>();
    filling_ = true;
    const size_t n = o ? o->materials.size() : 0;
    while (slots_->count() > int(n)) delete slots_->takeItem(slots_->count() - 1);
    for (size_t i = 0; i < n; ++i) {
        const Material* m = scene.find(o->materials[i]);
        // Kept and rewritten, because this may run while one of them is being renamed.
        QListWidgetItem* item = int(i) < slots_->count() ? slots_->item(int(i)) : new QListWidgetItem(slots_);
        item->setIcon(swatch(m ? glm::dvec3(m->baseColor) : glm::dvec3(0.8), devicePixelRatioF()));
        item->setText(m ? QString::fromStdString(m->name) : QString("None"));
        item->setSizeHint({0, rowHeight});
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setToolTip(QString("%1, slot %2: %3. Double click renames.").arg(item->text()).arg(i).arg(counted(faces[i], "face", "faces")));
    }
    slots_->setCurrentRow(int(slot_));
    slots_->setFixedHeight(rowHeight * std::clamp(slots_->count(), 1, mostRows) + 2 * slots_->frameWidth());
    filling_ = false;
}

void MaterialSection::refresh()
{
    const MeshObject* o = object();
    setVisible(o);
    if (!o) return;
    slot_ = std::clamp<int64_t>(slot_, 0, std::max<int64_t>(0, int64_t(o->materials.size()) - 1));
    fillSlots();
    const Material* m = material();
    const bool any = !o->materials.empty();
    none_->setVisible(!m);
    slots_->setVisible(any);
    assign_->setVisible(any);
    values_->setVisible(m);
    textures_->setVisible(m);
    const Selection& s = session_.document.selection();
    const bool some = s.elementsOf == node_ && s.elements.kind == ElementKind::Face && !s.elements.indices.empty();
    const bool plain = o->stack.empty();
    assign_->setText(some ? "Assign to faces" : "Assign to all");
    assign_->setEnabled(plain || !some);
    assign_->setToolTip(!plain && some ? "The selected faces are those of the result; apply the stack first"
                        : some         ? "The selected faces get this material"
                                       : "All faces get this material; select faces to cover only those");
    const size_t uses = m ? users(session_.document.scene(), o->materials[size_t(slot_)]) : 0;
    sharedRow_->setVisible(uses > 1);
    shared_->setText(counted(uses, "user", "users"));
    shared_->setToolTip("Slots that have this material; a change is seen on all of them");
    if (!m) return;
    color_ = glm::dvec3(m->baseColor);
    emissive_ = m->emissive;
    colorField_->setLinear(color_);
    emissiveField_->setLinear(emissive_);
    form_->setValues(valuesOf(*m));
    for (TextureSlot* t : pictures_) t->show(node_, slot_);
}

void MaterialSection::showMenu()
{
    const Scene& scene = session_.document.scene();
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const bool any = material();
    menu->addAction("Duplicate", this, [this] { newMaterial(slot_); })->setEnabled(any);
    menu->addAction("Rename", this,
                    [this] {
                        if (slots_->currentItem()) slots_->editItem(slots_->currentItem());
                    })
        ->setEnabled(any);
    QMenu* use = menu->addMenu("Use material");
    for (const MaterialId id : scene.materials()) {
        const Material& m = *scene.find(id);
        use->addAction(swatch(glm::dvec3(m.baseColor), devicePixelRatioF()), QString::fromStdString(m.name), this, [this, id] {
            run({"use-material", {{"node", node()}, {"slot", slot_}, {"material", materialText(session_.document.scene(), id)}}});
        });
    }
    use->setEnabled(!scene.materials().empty());
    menu->addSeparator();
    menu->addAction("Remove slot", this, [this] { run({"remove-slot", {{"node", node()}, {"slot", slot_}}}); })->setEnabled(any);
    menu->popup(more_->mapToGlobal(QPoint(0, more_->height())));
}

}  // namespace mw
