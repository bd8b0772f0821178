// Forwards and backwards through a run. Knows no kind of thing, only snapshots of whatever is stepped.
#pragma once
#include <atomic>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "core/steps/progress.h"
#include "core/steps/stage.h"

namespace mw {

/// A step that outlives its algorithm: everything the player, the viewport and the command line show.
struct StepRecord {
    size_t index = 0;  ///< 0 is the state before the first step (empty phase); the last one is the end (phase "end")
    std::string phase;
    std::vector<Focus> focus;  ///< rings included, one entry an element
    std::vector<Number> numbers;
    float progress = 0;
    const char* file = "";  ///< as the compiler saw it
    unsigned line = 0;
};

/// Position k is the state after k steps. Going back shows a kept state, or runs again from the start and keeps a window of states
/// before the wanted position. Both give the same state. Not thread safe: one thread at a time; `seek` may run on a worker.
class Stepper {
public:
    explicit Stepper(StartRun start, size_t keepBytes = size_t(256) << 20);
    ~Stepper();

    size_t position() const { return position_; }
    /// True when the state at `position` is the result.
    bool atEnd() const;
    /// The number of positions, 0 while the end has not been seen.
    size_t length() const { return length_; }
    const StepRecord& step() const { return record_; }
    /// The value at the present position; kept for stepping back.
    const Snapshot& value();

    bool forward();  ///< false at the end
    bool back();     ///< false at the start
    /// To a position, or the end if that is nearer. Throws Cancelled and then stays where it was.
    void seek(size_t position, Progress* progress = nullptr);
    /// Forward to the first step of which `wanted` is true; to the end if there is none. False then.
    bool seekWhere(const std::function<bool(const StepRecord&)>& wanted, Progress* progress = nullptr);

private:
    struct Kept {
        StepRecord record;
        Snapshot snapshot;
    };
    void restart();
    bool pull();  // one step of run_
    void keep();
    const Kept* kept(size_t position) const;

    StartRun start_;
    std::unique_ptr<Run> run_;
    size_t runPosition_ = 0;  // of run_
    bool runEnded_ = false;
    size_t position_ = 0, length_ = 0;
    StepRecord record_;
    std::deque<Kept> kept_;
    size_t keepBytes_, keptBytes_ = 0;
};

/// A record of the step `run` waits at.
StepRecord recordOf(const Run& run, size_t index);

}  // namespace mw
