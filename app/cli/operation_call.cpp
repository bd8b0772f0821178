#include "app/cli/operation_call.h"

#include "app/cli/foretell.h"
#include "app/cli/other_mesh.h"
#include "app/cli/output.h"
#include "core/io/io.h"
#include "core/scene/evaluation.h"

namespace mw::cli {

OperationCall parseCall(std::string_view text)
{
    const size_t colon = text.find(':');
    OperationCall call;
    call.operation = &operation(text.substr(0, colon));
    try {
        if (colon != text.npos) call.values = parsed(call.operation->parameters, text.substr(colon + 1));
    } catch (const Error& e) {
        throw Error(call.operation->id + ": " + e.reason());
    }
    return call;
}

Input readInput(const std::string& in, const OperationCall& first, Progress* progress, const ImportOptions& options)
{
    const bool source = first.operation && first.operation->accepts == Kind::Nothing;
    if (in != "-") {
        if (source)
            throw Error(in, first.operation->id + " makes " + kindName(first.operation->yields) + " from nothing and takes no file; give - as input");
        Imported file = readFile(in, progress, options);
        warn(in, file.warnings);
        return {std::move(file.scene), file.project, false};
    }
    if (!source) throw Error("the input - is for operations that make something from nothing (sources); the first operation is none");
    Value made = apply(*first.operation, {}, first.values, progress);
    if (kindOf(made) != Kind::Mesh) throw Error(first.operation->id + " makes no mesh");
    return {sceneOf(std::get<Mesh>(std::move(made)), first.operation->id), false, true};
}

Mesh evaluated(const MeshObject& object, Progress* progress, Evaluator* evaluator, const Scene* scene)
{
    if (object.stack.empty()) return object.base;
    foretell(object);
    const Evaluation e = evaluator ? evaluator->evaluate(object, progress, {}, scene) : Evaluator().evaluate(object, progress, {}, scene);
    for (size_t i = 0; i < e.levels.size(); ++i)
        if (!e.levels[i].error.empty())
            throw Error("object \"" + object.name + "\", modifier " + std::to_string(i + 1) + " (" + object.stack[i].operation +
                        "): " + e.levels[i].error);
    return e.result();
}

MeshObject processed(MeshObject object, std::span<const OperationCall> calls, Scene& scene, bool project, Working& working, const FindMesh& find)
{
    if (project) {
        for (OperationCall call : calls) {
            keepOthers(scene, call, working.progress());
            object.stack.push_back({scene.newModifierId(), call.operation->id, call.values, true});
        }
        return object;
    }
    Mesh mesh = evaluated(object, working.progress(), nullptr, &scene);
    for (const OperationCall& call : calls) {
        working.now(call.operation->id);
        foretell(*call.operation, mesh, call.values);
        try {
            mesh = std::get<Mesh>(
                apply(*call.operation, mesh, call.values, working.progress(), othersOf(*call.operation, call.values, find, working.progress())));
        } catch (const Error& e) {
            throw Error("object \"" + object.name + "\": " + call.operation->id + ": " + e.reason());
        }
    }
    object.base = mesh;
    object.stack.clear();
    return object;
}

}  // namespace mw::cli
