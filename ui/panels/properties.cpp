#include "ui/panels/properties.h"

#include <QScrollArea>
#include <QVBoxLayout>
#include <cmath>

#include "ui/panels/empty_state.h"
#include "ui/parameter_form.h"

namespace mw {
namespace {

// The transform and the material in the words of parameters, so that the same form shows them.
struct TransformForm {
    glm::dvec3 position{0}, rotation{0}, scale{1};
    template <class V>
    void describe(V& v)
    {
        v.point("position", position, {.title = "Position", .help = "Where the node is in its parent, in metres.", .unit = "m"});
        v.point("rotation", rotation, {.title = "Rotation", .help = "Turns about X, then Y, then Z.", .unit = "°"});
        v.point("scale", scale, {.title = "Scale", .help = "Factors along the node's own axes."});
    }
};
struct MaterialForm {
    glm::dvec3 color{0.8};
    double metallic = 0, roughness = 0.6;
    bool doubleSided = false;
    template <class V>
    void describe(V& v)
    {
        v.point("color", color, {.title = "Base colour", .help = "Red, green and blue of the surface, linear.", .min = 0, .max = 1});
        v.number("metallic", metallic, {.title = "Metallic", .help = "0 for plastic and stone, 1 for bare metal.", .min = 0, .max = 1});
        v.number("roughness", roughness, {.title = "Roughness", .help = "0 is a mirror, 1 is chalk.", .min = 0, .max = 1});
        v.flag("doubleSided", doubleSided, {.title = "Both sides", .help = "Draw the back of faces, too."});
    }
};

template <class F>
std::vector<Parameter> described()
{
    Describer d;
    F f;
    f.describe(d);
    return d.parameters;
}

ParameterValues valuesOf(const Transform& t)
{
    return {{"position", t.translation}, {"rotation", glm::degrees(glm::eulerAngles(t.rotation))}, {"scale", t.scale}};
}

class Properties : public QWidget {
public:
    Properties(Session& session, QWidget* parent) : QWidget(parent), session_(session)
    {
        auto* outer = new QVBoxLayout(this);
        outer->setContentsMargins(0, 0, 0, 0);
        auto* area = new QScrollArea(this);
        inside_ = new QWidget(area);
        box_ = new QVBoxLayout(inside_);
        box_->setContentsMargins(8, 8, 8, 8);
        area->setWidget(inside_);
        area->setWidgetResizable(true);
        outer->addWidget(area);
        subscription_ = session_.document.subscribe([this](const Change& c) {
            if (c.aspects & (Aspect::Selection | Aspect::Tree | Aspect::Transform | Aspect::Material | Aspect::File | Aspect::History))
                QMetaObject::invokeMethod(
                    this, [this] { refresh(); }, Qt::QueuedConnection);
        });
        refresh();
    }

private:
    void heading(const QString& text)
    {
        auto* l = new QLabel("<b>" + text.toHtmlEscaped() + "</b>", inside_);
        l->setContentsMargins(0, 6, 0, 2);
        box_->addWidget(l);
    }

    void clear()
    {
        while (QLayoutItem* item = box_->takeAt(0)) {
            if (item->widget()) item->widget()->deleteLater();
            delete item;
        }
        transform_ = material_ = nullptr;
    }

    MaterialId materialOf(NodeId id) const
    {
        const Node* n = session_.document.scene().find(id);
        const MeshObject* o = n ? session_.document.scene().find(n->mesh) : nullptr;
        return o && !o->materials.empty() ? o->materials.front() : MaterialId{};
    }

    ParameterValues materialValues(MaterialId id) const
    {
        const Material* m = session_.document.scene().find(id);
        if (!m) return {};
        return {{"color", glm::dvec3(m->baseColor)}, {"metallic", m->metallic}, {"roughness", m->roughness}, {"doubleSided", m->doubleSided}};
    }

    void refresh()
    {
        const NodeId active = session_.document.selection().active();
        const Node* node = session_.document.scene().find(active);
        const MaterialId material = materialOf(active);
        if (node && active == shown_ && material == shownMaterial_ && transform_) {
            transform_->setValues(valuesOf(node->local));
            if (material_) material_->setValues(materialValues(material));
            return;
        }
        clear();
        shown_ = active;
        shownMaterial_ = material;
        if (!node) {
            box_->addWidget(emptyStateLabel("Select a node to see where it is and what it is made of.", inside_));
            box_->addStretch(1);
            return;
        }
        heading(QString::fromStdString(node->name));
        transform_ = new ParameterForm(described<TransformForm>(), valuesOf(node->local), inside_);
        box_->addWidget(transform_);
        connect(transform_, &ParameterForm::committed, this, [this](const ParameterValues& v, const QString& what) { moveTo(v, what); });
        if (material) {
            heading("Material: " + QString::fromStdString(session_.document.scene().find(material)->name));
            material_ = new ParameterForm(described<MaterialForm>(), materialValues(material), inside_);
            box_->addWidget(material_);
            connect(material_, &ParameterForm::edited, this, [this](const ParameterValues& v) { session_.document.preview(withMaterial(v)); });
            connect(material_, &ParameterForm::committed, this, [this](const ParameterValues& v, const QString& what) {
                session_.document.commit("Material: " + what.toStdString(), withMaterial(v));
            });
        } else if (node->mesh) {
            box_->addWidget(emptyStateLabel("No material: the mesh is shown in plain clay.", inside_));
        }
        box_->addStretch(1);
    }

    void moveTo(const ParameterValues& v, const QString& what)
    {
        Scene next = session_.document.scene();
        Node n = next.node(shown_);
        n.local.translation = std::get<glm::dvec3>(v.at("position"));
        n.local.rotation = glm::dquat(glm::radians(std::get<glm::dvec3>(v.at("rotation"))));
        n.local.scale = std::get<glm::dvec3>(v.at("scale"));
        const std::string name = n.name + ": " + what.toStdString();
        next.set(shown_, std::move(n));
        session_.document.commit(name, std::move(next));
    }

    Scene withMaterial(const ParameterValues& v) const
    {
        Scene next = session_.document.scene();
        Material m = *next.find(shownMaterial_);
        m.baseColor = glm::dvec4(std::get<glm::dvec3>(v.at("color")), m.baseColor.a);
        m.metallic = std::get<double>(v.at("metallic"));
        m.roughness = std::get<double>(v.at("roughness"));
        m.doubleSided = std::get<bool>(v.at("doubleSided"));
        next.set(shownMaterial_, std::move(m));
        return next;
    }

    Session& session_;
    QWidget* inside_;
    QVBoxLayout* box_;
    ParameterForm *transform_ = nullptr, *material_ = nullptr;
    NodeId shown_;
    MaterialId shownMaterial_;
    std::shared_ptr<void> subscription_;
};

}  // namespace

QWidget* makePropertiesPanel(Session& session, QWidget* parent)
{
    return new Properties(session, parent);
}

}  // namespace mw
