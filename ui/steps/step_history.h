// What is remembered of the steps passed: where each phase and source line came, what was refused, and the named numbers for the plot.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/steps/stepper.h"

namespace mw {

/// A few bytes a step, however large the mesh. A worker fills one of its own, the window's thread appends it to the one that is shown.
class StepHistory {
public:
    using Points = std::vector<std::pair<size_t, double>>;
    static constexpr size_t npos = ~size_t(0);

    /// One that goes on where a history of `first` positions ends.
    explicit StepHistory(size_t first = 0) : first_(first) {}
    /// The step at position `end()`. Others are ignored: they were passed before.
    void add(const StepRecord& r);
    void append(const StepHistory& newer);

    size_t end() const { return first_ + siteOf_.size(); }
    float progress() const { return progress_; }  ///< at the last step that said one; 0 before
    size_t progressAt() const { return progressAt_; }

    /// Empty for a name that never came.
    const Points& series(const std::string& number) const;
    std::vector<std::string> seriesNames() const;

    const std::string& phaseAt(size_t position) const;
    std::vector<std::string> phases() const;  ///< in order of their first step; the end is none
    size_t countOf(const std::string& phase, size_t upTo) const;
    /// The nearest step after or before `position`; npos when none was seen.
    size_t nextOf(const std::string& phase, size_t position) const;
    size_t previousOf(const std::string& phase, size_t position) const;
    size_t nextAtLines(unsigned firstLine, unsigned lastLine, size_t position) const;
    std::vector<unsigned> lines() const;  ///< that yielded so far
    const std::vector<uint32_t>& rejected() const { return rejected_; }

private:
    struct Site {  // one co_yield
        std::string phase;
        unsigned line;
        std::vector<uint32_t> steps;
    };
    struct Series {
        std::string name;
        const char* key;  // its name has static storage
        size_t stride = 1, count = 0;
        Points points;
        void add(size_t step, double value);
    };
    uint8_t siteOf(const StepRecord& r);
    Series& seriesOf(const char* name);

    size_t first_;
    std::vector<Site> sites_;
    std::vector<uint8_t> siteOf_;
    std::vector<Series> series_;
    std::vector<uint32_t> rejected_;
    float progress_ = 0;
    size_t progressAt_ = 0;
};

}  // namespace mw
