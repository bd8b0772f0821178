#include "ui/panels/axis_box.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <cmath>
#include <utility>

namespace mw {

AxisBox::AxisBox(int axis, QWidget* parent) : NumberBox(parent)
{
    static const char* const edges[] = {"#E05252", "#6CBF4B", "#4C8DF0"};
    setMinimumWidth(std::max(44, fontMetrics().horizontalAdvance("00000") + 6));
    setMaximumWidth(5 * minimumWidth());
    setRange(-1e9, 1e9);
    setStyleSheet(QString("border-left: 2px solid %1; padding-left: 2px; padding-right: 3px;").arg(edges[axis]));
    lineEdit()->installEventFilter(this);
    lineEdit()->setCursor(Qt::SizeHorCursor);
    connect(this, &NumberBox::valueChanged, this, [this](double v) {
        if (setting_ || dragging_) return;
        mixed_ = false;
        emit entered(v);
    });
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] { typed_ = true; });
    // Where the others differ, the number that is there already may be typed, too.
    connect(this, &NumberBox::editingFinished, this, [this] {
        if (!std::exchange(typed_, false) || !mixed_ || setting_) return;
        mixed_ = false;
        emit entered(value());
    });
}

void AxisBox::setNumber(double v, bool mixed)
{
    if (dragging_) return;
    setting_ = true;
    mixed_ = mixed;
    setValue(v);
    lineEdit()->setText(mixed ? textFromValue(v) : textFromValue(v) + suffix());
    lineEdit()->setCursorPosition(0);
    setting_ = false;
}

QString AxisBox::textFromValue(double v) const
{
    if (mixed_) return "mixed";
    const double r = std::abs(v) < 5e-7 ? 0 : v;  // no -0 and no rests of a turn
    return QString::number(r, 'g', std::abs(r) >= 1000 ? 6 : 4).replace('-', QChar(0x2212));
}

// A press on a field without the focus gives it the focus first and comes afterwards: that press may become a drag.
void AxisBox::focusInEvent(QFocusEvent* e)
{
    fresh_ = e->reason() == Qt::MouseFocusReason;
    NumberBox::focusInEvent(e);
}

bool AxisBox::eventFilter(QObject* o, QEvent* e)
{
    auto* mouse = e->type() == QEvent::MouseButtonPress || e->type() == QEvent::MouseMove || e->type() == QEvent::MouseButtonRelease
                      ? static_cast<QMouseEvent*>(e)
                      : nullptr;
    if (mouse && e->type() == QEvent::MouseButtonPress && mouse->button() == Qt::LeftButton && (std::exchange(fresh_, false) || !hasFocus())) {
        pressed_ = true;
        from_ = mouse->globalPosition().toPoint();
        start_ = value();
    } else if (mouse && e->type() == QEvent::MouseMove && pressed_) {
        const int moved = int(mouse->globalPosition().x()) - from_.x();
        if (!dragging_ && std::abs(moved) < 4) return true;
        dragging_ = true;
        mixed_ = false;
        const double step = perPixel * (mouse->modifiers() & Qt::ShiftModifier ? 0.1 : 1);
        setValue(std::round((start_ + moved * step) / step) * step);
        emit dragged(value());
        return true;
    } else if (mouse && e->type() == QEvent::MouseButtonRelease && pressed_) {
        pressed_ = false;
        if (!dragging_) {
            selectAll();
            return true;
        }
        dragging_ = false;
        emit entered(value());
        clearFocus();
        return true;
    } else if (e->type() == QEvent::KeyPress && dragging_ && static_cast<QKeyEvent*>(e)->key() == Qt::Key_Escape) {
        dragging_ = pressed_ = false;
        clearFocus();
        emit abandoned();
        return true;
    }
    return NumberBox::eventFilter(o, e);
}

}  // namespace mw
