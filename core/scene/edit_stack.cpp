// Edits of modifier stacks. Modifiers are counted from 1, the base mesh is 0.
#include "core/catalog/others.h"
#include "core/scene/edit_entries.h"
#include "core/steps/stepper.h"

namespace mw {
namespace {

constexpr const char* whichNode = "Which one; all nodes that show its mesh get it.";

MeshId meshIdOf(const Scene& scene, const std::string& node)
{
    const NodeId id = nodeOf(scene, node);
    meshOf(scene, id);
    return scene.node(id).mesh;
}

Modifier& modifierOf(MeshObject& object, int64_t number)
{
    if (number < 1 || number > int64_t(object.stack.size()))
        throw Error("\"" + object.name + "\" has no modifier " + std::to_string(number) + ": it has " + std::to_string(object.stack.size()));
    return object.stack[size_t(number - 1)];
}

// Runs f(object, scene) on the mesh object of a node.
template <class F>
void change(Scene& scene, const std::string& node, F f)
{
    const MeshId id = meshIdOf(scene, node);
    MeshObject object = *scene.find(id);
    f(object);
    scene.set(id, std::move(object));
}

std::string titleOf(const std::string& operation)
{
    const Operation* op = findOperation(operation);
    return op ? op->title : operation;
}

std::string titleOf(const Scene& scene, const std::string& node, int64_t number)
{
    MeshObject object = *scene.find(meshIdOf(scene, node));
    return titleOf(modifierOf(object, number).operation);
}

ParameterValues valuesOf(const std::string& id, const std::string& with)
{
    const Operation& op = operation(id);
    try {
        return unlikeDefaults(op.parameters, parsed(op.parameters, with));
    } catch (const Error& e) {
        throw Error(op.id + ": " + e.reason());
    }
}

struct Modify {
    std::string node, op, with;
    int64_t at = 0;
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = whichNode});
        v.text("op", op, {.title = "Operation", .help = "Its id."});
        v.text("with", with, {.title = "Values", .help = "Of its parameters, as after --op ID: in quotes when there are several."});
        v.integer("at", at, {.title = "Place", .help = "Which modifier it becomes, counted from 1; 0: the last.", .min = 0, .max = 10000});
    }
};

void modify(Scene& scene, const Modify& p, EditRun&)
{
    operationOf(p.op, Kind::Mesh, Kind::Mesh);
    const ModifierId id = scene.newModifierId();
    change(scene, p.node, [&](MeshObject& o) {
        const size_t at = p.at == 0 ? o.stack.size() : std::min(size_t(p.at - 1), o.stack.size());
        o.stack.insert(o.stack.begin() + ptrdiff_t(at), {id, p.op, valuesOf(p.op, p.with), true});
    });
}

std::string modifyName(const Scene& scene, const Modify& p)
{
    return scene.node(nodeOf(scene, p.node)).name + ": add " + titleOf(p.op);
}

struct Which {
    std::string node;
    int64_t modifier = 1;
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = whichNode});
        v.integer("modifier", modifier, {.title = "Modifier", .help = "Counted from 1.", .min = 1, .max = 10000});
    }
};

void removeModifier(Scene& scene, const Which& p, EditRun&)
{
    change(scene, p.node, [&](MeshObject& o) {
        modifierOf(o, p.modifier);
        o.stack.erase(o.stack.begin() + ptrdiff_t(p.modifier - 1));
    });
}

std::string removeName(const Scene& scene, const Which& p)
{
    return titleOf(scene, p.node, p.modifier) + ": remove";
}

void duplicateModifier(Scene& scene, const Which& p, EditRun&)
{
    const ModifierId id = scene.newModifierId();
    change(scene, p.node, [&](MeshObject& o) {
        Modifier copy = modifierOf(o, p.modifier);
        copy.id = id;
        o.stack.insert(o.stack.begin() + ptrdiff_t(p.modifier), std::move(copy));
    });
}

std::string duplicateName(const Scene& scene, const Which& p)
{
    return titleOf(scene, p.node, p.modifier) + ": duplicate";
}

struct Move {
    Which which;
    int64_t to = 1;
    template <class V>
    void describe(V& v)
    {
        which.describe(v);
        v.integer("to", to, {.title = "To", .help = "Its new place, counted from 1.", .min = 1, .max = 10000});
    }
};

void moveModifier(Scene& scene, const Move& p, EditRun&)
{
    change(scene, p.which.node, [&](MeshObject& o) {
        Modifier moved = modifierOf(o, p.which.modifier);
        modifierOf(o, p.to);
        o.stack.erase(o.stack.begin() + ptrdiff_t(p.which.modifier - 1));
        o.stack.insert(o.stack.begin() + ptrdiff_t(p.to - 1), std::move(moved));
    });
}

std::string moveName(const Scene& scene, const Move& p)
{
    return titleOf(scene, p.which.node, p.which.modifier) + (p.to < p.which.modifier ? ": move up" : ": move down");
}

struct Enable {
    Which which;
    bool enabled = true;
    template <class V>
    void describe(V& v)
    {
        which.describe(v);
        v.flag("enabled", enabled, {.title = "Enabled", .help = "On, or passed over."});
    }
};

void enableModifier(Scene& scene, const Enable& p, EditRun&)
{
    change(scene, p.which.node, [&](MeshObject& o) { modifierOf(o, p.which.modifier).enabled = p.enabled; });
}

std::string enableName(const Scene& scene, const Enable& p)
{
    return titleOf(scene, p.which.node, p.which.modifier) + (p.enabled ? ": on" : ": off");
}

struct SetValues {
    Which which;
    std::string with;
    template <class V>
    void describe(V& v)
    {
        which.describe(v);
        v.text("with", with, {.title = "Values", .help = "Of its parameters; those not named get their defaults."});
    }
};

void setValues(Scene& scene, const SetValues& p, EditRun&)
{
    change(scene, p.which.node, [&](MeshObject& o) {
        Modifier& m = modifierOf(o, p.which.modifier);
        m.values = valuesOf(m.operation, p.with);
    });
}

std::string setName(const Scene& scene, const SetValues& p)
{
    MeshObject object = *scene.find(meshIdOf(scene, p.which.node));
    const Modifier& m = modifierOf(object, p.which.modifier);
    return titleOf(m.operation) + ": " + differenceText(operation(m.operation).parameters, m.values, valuesOf(m.operation, p.with));
}

struct Apply {
    std::string node;
    int64_t levels = 0;
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = whichNode});
        v.integer("levels", levels, {.title = "Levels", .help = "How many modifiers from the base; 0: all.", .min = 0, .max = 10000});
    }
};

// The result of the first modifiers becomes the base.
void applyModifiers(Scene& scene, const Apply& p, EditRun& run)
{
    change(scene, p.node, [&](MeshObject& o) {
        if (o.stack.empty()) throw Error("\"" + o.name + "\" has no modifiers");
        const size_t levels = p.levels == 0 ? o.stack.size() : size_t(p.levels);
        modifierOf(o, int64_t(levels));
        MeshObject lower = o;
        lower.stack.resize(levels);
        Evaluator own;
        const Evaluation e = (run.evaluator ? run.evaluator : &own)->evaluate(lower, run.progress, {}, &scene);
        for (size_t i = 0; i < levels; ++i)
            if (!e.levels[i].error.empty()) throw Error(titleOf(lower.stack[i].operation) + ": " + e.levels[i].error);
        o.base = e.result();
        o.stack.erase(o.stack.begin(), o.stack.begin() + ptrdiff_t(levels));
    });
}

std::string applyName(const Scene& scene, const Apply& p)
{
    const MeshObject& object = *scene.find(meshIdOf(scene, p.node));
    const bool all = p.levels == 0 || size_t(p.levels) == object.stack.size();
    return scene.node(nodeOf(scene, p.node)).name + (all ? ": apply stack" : ": apply up to " + titleOf(scene, p.node, p.levels));
}

struct KeepStep {
    std::string node, op, with;
    int64_t step = 1, level = 0;
    template <class V>
    void describe(V& v)
    {
        v.object("node", node, {.title = "Node", .help = whichNode});
        v.text("op", op, {.title = "Operation", .help = "Its id."});
        v.text("with", with, {.title = "Values", .help = "Of its parameters."});
        v.integer("step", step, {.title = "Step", .help = "After how many steps.", .min = 0, .max = 1e12});
        v.integer("level", level,
                  {.title = "Level", .help = "What it works on: the base is 0, the result of the first modifier 1.", .min = 0, .max = 10000});
    }
};

// An operation stopped on its way becomes the base.
void keepStep(Scene& scene, const KeepStep& p, EditRun& run)
{
    const Operation& op = operationOf(p.op, Kind::Mesh, Kind::Mesh);
    change(scene, p.node, [&](MeshObject& o) {
        if (size_t(p.level) > o.stack.size()) throw Error("\"" + o.name + "\" has only " + std::to_string(o.stack.size()) + " modifiers");
        MeshObject lower = o;
        lower.stack.resize(size_t(p.level));
        Evaluator own;
        const Evaluation e = (run.evaluator ? run.evaluator : &own)->evaluate(lower, run.progress, {}, &scene);
        Evaluator* const evaluator = run.evaluator ? run.evaluator : &own;
        const ParameterValues values = parsed(op.parameters, p.with);
        const Others others = othersOf(
            op, values, [&](const std::string& name) { return evaluator->meshOf(scene, name, run.progress); }, run.progress);
        Stepper stepper(stepping(op, e.result(), values, others));
        stepper.seek(size_t(p.step), run.progress);
        o.base = std::get<Mesh>(valueOf(stepper.value()));
        o.stack.clear();
    });
}

std::string keepName(const Scene&, const KeepStep& p)
{
    return titleOf(p.op) + ": step " + grouped(p.step) + " as base";
}

}  // namespace

std::vector<Edit> stackEdits()
{
    return {editEntry<Modify>("modify", "Add modifier", "Adds an operation to the stack of a mesh.", modify, modifyName),
            editEntry<SetValues>("set-modifier", "Change modifier", "Gives a modifier other values.", setValues, setName),
            editEntry<Enable>("enable-modifier", "Switch modifier", "Switches a modifier on or off.", enableModifier, enableName),
            editEntry<Move>("move-modifier", "Move modifier", "Gives a modifier another place in its stack.", moveModifier, moveName),
            editEntry<Which>("duplicate-modifier", "Duplicate modifier", "Puts a copy of a modifier after it.", duplicateModifier, duplicateName),
            editEntry<Which>("remove-modifier", "Remove modifier", "Takes a modifier out of its stack.", removeModifier, removeName),
            editEntry<Apply>("apply-modifiers", "Apply modifiers", "Makes the result of modifiers the base mesh.", applyModifiers, applyName, true),
            editEntry<KeepStep>("keep-step", "Keep step", "Makes a step of an operation the base mesh.", keepStep, keepName, true)};
}

}  // namespace mw
