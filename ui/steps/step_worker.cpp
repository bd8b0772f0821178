#include "ui/steps/step_worker.h"

#include <algorithm>
#include <chrono>

namespace mw::moves {
namespace {

constexpr size_t warmFaces = 20'000;  // from this size on the worker also makes what drawing needs
using Clock = std::chrono::steady_clock;

void search(Stepper& stepper, Task& task, const Wanted& wanted)
{
    const size_t last = task.passed.end() - 1;
    if (stepper.position() != last) stepper.seek(last, &task.progress);
    bool found = false;
    stepper.seekWhere(
        [&](const StepRecord& r) {
            task.passed.add(r);
            found = wanted(r);
            return found;
        },
        &task.progress);
    task.passed.add(stepper.step());  // the end, which is not searched
    if (found || task.command.fallback.isEmpty()) return;
    const size_t newer = task.passed.nextOf(task.fallbackPhase, 0);
    const size_t first = std::min(task.fallbackPosition, newer);
    if (first != StepHistory::npos) stepper.seek(first, &task.progress);
}

void move(Stepper& stepper, Task& task)
{
    const Command& c = task.command;
    if (c.wanted)
        search(stepper, task, c.wanted);
    else if (c.target < task.passed.end())
        stepper.seek(c.target, &task.progress);
    else
        search(stepper, task, [&](const StepRecord& r) { return r.index >= c.target; });
}

void warm(const Value& value)
{
    const Mesh* mesh = std::get_if<Mesh>(&value);
    if (!mesh || mesh->faceCount() < warmFaces) return;
    mesh->vertexNormals();
    mesh->triangulation();
}

}  // namespace

void execute(Task& task)
{
    Engine& e = *task.engine;
    const auto started = Clock::now();
    try {
        if (!e.stepper) e.stepper = std::make_unique<Stepper>(e.start);
        move(*e.stepper, task);
        task.record = e.stepper->step();
        task.position = e.stepper->position();
        task.length = e.stepper->length();
        task.value = mw::valueOf(e.stepper->value());
        warm(task.value);
    } catch (const Cancelled&) {
        task.cancelled = true;
    } catch (const std::exception& x) {
        task.error = QString::fromUtf8(x.what());
        e.stepper.reset();  // an algorithm that threw cannot go on; it begins anew
    }
    task.seconds = std::chrono::duration<double>(Clock::now() - started).count();
}

void showAsJob(Jobs& jobs, const std::shared_ptr<Task>& task)
{
    jobs.start(task->command.title, [task](Progress& p) -> std::function<void()> {
        std::unique_lock lock(task->mutex);
        while (!task->ended.wait_for(lock, std::chrono::milliseconds(40), [&] { return task->done; })) {
            p.fraction = task->progress.fraction.load();
            if (p.cancelled) task->progress.cancelled = true;
        }
        if (task->cancelled) throw Cancelled{};
        if (!task->error.isEmpty()) throw Error(task->error.toStdString());
        return [] {};
    });
}

}  // namespace mw::moves
