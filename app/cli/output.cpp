#include "app/cli/output.h"

#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>
#include <unistd.h>

namespace mw::cli {

std::string shown(double v)
{
    if (!std::isfinite(v)) return "undefined";
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, v, std::chars_format::general, 6).ptr;
    return {text, end};
}

std::string counted(size_t n, const char* one, const char* many)
{
    std::string text = std::to_string(n) + " ";
    if (n == 1) return text + one;
    return many ? text + many : text + one + "s";
}

void printJson(const nlohmann::json& j)
{
    std::cout << j.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

void warn(const std::string& file, std::span<const Warning> warnings)
{
    const char* overBar = isatty(STDERR_FILENO) ? "\r\033[K" : "";
    for (const Warning& w : warnings) std::cerr << overBar << "meshwright: " << file << ": warning: " << w.text << '\n';
}

nlohmann::json finite(double v)
{
    return std::isfinite(v) ? nlohmann::json(v) : nlohmann::json();
}

namespace {

// The work an interrupt cancels. Lock-free atomics may be touched in a signal handler.
std::atomic<Progress*> interruptible{nullptr};
static_assert(std::atomic<Progress*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

void interrupt(int)
{
    if (Progress* p = interruptible.load()) p->cancelled.store(true);
}

}  // namespace

struct Working::Bar {
    Progress progress;
    std::mutex mutex;
    std::condition_variable wake;
    std::string what;
    bool done = false, drawn = false;
    std::thread thread;

    // Ten times a second, and only once the work has lasted for a while.
    void run()
    {
        std::unique_lock lock(mutex);
        auto wait = std::chrono::milliseconds(400);
        while (!wake.wait_for(lock, wait, [this] { return done; })) {
            draw();
            wait = std::chrono::milliseconds(100);
        }
        if (drawn) std::fputs("\r\033[K", stderr);
    }
    void draw()
    {
        constexpr int width = 30;
        const float share = std::min(1.f, std::max(0.f, progress.fraction.load()));
        const int full = int(share * width);
        std::string bar(size_t(full), '#');
        bar.resize(width, '.');
        std::fprintf(stderr, "\r\033[K[%s] %3d %% %s", bar.c_str(), int(share * 100), what.c_str());
        std::fflush(stderr);
        drawn = true;
    }
};

Working::Working(std::string what) : bar_(std::make_unique<Bar>())
{
    bar_->what = std::move(what);
    interruptible = &bar_->progress;
    struct sigaction action = {};
    action.sa_handler = interrupt;
    action.sa_flags = int(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    if (isatty(STDERR_FILENO)) bar_->thread = std::thread([b = bar_.get()] { b->run(); });
}

Working::~Working()
{
    interruptible = nullptr;
    std::signal(SIGINT, SIG_DFL);
    if (!bar_->thread.joinable()) return;
    {
        const std::lock_guard lock(bar_->mutex);
        bar_->done = true;
    }
    bar_->wake.notify_one();
    bar_->thread.join();
}

Progress* Working::progress()
{
    return &bar_->progress;
}

void Working::now(std::string what)
{
    const std::lock_guard lock(bar_->mutex);
    bar_->progress.fraction = 0;
    bar_->what = std::move(what);
}

}  // namespace mw::cli
