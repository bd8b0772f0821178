// What a panel says when there is nothing to show: one sentence, top aligned, never an empty grey area.
#pragma once
#include <QLabel>

namespace mw {

inline QLabel* emptyStateLabel(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setProperty("secondary", true);
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    label->setContentsMargins(16, 16, 16, 16);
    return label;
}

}  // namespace mw
