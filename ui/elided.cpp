#include "ui/elided.h"

#include <QHelpEvent>
#include <QStyleOptionButton>
#include <QStyleOptionComboBox>
#include <QStylePainter>
#include <QToolTip>

namespace mw {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
}

QSize ElidedLabel::minimumSizeHint() const
{
    return {fontMetrics().averageCharWidth() * 2, QLabel::minimumSizeHint().height()};
}

void ElidedLabel::paintEvent(QPaintEvent*)
{
    QStylePainter painter(this);
    const QRect room = contentsRect().marginsRemoved({margin(), margin(), margin(), margin()});
    style()->drawItemText(&painter, room, int(QStyle::visualAlignment(layoutDirection(), alignment())), palette(), isEnabled(),
                          fontMetrics().elidedText(text(), Qt::ElideRight, room.width()), foregroundRole());
}

bool ElidedLabel::event(QEvent* e)
{
    if (e->type() == QEvent::ToolTip && toolTip().isEmpty() && fontMetrics().horizontalAdvance(text()) > contentsRect().width()) {
        QToolTip::showText(static_cast<QHelpEvent*>(e)->globalPos(), text(), this);
        return true;
    }
    return QLabel::event(e);
}

namespace {
constexpr int air = 4;  // a style sheet leaves it between the text and the frame, and does not count it
}

QSize ElidedComboBox::sizeHint() const
{
    return QComboBox::sizeHint() + QSize(air, 0);
}

QSize ElidedComboBox::minimumSizeHint() const
{
    const QSize all = QComboBox::minimumSizeHint();
    return {std::min(all.width(), 44 + 6 * fontMetrics().averageCharWidth()), all.height()};  // padding and arrow
}

QString ElidedComboBox::shownText() const
{
    QStyleOptionComboBox option;
    initStyleOption(&option);
    const int room = style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this).width() - air;
    return fontMetrics().elidedText(option.currentText, Qt::ElideRight, room);
}

void ElidedComboBox::paintEvent(QPaintEvent*)
{
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    option.currentText = shownText();
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
}

QSize ElidedButton::minimumSizeHint() const
{
    QStyleOptionButton option;
    initStyleOption(&option);
    const int text = fontMetrics().horizontalAdvance(option.text);
    const QSize all = QPushButton::minimumSizeHint();
    return {std::max(all.height(), all.width() - text), all.height()};
}

void ElidedButton::paintEvent(QPaintEvent*)
{
    QStylePainter painter(this);
    QStyleOptionButton option;
    initStyleOption(&option);
    const int picture = icon().isNull() ? 0 : iconSize().width() + 4;
    const int room = style()->subElementRect(QStyle::SE_PushButtonContents, &option, this).width() - picture;
    option.text = fontMetrics().elidedText(option.text, Qt::ElideRight, room);
    painter.drawControl(QStyle::CE_PushButton, option);
}

}  // namespace mw
