// Each mending is a plain function from mesh to mesh; the coroutine calls those that are wanted, in an order in which none undoes another.
#include "core/repair/repair.h"

#include <algorithm>

#include "core/mesh/connectivity.h"
#include "core/mesh/rings.h"
#include "core/mesh/topology.h"
#include "core/mesh/triangulate.h"
#include "core/repair/components.h"
#include "core/repair/fans.h"
#include "core/repair/rebuild.h"
#include "core/repair/weld.h"

namespace mw {

namespace {

/// The corners of a face without those at the vertex of the corner before.
std::vector<uint32_t> tidyCorners(const Mesh& mesh, uint32_t f)
{
    std::vector<uint32_t> corners;
    const Shared<uint32_t>& at = mesh.cornerVertex();
    for (uint32_t c = mesh.faceStart()[f]; c < mesh.faceStart()[f + 1]; ++c)
        if (corners.empty() || at[corners.back()] != at[c]) corners.push_back(c);
    while (corners.size() > 1 && at[corners.back()] == at[corners.front()]) corners.pop_back();
    return corners;
}

bool visitsTwice(const Mesh& mesh, const std::vector<uint32_t>& corners)
{
    std::vector<uint32_t> vertices;
    for (const uint32_t c : corners) vertices.push_back(mesh.cornerVertex()[c]);
    std::sort(vertices.begin(), vertices.end());
    return std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
}

/// One polygon as triangles; those without three different vertices have no area and are left out.
void addTriangles(const Mesh& mesh, const std::vector<uint32_t>& corners, uint32_t face, Parts& parts)
{
    Array<uint32_t> vertices;
    for (const uint32_t c : corners) vertices.push_back(mesh.cornerVertex()[c]);
    const uint32_t n = uint32_t(vertices.size());
    const Mesh polygon(mesh.positions(), Array<uint32_t>{0u, n}, std::move(vertices));
    const Mesh::Triangulation cut = triangulationOf(polygon);
    for (size_t i = 0; i + 2 < cut.vertices.size(); i += 3) {
        const uint32_t a = cut.vertices[i], b = cut.vertices[i + 1], c = cut.vertices[i + 2];
        if (a == b || b == c || c == a) continue;
        for (size_t k = i; k < i + 3; ++k) parts.addCorner(cut.vertices[k], corners[cut.corners[k]]);
        parts.endFace(face);
    }
}

Mesh tidied(const Mesh& mesh)
{
    const std::vector<uint8_t> degenerate = degenerateFacesOf(mesh);
    if (degenerate.empty()) return mesh;
    Parts parts;
    parts.vertexFrom.resize(mesh.vertexCount());
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) parts.vertexFrom[v] = v;
    parts.lines.assign(mesh.lines().begin(), mesh.lines().end());
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
        if (!degenerate[f]) {
            for (uint32_t c = mesh.faceStart()[f]; c < mesh.faceStart()[f + 1]; ++c) parts.addCorner(mesh.cornerVertex()[c], c);
            parts.endFace(f);
            continue;
        }
        const std::vector<uint32_t> corners = tidyCorners(mesh, f);
        if (corners.size() < 3) continue;
        if (visitsTwice(mesh, corners)) {
            addTriangles(mesh, corners, f, parts);
            continue;
        }
        for (const uint32_t c : corners) parts.addCorner(mesh.cornerVertex()[c], c);
        parts.endFace(f);
    }
    return rebuilt(mesh, std::move(parts));
}

Mesh withoutDuplicates(const Mesh& mesh)
{
    std::vector<uint8_t> dropped(mesh.faceCount(), 0);
    for (const uint32_t f : mesh.topology().duplicateFaces) dropped[f] = 1;
    return withoutFaces(mesh, dropped);
}

std::vector<uint32_t> sortedFace(const Mesh& mesh, uint32_t f)
{
    std::vector<uint32_t> v(mesh.face(f).begin(), mesh.face(f).end());
    std::sort(v.begin(), v.end());
    return v;
}

/// Two faces of the same vertices that run the same way round.
bool sameWay(const Mesh& mesh, uint32_t f, uint32_t g)
{
    const auto a = mesh.face(f), b = mesh.face(g);
    const auto start = std::find(b.begin(), b.end(), a[0]);
    return a.size() == b.size() && start != b.end() && b[size_t(start - b.begin() + 1) % b.size()] == a[1];
}

/// Of what welding has laid on each other only copies go: a front and a back that had vertices of their own are no mistake.
Mesh withoutCopies(const Mesh& mesh)
{
    std::vector<uint8_t> dropped(mesh.faceCount(), 0);
    for (const uint32_t f : mesh.topology().duplicateFaces) {
        if (mesh.face(f).size() < 3) continue;
        const std::vector<uint32_t> vertices = sortedFace(mesh, f);
        const Rings& rings = mesh.rings();
        for (const uint32_t c : rings.cornersOf(vertices[0])) {
            const uint32_t g = uint32_t(std::upper_bound(mesh.faceStart().begin(), mesh.faceStart().end(), c) - mesh.faceStart().begin()) - 1;
            if (g < f && !dropped[g] && sortedFace(mesh, g) == vertices && sameWay(mesh, f, g)) dropped[f] = 1;
        }
    }
    return withoutFaces(mesh, dropped);
}

Mesh withoutTiny(const Mesh& mesh, double share)
{
    std::vector<uint8_t> dropped(mesh.faceCount(), 0);
    for (const auto& component : tinyComponents(mesh, share))
        for (const uint32_t f : component) dropped[f] = 1;
    return withoutFaces(mesh, dropped);
}

}  // namespace

Generator repair(Mesh input, Repair p, Stage<Mesh>& stage)
{
    Mesh mesh = input;
    stage.show([&] { return mesh; });
    co_yield Step("tidy").progress(0);
    if (p.dropDegenerate) mesh = tidied(mesh);
    co_yield Step("duplicates").progress(0.1);
    if (p.dropDuplicates) mesh = withoutDuplicates(mesh);
    if (p.weld) {
        Stage<Mesh> inner(false);
        Generator welding = weld(markedForWelding(mesh), {.distance = p.weldDistance, .dropDegenerate = false, .dropUnreferenced = false}, inner);
        while (welding.next()) co_yield Step("weld").progress(0.2 + 0.3 * std::max(0.0, double(welding.step().progress())));
        mesh = inner.value();
        if (p.dropDegenerate) mesh = tidied(mesh);
        if (p.dropDuplicates) mesh = withoutCopies(mesh);
    }
    co_yield Step("split").progress(0.6);
    if (p.splitEdges || p.splitVertices) mesh = splitNonmanifold(mesh, p.splitEdges, p.splitVertices);
    // A front and its back that are held together all round are a duplicate after all, and leave open fans behind.
    for (int round = 0; p.weld && p.dropDuplicates && round < 4 && !mesh.topology().duplicateFaces.empty(); ++round) {
        mesh = withoutDuplicates(mesh);
        if (p.splitEdges || p.splitVertices) mesh = splitNonmanifold(mesh, p.splitEdges, p.splitVertices);
    }
    mesh = withoutMarks(mesh);
    co_yield Step("components").progress(0.8);
    if (p.dropTiny) mesh = withoutTiny(mesh, p.tinyShare);
    co_yield Step("loose").progress(0.9);
    if (p.dropIsolated && input.faceCount() > 0) mesh = withoutLooseVertices(mesh);
    stage.finish(mesh);
}

}  // namespace mw
