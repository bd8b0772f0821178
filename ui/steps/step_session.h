// The algorithm being stepped: one at a time, shared by transport strip, step player, source, plot and viewport.
#pragma once
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <memory>
#include <vector>

#include "core/scene/document.h"
#include "core/steps/stepper.h"
#include "ui/jobs.h"

namespace mw {

class StepHistory;

/// Lives in the window's thread, the Stepper on a worker. A step that is ready within a few milliseconds is shown at once; else the last
/// state stays until it is. A seek that takes longer shows as a job and can be cancelled there.
class StepSession : public QObject {
    Q_OBJECT

public:
    StepSession(Document& document, Jobs& jobs, QObject* parent = nullptr);
    ~StepSession() override;

    /// Opens an operation on an input: of a node's mesh, of the skeleton below a joint (a pose), or of nobody (a lab, `node` none). Ends what was
    /// open.
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
    size_t length() const;           ///< 0 while unknown
    size_t estimatedLength() const;  ///< from what the algorithm says of its progress; 0 while it cannot be told
    bool atEnd() const;
    bool seeking() const { return seeking_; }
    const QString& error() const;  ///< why the last move did not work; empty when it did

    /// The numbers of every step passed so far, for the plot: by name, (step, value).
    const std::vector<std::pair<size_t, double>>& series(const std::string& number) const;
    std::vector<std::string> seriesNames() const;
    const StepHistory& history() const;  ///< ui/steps/step_history.h

    enum class Unit { Step, Phase, Named };  ///< Named: each step of one phase
    void setUnit(Unit u, const QString& phase = {});
    Unit unit() const;
    const QString& unitPhase() const;
    void setSpeed(double stepsPerSecond);  ///< 0: as fast as it goes
    double speed() const;
    bool playing() const { return timer_.isActive(); }

    /// The numbers the plot shows, at most six; kept while the same algorithm stays open.
    const QStringList& plotted() const;
    void setPlotted(const QStringList& numbers);

    /// The document's mesh was changed since this was opened: the strip asks what to do.
    bool edited() const;
    void keepAsBase();  ///< the state shown becomes the node's mesh, without modifiers; ends stepping
    /// True when the state shown is a pose of a character in the scene.
    bool isOfCharacter() const;
    /// A clip that leads from the pose it began with to the one shown, within a second; ends stepping. None when it is no character's.
    ClipId keepAsClip();

public slots:
    void play();
    void pause();
    void forward();
    void back();
    void first();
    void last();
    void seek(size_t position);
    void scrub(size_t position);  ///< seek() of a drag: does not break off the seek before it
    void skip(int steps);         ///< ten at once, or so; negative: back
    void nextPhase();
    void lastPhase();
    void toPhase(const QString& phase);                   ///< next step of that phase
    void toLines(unsigned firstLine, unsigned lastLine);  ///< next step yielded in this range of lines (a statement may take several)

signals:
    void opened();
    void closed();
    void changed();  ///< another step, or playing or seeking began or ended

private:
    struct Impl;
    void tick();
    void documentChanged();

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
