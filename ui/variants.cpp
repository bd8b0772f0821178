#include "ui/variants.h"

#include <algorithm>

#include "core/catalog/others.h"
#include "ui/evaluation_service.h"
#include "ui/parameter_form.h"
#include "ui/stack_edits.h"

namespace mw {
namespace {

constexpr size_t mostVariants = 3;  // beside the result in four views

/// Which row it stands in, and whether that is on, is no matter.
bool isVariant(const Modifier& m, const Modifier& variant)
{
    return m.operation == variant.operation && m.values == variant.values;
}

std::string beginning(const std::string& id)
{
    return id.substr(0, id.find('-'));
}

}  // namespace

std::optional<size_t> lastModifier(const MeshObject& object)
{
    for (size_t i = object.stack.size(); i-- > 0;)
        if (object.stack[i].enabled && findOperation(object.stack[i].operation)) return i;
    return std::nullopt;
}

std::vector<const Operation*> alternatives(const Modifier& last)
{
    const Operation* own = findOperation(last.operation);
    std::vector<const Operation*> out;
    if (!own) return out;
    for (const Operation& op : catalog())
        if (&op == own || (op.category == own->category && op.accepts == Kind::Mesh && op.yields == Kind::Mesh && !needsOthers(op)))
            out.push_back(&op);
    const auto distance = [own](const Operation* op) { return op == own ? 0 : beginning(op->id) == beginning(own->id) ? 1 : 2; };
    std::stable_sort(out.begin(), out.end(), [&](const Operation* a, const Operation* b) { return distance(a) < distance(b); });
    return out;
}

Modifier withOperation(const Modifier& from, const Operation& op)
{
    Modifier m = from;
    m.operation = op.id;
    m.values.clear();
    for (const Parameter& p : op.parameters) {
        const auto value = from.values.find(p.name);
        if (value == from.values.end()) continue;
        try {
            m.values = checked(op.parameters, [&] {
                ParameterValues more = m.values;
                more[p.name] = value->second;
                return more;
            }());
        } catch (const Error&) {
            // The same name for something else: it keeps its default.
        }
    }
    m.values = unlikeDefaults(op.parameters, m.values);
    return m;
}

std::vector<Modifier> variantsOf(const Modifier& last)
{
    std::vector<Modifier> out;
    const Operation* own = findOperation(last.operation);
    if (!own) return out;
    for (const Parameter& p : own->parameters) {
        if (p.type != ParameterType::Choice || p.choices.size() < 3 || p.name.rfind("weight", 0) != 0) continue;
        const ParameterValue present = valueOf(p, last.values);
        for (const std::string& choice : p.choices) {
            if (ParameterValue(choice) == present || out.size() == mostVariants) continue;
            out.push_back(last);
            out.back().values[p.name] = choice;
        }
        return out;
    }
    for (const Operation* op : alternatives(last))
        if (op != own && beginning(op->id) == beginning(own->id) && out.size() < mostVariants) out.push_back(withOperation(last, *op));
    return out;
}

QString variantName(const Modifier& m, const Modifier& other)
{
    const Operation* op = findOperation(m.operation);
    if (!op || m.operation != other.operation) return edits::titleOf(m);
    QStringList differences;
    for (const Parameter& p : op->parameters)
        if (const ParameterValue v = valueOf(p, m.values); !(v == valueOf(p, other.values))) differences << valueText(p, v);
    return differences.isEmpty() ? edits::titleOf(m) : differences.join(", ");
}

bool showsVariant(const ViewSettings& look, MeshId mesh)
{
    const auto level = look.shownLevel.find(mesh);
    return level != look.shownLevel.end() && level->second == variantLevel && look.variant.count(mesh);
}

bool showsVariant(const ViewSettings& look, const Scene& scene, NodeId node)
{
    const Node* n = scene.find(node);
    return n && n->mesh && showsVariant(look, n->mesh);
}

Mesh shownVariant(const Session& session, const ViewSettings& look, MeshId id)
{
    const MeshObject* object = session.document.scene().find(id);
    const std::optional<size_t> last = object ? lastModifier(*object) : std::nullopt;
    if (!last || !session.evaluations || !showsVariant(look, id)) return session.document.shownMesh(id);
    const VariantService::State s = session.evaluations->variants().state(id, look.variant.at(id));
    if (s.mesh) return *s.mesh;
    if (s.running) return session.document.shownMesh(id);  // has what the colours ask for
    const auto e = session.document.evaluation(id);
    return *last == 0 ? object->base : e && *last <= e->levels.size() ? e->at(*last) : session.document.shownMesh(id);
}

VariantService::VariantService(Document& document, Jobs& jobs, std::shared_ptr<Evaluator> evaluator, QObject* parent)
    : QObject(parent), document_(document), jobs_(jobs), evaluator_(std::move(evaluator))
{
    subscription_ = document_.subscribe([this](const Change& c) {
        if (!(c.aspects & Aspect::File) || document_.history().size() != 1) return;  // another document: its ids mean other things
        drop([](const Entry&) { return true; });
    });
    connect(&jobs_, &Jobs::changed, this, &VariantService::hearOfJobs);
}

VariantService::Entry* VariantService::find(const MeshObject* object)
{
    const auto e = std::find_if(entries_.begin(), entries_.end(), [object](const Entry& one) { return one.object.get() == object; });
    return e == entries_.end() ? nullptr : &*e;
}

VariantService::State VariantService::state(MeshId id, const Modifier& variant)
{
    const auto present = document_.scene().shared(id);
    const std::optional<size_t> last = present ? lastModifier(*present) : std::nullopt;
    if (!last) return {};
    auto object = std::make_shared<MeshObject>(*present);
    object->stack.resize(*last + 1);
    const ModifierId row = object->stack.back().id;
    object->stack.back() = variant;
    object->stack.back().id = row;
    object->stack.back().enabled = true;
    const auto scene = refersToOthers(*object) ? document_.snapshot() : nullptr;
    for (const Entry& e : entries_)
        if (e.id == id && e.scene == scene && sameWork(*e.object, *object)) return e.state;
    // What it gave for another input is out of date: shown until the new result is there.
    std::optional<Mesh> before;
    drop([&](const Entry& e) {
        const bool same = e.id == id && isVariant(e.object->stack.back(), variant);
        if (same && e.state.mesh) before = e.state.mesh;
        return same;
    });
    return begin({id, object, scene, 0, {std::move(before), true, {}}}).state;
}

void VariantService::keep(const std::vector<std::pair<MeshId, Modifier>>& shown)
{
    drop([&](const Entry& e) {
        return std::none_of(shown.begin(), shown.end(),
                            [&](const auto& s) { return s.first == e.id && isVariant(e.object->stack.back(), s.second); });
    });
}

// Jobs tell at once that they are cancelled: the entries are gone by then.
void VariantService::drop(const std::function<bool(const Entry&)>& which)
{
    std::vector<quint64> idle;
    entries_.remove_if([&](const Entry& e) {
        if (!which(e)) return false;
        if (e.state.running) idle.push_back(e.job);
        return true;
    });
    for (const quint64 job : idle) jobs_.cancel(job);
}

VariantService::Entry& VariantService::begin(Entry made)
{
    const auto object = made.object;
    entries_.push_back(std::move(made));
    Entry& entry = entries_.back();
    entry.job = jobs_.start(
        "Variant: " + edits::titleOf(object->stack.back()),
        [this, object, scene = document_.snapshot(), evaluator = evaluator_](Progress& progress) -> std::function<void()> {
            auto result = std::make_shared<Evaluation>(evaluator->evaluate(*object, &progress, {}, scene.get()));
            warm(result->result());
            return [this, object, result] {
                Entry* e = find(object.get());
                if (!e) return;
                const Level& last = result->levels.back();
                e->state = {{}, false, QString::fromStdString(last.waits ? "A modifier before it could not run." : last.error)};
                if (e->state.failure.isEmpty()) e->state.mesh = last.mesh;
                emit changed();
            };
        },
        [this, object](const QString& text) {
            if (Entry* e = find(object.get())) e->state = {{}, false, text};
            emit changed();
        });
    return entry;
}

// A job that somebody cancels calls nobody back.
void VariantService::hearOfJobs()
{
    bool heard = false;
    for (Entry& e : entries_) {
        if (!e.state.running || !e.job) continue;
        for (const Job& j : jobs_.jobs())
            if (j.id == e.job && j.state == Job::State::Cancelled) {
                e.state = {{}, false, "Cancelled. Choose it again, or change a parameter, to run it."};
                heard = true;
            }
    }
    if (heard) emit changed();
}

}  // namespace mw
