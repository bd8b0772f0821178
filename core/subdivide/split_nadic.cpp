// Every face becomes a lattice: of barycentric coordinates in a triangle, of two parameters in a quad.
#include "core/subdivide/split_nadic.h"

#include <cmath>

#include "core/subdivide/carried.h"
#include "core/subdivide/face_edges.h"

namespace mw {

namespace {

/// A point of the lattice of a face: weights of its corners.
struct LatticePoint {
    double weight[4];
};

/// One face's lattice. Triangle: i steps from corner 0 to 1, j from 0 to 2. Quad: i from 0 to 1, j from 0 to 3.
class Lattice {
public:
    Lattice(const Mesh& mesh, const FaceEdges& edges, uint32_t n) : mesh_(mesh), edges_(edges), n_(n) {}
    /// `inner`: the vertex that the first point inside gets.
    void enter(size_t face, uint32_t inner)
    {
        first_ = mesh_.faceStart()[face];
        corners_ = mesh_.faceStart()[face + 1] - first_;
        inner_ = inner;
    }
    uint32_t corners() const { return corners_; }
    uint32_t innerCount() const { return corners_ == 3 ? (n_ - 1) * (n_ - 2) / 2 : (n_ - 1) * (n_ - 1); }

    uint32_t vertex(uint32_t i, uint32_t j) const
    {
        if (corners_ == 3) {
            if (j == 0) return i == n_ ? corner(1) : onSide(0, i);
            if (i + j == n_) return onSide(1, j);
            if (i == 0) return onSide(2, n_ - j);
            return inner_ + (j - 1) * (n_ - 1) - (j - 1) * j / 2 + i - 1;
        }
        if (j == 0) return i == n_ ? corner(1) : onSide(0, i);
        if (i == n_) return onSide(1, j);
        if (j == n_) return onSide(2, n_ - i);
        if (i == 0) return onSide(3, n_ - j);
        return inner_ + (j - 1) * (n_ - 1) + i - 1;
    }
    LatticePoint weights(uint32_t i, uint32_t j) const
    {
        const double u = double(i) / n_, w = double(j) / n_;
        if (corners_ == 3) return {{double(n_ - i - j) / n_, u, w, 0}};
        return {{(1 - u) * (1 - w), u * (1 - w), u * w, (1 - u) * w}};
    }
    /// Calls body(i, j) for the points inside, in the order of their vertices.
    template <class Body>
    void forInner(const Body& body) const
    {
        for (uint32_t j = 1; j < n_; ++j)
            for (uint32_t i = 1; i + (corners_ == 3 ? j : 0) < n_; ++i) body(i, j);
    }
    /// Calls body(pairs i, j of the corners) for each piece.
    template <class Body>
    void forPieces(const Body& body) const
    {
        using Piece = std::vector<std::pair<uint32_t, uint32_t>>;
        for (uint32_t j = 0; j < n_; ++j)
            for (uint32_t i = 0; i + (corners_ == 3 ? j : 0) < n_; ++i) {
                if (corners_ == 4) {
                    body(Piece{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
                    continue;
                }
                body(Piece{{i, j}, {i + 1, j}, {i, j + 1}});
                if (i + j + 1 < n_) body(Piece{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
            }
    }
    /// The old side that the step from one point to the next runs along, by its corner; none inside.
    uint32_t sideOf(std::pair<uint32_t, uint32_t> a, std::pair<uint32_t, uint32_t> b) const
    {
        if (a.second == 0 && b.second == 0) return first_;
        if (corners_ == 3) {
            if (a.first + a.second == n_ && b.first + b.second == n_) return first_ + 1;
            return a.first == 0 && b.first == 0 ? first_ + 2 : none;
        }
        if (a.first == n_ && b.first == n_) return first_ + 1;
        if (a.second == n_ && b.second == n_) return first_ + 2;
        return a.first == 0 && b.first == 0 ? first_ + 3 : none;
    }
    uint32_t corner(uint32_t k) const { return mesh_.cornerVertex()[first_ + k]; }
    uint32_t firstCorner() const { return first_; }

private:
    uint32_t onSide(uint32_t side, uint32_t step) const
    {
        if (step == 0) return corner(side);
        if (step == n_) return corner((side + 1) % corners_);
        const uint32_t half = edges_.half[first_ + side];
        return uint32_t(mesh_.vertexCount()) + (half >> 1) * (n_ - 1) + (half & 1 ? n_ - 1 - step : step - 1);
    }
    const Mesh& mesh_;
    const FaceEdges& edges_;
    uint32_t n_, first_ = 0, corners_ = 0, inner_ = 0;
};

/// All that a level makes.
struct Split {
    Array<glm::vec3> points;
    Array<uint32_t> start{0u}, corner, face, side;  // side: the old corner whose side a new corner's side is part of, or none
    Stencils vertexRows, cornerRows;
};

glm::vec3 between(const Mesh& mesh, Ends e, double t)
{
    return glm::vec3((1 - t) * glm::dvec3(mesh.positions()[e.a]) + t * glm::dvec3(mesh.positions()[e.b]));
}

void addVertices(const Mesh& mesh, const FaceEdges& edges, uint32_t n, Split& out)
{
    out.points.assign(mesh.positions().begin(), mesh.positions().end());
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) out.vertexRows.add(v, 1), out.vertexRows.endRow();
    for (const Ends& e : edges.ends)
        for (uint32_t i = 1; i < n; ++i) {
            out.points.push_back(between(mesh, e, double(i) / n));
            out.vertexRows.add(e.a, double(n - i) / n), out.vertexRows.add(e.b, double(i) / n), out.vertexRows.endRow();
        }
}

void addFace(const Mesh& mesh, Lattice& lattice, uint32_t f, Split& out)
{
    lattice.enter(f, uint32_t(out.points.size()));
    lattice.forInner([&](uint32_t i, uint32_t j) {
        const LatticePoint w = lattice.weights(i, j);
        glm::dvec3 p(0);
        for (uint32_t k = 0; k < lattice.corners(); ++k) {
            p += w.weight[k] * glm::dvec3(mesh.positions()[lattice.corner(k)]);
            out.vertexRows.add(lattice.corner(k), w.weight[k]);
        }
        out.vertexRows.endRow();
        out.points.emplace_back(p);
    });
    lattice.forPieces([&](const std::vector<std::pair<uint32_t, uint32_t>>& piece) {
        for (size_t c = 0; c < piece.size(); ++c) {
            const auto [i, j] = piece[c];
            out.corner.push_back(lattice.vertex(i, j));
            out.side.push_back(lattice.sideOf(piece[c], piece[(c + 1) % piece.size()]));
            const LatticePoint w = lattice.weights(i, j);
            for (uint32_t k = 0; k < lattice.corners(); ++k)
                if (w.weight[k] != 0) out.cornerRows.add(lattice.firstCorner() + k, w.weight[k]);
            out.cornerRows.endRow();
        }
        out.start.push_back(uint32_t(out.corner.size()));
        out.face.push_back(f);
    });
}

Mesh meshOf(Split& split, const Mesh& old)
{
    Origins o;
    o.vertexRows = [&] { return std::move(split.vertexRows); };
    o.corner = [&](const Attribute& a) { return blended(a, split.cornerRows); };
    o.crease = [&](const Attribute& a) {
        Array<float> crease(split.side.size(), 0.f);
        for (size_t c = 0; c < crease.size(); ++c)
            if (split.side[c] != none) crease[c] = float(a.at(split.side[c], 0));
        return floatAttribute(a.name, Domain::Corner, 1, std::move(crease));
    };
    o.faces = [&] { return split.face; };
    const std::vector<Attribute> attributes = carried(old.attributes(), o);
    Mesh out = Mesh(std::move(split.points), std::move(split.start), std::move(split.corner)).withGroupNames(old.groupNames());
    if (!old.lines().empty()) out = out.withLines(old.lines());
    return withAttributes(std::move(out), attributes);
}

}  // namespace

Generator splitNadic(Mesh input, SplitNadic parameters, Stage<Mesh>& stage)
{
    Mesh mesh = polygonsCut(input, 4);
    const uint32_t n = uint32_t(parameters.n);
    checkResultSize(double(mesh.faceCount()) * std::pow(double(n), 2 * double(parameters.levels)),
                    "n=" + std::to_string(n) + ",levels=" + std::to_string(parameters.levels));
    stage.show([&mesh] { return mesh; });
    const double share = 1.0 / double(parameters.levels);
    for (int64_t level = 1; level <= parameters.levels; ++level) {
        const double done = double(level - 1) * share;
        const FaceEdges edges = faceEdgesOf(mesh, {}, 1);
        Split split;
        addVertices(mesh, edges, n, split);
        for (uint32_t e = 0; stage.watched() && e < edges.size(); ++e) {
            Step step("edge");
            std::move(step).edge(edges.ends[e].a, edges.ends[e].b, Role::Current);
            std::move(step).vertex(edges.ends[e].a, Role::Current, "A").vertex(edges.ends[e].b, Role::Current, "B");
            for (uint32_t i = 1; i < n; ++i) std::move(step).point(split.points[mesh.vertexCount() + e * (n - 1) + i - 1], Role::New);
            std::move(step).number("level", double(level)).number("n", n).number("points", double(e + 1) * (n - 1));
            std::move(step).progress(done + 0.5 * share * e / double(edges.size()));
            co_yield step;
        }
        Lattice lattice(mesh, edges, n);
        for (uint32_t f = 0; f < mesh.faceCount(); ++f) {
            const size_t before = split.points.size();
            addFace(mesh, lattice, f, split);
            if (!stage.watched() && f % 4096 != 0) continue;
            Step step("face");
            std::move(step).face(f, Role::Current).ring(ElementKind::Vertex, Role::Neighbour, mesh.face(f));
            for (size_t p = before; p < split.points.size(); ++p) std::move(step).point(split.points[p], Role::New);
            std::move(step).number("level", double(level)).number("corners", double(lattice.corners())).number("inner", lattice.innerCount());
            std::move(step).number("pieces", double(n) * n).progress(done + share * (0.5 + 0.4 * f / double(mesh.faceCount())));
            co_yield step;
        }
        Mesh next = meshOf(split, mesh);
        mesh = std::move(next);
        co_yield Step("split")
            .number("level", double(level))
            .number("vertices", double(mesh.vertexCount()))
            .number("faces", double(mesh.faceCount()))
            .progress(double(level) * share);
    }
    stage.finish(std::move(mesh));
}

}  // namespace mw
