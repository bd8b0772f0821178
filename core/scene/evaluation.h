// What a modifier stack gives: the mesh at each level. Pure; cached by what goes in.
#pragma once
#include <functional>
#include <list>
#include <map>
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
    /// Throws Cancelled. Progress runs over the whole stack; `levelStarts`, when given, is told the level that begins. `scene` is where modifiers
    /// that work with other meshes find them, by the names of their nodes.
    Evaluation evaluate(const MeshObject& object, Progress* progress = nullptr, const std::function<void(size_t)>& levelStarts = {},
                        const Scene* scene = nullptr);
    /// What the node of that name shows; nothing when there is none, or when it shows no mesh. Throws Error when its modifiers fail or lead back to
    /// themselves.
    std::optional<Mesh> meshOf(const Scene& scene, const std::string& node, Progress* progress = nullptr);

private:
    struct Entry {
        Mesh input, output;  // input is held so that its identity stays unique
        std::string key;
        double seconds;
        Others others;
    };
    /// The way to a mesh that another one works with: names of nodes, so that a circle is seen.
    struct Place {
        const Scene* scene = nullptr;
        std::vector<std::string> way = {};
    };
    Evaluation evaluateAt(const MeshObject& object, Progress* progress, const std::function<void(size_t)>& levelStarts, const Place& place);
    std::optional<Mesh> meshAt(const std::string& node, Progress* progress, const Place& place);
    Others others(const Operation& op, const ParameterValues& values, Progress* progress, const Place& place);
    std::optional<Level> find(const Mesh& input, const std::string& key, const Others& others);
    void keep(Entry entry);
    Level run(const Mesh& input, const Modifier& modifier, size_t level, size_t levels, Progress* progress, const Place& place);

    std::mutex mutex_;
    std::list<Entry> entries_;                          // most recent first
    std::map<std::string, Mesh, std::less<>> sources_;  // meshes of sources that modifiers work with, by their text
    size_t bytes_ = 0, keepBytes_;
};

}  // namespace mw
