// See look.h.
#include "ui/look.h"

#include <QApplication>
#include <QFontDatabase>
#include <QHash>
#include <QLabel>
#include <QLocale>
#include <QMainWindow>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSvgRenderer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace mw::look {

namespace {

// 16 grid, line 1.4, round ends.
QByteArray shapeOf(const QString& name)
{
    if (name == "first") return "<path d='M3.5 3v10' /><path d='M12.5 3.2v9.6L5.5 8z' fill='C'/>";
    if (name == "last") return "<path d='M12.5 3v10' /><path d='M3.5 3.2v9.6L10.5 8z' fill='C'/>";
    if (name == "back") return "<path d='M11 3.2v9.6L4.5 8z' fill='C'/>";
    if (name == "next") return "<path d='M5 3.2v9.6L11.5 8z' fill='C'/>";
    if (name == "play") return "<path d='M4.5 2.6v10.8L13 8z' fill='C'/>";
    if (name == "pause") return "<path d='M4.5 3h2v10h-2zM9.5 3h2v10h-2z' fill='C'/>";
    return {};
}

}  // namespace

bool dark()
{
    return currentTheme() == Theme::Dark;
}

const Tones& tone()
{
    return tokens();
}

QColor roleColor(Role r)
{
    static const QColor marks[] = {"#FFE14D", "#86B7DC", "#31F0A8", "#FC422F", "#BE46E1"};
    return marks[size_t(r)];
}

QColor roleTextColor(Role r)
{
    static const QColor onDark[] = {"#FFE14D", "#86B7DC", "#31F0A8", "#FF7B6B", "#D98CF2"};
    static const QColor onLight[] = {"#7A5E00", "#1F5F93", "#0E6B45", "#B3261E", "#8A21AE"};
    return dark() ? onDark[size_t(r)] : onLight[size_t(r)];
}

QString roleName(Role r)
{
    switch (r) {
        case Role::Current:
            return QObject::tr("Current");
        case Role::Neighbour:
            return QObject::tr("Neighbour");
        case Role::New:
            return QObject::tr("New");
        case Role::Removed:
            return QObject::tr("Removed");
        case Role::Rejected:
            return QObject::tr("Rejected");
    }
    return {};
}

void paintRole(QPainter& p, Role r, const QRectF& box)
{
    p.save();
    p.setRenderHint(QPainter::Antialiasing);
    const QColor c = roleColor(r), edge("#101215");
    const QPointF m = box.center();
    auto line = [&](double x0, double y0, double x1, double y1, Qt::PenStyle style) {
        p.setPen(QPen(edge, 5.5, Qt::SolidLine, Qt::FlatCap));
        p.drawLine(QPointF(x0 - 1, y0), QPointF(x1 + 1, y1));
        p.setPen(QPen(c, 3, style, Qt::FlatCap));
        p.drawLine(QPointF(x0, y0), QPointF(x1, y1));
    };
    if (r == Role::Current) line(box.left(), m.y(), box.right(), m.y(), Qt::SolidLine);
    if (r == Role::Rejected) {
        p.setPen(QPen(edge, 5.5, Qt::SolidLine, Qt::FlatCap));
        p.drawLine(QPointF(box.left() - 1, m.y()), QPointF(box.right() + 1, m.y()));
        p.setPen(QPen(c, 3, Qt::CustomDashLine, Qt::FlatCap));
        QPen dash(c, 3, Qt::CustomDashLine, Qt::FlatCap);
        dash.setDashPattern({1.4, 1.0});
        p.setPen(dash);
        p.drawLine(QPointF(box.left(), m.y()), QPointF(box.right(), m.y()));
    }
    if (r == Role::Neighbour) {
        p.setPen(QPen(edge, 1.4));
        p.setBrush(c);
        p.drawEllipse(m, 3.6, 3.6);
    }
    if (r == Role::New) {
        for (const auto& [color, width] : {std::pair(edge, 5.0), std::pair(c, 2.2)}) {
            p.setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap));
            p.drawLine(m - QPointF(5, 0), m + QPointF(5, 0));
            p.drawLine(m - QPointF(0, 5), m + QPointF(0, 5));
        }
    }
    if (r == Role::Removed) {
        const QRectF face(m.x() - 8, m.y() - 5, 16, 10);
        p.fillRect(face, c);
        p.setClipRect(face);
        p.setPen(QPen(edge, 1.6));
        for (double x = face.left() - 10; x < face.right(); x += 5) p.drawLine(QPointF(x, face.bottom()), QPointF(x + 10, face.top()));
    }
    p.restore();
}

QIcon icon(const QString& name, const QColor& color)
{
    const QColor c = color.isValid() ? color : tone().text;
    if (shapeOf(name).isEmpty()) return mw::icon(name, c);
    static QHash<QString, QIcon> known;
    QIcon& made = known[name + c.name() + (dark() ? 'd' : 'l')];
    if (!made.isNull()) return made;
    auto add = [&](const QColor& ink, QIcon::Mode mode) {
        QByteArray svg =
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 16 16' fill='none' stroke='C' stroke-width='1.4' "
            "stroke-linecap='round' stroke-linejoin='round'>" +
            shapeOf(name) + "</svg>";
        svg.replace("'C'", "'" + ink.name().toLatin1() + "'");
        for (int scale : {1, 2, 3}) {
            QPixmap picture(16 * scale, 16 * scale);
            picture.fill(Qt::transparent);
            QPainter p(&picture);
            QSvgRenderer(svg).render(&p);
            p.end();
            picture.setDevicePixelRatio(scale);
            made.addPixmap(picture, mode);
        }
    };
    add(c, QIcon::Normal);
    add(tone().text3, QIcon::Disabled);
    return made;
}

namespace {

QString plain(double v, int digits)
{
    const QLocale l;
    QString s = l.toString(v, 'f', digits);
    if (digits > 0) {
        while (s.endsWith(l.zeroDigit())) s.chop(1);
        if (s.endsWith(l.decimalPoint())) s.chop(1);
    }
    return s;
}

QString withMinus(QString s)
{
    return s.replace('-', QChar(0x2212));
}

QString significant(double v, int digits)
{
    if (std::isnan(v)) return QObject::tr("none");
    if (std::isinf(v)) return withMinus(v > 0 ? "∞" : "-∞");
    if (v == 0) return "0";
    const double size = std::abs(v);
    if (v == std::round(v) && size < 1e9) return withMinus(plain(v, 0));
    if (size >= 1e7 || size < 1e-5) {
        const int exponent = int(std::floor(std::log10(size)));
        static const QString raised = "⁰¹²³⁴⁵⁶⁷⁸⁹";
        QString power;
        for (QChar c : QString::number(std::abs(exponent))) power += raised[c.digitValue()];
        return withMinus(plain(v / std::pow(10.0, exponent), digits - 1)) + " · 10" + (exponent < 0 ? "⁻" : "") + power;
    }
    return withMinus(plain(v, std::clamp(digits - 1 - int(std::floor(std::log10(size))), 0, 8)));
}

}  // namespace

QString formatted(double v, const std::string& format, const std::vector<std::string>& words)
{
    if (!std::isfinite(v)) return number(v);
    if (format == "integer") return withMinus(plain(std::round(v), 0));
    if (format == "percent") return number(100 * v) + " %";
    if (format == "degrees") return withMinus(QLocale().toString(v, 'f', 1)) + "°";
    if (format == "words") {
        const auto i = size_t(std::max(0.0, std::round(v)));
        return i < words.size() ? QString::fromStdString(words[i]) : number(v);
    }
    const int digits = format.empty() ? 0 : format[0] - '0';
    if (format.ends_with("decimals")) return withMinus(QLocale().toString(v, 'f', digits));
    return significant(v, digits > 0 ? digits : 3);
}

QString number(double v)
{
    return significant(v, 3);
}

QString exactNumber(double v)
{
    return withMinus(QLocale().toString(v, 'g', 17));
}

QString count(size_t n)
{
    return QLocale().toString(qulonglong(n));
}

QString counted(size_t n, const QString& one, const QString& many)
{
    return count(n) + ' ' + (n == 1 ? one : many);
}

QFont monospace()
{
    QFont f = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    f.setPointSizeF(qApp->font().pointSizeF() * 0.88);
    return f;
}

QWidget* emptyState(QWidget* parent, QLabel** sentence, QPushButton** button)
{
    auto* page = new QWidget(parent);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(24, 24, 24, 24);
    column->setSpacing(12);
    *sentence = new QLabel(page);
    (*sentence)->setWordWrap(true);
    column->addWidget(*sentence);
    if (button) {
        *button = new QPushButton(page);
        (*button)->setFocusPolicy(Qt::TabFocus);
        column->addWidget(*button, 0, Qt::AlignLeft);
    }
    column->addStretch(1);
    return page;
}

void keepWide(QScrollArea* area)
{
    struct Keeper : QObject {
        explicit Keeper(QScrollArea* a) : QObject(a->widget()), area(a) { keep(); }
        bool eventFilter(QObject*, QEvent* e) override
        {
            if (e->type() == QEvent::LayoutRequest || e->type() == QEvent::Resize) keep();
            return false;
        }
        void keep() const
        {
            const int page = area->widget()->minimumSizeHint().width() + area->verticalScrollBar()->sizeHint().width() + 2 * area->frameWidth();
            const bool docked = qobject_cast<QMainWindow*>(area->window());
            area->setMinimumWidth(docked ? std::min(page, area->window()->width() / 3) : page);
        }
        QScrollArea* area;
    };
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    auto* keeper = new Keeper(area);
    area->widget()->installEventFilter(keeper);
    area->installEventFilter(keeper);
}

SectionBar::SectionBar(const QString& title, QWidget* parent) : QWidget(parent), title_(title)
{
    setFixedHeight(std::max(24, fontMetrics().height() + 6));
    setAccessibleName(title);
}

void SectionBar::setFigure(const QString& text)
{
    figure_ = text;
    update();
}

void SectionBar::setTitle(const QString& text)
{
    title_ = text;
    setAccessibleName(text);
    update();
}

void SectionBar::paintEvent(QPaintEvent*)
{
    QPainter p(this);
    p.fillRect(rect(), tone().raised);
    QFont bold = font();
    bold.setBold(true);
    p.setFont(bold);
    p.setPen(tone().text);
    const int x = 8, w = p.fontMetrics().horizontalAdvance(title_);
    p.drawText(QRect(x, 0, w + 4, height()), Qt::AlignVCenter, title_);
    p.setFont(font());
    p.setPen(tone().text2);
    p.drawText(QRect(x + w + 8, 0, width() - x - w - 16, height()), Qt::AlignVCenter,
               p.fontMetrics().elidedText(figure_, Qt::ElideRight, width() - x - w - 16));
}

}  // namespace mw::look
