// What a last modifier is compared with: the same with another choice, or another operation of its category, run on the same input.
#pragma once
#include <QObject>
#include <functional>
#include <list>
#include <optional>

#include "core/catalog/catalog.h"
#include "core/scene/document.h"
#include "ui/jobs.h"
#include "ui/session.h"

namespace mw {

/// The row of the last modifier that runs; nothing when none does.
std::optional<size_t> lastModifier(const MeshObject& object);
/// Operations that may stand in place of it: those of its category that need no further mesh, itself first, then those whose ids begin alike.
std::vector<const Operation*> alternatives(const Modifier& last);
/// That operation with the values of `from` that it understands.
Modifier withOperation(const Modifier& from, const Operation& op);
/// At most three: the other choices of its weights when there are several, else the alternatives whose ids begin alike.
std::vector<Modifier> variantsOf(const Modifier& last);
/// How `m` differs from `other`: its operation, or the parameters that are not the same, "weights harmonic".
QString variantName(const Modifier& m, const Modifier& other);

bool showsVariant(const ViewSettings& look, MeshId mesh);
bool showsVariant(const ViewSettings& look, const Scene& scene, NodeId node);
/// What a view shows while it shows a variant: its mesh; while it is computed the one before, or the result; the input when it cannot run.
Mesh shownVariant(const Session& session, const ViewSettings& look, MeshId mesh);

/// Evaluates variants as jobs, by the evaluator of the stacks: what comes before the last modifier is not computed again.
class VariantService : public QObject {
    Q_OBJECT

public:
    VariantService(Document& document, Jobs& jobs, std::shared_ptr<Evaluator> evaluator, QObject* parent);

    struct State {
        std::optional<Mesh> mesh;  ///< of before while it runs
        bool running = false;
        QString failure;
    };
    /// Of the mesh with `variant` in place of its last modifier. Begins when it is not known; changed() follows.
    State state(MeshId id, const Modifier& variant);
    /// Drops all others, and ends what runs for them.
    void keep(const std::vector<std::pair<MeshId, Modifier>>& shown);

signals:
    void changed();

private:
    struct Entry {
        MeshId id;
        std::shared_ptr<const MeshObject> object;  // with the variant
        std::shared_ptr<const Scene> scene;        // only when other meshes come in
        quint64 job = 0;
        State state;
    };
    Entry* find(const MeshObject* object);
    void drop(const std::function<bool(const Entry&)>& which);
    Entry& begin(Entry made);
    void hearOfJobs();

    Document& document_;
    Jobs& jobs_;
    std::shared_ptr<Evaluator> evaluator_;
    std::list<Entry> entries_;
    std::shared_ptr<void> subscription_;
};

}  // namespace mw
