#include "ui/panels/timeline_tracks.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "render/bones.h"
#include "ui/playback.h"
#include "ui/theme.h"
#include "ui/words.h"

namespace mw {
namespace {

constexpr double mergeBelow = 3, keyReach = 6;  // pixels
constexpr double largestFrame = 120;            // pixels a frame, at most

QString wordOf(const Channel& c)
{
    switch (c.interpolation) {
        case Channel::Interpolation::Step:
            return "step";
        case Channel::Interpolation::Cubic:
            return "cubic";
        case Channel::Interpolation::Linear:
            break;
    }
    return c.path == Channel::Path::Rotation ? "sph" : "lin";
}

/// The channel that speaks for a node: its rotation before anything else.
const Channel& speaker(const std::vector<const Channel*>& channels)
{
    for (const Channel* c : channels)
        if (c->path == Channel::Path::Rotation) return *c;
    return *channels.front();
}

/// Keys of several channels at the same time are one. Arrays of times that are shared are looked at once.
std::vector<Track::Key> merged(const std::vector<const Channel*>& channels)
{
    std::vector<Track::Key> keys;
    std::set<const void*> seen;
    for (const Channel* c : channels) {
        if (!seen.insert(c->times.id()).second) continue;
        for (const double t : c->times) keys.push_back({t, c->interpolation});
    }
    if (seen.size() > 1) std::stable_sort(keys.begin(), keys.end(), [](const Track::Key& a, const Track::Key& b) { return a.time < b.time; });
    const auto same = [](const Track::Key& a, const Track::Key& b) { return b.time - a.time < 1e-7; };
    keys.erase(std::unique(keys.begin(), keys.end(), same), keys.end());
    return keys;
}

QString frameText(double frame)
{
    const bool whole = std::abs(frame - std::round(frame)) < 0.05;
    return whole ? QString::number(qRound64(frame)) : QString::number(frame, 'f', 1);
}

void paintShape(QPainter& p, Channel::Interpolation shape, QPointF at, double r)
{
    if (shape == Channel::Interpolation::Cubic) return p.drawEllipse(at, r, r);
    if (shape == Channel::Interpolation::Step) return p.drawRect(QRectF(at.x() - 0.85 * r, at.y() - 0.85 * r, 1.7 * r, 1.7 * r));
    const QPointF corners[] = {at + QPointF(0, -r), at + QPointF(r, 0), at + QPointF(0, r), at + QPointF(-r, 0)};
    p.drawConvexPolygon(corners, 4);
}

}  // namespace

std::vector<Track> tracksOf(const Scene& scene, const Clip& clip)
{
    std::map<NodeId, std::vector<const Channel*>> byNode;
    std::vector<const Channel*> all;
    for (const auto& c : clip.channels) {
        if (c->keys() == 0 || !scene.find(c->node)) continue;
        byNode[c->node].push_back(c.get());
        all.push_back(c.get());
    }
    std::vector<Track> tracks;
    if (all.empty()) return tracks;
    tracks.push_back({{}, "Summary", {}, {}, merged(all)});
    const auto colors = boneColors(scene);
    for (const NodeId id : scene.nodes()) {
        const auto channels = byNode.find(id);
        if (channels == byNode.end()) continue;
        Track t{id, nodeName(scene, id), wordOf(speaker(channels->second)), {}, merged(channels->second)};
        if (const auto c = colors.find(id); c != colors.end()) t.chip = QColor::fromRgbF(c->second.r, c->second.g, c->second.b);
        tracks.push_back(std::move(t));
    }
    return tracks;
}

TimelineTracks::TimelineTracks(Session& session, QWidget* parent) : QAbstractScrollArea(parent), session_(session)
{
    setObjectName("timelineTracks");
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::StrongFocus);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setAccessibleName("Keys of the clip");
    viewport()->setMouseTracking(true);
    viewport()->setAttribute(Qt::WA_OpaquePaintEvent);
    subscription_ = session_.document.subscribe([this](const Change& c) { take(c); });
    connect(session_.playback, &Playback::changed, this, [this] {
        if (session_.playback->clip() != shown_) rebuild();
        redraw();
    });
    connect(&session_.view, &ViewState::timeChanged, this, &TimelineTracks::movePlayhead);
    rebuild();
}

void TimelineTracks::take(const Change& change)
{
    if (session_.playback->clip() != shown_ || change.aspects & (Aspect::Tree | Aspect::Skin | Aspect::File)) rebuild();
    if (change.aspects & Aspect::Selection) scrollToSelected();
    redraw();
}

void TimelineTracks::rebuild()
{
    const bool other = !shown_ || !session_.playback->clip() || session_.playback->clip()->channels != shown_->channels;
    shown_ = session_.playback->clip();
    tracks_ = shown_ ? tracksOf(session_.document.scene(), *shown_) : std::vector<Track>();
    keyCount_ = 0;
    for (size_t i = 1; i < tracks_.size(); ++i) keyCount_ += tracks_[i].keys.size();
    setAccessibleDescription(tracks_.empty() ? QString() : counted(tracks_.size() - 1, "track", "tracks") + ", " + counted(keyCount_, "key", "keys"));
    if (other) {
        verticalScrollBar()->setValue(0);
        fit();
    }
    layoutRows();
    redraw();
}

void TimelineTracks::layoutRows()
{
    const int room = viewport()->height() - rulerHeight, rows = rowHeight * int(tracks_.size());
    verticalScrollBar()->setPageStep(std::max(1, room));
    verticalScrollBar()->setSingleStep(rowHeight);
    verticalScrollBar()->setRange(0, std::max(0, rows - room));
}

void TimelineTracks::redraw()
{
    still_ = QPixmap();
    viewport()->update();
}

void TimelineTracks::fit()
{
    const double length = session_.playback->end(), room = std::max(60, viewport()->width() - origin_ - 22);
    left_ = 0;
    scale_ = room / std::max(length, 1.0 / session_.playback->frameRate());
    fitted_ = true;
    redraw();
}

void TimelineTracks::zoom(double factor, double x)
{
    const double at = timeAt(x), whole = std::max(60, viewport()->width() - origin_ - 22) / std::max(session_.playback->end(), 1e-3);
    const double most = std::max(whole, largestFrame * session_.playback->frameRate());
    scale_ = std::clamp(scale_ * factor, whole, most);
    left_ = at - (x - origin_) / scale_;
    fitted_ = scale_ == whole;
    keepInside();
    redraw();
}

void TimelineTracks::keepInside()
{
    const double room = (viewport()->width() - origin_ - 22) / scale_;
    left_ = std::clamp(left_, 0.0, std::max(0.0, session_.playback->end() - room));
}

QRect TimelineTracks::playheadRect() const
{
    const int x = int(std::lround(xOf(session_.playback->time())));
    return QRect(x - 30, 0, 61, viewport()->height());
}

void TimelineTracks::movePlayhead()
{
    // Playing on beyond what is seen turns the page.
    const double x = xOf(session_.playback->time());
    if (session_.playback->playing() && (x < origin_ - 1 || x > viewport()->width())) {
        left_ = session_.playback->time();
        keepInside();
        return redraw();
    }
    viewport()->update(lastPlayhead_);
    lastPlayhead_ = playheadRect();
    viewport()->update(lastPlayhead_);
}

int TimelineTracks::rowAt(double y) const
{
    if (y < rulerHeight) return -1;
    const int row = int((y - rulerHeight + verticalScrollBar()->value()) / rowHeight);
    return row < int(tracks_.size()) ? row : -1;
}

const Track::Key* TimelineTracks::keyAt(QPointF at) const
{
    const int row = at.x() < listWidth ? -1 : rowAt(at.y());
    if (row < 0) return nullptr;
    const std::vector<Track::Key>& keys = tracks_[size_t(row)].keys;
    const double t = timeAt(at.x());
    auto i = std::lower_bound(keys.begin(), keys.end(), t, [](const Track::Key& k, double v) { return k.time < v; });
    if (i == keys.end() || (i != keys.begin() && t - (i - 1)->time < i->time - t)) --i;
    return std::abs(xOf(i->time) - at.x()) <= keyReach ? &*i : nullptr;
}

void TimelineTracks::select(int row)
{
    if (row < 1) return;
    session_.document.select({{tracks_[size_t(row)].node}, {}, {}});
}

void TimelineTracks::scrollToSelected()
{
    const NodeId active = session_.document.selection().active();
    for (size_t i = 1; i < tracks_.size(); ++i) {
        if (tracks_[i].node != active) continue;
        const int top = int(i) * rowHeight, room = viewport()->height() - rulerHeight, now = verticalScrollBar()->value();
        if (top < now) verticalScrollBar()->setValue(top);
        if (top + rowHeight > now + room) verticalScrollBar()->setValue(top + rowHeight - room);
    }
}

double TimelineTracks::frameStep() const
{
    const double rate = session_.playback->frameRate(), pixels = scale_ / rate;
    const int base = int(std::lround(rate));
    std::vector<double> steps{1, 2, 5, 10, 20, 50};
    if (base == 24 || base == 30 || base == 60 || base == 120)
        steps = base == 24 ? std::vector<double>{1, 2, 6, 12} : std::vector<double>{1, 2, 5, 10, 15};
    for (const double seconds : {1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1800, 3600}) steps.push_back(seconds * base);
    for (const double s : steps)
        if (s * pixels >= 56) return s;
    return steps.back();
}

void TimelineTracks::paintEvent(QPaintEvent*)
{
    const double ratio = devicePixelRatioF();
    if (still_.isNull()) {
        still_ = QPixmap(viewport()->size() * ratio);
        still_.setDevicePixelRatio(ratio);
        QPainter p(&still_);
        p.setFont(font());
        paintStatic(p);
    }
    QPainter p(viewport());
    p.drawPixmap(0, 0, still_);
    if (shown_) paintPlayhead(p);
}

void TimelineTracks::paintStatic(QPainter& p)
{
    const Tokens& t = tokens();
    const int w = viewport()->width(), h = viewport()->height();
    p.fillRect(0, 0, w, h, t.panel);
    p.fillRect(listWidth, rulerHeight, w - listWidth, h - rulerHeight, t.field);
    p.setRenderHint(QPainter::Antialiasing);
    p.setClipRect(0, rulerHeight, w, h - rulerHeight);
    const int top = verticalScrollBar()->value();
    for (int row = top / rowHeight; row < int(tracks_.size()); ++row) {
        const int y = rulerHeight + row * rowHeight - top;
        if (y > h) break;
        paintRow(p, row, y);
    }
    p.setClipping(false);
    paintRuler(p);
    p.fillRect(QRectF(listWidth, 0, 1, h), t.border);
    p.fillRect(QRectF(0, rulerHeight - 1, listWidth, 1), t.border);
}

void TimelineTracks::paintRow(QPainter& p, int row, int y)
{
    const Tokens& t = tokens();
    const Track& track = tracks_[size_t(row)];
    const bool selected = track.node && session_.document.selection().has(track.node);
    const int w = viewport()->width();
    if (selected) {
        p.fillRect(0, y, listWidth, rowHeight, t.selection);
        QColor faint = t.selection;
        faint.setAlphaF(0.45f);
        p.fillRect(listWidth, y, w - listWidth, rowHeight, faint);
    }
    p.fillRect(QRectF(listWidth, y + rowHeight - 1, w - listWidth, 1), t.window);
    QFont f = font();
    f.setBold(row == 0);
    p.setFont(f);
    int left = 12;
    if (track.chip.isValid()) {
        p.setPen(Qt::NoPen);
        p.setBrush(track.chip);
        p.drawRoundedRect(QRectF(left, y + 7, 8, 8), 2, 2);
    }
    if (row > 0) left += 16;
    p.setPen(selected ? t.selectionText : t.text);
    const QString name = QFontMetrics(f).elidedText(track.name, Qt::ElideRight, listWidth - left - 52);
    p.drawText(QRect(left, y, listWidth - left - 44, rowHeight), Qt::AlignVCenter | Qt::AlignLeft, name);
    p.setPen(selected ? t.selectionText : t.text2);
    p.drawText(QRect(listWidth - 60, y, 50, rowHeight), Qt::AlignVCenter | Qt::AlignRight, track.word);
    p.setClipRect(listWidth + 1, std::max(y, rulerHeight), w - listWidth, rowHeight);
    paintKeys(p, track, y, selected ? t.selectionText : row == 0 ? t.text : t.text2);
    p.setClipRect(0, rulerHeight, w, viewport()->height() - rulerHeight);
}

// Only what is seen; runs of keys closer than can be told apart are one bar, found by leaps.
void TimelineTracks::paintKeys(QPainter& p, const Track& track, int y, const QColor& color)
{
    const auto before = [](const Track::Key& k, double v) { return k.time < v; };
    const double middle = y + 0.5 * rowHeight - 0.5, gap = mergeBelow / scale_;
    p.setPen(Qt::NoPen);
    p.setBrush(color);
    auto i = std::lower_bound(track.keys.begin(), track.keys.end(), timeAt(listWidth - 8), before);
    const auto end = std::lower_bound(i, track.keys.end(), timeAt(viewport()->width() + 8), before);
    while (i != end) {
        auto last = i;
        while (last + 1 != end && (last + 1)->time - last->time < gap) {
            const auto leap = std::lower_bound(last + 1, end, last->time + gap, before) - 1;  // all of them are nearer than a gap
            last = std::max(leap, last + 1);
        }
        const double x = xOf(i->time), to = xOf(last->time);
        if (last - i > 1) {
            p.setOpacity(0.7);
            p.drawRoundedRect(QRectF(x - 2, middle - 2.5, to - x + 4, 5), 2.5, 2.5);
            p.setOpacity(1);
        } else {
            const double next = last + 1 == end ? 1e9 : xOf((last + 1)->time) - to;
            paintShape(p, i->shape, {x, middle}, std::clamp(0.55 * next, 2.2, 4.0));
        }
        i = last + 1;
    }
}

void TimelineTracks::paintRuler(QPainter& p)
{
    const Tokens& t = tokens();
    const int w = viewport()->width();
    const Playback& play = *session_.playback;
    p.setPen(t.text2);
    p.setFont(font());
    if (!tracks_.empty())
        p.drawText(QRect(12, 0, listWidth - 20, rulerHeight), Qt::AlignVCenter,
                   counted(tracks_.size() - 1, "track", "tracks") + ", " + counted(keyCount_, "key", "keys"));
    p.setClipRect(listWidth, 0, w - listWidth, viewport()->height());
    const double step = frameStep(), rate = play.frameRate(), last = play.end() * rate;
    for (double f = std::max(0.0, std::floor(timeAt(listWidth) * rate / step) * step); f <= last + 1e-6; f += step) {
        const double x = std::round(xOf(f / rate));
        if (x > w) break;
        p.fillRect(QRectF(x, 14, 1, 7), t.strong);
        QColor line = t.border;
        line.setAlphaF(0.5f);
        p.fillRect(QRectF(x, rulerHeight, 1, viewport()->height() - rulerHeight), line);
        p.drawText(QRectF(x + 4, 0, 60, 20), Qt::AlignLeft | Qt::AlignVCenter, QString::number(qRound64(f)));
    }
    const double from = xOf(play.rangeFrom()), to = xOf(play.rangeTo());
    if (to > from) p.fillRect(QRectF(from, rulerHeight - 3, to - from, 3), t.accentText);
    p.setClipping(false);
}

void TimelineTracks::paintPlayhead(QPainter& p)
{
    const Tokens& t = tokens();
    const double x = std::round(xOf(session_.playback->time()));
    if (x < listWidth) return;
    p.fillRect(QRectF(x - 0.5, rulerHeight, 1.5, viewport()->height() - rulerHeight), t.accentText);
    const QString text = frameText(session_.playback->frame());
    const double width = QFontMetrics(font()).horizontalAdvance(text) + 12;
    p.setRenderHint(QPainter::Antialiasing);
    p.setPen(Qt::NoPen);
    p.setBrush(t.accent);
    const QRectF tag(x - 0.5 * width, 1, width, rulerHeight - 4);
    p.drawRoundedRect(tag, 3, 3);
    p.setPen(Qt::white);
    p.drawText(tag, Qt::AlignCenter, text);
}

void TimelineTracks::resizeEvent(QResizeEvent*)
{
    layoutRows();
    if (fitted_) return fit();
    keepInside();
    redraw();
}

void TimelineTracks::scrollContentsBy(int, int)
{
    redraw();
}

void TimelineTracks::mousePressEvent(QMouseEvent* e)
{
    const QPointF at = e->position();
    if (e->button() == Qt::MiddleButton && at.x() > listWidth) {
        drag_ = Drag::Pan;
        dragged_ = at.x();
    } else if (e->button() == Qt::LeftButton && at.x() > listWidth &&
               (at.y() < rulerHeight || std::abs(xOf(session_.playback->time()) - at.x()) < 4)) {
        drag_ = Drag::Scrub;
        session_.playback->pause();
        session_.playback->setTime(timeAt(at.x()));
    } else if (e->button() == Qt::LeftButton) {
        select(rowAt(at.y()));
    }
}

void TimelineTracks::mouseMoveEvent(QMouseEvent* e)
{
    const double x = e->position().x();
    if (drag_ == Drag::Scrub) session_.playback->setTime(timeAt(x));
    if (drag_ == Drag::Pan) {
        left_ -= (x - dragged_) / scale_;
        dragged_ = x;
        keepInside();
        redraw();
    }
    const bool head = x > listWidth && (e->position().y() < rulerHeight || std::abs(xOf(session_.playback->time()) - x) < 4);
    viewport()->setCursor(drag_ == Drag::Pan ? Qt::SizeAllCursor : head ? Qt::SplitHCursor : Qt::ArrowCursor);
}

void TimelineTracks::mouseReleaseEvent(QMouseEvent*)
{
    drag_ = Drag::None;
}

void TimelineTracks::mouseDoubleClickEvent(QMouseEvent* e)
{
    if (const Track::Key* key = keyAt(e->position())) {
        session_.playback->pause();
        session_.playback->setTime(key->time);
    } else if (e->position().x() < listWidth && rowAt(e->position().y()) > 0) {
        session_.view.frameNodes({tracks_[size_t(rowAt(e->position().y()))].node});
    }
}

void TimelineTracks::wheelEvent(QWheelEvent* e)
{
    const double turns = (e->angleDelta().y() + e->angleDelta().x()) / 120.0, x = e->position().x();
    const bool all = scale_ * session_.playback->end() <= viewport()->width() - origin_;
    if (e->modifiers() & Qt::ControlModifier) {
        zoom(std::pow(1.25, turns), std::max(x, double(origin_)));
    } else if (x < listWidth || all || e->modifiers() & Qt::ShiftModifier) {
        verticalScrollBar()->setValue(verticalScrollBar()->value() - int(turns * 2 * rowHeight));
    } else {
        left_ -= turns * 60 / scale_;
        keepInside();
        redraw();
    }
    e->accept();
}

void TimelineTracks::keyPressEvent(QKeyEvent* e)
{
    int row = 0;
    for (size_t i = 1; i < tracks_.size(); ++i)
        if (tracks_[i].node == session_.document.selection().active()) row = int(i);
    if (e->key() == Qt::Key_Home)
        fit();
    else if (e->key() == Qt::Key_Down && !tracks_.empty())
        select(std::min(row + 1, int(tracks_.size()) - 1));
    else if (e->key() == Qt::Key_Up)
        select(std::max(row - 1, 1));
    else
        e->ignore();
}

void TimelineTracks::changeEvent(QEvent* e)
{
    if (e->type() == QEvent::PaletteChange || e->type() == QEvent::FontChange) redraw();
    QAbstractScrollArea::changeEvent(e);
}

bool TimelineTracks::viewportEvent(QEvent* e)
{
    if (e->type() != QEvent::ToolTip) return QAbstractScrollArea::viewportEvent(e);
    const auto* help = static_cast<QHelpEvent*>(e);
    const int row = rowAt(help->pos().y());
    QString text;
    if (const Track::Key* key = keyAt(help->pos())) {
        text = QString("%1: frame %2, %3 s")
                   .arg(tracks_[size_t(row)].name, frameText(key->time * session_.playback->frameRate()))
                   .arg(key->time, 0, 'f', 3);
    } else if (row > 0 && help->pos().x() < listWidth) {
        static const std::map<QString, QString> words{{"lin", "linear"},
                                                      {"sph", "spherical: the shortest turn at constant speed"},
                                                      {"step", "stays until the next key"},
                                                      {"cubic", "cubic, with tangents"}};
        const Track& t = tracks_[size_t(row)];
        text = QString("%1: %2, %3. Click selects, double click frames it.").arg(t.name, counted(t.keys.size(), "key", "keys"), words.at(t.word));
    } else if (help->pos().y() < rulerHeight && help->pos().x() > listWidth) {
        text = "Frames. Drag moves the playhead; Ctrl+wheel zooms, wheel pans, Home shows all.";
    }
    QToolTip::showText(help->globalPos(), text, this);
    return true;
}

}  // namespace mw
