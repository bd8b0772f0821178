#include "ui/playback.h"

#include <algorithm>
#include <cmath>

namespace mw {
namespace {

constexpr int displayPace = 8;  // ms between looks at the clock: no slower than displays are; the view draws no more often than it can

/// All keys of some channels lie at whole frames of a rate.
bool lieAtFrames(const Clip& clip, double rate)
{
    size_t looked = 0;
    for (const auto& c : clip.channels)
        for (size_t i = 0; i < c->keys() && looked < 400; ++i, ++looked) {
            const double frame = c->times[i] * rate;
            if (std::abs(frame - std::round(frame)) > 0.02) return false;
        }
    return looked > 0;
}

}  // namespace

double frameRateOf(const Clip& clip)
{
    if (clip.frameTime > 0) return 1 / clip.frameTime;
    for (const double rate : {24.0, 25.0, 30.0, 60.0, 120.0})
        if (lieAtFrames(clip, rate)) return rate;
    return 24;
}

Playback::Playback(Document& document, ViewState& view) : document_(document), view_(view)
{
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(displayPace);
    connect(&timer_, &QTimer::timeout, this, &Playback::tick);
    subscription_ = document_.subscribe([this](const Change& c) { take(c); });
}

void Playback::take(const Change& change)
{
    const std::vector<ClipId> clips = document_.scene().clips();
    if (change.aspects & Aspect::File || (clip() == nullptr && (view_.clip || change.aspects & Aspect::Clip)))
        return setClip(clips.empty() ? ClipId{} : clips.front());
    if (clip() != adopted_) adopt();
}

void Playback::setClip(ClipId id)
{
    timer_.stop();
    view_.clip = id;
    view_.time = 0;
    rangeFrom_ = rangeTo_ = 0;
    adopt();
    view_.setTime(0);
}

void Playback::adopt()
{
    const bool whole = rangeFrom_ == 0 && rangeTo_ == end();
    adopted_ = clip();
    frameRate_ = adopted_ ? frameRateOf(*adopted_) : 24;
    const double last = end();
    if (whole || rangeTo_ == 0 || rangeTo_ > last) rangeTo_ = last;
    rangeFrom_ = std::min(rangeFrom_, rangeTo_);
    if (!adopted_) timer_.stop();
    emit changed();
    if (view_.time > last) view_.setTime(last);
}

double Playback::end() const
{
    return clip() ? duration(*clip()) : 0;
}

void Playback::setTime(double seconds)
{
    clock_.restart();
    view_.setTime(std::clamp(seconds, 0.0, end()));
}

void Playback::play()
{
    if (!clip() || rangeTo_ <= rangeFrom_) return;
    if (view_.time >= rangeTo_ || view_.time < rangeFrom_) view_.setTime(rangeFrom_);
    clock_.restart();
    timer_.start();
    emit changed();
}

void Playback::pause()
{
    if (!playing()) return;
    timer_.stop();
    emit changed();
}

void Playback::setLoop(bool on)
{
    loop_ = on;
    emit changed();
}

void Playback::setSpeed(double factor)
{
    speed_ = factor;
    emit changed();
}

void Playback::setRange(double from, double to)
{
    rangeFrom_ = std::clamp(from, 0.0, end());
    rangeTo_ = std::clamp(to, rangeFrom_, end());
    emit changed();
}

void Playback::tick()
{
    const double passed = 1e-9 * double(clock_.nsecsElapsed()) * speed_, length = rangeTo_ - rangeFrom_;
    clock_.restart();
    double next = view_.time + passed;
    if (next >= rangeTo_) {
        if (loop_ && length > 0) {
            next = rangeFrom_ + std::fmod(next - rangeFrom_, length);
        } else {
            next = rangeTo_;
            timer_.stop();
            emit changed();
        }
    }
    view_.setTime(next);
}

void Playback::stepFrames(int n)
{
    pause();
    const double at = frame(), near = std::round(at);
    const bool whole = std::abs(at - near) < 1e-6;
    setTime((whole ? near + n : n > 0 ? std::ceil(at) + n - 1 : std::floor(at) + n + 1) / frameRate_);
}

void Playback::nextKey()
{
    if (!clip()) return;
    pause();
    double next = end();
    for (const auto& c : clip()->channels) {
        const auto i = std::upper_bound(c->times.begin(), c->times.end(), view_.time + 1e-9);
        if (i != c->times.end()) next = std::min(next, *i);
    }
    setTime(next);
}

void Playback::lastKey()
{
    if (!clip()) return;
    pause();
    double last = 0;
    for (const auto& c : clip()->channels) {
        const auto i = std::lower_bound(c->times.begin(), c->times.end(), view_.time - 1e-9);
        if (i != c->times.begin()) last = std::max(last, *(i - 1));
    }
    setTime(last);
}

const ScenePose& Playback::pose() const
{
    const Clip* now = clip();
    const auto scene = document_.snapshot();
    if (now == posedClip_ && scene == posedScene_ && view_.time == posedTime_) return pose_;
    pose_ = now ? poseAt(*scene, *now, view_.time) : ScenePose();
    posedClip_ = now;
    posedScene_ = scene;
    posedTime_ = view_.time;
    return pose_;
}

}  // namespace mw
