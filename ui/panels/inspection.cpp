// See inspection.h.
#include "ui/panels/inspection.h"

#include <QCoreApplication>
#include <algorithm>
#include <cstring>
#include <numeric>
#include <tuple>

#include "core/catalog/catalog.h"
#include "core/mesh/rings.h"
#include "ui/panels/look.h"

namespace mw {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("Inspection", text);
}

using Edge = TopologyReport::Edge;

ElementSet edgeSet(std::vector<Edge> edges)
{
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    ElementSet s{ElementKind::Edge, {}};
    s.indices.reserve(2 * edges.size());
    for (const Edge& e : edges) s.indices.push_back(e.first), s.indices.push_back(e.second);
    return s;
}

ElementSet elementSet(ElementKind kind, std::vector<uint32_t> indices)
{
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return {kind, std::move(indices)};
}

QString edgeName(Edge e)
{
    return tr("Edge %1 – %2").arg(look::count(e.first), look::count(e.second));
}

bool degenerate(std::span<const uint32_t> face)
{
    if (face.size() < 3) return true;
    std::vector<uint32_t> v(face.begin(), face.end());
    std::sort(v.begin(), v.end());
    return std::adjacent_find(v.begin(), v.end()) != v.end();
}

// Edges of one face only. Needed where a boundary is no simple loop and its vertices alone do not say which edges it has.
std::vector<Edge> boundaryEdgesOf(const Mesh& mesh)
{
    std::vector<Edge> edges;
    edges.reserve(mesh.cornerCount());
    for (size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto face = mesh.face(f);
        if (degenerate(face)) continue;
        for (size_t i = 0; i < face.size(); ++i) edges.push_back(std::minmax(face[i], face[(i + 1) % face.size()]));
    }
    std::sort(edges.begin(), edges.end());
    std::vector<Edge> once;
    for (size_t i = 0; i < edges.size();) {
        size_t j = i + 1;
        while (j < edges.size() && edges[j] == edges[i]) ++j;
        if (j == i + 1) once.push_back(edges[i]);
        i = j;
    }
    return once;
}

std::vector<std::vector<Edge>> loopEdges(const Mesh& mesh, const TopologyReport& r)
{
    std::vector<std::vector<Edge>> loops(r.boundaryLoops.size());
    size_t around = 0;
    for (const auto& l : r.boundaryLoops) around += l.size();
    if (around == r.boundaryEdges) {
        for (size_t i = 0; i < loops.size(); ++i)
            for (size_t k = 0; k < r.boundaryLoops[i].size(); ++k)
                loops[i].push_back(std::minmax(r.boundaryLoops[i][k], r.boundaryLoops[i][(k + 1) % r.boundaryLoops[i].size()]));
        return loops;
    }
    std::vector<uint32_t> loopOf(mesh.vertexCount(), none);
    for (size_t i = 0; i < loops.size(); ++i)
        for (uint32_t v : r.boundaryLoops[i]) loopOf[v] = uint32_t(i);
    for (const Edge& e : boundaryEdgesOf(mesh))
        if (loopOf[e.first] != none) loops[loopOf[e.first]].push_back(e);
    return loops;
}

Finding holes(const Mesh& mesh, const TopologyReport& r)
{
    Finding f{"holes", tr("Holes"), {}, tr("Every edge has two faces."), {}, {}, r.boundaryLoops.size(), "fill-holes", tr("Fill")};
    if (f.passed()) {
        f.title = tr("Closed surface"), f.figure = tr("0 loops");
        return f;
    }
    std::vector<std::vector<Edge>> loops = loopEdges(mesh, r);
    std::stable_sort(loops.begin(), loops.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
    f.figure = look::counted(loops.size(), tr("loop"), tr("loops")) + ", " + look::counted(r.boundaryEdges, tr("edge"), tr("edges"));
    std::vector<Edge> all;
    for (size_t i = 0; i < loops.size(); ++i) {
        all.insert(all.end(), loops[i].begin(), loops[i].end());
        if (i >= Inspection::maxOffenders) continue;
        f.offenders.push_back({tr("Loop %1").arg(look::count(i + 1)), look::counted(loops[i].size(), tr("edge"), tr("edges")), edgeSet(loops[i])});
    }
    f.all = edgeSet(std::move(all));
    return f;
}

Finding ofEdges(const char* id, const QString& title, const QString& checked, const std::vector<Edge>& edges, const char* repair, const QString& text)
{
    Finding f{id, title, look::counted(edges.size(), tr("edge"), tr("edges")), checked, edgeSet(edges), {}, edges.size(), repair, text};
    for (size_t i = 0; i < std::min(edges.size(), Inspection::maxOffenders); ++i)
        f.offenders.push_back({edgeName(edges[i]), {}, edgeSet({edges[i]})});
    return f;
}

struct Words {
    const char* id;
    QString title, checked, one, many, name;  // name: "Face %1"
    const char* repair;
    QString repairText;
};

Finding ofElements(ElementKind kind, const Words& w, const std::vector<uint32_t>& elements)
{
    Finding f{w.id,     w.title,     look::counted(elements.size(), w.one, w.many), w.checked, elementSet(kind, elements), {}, elements.size(),
              w.repair, w.repairText};
    for (size_t i = 0; i < std::min(elements.size(), Inspection::maxOffenders); ++i)
        f.offenders.push_back({w.name.arg(look::count(elements[i])), {}, elementSet(kind, {elements[i]})});
    return f;
}

// Vertices at exactly the same place, by place.
Finding coincident(const Mesh& mesh)
{
    const auto& p = mesh.positions();
    std::vector<uint32_t> order(mesh.vertexCount());
    std::iota(order.begin(), order.end(), 0u);
    auto key = [&](uint32_t v) { return std::tuple(p[v].x, p[v].y, p[v].z, v); };
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
    Finding f{"coincident", tr("Coincident vertices"), {}, tr("No two vertices are at the same place."), {}, {}, 0, "weld", tr("Weld")};
    std::vector<uint32_t> all;
    std::vector<std::vector<uint32_t>> groups;
    for (size_t i = 0; i < order.size();) {
        size_t j = i + 1;
        while (j < order.size() && p[order[j]] == p[order[i]]) ++j;
        if (j > i + 1) {
            all.insert(all.end(), order.begin() + long(i), order.begin() + long(j));
            f.total += j - i - 1;
            if (groups.size() < Inspection::maxOffenders) groups.emplace_back(order.begin() + long(i), order.begin() + long(j));
        }
        i = j;
    }
    std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
    for (auto& g : groups)
        f.offenders.push_back({tr("At vertex %1").arg(look::count(g.front())), look::counted(g.size(), tr("vertex"), tr("vertices")),
                               elementSet(ElementKind::Vertex, g)});
    f.figure = look::count(f.total);  // how many welding would take away
    f.all = elementSet(ElementKind::Vertex, std::move(all));
    return f;
}

std::vector<Finding> findingsOf(const Mesh& mesh, const TopologyReport& r)
{
    std::vector<Finding> all;
    all.push_back(ofEdges("nonmanifold-edges", tr("Non-manifold edges"), tr("No edge has more than two faces."), r.nonmanifoldEdges,
                          "split-nonmanifold", tr("Split")));
    all.push_back(ofElements(ElementKind::Vertex,
                             {"nonmanifold-vertices", tr("Non-manifold vertices"), tr("The faces at each vertex are one fan."), tr("vertex"),
                              tr("vertices"), tr("Vertex %1"), "split-nonmanifold", tr("Split")},
                             r.nonmanifoldVertices));
    all.push_back(ofEdges("orientation", tr("Inconsistent orientation"), tr("Neighbouring faces turn the same way."), r.inconsistentEdges, "orient",
                          tr("Orient")));
    all.push_back(ofElements(ElementKind::Face,
                             {"degenerate-faces", tr("Degenerate faces"), tr("Every face has three different vertices."), tr("face"), tr("faces"),
                              tr("Face %1"), "remove-degenerate", tr("Delete")},
                             r.degenerateFaces));
    all.push_back(ofElements(ElementKind::Face,
                             {"duplicate-faces", tr("Duplicate faces"), tr("No two faces have the same vertices."), tr("face"), tr("faces"),
                              tr("Face %1"), "remove-duplicate-faces", tr("Delete")},
                             r.duplicateFaces));
    all.push_back(holes(mesh, r));
    all.push_back(coincident(mesh));
    all.push_back(ofElements(ElementKind::Vertex,
                             {"isolated", tr("Isolated vertices"), tr("Every vertex belongs to a face."), tr("vertex"), tr("vertices"),
                              tr("Vertex %1"), "delete-isolated", tr("Delete")},
                             r.isolatedVertices));
    for (Finding& f : all)
        if (!findOperation(f.repair)) f.repair.clear();
    std::stable_partition(all.begin(), all.end(), [](const Finding& f) { return !f.passed(); });
    return all;
}

}  // namespace

size_t Inspection::toFix() const
{
    return size_t(std::count_if(findings.begin(), findings.end(), [](const Finding& f) { return !f.passed(); }));
}

Inspection inspect(const Mesh& mesh)
{
    const TopologyReport& r = mesh.topology();
    Inspection i;
    i.mesh = mesh;
    i.isolated = r.isolatedVertices.size();
    i.vertices = r.vertices - i.isolated;
    i.edges = r.edges, i.faces = r.faces, i.components = r.components;
    i.euler = r.euler, i.genus = r.genus;
    i.valences = r.vertexValences;
    i.regular = i.vertices ? double(r.regularVertices) / double(i.vertices) : 0;
    i.findings = findingsOf(mesh, r);
    return i;
}

Bounds boundsOf(const Mesh& mesh, const ElementSet& elements)
{
    Bounds b;
    const auto& p = mesh.positions();
    for (uint32_t i : elements.indices) {
        if (elements.kind == ElementKind::Face) {
            if (i < mesh.faceCount())
                for (uint32_t v : mesh.face(i)) b.add(glm::dvec3(p[v]));
        } else if (i < p.size())
            b.add(glm::dvec3(p[i]));
    }
    return b;
}

ElementSet verticesOfValence(const Mesh& mesh, size_t valence, bool orMore)
{
    ElementSet s{ElementKind::Vertex, {}};
    const Rings& rings = mesh.rings();
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
        const size_t n = rings.neighboursOf(v).size();
        if (n > 0 && (orMore ? n >= valence : n == valence)) s.indices.push_back(v);
    }
    return s;
}

}  // namespace mw
