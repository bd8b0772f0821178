#include "app/cli/findings.h"

#include <algorithm>
#include <numeric>

#include "app/cli/output.h"

namespace mw::cli {

namespace {

constexpr size_t sample = 1000;  // elements listed of each finding

std::vector<uint32_t> some(const std::vector<uint32_t>& all)
{
    return {all.begin(), all.begin() + long(std::min(all.size(), sample))};
}

// Pairs of end vertices, one after the other.
std::vector<uint32_t> some(const std::vector<TopologyReport::Edge>& all)
{
    std::vector<uint32_t> flat;
    for (size_t i = 0; i < std::min(all.size(), sample); ++i) {
        flat.push_back(all[i].first);
        flat.push_back(all[i].second);
    }
    return flat;
}

// Vertices at exactly the place of one of lower index.
std::vector<uint32_t> coincident(const Mesh& mesh)
{
    const std::span<const glm::vec3> p = mesh.positions();
    std::vector<uint32_t> order(p.size()), out;
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](uint32_t v) { return std::tuple(p[v].x, p[v].y, p[v].z); };
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
    for (size_t i = 1; i < order.size(); ++i)
        if (key(order[i]) == key(order[i - 1])) out.push_back(order[i]);
    std::sort(out.begin(), out.end());
    return out;
}

}  // namespace

std::vector<Warning> findings(const Mesh& mesh, const TopologyReport& r)
{
    std::vector<Warning> out;
    const auto add = [&](size_t n, const char* code, std::string text, std::vector<uint32_t> elements) {
        if (n > 0) out.push_back({code, std::move(text), std::move(elements)});
    };
    add(mesh.faceCount() == 0, "no-faces", "there are no faces, only " + counted(mesh.vertexCount(), "point"), {});
    const std::vector<uint32_t> twins = coincident(mesh);
    add(r.nonmanifoldEdges.size(), "nonmanifold-edges", counted(r.nonmanifoldEdges.size(), "edge has", "edges have") + " more than two faces",
        some(r.nonmanifoldEdges));
    add(r.nonmanifoldVertices.size(), "nonmanifold-vertices",
        counted(r.nonmanifoldVertices.size(), "vertex joins", "vertices join") + " more than one fan of faces", some(r.nonmanifoldVertices));
    add(!r.orientable, "not-orientable", "the surface has one side only (as a Moebius strip)", {});
    add(r.orientable ? r.inconsistentEdges.size() : 0, "inconsistent-orientation",
        counted(r.inconsistentEdges.size(), "edge has", "edges have") + " neighbouring faces that face opposite ways", some(r.inconsistentEdges));
    add(r.degenerateFaces.size(), "degenerate-faces",
        counted(r.degenerateFaces.size(), "face has", "faces have") + " fewer than three corners or a vertex twice", some(r.degenerateFaces));
    add(r.duplicateFaces.size(), "duplicate-faces",
        counted(r.duplicateFaces.size(), "face has", "faces have") + " the same vertices as an earlier one", some(r.duplicateFaces));
    add(twins.size(), "coincident-vertices", counted(twins.size(), "vertex is", "vertices are") + " at exactly the place of another", some(twins));
    add(mesh.faceCount() == 0 ? 0 : r.isolatedVertices.size(), "isolated-vertices",
        counted(r.isolatedVertices.size(), "vertex belongs", "vertices belong") + " to no face", some(r.isolatedVertices));
    return out;
}

}  // namespace mw::cli
