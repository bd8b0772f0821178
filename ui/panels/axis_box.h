// A number field for one axis: typed, stepped by arrows, or dragged sideways. Shows "mixed" where several things differ.
#pragma once
#include "ui/parameter_form.h"

namespace mw {

class AxisBox : public NumberBox {
    Q_OBJECT

public:
    AxisBox(int axis, QWidget* parent);
    void setNumber(double v, bool mixed);  ///< from outside: no signal
    bool mixed() const { return mixed_; }
    bool dragging() const { return dragging_; }
    QString textFromValue(double v) const override;
    double perPixel = 0.01;  ///< what a drag of one pixel adds; Shift a tenth of it

signals:
    void dragged(double value);  ///< on the way
    void entered(double value);  ///< typed, stepped, or the end of a drag
    void abandoned();            ///< Esc while dragging

protected:
    bool eventFilter(QObject* o, QEvent* e) override;
    void focusInEvent(QFocusEvent* e) override;

private:
    bool mixed_ = false, typed_ = false, fresh_ = false, dragging_ = false, pressed_ = false, setting_ = false;
    QPoint from_;
    double start_ = 0;
};

}  // namespace mw
