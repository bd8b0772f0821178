// Texture coordinates of a mesh as a drawing.
#include "core/metrics/uv_layout.h"

#include <cmath>
#include <glm/common.hpp>
#include <string>

#include "core/error.h"
#include "core/mesh/connectivity.h"

namespace mw {
namespace {

std::string setName(int64_t set)
{
    return std::string(names::texcoord) + (set > 0 ? std::to_string(set) : "");
}

Array<glm::vec2> cornerCoordinates(const Mesh& mesh, const Attribute& a)
{
    Array<glm::vec2> out(mesh.cornerCount());
    const auto finite = [](double x) { return std::isfinite(x) ? float(x) : 0.f; };
    for (size_t c = 0; c < out.size(); ++c) {
        const size_t at = a.domain == Domain::Corner ? c : mesh.cornerVertex()[c];
        out[c] = {finite(a.at(at, 0)), finite(a.at(at, 1))};
    }
    return out;
}

double signedArea(std::span<const glm::vec2> face)
{
    double twice = 0;
    for (size_t i = 0; i < face.size(); ++i) {
        const glm::dvec2 a = face[i], b = face[(i + 1) % face.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * twice;
}

uint32_t nextCorner(const Mesh& mesh, std::span<const uint32_t> faceOf, uint32_t c)
{
    const uint32_t f = faceOf[c];
    return c + 1 < mesh.faceStart()[f + 1] ? c + 1 : mesh.faceStart()[f];
}

void addEdges(const Mesh& mesh, UvLayout& out)
{
    const Array<uint32_t> faceOf = cornerFacesOf(mesh);
    const EdgeSides edges = edgeSidesOf(mesh);
    for (size_t e = 0; e < edges.size(); ++e) {
        // A side's coordinates, at the lower vertex first, so that sides can be compared whichever way they run.
        const auto ends = [&](uint32_t c) {
            const uint32_t n = nextCorner(mesh, faceOf, c);
            return mesh.cornerVertex()[c] == edges.ends[2 * e] ? std::pair(c, n) : std::pair(n, c);
        };
        const auto sides = edges.sides(e);
        const auto [a, b] = ends(sides[0]);
        bool apart = false;
        for (const uint32_t side : sides) {
            const auto [c, d] = ends(side);
            apart = apart || out.corners[c] != out.corners[a] || out.corners[d] != out.corners[b];
        }
        out.seams += apart;
        const UvLayout::Kind kind = apart ? UvLayout::Seam : sides.size() == 1 ? UvLayout::Border : UvLayout::Inside;
        for (const uint32_t side : apart ? sides : sides.first(1)) {
            const auto [c, d] = ends(side);
            out.edges.push_back(c);
            out.edges.push_back(d);
            out.kinds.push_back(kind);
        }
    }
}

bool inside(std::span<const glm::vec2> face, glm::dvec2 p)
{
    bool in = false;
    for (size_t i = 0; i < face.size(); ++i) {
        const glm::dvec2 a = face[i], b = face[(i + 1) % face.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    }
    return in;
}

}  // namespace

const Attribute* textureSet(const Mesh& mesh, int64_t set)
{
    const std::string name = setName(set);
    const Attribute* a = mesh.find(name, Domain::Corner);
    if (!a) a = mesh.find(name, Domain::Vertex);
    return a && a->components >= 2 && a->size() >= mesh.count(a->domain) ? a : nullptr;
}

int64_t textureSets(const Mesh& mesh)
{
    int64_t n = 0;
    while (n < 64 && textureSet(mesh, n)) ++n;
    return n;
}

UvLayout uvLayoutOf(const Mesh& mesh, int64_t set)
{
    const Attribute* a = textureSet(mesh, set);
    if (!a)
        throw Error("the mesh has no texture coordinates" + (set > 0 ? " of set " + std::to_string(set) : std::string()) +
                    "; unwrap it, or read it from a file that has them");
    UvLayout out;
    out.corners = cornerCoordinates(mesh, *a);
    out.areas = Array<double>(mesh.faceCount(), 0.);
    bool first = true;
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        const std::span<const glm::vec2> face(out.corners.data() + mesh.faceStart()[f], mesh.face(f).size());
        out.areas[f] = signedArea(face);
        if (out.areas[f] < 0) out.folded.push_back(uint32_t(f));
        for (const glm::dvec2 p : face) {
            out.low = first ? p : glm::min(out.low, p);
            out.high = first ? p : glm::max(out.high, p);
            first = false;
        }
    }
    addEdges(mesh, out);
    return out;
}

std::vector<uint32_t> facesAt(const Mesh& mesh, const UvLayout& layout, glm::dvec2 point)
{
    std::vector<uint32_t> found;
    for (size_t f = 0; f < mesh.faceCount(); ++f)
        if (inside({layout.corners.data() + mesh.faceStart()[f], mesh.face(f).size()}, point)) found.push_back(uint32_t(f));
    return found;
}

}  // namespace mw
