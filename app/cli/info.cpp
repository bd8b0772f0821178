// info FILE: what is in a file, and what is wrong with it.
#include <algorithm>
#include <cctype>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/findings.h"
#include "app/cli/operation_call.h"
#include "app/cli/output.h"
#include "app/cli/placement_options.h"
#include "app/cli/verb.h"
#include "app/cli/worklist.h"
#include "core/io/placement.h"
#include "core/scene/scene_pose.h"

namespace mw::cli {

namespace {

constexpr size_t quickTriangles = 200000;  // up to there self-intersections are found in a moment

struct MeshInfo {
    std::string name;
    Mesh mesh;
    size_t modifiers = 0;
    std::vector<Warning> wrong;
    std::vector<Defect> defects;
};

size_t morphTargets(const Mesh& m)
{
    size_t n = 0;
    for (const Attribute& a : m.attributes()) n += a.name.starts_with(names::morph);
    return n;
}

nlohmann::json point(const glm::dvec3& p)
{
    return {finite(p.x), finite(p.y), finite(p.z)};
}

size_t sum(const std::map<size_t, size_t>& counts)
{
    size_t all = 0;
    for (const auto& [value, n] : counts) all += value * n;
    return all;
}

nlohmann::json histogram(const std::map<size_t, size_t>& counts)
{
    nlohmann::json out = nlohmann::json::object();
    for (const auto& [key, n] : counts) out[std::to_string(key)] = n;
    return out;
}

nlohmann::json meshJson(const MeshInfo& info)
{
    const TopologyReport& r = info.mesh.topology();
    const Bounds b = info.mesh.bounds();
    return {{"name", info.name},
            {"vertices", r.vertices},
            {"edges", r.edges},
            {"faces", r.faces},
            {"triangles", r.triangles},
            {"euler", r.euler},
            {"genus", r.genus ? nlohmann::json(*r.genus) : nlohmann::json()},
            {"components", r.components},
            {"boundary_loops", r.boundaryLoops.size()},
            {"boundary_edges", r.boundaryEdges},
            {"nonmanifold_edges", r.nonmanifoldEdges.size()},
            {"nonmanifold_vertices", r.nonmanifoldVertices.size()},
            {"degenerate_faces", r.degenerateFaces.size()},
            {"duplicate_faces", r.duplicateFaces.size()},
            {"isolated_vertices", r.isolatedVertices.size()},
            {"orientable", r.orientable},
            {"consistently_oriented", r.consistentlyOriented},
            {"closed", r.closed},
            {"valence_histogram", histogram(r.vertexValences)},
            {"face_sizes", histogram(r.faceSizes)},
            {"valence_sum", sum(r.vertexValences)},
            {"face_size_sum", sum(r.faceSizes)},
            {"regular_vertices", r.regularVertices},
            {"bounds", {{"min", point(b.min)}, {"max", point(b.max)}}},
            {"area", finite(surfaceArea(info.mesh))},
            {"volume", finite(enclosedVolume(info.mesh))},
            {"morph_targets", morphTargets(info.mesh)},
            {"defects", defectsJson(info.defects)}};
}

// Names of the joints from a topmost one down, in the order of the tree; end sites only say where the last one ends.
std::vector<std::string> jointNames(const Scene& scene, NodeId top)
{
    std::vector<std::string> names;
    std::vector<NodeId> open{top};
    while (!open.empty()) {
        const Node& n = scene.node(open.back());
        open.pop_back();
        if (n.joint == Node::Joint::Joint) names.push_back(n.name);
        open.insert(open.end(), n.children.rbegin(), n.children.rend());
    }
    return names;
}

nlohmann::json skeletonsJson(const Scene& scene)
{
    nlohmann::json out = nlohmann::json::array();
    for (const NodeId top : skeletonRoots(scene)) out.push_back({{"root", scene.node(top).name}, {"joints", jointNames(scene, top)}});
    return out;
}

nlohmann::json clipsJson(const Scene& scene)
{
    nlohmann::json out = nlohmann::json::array();
    for (const ClipId id : scene.clips()) {
        const Clip& c = *scene.find(id);
        out.push_back({{"name", c.name}, {"duration", finite(duration(c))}, {"channels", c.channels.size()}, {"keys", keyCount(c)}});
    }
    return out;
}

nlohmann::json terrainsJson(const Scene& scene)
{
    nlohmann::json out = nlohmann::json::array();
    for (const TerrainId id : scene.terrains()) {
        const Terrain& t = scene.find(id)->terrain;
        out.push_back({{"name", t.name},
                       {"width", t.map.width()},
                       {"height", t.map.height()},
                       {"extent", finite(t.extent)},
                       {"maximum_height", finite(t.maximumHeight)},
                       {"water_level", finite(t.waterLevel)}});
    }
    return out;
}

nlohmann::json asJson(const std::string& file, const Imported& in, const std::vector<MeshInfo>& meshes)
{
    nlohmann::json list = nlohmann::json::array(), warnings = nlohmann::json::array();
    for (const Warning& w : in.warnings) warnings.push_back({{"code", w.code}, {"text", w.text}, {"elements", w.elements}});
    for (const MeshInfo& m : meshes) {
        list.push_back(meshJson(m));
        for (const Warning& w : m.wrong)
            warnings.push_back({{"code", w.code}, {"text", "mesh \"" + m.name + "\": " + w.text}, {"elements", w.elements}});
    }
    return {{"file", file},
            {"format", in.format},
            {"units", in.units},
            {"metres_per_unit", in.placement.metresPerUnit},
            {"up", upText(in.placement.up)},
            {"placement_from_file", in.placementFromFile},
            {"meshes", list},
            {"nodes", in.scene.nodes().size()},
            {"materials", in.scene.materials().size()},
            {"images", in.scene.images().size()},
            {"skeletons", skeletonsJson(in.scene)},
            {"clips", clipsJson(in.scene)},
            {"terrains", terrainsJson(in.scene)},
            {"warnings", warnings}};
}

std::string faceKinds(const TopologyReport& r)
{
    std::string out;
    for (const auto& [size, n] : r.faceSizes) {
        if (!out.empty()) out += ", ";
        if (out.size() > 60) return out + "...";
        out += size == 3 ? counted(n, "triangle") : size == 4 ? counted(n, "quad") : std::to_string(n) + " x " + std::to_string(size) + " corners";
    }
    return out.empty() ? "" : " (" + out + ")";
}

void printTopology(const Mesh& mesh, const TopologyReport& r)
{
    std::cout << "  " << counted(r.vertices, "vertex", "vertices") << ", " << counted(r.edges, "edge") << ", " << counted(r.faces, "face")
              << faceKinds(r) << '\n';
    if (r.faces > 0) {
        std::cout << "  Euler characteristic " << r.euler << ", genus " << (r.genus ? std::to_string(*r.genus) : "undefined") << ", "
                  << counted(r.components, "component") << ", ";
        if (r.boundaryLoops.empty())
            std::cout << (r.closed ? "closed" : "no boundary");
        else
            std::cout << counted(r.boundaryLoops.size(), "boundary loop") << " (" << counted(r.boundaryEdges, "edge") << ")";
        std::cout << ", " << (r.manifold() ? "manifold" : "not manifold") << ", "
                  << (!r.orientable            ? "not orientable"
                      : r.consistentlyOriented ? "consistently oriented"
                                               : "faces wound both ways")
                  << '\n';
        std::cout << "  area " << shown(surfaceArea(mesh));
        if (r.closed) std::cout << ", volume " << shown(enclosedVolume(mesh));
        size_t most = 0, valence = 0;
        for (const auto& [v, n] : r.vertexValences)
            if (v > 0 && n > most) most = n, valence = v;
        std::cout << ", " << shown(100.0 * double(r.regularVertices) / double(std::max<size_t>(1, r.vertices - r.isolatedVertices.size())))
                  << " % of the vertices regular, most of valence " << valence << "; the valences add up to " << sum(r.vertexValences) << '\n';
    }
    if (const Bounds b = mesh.bounds(); !b.empty) {
        const glm::dvec3 s = b.size();
        std::cout << "  size " << shown(s.x) << " x " << shown(s.y) << " x " << shown(s.z) << ", from (" << shown(b.min.x) << ", " << shown(b.min.y)
                  << ", " << shown(b.min.z) << ") to (" << shown(b.max.x) << ", " << shown(b.max.y) << ", " << shown(b.max.z) << ")\n";
    }
}

void printAttributes(const Mesh& mesh)
{
    static constexpr const char* domains[] = {"vertex", "corner", "face"};
    std::string line;
    for (const Attribute& a : mesh.attributes())
        line += (line.empty() ? "  attributes: " : ", ") + a.name + " (" + domains[size_t(a.domain)] + ", " + std::to_string(a.components) + ")";
    if (!line.empty()) std::cout << line << '\n';
    if (!mesh.lines().empty()) std::cout << "  " << counted(mesh.lines().size() / 2, "loose line") << '\n';
    if (!mesh.groupNames().empty()) std::cout << "  " << counted(mesh.groupNames().size(), "group") << '\n';
}

// The first few, so that a line stays one.
std::string firstOf(const std::vector<std::string>& names)
{
    std::string out;
    for (size_t i = 0; i < names.size(); ++i) {
        if (out.size() > 60) return out + ", ...";
        out += (i ? ", " : "") + (names[i].empty() ? "(no name)" : names[i]);
    }
    return out;
}

void printMotion(const Scene& scene)
{
    const std::vector<NodeId> tops = skeletonRoots(scene);
    if (!tops.empty() || !scene.clips().empty() || !scene.terrains().empty()) std::cout << '\n';
    for (const NodeId top : tops) {
        const std::vector<std::string> names = jointNames(scene, top);
        std::cout << "skeleton \"" << scene.node(top).name << "\": " << counted(names.size(), "joint") << " (" << firstOf(names) << ")\n";
    }
    for (const ClipId id : scene.clips()) {
        const Clip& c = *scene.find(id);
        std::cout << "clip \"" << c.name << "\": " << shown(duration(c)) << " s, " << counted(c.channels.size(), "channel") << ", "
                  << counted(keyCount(c), "key");
        if (c.frameTime > 0) std::cout << ", " << shown(1 / c.frameTime) << " frames a second";
        std::cout << '\n';
    }
    for (const TerrainId id : scene.terrains()) {
        const Terrain& t = scene.find(id)->terrain;
        std::cout << "terrain \"" << t.name << "\": " << t.map.width() << " x " << t.map.height() << " samples, " << shown(t.extent)
                  << " m wide, height 1 is " << shown(t.maximumHeight) << " m, water at " << shown(t.waterLevel) << " m\n";
    }
}

/// "units millimetres, z up", "units unknown, taken as metres, y up".
std::string placementText(const Imported& in)
{
    const std::string taken = unitText(in.placement.metresPerUnit);
    return "units " + in.units + (in.units == taken ? "" : ", taken as " + taken) + ", " + upText(in.placement.up) + " up";
}

// As a shell takes it: quoted where a name holds anything odd.
std::string quoted(const std::string& file)
{
    const auto plain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || std::string_view("/._-+:@%,").find(c) != std::string_view::npos;
    };
    if (!file.empty() && std::all_of(file.begin(), file.end(), plain)) return file;
    std::string out = "'";
    for (const char c : file) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

void printRepairs(const std::string& file, const std::vector<MeshInfo>& meshes)
{
    std::vector<std::string> calls;
    for (const MeshInfo& m : meshes)
        for (const std::string& call : repairCalls(m.defects))
            if (std::find(calls.begin(), calls.end(), call) == calls.end()) calls.push_back(call);
    if (calls.empty()) return;
    std::cout << "\nAll of it:\n  meshwright process " << quoted(file);
    for (const std::string& call : calls) std::cout << " --op " << call;
    std::cout << " -o OUT\n";
}

void printWrong(const std::string& file, const Imported& in, const std::vector<MeshInfo>& meshes)
{
    bool wrong = !in.warnings.empty();
    for (const MeshInfo& m : meshes)
        wrong = wrong || m.mesh.faceCount() == 0 || std::any_of(m.defects.begin(), m.defects.end(), [](const Defect& d) { return !d.passed(); });
    if (!wrong) {
        std::cout << "\nNothing is wrong with it.\n";
        return;
    }
    std::cout << "\nWhat is wrong, worst first:\n";
    for (const Warning& w : in.warnings) std::cout << "  - " << w.text << '\n';
    for (const MeshInfo& m : meshes) {
        if (meshes.size() > 1 && !m.wrong.empty()) std::cout << "  mesh \"" << m.name << "\":\n";
        if (m.mesh.faceCount() == 0)
            std::cout << "  - there are no faces, only " << counted(m.mesh.vertexCount(), "point")
                      << "\n    operations on surfaces have nothing to work on\n";
        printWorklist(m.mesh, m.defects);
    }
    printRepairs(file, meshes);
}

void printText(const std::string& file, const Imported& in, const std::vector<MeshInfo>& meshes)
{
    std::cout << file << ": " << in.format << ", " << placementText(in) << (in.project ? ", a Meshwright project" : "") << '\n'
              << counted(meshes.size(), "mesh", "meshes") << ", " << counted(in.scene.nodes().size(), "node") << ", "
              << counted(in.scene.materials().size(), "material") << ", " << counted(in.scene.images().size(), "image") << '\n';
    for (const MeshInfo& m : meshes) {
        std::cout << "\nmesh \"" << m.name << "\"" << (m.modifiers ? " (after " + counted(m.modifiers, "modifier") + ")" : "") << '\n';
        printTopology(m.mesh, m.mesh.topology());
        printAttributes(m.mesh);
    }
    printMotion(in.scene);
    printWrong(file, in, meshes);
}

int run(Arguments& arguments)
{
    const bool json = arguments.flag("--json"), intersections = arguments.flag("--self-intersections");
    const ImportOptions options = takeImportOptions(arguments);
    const std::string file = arguments.finish({"FILE"})[0];
    Imported in;
    std::vector<MeshInfo> meshes;
    {
        Working working("reading");
        in = readFile(file, working.progress(), options);
        for (MeshId id : in.scene.meshes()) {
            const MeshObject& object = *in.scene.find(id);
            working.now(object.name);
            MeshInfo m{object.name, {}, object.stack.size(), {}, {}};
            try {
                m.mesh = evaluated(object, working.progress(), nullptr, &in.scene);
            } catch (const Error& e) {
                m.mesh = object.base;
                in.warnings.push_back({"modifier-failed", e.reason() + "; the figures are of the mesh before its modifiers", {}});
            }
            m.wrong = findings(m.mesh, m.mesh.topology());
            DefectOptions checks;
            checks.selfIntersections = intersections || m.mesh.topology().triangles <= quickTriangles;
            m.defects = defectsOf(m.mesh, checks, working.progress());
            meshes.push_back(std::move(m));
        }
    }
    if (json)
        printJson(asJson(file, in, meshes));
    else
        printText(file, in, meshes);
    return 0;
}

}  // namespace

const Verb infoVerb{"info", "what is in a file, and what is wrong with it",
                    "info FILE [--unit UNIT] [--up y|z|x] [--json] [--self-intersections]\n\n"
                    "Counts, topology, bounds and attributes of each mesh; skeletons, clips and terrains; and what is wrong, worst first,\n"
                    "with the operations that mend it.\n"
                    "  --json                 one JSON object instead of text\n"
                    "  --self-intersections   look for them in meshes of more than 200,000 triangles, too\n",
                    run};

}  // namespace mw::cli
