#include "core/repair/rebuild.h"

#include <algorithm>
#include <numeric>

namespace mw {

Mesh rebuilt(const Mesh& mesh, Parts parts)
{
    Array<glm::vec3> positions(parts.vertexFrom.size());
    for (size_t v = 0; v < positions.size(); ++v) positions[v] = mesh.positions()[parts.vertexFrom[v]];
    Mesh out(std::move(positions), std::move(parts.faceStart), std::move(parts.cornerVertex));
    for (const Attribute& a : mesh.attributes()) {
        const auto& from = a.domain == Domain::Vertex ? parts.vertexFrom : a.domain == Domain::Corner ? parts.cornerFrom : parts.faceFrom;
        out = out.with(gathered(a, from));
    }
    return out.withLines(std::move(parts.lines)).withGroupNames(mesh.groupNames());
}

Mesh withoutFaces(const Mesh& mesh, const std::vector<uint8_t>& dropped)
{
    if (std::find(dropped.begin(), dropped.end(), 1) == dropped.end()) return mesh;
    Parts parts;
    parts.vertexFrom.resize(mesh.vertexCount());
    std::iota(parts.vertexFrom.begin(), parts.vertexFrom.end(), 0u);
    parts.lines.assign(mesh.lines().begin(), mesh.lines().end());
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
        if (dropped[f]) continue;
        for (uint32_t c = mesh.faceStart()[f]; c < mesh.faceStart()[f + 1]; ++c) parts.addCorner(mesh.cornerVertex()[c], c);
        parts.endFace(f);
    }
    return rebuilt(mesh, std::move(parts));
}

Mesh withoutLooseVertices(const Mesh& mesh)
{
    Array<uint32_t> target(mesh.vertexCount(), none);
    for (const uint32_t v : mesh.cornerVertex()) target[v] = 0;
    for (const uint32_t v : mesh.lines()) target[v] = 0;
    Parts parts;
    for (uint32_t v = 0; v < target.size(); ++v) {
        if (target[v] == none) continue;
        target[v] = uint32_t(parts.vertexFrom.size());
        parts.vertexFrom.push_back(v);
    }
    if (parts.vertexFrom.size() == mesh.vertexCount()) return mesh;
    parts.faceStart.assign(mesh.faceStart().begin(), mesh.faceStart().end());
    parts.cornerFrom.resize(mesh.cornerCount());
    std::iota(parts.cornerFrom.begin(), parts.cornerFrom.end(), 0u);
    parts.faceFrom.resize(mesh.faceCount());
    std::iota(parts.faceFrom.begin(), parts.faceFrom.end(), 0u);
    for (const uint32_t v : mesh.cornerVertex()) parts.cornerVertex.push_back(target[v]);
    for (const uint32_t v : mesh.lines()) parts.lines.push_back(target[v]);
    return rebuilt(mesh, std::move(parts));
}

}  // namespace mw
