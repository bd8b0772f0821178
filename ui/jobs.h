// Work off the window's thread: one place that starts it, shows how far it is, and can cancel it.
#pragma once
#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <vector>

#include "core/steps/progress.h"

namespace mw {

/// A running or finished job, as the Jobs panel and the status bar show it.
struct Job {
    enum class State { Running, Done, Failed, Cancelled };
    quint64 id = 0;
    QString name;
    std::shared_ptr<Progress> progress;
    State state = State::Running;
    QString error;
    QElapsedTimer clock;
    qint64 milliseconds = 0;  ///< once it has ended
};

/// Lives in the window's thread; so do all its callbacks.
class Jobs : public QObject {
    Q_OBJECT

public:
    explicit Jobs(QObject* parent = nullptr);
    ~Jobs() override;  ///< cancels all and waits

    /// `work` runs on a worker; what it returns is called here afterwards, unless it was cancelled or threw. `failed` gets an Error's text.
    quint64 start(const QString& name, std::function<std::function<void()>(Progress&)> work, std::function<void(const QString&)> failed = {});
    void cancel(quint64 id);
    const std::vector<Job>& jobs() const { return jobs_; }  ///< newest last; finished ones stay, at most 50
    bool busy() const;

signals:
    void changed();  ///< started, ended; and ten times a second while one runs

private:
    struct Worker;
    std::vector<Job> jobs_;
    std::unique_ptr<Worker> worker_;
};

}  // namespace mw
