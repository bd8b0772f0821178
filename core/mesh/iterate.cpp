// Iterators: all vertices, faces, edges or half-edges in order.
#include "core/mesh/iterate.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/mesh/halfedge_walk.h"
#include "core/mesh/normals.h"

namespace mw {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

// Columns and numbers of a step, by what is gone through.
constexpr const char* vertexNames[] = {"valence", "x", "y", "z"};
constexpr const char* faceNames[] = {"size", "half-edge"};
constexpr const char* edgeNames[] = {"dihedral", "length", "x", "y", "z"};
constexpr const char* halfedgeNames[] = {"from", "to", "face", "next", "prev", "pair"};

/// The table and how it is filled, a row an element.
class Iteration {
public:
    Iteration(const Mesh& mesh, Iterate::Elements elements);

    size_t size() const { return size_; }
    void visit(uint32_t i);
    Step step(uint32_t i) const;
    Table table(size_t rows) const;

private:
    void begin(ElementKind rows, size_t size, std::span<const char* const> names);
    void visitVertex(uint32_t v);
    void visitFace(uint32_t f);
    void visitEdge(uint32_t e);
    void visitHalfedge(uint32_t h);
    double dihedral(uint32_t h) const;
    glm::dvec3 at(uint32_t v) const { return glm::dvec3(mesh_.positions()[v]); }

    Mesh mesh_;
    HalfedgeWalk walk_;
    Iterate::Elements elements_;
    size_t size_ = 0;
    std::span<const char* const> names_;
    Table table_;
    std::vector<uint32_t> neighbours_;
};

Iteration::Iteration(const Mesh& mesh, Iterate::Elements elements) : mesh_(mesh), walk_(mesh), elements_(elements)
{
    switch (elements) {
        case Iterate::Elements::Vertices:
            begin(ElementKind::Vertex, mesh.vertexCount(), vertexNames);
            break;
        case Iterate::Elements::Faces:
            begin(ElementKind::Face, mesh.faceCount(), faceNames);
            break;
        case Iterate::Elements::Edges:
            begin(ElementKind::Edge, walk_.size() / 2, edgeNames);
            table_.columns[0].unit = "°";
            for (uint32_t h = 0; h < walk_.size(); h += 2)
                for (const uint32_t v : {std::min(walk_.source(h), walk_.target(h)), std::max(walk_.source(h), walk_.target(h))})
                    table_.edges.push_back(v);
            break;
        case Iterate::Elements::Halfedges:
            begin(ElementKind::Object, walk_.size(), halfedgeNames);
            break;
    }
}

void Iteration::begin(ElementKind rows, size_t size, std::span<const char* const> names)
{
    table_.rows = rows;
    size_ = size;
    names_ = names;
    for (const char* name : names) table_.columns.push_back({name, "", Array<double>(size, undefined), false});
}

void Iteration::visit(uint32_t i)
{
    switch (elements_) {
        case Iterate::Elements::Vertices:
            return visitVertex(i);
        case Iterate::Elements::Faces:
            return visitFace(i);
        case Iterate::Elements::Edges:
            return visitEdge(i);
        case Iterate::Elements::Halfedges:
            return visitHalfedge(i);
    }
}

void Iteration::visitVertex(uint32_t v)
{
    neighbours_.clear();
    for (const uint32_t first : walk_.fans(v)) {
        uint32_t h = first;
        do {
            neighbours_.push_back(walk_.target(h));
            h = walk_.next(walk_.pair(h));
        } while (h != first);
    }
    std::sort(neighbours_.begin(), neighbours_.end());  // an edge of several faces counts once
    table_.columns[0].values[v] = double(std::unique(neighbours_.begin(), neighbours_.end()) - neighbours_.begin());
    for (int k = 0; k < 3; ++k) table_.columns[size_t(k) + 1].values[v] = mesh_.positions()[v][k];
}

void Iteration::visitFace(uint32_t f)
{
    const uint32_t h = walk_.ofFace(f);
    table_.columns[0].values[f] = double(mesh_.face(f).size());
    if (h != none) table_.columns[1].values[f] = h;
}

double Iteration::dihedral(uint32_t h) const
{
    const uint32_t f = walk_.face(h), g = walk_.face(walk_.pair(h));
    if (f == none || g == none) return undefined;
    const glm::dvec3 a = areaVector(mesh_, f), b = areaVector(mesh_, g), along = at(walk_.target(h)) - at(walk_.source(h));
    const double length = glm::length(along);
    if (!(glm::length(a) > 0) || !(glm::length(b) > 0) || !(length > 0)) return undefined;
    return std::atan2(glm::dot(glm::cross(a, b), along) / length, glm::dot(a, b)) * 180 / M_PI;
}

void Iteration::visitEdge(uint32_t e)
{
    const uint32_t a = walk_.source(2 * e), b = walk_.target(2 * e);
    table_.columns[0].values[e] = dihedral(2 * e);
    table_.columns[1].values[e] = glm::distance(at(a), at(b));
    for (int k = 0; k < 3; ++k) table_.columns[size_t(k) + 2].values[e] = 0.5 * (at(a)[k] + at(b)[k]);
}

void Iteration::visitHalfedge(uint32_t h)
{
    const uint32_t f = walk_.face(h);
    const double row[] = {double(walk_.source(h)), double(walk_.target(h)), f == none ? undefined : double(f),
                          double(walk_.next(h)),   double(walk_.prev(h)),   double(walk_.pair(h))};
    for (size_t k = 0; k < 6; ++k) table_.columns[k].values[h] = row[k];
}

Step Iteration::step(uint32_t i) const
{
    static constexpr const char* phases[] = {"vertex", "face", "edge", "half-edge"};
    Step s = Step(phases[size_t(elements_)]).number("index", i).progress(double(i + 1) / double(size_));
    for (size_t k = 0; k < names_.size(); ++k) s = std::move(s).number(names_[k], table_.columns[k].values[i]);
    switch (elements_) {
        case Iterate::Elements::Vertices:
            return std::move(s).vertex(i, Role::Current, "v");
        case Iterate::Elements::Faces:
            return std::move(s).face(i, Role::Current, "f");
        case Iterate::Elements::Edges:
            return std::move(s).edge(walk_.source(2 * i), walk_.target(2 * i), Role::Current, "e");
        case Iterate::Elements::Halfedges:
            break;
    }
    s = std::move(s).edge(walk_.source(i), walk_.target(i), Role::Current, "h").vertex(walk_.target(i), Role::Neighbour, "v");
    return walk_.face(i) == none ? s : std::move(s).face(walk_.face(i), Role::Neighbour, "f");
}

/// The rows so far; those to come are undefined, so that the heat map grows.
Table Iteration::table(size_t rows) const
{
    Table t = table_;
    double sum = 0, defined = 0;
    if (!t.columns.empty())
        for (size_t i = 0; i < std::min(rows, size_); ++i)
            if (const double v = t.columns[0].values[i]; std::isfinite(v)) sum += v, defined += 1;
    t.summary = {{"elements", double(size_)}};
    if (elements_ == Iterate::Elements::Vertices) t.summary.emplace_back("sum of valences", sum);
    if (elements_ == Iterate::Elements::Faces) t.summary.emplace_back("sum of sizes", sum);
    if (elements_ == Iterate::Elements::Edges) t.summary.emplace_back("inner edges", defined);
    return t;
}

}  // namespace

Generator iterate(Mesh input, Iterate parameters, Stage<Table>& stage)
{
    Iteration all(input, parameters.elements);
    size_t rows = 0;
    stage.show([&] { return all.table(rows); });
    for (uint32_t i = 0; i < all.size(); ++i) {
        all.visit(i);
        ++rows;
        if (stage.watched() || (i & 4095) == 4095) co_yield all.step(i);
    }
    stage.finish(all.table(rows));
}

}  // namespace mw
