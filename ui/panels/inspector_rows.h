// How the rows of the inspector's list are drawn: bars of sections, rows with a figure at the right end, sentences that wrap.
#pragma once
#include <QStyledItemDelegate>

namespace mw {

class InspectorRows : public QStyledItemDelegate {
public:
    /// A section's row has a figure beside its title; a sentence's row has neither icon nor figure.
    enum Role { Section = Qt::UserRole + 2, SectionFigure, Sentence };
    using QStyledItemDelegate::QStyledItemDelegate;
    QSize sizeHint(const QStyleOptionViewItem& o, const QModelIndex& i) const override;
    void paint(QPainter* p, const QStyleOptionViewItem& o, const QModelIndex& i) const override;

private:
    void paintSection(QPainter* p, const QStyleOptionViewItem& o, const QModelIndex& i) const;
};

}  // namespace mw
