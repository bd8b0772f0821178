#include "core/scene/evaluation.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "core/catalog/others.h"

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

bool sameOthers(const Others& a, const Others& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& x, const auto& y) { return x.first == y.first && sameMesh(x.second, y.second); });
}

}  // namespace

std::optional<Level> Evaluator::find(const Mesh& input, const std::string& key, const Others& others)
{
    const std::lock_guard lock(mutex_);
    for (auto e = entries_.begin(); e != entries_.end(); ++e) {
        if (e->key != key || !sameMesh(e->input, input) || !sameOthers(e->others, others)) continue;
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

std::optional<Mesh> Evaluator::meshOf(const Scene& scene, const std::string& node, Progress* progress)
{
    return meshAt(node, progress, {&scene});
}

std::optional<Mesh> Evaluator::meshAt(const std::string& name, Progress* progress, const Place& place)
{
    if (!place.scene) return std::nullopt;
    for (const NodeId id : place.scene->nodes()) {
        const Node& node = place.scene->node(id);
        const MeshObject* object = node.name == name ? place.scene->find(node.mesh) : nullptr;
        if (!object) continue;
        if (std::count(place.way.begin(), place.way.end(), name))
            throw Error("\"" + name + "\" works with itself by its modifiers; choose another mesh");
        Place next = place;
        next.way.push_back(name);
        Evaluation e = evaluateAt(*object, nullptr, {}, next);
        if (progress) progress->at(progress->fraction);
        for (const Level& l : e.levels)
            if (!l.error.empty()) throw Error("\"" + name + "\": " + l.error);
        return e.result();
    }
    return std::nullopt;
}

Others Evaluator::others(const Operation& op, const ParameterValues& values, Progress* progress, const Place& place)
{
    const auto find = [&](const std::string& name) -> std::optional<Mesh> {
        if (std::optional<Mesh> mesh = meshAt(name, progress, place)) return mesh;
        {
            const std::lock_guard lock(mutex_);
            if (const auto known = sources_.find(name); known != sources_.end()) return known->second;
        }
        std::optional<Mesh> made = meshOfSource(name, progress);
        if (made) {
            const std::lock_guard lock(mutex_);
            sources_.emplace(name, *made);
        }
        return made;
    };
    return othersOf(op, values, find, progress);
}

Level Evaluator::run(const Mesh& input, const Modifier& modifier, size_t level, size_t levels, Progress* progress, const Place& place)
{
    const Operation& op = operation(modifier.operation);
    if (op.accepts != Kind::Mesh || op.yields != Kind::Mesh) throw Error(op.id + " is no modifier: it does not make a mesh from a mesh");
    const ParameterValues values = checked(op.parameters, modifier.values);
    const std::string key = op.id + toJson(values).dump();
    const Others with = needsOthers(op) ? others(op, values, progress, place) : Others();
    if (auto known = find(input, key, with)) return *known;
    const auto begin = std::chrono::steady_clock::now();
    const std::unique_ptr<Run> run = op.start(input, values, with, false);
    while (run->advance())
        if (progress) progress->at((float(level) + std::max(0.f, run->step().progress())) / float(levels));
    Level result;
    result.mesh = std::get<Mesh>(valueOf(run->snapshot()));
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    keep({input, result.mesh, key, result.seconds, with});
    return result;
}

Evaluation Evaluator::evaluate(const MeshObject& object, Progress* progress, const std::function<void(size_t)>& levelStarts, const Scene* scene)
{
    return evaluateAt(object, progress, levelStarts, {scene});
}

Evaluation Evaluator::evaluateAt(const MeshObject& object, Progress* progress, const std::function<void(size_t)>& levelStarts, const Place& place)
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
                    level = run(input, object.stack[i], i, object.stack.size(), progress, place);
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
