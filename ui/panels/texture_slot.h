// One picture of a material: thumbnail, file, coordinates it uses, clear. A file dropped on it is put there.
#pragma once
#include <QWidget>

#include "core/scene/materials.h"
#include "ui/session.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QToolButton;

namespace mw {

class TextureSlot : public QWidget {
    Q_OBJECT

public:
    TextureSlot(Session& session, TextureKind kind, QWidget* parent);
    void show(NodeId node, int64_t slot);
    void refresh();
    void take(const QString& file);  ///< puts a picture file there; says below why it cannot

protected:
    void dragEnterEvent(QDragEnterEvent* e) override;
    void dragLeaveEvent(QDragLeaveEvent* e) override;
    void dropEvent(QDropEvent* e) override;
    void paintEvent(QPaintEvent* e) override;

private:
    void makeButtons();
    void makeCoordinates();
    void choose();
    void run(const EditCall& call);
    EditCall callFor(const QString& file) const;
    const Material::Texture* texture() const;

    Session& session_;
    TextureKind kind_;
    NodeId node_;
    int64_t slot_ = 0;
    QToolButton *thumbnail_, *clear_;
    QLabel *name_, *error_;
    QComboBox* set_;
    QCheckBox* repeat_;
    QWidget* laid_;
    bool over_ = false, filling_ = false;
};

}  // namespace mw
