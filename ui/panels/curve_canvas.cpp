#include "ui/panels/curve_canvas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "ui/look.h"
#include "ui/theme.h"

namespace mw {
namespace {

constexpr double grabReach = 9, segmentReach = 8;  // pixels

double distanceToSegment(QPointF p, QPointF a, QPointF b)
{
    const QPointF d = b - a;
    const double length = QPointF::dotProduct(d, d);
    const double t = length > 0 ? std::clamp(QPointF::dotProduct(p - a, d) / length, 0.0, 1.0) : 0;
    const QPointF off = p - (a + t * d);
    return std::hypot(off.x(), off.y());
}

/// A box in a corner of another, 4 from its sides.
QRect cornered(QSize size, Qt::Corner corner, const QRect& within)
{
    QRect box({}, size);
    const bool right = corner == Qt::TopRightCorner || corner == Qt::BottomRightCorner;
    const bool low = corner == Qt::BottomLeftCorner || corner == Qt::BottomRightCorner;
    box.moveTo(right ? within.right() - box.width() - 3 : 4, low ? within.bottom() - box.height() - 3 : 4);
    return box;
}

}  // namespace

CurveCanvas::CurveCanvas(QWidget* parent) : QWidget(parent)
{
    setObjectName("curveCanvas");
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(220, 180);
    setAccessibleName("Control polygon");
    setAccessibleDescription("Comma and full stop choose a point, arrows move it, Insert adds one after it, Delete removes it");
    setToolTip("Click: add a point. Drag: move it, with Shift along one axis. Alt and click: remove it. Home: fit");
}

QColor CurveCanvas::colorOf(size_t iteration)
{
    const bool dark = look::dark();
    static const QColor onDark[] = {"#E6E8EB", "#6CB2FF", "#FF7A6E", "#C9A2FF", "#4FD99A", "#FFC35C", "#5FD6E8", "#F58CC6"};
    static const QColor onLight[] = {"#1C2126", "#1F6FC4", "#D32F2F", "#7A5BD0", "#14935A", "#B56A00", "#117E8F", "#B01E7A"};
    return iteration == 0 ? (dark ? onDark[0] : onLight[0]) : (dark ? onDark : onLight)[1 + (iteration - 1) % 7];
}

void CurveCanvas::setPolygon(Points points, bool closed)
{
    const Points before = std::exchange(points_, std::move(points));
    closed_ = closed;
    selected_ = std::min(selected_, int(points_.size()) - 1);
    if (before.empty()) fit();
    for (size_t i = 0; i < points_.size(); ++i)
        if (i >= before.size() || before[i] != points_[i]) keepInSight(int(i));
    update();
}

// Not while it is dragged: it would run away under the pointer.
void CurveCanvas::keepInSight(int point)
{
    if (dragged_ < 0 && !QRectF(rect()).contains(placeOf(points_[size_t(point)]))) fit();
}

void CurveCanvas::setIterations(std::vector<Points> iterations)
{
    const bool grows = iterations.size() != iterations_.size();
    iterations_ = std::move(iterations);
    if (grows && fitted_) fit();  // so does the legend
    update();
}

void CurveCanvas::setSelected(int point)
{
    const int now = std::clamp(point, -1, int(points_.size()) - 1);
    if (now == selected_) return;
    selected_ = now;
    update();
    emit selectionChanged(selected_);
}

void CurveCanvas::fit()
{
    if (points_.empty() || width() < 20) return;
    glm::dvec2 low = points_[0], high = points_[0];
    for (const glm::dvec2& p : points_) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::dvec2 extent = glm::max(high - low, glm::dvec2(1e-6));
    const double strip = legendSize().height() < height() / 2 ? legendSize().height() : 0;  // the legend's, above
    scale_ = 0.75 * std::min(width() / extent.x, (height() - strip) / extent.y);
    centre_ = 0.5 * (low + high) + glm::dvec2(0, 0.5 * strip / scale_);
    fitted_ = true;
    update();
}

QPointF CurveCanvas::placeOf(glm::dvec2 p) const
{
    return {0.5 * width() + scale_ * (p.x - centre_.x), 0.5 * height() - scale_ * (p.y - centre_.y)};
}

glm::dvec2 CurveCanvas::at(QPointF place) const
{
    return centre_ + glm::dvec2(place.x() - 0.5 * width(), 0.5 * height() - place.y()) / scale_;
}

int CurveCanvas::pointAt(QPointF place) const
{
    int best = -1;
    double least = grabReach;
    for (size_t i = 0; i < points_.size(); ++i) {
        const QPointF off = placeOf(points_[i]) - place;
        const double d = std::hypot(off.x(), off.y());
        if (d > least) continue;
        least = d;
        best = int(i);
    }
    return best;
}

/// Where in the order a new point goes: within the segment that is near, else at the end.
size_t CurveCanvas::placeFor(QPointF place) const
{
    const size_t n = points_.size();
    size_t best = n;
    double least = segmentReach;
    for (size_t i = 0; i + (closed_ ? 0 : 1) < n; ++i) {
        const double d = distanceToSegment(place, placeOf(points_[i]), placeOf(points_[(i + 1) % n]));
        if (d > least) continue;
        least = d;
        best = i + 1;
    }
    return best;
}

void CurveCanvas::addPoint(size_t index, glm::dvec2 p, bool drag)
{
    points_.insert(points_.begin() + ptrdiff_t(index), p);
    setSelected(int(index));
    added_ = drag;
    emit edited(drag ? QString() : QString("add point %1").arg(index + 1));
    update();
}

void CurveCanvas::removePoint(int point)
{
    if (point < 0 || point >= int(points_.size())) return;
    points_.erase(points_.begin() + point);
    selected_ = -1;
    setSelected(std::min(point, int(points_.size()) - 1));
    emit edited(QString("remove point %1").arg(point + 1));
    update();
}

void CurveCanvas::mousePressEvent(QMouseEvent* e)
{
    setFocus(Qt::MouseFocusReason);
    last_ = e->position();
    if (e->button() == Qt::MiddleButton) {
        panning_ = true;
        return;
    }
    if (e->button() != Qt::LeftButton) return;
    const int hit = pointAt(e->position());
    if (e->modifiers() & Qt::AltModifier) {
        removePoint(hit);
        return;
    }
    moved_ = false;
    added_ = false;
    dragged_ = hit;
    if (hit < 0) {
        const size_t index = placeFor(e->position());
        addPoint(index, at(e->position()), true);
        dragged_ = int(index);
    }
    setSelected(dragged_);
    dragStart_ = points_[size_t(dragged_)];
}

void CurveCanvas::mouseMoveEvent(QMouseEvent* e)
{
    if (panning_) {
        const QPointF by = e->position() - last_;
        centre_ -= glm::dvec2(by.x(), -by.y()) / scale_;
        fitted_ = false;
        last_ = e->position();
        update();
        return;
    }
    if (dragged_ < 0) {
        const int over = pointAt(e->position());
        if (over != hovered_) update();
        hovered_ = over;
        return;
    }
    if (!moved_ && (e->position() - last_).manhattanLength() < 2) return;
    moved_ = true;
    glm::dvec2 to = at(e->position());
    if (e->modifiers() & Qt::ShiftModifier) {
        const glm::dvec2 by = glm::abs(to - dragStart_);
        (by.x >= by.y ? to.y : to.x) = by.x >= by.y ? dragStart_.y : dragStart_.x;
    }
    points_[size_t(dragged_)] = to;
    emit edited({});
    update();
}

void CurveCanvas::mouseReleaseEvent(QMouseEvent* e)
{
    if (e->button() == Qt::MiddleButton) panning_ = false;
    if (e->button() != Qt::LeftButton || dragged_ < 0) return;
    const int point = dragged_;
    dragged_ = -1;
    keepInSight(point);
    if (moved_ || added_) emit edited(QString(added_ ? "add point %1" : "move point %1").arg(point + 1));
}

void CurveCanvas::wheelEvent(QWheelEvent* e)
{
    const glm::dvec2 before = at(e->position());
    scale_ = std::clamp(scale_ * std::pow(1.0015, double(e->angleDelta().y())), 1e-3, 1e7);
    centre_ += before - at(e->position());
    fitted_ = false;
    update();
    e->accept();
}

void CurveCanvas::keyPressEvent(QKeyEvent* e)
{
    const int n = int(points_.size());
    const double step = (e->modifiers() & Qt::ShiftModifier ? 10 : 1) / scale_;
    const auto move = [&](double x, double y) {
        if (selected_ < 0) return;
        points_[size_t(selected_)] += glm::dvec2(x, y) * step;
        keepInSight(selected_);
        emit edited(QString("move point %1").arg(selected_ + 1));
        update();
    };
    switch (e->key()) {
        case Qt::Key_Left:
            return move(-1, 0);
        case Qt::Key_Right:
            return move(1, 0);
        case Qt::Key_Up:
            return move(0, 1);
        case Qt::Key_Down:
            return move(0, -1);
        case Qt::Key_Period:
            return setSelected(n ? (selected_ + 1) % n : -1);
        case Qt::Key_Comma:
            return setSelected(n ? (selected_ + n - 1 + (selected_ < 0)) % n : -1);
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            return removePoint(selected_);
        case Qt::Key_Insert: {
            const size_t from = size_t(std::max(0, selected_)), to = n ? (from + 1) % size_t(n) : 0;
            const glm::dvec2 p = n == 0 ? centre_ : 0.5 * (points_[from] + points_[to]);
            return addPoint(n == 0 ? 0 : from + 1, p, false);
        }
        case Qt::Key_Home:
            return fit();
        default:
            QWidget::keyPressEvent(e);
    }
}

void CurveCanvas::resizeEvent(QResizeEvent*)
{
    fit();
}

QSize CurveCanvas::legendSize() const
{
    const QFontMetrics m(font());
    return {30 + m.horizontalAdvance("Iteration 10: N = 10,240"), (m.height() + 2) * int(iterations_.size() + 1) + 6};
}

QRect CurveCanvas::legend() const
{
    return cornered(legendSize(), legendCorner_, rect());
}

/// Where the legend hides the fewest points: of the polygon first, then of the curve.
Qt::Corner CurveCanvas::freeCorner() const
{
    const auto hidden = [this](Qt::Corner corner) {
        const QRectF box = cornered(legendSize(), corner, rect()).adjusted(-8, -8, 8, 8);
        const auto inside = [&](const Points& points) {
            return std::count_if(points.begin(), points.end(), [&](const glm::dvec2& q) { return box.contains(placeOf(q)); });
        };
        return std::pair(inside(points_), iterations_.empty() ? 0 : inside(iterations_.back()));
    };
    Qt::Corner best = Qt::TopLeftCorner;
    for (const Qt::Corner c : {Qt::TopRightCorner, Qt::BottomLeftCorner, Qt::BottomRightCorner})
        if (hidden(c) < hidden(best)) best = c;
    return best;
}

void CurveCanvas::paintLegend(QPainter& p)
{
    if (dragged_ < 0) legendCorner_ = freeCorner();
    const QFontMetrics m(font());
    const QRect box = legend();
    QColor ground = tokens().field;
    ground.setAlphaF(0.8f);  // the polygon may run behind it
    p.fillRect(box, ground);
    int y = box.top() + 4;
    for (size_t k = 0; k <= iterations_.size(); ++k) {
        const size_t n = k == 0 ? points_.size() : iterations_[k - 1].size();
        const QString text = (k == 0 ? QString("Polygon") : QString("Iteration %1").arg(k)) + ": N = " + look::count(n);
        p.setPen(QPen(colorOf(k), k == 0 ? 1.5 : 2.5));
        p.drawLine(QPointF(box.left() + 6, y + 0.5 * m.height()), QPointF(box.left() + 22, y + 0.5 * m.height()));
        p.setPen(tokens().text);
        p.drawText(box.left() + 30, y + m.ascent(), text);
        y += m.height() + 2;
    }
}

void CurveCanvas::paintEvent(QPaintEvent*)
{
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    p.fillRect(rect(), tokens().field);
    const auto line = [&](const Points& points) {
        QPolygonF out;
        for (const glm::dvec2& q : points) out << placeOf(q);
        if (closed_)
            p.drawPolygon(out);
        else
            p.drawPolyline(out);
    };
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(colorOf(0), 1.5));
    line(points_);
    for (size_t k = 0; k < iterations_.size(); ++k) {
        p.setPen(QPen(colorOf(k + 1), k + 1 == iterations_.size() ? 2.5 : 1.5));
        line(iterations_[k]);
        if (iterations_[k].size() > 40) continue;
        p.setBrush(colorOf(k + 1));
        for (const glm::dvec2& q : iterations_[k]) p.drawEllipse(placeOf(q), 2, 2);
        p.setBrush(Qt::NoBrush);
    }
    for (size_t i = 0; i < points_.size(); ++i) {
        const bool chosen = int(i) == selected_;
        p.setPen(QPen(tokens().field, 1));
        p.setBrush(chosen ? tokens().warning : colorOf(0));
        const double r = chosen || int(i) == hovered_ ? 6 : 4.5;
        p.drawEllipse(placeOf(points_[i]), r, r);
        p.setPen(tokens().text2);
        p.drawText(placeOf(points_[i]) + QPointF(8, -6), QString::number(i + 1));
    }
    paintLegend(p);
    if (hasFocus()) {
        p.setBrush(Qt::NoBrush);
        p.setPen(tokens().accent);
        p.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

}  // namespace mw
