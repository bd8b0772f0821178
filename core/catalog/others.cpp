#include "core/catalog/others.h"

#include <algorithm>

namespace mw {

bool needsOthers(const Operation& op)
{
    return std::any_of(op.parameters.begin(), op.parameters.end(), [](const Parameter& p) { return p.type == ParameterType::Object; });
}

std::optional<Mesh> meshOfSource(const std::string& text, Progress* progress)
{
    const size_t colon = text.find(':');
    const Operation* op = findOperation(text.substr(0, colon));
    if (!op || op->accepts != Kind::Nothing || op->yields != Kind::Mesh) return std::nullopt;
    return std::get<Mesh>(apply(*op, {}, parsed(op->parameters, colon == text.npos ? std::string() : text.substr(colon + 1)), progress));
}

Others othersOf(const Operation& op, const ParameterValues& values, const FindMesh& find, Progress* progress)
{
    Others others;
    for (const Parameter& p : op.parameters) {
        if (p.type != ParameterType::Object) continue;
        const std::string name = std::get<std::string>(valueOf(p, values));
        if (name.empty() && p.about.optional) continue;
        if (name.empty()) throw Error(op.id + " needs another mesh: give its node, its file or a source (\"torus\") as " + p.name);
        std::optional<Mesh> mesh = find ? find(name) : std::nullopt;
        if (!mesh) mesh = meshOfSource(name, progress);
        if (!mesh)
            throw Error(op.id + ": there is no mesh \"" + name + "\"; " + p.name +
                        " names a node that shows a mesh, a file, or a source (\"torus\")");
        others.emplace(p.name, *std::move(mesh));
    }
    return others;
}

}  // namespace mw
