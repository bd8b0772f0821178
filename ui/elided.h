// Text that ends in an ellipsis where there is no room for all of it, and then says the whole in its tooltip.
#pragma once
#include <QComboBox>
#include <QLabel>
#include <QPushButton>

namespace mw {

/// One line of plain text; as narrow as its layout wants it.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget* parent);
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* e) override;
    bool event(QEvent* e) override;
};

/// A style sheet's combo box would cut its text off.
class ElidedComboBox : public QComboBox {
    Q_OBJECT

public:
    using QComboBox::QComboBox;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;  ///< of some letters
    QString shownText() const;               ///< of the current one, as much as there is room for

protected:
    void paintEvent(QPaintEvent* e) override;
};

/// As narrow as its icon.
class ElidedButton : public QPushButton {
    Q_OBJECT

public:
    using QPushButton::QPushButton;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* e) override;
};

}  // namespace mw
