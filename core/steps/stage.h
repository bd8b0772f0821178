// What an algorithm sees of whoever runs it, and the type-erased run that the stepper pulls.
#pragma once
#include <any>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "core/steps/generator.h"

namespace mw {

/// The thing that is worked on, as it stands at a step. `value` holds the algorithm's own type (Mesh, Table, ...).
struct Snapshot {
    std::any value;
    size_t bytes = 0;  ///< roughly what keeping it costs
};

/// Where an algorithm of result type T shows its state and leaves its result.
/// T needs `size_t byteSize(const T&)`, found by argument-dependent lookup.
template <class T>
class Stage {
public:
    /// `initial` is what there is before the algorithm has begun: its input where that is of the same type.
    explicit Stage(bool watched, T initial = {}) : watched_(watched), initial_(std::move(initial)) {}

    /// True when someone looks at every step. Else a hot loop yields only now and then, for progress and cancelling:
    /// `if (stage.watched() || (++n & 1023) == 0) co_yield ...`. The result must not depend on it.
    bool watched() const { return watched_; }
    /// How to make the value as it stands; called only while the algorithm is suspended, never after it has ended.
    void show(std::function<T()> current) { current_ = std::move(current); }
    /// The result; the last thing an algorithm does. One that never calls it has failed.
    void finish(T result)
    {
        current_ = nullptr;
        result_ = std::move(result);
    }

    bool finished() const { return result_.has_value(); }
    T value() const { return result_ ? *result_ : current_ ? current_() : initial_; }

private:
    bool watched_;
    T initial_;
    std::function<T()> current_;
    std::optional<T> result_;
};

/// One execution of some algorithm, paused between steps.
class Run {
public:
    virtual ~Run() = default;
    /// To the next step; false when it has ended. Throws what the algorithm throws.
    virtual bool advance() = 0;
    /// The step it waits at. Only after advance() returned true.
    virtual const Step& step() const = 0;
    virtual const std::source_location& where() const = 0;
    /// The value as it stands, at the end the result.
    virtual Snapshot snapshot() const = 0;
};

/// Starts an algorithm from its beginning; may be called any number of times.
using StartRun = std::function<std::unique_ptr<Run>(bool watched)>;

/// A Run of the coroutine that `start` makes on a stage.
template <class T>
class RunOf final : public Run {
public:
    template <class Start>
    RunOf(bool watched, const Start& start, T initial = {}) : stage_(watched, std::move(initial)), generator_(start(stage_))
    {}
    bool advance() override { return generator_.next(); }
    const Step& step() const override { return generator_.step(); }
    const std::source_location& where() const override { return generator_.where(); }
    Snapshot snapshot() const override
    {
        T value = stage_.value();
        const size_t bytes = byteSize(value);
        return {std::move(value), bytes};
    }

private:
    Stage<T> stage_;  // before the generator, which refers to it
    Generator generator_;
};

}  // namespace mw
