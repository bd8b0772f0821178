#include "ui/jobs.h"

#include <QThreadPool>
#include <QTimer>
#include <algorithm>

namespace mw {

struct Jobs::Worker {
    QThreadPool pool;
    QTimer ticker;
    quint64 next = 1;
    bool closing = false;
};

namespace {

struct Outcome {
    Job::State state = Job::State::Done;
    QString error;
    std::function<void()> then;
};

// Whatever work throws becomes an outcome: nothing leaves a worker.
Outcome perform(const std::function<std::function<void()>(Progress&)>& work, Progress& progress)
{
    Outcome o;
    try {
        o.then = work(progress);
    } catch (const Cancelled&) {
        o.state = Job::State::Cancelled;
    } catch (const std::bad_alloc&) {
        o = {Job::State::Failed, "There is not enough memory for this. Close other programs or use a smaller mesh.", {}};
    } catch (const std::exception& e) {
        o = {Job::State::Failed, QString::fromUtf8(e.what()), {}};
    }
    if (progress.cancelled) o.state = Job::State::Cancelled;
    return o;
}

}  // namespace

Jobs::Jobs(QObject* parent) : QObject(parent), worker_(std::make_unique<Worker>())
{
    worker_->pool.setMaxThreadCount(std::max(3, QThread::idealThreadCount()));
    worker_->ticker.setInterval(100);
    connect(&worker_->ticker, &QTimer::timeout, this, [this] {
        if (!busy()) worker_->ticker.stop();
        emit changed();
    });
}

Jobs::~Jobs()
{
    worker_->closing = true;
    for (Job& j : jobs_) j.progress->cancelled = true;
    worker_->pool.waitForDone();
}

quint64 Jobs::start(const QString& name, std::function<std::function<void()>(Progress&)> work, std::function<void(const QString&)> failed)
{
    Job job;
    job.id = worker_->next++;
    job.name = name;
    job.progress = std::make_shared<Progress>();
    job.clock.start();
    jobs_.push_back(job);
    const auto ended = std::find_if(jobs_.begin(), jobs_.end(), [](const Job& j) { return j.state != Job::State::Running; });
    if (jobs_.size() > 50 && ended != jobs_.end()) jobs_.erase(ended);
    worker_->ticker.start();
    const auto finish = [this, id = job.id, failed = std::move(failed)](const Outcome& o) {
        if (worker_->closing) return;
        const auto j = std::find_if(jobs_.begin(), jobs_.end(), [id](const Job& x) { return x.id == id; });
        if (j == jobs_.end()) return;
        const auto progress = j->progress;
        j->state = progress->cancelled ? Job::State::Cancelled : o.state;  // cancelled while its result was on the way
        j->milliseconds = j->clock.elapsed();
        j->error = o.error;
        const Job::State state = j->state;
        if (state == Job::State::Done && o.then) o.then();
        if (state == Job::State::Failed && failed) failed(o.error);
        emit changed();
    };
    worker_->pool.start([this, progress = job.progress, work = std::move(work), finish]() {
        Outcome o = perform(work, *progress);
        QMetaObject::invokeMethod(
            this, [finish, o = std::move(o)] { finish(o); }, Qt::QueuedConnection);
    });
    emit changed();
    return job.id;
}

void Jobs::cancel(quint64 id)
{
    for (Job& j : jobs_)
        if (j.id == id && j.state == Job::State::Running) {
            j.progress->cancelled = true;
            j.state = Job::State::Cancelled;
            j.milliseconds = j.clock.elapsed();
        }
    emit changed();
}

bool Jobs::busy() const
{
    return std::any_of(jobs_.begin(), jobs_.end(), [](const Job& j) { return j.state == Job::State::Running; });
}

}  // namespace mw
