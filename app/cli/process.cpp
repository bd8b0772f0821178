// process IN --op ... -o OUT: operations in turn, on every mesh object of a scene; hierarchy and materials stay.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>

#include "app/cli/other_mesh.h"
#include "app/cli/output.h"
#include "app/cli/placement_options.h"
#include "app/cli/process_edits.h"
#include "app/cli/subject.h"
#include "app/cli/table_file.h"
#include "app/cli/value_file.h"
#include "app/cli/verb.h"
#include "core/io/io.h"
#include "core/scene/animate_morph.h"

namespace mw::cli {

namespace {

struct Job {
    std::string in, out;
    std::vector<OperationCall> calls;
    std::optional<std::string> object;
    bool project = false, ascii = false;
    ImportOptions import = {};
    Placement placement = {};
    bool query() const { return !calls.empty() && calls.back().operation->yields != Kind::Mesh; }
};

Kind firstKind(const Job& job)
{
    if (job.calls.empty()) return Kind::Mesh;
    const Operation& first = *job.calls.front().operation;
    return first.accepts == Kind::Nothing ? first.yields : first.accepts;
}

// Whatever can be said before a large file is read.
void check(const Job& job)
{
    Kind kind = firstKind(job);
    for (size_t i = 0; i < job.calls.size(); ++i) {
        const Operation& op = *job.calls[i].operation;
        if (i > 0 && op.accepts == Kind::Nothing) throw Error(op.id + " is a source: it must be the first operation, with - as input");
        if (kind == Kind::Table || kind == Kind::Selection)
            throw Error(job.calls[i - 1].operation->id + " gives a " + kindName(kind) + ": it must be the last operation");
        if (op.accepts != Kind::Nothing && op.accepts != kind)
            throw Error(op.id + " works on " + kindName(op.accepts) + ", not on a " + kindName(kind));
        kind = op.yields;
    }
    checkValueFile(kind, job.out);
}

void say(const Job& job, const std::string& name, const Mesh& before, const Mesh& after)
{
    std::cout << job.out << ": \"" << name << "\" ";
    if (before.vertexCount() != after.vertexCount() || before.faceCount() != after.faceCount())
        std::cout << counted(before.vertexCount(), "vertex", "vertices") << ", " << counted(before.faceCount(), "face") << " -> ";
    std::cout << counted(after.vertexCount(), "vertex", "vertices") << ", " << counted(after.faceCount(), "face") << '\n';
}

void writeResults(const Job& job, const Scene& scene, Working& working, const FindMesh& find)
{
    const OperationCall& query = job.calls.back();
    std::vector<NamedResult> results;
    for (MeshId id : scene.meshes()) {
        const MeshObject& object = *scene.find(id);
        working.now(query.operation->id);
        results.push_back({object.name, apply(*query.operation, object.base, query.values, working.progress(),
                                              othersOf(*query.operation, query.values, find, working.progress()))});
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
        Input input = readInput(job.in, job.calls.empty() ? OperationCall{} : job.calls.front(), working.progress(), job.import);
        std::span<const OperationCall> meshCalls(job.calls);
        if (input.sourceUsed) meshCalls = meshCalls.subspan(1);
        if (job.query() && !meshCalls.empty()) meshCalls = meshCalls.first(meshCalls.size() - 1);
        const bool project = job.project && !job.query();
        if (input.scene.meshes().empty()) throw Error(job.in, "there is no mesh in it");
        const Scene asRead = input.scene;  // other meshes are taken as they were
        const FindMesh find = meshesOf(asRead, working.progress());
        for (MeshId id : asRead.meshes()) {
            const MeshObject before = *input.scene.find(id);
            MeshObject after = processed(before, meshCalls, input.scene, project, working, find);
            names.push_back(before.name);
            changes.emplace_back(before.base, project ? evaluated(after, working.progress(), &evaluator, &input.scene) : after.base);
            input.scene.set(id, std::move(after));
            animateNewMorphs(input.scene, id, morphTargets(before));
        }
        if (job.query()) {
            writeResults(job, input.scene, working, find);
        } else {
            working.now("writing " + job.out);
            lost = writeFile(input.scene, job.out, {.project = project, .binary = !job.ascii, .placement = job.placement, .evaluator = &evaluator},
                             working.progress());
        }
    }
    warn(job.out, lost);
    if (!job.query())
        for (size_t i = 0; i < names.size(); ++i) say(job, names[i], changes[i].first, changes[i].second);
    return 0;
}

// Curves, poses, height maps, rotations: one value, not objects of a scene.
int workOnValue(const Job& job)
{
    std::vector<Warning> lost;
    Value value;
    {
        Working working("reading " + job.in);
        value = subjectOf(job.in, job.calls.front(), job.object, working.progress(), job.import);
        for (const OperationCall& call : job.calls) {
            working.now(call.operation->id);
            value = apply(*call.operation, value, call.values, working.progress());
        }
        working.now("writing " + job.out);
        lost = writeValueFile(job.out, job.calls.back().operation->id, value, working.progress());
    }
    warn(job.out, lost);
    std::cout << job.out << ": " << summaryOf(value) << '\n';
    return 0;
}

int run(Arguments& arguments)
{
    Job job;
    const std::string_view names[] = {"--op", "--do"};
    const auto steps = arguments.inOrder(names);
    const std::optional<std::string> out = arguments.value("--output", "-o");
    job.object = arguments.value("--object");
    job.project = arguments.flag("--project");
    job.ascii = arguments.flag("--ascii");
    job.import = takeImportOptions(arguments);
    job.placement = takeOutPlacement(arguments);
    job.in = arguments.finish({"IN"})[0];
    if (!out || out->empty()) throw UsageError("-o OUT is missing");
    job.out = *out;
    if (std::any_of(steps.begin(), steps.end(), [](const auto& s) { return s.first == "--do"; }))
        return processEdits({job.in, job.out, steps, job.project, job.ascii, job.import, job.placement});
    for (const auto& step : steps) job.calls.push_back(parseCall(step.second));
    if (job.in != "-" && !job.calls.empty() && job.calls.front().operation->accepts == Kind::Nothing && firstKind(job) != Kind::Mesh)
        throw Error(job.in,
                    job.calls.front().operation->id + " makes a " + kindName(firstKind(job)) + " from nothing and takes no file; give - as input");
    if (job.in == "-" && job.calls.empty()) throw UsageError("the input - wants a source: --op icosphere");
    check(job);
    try {
        return firstKind(job) == Kind::Mesh ? work(job) : workOnValue(job);
    } catch (const Error& e) {
        // What an operation says names no file: it is the input's.
        if (!e.file().empty() || job.in == "-") throw;
        throw Error(job.in, e.reason());
    }
}

}  // namespace

const Verb processVerb{
    "process", "operations in turn, the result into a file",
    "process IN [--op ID[:k=v,...] | --do EDIT[:k=v,...]]... -o OUT [--project] [--ascii] [--object NAME]\n        [--unit UNIT] [--up y|z|x] "
    "[--out-unit UNIT] [--out-up "
    "y|z|x]\n\n"
    "Each operation works on every mesh of IN; hierarchy and materials stay. IN may be - when the first operation makes something from\n"
    "nothing. OUT is written by its ending (.glb .gltf .obj .off .ply .stl); an operation that gives a table comes last and goes to .csv or .json.\n"
    "Other kinds are one value: a skeleton of a character, a curve from .csv, a height map from .png. Height maps go to .png or as the mesh of\n"
    "a terrain to .glb; curves, poses and rotations to .json or .csv.\n"
    "The verb algorithms lists operations and parameters.\n"
    "--do makes an edit of the scene, as the window does: nodes joined, copied, moved, modifiers, materials, terrains. Edits and operations run in\n"
    "the order in which they are given; IN may then be - for an empty scene. The verb edits lists them.\n"
    "  --project   glTF: keep the operations as modifiers that can still be changed\n"
    "  --ascii     OFF, PLY, STL: as text\n"
    "  --unit UNIT, --up y|z|x            how the numbers of IN are meant; see meshwright convert --help\n"
    "  --out-unit UNIT, --out-up y|z|x    how those of OUT shall be meant\n"
    "  --object NAME   which skeleton, by its topmost joint, when the file has several\n\n"
    "  meshwright process scan.ply --op weld --op decimate-quadric:ratio=0.1 -o small.glb\n"
    "  meshwright process scene.glb --do join:nodes=left+right --op weld -o joined.glb\n"
    "  meshwright process - --op icosphere --op vertex-valence -o valence.csv\n"
    "  meshwright process - --op sample-curve:shape=star --op subdivide-curve -o star.csv\n",
    run};

}  // namespace mw::cli
