// See inspection.h.
#include "ui/panels/inspection.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/catalog/catalog.h"
#include "core/mesh/rings.h"
#include "core/mesh/select.h"
#include "ui/look.h"

namespace mw {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("Inspection", text);
}

QString text(const std::string& s)
{
    return QString::fromStdString(s);
}

QString counted(ElementKind kind, size_t n)
{
    switch (kind) {
        case ElementKind::Vertex:
            return look::counted(n, tr("vertex"), tr("vertices"));
        case ElementKind::Edge:
            return look::counted(n, tr("edge"), tr("edges"));
        default:
            return look::counted(n, tr("face"), tr("faces"));
    }
}

/// What several elements together are called, in this check; empty where an offender is one element.
struct Group {
    QString one, many, name;
};

Group groupOf(const std::string& id)
{
    if (id == "holes") return {tr("loop"), tr("loops"), tr("Loop %1")};
    if (id == "tiny-components") return {tr("piece"), tr("pieces"), tr("Piece %1")};
    if (id == "coincident-vertices") return {tr("place"), tr("places"), tr("Place %1")};
    if (id == "self-intersections") return {tr("group"), tr("groups"), tr("Group %1")};
    return {};
}

QString repairText(const std::string& id)
{
    if (id == "holes") return tr("Fill");
    if (id == "orientation") return tr("Orient");
    if (id == "coincident-vertices") return tr("Weld");
    if (id.starts_with("nonmanifold")) return tr("Split");
    return tr("Delete");
}

Offender offenderOf(const Group& group, size_t number, const ElementSet& e)
{
    if (!group.name.isEmpty()) return {group.name.arg(look::count(number + 1)), counted(e.kind, countOf(e)), e};
    const auto& i = e.indices;
    if (e.kind == ElementKind::Edge && i.size() == 2) return {tr("Edge %1 \u2013 %2").arg(look::count(i[0]), look::count(i[1])), {}, e};
    if (i.size() == 1) return {(e.kind == ElementKind::Vertex ? tr("Vertex %1") : tr("Face %1")).arg(look::count(i[0])), {}, e};
    return {tr("Group %1").arg(look::count(number + 1)), counted(e.kind, countOf(e)), e};
}

Finding findingOf(const Defect& d)
{
    Finding f;
    f.id = text(d.id), f.title = text(d.title), f.explanation = text(d.explanation), f.checked = text(d.checked);
    f.total = d.offenders.size();
    const Group group = groupOf(d.id);
    f.all.kind = d.offenders.empty() ? ElementKind::Vertex : d.offenders[0].kind;
    for (size_t i = 0; i < d.offenders.size(); ++i) {
        const auto& indices = d.offenders[i].indices;
        f.all.indices.insert(f.all.indices.end(), indices.begin(), indices.end());
        if (i < Inspection::maxOffenders) f.offenders.push_back(offenderOf(group, i, d.offenders[i]));
    }
    f.all = sorted(std::move(f.all));
    f.inFull = counted(f.all.kind, countOf(f.all));
    f.figure = look::count(countOf(f.all));  // short, so that the title beside it is not cut
    if (!group.one.isEmpty()) {
        f.figure = look::counted(f.total, group.one, group.many);
        f.inFull = f.figure + ", " + f.inFull;
    }
    if (const Operation* op = findOperation(d.repair)) {
        f.repair = d.repair;
        f.repairValues = parsed(op->parameters, d.repairParameters);
        f.repairText = repairText(d.id);
    }
    return f;
}

Finding unmeasuredIntersections()
{
    Finding f;
    f.id = "self-intersections", f.title = tr("Self-intersections"), f.figure = tr("not yet");
    f.explanation = tr("The mesh has over %1 faces: looking for faces that pass through each other takes a while.")
                        .arg(look::count(Inspection::intersectionFaces));
    f.measured = false;
    return f;
}

}  // namespace

size_t Inspection::toFix() const
{
    return size_t(std::count_if(findings.begin(), findings.end(), [](const Finding& f) { return f.toFix(); }));
}

size_t Inspection::passed() const
{
    return size_t(std::count_if(findings.begin(), findings.end(), [](const Finding& f) { return f.passed(); }));
}

std::vector<Mending> Inspection::mendings() const
{
    std::vector<Mending> all;
    for (const Finding& f : findings) {
        if (!f.toFix() || f.repair.empty()) continue;
        auto m = std::find_if(all.begin(), all.end(), [&](const Mending& o) { return o.operation == f.repair; });
        if (m == all.end()) m = all.insert(all.end(), Mending{f.repair, {}, {}});
        for (const auto& [name, value] : f.repairValues) m->values[name] = value;
        m->findings += (m->findings.isEmpty() ? "" : ", ") + (m->findings.isEmpty() ? f.title : f.title.toLower());
    }
    return all;
}

Inspection inspect(const Mesh& mesh, bool everything, Progress* progress)
{
    Inspection i;
    i.mesh = mesh;
    DefectOptions options;
    options.selfIntersections = everything || mesh.faceCount() < Inspection::intersectionFaces;
    const std::vector<Defect> defects = defectsOf(mesh, options, progress);
    const TopologyReport& r = mesh.topology();
    i.isolated = r.isolatedVertices.size();
    i.vertices = r.vertices - i.isolated;
    i.edges = r.edges, i.faces = r.faces, i.components = r.components;
    i.euler = r.euler, i.genus = r.genus;
    i.valences = r.vertexValences;
    i.faceSizes = r.faceSizes;
    i.regular = i.vertices ? double(r.regularVertices) / double(i.vertices) : 0;
    for (const Defect& d : defects) i.findings.push_back(findingOf(d));
    if (!options.selfIntersections) i.findings.push_back(unmeasuredIntersections());
    const auto rank = [](const Finding& f) { return f.toFix() ? 0 : f.measured ? 2 : 1; };
    std::stable_sort(i.findings.begin(), i.findings.end(), [&](const Finding& a, const Finding& b) { return rank(a) < rank(b); });
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

ElementSet facesOfSize(const Mesh& mesh, size_t corners, bool orMore)
{
    ElementSet s{ElementKind::Face, {}};
    for (uint32_t f = 0; f < mesh.faceCount(); ++f)
        if (const size_t n = mesh.face(f).size(); orMore ? n >= corners : n == corners) s.indices.push_back(f);
    return s;
}

}  // namespace mw
