// The algorithm being stepped: one at a time, shared by transport strip, step player, source, plot and viewport.
#pragma once
#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <vector>

#include "core/scene/document.h"
#include "core/steps/stepper.h"
#include "ui/jobs.h"

namespace mw {

/// Lives in the window's thread. Long seeks run as a job; until one ends the last state stays.
class StepSession : public QObject {
    Q_OBJECT

public:
    StepSession(Document& document, Jobs& jobs, QObject* parent = nullptr);
    ~StepSession() override;

    /// Opens an operation on the input of a node's mesh (`level` 0: its base). Ends what was open.
    void open(const Operation& op, NodeId node, const Value& input, ParameterValues values);
    void close();
    bool isOpen() const { return op_ != nullptr; }

    const Operation* operation() const { return op_; }
    NodeId node() const { return node_; }
    const ParameterValues& values() const { return values_; }
    void setValues(ParameterValues values);  ///< starts again

    const StepRecord& step() const;
    /// The thing as it stands, to draw in place of the node's mesh. Null while nothing is open.
    const Value* value() const;
    size_t position() const;
    size_t length() const;  ///< 0 while unknown
    bool seeking() const { return seeking_; }

    /// The numbers of every step passed so far, for the plot: by name, (step, value).
    const std::vector<std::pair<size_t, double>>& series(const std::string& number) const;
    std::vector<std::string> seriesNames() const;

    enum class Unit { Step, Phase };
    void setUnit(Unit u);
    void setSpeed(double stepsPerSecond);  ///< 0: as fast as it goes
    bool playing() const { return timer_.isActive(); }

public slots:
    void play();
    void pause();
    void forward();
    void back();
    void first();
    void last();
    void seek(size_t position);
    void toPhase(const QString& phase);  ///< next step of that phase
    void toLine(unsigned line);          ///< next step yielded there

signals:
    void opened();
    void closed();
    void changed();  ///< another step, or playing or seeking began or ended

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
    Document& document_;
    Jobs& jobs_;
    const Operation* op_ = nullptr;
    NodeId node_;
    ParameterValues values_;
    QTimer timer_;
    bool seeking_ = false;
};

}  // namespace mw
