#include "ui/panels/transform_fields.h"

#include <QGridLayout>
#include <QLabel>
#include <QResizeEvent>
#include <cmath>

#include "core/math/euler.h"
#include "core/scene/edit.h"
#include "ui/panels/axis_box.h"
#include "ui/words.h"

namespace mw {
namespace {

struct RowWords {
    const char *title, *tip, *unit, *key;
    double perPixel;
};
constexpr RowWords rowWords[] = {{"Position", "Where the node is in its parent, in metres.", " m", "position", 0.01},
                                 {"Rotation", "Turns about X, then Y, then Z, in degrees.", "°", "rotation", 0.5},
                                 {"Scale", "Factors along the node's own axes.", "", "scale", 0.01}};

bool same(double a, double b)
{
    return std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)});
}

}  // namespace

TransformFields::TransformFields(Session& session, QWidget* parent) : QWidget(parent), session_(session)
{
    grid_ = new QGridLayout(this);
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setHorizontalSpacing(4);
    grid_->setVerticalSpacing(4);
    for (int row = 0; row < 3; ++row) {
        const RowWords& words = rowWords[row];
        labels_[size_t(row)] = new QLabel(words.title, this);
        labels_[size_t(row)]->setToolTip(words.tip);
        for (int axis = 0; axis < 3; ++axis) {
            auto* box = new AxisBox(axis, this);
            fields_[size_t(3 * row + axis)] = box;
            box->setObjectName(QString("%1-%2").arg(words.key).arg("xyz"[axis]));
            box->setAccessibleName(QString("%1 %2").arg(words.title).arg("XYZ"[axis]));
            box->setToolTip(QString("%1 %2. %3 Drag sideways to change it, with Shift finer.").arg(words.title).arg("XYZ"[axis]).arg(words.tip));
            box->setSuffix(words.unit);
            box->perPixel = words.perPixel;
            connect(box, &AxisBox::dragged, this, [this, row, axis](double v) { preview(row, axis, v); });
            connect(box, &AxisBox::entered, this, [this, row, axis](double v) { commit(row, axis, v); });
            connect(box, &AxisBox::abandoned, this, [this] {
                session_.document.cancelPreview();
                refresh();
            });
        }
    }
    arrange();
}

void TransformFields::arrange()
{
    const bool narrow = width() < std::max(300, labelRoom() + minimumSizeHint().width());
    if (arranged_ && narrow == narrow_) return;
    arranged_ = true;
    narrow_ = narrow;
    for (int row = 0; row < 3; ++row) {
        // In a narrow dock the label stands over its fields.
        if (narrow)
            grid_->addWidget(labels_[size_t(row)], 2 * row, 1, 1, 3);
        else
            grid_->addWidget(labels_[size_t(row)], 2 * row + 1, 0);
        for (int axis = 0; axis < 3; ++axis) grid_->addWidget(field(row, axis), 2 * row + 1, 1 + axis);
    }
    grid_->setColumnMinimumWidth(0, narrow ? 0 : 68);
    for (int axis = 0; axis < 3; ++axis) grid_->setColumnStretch(1 + axis, 1);
}

int TransformFields::labelRoom() const
{
    int widest = 0;
    for (const QLabel* l : labels_) widest = std::max(widest, l->sizeHint().width());
    return widest + grid_->horizontalSpacing();
}

QSize TransformFields::minimumSizeHint() const
{
    return {3 * field(0, 0)->minimumWidth() + 2 * grid_->horizontalSpacing(), QWidget::minimumSizeHint().height()};
}

void TransformFields::resizeEvent(QResizeEvent* e)
{
    QWidget::resizeEvent(e);
    arrange();
}

void TransformFields::setNodes(std::vector<NodeId> nodes)
{
    nodes_ = std::move(nodes);
    refresh();
}

glm::dvec3 TransformFields::valueOf(NodeId id, int row) const
{
    const Transform& t = session_.document.scene().node(id).local;
    if (row == 0) return t.translation;
    if (row == 2) return t.scale;
    const auto shown = euler_.find(id);
    return eulerDegreesNear(t.rotation, shown == euler_.end() ? glm::dvec3(0) : shown->second);
}

void TransformFields::refresh()
{
    const Scene& scene = session_.document.scene();
    std::erase_if(nodes_, [&](NodeId id) { return !scene.find(id); });
    if (nodes_.empty()) return;
    for (const NodeId id : nodes_) euler_[id] = valueOf(id, 1);
    for (int row = 0; row < 3; ++row)
        for (int axis = 0; axis < 3; ++axis) {
            const double shown = valueOf(nodes_.back(), row)[axis];
            bool mixed = false;
            for (const NodeId id : nodes_) mixed = mixed || !same(valueOf(id, row)[axis], shown);
            if (!(field(row, axis)->hasFocus() && field(row, axis)->mixed() == mixed && same(field(row, axis)->value(), shown)))
                field(row, axis)->setNumber(shown, mixed);
        }
}

std::vector<EditCall> TransformFields::callsFor(int row, int axis, double value) const
{
    std::vector<EditCall> calls;
    const Scene& scene = session_.document.scene();
    for (const NodeId id : nodes_) {
        glm::dvec3 rows[3] = {valueOf(id, 0), valueOf(id, 1), valueOf(id, 2)};
        rows[row][axis] = value;
        calls.push_back({"transform", {{"node", nodeText(scene, id)}, {"position", rows[0]}, {"rotation", rows[1]}, {"scale", rows[2]}}});
    }
    return calls;
}

void TransformFields::preview(int row, int axis, double value)
{
    if (nodes_.empty()) return;
    Scene next = session_.document.scene();
    for (const EditCall& call : callsFor(row, axis, value)) next = edited(next, call);
    if (row == 1)
        for (const NodeId id : nodes_) euler_[id][axis] = value;
    session_.document.preview(std::move(next));
}

void TransformFields::commit(int row, int axis, double value)
{
    if (nodes_.empty()) return;
    const Scene& scene = session_.document.scene();
    const std::vector<EditCall> calls = callsFor(row, axis, value);
    if (row == 1)
        for (const NodeId id : nodes_) euler_[id][axis] = value;
    const QString who = nodes_.size() == 1 ? nodeName(scene, nodes_.front()) : counted(nodes_.size(), "node", "nodes");
    const QString what =
        QString("%1 %2 %3%4").arg(QString(rowWords[row].title).toLower()).arg("XYZ"[axis]).arg(value, 0, 'g', 4).arg(rowWords[row].unit);
    commitEdits(session_.document, (who + ": " + what).toStdString(), calls);
    refresh();
}

}  // namespace mw
