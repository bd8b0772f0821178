#include "ui/evaluation_service.h"

#include <QSettings>
#include <algorithm>

#include "core/catalog/others.h"
#include "core/mesh/same_mesh.h"
#include "ui/variants.h"

namespace mw {
namespace {

constexpr const char* costKey = "evaluation/costs";

}  // namespace

bool sameWork(const MeshObject& a, const MeshObject& b)
{
    return sameMesh(a.base, b.base) && sameAttributes(a.base, b.base) && a.stack == b.stack;
}

bool refersToOthers(const MeshObject& object)
{
    return std::any_of(object.stack.begin(), object.stack.end(), [](const Modifier& m) {
        const Operation* op = m.enabled ? findOperation(m.operation) : nullptr;
        return op && needsOthers(*op);
    });
}

void warm(const Mesh& mesh)
{
    mesh.vertexNormals();
    mesh.faceNormals();
    mesh.triangulation();
    mesh.edges();
    mesh.bounds();
}

EvaluationService::EvaluationService(Document& document, Jobs& jobs, QObject* parent)
    : QObject(parent),
      document_(document),
      jobs_(jobs),
      evaluator_(std::make_shared<Evaluator>()),
      variants_(new VariantService(document, jobs, evaluator_, this))
{
    costs_ = CostRecord::fromText(QSettings().value(costKey).toString().toStdString());
    subscription_ = document_.subscribe([this](const Change& c) { follow(c); });
    connect(&jobs_, &Jobs::changed, this, [this] { emit changed(); });
}

void EvaluationService::follow(const Change& change)
{
    if (change.aspects & Aspect::File && document_.history().size() == 1) {  // another document: its ids mean other things
        for (auto& [id, r] : requests_)
            if (r.running) jobs_.cancel(r.job);
        requests_.clear();
    }
    if (paused_ || !(change.aspects & (Aspect::Mesh | Aspect::Stack | Aspect::Tree | Aspect::History | Aspect::File))) return;
    for (MeshId id : document_.scene().meshes()) {
        const auto object = document_.scene().shared(id);
        const auto known = requests_.find(id);
        if (known != requests_.end() && sameWork(*known->second.object, *object) && !refersToOthers(*object)) continue;
        request(id, object);
    }
}

void EvaluationService::request(MeshId id, std::shared_ptr<const MeshObject> object)
{
    Request& r = requests_[id];
    if (r.running) jobs_.cancel(r.job);
    r = {object, std::make_shared<std::atomic<size_t>>(0), 0, true, false, {}};
    const QString name =
        object->stack.empty() ? "Prepare " + QString::fromStdString(object->name) : "Evaluate " + QString::fromStdString(object->name);
    r.job = jobs_.start(
        name,
        [this, id, object, scene = document_.snapshot(), level = r.level, evaluator = evaluator_](Progress& progress) -> std::function<void()> {
            auto result = std::make_shared<Evaluation>(evaluator->evaluate(
                *object, &progress, [&](size_t l) { *level = l; }, scene.get()));
            warm(result->result());
            return [this, id, object, result] {
                const auto known = requests_.find(id);
                if (known == requests_.end() || known->second.object != object) return;
                known->second.running = false;
                learn(*object, *result);
                document_.setEvaluation(id, result);
                emit changed();
            };
        },
        [this, id, object](const QString& error) {
            const auto known = requests_.find(id);
            if (known == requests_.end() || known->second.object != object) return;
            known->second.running = false;
            known->second.failure = error;
            emit changed();
        });
    emit changed();
}

// Of what was computed just now; the record outlives the session.
void EvaluationService::learn(const MeshObject& object, const Evaluation& e)
{
    const std::string before = costs_.text();
    for (size_t i = 0; i < e.levels.size(); ++i) {
        const Operation* op = findOperation(object.stack[i].operation);
        const Level& l = e.levels[i];
        if (op && object.stack[i].enabled && l.error.empty() && !l.waits && !l.cached)
            costs_.learn(*op, sizeOf(e.at(i)), object.stack[i].values, l.seconds);
    }
    if (costs_.text() != before) QSettings().setValue(costKey, QString::fromStdString(costs_.text()));
}

std::optional<Cost> EvaluationService::expected(const Operation& op, MeshSize input, const ParameterValues& values) const
{
    return expectedCost(op, input, values, &costs_);
}

EvaluationService::State EvaluationService::state(MeshId id) const
{
    State s;
    const auto known = requests_.find(id);
    if (known == requests_.end()) return s;
    const Request& r = known->second;
    s.running = r.running;
    s.cancelled = r.cancelled;
    s.failure = r.failure;
    s.level = *r.level;
    for (const Job& j : jobs_.jobs())
        if (j.id == r.job) {
            s.fraction = j.progress->fraction;
            s.elapsed = j.clock.elapsed();
        }
    return s;
}

void EvaluationService::cancel(MeshId id)
{
    const auto known = requests_.find(id);
    if (known == requests_.end() || !known->second.running) return;
    jobs_.cancel(known->second.job);
    known->second.running = false;
    known->second.cancelled = true;
    emit changed();
}

void EvaluationService::again(MeshId id)
{
    if (const auto object = document_.scene().shared(id)) request(id, object);
}

void EvaluationService::setPaused(bool paused)
{
    paused_ = paused;
    if (!paused) follow({Aspect::Stack, {}});
    emit changed();
}

bool EvaluationService::idle() const
{
    for (const auto& [id, r] : requests_)
        if (r.running) return false;
    return true;
}

}  // namespace mw
