#include "ui/theme.h"

#include <QApplication>
#include <QFile>
#include <QFontMetrics>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSettings>
#include <QStyleFactory>
#include <QSvgRenderer>
#include <algorithm>
#include <optional>
#include <utility>

#include "core/math/srgb.h"

static void initResources()
{
    Q_INIT_RESOURCE(ui);  // a static library's resources are not found by themselves
}

namespace mw {
namespace {

Theme theTheme = Theme::Dark;
QPalette systemPalette;
std::optional<Tokens> contrastTokens;  // of the system's palette, while that is to be used as it is

struct Named {
    const char* name;
    QColor Tokens::*color;
};
constexpr Named allTokens[] = {{"window", &Tokens::window},       {"panel", &Tokens::panel},
                               {"raised", &Tokens::raised},       {"field", &Tokens::field},
                               {"hover", &Tokens::hover},         {"border", &Tokens::border},
                               {"strong", &Tokens::strong},       {"text", &Tokens::text},
                               {"text2", &Tokens::text2},         {"text3", &Tokens::text3},
                               {"accent", &Tokens::accent},       {"accentText", &Tokens::accentText},
                               {"selection", &Tokens::selection}, {"selectionText", &Tokens::selectionText},
                               {"warning", &Tokens::warning},     {"error", &Tokens::error},
                               {"success", &Tokens::success}};

QPalette paletteOf(const Tokens& t)
{
    QPalette p;
    p.setColor(QPalette::Window, t.panel);
    p.setColor(QPalette::WindowText, t.text);
    p.setColor(QPalette::Base, t.field);
    p.setColor(QPalette::AlternateBase, t.panel);
    p.setColor(QPalette::Text, t.text);
    p.setColor(QPalette::PlaceholderText, t.text2);
    p.setColor(QPalette::Button, t.raised);
    p.setColor(QPalette::ButtonText, t.text);
    p.setColor(QPalette::BrightText, t.error);
    p.setColor(QPalette::ToolTipBase, t.raised);
    p.setColor(QPalette::ToolTipText, t.text);
    p.setColor(QPalette::Highlight, t.selection);
    p.setColor(QPalette::HighlightedText, t.selectionText);
    p.setColor(QPalette::Link, t.accentText);
    p.setColor(QPalette::LinkVisited, t.accentText);
    p.setColor(QPalette::Light, t.hover);
    p.setColor(QPalette::Midlight, t.raised);
    p.setColor(QPalette::Mid, t.border);
    p.setColor(QPalette::Dark, t.window);
    p.setColor(QPalette::Shadow, t.window);
    for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
        p.setColor(QPalette::Disabled, role, t.text3);
    return p;
}

QString styleSheet(const Tokens& t)
{
    QFile file(":/meshwright/style.qss");
    if (!file.open(QIODevice::ReadOnly)) return {};
    QString text = QString::fromUtf8(file.readAll());
    for (const Named& n : allTokens) text.replace(QString("@%1@").arg(n.name), (t.*n.color).name());
    // A style sheet cannot tint a picture: the arrow of a combo comes in two colours.
    text.replace("@theme@", t.panel.lightness() < 128 ? "dark" : "light");
    text.replace("@pressed@", t.raised.darker(108).name());
    const int line = QFontMetrics(QApplication::font()).height();
    for (const auto& [name, least] : {std::pair("button", 18), {"field", 20}, {"row", 24}})
        text.replace(QString("@%1Line@").arg(name), QString::number(std::max(least, line)));
    return text;
}

// White is no token here: it is also drawn on the accent, in every theme.
QColor Tokens::*tokenOf(const QColor& color)
{
    if (!color.isValid() || color == Qt::white) return nullptr;
    for (const Named& n : allTokens)
        if (tokens().*n.color == color) return n.color;
    return nullptr;
}

// Draws the SVG at whatever size and ratio is asked for.
class TintedEngine : public QIconEngine {
public:
    TintedEngine(QString name, QColor color) : TintedEngine(std::move(name), color, tokenOf(color)) {}
    TintedEngine(QString name, QColor color, QColor Tokens::*token) : name_(std::move(name)), color_(color), token_(token) {}
    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        const Tokens& t = tokens();
        if (mode == QIcon::Disabled) painter->setOpacity(0.45);
        const QColor c = token_ ? t.*token_ : color_.isValid() ? color_ : mode == QIcon::Selected ? t.selectionText : t.text;
        const qreal ratio = painter->device() ? painter->device()->devicePixelRatioF() : 1;
        painter->drawPixmap(rect, iconPixmap(name_, c, rect.width(), ratio));
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap p(size);
        p.fill(Qt::transparent);
        QPainter painter(&p);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return p;
    }
    QIconEngine* clone() const override { return new TintedEngine(name_, color_, token_); }

private:
    QString name_;
    QColor color_;
    QColor Tokens::*token_;
};

double luminance(const QColor& c)
{
    return 0.2126 * linearFromSrgb(c.redF()) + 0.7152 * linearFromSrgb(c.greenF()) + 0.0722 * linearFromSrgb(c.blueF());
}

// As WCAG 2 has it: 1 to 21.
double contrast(const QColor& a, const QColor& b)
{
    const double la = luminance(a), lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace

const Tokens& tokens()
{
    static const Tokens dark{"#1B1D20", "#24272B", "#2E3237", "#17191C", "#363B41", "#3D434A", "#7B838D", "#E6E8EB", "#AEB5BD",
                             "#7C848D", "#2F6FC4", "#6CB2FF", "#27507D", "#FFFFFF", "#F2B84B", "#FF7B72", "#4CC38A"};
    static const Tokens light{"#D5D9DE", "#F4F5F7", "#E6E9ED", "#FFFFFF", "#DADFE5", "#C3C9D0", "#7D8690", "#1C2126", "#4A535D",
                              "#8A929B", "#1F63B5", "#1A5CAA", "#C9DFF7", "#0E2A47", "#7D5200", "#B3261E", "#17693A"};
    return contrastTokens ? *contrastTokens : theTheme == Theme::Dark ? dark : light;
}

Theme currentTheme()
{
    return theTheme;
}

void applyTheme(QApplication& app, Theme theme)
{
    initResources();
    theTheme = theme;
    app.setStyle(QStyleFactory::create("Fusion"));
    app.setPalette(paletteOf(tokens()));
    app.setStyleSheet(styleSheet(tokens()));
}

void followSystemPalette(const QPalette& system)
{
    systemPalette = system;
}

bool isHighContrast(const QPalette& p)
{
    const auto extreme = [](const QColor& c) { return c.lightness() <= 4 || c.lightness() >= 251; };
    return extreme(p.color(QPalette::Window)) && contrast(p.color(QPalette::Window), p.color(QPalette::WindowText)) > 18;
}

Tokens tokensOf(const QPalette& p)
{
    const QColor text = p.color(QPalette::WindowText), window = p.color(QPalette::Window), mark = p.color(QPalette::Highlight);
    const QColor link = contrast(p.color(QPalette::Link), window) > 7 ? p.color(QPalette::Link) : text;
    Tokens t;
    t.window = t.panel = window;
    t.raised = p.color(QPalette::Button);
    t.field = p.color(QPalette::Base);
    t.hover = t.raised;
    t.border = t.strong = t.text = t.text2 = text;
    t.text3 = p.color(QPalette::Disabled, QPalette::WindowText);
    t.accent = t.selection = mark;
    t.accentText = link;
    t.selectionText = p.color(QPalette::HighlightedText);
    t.warning = t.error = t.success = text;  // the icon beside it says which
    return t;
}

ThemeChoice themeChoice()
{
    const QString kept = QSettings().value("view/theme", "dark").toString();
    return kept == "system" ? ThemeChoice::System : kept == "light" ? ThemeChoice::Light : ThemeChoice::Dark;
}

void chooseTheme(QApplication& app, ThemeChoice choice)
{
    QSettings().setValue("view/theme", choice == ThemeChoice::System ? "system" : choice == ThemeChoice::Light ? "light" : "dark");
    const bool system = choice == ThemeChoice::System;
    const bool light = system ? systemPalette.color(QPalette::Window).lightness() > 127 : choice == ThemeChoice::Light;
    contrastTokens.reset();
    if (system && isHighContrast(systemPalette)) contrastTokens = tokensOf(systemPalette);
    applyTheme(app, light ? Theme::Light : Theme::Dark);
}

bool reducedMotion()
{
    return QSettings().value("view/reducedMotion", false).toBool();
}

void setReducedMotion(bool on)
{
    QSettings().setValue("view/reducedMotion", on);
}

IconLabel::IconLabel(QString name, QColor Tokens::*color, QWidget* parent, int size)
    : QWidget(parent), name_(std::move(name)), color_(color), size_(size)
{
    setFixedSize(size, size);
}

void IconLabel::set(const QString& name, QColor Tokens::*color)
{
    name_ = name;
    color_ = color;
    update();
}

void IconLabel::paintEvent(QPaintEvent*)
{
    QPainter p(this);
    p.drawPixmap(0, 0, iconPixmap(name_, tokens().*color_, size_, devicePixelRatioF()));
}

QPixmap iconPixmap(const QString& name, const QColor& color, int size, qreal ratio)
{
    QPixmap p(QSize(size, size) * ratio);
    p.fill(Qt::transparent);
    QFile file(":/meshwright/icons/" + name + ".svg");
    if (!file.open(QIODevice::ReadOnly)) return p;
    QByteArray svg = file.readAll();
    svg.replace("currentColor", color.name().toLatin1());
    QSvgRenderer renderer(svg);
    QPainter painter(&p);
    renderer.render(&painter);
    painter.end();
    p.setDevicePixelRatio(ratio);
    return p;
}

QIcon icon(const QString& name, const QColor& color)
{
    return QIcon(new TintedEngine(name, color));
}

}  // namespace mw
