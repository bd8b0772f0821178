#include "core/mesh/submesh.h"

#include <algorithm>

namespace mw {
namespace {

// Vertices that faces and lines of a mesh use, of those kept.
std::vector<bool> used(const Mesh& mesh, const KeptElements& kept)
{
    std::vector<bool> out(mesh.vertexCount(), false);
    for (size_t f = 0; f < mesh.faceCount(); ++f)
        if (kept.faces[f])
            for (const uint32_t v : mesh.face(f)) out[v] = true;
    for (size_t l = 0; l < kept.lines.size(); ++l)
        if (kept.lines[l]) out[mesh.lines()[2 * l]] = out[mesh.lines()[2 * l + 1]] = true;
    return out;
}

// What only elements that went had used goes, too.
void dropOrphans(const Mesh& mesh, KeptElements& kept)
{
    const std::vector<bool> before = used(mesh, KeptElements(mesh)), after = used(mesh, kept);
    for (size_t v = 0; v < before.size(); ++v)
        if (before[v] && !after[v]) kept.vertices[v] = false;
}

void dropVertices(const Mesh& mesh, const ElementSet& set, KeptElements& kept)
{
    for (const uint32_t v : set.indices) kept.vertices.at(v) = false;
    for (size_t f = 0; f < mesh.faceCount(); ++f)
        for (const uint32_t v : mesh.face(f)) kept.faces[f] = kept.faces[f] && kept.vertices[v];
    for (size_t l = 0; l < kept.lines.size(); ++l) kept.lines[l] = kept.vertices[mesh.lines()[2 * l]] && kept.vertices[mesh.lines()[2 * l + 1]];
}

void dropEdges(const Mesh& mesh, const ElementSet& set, KeptElements& kept)
{
    std::vector<std::pair<uint32_t, uint32_t>> edges;
    for (size_t i = 0; i + 1 < set.indices.size(); i += 2) edges.push_back(std::minmax(set.indices[i], set.indices[i + 1]));
    std::sort(edges.begin(), edges.end());
    const auto gone = [&](uint32_t a, uint32_t b) {
        return std::binary_search(edges.begin(), edges.end(), std::pair<uint32_t, uint32_t>(std::minmax(a, b)));
    };
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto corners = mesh.face(f);
        for (size_t i = 0; i < corners.size(); ++i)
            if (gone(corners[i], corners[(i + 1) % corners.size()])) kept.faces[f] = false;
    }
    for (size_t l = 0; l < kept.lines.size(); ++l)
        if (gone(mesh.lines()[2 * l], mesh.lines()[2 * l + 1])) kept.lines[l] = false;
}

// The numbers of what is kept.
Array<uint32_t> numbersOf(const std::vector<bool>& kept)
{
    Array<uint32_t> out;
    for (size_t i = 0; i < kept.size(); ++i)
        if (kept[i]) out.push_back(uint32_t(i));
    return out;
}

}  // namespace

Mesh submesh(const Mesh& mesh, const KeptElements& kept)
{
    const Array<uint32_t> vertices = numbersOf(kept.vertices), faces = numbersOf(kept.faces);
    Array<uint32_t> number(mesh.vertexCount(), none), start{0u}, corner, cornerFrom, lines;
    Array<glm::vec3> positions(vertices.size());
    for (size_t i = 0; i < vertices.size(); ++i) {
        number[vertices[i]] = uint32_t(i);
        positions[i] = mesh.positions()[vertices[i]];
    }
    for (const uint32_t f : faces) {
        for (uint32_t c = mesh.faceStart()[f]; c < mesh.faceStart()[f + 1]; ++c) {
            corner.push_back(number[mesh.cornerVertex()[c]]);
            cornerFrom.push_back(c);
        }
        start.push_back(uint32_t(corner.size()));
    }
    for (size_t l = 0; l < kept.lines.size(); ++l)
        if (kept.lines[l])
            for (const size_t end : {2 * l, 2 * l + 1}) lines.push_back(number[mesh.lines()[end]]);
    Mesh out(std::move(positions), std::move(start), std::move(corner));
    if (!lines.empty()) out = out.withLines(std::move(lines));
    for (const Attribute& a : mesh.attributes())
        out = out.with(gathered(a, a.domain == Domain::Vertex ? vertices : a.domain == Domain::Corner ? cornerFrom : faces));
    return out.withGroupNames(mesh.groupNames());
}

Mesh withoutElements(const Mesh& mesh, const ElementSet& elements)
{
    KeptElements kept(mesh);
    if (elements.kind == ElementKind::Vertex) dropVertices(mesh, elements, kept);
    if (elements.kind == ElementKind::Edge) dropEdges(mesh, elements, kept);
    if (elements.kind == ElementKind::Face)
        for (const uint32_t f : elements.indices) kept.faces.at(f) = false;
    dropOrphans(mesh, kept);
    return submesh(mesh, kept);
}

SplitMesh splitFaces(const Mesh& mesh, const std::vector<bool>& named)
{
    KeptElements first(mesh), second(mesh);
    for (size_t f = 0; f < named.size(); ++f) {
        first.faces[f] = named[f];
        second.faces[f] = !named[f];
    }
    std::fill(first.lines.begin(), first.lines.end(), false);
    first.vertices = used(mesh, first);
    dropOrphans(mesh, second);
    return {submesh(mesh, first), submesh(mesh, second)};
}

}  // namespace mw
