#include "ui/panels/colour_field.h"

#include <QApplication>
#include <QBoxLayout>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QScreen>
#include <array>
#include <cmath>
#include <functional>

#include "core/math/srgb.h"
#include "ui/look.h"
#include "ui/parameter_form.h"

namespace mw {
namespace {

// Saturation to the right, value upwards, hue on a bar beside them; arrows move the mark.
class HueSquare : public QWidget {
public:
    explicit HueSquare(QWidget* parent) : QWidget(parent)
    {
        setFixedSize(212, 150);
        setFocusPolicy(Qt::StrongFocus);
        setAccessibleName("Saturation and brightness; hue at the right");
        setToolTip("Saturation to the right, brightness upwards; hue on the bar. Arrow keys move the mark, with Shift the hue.");
    }
    std::function<void(const QColor&, bool done)> changed;
    void setColour(const QColor& c)
    {
        const double h = c.hsvHueF();
        if (h >= 0) hue_ = h;  // grey has none: the last one stays
        saturation_ = c.hsvSaturationF();
        value_ = c.valueF();
        update();
    }

private:
    QRect square() const { return {0, 0, 186, height()}; }
    QRect bar() const { return {194, 0, 18, height()}; }
    void paintEvent(QPaintEvent*) override
    {
        QPainter p(this);
        QLinearGradient across(square().topLeft(), square().topRight());
        across.setColorAt(0, Qt::white);
        across.setColorAt(1, QColor::fromHsvF(float(hue_), 1, 1));
        p.fillRect(square(), across);
        QLinearGradient down(square().topLeft(), square().bottomLeft());
        down.setColorAt(0, QColor(0, 0, 0, 0));
        down.setColorAt(1, Qt::black);
        p.fillRect(square(), down);
        QLinearGradient hues(bar().topLeft(), bar().bottomLeft());
        for (int i = 0; i <= 6; ++i) hues.setColorAt(i / 6.0, QColor::fromHsvF(float(i % 6) / 6, 1, 1));
        p.fillRect(bar(), hues);
        p.setRenderHint(QPainter::Antialiasing);
        const QPointF at(saturation_ * (square().width() - 1), (1 - value_) * (height() - 1));
        const double y = hue_ * (height() - 1);
        for (const auto& [colour, width] : {std::pair(QColor("#101215"), 4.0), std::pair(QColor(Qt::white), 2.0)}) {
            p.setPen(QPen(colour, width));
            p.drawEllipse(at, 5, 5);
            p.drawRect(QRectF(bar().left() + 1.5, std::clamp(y - 2, 1.0, height() - 5.0), bar().width() - 3, 4));
        }
        if (!hasFocus()) return;
        p.setPen(QPen(look::tone().accentText, 2));
        p.drawRect(rect().adjusted(1, 1, -1, -1));
    }
    void take(QPoint at)
    {
        const double y = std::clamp(double(at.y()) / (height() - 1), 0.0, 1.0);
        if (inBar_)
            hue_ = std::min(y, 0.9999);
        else
            saturation_ = std::clamp(double(at.x()) / (square().width() - 1), 0.0, 1.0), value_ = 1 - y;
    }
    void tell(bool done)
    {
        update();
        changed(QColor::fromHsvF(float(hue_), float(saturation_), float(value_)), done);
    }
    void mousePressEvent(QMouseEvent* e) override
    {
        inBar_ = e->pos().x() >= bar().left() - 4;
        take(e->pos());
        tell(false);
    }
    void mouseMoveEvent(QMouseEvent* e) override
    {
        take(e->pos());
        tell(false);
    }
    void mouseReleaseEvent(QMouseEvent*) override { tell(true); }
    void keyPressEvent(QKeyEvent* e) override
    {
        const int x = e->key() == Qt::Key_Right ? 1 : e->key() == Qt::Key_Left ? -1 : 0;
        const int y = e->key() == Qt::Key_Up ? 1 : e->key() == Qt::Key_Down ? -1 : 0;
        if (!x && !y) return QWidget::keyPressEvent(e);
        if (e->modifiers() & Qt::ShiftModifier)
            hue_ = std::fmod(1 + hue_ + (x - y) / 100.0, 1.0);
        else
            saturation_ = std::clamp(saturation_ + x / 50.0, 0.0, 1.0), value_ = std::clamp(value_ + y / 50.0, 0.0, 1.0);
        tell(true);
    }
    double hue_ = 0, saturation_ = 0, value_ = 1;
    bool inBar_ = false;
};

double strengthOf(glm::dvec3 c)
{
    return std::max({1.0, c.x, c.y, c.z});
}

class ColourPopup : public QFrame {
public:
    ColourPopup(ColourField* owner, const QString& title, bool glow) : QFrame(owner, Qt::Popup), owner_(owner), linear_(owner->linear())
    {
        setObjectName("popup");
        setAttribute(Qt::WA_DeleteOnClose);
        setAccessibleName(title);
        auto* box = new QVBoxLayout(this);
        box->setContentsMargins(10, 10, 10, 10);
        box->setSpacing(6);
        square_ = new HueSquare(this);
        square_->changed = [this](const QColor& c, bool done) { set(unitOf(c), strengthOf(linear_), done); };
        box->addWidget(square_);
        auto* form = new QFormLayout;
        form->setVerticalSpacing(4);
        box->addLayout(form);
        makeHex(form);
        makeBoxes(form);
        if (glow) makeStrength(form);
        showColour();
    }

private:
    static glm::dvec3 unitOf(const QColor& c) { return {linearFromSrgb(c.redF()), linearFromSrgb(c.greenF()), linearFromSrgb(c.blueF())}; }
    void makeHex(QFormLayout* form)
    {
        hex_ = new QLineEdit(this);
        hex_->setObjectName("colourHex");
        hex_->setAccessibleName("sRGB as #rrggbb");
        hex_->setToolTip("As screens and pictures have it (sRGB).");
        form->addRow("sRGB", hex_);
        connect(hex_, &QLineEdit::editingFinished, this, [this] {
            const QString text = hex_->text().trimmed();
            const QColor c(text.startsWith('#') ? text : "#" + text);
            if (!c.isValid() || c == screenColour(linear_)) return showColour();
            hex_->setModified(false);
            set(unitOf(c), strengthOf(linear_), true);
        });
    }
    void makeBoxes(QFormLayout* form)
    {
        auto* line = new QHBoxLayout;
        line->setSpacing(4);
        for (int i = 0; i < 3; ++i) {
            NumberBox* b = boxes_[size_t(i)] = new NumberBox(this);
            b->setRange(0, 1);
            b->setSingleStep(0.01);
            b->setFixedWidth(50);
            b->setAccessibleName(QString("Linear ") + QStringList{"red", "green", "blue"}[i]);
            b->setToolTip("Linear light, 0 to 1, as the material keeps it.");
            line->addWidget(b);
            connect(b, &NumberBox::valueChanged, this, [this, i](double v) {
                if (showing_) return;
                glm::dvec3 unit = linear_ / strengthOf(linear_);
                unit[i] = v;
                set(unit, strengthOf(linear_), true);
            });
        }
        form->addRow("Linear", line);
    }
    void makeStrength(QFormLayout* form)
    {
        strength_ = new NumberBox(this);
        strength_->setRange(1, 1e6);
        strength_->setAccessibleName("Strength");
        strength_->setToolTip("Factor on the colour; above 1 it glows.");
        form->addRow("Strength", strength_);
        connect(strength_, &NumberBox::valueChanged, this, [this](double v) {
            if (!showing_) set(linear_ / strengthOf(linear_), v, true);
        });
    }

    void showColour()
    {
        showing_ = true;
        const double s = strengthOf(linear_);
        const QColor c = screenColour(linear_);
        square_->setColour(c);
        if (!hex_->hasFocus() || !hex_->isModified()) hex_->setText(c.name().toUpper());
        for (int i = 0; i < 3; ++i) boxes_[size_t(i)]->setValue(linear_[i] / s);
        if (strength_) strength_->setValue(s);
        showing_ = false;
    }
    /// `done`: no drag that goes on.
    void set(glm::dvec3 unit, double strength, bool done)
    {
        linear_ = unit * strength;
        showColour();
        if (done)
            emit owner_->committed(linear_);
        else
            emit owner_->edited(linear_);
    }

    ColourField* owner_;
    HueSquare* square_;
    QLineEdit* hex_;
    std::array<NumberBox*, 3> boxes_{};
    NumberBox* strength_ = nullptr;  ///< of what glows
    glm::dvec3 linear_;
    bool showing_ = false;
};

}  // namespace

QColor screenColour(glm::dvec3 c)
{
    c /= strengthOf(c);
    return QColor(int(std::lround(255 * srgbFromLinear(c.x))), int(std::lround(255 * srgbFromLinear(c.y))),
                  int(std::lround(255 * srgbFromLinear(c.z))));
}

QIcon swatch(glm::dvec3 linear, qreal ratio)
{
    QPixmap picture(QSize(16, 16) * ratio);
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    QPainter p(&picture);
    p.setRenderHint(QPainter::Antialiasing);
    p.setPen(QPen(look::tone().strong, 1));
    p.setBrush(screenColour(linear));
    p.drawRoundedRect(QRectF(1.5, 1.5, 13, 13), 3, 3);
    return QIcon(picture);
}

ColourField::ColourField(const QString& title, bool glow, QWidget* parent) : QPushButton(parent), title_(title), glow_(glow)
{
    setFocusPolicy(Qt::TabFocus);
    setFixedHeight(24);
    setMinimumWidth(90);
    connect(this, &QPushButton::clicked, this, [this] { openPopup(); });
    setLinear({0, 0, 0});
}

void ColourField::setLinear(glm::dvec3 linear)
{
    linear_ = linear;
    const QString name = screenColour(linear).name().toUpper();
    setAccessibleName(title_ + " " + name);
    setToolTip(QString("%1. %2 in sRGB; linear %3, %4, %5. Click to change.")
                   .arg(title_, name, look::number(linear.x), look::number(linear.y), look::number(linear.z)));
    update();
}

void ColourField::openPopup()
{
    auto* popup = new ColourPopup(this, title_, glow_);
    popup->adjustSize();
    const QRect screen = this->screen()->availableGeometry();
    QPoint at = mapToGlobal(QPoint(0, height() + 2));
    at.setX(std::clamp(at.x(), screen.left(), std::max(screen.left(), screen.right() - popup->width())));
    if (at.y() + popup->height() > screen.bottom()) at.setY(mapToGlobal(QPoint(0, 0)).y() - popup->height() - 2);
    popup->move(at);
    popup->show();
}

void ColourField::paintEvent(QPaintEvent*)
{
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    p.setPen(QPen(hasFocus() ? look::tone().accentText : look::tone().border, 1));
    p.setBrush(look::tone().field);
    p.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    p.setPen(QPen(look::tone().strong, 1));
    p.setBrush(screenColour(linear_));
    p.drawRoundedRect(QRectF(4.5, 4.5, 31, height() - 9), 2, 2);
    p.setPen(look::tone().text);
    const double s = strengthOf(linear_);
    const QString text = screenColour(linear_).name().toUpper() + (s > 1 ? " × " + look::number(s) : QString());
    p.drawText(QRect(42, 0, width() - 46, height()), Qt::AlignVCenter, p.fontMetrics().elidedText(text, Qt::ElideRight, width() - 46));
}

}  // namespace mw
