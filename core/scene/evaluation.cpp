#include "core/scene/evaluation.h"

#include <chrono>
#include <nlohmann/json.hpp>

namespace mw {

namespace {

// Two meshes are the same input when all their arrays are.
bool sameMesh(const Mesh& a, const Mesh& b)
{
    if (a.positions().id() != b.positions().id() || a.faceStart().id() != b.faceStart().id() || a.cornerVertex().id() != b.cornerVertex().id() ||
        a.lines().id() != b.lines().id() || a.attributes().size() != b.attributes().size())
        return false;
    for (size_t i = 0; i < a.attributes().size(); ++i)
        if (a.attributes()[i].id() != b.attributes()[i].id() || a.attributes()[i].name != b.attributes()[i].name) return false;
    return true;
}

}  // namespace

std::optional<Level> Evaluator::find(const Mesh& input, const std::string& key)
{
    const std::lock_guard lock(mutex_);
    for (auto e = entries_.begin(); e != entries_.end(); ++e) {
        if (e->key != key || !sameMesh(e->input, input)) continue;
        entries_.splice(entries_.begin(), entries_, e);
        return Level{e->output, {}, false, true, e->seconds};
    }
    return std::nullopt;
}

void Evaluator::keep(Entry entry)
{
    const std::lock_guard lock(mutex_);
    bytes_ += entry.output.bytes();
    entries_.push_front(std::move(entry));
    while (bytes_ > keepBytes_ && entries_.size() > 1) {
        bytes_ -= entries_.back().output.bytes();
        entries_.pop_back();
    }
}

Level Evaluator::run(const Mesh& input, const Modifier& modifier, size_t level, size_t levels, Progress* progress)
{
    const Operation& op = operation(modifier.operation);
    if (op.accepts != Kind::Mesh || op.yields != Kind::Mesh) throw Error(op.id + " is no modifier: it does not make a mesh from a mesh");
    const ParameterValues values = checked(op.parameters, modifier.values);
    const std::string key = op.id + toJson(values).dump();
    if (auto known = find(input, key)) return *known;
    const auto begin = std::chrono::steady_clock::now();
    const std::unique_ptr<Run> run = op.start(input, values, false);
    while (run->advance())
        if (progress) progress->at((float(level) + std::max(0.f, run->step().progress())) / float(levels));
    Level result;
    result.mesh = std::get<Mesh>(valueOf(run->snapshot()));
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    keep({input, result.mesh, key, result.seconds});
    return result;
}

Evaluation Evaluator::evaluate(const MeshObject& object, Progress* progress, const std::function<void(size_t)>& levelStarts)
{
    Evaluation out;
    out.base = object.base;
    bool failed = false;
    for (size_t i = 0; i < object.stack.size(); ++i) {
        const Mesh& input = out.result();
        Level level;
        level.mesh = input;
        if (object.stack[i].enabled) {
            if (levelStarts) levelStarts(i);
            if (failed)
                level.waits = true;
            else
                try {
                    level = run(input, object.stack[i], i, object.stack.size(), progress);
                } catch (const std::bad_alloc&) {
                    level.error = "there is not enough memory for it; make the mesh smaller before it";
                } catch (const std::exception& e) {
                    level.error = e.what();
                }
            failed = failed || !level.error.empty();
        }
        out.levels.push_back(std::move(level));
    }
    if (progress) progress->at(1);
    return out;
}

}  // namespace mw
