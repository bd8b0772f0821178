// Keeps the results of all modifier stacks up to date: listens to the document, evaluates on a worker, hands the result back.
#pragma once
#include <QObject>
#include <atomic>
#include <map>
#include <memory>

#include "core/catalog/cost.h"
#include "core/scene/document.h"
#include "ui/jobs.h"

namespace mw {

/// Makes what drawing needs (normals, triangles), so that the window's thread finds it ready.
void warm(const Mesh& mesh);
/// The same base and the same modifiers: evaluating one gives what evaluating the other does, where no other mesh comes in.
bool sameWork(const MeshObject& a, const MeshObject& b);
/// Some modifier works with other meshes, so that their changes are its own.
bool refersToOthers(const MeshObject& object);

class VariantService;

class EvaluationService : public QObject {
    Q_OBJECT

public:
    EvaluationService(Document& document, Jobs& jobs, QObject* parent = nullptr);

    struct State {
        bool running = false, cancelled = false;
        size_t level = 0;    ///< stack row that runs
        float fraction = 0;  ///< of the whole stack
        qint64 elapsed = 0;  ///< milliseconds
        QString failure;     ///< of the job itself (memory)
    };
    State state(MeshId id) const;
    void cancel(MeshId id);
    void again(MeshId id);
    void setPaused(bool paused);
    bool paused() const { return paused_; }
    bool idle() const;
    /// What a modifier on a mesh is expected to take on this machine: learnt from the runs before, also of earlier sessions.
    std::optional<Cost> expected(const Operation& op, MeshSize input, const ParameterValues& values) const;
    /// Knows the results it has made; thread safe. For jobs that write: stacks are then not evaluated again.
    std::shared_ptr<Evaluator> evaluator() const { return evaluator_; }
    /// Who evaluates what a last modifier is compared with.
    VariantService& variants() const { return *variants_; }

signals:
    void changed();  ///< began, ended, cancelled, or ten times a second while it runs

private:
    struct Request {
        std::shared_ptr<const MeshObject> object;
        std::shared_ptr<std::atomic<size_t>> level;
        quint64 job = 0;
        bool running = false, cancelled = false;
        QString failure;
    };
    void follow(const Change& change);
    void learn(const MeshObject& object, const Evaluation& e);
    void request(MeshId id, std::shared_ptr<const MeshObject> object);

    Document& document_;
    Jobs& jobs_;
    std::shared_ptr<Evaluator> evaluator_;
    VariantService* variants_;  // a child
    std::map<MeshId, Request> requests_;
    std::shared_ptr<void> subscription_;
    bool paused_ = false;
    CostRecord costs_;
};

}  // namespace mw
