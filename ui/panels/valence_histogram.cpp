// See valence_histogram.h.
#include "ui/panels/valence_histogram.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "ui/look.h"

namespace mw {

namespace {
constexpr size_t mostBars = 11;
}

ValenceHistogram::ValenceHistogram(QWidget* parent) : QWidget(parent)
{
    setObjectName("valence-histogram");
    setAccessibleName(tr("Vertices by valence"));
    setMouseTracking(true);
    setFocusPolicy(Qt::TabFocus);
    setFixedHeight(76);
}

void ValenceHistogram::setValences(const std::map<size_t, size_t>& valences)
{
    bars_.clear();
    for (const auto& [valence, n] : valences) {
        if (valence == 0) continue;
        // Every valence between gets its place, so that the shape is true; the long tail is one bar.
        while (!bars_.empty() && bars_.size() < mostBars && bars_.back().valence + 1 < valence) bars_.push_back({bars_.back().valence + 1, 0, false});
        if (bars_.size() < mostBars)
            bars_.push_back({valence, n, false});
        else
            bars_.back().count += n, bars_.back().orMore = true;
    }
    QStringList words;
    for (int i = 0; i < int(bars_.size()); ++i) words << textOf(i);
    setAccessibleDescription(words.join(", "));
    current_ = 0;
    update();
}

void ValenceHistogram::setFaces()
{
    faces_ = true;
    setAccessibleName(tr("Faces by number of corners"));
}

QString ValenceHistogram::textOf(int i) const
{
    const Bar& b = bars_[size_t(i)];
    const QString count = faces_ ? look::counted(b.count, tr("face"), tr("faces")) : look::counted(b.count, tr("vertex"), tr("vertices"));
    return (faces_ ? tr("%1 of %2%3 corners") : tr("%1 of valence %2%3")).arg(count).arg(b.valence).arg(b.orMore ? tr(" or more") : QString());
}

QRect ValenceHistogram::barCell(int i) const
{
    const int n = std::max(1, int(bars_.size())), w = std::min(44, (width() - 16) / n);
    return {8 + i * w, 4, w, height() - 8};
}

int ValenceHistogram::barAt(QPoint p) const
{
    for (int i = 0; i < int(bars_.size()); ++i)
        if (barCell(i).contains(p)) return i;
    return -1;
}

void ValenceHistogram::paintEvent(QPaintEvent*)
{
    const look::Tones& t = look::tone();
    QPainter p(this);
    size_t most = 1;
    for (const Bar& b : bars_) most = std::max(most, b.count);
    const int text = fontMetrics().height();
    for (int i = 0; i < int(bars_.size()); ++i) {
        const QRect cell = barCell(i);
        const Bar& b = bars_[size_t(i)];
        const int room = cell.height() - text - 2;
        const int h = b.count == 0 ? 0 : std::max(1, int(double(room) * double(b.count) / double(most)));
        if (i == hovered_) p.fillRect(cell, t.hover);
        p.fillRect(cell.left() + 3, cell.top() + room - h, cell.width() - 6, h, b.count == most ? t.accentText : t.strong);
        p.setPen(t.text2);
        p.drawText(QRect(cell.left() - 4, cell.bottom() - text + 1, cell.width() + 8, text), Qt::AlignCenter,
                   QString::number(b.valence) + (b.orMore ? "+" : ""));
        if (hasFocus() && i == current_) {
            p.setPen(QPen(t.accentText, 2));
            p.drawRect(cell.adjusted(1, 1, -1, -1));
        }
    }
}

void ValenceHistogram::mouseMoveEvent(QMouseEvent* e)
{
    const int at = barAt(e->pos());
    if (at == hovered_) return;
    hovered_ = at;
    setCursor(at >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    setToolTip(at >= 0 ? textOf(at) + tr(". Click selects them.") : QString());
    update();
}

void ValenceHistogram::mouseReleaseEvent(QMouseEvent* e)
{
    const int at = barAt(e->pos());
    if (e->button() != Qt::LeftButton || at < 0) return;
    current_ = at;
    emit barClicked(bars_[size_t(at)].valence, bars_[size_t(at)].orMore);
}

void ValenceHistogram::keyPressEvent(QKeyEvent* e)
{
    const int step = e->key() == Qt::Key_Right ? 1 : e->key() == Qt::Key_Left ? -1 : 0;
    if (bars_.empty()) return QWidget::keyPressEvent(e);
    if (step != 0)
        current_ = std::clamp(current_ + step, 0, int(bars_.size()) - 1);
    else if (e->key() == Qt::Key_Return || e->key() == Qt::Key_Space)
        emit barClicked(bars_[size_t(current_)].valence, bars_[size_t(current_)].orMore);
    else
        return QWidget::keyPressEvent(e);
    update();
}

void ValenceHistogram::leaveEvent(QEvent*)
{
    hovered_ = -1;
    update();
}

}  // namespace mw
