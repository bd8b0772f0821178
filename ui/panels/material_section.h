// The materials of a mesh: its slots, which faces they cover, and the values and pictures of the chosen one.
#pragma once
#include <QWidget>
#include <array>

#include "ui/session.h"

class QLabel;
class QListWidget;
class QPushButton;
class QToolButton;

namespace mw {

class ColourField;
class Fold;
class ParameterForm;
class TextureSlot;

class MaterialSection : public QWidget {
    Q_OBJECT

public:
    MaterialSection(Session& session, QWidget* parent);
    void setNode(NodeId id);
    void refresh();

private:
    void makeSlots(QWidget* parent);
    void makeValues();
    void fillSlots();
    void showMenu();
    void newMaterial(int64_t like);
    void assign();
    void run(const EditCall& call);
    EditCall valuesCall() const;
    ParameterValues valuesOf(const Material& m) const;
    const MeshObject* object() const;
    const Material* material() const;
    std::string node() const;

    Session& session_;
    NodeId node_;
    int64_t slot_ = 0;
    glm::dvec3 color_{0}, emissive_{0};
    QListWidget* slots_;
    QLabel *none_, *shared_, *error_;
    QWidget *sharedRow_, *values_;
    QPushButton *new_, *assign_;
    QToolButton* more_;
    ColourField *colorField_, *emissiveField_;
    ParameterForm* form_;
    Fold* textures_;
    std::array<TextureSlot*, 5> pictures_;
    bool filling_ = false;
};

}  // namespace mw
