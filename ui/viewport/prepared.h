// What a tool needs made of a mesh before it can answer. Of a large mesh a job makes it; the tool says meanwhile that it prepares.
#pragma once
#include <functional>
#include <memory>

#include "core/mesh/same_mesh.h"
#include "ui/jobs.h"

namespace mw {

/// Keeps what was asked for last; a job for something else is cancelled. Lives in the window's thread.
template <class Made>
class Prepared {
public:
    /// `vertex`: what it is made for, none when it is of the mesh alone. Runs on a worker, and hears its cancel by `progress`.
    using Make = std::function<std::shared_ptr<Made>(const Mesh& mesh, uint32_t vertex, Progress& progress)>;
    /// `name`: of the job, for people. `ready`: called when one has ended, well or not; never after this has gone.
    Prepared(QString name, Make make, std::function<void()> ready) : name_(std::move(name)), make_(std::move(make)), ready_(std::move(ready)) {}

    /// Null while it is being made, and when that failed.
    std::shared_ptr<Made> of(Jobs& jobs, const Mesh& mesh, uint32_t vertex = none)
    {
        if (wanted_ && sameMesh(wanted_->mesh, mesh) && wanted_->vertex == vertex && !wasCancelled(jobs)) return wanted_->made;
        drop(jobs);
        wanted_ = std::make_shared<Wanted>(Wanted{mesh, vertex, nullptr, {}, 0});
        if (Progress here; mesh.faceCount() <= atOnce)
            wanted_->made = make_(mesh, vertex, here);
        else
            start(jobs);
        return wanted_->made;
    }
    /// Why there is none; empty while it is being made.
    QString failure() const { return wanted_ ? wanted_->failure : QString(); }
    void drop(Jobs& jobs)
    {
        if (wanted_ && wanted_->job) jobs.cancel(wanted_->job);
        wanted_.reset();
    }

private:
    struct Wanted {
        Mesh mesh;
        uint32_t vertex;
        std::shared_ptr<Made> made;
        QString failure;
        quint64 job;
    };
    static constexpr size_t atOnce = 30'000;  // faces: some milliseconds

    void start(Jobs& jobs)
    {
        // The tool may have gone, or want something else, when it is made.
        const std::weak_ptr<Wanted> wanted = wanted_;
        const auto end = [wanted, ready = ready_](std::shared_ptr<Made> made, const QString& failure) {
            const auto w = wanted.lock();
            if (!w) return;
            w->made = std::move(made);
            w->failure = failure;
            ready();
        };
        wanted_->job = jobs.start(
            name_,
            [make = make_, mesh = wanted_->mesh, vertex = wanted_->vertex, end](Progress& progress) -> std::function<void()> {
                progress.at(0);
                return [end, made = make(mesh, vertex, progress)] { end(made, {}); };
            },
            [end](const QString& text) { end(nullptr, text); });
    }
    bool wasCancelled(const Jobs& jobs) const
    {
        for (const Job& j : jobs.jobs())
            if (j.id == wanted_->job) return j.state == Job::State::Cancelled;
        return false;
    }

    QString name_;
    Make make_;
    std::function<void()> ready_;
    std::shared_ptr<Wanted> wanted_;
};

}  // namespace mw
