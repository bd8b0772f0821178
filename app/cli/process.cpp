// process IN --op ... -o OUT: operations in turn, on every mesh object of a scene; hierarchy and materials stay.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>

#include "app/cli/operation_call.h"
#include "app/cli/output.h"
#include "app/cli/table_file.h"
#include "app/cli/verb.h"
#include "core/io/io.h"

namespace mw::cli {

namespace {

struct Job {
    std::string in, out;
    std::vector<OperationCall> calls;
    bool project = false, ascii = false;
    bool query() const { return !calls.empty() && calls.back().operation->yields != Kind::Mesh; }
};

bool tableEnding(const std::string& file)
{
    std::string e = std::filesystem::path(file).extension().string();
    std::transform(e.begin(), e.end(), e.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return e == ".csv" || e == ".json";
}

// Whatever can be said before a large file is read.
void check(const Job& job)
{
    for (size_t i = 0; i < job.calls.size(); ++i) {
        const Operation& op = *job.calls[i].operation;
        const bool last = i + 1 == job.calls.size();
        if (i > 0 && op.accepts == Kind::Nothing) throw Error(op.id + " is a source: it must be the first operation, with - as input");
        if (op.accepts != Kind::Nothing && op.accepts != Kind::Mesh) throw Error(op.id + " works on " + kindName(op.accepts) + ", not on a mesh");
        if (op.yields != Kind::Mesh && !last) throw Error(op.id + " gives a " + kindName(op.yields) + ": it must be the last operation");
    }
    if (job.query() && !tableEnding(job.out))
        throw Error(job.out,
                    job.calls.back().operation->id + " gives a " + kindName(job.calls.back().operation->yields) + "; name a .csv or .json file");
    if (!job.query() && tableEnding(job.out))
        throw Error(job.out,
                    "a mesh cannot be written as this; end with an operation that gives a table (as vertex-valence), or name a .glb, .obj or .ply");
}

// The mesh operations on one object: its mesh after them; with `project` they become modifiers of its stack instead.
MeshObject processed(MeshObject object, std::span<const OperationCall> calls, Scene& scene, bool project, Working& working)
{
    if (project) {
        for (const OperationCall& call : calls) object.stack.push_back({scene.newModifierId(), call.operation->id, call.values, true});
        return object;
    }
    Mesh mesh = evaluated(object, working.progress());
    for (const OperationCall& call : calls) {
        working.now(call.operation->id);
        try {
            mesh = std::get<Mesh>(apply(*call.operation, mesh, call.values, working.progress()));
        } catch (const Error& e) {
            throw Error("object \"" + object.name + "\": " + call.operation->id + ": " + e.reason());
        }
    }
    object.base = mesh;
    object.stack.clear();
    return object;
}

void say(const Job& job, const std::string& name, const Mesh& before, const Mesh& after)
{
    std::cout << job.out << ": \"" << name << "\" ";
    if (before.vertexCount() != after.vertexCount() || before.faceCount() != after.faceCount())
        std::cout << counted(before.vertexCount(), "vertex", "vertices") << ", " << counted(before.faceCount(), "face") << " -> ";
    std::cout << counted(after.vertexCount(), "vertex", "vertices") << ", " << counted(after.faceCount(), "face") << '\n';
}

void writeResults(const Job& job, const Scene& scene, Working& working)
{
    const OperationCall& query = job.calls.back();
    std::vector<NamedResult> results;
    for (MeshId id : scene.meshes()) {
        const MeshObject& object = *scene.find(id);
        working.now(query.operation->id);
        results.push_back({object.name, apply(*query.operation, object.base, query.values, working.progress())});
    }
    working.now("writing");
    writeTableFile(job.out, query.operation->id, results);
}

int work(const Job& job)
{
    std::vector<Warning> lost;
    std::vector<std::string> names;
    std::vector<std::pair<Mesh, Mesh>> changes;
    Evaluator evaluator;  // a project's stack is run once, for the figures and for the file
    {
        Working working("reading " + job.in);
        Input input = readInput(job.in, job.calls.empty() ? OperationCall{} : job.calls.front(), working.progress());
        std::span<const OperationCall> meshCalls(job.calls);
        if (input.sourceUsed) meshCalls = meshCalls.subspan(1);
        if (job.query() && !meshCalls.empty()) meshCalls = meshCalls.first(meshCalls.size() - 1);
        const bool project = job.project && !job.query();
        if (input.scene.meshes().empty()) throw Error(job.in, "there is no mesh in it");
        for (MeshId id : input.scene.meshes()) {
            const MeshObject before = *input.scene.find(id);
            MeshObject after = processed(before, meshCalls, input.scene, project, working);
            names.push_back(before.name);
            changes.emplace_back(before.base, project ? evaluated(after, working.progress(), &evaluator) : after.base);
            input.scene.set(id, std::move(after));
        }
        if (job.query()) {
            writeResults(job, input.scene, working);
        } else {
            working.now("writing " + job.out);
            lost = writeFile(input.scene, job.out, {.project = project, .binary = !job.ascii, .evaluator = &evaluator}, working.progress());
        }
    }
    warn(job.out, lost);
    if (!job.query())
        for (size_t i = 0; i < names.size(); ++i) say(job, names[i], changes[i].first, changes[i].second);
    return 0;
}

int run(Arguments& arguments)
{
    Job job;
    const std::vector<std::string> ops = arguments.values("--op");
    const std::optional<std::string> out = arguments.value("--output", "-o");
    job.project = arguments.flag("--project");
    job.ascii = arguments.flag("--ascii");
    job.in = arguments.finish({"IN"})[0];
    if (!out || out->empty()) throw UsageError("-o OUT is missing");
    job.out = *out;
    for (const std::string& op : ops) job.calls.push_back(parseCall(op));
    if (job.in == "-" && job.calls.empty()) throw UsageError("the input - wants a source: --op icosphere");
    check(job);
    try {
        return work(job);
    } catch (const Error& e) {
        // What an operation says names no file: it is the input's.
        if (!e.file().empty() || job.in == "-") throw;
        throw Error(job.in, e.reason());
    }
}

}  // namespace

const Verb processVerb{
    "process", "operations in turn, the result into a file",
    "process IN [--op ID[:k=v,...]]... -o OUT [--project] [--ascii]\n\n"
    "Each operation works on every mesh of IN; hierarchy and materials stay. IN may be - when the first operation makes a mesh from\n"
    "nothing. OUT is written by its ending (.glb .gltf .obj .ply); an operation that gives a table comes last and goes to .csv or .json.\n"
    "The verb algorithms lists operations and parameters.\n"
    "  --project   glTF: keep the operations as modifiers that can still be changed\n"
    "  --ascii     PLY: as text\n\n"
    "  meshwright process scan.ply --op weld --op decimate-quadric:ratio=0.1 -o small.glb\n"
    "  meshwright process - --op icosphere --op vertex-valence -o valence.csv\n",
    run};

}  // namespace mw::cli
