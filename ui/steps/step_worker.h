// The worker's side of a step session: the running algorithm, which belongs to one worker thread, and the moves it is told.
#pragma once
#include <QString>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>

#include "core/catalog/catalog.h"
#include "core/steps/stepper.h"
#include "ui/jobs.h"
#include "ui/steps/step_history.h"

namespace mw::moves {

using Wanted = std::function<bool(const StepRecord&)>;

/// A move: to a position, or forward to the first new step that is wanted.
struct Command {
    size_t target = 0;
    Wanted wanted;      // set: search onwards from the last step seen
    QString fallback;   // a phase: when the search ends without it, its first step
    bool soft = false;  // waits for the move before it rather than breaking it off
    bool batch = false;
    QString title;
};

/// The running algorithm. Used by the worker only.
struct Engine {
    StartRun start;
    std::unique_ptr<Stepper> stepper;
};

/// One command on its way. What follows `done` is written by the worker before, read by others after.
struct Task {
    Command command;
    std::shared_ptr<Engine> engine;
    Progress progress;
    StepHistory passed;
    std::string fallbackPhase;
    size_t fallbackPosition = StepHistory::npos;

    std::mutex mutex;
    std::condition_variable ended;
    bool done = false;

    bool cancelled = false;
    QString error;
    StepRecord record;
    Value value;
    size_t position = 0, length = 0;
    double seconds = 0;
};

/// Runs in the worker thread: makes the move and leaves in the task where that led, or the error.
void execute(Task& task);
/// Shows a move in the jobs list and lets it be cancelled there.
void showAsJob(Jobs& jobs, const std::shared_ptr<Task>& task);

}  // namespace mw::moves
