#include "ui/panels/properties.h"

#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/scene/scene_pose.h"
#include "ui/look.h"
#include "ui/panels/empty_state.h"
#include "ui/panels/fold.h"
#include "ui/panels/material_section.h"
#include "ui/panels/matrix_product.h"
#include "ui/panels/transform_fields.h"
#include "ui/panels/view_section.h"
#include "ui/playback.h"
#include "ui/viewport/frame_builder.h"
#include "ui/words.h"

namespace mw {
namespace {

Bounds placed(const Mesh& mesh, const glm::dmat4& world)
{
    Bounds b;
    for (const glm::vec3& p : mesh.positions()) b.add(glm::dvec3(world * glm::dvec4(p, 1)));
    return b;
}

/// Size and centre of the box around the shown meshes, in their own axes and in the world.
class BoundsNumbers : public QWidget {
public:
    BoundsNumbers(Session& session, QWidget* parent) : QWidget(parent), session_(session)
    {
        auto* grid = new QGridLayout(this);
        grid->setContentsMargins(0, 0, 0, 0);
        grid->setHorizontalSpacing(4);
        grid->setVerticalSpacing(2);
        static const char* const titles[] = {"Size", "Centre"};
        static const char* const tips[2][2] = {{"Of the box along the mesh's own axes", "Its middle, in the mesh's own space"},
                                               {"Of the box along the axes of the world", "Its middle in the world"}};
        for (int space = 0; space < 2; ++space) {
            auto* head = new QLabel(space == 0 ? "Own axes" : "World", this);
            head->setProperty("secondary", true);
            grid->addWidget(head, 3 * space, 0);
            for (int axis = 0; axis < 3; ++axis) {
                auto* unit = new QLabel(QString("%1, m").arg("XYZ"[axis]), this);
                unit->setProperty("secondary", true);
                unit->setAlignment(Qt::AlignRight);
                grid->addWidget(unit, 3 * space, 1 + axis);
            }
            for (int row = 0; row < 2; ++row) {
                auto* title = new QLabel(titles[row], this);
                title->setToolTip(tips[space][row]);
                grid->addWidget(title, 3 * space + 1 + row, 0);
                for (int axis = 0; axis < 3; ++axis) {
                    QLabel*& cell = cells_[2 * space + row][axis];
                    cell = new QLabel(this);
                    cell->setAlignment(Qt::AlignRight);
                    cell->setTextInteractionFlags(Qt::TextSelectableByMouse);
                    grid->addWidget(cell, 3 * space + 1 + row, 1 + axis);
                }
            }
        }
        for (int axis = 0; axis < 3; ++axis) grid->setColumnStretch(1 + axis, 1);
        cells_[0][0]->setObjectName("boundsSizeX");
        cells_[2][0]->setObjectName("boundsWorldSizeX");
    }
    /// False when none of the nodes shows anything with a size.
    bool show(const std::vector<NodeId>& nodes)
    {
        const Scene& scene = session_.document.scene();
        const auto worlds = worldMatrices(scene, session_.playback ? session_.playback->pose() : ScenePose());
        Bounds local, world;
        for (const NodeId id : nodes) {
            const Node& n = scene.node(id);
            if (!n.mesh) continue;
            const Mesh mesh = shownMesh(session_, n.mesh);
            local.add(mesh.bounds());
            world.add(placed(mesh, worldFromMesh(scene, id, worlds)));
        }
        if (local.empty) return false;
        const bool one = nodes.size() == 1;
        const glm::dvec3 rows[] = {local.size(), local.centre(), world.size(), world.centre()};
        for (int row = 0; row < 4; ++row)
            for (int axis = 0; axis < 3; ++axis) {
                const bool said = one || row >= 2;  // boxes in different spaces have no common one
                cells_[row][axis]->setText(said ? look::number(rows[row][axis]) : QString("mixed"));
                cells_[row][axis]->setToolTip(said ? look::exactNumber(rows[row][axis]) + " m" : QString());
            }
        return true;
    }

private:
    Session& session_;
    QLabel* cells_[4][3];
};

class Properties : public QWidget {
public:
    Properties(Session& session, QWidget* parent) : QWidget(parent), session_(session)
    {
        auto* outer = new QVBoxLayout(this);
        outer->setContentsMargins(0, 0, 0, 0);
        auto* area = new QScrollArea(this);
        auto* page = new QWidget(area);
        auto* column = new QVBoxLayout(page);
        column->setContentsMargins(8, 8, 8, 8);
        column->setSpacing(6);
        empty_ = emptyStateLabel("Select a node to see where it is and what it is made of.", page);
        auto* inside = ofNodes_ = new QWidget(page);
        auto* box = new QVBoxLayout(inside);
        box->setContentsMargins(0, 0, 0, 0);
        box->setSpacing(6);
        name_ = new QLabel(inside);
        name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        note_ = new QLabel(inside);
        note_->setProperty("secondary", true);
        note_->setWordWrap(true);
        auto* transform = new Fold("Transform", "transform", true, inside);
        fields_ = new TransformFields(session_, transform);
        transform->inside()->addWidget(fields_);
        transform->inside()->addWidget(note_);
        boundsFold_ = new Fold("Bounding box", "bounds", true, inside);
        bounds_ = new BoundsNumbers(session_, boundsFold_);
        boundsFold_->inside()->addWidget(bounds_);
        material_ = new MaterialSection(session_, inside);
        matricesFold_ = new Fold("Matrices", "matrices", false, inside);
        matrices_ = new MatrixProduct(session_, matricesFold_);
        matricesFold_->inside()->addWidget(matrices_);
        for (QWidget* w : {static_cast<QWidget*>(name_), static_cast<QWidget*>(transform), static_cast<QWidget*>(material_),
                           static_cast<QWidget*>(matricesFold_), static_cast<QWidget*>(boundsFold_)})
            box->addWidget(w);
        column->addWidget(empty_);
        column->addWidget(ofNodes_);
        column->addWidget(makeViewSection(session_, page));
        column->addStretch(1);
        area->setWidget(page);
        area->setWidgetResizable(true);
        look::keepWide(area);
        outer->addWidget(area);
        subscription_ = session_.document.subscribe([this](const Change& c) {
            if (c.aspects & (Aspect::Selection | Aspect::Tree | Aspect::Transform | Aspect::Material | Aspect::Mesh | Aspect::Stack |
                             Aspect::Evaluation | Aspect::Skin | Aspect::File | Aspect::History))
                refreshSoon();
        });
        connect(&session_.view, &ViewState::timeChanged, this, [this] {
            if (isVisible() && matricesFold_->isOpen()) matrices_->refresh();
        });
        connect(&session_.view, &ViewState::changed, this, [this] {
            if (session_.view.shownLevel != levels_) refreshSoon();
        });
        for (Fold* f : {boundsFold_, matricesFold_}) connect(f, &Fold::opened, this, [this] { refresh(); });
        refresh();
    }

private:
    void refreshSoon()
    {
        if (std::exchange(pending_, true)) return;
        QMetaObject::invokeMethod(
            this, [this] { refresh(); }, Qt::QueuedConnection);
    }

    void refresh()
    {
        pending_ = false;
        const Scene& scene = session_.document.scene();
        levels_ = session_.view.shownLevel;
        std::vector<NodeId> nodes = session_.document.selection().nodes;
        std::erase_if(nodes, [&](NodeId id) { return !scene.find(id); });
        empty_->setVisible(nodes.empty());
        ofNodes_->setVisible(!nodes.empty());
        if (nodes.empty()) return;
        const NodeId active = nodes.back();
        const bool one = nodes.size() == 1;
        name_->setText("<b>" + (one ? nodeName(scene, active) : counted(nodes.size(), "node", "nodes")).toHtmlEscaped() + "</b>");
        fields_->setNodes(nodes);
        const Clip* clip = session_.playback ? session_.playback->clip() : nullptr;
        bool driven = false;
        if (clip)
            for (const auto& c : clip->channels) driven = driven || std::find(nodes.begin(), nodes.end(), c->node) != nodes.end();
        const bool skinned = bool(scene.node(active).skin);
        note_->setText(driven ? "A clip moves it; these are its numbers at rest."
                              : "Its skin places the mesh; the node's own transform does not count.");
        note_->setVisible(driven || skinned);
        if (boundsFold_->isOpen() || boundsFold_->isHidden()) boundsFold_->setVisible(bounds_->show(nodes));
        material_->setNode(one ? active : NodeId{});
        if (matricesFold_->isOpen()) matrices_->setNode(active);
    }

    Session& session_;
    QLabel *empty_, *name_, *note_;
    QWidget* ofNodes_;
    TransformFields* fields_;
    Fold *boundsFold_, *matricesFold_;
    BoundsNumbers* bounds_;
    MaterialSection* material_;
    MatrixProduct* matrices_;
    std::map<MeshId, size_t> levels_;
    bool pending_ = false;
    std::shared_ptr<void> subscription_;
};

}  // namespace

QWidget* makePropertiesPanel(Session& session, QWidget* parent)
{
    return new Properties(session, parent);
}

}  // namespace mw
