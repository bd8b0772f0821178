// See step_history.h.
#include "ui/steps/step_history.h"

#include <algorithm>
#include <cmath>

namespace mw {

namespace {
constexpr size_t maxPoints = 100'000;
constexpr size_t maxSites = 255;
}  // namespace

void StepHistory::Series::add(size_t step, double value)
{
    if (count++ % stride != 0) return;
    points.emplace_back(step, value);
    if (points.size() < maxPoints) return;
    for (size_t i = 0; 2 * i < points.size(); ++i) points[i] = points[2 * i];
    points.resize((points.size() + 1) / 2);
    stride *= 2;
}

uint8_t StepHistory::siteOf(const StepRecord& r)
{
    for (size_t i = 0; i < sites_.size(); ++i)
        if (sites_[i].line == r.line && sites_[i].phase == r.phase) return uint8_t(i);
    if (sites_.size() == maxSites) return maxSites - 1;
    sites_.push_back({r.phase, r.line, {}});
    return uint8_t(sites_.size() - 1);
}

StepHistory::Series& StepHistory::seriesOf(const char* name)
{
    for (Series& s : series_)
        if (s.key == name) return s;
    for (Series& s : series_)
        if (s.name == name) return s;
    return series_.emplace_back(Series{name, name, 1, 0, {}});
}

void StepHistory::add(const StepRecord& r)
{
    if (r.index != end()) return;
    const uint8_t site = siteOf(r);
    siteOf_.push_back(site);
    sites_[site].steps.push_back(uint32_t(r.index));
    for (const Number& n : r.numbers)
        if (std::isfinite(n.value)) seriesOf(n.name).add(r.index, n.value);
    if (std::any_of(r.focus.begin(), r.focus.end(), [](const Focus& f) { return f.role == Role::Rejected; })) rejected_.push_back(uint32_t(r.index));
    if (r.progress >= 0) progress_ = r.progress, progressAt_ = r.index;
}

void StepHistory::append(const StepHistory& newer)
{
    if (newer.first_ != end()) return;
    std::vector<uint8_t> site;
    for (const Site& s : newer.sites_) {
        StepRecord key;
        key.phase = s.phase, key.line = s.line;
        site.push_back(siteOf(key));
        auto& steps = sites_[site.back()].steps;
        steps.insert(steps.end(), s.steps.begin(), s.steps.end());
    }
    for (uint8_t s : newer.siteOf_) siteOf_.push_back(site[s]);
    for (const Series& s : newer.series_) {
        Series& mine = seriesOf(s.key);
        for (const auto& [step, value] : s.points) mine.add(step, value);
    }
    rejected_.insert(rejected_.end(), newer.rejected_.begin(), newer.rejected_.end());
    if (newer.progressAt_ > 0) progress_ = newer.progress_, progressAt_ = newer.progressAt_;
}

const StepHistory::Points& StepHistory::series(const std::string& number) const
{
    static const Points nothing;
    for (const Series& s : series_)
        if (s.name == number) return s.points;
    return nothing;
}

std::vector<std::string> StepHistory::seriesNames() const
{
    std::vector<std::string> names;
    for (const Series& s : series_) names.push_back(s.name);
    return names;
}

const std::string& StepHistory::phaseAt(size_t position) const
{
    static const std::string nothing;
    return position < first_ || position >= end() ? nothing : sites_[siteOf_[position - first_]].phase;
}

std::vector<std::string> StepHistory::phases() const
{
    std::vector<std::string> names;
    for (const Site& s : sites_)
        if (!s.phase.empty() && s.line != 0 && std::find(names.begin(), names.end(), s.phase) == names.end()) names.push_back(s.phase);
    return names;
}

size_t StepHistory::countOf(const std::string& phase, size_t upTo) const
{
    size_t n = 0;
    for (const Site& s : sites_)
        if (s.phase == phase) n += size_t(std::upper_bound(s.steps.begin(), s.steps.end(), upTo) - s.steps.begin());
    return n;
}

size_t StepHistory::nextOf(const std::string& phase, size_t position) const
{
    size_t found = npos;
    for (const Site& s : sites_) {
        if (s.phase != phase) continue;
        auto i = std::upper_bound(s.steps.begin(), s.steps.end(), position);
        if (i != s.steps.end()) found = std::min(found, size_t(*i));
    }
    return found;
}

size_t StepHistory::previousOf(const std::string& phase, size_t position) const
{
    size_t found = npos;
    for (const Site& s : sites_) {
        if (s.phase != phase) continue;
        auto i = std::lower_bound(s.steps.begin(), s.steps.end(), position);
        if (i != s.steps.begin() && (found == npos || size_t(*(i - 1)) > found)) found = *(i - 1);
    }
    return found;
}

size_t StepHistory::nextAtLines(unsigned firstLine, unsigned lastLine, size_t position) const
{
    size_t found = npos;
    for (const Site& s : sites_) {
        if (s.line < firstLine || s.line > lastLine) continue;
        auto i = std::upper_bound(s.steps.begin(), s.steps.end(), position);
        if (i != s.steps.end()) found = std::min(found, size_t(*i));
    }
    return found;
}

std::vector<unsigned> StepHistory::lines() const
{
    std::vector<unsigned> found;
    for (const Site& s : sites_)
        if (s.line != 0) found.push_back(s.line);
    return found;
}

}  // namespace mw
