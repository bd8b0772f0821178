// Colours by name, numbers as words, the small icons and rows that several panels draw alike (ui/UI.md 5 and 6).
#pragma once
#include <QColor>
#include <QIcon>
#include <QString>
#include <QWidget>
#include <string>
#include <vector>

#include "core/steps/step.h"
#include "ui/theme.h"

class QLabel;
class QPainter;
class QPushButton;
class QScrollArea;

namespace mw::look {

using Tones = Tokens;
const Tones& tone();  ///< of the theme in use
bool dark();
QColor roleColor(Role r);      ///< of marks
QColor roleTextColor(Role r);  ///< of words and formula terms on a panel
QString roleName(Role r);
void paintRole(QPainter& p, Role r, const QRectF& box);  ///< the sign of a legend: shape as well as colour

/// The filled signs of the transport; any other name is one of resources/icons.
QIcon icon(const QString& name, const QColor& color = {});

/// Three significant digits, thousands grouped, a true minus; counts in full.
QString number(double v);
/// All digits, for tooltips.
QString exactNumber(double v);
QString count(size_t n);
/// As a lesson wants it: "integer", "N significant", "N decimals", "percent", "degrees", "words".
QString formatted(double v, const std::string& format, const std::vector<std::string>& words);
/// "1 edge", "40 edges".
QString counted(size_t n, const QString& one, const QString& many);

QFont monospace();
/// One sentence and, with a `button`, one thing to do; top aligned.
QWidget* emptyState(QWidget* parent, QLabel** sentence, QPushButton** button = nullptr);
/// A form is never narrower than what is in it, so that its dock is as wide as that; but not over a third of the main window, where it scrolls.
void keepWide(QScrollArea* area);
/// A heading bar of a section: bold title, a figure beside it.
class SectionBar : public QWidget {
    Q_OBJECT

public:
    explicit SectionBar(const QString& title, QWidget* parent);
    void setFigure(const QString& text);
    void setTitle(const QString& text);
    QSize sizeHint() const override { return {120, 24}; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    QString title_, figure_;
};

}  // namespace mw::look
