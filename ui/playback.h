// Plays the clip of the view: moves its playhead at the pace of the display, and gives the pose there. No part of the document.
#pragma once
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "core/scene/document.h"
#include "ui/view_state.h"

namespace mw {

class Playback : public QObject {
    Q_OBJECT

public:
    Playback(Document& document, ViewState& view);

    const Clip* clip() const { return document_.scene().find(view_.clip); }  ///< null: the scene rests
    void setClip(ClipId id);                                                 ///< stands at its start
    double time() const { return view_.time; }
    void setTime(double seconds);  ///< kept within the clip; goes on playing from there
    double end() const;            ///< of the clip, seconds
    double frameRate() const { return frameRate_; }
    double frame() const { return view_.time * frameRate_; }

    bool playing() const { return timer_.isActive(); }
    void play();  ///< from the range's start when it stands at its end
    void pause();
    void toggle() { playing() ? pause() : play(); }
    bool loop() const { return loop_; }
    void setLoop(bool on);
    double speed() const { return speed_; }
    void setSpeed(double factor);
    /// What is played, seconds.
    double rangeFrom() const { return rangeFrom_; }
    double rangeTo() const { return rangeTo_; }
    void setRange(double from, double to);

    void stepFrames(int n);  ///< to whole frames
    void nextKey();
    void lastKey();
    void toFirst() { setTime(rangeFrom_); }
    void toLast() { setTime(rangeTo_); }

    /// At the playhead; empty while the scene rests. Computed once for each moment.
    const ScenePose& pose() const;

signals:
    void changed();  ///< clip, range, speed, or whether it plays; the playhead is told by ViewState::timeChanged

private:
    void take(const Change& change);
    void adopt();  // a clip that was just chosen or edited
    void tick();

    Document& document_;
    ViewState& view_;
    std::shared_ptr<void> subscription_;
    QTimer timer_;
    QElapsedTimer clock_;
    double frameRate_ = 24, speed_ = 1, rangeFrom_ = 0, rangeTo_ = 0;
    bool loop_ = true;
    const Clip* adopted_ = nullptr;
    mutable ScenePose pose_;
    mutable std::shared_ptr<const Scene> posedScene_;
    mutable const Clip* posedClip_ = nullptr;
    mutable double posedTime_ = -1;
};

/// Frames a second a clip was made with: what its file says, else the common rate at whose frames its keys lie, else 24.
double frameRateOf(const Clip& clip);

}  // namespace mw
