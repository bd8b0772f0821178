#include "core/steps/stepper.h"

#include <cstring>

namespace mw {

namespace {
constexpr size_t window = 16;  // states kept before a position that was reached by running again
}

StepRecord recordOf(const Run& run, size_t index)
{
    const Step& s = run.step();
    StepRecord r;
    r.index = index;
    r.phase = s.phase();
    r.focus.assign(s.focus().begin(), s.focus().end());
    for (const Step::Ring& ring : s.rings()) {
        const bool edges = ring.kind == ElementKind::Edge;
        for (size_t i = 0; i + edges < ring.indices.size(); i += 1 + edges)
            r.focus.push_back({ring.kind, ring.role, nullptr, ring.indices[i], edges ? ring.indices[i + 1] : 0, {}, {}});
    }
    r.numbers.assign(s.numbers().begin(), s.numbers().end());
    r.progress = s.progress();
    r.file = run.where().file_name();
    r.line = run.where().line();
    return r;
}

Stepper::Stepper(StartRun start, size_t keepBytes) : start_(std::move(start)), keepBytes_(keepBytes)
{
    restart();
}

Stepper::~Stepper() = default;

bool Stepper::atEnd() const
{
    return length_ > 0 && position_ + 1 == length_;
}

void Stepper::restart()
{
    run_ = start_(true);
    runPosition_ = 0;
    runEnded_ = false;
}

bool Stepper::pull()
{
    if (runEnded_) return false;
    runEnded_ = !run_->advance();
    ++runPosition_;
    if (runEnded_) length_ = runPosition_ + 1;
    return true;
}

const Stepper::Kept* Stepper::kept(size_t position) const
{
    for (auto k = kept_.rbegin(); k != kept_.rend(); ++k)
        if (k->record.index == position) return &*k;
    return nullptr;
}

// Keeps the state run_ is at, as long as the oldest can be let go for it.
void Stepper::keep()
{
    if (kept(runPosition_)) return;
    Kept k;
    if (runEnded_)
        k.record.phase = "end", k.record.progress = 1;
    else if (runPosition_ > 0)
        k.record = recordOf(*run_, runPosition_);
    k.record.index = runPosition_;
    k.snapshot = run_->snapshot();
    keptBytes_ += k.snapshot.bytes;
    kept_.push_back(std::move(k));
    while (keptBytes_ > keepBytes_ && kept_.size() > 2) {
        keptBytes_ -= kept_.front().snapshot.bytes;
        kept_.pop_front();
    }
}

const Snapshot& Stepper::value()
{
    if (!kept(position_)) seek(position_);
    return kept(position_)->snapshot;
}

bool Stepper::forward()
{
    if (atEnd()) return false;
    seek(position_ + 1);
    return true;
}

bool Stepper::back()
{
    if (position_ == 0) return false;
    seek(position_ - 1);
    return true;
}

void Stepper::seek(size_t wanted, Progress* progress)
{
    if (length_ > 0) wanted = std::min(wanted, length_ - 1);
    if (!kept(wanted)) {
        if (runPosition_ > wanted) {
            // The kept states no longer lead to it: begin anew and keep the window before it.
            kept_.clear();
            keptBytes_ = 0;
            restart();
        }
        if (runPosition_ + window >= wanted) keep();
        while (runPosition_ < wanted) {
            if (progress && wanted > 0) progress->at(float(runPosition_) / float(wanted));
            if (!pull()) break;
            if (runPosition_ + window >= wanted || runEnded_) keep();
        }
        wanted = std::min(wanted, runPosition_);
        keep();
    }
    position_ = wanted;
    record_ = kept(position_)->record;
}

bool Stepper::seekWhere(const std::function<bool(const StepRecord&)>& wanted, Progress* progress)
{
    // Through the kept states and a replay first: run_ may be ahead of the position.
    if (runPosition_ != position_) {
        const size_t head = runPosition_;
        for (size_t p = position_ + 1; p <= head; ++p) {
            const Kept* k = kept(p);
            if (!k) {
                seek(p, progress);
                k = kept(p);
            }
            if (k && wanted(k->record)) {
                seek(p, progress);
                return !(length_ > 0 && p + 1 == length_);
            }
        }
        position_ = head;
    }
    while (true) {
        if (progress) progress->at(runPosition_ > 0 && !runEnded_ ? std::max(0.f, run_->step().progress()) : 0.f);
        if (!pull()) break;
        if (runEnded_ || wanted(recordOf(*run_, runPosition_))) break;
    }
    keep();
    position_ = runPosition_;
    record_ = kept(position_)->record;
    return !runEnded_;
}

}  // namespace mw
