// Level by level: the middle of every edge, the centre of every face that is no triangle, the pieces.
#include "core/subdivide/split_dyadic.h"

#include <cmath>

#include "core/subdivide/carried.h"
#include "core/subdivide/face_edges.h"

namespace mw {

namespace {

/// Vertices of the next level: old ones, middles of edges, centres of faces.
struct Split {
    const Mesh& mesh;
    FaceEdges edges;
    Array<uint32_t> centre;  // by face; none for triangles
    uint32_t centres = 0;

    explicit Split(const Mesh& m) : mesh(m), edges(faceEdgesOf(m, {}, 1)), centre(m.faceCount(), none)
    {
        const uint32_t first = uint32_t(mesh.vertexCount() + edges.size());
        for (size_t f = 0; f < mesh.faceCount(); ++f)
            if (mesh.face(f).size() != 3) centre[f] = first + centres++;
    }
    FaceCut cut() const { return {mesh.faceStart(), mesh.faceCount(), 3, true}; }
    uint32_t middle(uint32_t corner) const { return uint32_t(mesh.vertexCount()) + (edges.half[corner] >> 1); }
    glm::vec3 middlePoint(uint32_t e) const
    {
        return glm::vec3(0.5 * (glm::dvec3(mesh.positions()[edges.ends[e].a]) + glm::dvec3(mesh.positions()[edges.ends[e].b])));
    }
    glm::vec3 centrePoint(size_t f) const
    {
        glm::dvec3 sum(0);
        for (const uint32_t v : mesh.face(f)) sum += glm::dvec3(mesh.positions()[v]);
        return glm::vec3(sum / double(mesh.face(f).size()));
    }
    Array<glm::vec3> points() const
    {
        Array<glm::vec3> p(mesh.positions().begin(), mesh.positions().end());
        p.reserve(p.size() + edges.size() + centres);
        for (uint32_t e = 0; e < edges.size(); ++e) p.push_back(middlePoint(e));
        for (size_t f = 0; f < mesh.faceCount(); ++f)
            if (centre[f] != none) p.push_back(centrePoint(f));
        return p;
    }
    Stencils rows() const
    {
        Stencils rows;
        for (uint32_t v = 0; v < mesh.vertexCount(); ++v) rows.add(v, 1), rows.endRow();
        for (const Ends& e : edges.ends) rows.add(e.a, 0.5), rows.add(e.b, 0.5), rows.endRow();
        for (size_t f = 0; f < mesh.faceCount(); ++f) {
            if (centre[f] == none) continue;
            for (const uint32_t v : mesh.face(f)) rows.add(v, 1.0 / double(mesh.face(f).size()));
            rows.endRow();
        }
        return rows;
    }
    Mesh pieces() const
    {
        Array<uint32_t> start{0u}, corner;
        const auto face = [&](std::initializer_list<uint32_t> vertices) {
            corner.insert(corner.end(), vertices);
            start.push_back(uint32_t(corner.size()));
        };
        for (size_t f = 0; f < mesh.faceCount(); ++f) {
            const uint32_t first = mesh.faceStart()[f], end = mesh.faceStart()[f + 1];
            for (uint32_t c = first; c < end; ++c) {
                const uint32_t v = mesh.cornerVertex()[c], before = middle(c == first ? end - 1 : c - 1);
                if (centre[f] == none)
                    face({v, middle(c), before});
                else
                    face({v, middle(c), centre[f], before});
            }
            if (centre[f] == none) face({middle(first), middle(first + 1), middle(first + 2)});
        }
        return Mesh(points(), std::move(start), std::move(corner));
    }
};

Mesh finer(const Split& split)
{
    const FaceCut cut = split.cut();
    Origins o;
    o.vertexRows = [&split] { return split.rows(); };
    o.corner = [cut](const Attribute& a) { return cutCorners(a, cut); };
    o.crease = [cut](const Attribute& a) { return cutCrease(a, cut, Creases::Kept); };
    o.faces = [cut] { return cutFaces(cut); };
    Mesh out = split.pieces().withGroupNames(split.mesh.groupNames());
    if (!split.mesh.lines().empty()) out = out.withLines(split.mesh.lines());
    return withAttributes(std::move(out), carried(split.mesh.attributes(), o));
}

}  // namespace

Generator splitDyadic(Mesh input, SplitDyadic parameters, Stage<Mesh>& stage)
{
    Mesh mesh = withoutTinyFaces(input);
    checkResultSize(double(FaceCut{mesh.faceStart(), mesh.faceCount(), 3, true}.newFaces()) * std::pow(4.0, double(parameters.levels - 1)),
                    "levels=" + std::to_string(parameters.levels));
    stage.show([&mesh] { return mesh; });
    const double share = 1.0 / double(parameters.levels);
    for (int64_t n = 1; n <= parameters.levels; ++n) {
        const double done = double(n - 1) * share;
        const Split split(mesh);
        for (uint32_t e = 0; stage.watched() && e < split.edges.size(); ++e)
            co_yield Step("edge")
                .edge(split.edges.ends[e].a, split.edges.ends[e].b, Role::Current)
                .vertex(split.edges.ends[e].a, Role::Current, "A")
                .vertex(split.edges.ends[e].b, Role::Current, "B")
                .point(split.middlePoint(e), Role::New, "m")
                .number("level", double(n))
                .number("points", double(e + 1))
                .progress(done + 0.5 * share * e / double(split.edges.size()));
        for (uint32_t f = 0; stage.watched() && f < mesh.faceCount(); ++f) {
            const size_t corners = mesh.face(f).size();
            Step step("face");
            std::move(step).face(f, Role::Current).ring(ElementKind::Vertex, Role::Neighbour, mesh.face(f));
            for (uint32_t c = mesh.faceStart()[f]; c < mesh.faceStart()[f + 1]; ++c)
                std::move(step).point(split.middlePoint(split.edges.half[c] >> 1), Role::New);
            if (corners != 3) std::move(step).point(split.centrePoint(f), Role::New, "c");
            std::move(step)
                .number("level", double(n))
                .number("corners", double(corners))
                .number("pieces", corners == 3 ? 4 : double(corners))
                .progress(done + share * (0.5 + 0.4 * f / double(mesh.faceCount())));
            co_yield step;
        }
        if (!stage.watched()) co_yield Step("edge").number("level", double(n)).progress(done);
        Mesh next = finer(split);
        mesh = std::move(next);
        co_yield Step("split")
            .number("level", double(n))
            .number("vertices", double(mesh.vertexCount()))
            .number("faces", double(mesh.faceCount()))
            .progress(double(n) * share);
    }
    stage.finish(std::move(mesh));
}

}  // namespace mw
