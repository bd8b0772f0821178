// Position, rotation and scale of the selected nodes as nine fields. Where they differ a field says "mixed"; what is typed goes to all.
#pragma once
#include <QWidget>
#include <array>
#include <map>
#include <vector>

#include "ui/session.h"

class QGridLayout;
class QLabel;

namespace mw {

class AxisBox;

class TransformFields : public QWidget {
    Q_OBJECT

public:
    TransformFields(Session& session, QWidget* parent);
    void setNodes(std::vector<NodeId> nodes);
    void refresh();  ///< reads the scene again; not while a field is dragged
    /// Row 0 position, 1 rotation, 2 scale; axis 0 X, 1 Y, 2 Z.
    AxisBox* field(int row, int axis) const { return fields_[size_t(3 * row + axis)]; }

    QSize minimumSizeHint() const override;  ///< with the labels over their fields

protected:
    void resizeEvent(QResizeEvent* e) override;

private:
    int labelRoom() const;
    glm::dvec3 valueOf(NodeId id, int row) const;
    std::vector<EditCall> callsFor(int row, int axis, double value) const;
    void preview(int row, int axis, double value);
    void commit(int row, int axis, double value);
    void arrange();

    Session& session_;
    std::vector<NodeId> nodes_;
    std::map<NodeId, glm::dvec3> euler_;  // as shown: a rotation has many
    std::array<AxisBox*, 9> fields_;
    std::array<QLabel*, 3> labels_;
    QGridLayout* grid_;
    bool narrow_ = false, arranged_ = false;
};

}  // namespace mw
