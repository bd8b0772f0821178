#include "core/scene/edit.h"

#include <algorithm>
#include <charconv>

#include "core/scene/edit_entries.h"
#include "core/scene/same_scene.h"

namespace mw {
namespace {

bool plainName(std::string_view name)
{
    const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '.' || c == '-' || c == ' ' || c >= 0x80; };
    return !name.empty() && name.front() != ' ' && name.back() != ' ' && std::all_of(name.begin(), name.end(), plain);
}

std::string textOf(const Scene& scene, NodeId id)
{
    const std::string& name = scene.node(id).name;
    size_t same = 0;
    for (const NodeId n : scene.nodes()) same += scene.node(n).name == name;
    return same == 1 && plainName(name) ? name : "#" + std::to_string(id.value);
}

NodeId find(const Scene& scene, std::string_view text)
{
    if (text.starts_with('#')) {
        uint32_t value = 0;
        const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), value);
        if (error == std::errc() && end == text.data() + text.size() && scene.find(NodeId{value})) return {value};
        throw Error("there is no node " + std::string(text));
    }
    NodeId found;
    for (const NodeId n : scene.nodes()) {
        if (scene.node(n).name != text) continue;
        if (found) throw Error("several nodes are called \"" + std::string(text) + "\"; name one by its number, #" + std::to_string(found.value));
        found = n;
    }
    if (!found) throw Error("there is no node \"" + std::string(text) + "\"");
    return found;
}

}  // namespace

std::span<const Edit> editList()
{
    static const std::vector<Edit> all = [] {
        std::vector<Edit> list;
        for (auto edits : {sceneEdits, fileEdits, placementEdits, nodeEdits, meshEdits, elementEdits, stackEdits, materialEdits, textureEdits,
                           terrainEdits, clipEdits})
            for (Edit& e : edits()) list.push_back(std::move(e));
        return list;
    }();
    return all;
}

const Edit* findEdit(std::string_view id)
{
    for (const Edit& e : editList())
        if (e.id == id) return &e;
    return nullptr;
}

const Edit& editOf(std::string_view id)
{
    if (const Edit* e = findEdit(id)) return *e;
    std::string list;
    for (const Edit& e : editList()) list += (list.empty() ? "" : ", ") + e.id;
    throw Error("there is no edit \"" + std::string(id) + "\"; there are: " + list);
}

Scene edited(const Scene& scene, const EditCall& call, EditRun& run)
{
    const Edit& e = editOf(call.id);
    Scene next = scene;
    e.apply(next, checked(e.parameters, call.values), run);
    return next;
}

Scene edited(const Scene& scene, const EditCall& call)
{
    EditRun run;
    return edited(scene, call, run);
}

void commitEdit(Document& document, const EditCall& call)
{
    const auto before = document.history()[document.historyPosition()].scene;  // not a preview
    EditRun run;
    Scene next = edited(*before, call, run);
    commitEdited(document, call, *before, std::move(next), run);
}

bool commitEdited(Document& document, const EditCall& call, const Scene& before, Scene next, const EditRun& run)
{
    if (document.history()[document.historyPosition()].scene.get() != &before) return false;
    if (sameScene(next, before)) {
        document.cancelPreview();
        return true;
    }
    std::string name = editName(before, call);
    if (run.made.empty())
        document.commit(std::move(name), std::move(next), std::vector{call});
    else
        document.commit(std::move(name), std::move(next), Selection{run.made, {}, {}}, {call});
    return true;
}

void commitEdits(Document& document, std::string name, const std::vector<EditCall>& calls)
{
    const auto before = document.history()[document.historyPosition()].scene;
    EditRun run;
    Scene next = *before;
    for (const EditCall& call : calls) next = edited(next, call, run);
    if (sameScene(next, *before)) return document.cancelPreview();
    if (run.made.empty())
        document.commit(std::move(name), std::move(next), calls);
    else
        document.commit(std::move(name), std::move(next), Selection{run.made, {}, {}}, calls);
}

std::string editName(const Scene& before, const EditCall& call)
{
    const Edit& e = editOf(call.id);
    return e.name(before, checked(e.parameters, call.values));
}

std::string commandText(const EditCall& call)
{
    const std::string values = printed(editOf(call.id).parameters, call.values);
    return values.empty() ? call.id : call.id + ":" + values;
}

EditCall parsedEdit(std::string_view text)
{
    const size_t colon = text.find(':');
    const Edit& e = editOf(text.substr(0, colon));
    return {e.id, parsed(e.parameters, colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1))};
}

std::string nodeText(const Scene& scene, const std::vector<NodeId>& nodes)
{
    std::string text;
    for (const NodeId n : nodes) text += (text.empty() ? "" : "+") + textOf(scene, n);
    return text;
}

std::vector<NodeId> nodesOf(const Scene& scene, std::string_view text)
{
    std::vector<NodeId> nodes;
    while (!text.empty()) {
        const size_t plus = text.find('+');
        const NodeId n = find(scene, text.substr(0, plus));
        if (std::find(nodes.begin(), nodes.end(), n) == nodes.end()) nodes.push_back(n);
        text = plus == std::string_view::npos ? std::string_view() : text.substr(plus + 1);
    }
    if (nodes.empty()) throw Error("no node is named; give names joined by +");
    return nodes;
}

NodeId nodeOf(const Scene& scene, std::string_view text)
{
    const std::vector<NodeId> nodes = nodesOf(scene, text);
    if (nodes.size() != 1) throw Error("one node is wanted, " + std::to_string(nodes.size()) + " are named");
    return nodes.front();
}

}  // namespace mw
