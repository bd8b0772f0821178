#include "core/morph/morph_mesh.h"

#include <algorithm>

#include "core/morph/target.h"

namespace mw {

namespace {

/// Adds w of an element of the prepared mesh, which may itself lie between two of the source.
void addMix(Stencils& rows, const MorphMesh::Mix& m, double w)
{
    if (w == 0) return;
    if (m.t < 1) rows.add(m.a, w * (1 - m.t));
    if (m.t > 0) rows.add(m.b, w * m.t);
}

Stencils vertexRows(const Overlay& o, int in, const MorphMesh& first)
{
    Stencils rows;
    const DomainMesh& map = o.input(in).map;
    for (uint32_t v = 0; v < o.vertices(); ++v) {
        const OverlayPlace& p = o.place(in, v);
        if (p.at.kind == Location::Kind::Vertex) {
            addMix(rows, first.vertexOf[p.at.index], 1);
        } else if (p.at.kind == Location::Kind::Edge) {
            addMix(rows, first.vertexOf[map.from(p.at.index)], p.weights.x);
            addMix(rows, first.vertexOf[map.to(p.at.index)], p.weights.y);
        } else {
            for (uint32_t k = 0; k < 3; ++k) addMix(rows, first.vertexOf[map.from(3 * p.at.index + k)], p.weights[int(k)]);
        }
        rows.endRow();
    }
    return rows;
}

Stencils cornerRows(const Overlay& o, int in, const MorphMesh& mesh)
{
    Stencils rows;
    for (size_t c = 0; c < o.corners().size(); ++c) {
        const uint32_t f = o.triangleOf(in, c / 3);
        const glm::dvec3 w = o.weightsIn(in, f, o.corners()[c]);
        for (uint32_t k = 0; k < 3; ++k) addMix(rows, mesh.cornerOf[3 * f + k], w[int(k)]);
        rows.endRow();
    }
    return rows;
}

/// Sharpness stays on what is left of the edges; new ones are smooth.
Attribute carriedCrease(const Attribute& crease, const Overlay& o, const MorphMesh& first)
{
    Array<float> out(o.corners().size(), 0.f);
    const DomainMesh& map = o.input(0).map;
    const Shared<uint32_t>& start = first.source.faceStart();
    for (size_t c = 0; c < out.size(); ++c) {
        const uint32_t e = o.edgeAlong(0, c), f = o.triangleOf(0, c / 3);
        for (uint32_t h = 3 * f; e != none && h < 3 * f + 3; ++h) {
            if (map.edge(h) != e) continue;
            // A side of the face, not one that cutting it into triangles has made.
            const MorphMesh::Mix &at = first.cornerOf[h], &to = first.cornerOf[DomainMesh::next(h)];
            const uint32_t face = first.faceOf[f], after = at.a + 1 == start[face + 1] ? start[face] : at.a + 1;
            if ((to.t > 0 ? to.b : to.a) == after) out[c] = float(crease.at(at.a, 0));
        }
    }
    return floatAttribute(crease.name, Domain::Corner, 1, std::move(out));
}

Mesh withAttributes(Mesh out, const Overlay& o, const MorphMesh& first)
{
    const std::vector<Attribute>& attributes = first.source.attributes();
    const auto has = [&](Domain d) { return std::any_of(attributes.begin(), attributes.end(), [d](const Attribute& a) { return a.domain == d; }); };
    const Stencils vertices = has(Domain::Vertex) ? vertexRows(o, 0, first) : Stencils();
    const Stencils corners = has(Domain::Corner) ? cornerRows(o, 0, first) : Stencils();
    std::vector<uint32_t> faces;
    for (size_t f = 0; has(Domain::Face) && f < out.faceCount(); ++f) faces.push_back(first.faceOf[o.triangleOf(0, f)]);
    const Attribute *joints = first.source.find(names::joints, Domain::Vertex), *skin = first.source.find(names::weights, Domain::Vertex);
    for (const Attribute& a : attributes) {
        if (a.domain == Domain::Face)
            out = out.with(gathered(a, faces));
        else if (a.domain == Domain::Corner)
            out = out.with(a.name == names::crease ? carriedCrease(a, o, first) : blended(a, corners));
        else if (!(joints && skin && (&a == joints || &a == skin)))
            out = out.with(blended(a, vertices));
    }
    if (joints && skin) {
        SkinWeights mixed = blendedSkin(*joints, *skin, vertices);
        out = out.with(std::move(mixed.joints)).with(std::move(mixed.weights));
    }
    return out.withGroupNames(first.source.groupNames());
}

}  // namespace

MorphMesh MorphMesh::of(const Mesh& mesh)
{
    MorphMesh out;
    out.source = mesh;
    const Mesh::Triangulation& t = mesh.triangulation();
    std::vector<uint32_t> place(mesh.vertexCount(), none);
    for (size_t f = 0; f < t.faces.size(); ++f) {
        const uint32_t *v = t.vertices.data() + 3 * f, *c = t.corners.data() + 3 * f;
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
        for (int k = 0; k < 3; ++k) {
            place[v[k]] = 0;
            out.corners.push_back(v[k]);
            out.cornerOf.push_back({c[k], none, 0});
        }
        out.faceOf.push_back(t.faces[f]);
    }
    for (uint32_t v = 0; v < place.size(); ++v) {
        if (place[v] == none) continue;
        place[v] = uint32_t(out.positions.size());
        out.positions.push_back(glm::dvec3(mesh.positions()[v]));
        out.vertexOf.push_back({v, none, 0});
    }
    for (uint32_t& v : out.corners) v = place[v];
    return out;
}

Mesh MorphMesh::mesh() const
{
    Array<glm::vec3> places(positions.size());
    std::transform(positions.begin(), positions.end(), places.begin(), [](const glm::dvec3& p) { return glm::vec3(p); });
    return Mesh::triangles(std::move(places), Array<uint32_t>(corners.begin(), corners.end()));
}

Attribute carriedVertexAttribute(const Overlay& overlay, int in, const MorphMesh& mesh, std::string_view name)
{
    return blended(*mesh.source.find(name, Domain::Vertex), vertexRows(overlay, in, mesh));
}

Mesh overlaid(const Overlay& overlay, const MorphMesh& first)
{
    Array<glm::vec3> places(overlay.vertices());
    for (uint32_t v = 0; v < overlay.vertices(); ++v) places[v] = glm::vec3(overlay.position(0, v));
    Mesh out = Mesh::triangles(std::move(places), Array<uint32_t>(overlay.corners().begin(), overlay.corners().end()));
    return withAttributes(std::move(out), overlay, first);
}

Array<float> displacement(const Overlay& overlay)
{
    Array<float> out(3 * overlay.vertices());
    for (uint32_t v = 0; v < overlay.vertices(); ++v) {
        const glm::dvec3 d = overlay.position(1, v) - glm::dvec3(glm::vec3(overlay.position(0, v)));
        for (int k = 0; k < 3; ++k) out[3 * v + uint32_t(k)] = float(d[k]);
    }
    return out;
}

std::optional<Attribute> colorOn(const Overlay& overlay, int in, const MorphMesh& mesh)
{
    const Attribute* color = colorOf(mesh.source);
    if (!color) return {};
    return blended(*color, color->domain == Domain::Corner ? cornerRows(overlay, in, mesh) : vertexRows(overlay, in, mesh));
}

Mesh morphed(const Overlay& overlay, const MorphMesh& first, const std::string& name)
{
    return withTarget(overlaid(overlay, first), name, displacement(overlay));
}

}  // namespace mw
