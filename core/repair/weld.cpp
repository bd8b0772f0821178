// Vertices at the same place become one: a hash grid finds who is near, the lowest index stays.
#include "core/repair/weld.h"

#include <bit>
#include <cmath>

#include "core/math/hash.h"

namespace mw {

namespace {

/// The vertices kept so far, by cells of twice the distance: whoever is within the distance lies in one of at most 2 x 2 x 2 cells. Kept
/// vertices are further apart than the distance, so a cell holds few, however many vertices there are.
class KeptVertices {
public:
    KeptVertices(const Shared<glm::vec3>& positions, double distance)
        : positions_(positions), distance_(distance), head_(std::bit_ceil(positions.size() + 1), none), next_(positions.size())
    {}

    /// The lowest kept vertex within the distance of vertex v; none when there is none.
    uint32_t nearest(uint32_t v) const;
    void keep(uint32_t v);

private:
    double cell(double x) const { return distance_ > 0 ? std::floor(x / (2 * distance_)) : x + 0.0; }  // -0 + 0 is 0
    uint32_t& head(double x, double y, double z)
    {
        Hasher h;
        h.number(std::bit_cast<uint64_t>(x + 0.0));
        h.number(std::bit_cast<uint64_t>(y + 0.0));
        h.number(std::bit_cast<uint64_t>(z + 0.0));
        return head_[h.value() & (head_.size() - 1)];
    }
    uint32_t head(double x, double y, double z) const { return const_cast<KeptVertices*>(this)->head(x, y, z); }

    const Shared<glm::vec3>& positions_;
    double distance_;
    std::vector<uint32_t> head_;
    Array<uint32_t> next_;
};

uint32_t KeptVertices::nearest(uint32_t v) const
{
    const glm::dvec3 p(positions_[v]);
    double low[3], high[3];
    for (int k = 0; k < 3; ++k) {
        low[k] = cell(p[k] - distance_);
        high[k] = cell(p[k] + distance_);
    }
    uint32_t best = none;
    for (int i = 0; i < 8; ++i) {
        const bool x = i & 1, y = i & 2, z = i & 4;
        if ((x && low[0] == high[0]) || (y && low[1] == high[1]) || (z && low[2] == high[2])) continue;
        for (uint32_t w = head(x ? high[0] : low[0], y ? high[1] : low[1], z ? high[2] : low[2]); w != none; w = next_[w]) {
            const glm::dvec3 d = glm::dvec3(positions_[w]) - p;
            if (d.x * d.x + d.y * d.y + d.z * d.z <= distance_ * distance_ && w < best) best = w;
        }
    }
    return best;
}

void KeptVertices::keep(uint32_t v)
{
    const glm::dvec3 p(positions_[v]);
    uint32_t& h = head(cell(p.x), cell(p.y), cell(p.z));
    next_[v] = h;
    h = v;
}

/// What becomes of the vertices.
struct Merge {
    Array<uint32_t> target;  ///< old vertex to new
    Array<uint32_t> from;    ///< new vertex to old
};

/// New vertices are numbered in the order of old ones; those without `used` are left out.
Merge numbered(const Array<uint32_t>& keptAs, const std::vector<uint8_t>& used)
{
    Merge m;
    m.target.assign(keptAs.size(), none);
    for (uint32_t v = 0; v < keptAs.size(); ++v) {
        if (keptAs[v] == v && used[v]) {
            m.target[v] = uint32_t(m.from.size());
            m.from.push_back(v);
        } else {
            m.target[v] = m.target[keptAs[v]];  // lower, so known
        }
    }
    return m;
}

std::vector<uint8_t> usedVertices(const Mesh& mesh, const Array<uint32_t>& keptAs, bool dropUnreferenced)
{
    std::vector<uint8_t> used(mesh.vertexCount(), dropUnreferenced ? 0 : 1);
    for (const uint32_t v : mesh.cornerVertex()) used[keptAs[v]] = 1;
    for (const uint32_t v : mesh.lines()) used[keptAs[v]] = 1;
    return used;
}

bool belongsToCorners(const Attribute& a)
{
    return a.name == names::normal || a.name == names::tangent || a.name.starts_with(names::texcoord) || a.name.starts_with(names::color);
}

bool differs(const Attribute& a, const Merge& m)
{
    for (size_t v = 0; v < m.target.size(); ++v) {
        if (m.target[v] == none) continue;
        const uint32_t kept = m.from[m.target[v]];
        for (int k = 0; kept != v && k < a.components; ++k)
            if (a.at(v, k) != a.at(kept, k)) return true;
    }
    return false;
}

/// Faces over the new vertices: which old corners and faces are left.
struct Faces {
    Array<uint32_t> start{0u}, vertices;
    Array<uint32_t> fromCorner, fromFace;
    bool all = true;  ///< nothing was left out
};

Faces mergedFaces(const Mesh& mesh, const Merge& m, bool tidy)
{
    Faces out;
    out.vertices.reserve(mesh.cornerCount());
    for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
        const uint32_t first = mesh.faceStart()[f], end = mesh.faceStart()[f + 1];
        const size_t begin = out.vertices.size();
        for (uint32_t c = first; c < end; ++c) {
            const uint32_t v = m.target[mesh.cornerVertex()[c]];
            if (tidy && out.vertices.size() > begin && out.vertices.back() == v) continue;
            out.vertices.push_back(v);
            out.fromCorner.push_back(c);
        }
        while (tidy && out.vertices.size() > begin + 1 && out.vertices.back() == out.vertices[begin]) {
            out.vertices.pop_back();
            out.fromCorner.pop_back();
        }
        if (tidy && out.vertices.size() - begin < 3) {
            out.vertices.resize(begin);
            out.fromCorner.resize(begin);
        } else {
            out.start.push_back(uint32_t(out.vertices.size()));
            out.fromFace.push_back(f);
        }
    }
    out.all = out.vertices.size() == mesh.cornerCount() && out.fromFace.size() == mesh.faceCount();
    return out;
}

Shared<uint32_t> mergedLines(const Mesh& mesh, const Merge& m, bool tidy)
{
    Array<uint32_t> lines;
    for (size_t i = 0; i + 1 < mesh.lines().size(); i += 2) {
        const uint32_t a = m.target[mesh.lines()[i]], b = m.target[mesh.lines()[i + 1]];
        if (!tidy || a != b) lines.insert(lines.end(), {a, b});
    }
    return lines;
}

Mesh welded(const Mesh& mesh, const Merge& m, bool tidy)
{
    Array<glm::vec3> positions(m.from.size());
    for (size_t v = 0; v < positions.size(); ++v) positions[v] = mesh.positions()[m.from[v]];
    Faces faces = mergedFaces(mesh, m, tidy);
    Mesh out(std::move(positions), faces.all ? mesh.faceStart() : Shared<uint32_t>(std::move(faces.start)), std::move(faces.vertices));
    for (const Attribute& a : mesh.attributes()) {
        if (a.domain == Domain::Vertex && mesh.cornerCount() > 0 && belongsToCorners(a) && !mesh.find(a.name, Domain::Corner) && differs(a, m)) {
            Array<uint32_t> vertexOfCorner(faces.fromCorner.size());
            for (size_t c = 0; c < vertexOfCorner.size(); ++c) vertexOfCorner[c] = mesh.cornerVertex()[faces.fromCorner[c]];
            Attribute moved = gathered(a, vertexOfCorner);
            moved.domain = Domain::Corner;
            out = out.with(std::move(moved));
        } else if (a.domain == Domain::Vertex) {
            out = out.with(gathered(a, m.from));
        } else {
            out = out.with(faces.all ? a : gathered(a, a.domain == Domain::Corner ? faces.fromCorner : faces.fromFace));
        }
    }
    return out.withLines(mergedLines(mesh, m, tidy)).withGroupNames(mesh.groupNames());
}

}  // namespace

Generator weld(Mesh input, Weld parameters, Stage<Mesh>& stage)
{
    const uint32_t n = uint32_t(input.vertexCount());
    KeptVertices kept(input.positions(), parameters.distance);
    Array<uint32_t> keptAs(n);
    uint32_t merged = 0;
    for (uint32_t v = 0; v < n; ++v) {
        if ((v & 0xffff) == 0) co_yield Step("find near vertices").number("merged", merged).progress(0.8 * v / n);
        keptAs[v] = kept.nearest(v);
        if (keptAs[v] == none) {
            keptAs[v] = v;
            kept.keep(v);
        } else {
            ++merged;
        }
    }
    co_yield Step("merge").number("merged", merged).progress(0.8);
    const std::vector<uint8_t> used = usedVertices(input, keptAs, parameters.dropUnreferenced);
    stage.finish(welded(input, numbered(keptAs, used), parameters.dropDegenerate));
}

}  // namespace mw
