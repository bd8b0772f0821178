#include "ui/theme.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QRegularExpression>
#include <QStyleFactory>
#include <QSvgRenderer>

static void initResources()
{
    Q_INIT_RESOURCE(ui);  // a static library's resources are not found by themselves
}

namespace mw {
namespace {

Theme theTheme = Theme::Dark;

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
    return text;
}

// Draws the SVG at whatever size and ratio is asked for.
class TintedEngine : public QIconEngine {
public:
    TintedEngine(QString name, QColor color) : name_(std::move(name)), color_(color) {}
    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        const Tokens& t = tokens();
        if (mode == QIcon::Disabled) painter->setOpacity(0.45);
        const QColor c = color_.isValid() ? color_ : mode == QIcon::Selected ? t.selectionText : t.text;
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
    QIconEngine* clone() const override { return new TintedEngine(name_, color_); }

private:
    QString name_;
    QColor color_;
};

}  // namespace

const Tokens& tokens()
{
    static const Tokens dark{"#1B1D20", "#24272B", "#2E3237", "#17191C", "#363B41", "#3D434A", "#7B838D", "#E6E8EB", "#AEB5BD",
                             "#7C848D", "#2F6FC4", "#6CB2FF", "#27507D", "#FFFFFF", "#F2B84B", "#FF7B72", "#4CC38A"};
    static const Tokens light{"#D5D9DE", "#F4F5F7", "#E6E9ED", "#FFFFFF", "#DADFE5", "#C3C9D0", "#7D8690", "#1C2126", "#4A535D",
                              "#8A929B", "#1F63B5", "#1A5CAA", "#C9DFF7", "#0E2A47", "#7D5200", "#B3261E", "#17693A"};
    return theTheme == Theme::Dark ? dark : light;
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
