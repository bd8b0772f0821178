// Whether a join survives depends on the faces at a place alone: the repair is run on these, with and without welding, and vertices are counted.
#include "core/repair/coincident.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "core/repair/fans.h"
#include "core/repair/rebuild.h"
#include "core/repair/repair.h"

namespace mw {

namespace {

using Place = std::tuple<float, float, float>;

Place placeOf(const glm::vec3& p)
{
    return {p.x + 0.f, p.y + 0.f, p.z + 0.f};  // -0 + 0 is 0
}

/// How many vertices with faces are at each place after the repair.
std::map<Place, size_t> vertexCounts(const Mesh& mesh, bool weld, Progress* progress)
{
    Stage<Mesh> stage(false);
    Repair options;
    options.weld = weld;
    Generator run = repair(mesh, options, stage);
    while (run.next())
        if (progress) progress->at(progress->fraction);
    std::map<Place, size_t> out;
    const Mesh repaired = stage.value();
    for (const glm::vec3& p : repaired.positions()) ++out[placeOf(p)];
    return out;
}

}  // namespace

Array<uint32_t> lowestAtPlace(const Mesh& mesh)
{
    const Shared<glm::vec3>& p = mesh.positions();
    Array<uint32_t> order(p.size()), first(p.size());
    std::iota(order.begin(), order.end(), 0u);
    std::iota(first.begin(), first.end(), 0u);
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        if (p[a].x != p[b].x) return p[a].x < p[b].x;
        if (p[a].y != p[b].y) return p[a].y < p[b].y;
        return p[a].z != p[b].z ? p[a].z < p[b].z : a < b;
    });
    for (size_t i = 1; i < order.size(); ++i)
        if (p[order[i]] == p[order[i - 1]]) first[order[i]] = first[order[i - 1]];
    return first;
}

std::vector<std::vector<uint32_t>> joinableVertices(const Mesh& mesh, Progress* progress)
{
    const Array<uint32_t> lowest = lowestAtPlace(mesh);
    std::vector<uint8_t> shared(mesh.vertexCount(), 0), used(mesh.vertexCount(), 0);
    for (const uint32_t v : mesh.cornerVertex()) used[v] = 1;
    for (uint32_t v = 0; v < lowest.size(); ++v)
        if (lowest[v] != v && used[v]) shared[lowest[v]] = 1;
    std::vector<uint8_t> elsewhere(mesh.faceCount(), 1);
    for (size_t f = 0; f < mesh.faceCount(); ++f)
        for (const uint32_t v : mesh.face(f))
            if (shared[lowest[v]]) elsewhere[f] = 0;
    std::vector<std::vector<uint32_t>> groups;
    if (std::find(elsewhere.begin(), elsewhere.end(), 0) == elsewhere.end()) return groups;
    Mesh bare(mesh.positions(), mesh.faceStart(), mesh.cornerVertex());
    const Mesh part = withoutFaces(markedForWelding(bare), elsewhere);
    const auto apart = vertexCounts(part, false, progress), welded = vertexCounts(part, true, progress);
    Array<uint32_t> group(mesh.vertexCount(), none);
    for (uint32_t v = 0; v < lowest.size(); ++v) {
        if (!used[v] || !shared[lowest[v]]) continue;
        uint32_t& g = group[lowest[v]];
        if (g == none) {
            const auto before = apart.find(placeOf(mesh.positions()[v])), after = welded.find(placeOf(mesh.positions()[v]));
            const size_t left = after == welded.end() ? 0 : after->second;
            if (before == apart.end() || left >= before->second) {
                shared[lowest[v]] = 0;
                continue;
            }
            g = uint32_t(groups.size());
            groups.emplace_back();
        }
        groups[g].push_back(v);
    }
    return groups;
}

}  // namespace mw
