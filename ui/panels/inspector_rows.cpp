#include "ui/panels/inspector_rows.h"

#include <QPainter>
#include <QTreeView>

#include "ui/look.h"

namespace mw {
namespace {

constexpr int rowHeight = 26, sentenceMargin = 4;

QFont small(const QFont& font)
{
    QFont f = font;
    f.setPointSizeF(0.92 * f.pointSizeF());
    return f;
}

}  // namespace

QSize InspectorRows::sizeHint(const QStyleOptionViewItem& o, const QModelIndex& i) const
{
    const QSize usual = QStyledItemDelegate::sizeHint(o, i);
    if (!i.data(Sentence).toBool()) return {usual.width(), std::max(rowHeight, o.fontMetrics.height() + 8)};
    const auto* view = qobject_cast<const QTreeView*>(o.widget);
    int depth = 0;
    for (QModelIndex up = i; up.parent().isValid(); up = up.parent()) ++depth;
    const int width = view ? view->viewport()->width() - depth * view->indentation() - 16 : 240;
    const QRect box = QFontMetrics(small(o.font)).boundingRect(0, 0, std::max(60, width), 1000, Qt::TextWordWrap, i.data().toString());
    return {60, box.height() + 2 * sentenceMargin};
}

// The figure keeps its room while the title is cut short. It is the text of column 1, whose cell holds a button or nothing.
void InspectorRows::paint(QPainter* p, const QStyleOptionViewItem& o, const QModelIndex& i) const
{
    if (i.data(Section).toBool()) return paintSection(p, o, i);
    if (i.data(Sentence).toBool()) {
        p->setFont(small(o.font));
        p->setPen(look::tone().text2);
        return p->drawText(o.rect.adjusted(8, sentenceMargin, -8, 0), Qt::TextWordWrap, i.data().toString());
    }
    QStyleOptionViewItem row = o;
    initStyleOption(&row, i);
    const QString figure = i.column() == 0 ? i.siblingAtColumn(1).data().toString() : QString();
    const int w = figure.isEmpty() ? 0 : o.fontMetrics.horizontalAdvance(figure) + 16;
    const int room = o.rect.width() - w - (row.icon.isNull() ? 8 : 30);
    row.text = i.column() == 0 ? QFontMetrics(row.font).elidedText(row.text, Qt::ElideRight, room) : QString();
    const QWidget* view = o.widget;
    view->style()->drawControl(QStyle::CE_ItemViewItem, &row, p, view);
    const bool selected = o.state & QStyle::State_Selected;
    p->setFont(row.font);  // struck through like the title
    p->setPen(selected ? look::tone().selectionText : i.siblingAtColumn(1).data(Qt::ForegroundRole).value<QBrush>().color());
    p->drawText(o.rect.adjusted(0, 0, -8, 0), Qt::AlignRight | Qt::AlignVCenter, figure);
}

void InspectorRows::paintSection(QPainter* p, const QStyleOptionViewItem& o, const QModelIndex& i) const
{
    const look::Tones& t = look::tone();
    p->fillRect(o.rect, t.raised);
    QFont bold = o.font;
    bold.setBold(true);
    const QString title = i.data(Qt::DisplayRole).toString();
    const int w = QFontMetrics(bold).horizontalAdvance(title);
    const QRect r = o.rect.adjusted(8, 0, 0, 0);
    p->setFont(bold);
    p->setPen(t.text);
    p->drawText(r, Qt::AlignVCenter, title);
    p->setFont(o.font);
    p->setPen(t.text2);
    const QRect rest = r.adjusted(w + 8, 0, -4, 0);
    p->drawText(rest, Qt::AlignVCenter, o.fontMetrics.elidedText(i.data(SectionFigure).toString(), Qt::ElideRight, rest.width()));
}

}  // namespace mw
