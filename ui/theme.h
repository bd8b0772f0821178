// The look of the window from one table of colours (ui/UI.md 5): palette, style sheet, tinted icons.
#pragma once
#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QString>
#include <QWidget>

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

/// What the user wants to see; kept in the settings.
enum class ThemeChoice { System, Dark, Light };
ThemeChoice themeChoice();
/// Keeps the choice and changes over at once. Widgets hear of it by QEvent::PaletteChange.
void chooseTheme(QApplication& app, ThemeChoice choice);
/// Before the first applyTheme(): the palette the desktop gave us, which the choice System follows.
void followSystemPalette(const QPalette& system);
bool isHighContrast(const QPalette& palette);  ///< black and white alone: our colours then step aside for the palette's
Tokens tokensOf(const QPalette& palette);

/// No flights of the camera, nothing that turns by itself; kept in the settings.
bool reducedMotion();
void setReducedMotion(bool on);

/// An icon of resources/icons in the text colour of the theme (disabled: 45 %), or in `color`. A colour that is a token of the theme in use
/// is that token from then on: the icon follows the theme. Made anew for each device ratio.
QIcon icon(const QString& name, const QColor& color = {});
QPixmap iconPixmap(const QString& name, const QColor& color, int size, qreal ratio);

/// An icon beside a text, in a token's colour; follows the theme and the device ratio.
class IconLabel : public QWidget {
    Q_OBJECT

public:
    IconLabel(QString name, QColor Tokens::*color, QWidget* parent, int size = 16);
    void set(const QString& name, QColor Tokens::*color);
    QSize sizeHint() const override { return {size_, size_}; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    QString name_;
    QColor Tokens::*color_;
    int size_;
};

}  // namespace mw
