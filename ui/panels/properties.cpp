#include "ui/panels/properties.h"

#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/panels/empty_state.h"
#include "ui/parameter_form.h"
#include "ui/playback.h"
#include "ui/theme.h"
#include "ui/words.h"

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

/// Rows between upright lines, three decimals; a number that would show as -0.000 has no sign.
QString matrixText(const QString& title, const glm::dmat4& m)
{
    QString rows;
    for (int r = 0; r < 4; ++r) {
        rows += "<tr>";
        for (int c = 0; c < 4; ++c) {
            const double v = std::abs(m[c][r]) < 5e-4 ? 0 : m[c][r];
            const QString edge = c == 0 ? "border-left: 1px solid %1;" : c == 3 ? "border-right: 1px solid %1;" : "";
            rows += QString("<td align='right' style='padding: 1px 7px; %1'>%2</td>")
                        .arg(edge.isEmpty() ? edge : edge.arg(tokens().text2.name()), QLocale().toString(v, 'f', 3).replace('-', QChar(0x2212)));
        }
        rows += "</tr>";
    }
    return QString("<p style='margin: 6px 0 2px 0; color: %1'>%2</p><table cellspacing='0'>%3</table>").arg(tokens().text2.name(), title, rows);
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
        connect(&session_.view, &ViewState::timeChanged, this, [this] {
            if (isVisible()) showMatrices();
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
        matrices_ = nullptr;
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
            showMatrices();
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
        heading(nodeName(session_.document.scene(), active));
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
        if (node->joint != Node::Joint::No) addMatrices();
        box_->addStretch(1);
    }

    void addMatrices()
    {
        heading("At the playhead");
        matrices_ = new QLabel(inside_);
        matrices_->setObjectName("jointMatrices");
        matrices_->setTextFormat(Qt::RichText);
        matrices_->setTextInteractionFlags(Qt::TextSelectableByMouse);
        matrices_->setToolTip("Matrices act on columns; the last column is the place, in metres.");
        box_->addWidget(matrices_);
        showMatrices();
    }

    /// The joint's own transform, where that puts it, and the offset matrix that brings the mesh into its space (7.7).
    void showMatrices()
    {
        const Scene& scene = session_.document.scene();
        const Node* node = scene.find(shown_);
        if (!matrices_ || !node) return;
        const ScenePose pose = session_.playback ? session_.playback->pose() : ScenePose();
        const auto posed = pose.locals.find(shown_);
        const Transform local = posed == pose.locals.end() ? node->local : posed->second;
        QString text = matrixText("Local: parent from joint", local.matrix());
        text += matrixText("World: world from joint", worldMatrices(scene, pose).at(shown_));
        for (const SkinId id : scene.skins()) {
            const Skin& skin = *scene.find(id);
            const auto at = std::find(skin.joints.begin(), skin.joints.end(), shown_);
            if (at == skin.joints.end()) continue;
            text += matrixText("Offset: joint from mesh, at rest", skin.inverseBind[size_t(at - skin.joints.begin())]);
            break;
        }
        matrices_->setText(text);
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
    QLabel* matrices_ = nullptr;
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
