// The look of the window from one table of colours (ui/UI.md 5): palette, style sheet, tinted icons.
#pragma once
#include <QColor>
#include <QIcon>
#include <QString>

#include "render/renderer.h"

class QApplication;

namespace mw {

struct Tokens {
    QColor window, panel, raised, field, hover, border, strong, text, text2, text3, accent, accentText, selection, selectionText, warning, error,
        success;
};
const Tokens& tokens();  ///< of the theme in use
Theme currentTheme();

/// Fusion, palette and style sheet; may be called again to change over.
void applyTheme(QApplication& app, Theme theme);

/// An icon of resources/icons in the text colour of the theme (disabled: 45 %), or in `color`. Made anew for each device ratio.
QIcon icon(const QString& name, const QColor& color = {});
QPixmap iconPixmap(const QString& name, const QColor& color, int size, qreal ratio);

}  // namespace mw
