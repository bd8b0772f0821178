#include "app/cli/process_edits.h"

#include <iostream>

#include "app/cli/foretell.h"
#include "app/cli/other_mesh.h"
#include "app/cli/output.h"
#include "core/io/io.h"
#include "core/scene/animate_morph.h"
#include "core/scene/edit.h"

namespace mw::cli {

namespace {

/// One of the two.
struct SceneStep {
    OperationCall operation;
    EditCall edit;
    std::string text;
};

// Whatever can be said before a large file is read.
std::vector<SceneStep> parsedSteps(const EditJob& job)
{
    std::vector<SceneStep> steps;
    for (const auto& [option, text] : job.steps) {
        SceneStep step;
        step.text = text.substr(0, 200);
        if (option == "--do") {
            step.edit = parsedEdit(text);
        } else {
            step.operation = parseCall(text);
            const Operation& op = *step.operation.operation;
            const bool first = steps.empty() && job.in == "-" && op.accepts == Kind::Nothing;
            if ((op.accepts != Kind::Mesh && !first) || op.yields != Kind::Mesh)
                throw Error(op.id + " makes no mesh from a mesh, so it cannot stand beside --do; run it on the result");
        }
        steps.push_back(std::move(step));
    }
    return steps;
}

void apply(Scene& scene, const SceneStep& step, const EditJob& job, EditRun& run, Working& working)
{
    working.now(step.operation.operation ? step.operation.operation->id : step.edit.id);
    if (!step.operation.operation) {
        const auto node = step.edit.values.find("node");
        if (step.edit.id == "apply-modifiers" && node != step.edit.values.end())
            if (const MeshObject* object = scene.find(scene.node(nodeOf(scene, std::get<std::string>(node->second))).mesh)) foretell(*object);
        scene = edited(scene, step.edit, run);
        return;
    }
    const Scene before = scene;  // other meshes are taken as they were
    const FindMesh find = meshesOf(before, working.progress());
    for (const MeshId id : before.meshes()) {
        scene.set(id, processed(*before.find(id), std::span(&step.operation, 1), scene, job.project, working, find));
        animateNewMorphs(scene, id, morphTargets(*before.find(id)));
    }
}

std::string summary(const Scene& scene)
{
    size_t vertices = 0, faces = 0;
    for (const MeshId id : scene.meshes()) {
        vertices += scene.find(id)->base.vertexCount();
        faces += scene.find(id)->base.faceCount();
    }
    return counted(scene.nodes().size(), "node") + ", " + counted(scene.meshes().size(), "mesh", "meshes") + " of " +
           counted(vertices, "vertex", "vertices") + ", " + counted(faces, "face");
}

}  // namespace

int processEdits(const EditJob& job)
{
    const std::vector<SceneStep> steps = parsedSteps(job);
    std::vector<Warning> lost;
    Evaluator evaluator;
    Scene scene;
    {
        Working working("reading " + job.in);
        std::span<const SceneStep> rest(steps);
        if (job.in != "-" || steps.front().operation.operation) {
            Input input = readInput(job.in, steps.front().operation, working.progress(), job.import);
            scene = std::move(input.scene);
            if (input.sourceUsed) rest = rest.subspan(1);
        }
        EditRun run;
        run.progress = working.progress();
        run.evaluator = &evaluator;
        for (const SceneStep& step : rest) try {
                run.warnings.clear();
                apply(scene, step, job, run, working);
                warn(job.in, run.warnings);
            } catch (const Error& e) {
                throw Error(e.file(), step.text + ": " + e.reason());
            }
        for (const MeshId id : scene.meshes()) foretell(*scene.find(id));
        working.now("writing " + job.out);
        lost = writeFile(scene, job.out, {.project = job.project, .binary = !job.ascii, .placement = job.placement, .evaluator = &evaluator},
                         working.progress());
    }
    warn(job.out, lost);
    std::cout << job.out << ": " << summary(scene) << '\n';
    return 0;
}

}  // namespace mw::cli
