#include "core/scene/command_line.h"

#include <algorithm>

namespace mw {
namespace {

const std::string& sourceOf(const Document& d)
{
    if (d.source().input.empty()) throw Error("the scene came from no file: save it first, then commands can begin with that file");
    return d.source().input;
}

// Modifiers added to the only mesh of the source and nothing else. False when something else was done.
bool onlyModifiers(const Document& d, std::span<const EditCall> calls)
{
    if (calls.empty() || d.sourceEntry() != 0 || !d.forgotten().empty()) return false;
    const Scene& scene = *d.history().front().scene;
    if (scene.meshes().size() != 1 || !scene.find(scene.meshes().front())->stack.empty()) return false;
    return std::all_of(calls.begin(), calls.end(), [](const EditCall& c) { return c.id == "modify" && !c.values.contains("at"); });
}

std::string textOf(const EditCall& call, const char* name)
{
    const auto i = call.values.find(name);
    return i == call.values.end() ? std::string() : std::get<std::string>(i->second);
}

std::string lineOf(const Document& d, std::span<const EditCall> calls)
{
    const std::string& input = sourceOf(d);
    std::string line = "meshwright process " + shellQuoted(input.size() > 1 && input[0] == '-' ? "./" + input : input);
    for (const std::string& option : d.source().options) line += " " + shellQuoted(option);
    const bool shorter = onlyModifiers(d, calls);
    for (const EditCall& call : calls) {
        const std::string with = textOf(call, "with");
        line += shorter ? " --op " + shellQuoted(textOf(call, "op") + (with.empty() ? "" : ":" + with)) : " --do " + shellQuoted(commandText(call));
    }
    return line + " -o result.glb";
}

}  // namespace

std::string shellQuoted(std::string_view word)
{
    const auto plain = [](unsigned char c) { return std::isalnum(c) || std::string_view("_./:=,+@%-").find(char(c)) != std::string_view::npos; };
    if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return std::string(word);
    std::string out = "'";
    for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

std::vector<EditCall> callsUpTo(const Document& d, size_t position)
{
    std::vector<const Document::Entry*> entries;
    for (const Document::Entry& e : d.forgotten()) entries.push_back(&e);
    for (size_t i = 0; i <= position && i < d.history().size(); ++i) entries.push_back(&d.history()[i]);
    std::vector<EditCall> calls;
    for (size_t i = d.sourceEntry() + 1; i < entries.size(); ++i) {
        if (entries[i]->calls.empty()) throw Error("\"" + entries[i]->name + "\" cannot be repeated from a command line");
        calls.insert(calls.end(), entries[i]->calls.begin(), entries[i]->calls.end());
    }
    if (d.forgotten().size() + position < d.sourceEntry())
        throw Error("the file that this began from has been overwritten since; only what was done after saving can be repeated");
    return calls;
}

std::string commandLine(const Document& d, size_t position)
{
    return lineOf(d, callsUpTo(d, position));
}

std::string entryCommand(const Document& d, size_t position)
{
    const Document::Entry& e = d.history().at(position);
    if (e.calls.empty()) throw Error("\"" + e.name + "\" cannot be repeated from a command line");
    return lineOf(d, e.calls);
}

std::string callCommand(const Document& d, const EditCall& call)
{
    return lineOf(d, std::span(&call, 1));
}

Scene replayed(Scene scene, std::span<const EditCall> calls, EditRun& run)
{
    for (const EditCall& call : calls) {
        run.made.clear();
        try {
            scene = edited(scene, call, run);
        } catch (const Error& e) {
            if (calls.size() == 1) throw;
            throw Error(e.file(), commandText(call).substr(0, 200) + ": " + e.reason());
        }
    }
    return scene;
}

}  // namespace mw
