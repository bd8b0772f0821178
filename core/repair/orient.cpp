// Flooding over faces: a neighbour that runs along the common edge the same way is to be turned over.
#include "core/repair/orient.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/mesh/connectivity.h"
#include "core/mesh/topology.h"
#include "core/repair/fans.h"
#include "core/repair/rebuild.h"

namespace mw {

namespace {

constexpr uint8_t unseen = 2;

/// What the flood knows: neighbours across edges of two faces, and for each face whether it is turned (1), stays (0) or is unseen.
class Flood {
public:
    explicit Flood(const Mesh& mesh);

    /// A face across a side of `face`; none where there is no neighbour, or more than one.
    uint32_t across(uint32_t side) const { return other_[side] == none ? none : faceOf(other_[side]); }
    /// True when both faces of the side run along it the same way, as they are turned now.
    bool disagree(uint32_t side) const
    {
        const bool sameWay = mesh_.cornerVertex()[side] == mesh_.cornerVertex()[other_[side]];
        return sameWay != (turned[faceOf(side)] != turned[faceOf(other_[side])]);
    }
    uint32_t next(uint32_t corner) const
    {
        const uint32_t f = faceOf(corner);
        return corner + 1 == mesh_.faceStart()[f + 1] ? mesh_.faceStart()[f] : corner + 1;
    }
    uint32_t faceOf(uint32_t corner) const { return face_.empty() ? corner / 3 : face_[corner]; }

    std::vector<uint8_t> turned;

private:
    const Mesh& mesh_;
    Array<uint32_t> face_;   // of each corner; empty for triangles
    Array<uint32_t> other_;  // the side across
};

Flood::Flood(const Mesh& mesh) : turned(mesh.faceCount(), unseen), mesh_(mesh), other_(mesh.cornerCount(), none)
{
    if (!mesh.isTriangles()) face_ = cornerFacesOf(mesh);
    const std::vector<uint8_t> degenerate = degenerateFacesOf(mesh);
    const EdgeSides edges = edgeSidesOf(mesh, degenerate);
    for (size_t e = 0; e < edges.size(); ++e) {
        const auto sides = edges.sides(e);
        if (sides.size() != 2) continue;
        other_[sides[0]] = sides[1];
        other_[sides[1]] = sides[0];
    }
    for (size_t f = 0; f < degenerate.size(); ++f)
        if (degenerate[f]) turned[f] = 0;
}

/// Corner k of a turned face is the old corner order(k): the first one stays, the others run backwards.
uint32_t oldCorner(uint32_t first, uint32_t count, uint32_t k)
{
    return k == 0 ? first : first + count - k;
}

Attribute scaledPart(const Attribute& a, const std::vector<uint8_t>& marked, int from, int to)
{
    Attribute out = a;
    Array<float> values(a.floats().begin(), a.floats().end());
    for (size_t i = 0; i < marked.size(); ++i)
        for (int k = from; marked[i] && k < to; ++k) values[i * size_t(a.components) + size_t(k)] *= -1;
    out.values = Shared<float>(std::move(values));
    return out;
}

/// The elements of a domain that belong to turned faces; a vertex when most of its corners do.
std::vector<uint8_t> turnedElements(const Mesh& mesh, const std::vector<uint8_t>& turned, Domain d)
{
    if (d == Domain::Face) return turned;
    std::vector<uint8_t> out(mesh.count(d), 0);
    std::vector<int> votes(d == Domain::Vertex ? mesh.vertexCount() : 0, 0);
    for (size_t f = 0; f < turned.size(); ++f)
        for (uint32_t c = mesh.faceStart()[f]; c < mesh.faceStart()[f + 1]; ++c) {
            if (d == Domain::Corner)
                out[c] = turned[f];
            else
                votes[mesh.cornerVertex()[c]] += turned[f] ? 1 : -1;
        }
    for (size_t v = 0; v < votes.size(); ++v) out[v] = votes[v] > 0;
    return out;
}

/// What points to the outside points the other way.
Attribute turnedDirections(const Mesh& mesh, const Attribute& a, const std::vector<uint8_t>& turned)
{
    const bool normal = (a.name == names::normal || a.name.starts_with("morph-normal:")) && a.components == 3;
    const bool tangent = a.name == names::tangent && a.components == 4;
    if ((!normal && !tangent) || a.floats().empty()) return a;
    return scaledPart(a, turnedElements(mesh, turned, a.domain), normal ? 0 : 3, normal ? 3 : 4);
}

Mesh withTurned(const Mesh& mesh, const std::vector<uint8_t>& faces)
{
    std::vector<uint8_t> turned = faces;
    for (uint8_t& t : turned) t = t == 1;
    if (std::find(turned.begin(), turned.end(), 1) == turned.end()) return mesh;
    Array<uint32_t> from(mesh.cornerCount()), edgeFrom(mesh.cornerCount()), vertices(mesh.cornerCount());
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
        const uint32_t first = mesh.faceStart()[f], n = mesh.faceStart()[f + 1] - first;
        for (uint32_t k = 0; k < n; ++k) {
            from[first + k] = turned[f] ? oldCorner(first, n, k) : first + k;
            edgeFrom[first + k] = turned[f] ? oldCorner(first, n, (k + 1) % n) : first + k;
            vertices[first + k] = mesh.cornerVertex()[from[first + k]];
        }
    }
    Mesh out(mesh.positions(), mesh.faceStart(), std::move(vertices));
    for (const Attribute& a : mesh.attributes()) {
        const bool ofEdges = a.name == names::crease;
        const Attribute placed = a.domain == Domain::Corner ? gathered(a, ofEdges ? edgeFrom : from) : a;
        out = out.with(turnedDirections(out, placed, turned));
    }
    return out.withLines(mesh.lines()).withGroupNames(mesh.groupNames());
}

/// Opens every edge of two faces that still run along it the same way.
Mesh cutOpen(const Mesh& mesh)
{
    if (mesh.topology().consistentlyOriented) return mesh;
    const EdgeSides edges = edgeSidesOf(mesh, degenerateFacesOf(mesh));
    const Shared<uint32_t>& at = mesh.cornerVertex();
    std::vector<uint8_t> where(mesh.vertexCount(), 0);
    CornerFans fans(mesh);
    for (size_t e = 0; e < edges.size(); ++e) {
        const auto sides = edges.sides(e);
        if (sides.size() == 2 && at[sides[0]] == at[sides[1]])
            where[edges.ends[2 * e]] = where[edges.ends[2 * e + 1]] = 1;
        else
            for (size_t i = 1; i < sides.size(); ++i) fans.join(sides[0], sides[i]);
    }
    return splitAtFans(mesh, fans, where);
}

/// One piece: its faces in the order of the flood.
struct Piece {
    std::vector<uint32_t> faces;
    bool closed = true;
};

/// Six times the volume that the piece encloses, faces turned as the flood has them.
double signedVolume(const Mesh& mesh, const Array<uint32_t>& firstTriangle, const Piece& piece, const std::vector<uint8_t>& turned)
{
    const Shared<uint32_t>& t = mesh.triangulation().vertices;
    const Shared<glm::vec3>& p = mesh.positions();
    if (piece.faces.empty() || mesh.face(piece.faces[0]).empty()) return 0;
    const glm::dvec3 origin(p[mesh.face(piece.faces[0])[0]]);
    double sum = 0;
    for (const uint32_t f : piece.faces)
        for (uint32_t i = firstTriangle[f]; i < firstTriangle[f + 1]; ++i) {
            const glm::dvec3 a = glm::dvec3(p[t[3 * i]]) - origin, b = glm::dvec3(p[t[3 * i + 1]]) - origin, c = glm::dvec3(p[t[3 * i + 2]]) - origin;
            sum += (turned[f] ? -1 : 1) * glm::dot(a, glm::cross(b, c));
        }
    return sum;
}

/// The triangles of face f are firstTriangle[f] .. firstTriangle[f+1]-1.
Array<uint32_t> firstTriangles(const Mesh& mesh)
{
    Array<uint32_t> first(mesh.faceCount() + 1, 0);
    for (const uint32_t f : mesh.triangulation().faces) ++first[f + 1];
    for (size_t f = 1; f < first.size(); ++f) first[f] += first[f - 1];
    return first;
}

bool shouldTurn(Orient::Outside rule, const Piece& piece, const std::vector<uint8_t>& turned, double volume)
{
    if (rule == Orient::Outside::KeepFirst) return false;
    if (rule == Orient::Outside::Outward && piece.closed && volume != 0) return volume < 0;
    size_t n = 0;
    for (const uint32_t f : piece.faces) n += turned[f];
    return 2 * n > piece.faces.size();
}

}  // namespace

Generator orient(Mesh input, Orient p, Stage<Mesh>& stage)
{
    const Mesh& mesh = input;
    Flood flood(mesh);
    stage.show([&] { return withTurned(mesh, flood.turned); });
    const Array<uint32_t> triangles = firstTriangles(mesh);
    const uint32_t count = uint32_t(mesh.faceCount());
    size_t seen = 0, turnedOver = 0;
    double pieces = 0;
    for (uint32_t start = 0; start < count; ++start) {
        if (flood.turned[start] != unseen) continue;
        Piece piece;
        piece.faces.push_back(start);
        flood.turned[start] = 0;
        ++pieces;
        if (stage.watched() || (uint64_t(pieces) & 255) == 0)
            co_yield Step("start").face(start, Role::Current, "f").number("piece", pieces).progress(double(seen) / count);
        for (size_t i = 0; i < piece.faces.size(); ++i) {
            const uint32_t f = piece.faces[i];
            ++seen;
            for (uint32_t c = mesh.faceStart()[f]; c < mesh.faceStart()[f + 1]; ++c) {
                const uint32_t g = flood.across(c);
                piece.closed = piece.closed && g != none;
                if (g == none || flood.turned[g] != unseen) continue;
                flood.turned[g] = 0;
                const bool turn = flood.disagree(c);
                flood.turned[g] = turn;
                turnedOver += turn;
                piece.faces.push_back(g);
                if (stage.watched() || (piece.faces.size() & 0xffff) == 0)
                    co_yield Step("visit")
                        .face(f, Role::Neighbour, "f")
                        .face(g, Role::Current, "g")
                        .edge(mesh.cornerVertex()[c], mesh.cornerVertex()[flood.next(c)], Role::Current, "e")
                        .number("turned", double(turn))
                        .number("visited", double(seen))
                        .number("turned over", double(turnedOver))
                        .progress(double(seen) / count);
            }
        }
        double left = 0;
        for (const uint32_t f : piece.faces)
            for (uint32_t c = mesh.faceStart()[f]; c < mesh.faceStart()[f + 1]; ++c) left += flood.across(c) != none && flood.disagree(c);
        const double volume = piece.closed ? signedVolume(mesh, triangles, piece, flood.turned) / 6 : 0;
        const bool turn = shouldTurn(p.outside, piece, flood.turned, volume);
        if (turn)
            for (const uint32_t f : piece.faces) flood.turned[f] ^= 1;
        if (stage.watched())
            co_yield Step("decide")
                .ring(ElementKind::Face, Role::Current, piece.faces)
                .number("piece", pieces)
                .number("faces", double(piece.faces.size()))
                .number("closed", double(piece.closed))
                .number("volume", volume)
                .number("turned", double(turn))
                .number("left", left / 2)
                .progress(double(seen) / count);
    }
    const Mesh out = withTurned(mesh, flood.turned);
    stage.finish(p.cut ? cutOpen(out) : out);
}

}  // namespace mw
