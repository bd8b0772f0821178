// See record_tables.h.
#include "ui/panels/record_tables.h"

#include <QCoreApplication>
#include <QStringList>

#include "core/mesh/select.h"
#include "core/mesh/triangle_adjacency.h"
#include "core/steps/stage.h"
#include "ui/look.h"

namespace mw {

namespace {

using To = RecordLink::To;

QString tr(const char* text)
{
    return QCoreApplication::translate("Records", text);
}

// "a" of figure 2.9 beside the name of the field.
std::vector<RecordCell> cellsOf(const Record& record, const QString& owner = {})
{
    std::vector<RecordCell> cells;
    for (const Record::Field& f : record.fields) {
        QString name = owner + QString::fromStdString(f.name);
        if (!f.label.empty()) name += QString(" ") + QString::fromStdString(f.label);
        cells.push_back({name, f.link});
    }
    return cells;
}

// The book's face-based record is a column of vertices beside one of faces.
std::vector<RecordCell> sideBySide(const std::vector<RecordCell>& cells)
{
    std::vector<RecordCell> out;
    for (size_t i = 0; i < cells.size() / 2; ++i) out.push_back(cells[i]), out.push_back(cells[cells.size() / 2 + i]);
    return out;
}

void append(std::vector<RecordCell>& cells, std::vector<RecordCell> more)
{
    cells.insert(cells.end(), more.begin(), more.end());
}

// The vertex and the face table name one edge or half-edge each: the ways in.
std::vector<RecordCell> entriesOf(const RecordPlace& place, const Record& vertex, const Record& face)
{
    std::vector<RecordCell> cells;
    if (place.vertex != none) append(cells, cellsOf(vertex, handleOf(vertex.of) + "."));
    if (place.face != none) append(cells, cellsOf(face, handleOf(face.of) + "."));
    return cells;
}

RecordTable primitiveTable(const RecordMesh& m, const RecordPlace& place)
{
    RecordTable t{"primitive", tr("Triangle adjacency"), {}};
    const auto six = adjacencyOf(m.walk, m.mesh, place.face);
    if (!six) return t;
    t.title += "  " + handleOf({To::Face, place.face});
    for (size_t k = 0; k < 6; ++k) {
        const bool missing = k % 2 == 1 && (*six)[k] == (*six)[k - 1];
        t.cells.push_back({QString("V%1").arg(k), {To::Vertex, (*six)[k]}, {}});
        if (missing) t.cells.back().missing = tr("none");
    }
    return t;
}

}  // namespace

QString handleOf(RecordLink link)
{
    static constexpr const char* letters[] = {"", "v", "e", "f", "h"};
    if (link.to == To::Nothing) return tr("none");
    return letters[size_t(link.to)] + QString::number(link.index);
}

QString wordsOf(const RecordMesh& m, RecordLink link)
{
    const auto ends = [&](uint32_t h) { return QString("%1 to %2").arg(m.walk.source(h)).arg(m.walk.target(h)); };
    switch (link.to) {
        case To::Nothing:
            return tr("None: the mesh ends here");
        case To::Vertex:
            return tr("Vertex %1").arg(link.index);
        case To::Face:
            return tr("Face %1").arg(link.index);
        case To::Edge:
            return tr("Edge %1, vertex %2").arg(QString::number(link.index), ends(2 * link.index));
        case To::Halfedge:
            return tr("Half-edge %1, vertex %2").arg(QString::number(link.index), ends(link.index));
    }
    return {};
}

ElementSet elementsOf(const RecordMesh& m, RecordLink link)
{
    switch (link.to) {
        case To::Nothing:
            return {};
        case To::Vertex:
            return {ElementKind::Vertex, {link.index}};
        case To::Face:
            return {ElementKind::Face, {link.index}};
        case To::Edge:
        case To::Halfedge:
            break;
    }
    const uint32_t h = link.to == To::Edge ? 2 * link.index : link.index;
    return sorted({ElementKind::Edge, {m.walk.source(h), m.walk.target(h)}});
}

RecordLink linkOf(const RecordMesh& m, const ElementSet& elements)
{
    const auto& i = elements.indices;
    if (i.empty()) return {};
    if (elements.kind == ElementKind::Vertex) return i[0] < m.mesh.vertexCount() ? RecordLink{To::Vertex, i[0]} : RecordLink();
    if (elements.kind == ElementKind::Face) return i[0] < m.mesh.faceCount() ? RecordLink{To::Face, i[0]} : RecordLink();
    if (elements.kind != ElementKind::Edge || i.size() < 2 || std::max(i[0], i[1]) >= m.mesh.vertexCount()) return {};
    const RecordPlace place = placeOfEdge(m.walk, i[0], i[1]);
    return place.halfedge == none ? RecordLink() : RecordLink{To::Halfedge, place.halfedge};
}

std::vector<RecordTable> recordTables(const RecordMesh& m, const RecordPlace& place)
{
    std::vector<RecordTable> tables;
    if (place.halfedge != none) {
        const Record half = halfedgeRecord(m.walk, place.halfedge), winged = wingedEdgeRecord(m.walk, m.walk.ofEdge(place.halfedge));
        const RecordLink v{To::Vertex, place.vertex}, f{To::Face, place.face};
        const auto title = [&](const QString& name, const Record& r) { return name + "  " + handleOf(r.of); };
        RecordTable h{"halfedge", title(tr("Half-edge"), half), cellsOf(half)};
        if (h.cells.size() % 2) h.cells.push_back({});
        append(h.cells, entriesOf(place, halfedgeVertexRecord(m.walk, v.index), f.index == none ? Record() : halfedgeFaceRecord(m.walk, f.index)));
        tables.push_back(std::move(h));
        RecordTable w{"winged-edge", title(tr("Winged-edge"), winged), cellsOf(winged)};
        append(w.cells, entriesOf(place, wingedVertexRecord(m.walk, v.index), f.index == none ? Record() : wingedFaceRecord(m.walk, f.index)));
        tables.push_back(std::move(w));
    }
    if (place.face == none) return tables;
    const Record face = faceRecord(m.walk, m.mesh, place.face);
    tables.push_back({"face-based", tr("Face-based") + "  " + handleOf(face.of), sideBySide(cellsOf(face))});
    if (RecordTable t = primitiveTable(m, place); !t.cells.empty()) tables.push_back(std::move(t));
    return tables;
}

RecordLink askedAt(const RecordPlace& place, Adjacency::Query query)
{
    switch (askedKind(query)) {
        case ElementKind::Vertex:
            return place.vertex == none ? RecordLink() : RecordLink{To::Vertex, place.vertex};
        case ElementKind::Face:
            return place.face == none ? RecordLink() : RecordLink{To::Face, place.face};
        default:
            return place.halfedge == none ? RecordLink() : RecordLink{To::Edge, place.halfedge / 2};
    }
}

ElementSet answerOf(const RecordMesh& m, RecordLink asked, Adjacency::Query query)
{
    if (asked.to == To::Nothing) return {foundKind(query), {}};
    Adjacency parameters;
    parameters.query = query;
    parameters.element = elementText(elementsOf(m, asked));
    RunOf<ElementSet> run(false, [&](Stage<ElementSet>& stage) { return adjacency(m.mesh, parameters, stage); });
    while (run.advance()) continue;
    return std::any_cast<ElementSet>(run.snapshot().value);
}

QString handlesOf(const RecordMesh& m, const ElementSet& elements, size_t most)
{
    QStringList words;
    const size_t n = countOf(elements);
    for (size_t i = 0; i < std::min(n, most); ++i) {
        if (elements.kind != ElementKind::Edge) {
            words << handleOf({elements.kind == ElementKind::Vertex ? To::Vertex : To::Face, elements.indices[i]});
            continue;
        }
        const RecordPlace p = placeOfEdge(m.walk, elements.indices[2 * i], elements.indices[2 * i + 1]);
        words << (p.halfedge == none ? QString("v%1\u2013v%2").arg(elements.indices[2 * i]).arg(elements.indices[2 * i + 1])
                                     : handleOf({To::Edge, p.halfedge / 2}));
    }
    QString text = words.join(", ");
    if (n > most) text += tr(" and %1 more").arg(look::count(n - most));
    return text;
}

}  // namespace mw
