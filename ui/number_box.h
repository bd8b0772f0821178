// A spin box that leaves the wheel to the page unless it has the focus, and shows no needless zeros.
#pragma once
#include <QDoubleSpinBox>

namespace mw {

class NumberBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit NumberBox(QWidget* parent = nullptr);
    QString textFromValue(double v) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString&, int&) const override { return QValidator::Acceptable; }
    bool integral = false;

signals:
    void outOfRange(bool out);

protected:
    void wheelEvent(QWheelEvent* e) override;
};

}  // namespace mw
