#include "ui/number_box.h"

#include <QLocale>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace mw {

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent)
{
    setButtonSymbols(NoButtons);
    setAlignment(Qt::AlignRight);
    setDecimals(12);
    setKeyboardTracking(false);
    setFocusPolicy(Qt::StrongFocus);
    setFixedWidth(std::max(82, fontMetrics().horizontalAdvance("00000000") + 16));  // the padding of a field
}

QString NumberBox::textFromValue(double v) const
{
    if (integral || (std::abs(v) >= 1000 && std::abs(v) < 1e9)) return QLocale(QLocale::English).toString(qlonglong(std::llround(v)));
    return QString::number(v, 'g', 4);
}

double NumberBox::valueFromText(const QString& text) const
{
    QString t = text;
    t.remove(suffix()).remove(',').remove(' ').replace(QChar(0x2212), '-');
    bool ok = false;
    double v = t.toDouble(&ok);
    if (!ok) return value();
    const bool out = v < minimum() || v > maximum();
    emit const_cast<NumberBox*>(this)->outOfRange(out);
    return out ? value() : integral ? std::round(v) : v;
}

void NumberBox::wheelEvent(QWheelEvent* e)
{
    if (hasFocus())
        QDoubleSpinBox::wheelEvent(e);
    else
        e->ignore();
}

}  // namespace mw
