// The coroutine type of every algorithm: it runs until its next Step and waits there.
#pragma once
#include <coroutine>
#include <exception>
#include <memory>
#include <source_location>
#include <utility>

#include "core/steps/step.h"

namespace mw {

/// A running algorithm. Lazy: nothing happens before the first next(). Destroying it half-way is safe.
/// The Step it hands out lives until the next call of next().
class Generator {
public:
    struct promise_type {
        const Step* step = nullptr;
        std::source_location where;
        std::exception_ptr failure;

        Generator get_return_object() { return Generator(std::coroutine_handle<promise_type>::from_promise(*this)); }
        std::suspend_always initial_suspend() noexcept { return {}; }
        std::suspend_always final_suspend() noexcept { return {}; }
        // The temporary of a co_yield lives until the coroutine is resumed, so its address is enough.
        std::suspend_always yield_value(const Step& s, std::source_location w = std::source_location::current())
        {
            step = &s;
            where = w;
            return {};
        }
        void return_void() {}
        void unhandled_exception() { failure = std::current_exception(); }
    };

    Generator() = default;
    Generator(Generator&& g) noexcept : handle_(std::exchange(g.handle_, nullptr)) {}
    Generator& operator=(Generator&& g) noexcept
    {
        std::swap(handle_, g.handle_);
        return *this;
    }
    ~Generator()
    {
        if (handle_) handle_.destroy();
    }

    /// Runs to the next step. False when the algorithm has ended; rethrows what it threw.
    bool next()
    {
        handle_.resume();
        if (handle_.promise().failure) std::rethrow_exception(std::exchange(handle_.promise().failure, nullptr));
        return !handle_.done();
    }
    const Step& step() const { return *handle_.promise().step; }
    const std::source_location& where() const { return handle_.promise().where; }

private:
    explicit Generator(std::coroutine_handle<promise_type> h) : handle_(h) {}
    std::coroutine_handle<promise_type> handle_;
};

}  // namespace mw
