// A colour as a swatch with its name; a click opens square, hue bar and numbers. Values are linear, as materials have them; the swatch, the
// square and the # number are sRGB, as screens and pictures have them.
#pragma once
#include <QColor>
#include <QIcon>
#include <QPushButton>
#include <glm/vec3.hpp>

namespace mw {

class ColourField : public QPushButton {
    Q_OBJECT

public:
    /// `glow`: values above 1 are allowed, as a strength beside the colour.
    ColourField(const QString& title, bool glow, QWidget* parent);
    void setLinear(glm::dvec3 linear);
    glm::dvec3 linear() const { return linear_; }
    void openPopup();

signals:
    void edited(glm::dvec3 linear);     ///< while a drag goes on
    void committed(glm::dvec3 linear);  ///< done

protected:
    void paintEvent(QPaintEvent* e) override;

private:
    QString title_;
    bool glow_;
    glm::dvec3 linear_{0};
};

QColor screenColour(glm::dvec3 linear);  ///< brightest channel at most 1
/// 16 x 16 (logical) swatch.
QIcon swatch(glm::dvec3 linear, qreal ratio);

}  // namespace mw
