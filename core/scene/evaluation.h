// What a modifier stack gives: the mesh at each level. Pure; cached by what goes in.
#pragma once
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "core/steps/progress.h"

namespace mw {

struct Level {
    Mesh mesh;            ///< after this modifier; the one before it when switched off or failed
    std::string error;    ///< why it could not run; empty when it did or is off
    bool waits = false;   ///< a modifier before it failed
    bool cached = false;  ///< not computed this time
    double seconds = 0;   ///< the time it took when it was computed
};

/// levels[i] belongs to stack[i]. With an error, result() is the last good mesh before it.
struct Evaluation {
    Mesh base;
    std::vector<Level> levels;
    const Mesh& result() const { return levels.empty() ? base : levels.back().mesh; }
    const Mesh& at(size_t level) const { return level == 0 ? base : levels[level - 1].mesh; }  ///< 0 is the base
};

/// Keeps results by (input identity, operation, parameters), at most `keepBytes`. Thread safe.
class Evaluator {
public:
    explicit Evaluator(size_t keepBytes = size_t(1) << 30) : keepBytes_(keepBytes) {}
    /// Throws Cancelled. Progress runs over the whole stack; `levelStarts`, when given, is told the level that begins.
    Evaluation evaluate(const MeshObject& object, Progress* progress = nullptr, const std::function<void(size_t)>& levelStarts = {});

private:
    struct Entry {
        Mesh input, output;  // input is held so that its identity stays unique
        std::string key;
        double seconds;
    };
    std::optional<Level> find(const Mesh& input, const std::string& key);
    void keep(Entry entry);
    Level run(const Mesh& input, const Modifier& modifier, size_t level, size_t levels, Progress* progress);

    std::mutex mutex_;
    std::list<Entry> entries_;  // most recent first
    size_t bytes_ = 0, keepBytes_;
};

}  // namespace mw
