// See step_session.h. Commands go to the worker one at a time, results come back as plain values.
#include "ui/steps/step_session.h"

#include <QLocale>
#include <QThreadPool>
#include <algorithm>
#include <optional>

#include "core/catalog/others.h"
#include "core/scene/edit.h"
#include "core/scene/scene_pose.h"
#include "ui/steps/step_worker.h"

namespace mw {

using namespace moves;

namespace {

constexpr auto patience = std::chrono::milliseconds(8);  // the window waits this long for a step; longer ones come by event
constexpr double batchLeast = 0.012, batchMost = 0.05;   // seconds a batch should take when it plays as fast as it goes
constexpr int jobAfter = 300;                            // ms

/// What the first node of that name shows; nothing when it shows no mesh.
std::optional<Mesh> shownBy(const Document& document, const std::string& name)
{
    const Scene& scene = document.scene();
    for (const NodeId id : scene.nodes())
        if (const Node& n = scene.node(id); n.name == name && n.mesh) return document.shownMesh(n.mesh);
    return std::nullopt;
}

bool sameShape(const MeshObject& a, const MeshObject& b)
{
    return a.base.positions().data() == b.base.positions().data() && a.base.cornerVertex().data() == b.base.cornerVertex().data() &&
           a.base.faceStart().data() == b.base.faceStart().data() && a.stack == b.stack;
}

}  // namespace

struct StepSession::Impl {
    StepSession& self;
    std::shared_ptr<Engine> engine;
    Value input, value;
    StepHistory history;
    StepRecord record;
    size_t position = 0, length = 0;
    QString error;
    std::shared_ptr<Task> current;
    std::optional<Command> pending;
    Unit unit = Unit::Step;
    QString unitPhase;
    QStringList plotted;
    double speed = 4;
    size_t batchSteps = 16;  // of playing as fast as it goes; follows the time they take
    std::shared_ptr<const MeshObject> openedOn;
    bool edited = false;
    std::shared_ptr<void> subscription;
    QThreadPool pool;

    explicit Impl(StepSession& s) : self(s) { pool.setMaxThreadCount(1); }

    void abandon();
    void submit(Command c);
    void run(Command c);
    void finish(const std::shared_ptr<Task>& task);
    void take(Task& task);
    size_t goal() const;
    std::optional<size_t> knownNext(size_t from, Unit by) const;
    Wanted onwards(size_t from, size_t least, Unit by) const;
    void advance(size_t steps, bool batch, Unit by);
    void retreat(Unit by);
    QString name() const { return QString::fromStdString(self.op_->title); }
};

// Whatever is under way is for nobody any more.
void StepSession::Impl::abandon()
{
    if (current) current->progress.cancelled = true;
    current.reset();
    pending.reset();
    self.seeking_ = false;
}

void StepSession::Impl::submit(Command c)
{
    if (!engine || !engine->start) return;  // its parameters were refused
    if (!current) return run(std::move(c));
    if (!c.soft) current->progress.cancelled = true;
    pending = std::move(c);
}

void StepSession::Impl::run(Command c)
{
    auto task = std::make_shared<Task>();
    task->engine = engine;
    task->passed = StepHistory(history.end());
    task->fallbackPhase = c.fallback.toStdString();
    if (!c.fallback.isEmpty()) task->fallbackPosition = history.nextOf(task->fallbackPhase, 0);
    task->command = std::move(c);
    current = task;
    self.seeking_ = true;
    pool.start([task, session = &self] {
        execute(*task);
        {
            std::lock_guard lock(task->mutex);
            task->done = true;
        }
        task->ended.notify_all();
        // The session waits for its worker before it goes, so it is there to be told.
        QMetaObject::invokeMethod(
            session, [task, session] { session->impl_->finish(task); }, Qt::QueuedConnection);
    });
    if (!task->command.batch) {
        std::unique_lock lock(task->mutex);
        if (task->ended.wait_for(lock, patience, [&] { return task->done; })) {
            lock.unlock();
            return finish(task);
        }
        QTimer::singleShot(jobAfter, &self, [this, task] {
            if (current == task) showAsJob(self.jobs_, task);
        });
    }
    emit self.changed();
}

void StepSession::Impl::finish(const std::shared_ptr<Task>& task)
{
    if (task != current) return;  // taken already, or abandoned
    current.reset();
    self.seeking_ = false;
    take(*task);
    if (pending) {
        Command next = std::move(*pending);
        pending.reset();
        return run(std::move(next));
    }
    emit self.changed();
}

void StepSession::Impl::take(Task& task)
{
    history.append(task.passed);
    if (!task.cancelled) error = task.error;
    if (!task.error.isEmpty()) self.timer_.stop();
    if (task.command.batch && task.seconds < batchLeast) batchSteps = std::min<size_t>(2 * batchSteps, 1 << 20);
    if (task.command.batch && task.seconds > batchMost) batchSteps = std::max<size_t>(batchSteps / 2, 1);
    if (task.cancelled || !task.error.isEmpty()) return;
    record = std::move(task.record);
    value = std::move(task.value);
    position = task.position;
    length = task.length;
    if (length > 0 && position + 1 >= length) self.timer_.stop();
}

// Where the moves already ordered will lead.
size_t StepSession::Impl::goal() const
{
    if (pending && !pending->wanted) return pending->target;
    if (current && !current->command.wanted && !current->progress.cancelled) return current->command.target;
    return position;
}

// The next place to stop at after `from`, if it was passed before.
std::optional<size_t> StepSession::Impl::knownNext(size_t from, Unit by) const
{
    if (length > 0 && from + 1 >= length) return length - 1;
    if (by == Unit::Step) return from + 1;
    size_t found = by == Unit::Named ? history.nextOf(unitPhase.toStdString(), from) : StepHistory::npos;
    for (size_t p = from + 1; by == Unit::Phase && p < history.end(); ++p)
        if (history.phaseAt(p) != history.phaseAt(from)) {
            found = p;
            break;
        }
    if (found != StepHistory::npos) return found;
    if (length > 0 && history.end() >= length) return length - 1;
    return std::nullopt;
}

// The same for steps that were not passed yet. It runs on the worker, so it holds copies.
Wanted StepSession::Impl::onwards(size_t from, size_t least, Unit by) const
{
    if (by == Unit::Named) return [least, phase = unitPhase.toStdString()](const StepRecord& r) { return r.index >= least && r.phase == phase; };
    return [least, before = history.phaseAt(from)](const StepRecord& r) { return r.index >= least && r.phase != before; };
}

void StepSession::Impl::advance(size_t steps, bool batch, Unit by)
{
    if (current && current->command.wanted) return;  // still looking for the stop before
    const size_t from = goal();
    const QString title = self.tr("%1: next step").arg(name());
    if (std::optional<size_t> next = knownNext(from + steps - 1, by)) return submit({*next, {}, {}, true, batch, title});
    submit({0, onwards(from, from + steps, by), {}, true, batch, title});
}

void StepSession::Impl::retreat(Unit by)
{
    const size_t from = goal();
    if (from == 0 || (current && current->command.wanted)) return;
    size_t to = from - 1;
    if (by == Unit::Named) to = history.previousOf(unitPhase.toStdString(), from);
    // To the start of this phase, or of the one before when it stands there already.
    while (by == Unit::Phase && to > 0 && history.phaseAt(to - 1) == history.phaseAt(to)) --to;
    submit({to == StepHistory::npos ? 0 : to, {}, {}, true, false, self.tr("%1: step back").arg(name())});
}

StepSession::StepSession(Document& document, Jobs& jobs, QObject* parent)
    : QObject(parent), impl_(std::make_unique<Impl>(*this)), document_(document), jobs_(jobs)
{
    connect(&timer_, &QTimer::timeout, this, &StepSession::tick);
    impl_->subscription = document_.subscribe([this](const Change&) { documentChanged(); });
}

StepSession::~StepSession()
{
    impl_->abandon();
    impl_->pool.waitForDone();
}

void StepSession::open(const Operation& op, NodeId node, const Value& input, ParameterValues values)
{
    timer_.stop();
    impl_->abandon();
    const bool other = op_ != &op;
    op_ = &op;
    node_ = node;
    values_ = std::move(values);
    if (other) impl_->unit = Unit::Step, impl_->unitPhase.clear(), impl_->plotted.clear();
    impl_->input = input;
    impl_->engine = std::make_shared<Engine>();
    impl_->history = StepHistory();
    impl_->history.add({});
    impl_->record = {};
    impl_->value = op.accepts == op.yields ? input : Value{};
    impl_->position = impl_->length = 0;
    impl_->error.clear();
    impl_->edited = false;
    const Node* n = document_.scene().find(node);
    impl_->openedOn = n && n->mesh && op.accepts == Kind::Mesh ? document_.scene().shared(n->mesh) : nullptr;
    try {
        impl_->engine->start =
            stepping(op, input, values_, othersOf(op, values_, [this](const std::string& name) { return shownBy(document_, name); }));
    } catch (const Error& e) {
        impl_->error = QString::fromUtf8(e.what());
    }
    emit opened();
    emit changed();
}

void StepSession::close()
{
    if (!op_) return;
    timer_.stop();
    impl_->abandon();
    impl_->engine.reset();
    impl_->input = impl_->value = Value{};
    impl_->history = StepHistory();
    impl_->record = {};
    impl_->position = impl_->length = 0;
    impl_->openedOn.reset();
    op_ = nullptr;
    node_ = {};
    emit closed();
    emit changed();
}

void StepSession::setValues(ParameterValues values)
{
    if (!op_) return;
    const Value input = impl_->input;
    open(*op_, node_, input, std::move(values));
}

const StepRecord& StepSession::step() const
{
    return impl_->record;
}

const Value* StepSession::value() const
{
    return op_ ? &impl_->value : nullptr;
}

size_t StepSession::position() const
{
    return impl_->position;
}

size_t StepSession::length() const
{
    return impl_->length;
}

size_t StepSession::estimatedLength() const
{
    if (impl_->length > 0) return impl_->length;
    const StepHistory& h = impl_->history;
    if (h.progress() < 0.02f || h.progressAt() < 8) return 0;
    return std::max(h.end(), size_t(double(h.progressAt()) / h.progress()));
}

bool StepSession::atEnd() const
{
    return impl_->length > 0 && impl_->position + 1 >= impl_->length;
}

const QString& StepSession::error() const
{
    return impl_->error;
}

const std::vector<std::pair<size_t, double>>& StepSession::series(const std::string& number) const
{
    return impl_->history.series(number);
}

std::vector<std::string> StepSession::seriesNames() const
{
    return impl_->history.seriesNames();
}

const StepHistory& StepSession::history() const
{
    return impl_->history;
}

const QStringList& StepSession::plotted() const
{
    return impl_->plotted;
}

void StepSession::setPlotted(const QStringList& numbers)
{
    impl_->plotted = numbers.mid(0, 6);
    emit changed();
}

void StepSession::setUnit(Unit u, const QString& phase)
{
    impl_->unit = u;
    impl_->unitPhase = phase;
    emit changed();
}

StepSession::Unit StepSession::unit() const
{
    return impl_->unit;
}

const QString& StepSession::unitPhase() const
{
    return impl_->unitPhase;
}

void StepSession::setSpeed(double stepsPerSecond)
{
    impl_->speed = stepsPerSecond;
    timer_.setInterval(stepsPerSecond > 0 ? std::max(1, int(1000 / stepsPerSecond)) : 15);
}

double StepSession::speed() const
{
    return impl_->speed;
}

bool StepSession::edited() const
{
    return impl_->edited;
}

namespace {

// The level of a stack that a mesh is the result of; the base when it is none.
size_t levelOf(const Document& document, MeshId id, const Mesh& mesh)
{
    const auto e = document.evaluation(id);
    for (size_t i = e ? e->levels.size() : 0; i > 0; --i)
        if (e->at(i).positions().id() == mesh.positions().id() && e->at(i).cornerVertex().id() == mesh.cornerVertex().id()) return i;
    return 0;
}

}  // namespace

void StepSession::keepAsBase()
{
    const Node* n = op_ ? document_.scene().find(node_) : nullptr;
    const Mesh* mesh = std::get_if<Mesh>(&impl_->value);
    if (!n || !n->mesh || !mesh) return;
    document_.cancelPreview();
    Scene next = document_.scene();
    MeshObject object = *next.find(n->mesh);
    EditCall call{"keep-step",
                  {{"node", nodeText(next, node_)},
                   {"op", op_->id},
                   {"with", printed(op_->parameters, values_)},
                   {"step", int64_t(impl_->position)},
                   {"level", int64_t(levelOf(document_, n->mesh, std::get<Mesh>(impl_->input)))}}};
    object.base = *mesh;
    object.stack.clear();
    next.set(n->mesh, std::move(object));
    const auto before = document_.snapshot();
    close();
    commitEdited(document_, call, *before, std::move(next), {});
}

bool StepSession::isOfCharacter() const
{
    return op_ && document_.scene().find(node_) && std::holds_alternative<Pose>(impl_->value) && std::holds_alternative<Pose>(impl_->input);
}

ClipId StepSession::keepAsClip()
{
    if (!isOfCharacter()) return {};
    const Pose from = std::get<Pose>(impl_->input), to = std::get<Pose>(impl_->value);
    const QString title = tr("%1 as clip").arg(impl_->name());
    Scene next = document_.scene();
    const ClipId clip = next.add(keyed(from, to, 1, impl_->name().toStdString()));
    close();
    document_.commit(title.toStdString(), std::move(next));
    return clip;
}

void StepSession::documentChanged()
{
    if (!op_ || !node_) return;
    const Node* n = document_.scene().find(node_);
    if (!n || (op_->accepts == Kind::Mesh && !n->mesh)) return close();
    if (!n->mesh) return;
    const std::shared_ptr<const MeshObject> now = document_.scene().shared(n->mesh);
    const bool edited = impl_->openedOn && now != impl_->openedOn && !sameShape(*now, *impl_->openedOn);
    if (edited == impl_->edited) return;
    impl_->edited = edited;
    if (edited) timer_.stop();
    emit changed();
}

void StepSession::play()
{
    if (!op_ || playing()) return;
    if (atEnd()) impl_->submit({0, {}, {}, false, false, impl_->name()});
    setSpeed(impl_->speed);
    timer_.start();
    emit changed();
}

void StepSession::pause()
{
    if (!playing()) return;
    timer_.stop();
    emit changed();
}

void StepSession::tick()
{
    if (impl_->current) return;
    if (atEnd()) return pause();
    impl_->advance(impl_->speed > 0 ? 1 : impl_->batchSteps, impl_->speed <= 0, impl_->unit);
}

void StepSession::forward()
{
    if (!op_) return;
    pause();
    impl_->advance(1, false, impl_->unit);
}

void StepSession::back()
{
    if (!op_) return;
    pause();
    impl_->retreat(impl_->unit);
}

void StepSession::nextPhase()
{
    if (!op_) return;
    pause();
    impl_->advance(1, false, Unit::Phase);
}

void StepSession::lastPhase()
{
    if (!op_) return;
    pause();
    impl_->retreat(Unit::Phase);
}

void StepSession::skip(int steps)
{
    const size_t from = impl_->goal();
    scrub(steps < 0 && from < size_t(-steps) ? 0 : from + size_t(steps));
}

void StepSession::first()
{
    seek(0);
}

void StepSession::last()
{
    if (!op_) return;
    pause();
    const QString title = tr("%1: run to the end").arg(impl_->name());
    if (length() > 0) return impl_->submit({length() - 1, {}, {}, false, false, title});
    impl_->submit({0, [](const StepRecord&) { return false; }, {}, false, false, title});
}

void StepSession::seek(size_t position)
{
    if (!op_) return;
    pause();
    impl_->submit({position, {}, {}, false, false, tr("%1: go to step %2").arg(impl_->name(), QLocale().toString(qulonglong(position)))});
}

void StepSession::scrub(size_t position)
{
    if (!op_) return;
    pause();
    impl_->submit({position, {}, {}, true, false, tr("%1: go to step %2").arg(impl_->name(), QLocale().toString(qulonglong(position)))});
}

void StepSession::toPhase(const QString& phase)
{
    if (!op_) return;
    pause();
    const std::string name = phase.toStdString();
    const QString title = tr("%1: run to %2").arg(impl_->name(), phase);
    const size_t known = impl_->history.nextOf(name, impl_->position);
    if (known != StepHistory::npos) return impl_->submit({known, {}, {}, false, false, title});
    impl_->submit({0, [name](const StepRecord& r) { return r.phase == name; }, phase, false, false, title});
}

void StepSession::toLines(unsigned firstLine, unsigned lastLine)
{
    if (!op_) return;
    pause();
    const QString title = tr("%1: run to line %2").arg(impl_->name()).arg(firstLine);
    const size_t known = impl_->history.nextAtLines(firstLine, lastLine, impl_->position);
    if (known != StepHistory::npos) return impl_->submit({known, {}, {}, false, false, title});
    const auto wanted = [firstLine, lastLine](const StepRecord& r) { return r.line >= firstLine && r.line <= lastLine; };
    impl_->submit({0, wanted, {}, false, false, title});
}

}  // namespace mw
