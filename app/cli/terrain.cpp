// terrain [--source ID[:k=v,...] | --from PICTURE] -o OUT: a landscape from a generator or a picture, as picture, mesh or project.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "app/cli/operation_call.h"
#include "app/cli/output.h"
#include "app/cli/verb.h"
#include "core/io/height_picture.h"
#include "core/io/io.h"

namespace mw::cli {

namespace {

struct Job {
    std::string from, out;
    OperationCall source;
    TerrainObject object;
    size_t triangles = 200'000;
    bool project = false;
};

std::string endingOf(const std::string& file)
{
    std::string e = std::filesystem::path(file).extension().string();
    std::transform(e.begin(), e.end(), e.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return e;
}

/// A length in metres.
void take(Arguments& arguments, const char* name, double least, double& value)
{
    const std::optional<std::string> text = arguments.value(name);
    if (!text) return;
    const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
    if (error != std::errc() || end != text->data() + text->size() || !std::isfinite(value) || value < least || value > 1e7)
        throw UsageError(std::string(name) + " wants metres, " + shown(least) + " to 1e+07, and was given \"" + *text + "\"");
}

std::string listOfSources()
{
    std::string list;
    for (const Operation& op : catalog())
        if (op.accepts == Kind::Nothing && op.yields == Kind::HeightMap) list += (list.empty() ? "" : ", ") + op.id;
    return list;
}

void makeMap(Job& job, Working& working)
{
    Terrain& t = job.object.terrain;
    if (!job.from.empty()) {
        working.now("reading " + job.from);
        std::vector<Warning> warnings;
        t.map = readHeightMap(job.from, &warnings, working.progress());
        t.name = std::filesystem::path(job.from).stem().string();
        warn(job.from, warnings);
        return;
    }
    working.now(job.source.operation->id);
    t.map = std::get<HeightMap>(apply(*job.source.operation, {}, job.source.values, working.progress()));
    t.name = job.source.operation->id;
    job.object.sourceOperation = job.source.operation->id;
    job.object.sourceValues = job.source.values;
}

/// What was made, in one line.
std::string summary(const Job& job, const Mesh* mesh)
{
    const Terrain& t = job.object.terrain;
    const auto [least, most] = t.map.range();
    std::string text = job.out + ": " + std::to_string(t.map.width()) + " x " + std::to_string(t.map.height()) + " samples, " + shown(t.size().x) +
                       " x " + shown(t.size().y) + " m, heights " + shown(double(least) * t.maximumHeight) + " to " +
                       shown(double(most) * t.maximumHeight) + " m";
    if (mesh) text += ", " + counted(mesh->faceCount(), "triangle") + ", at most " + shown(terrainMeshError(t, *mesh)) + " m off";
    return text;
}

int work(Job& job)
{
    std::vector<Warning> lost;
    std::string said;
    {
        Working working("terrain");
        makeMap(job, working);
        Scene scene;
        Node node;
        node.name = job.object.terrain.name;
        node.terrain = scene.add(job.object);
        const NodeId id = scene.add(std::move(node));
        const bool picture = endingOf(job.out) == ".png";
        if (!job.project && !picture) {
            working.now("triangles");
            scene = withTerrainMeshes(scene, job.triangles, working.progress());
        }
        const MeshObject* mesh = scene.find(scene.node(id).mesh);
        said = summary(job, mesh ? &mesh->base : nullptr);
        working.now("writing " + job.out);
        lost = writeFile(scene, job.out, {.project = job.project, .terrainTriangles = job.triangles}, working.progress());
    }
    warn(job.out, lost);
    std::cout << said << '\n';
    return 0;
}

int run(Arguments& arguments)
{
    Job job;
    Terrain& t = job.object.terrain;
    const std::optional<std::string> source = arguments.value("--source"), from = arguments.value("--from"), out = arguments.value("--output", "-o");
    take(arguments, "--extent", 1e-3, t.extent);
    take(arguments, "--max-height", 0, t.maximumHeight);
    take(arguments, "--water", -1e7, t.waterLevel);
    if (const std::optional<long> n = arguments.number("--triangles", 1, 100'000'000)) job.triangles = size_t(*n);
    job.project = arguments.flag("--project");
    arguments.finish({});
    if (!out || out->empty()) throw UsageError("-o OUT is missing");
    if (source && from) throw UsageError("--source and --from are two ways to get heights; give one");
    job.out = *out;
    job.from = from.value_or("");
    const std::string ending = endingOf(job.out);
    if (ending != ".png" && ending != ".glb" && ending != ".gltf" && ending != ".obj" && ending != ".ply")
        throw Error(job.out, "a terrain is written as .png (heights, 16 bits), .glb, .gltf, .obj or .ply");
    if (job.project && ending != ".glb" && ending != ".gltf") throw UsageError("--project wants a .glb or .gltf");
    if (job.from.empty()) {
        job.source = parseCall(source.value_or("diamond-square"));
        if (job.source.operation->accepts != Kind::Nothing || job.source.operation->yields != Kind::HeightMap)
            throw Error(job.source.operation->id + " makes no heights from nothing; these do: " + listOfSources());
    }
    return work(job);
}

}  // namespace

const Verb terrainVerb{
    "terrain", "a landscape from a generator or a picture",
    "terrain [--source ID[:k=v,...] | --from PICTURE] -o OUT\n\n"
    "Heights come from a generator (diamond-square if none is named; the verb algorithms lists them) or a picture (.png .tga .pgm).\n"
    "OUT is a picture of 16 bits (.png) or a mesh of few triangles where the ground is even (.glb .gltf .obj .ply).\n"
    "  --source ID      perlin:seed=4,octaves=6\n"
    "  --from PICTURE   black is height 0, white the maximum height\n"
    "  --extent M       metres along x, 1000 if not given\n"
    "  --max-height M   metres of height 1 (white), 115 if not given\n"
    "  --water M        level of the water in metres, 0 if not given\n"
    "  --triangles N    most triangles of the mesh, 200000 if not given\n"
    "  --project        glTF: keep the heights, so that Meshwright can go on painting\n\n"
    "  meshwright terrain --source perlin:size=1025,octaves=7,interval=256 --water 40 -o hills.glb\n"
    "  meshwright terrain --from mount-cook.tga --extent 8000 --max-height 2400 --triangles 50000 -o cook.obj\n",
    run};

}  // namespace mw::cli
