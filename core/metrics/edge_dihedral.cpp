// Query: the cost of each edge by the angle between its faces and its length.
#include "core/metrics/edge_dihedral.h"

#include <algorithm>
#include <numbers>

#include "core/metrics/fan.h"

namespace mw {

namespace {

/// Edges with what the costs need, in the order of Mesh::edges().
class EdgeCosts {
public:
    EdgeCosts(const Mesh& mesh, const EdgeDihedral& p) : mesh_(mesh), parameters_(p), rings_(mesh.rings()), corners_(mesh) {}
    /// What is needed of the whole mesh, in three parts of some time each; false when there is no such part.
    bool gather(int part);
    size_t size() const { return ends_.size() / 2; }
    uint32_t a(size_t e) const { return ends_[2 * e]; }
    uint32_t b(size_t e) const { return ends_[2 * e + 1]; }
    void measure(size_t e);

    Table table;
    double cosine = 1, length = 0, longest = 0;  // of the last edge; of all
    uint32_t left = none, right = none;          // its sharpest pair of faces

private:
    void findSides(size_t e);
    void makeTable();

    const Mesh& mesh_;
    EdgeDihedral parameters_;
    Shared<uint32_t> ends_;
    const Rings& rings_;
    FaceCorners corners_;
    std::vector<uint32_t> sides_;  // of the last edge
    Array<FaceMeasure> measures_;
};

bool EdgeCosts::gather(int part)
{
    if (part == 0) ends_ = mesh_.edges();
    if (part == 1) measures_ = faceMeasuresOf(mesh_);
    if (part == 2) makeTable();
    return part < 3;
}

void EdgeCosts::makeTable()
{
    table.rows = ElementKind::Edge;
    table.edges.assign(ends_.begin(), ends_.end());
    addColumn(table, "cost", "", size());
    addColumn(table, "angle", "\u00b0", size());
    addColumn(table, "length", "", size());
    double square = 0;
    for (size_t e = 0; e < size(); ++e) {
        const glm::dvec3 side = glm::dvec3(mesh_.positions()[b(e)]) - glm::dvec3(mesh_.positions()[a(e)]);
        square = std::max(square, glm::dot(side, side));
    }
    longest = std::sqrt(square);
}

/// At the end with fewer corners: else a cone of many faces would take the square of their number.
void EdgeCosts::findSides(size_t e)
{
    uint32_t v = a(e), w = b(e);
    if (rings_.cornersOf(v).size() > rings_.cornersOf(w).size()) std::swap(v, w);
    sides_.clear();
    const uint32_t* at = mesh_.cornerVertex().data();
    for (const uint32_t c : rings_.cornersOf(v)) {
        if (at[corners_.next(c)] == w) sides_.push_back(c);
        if (const uint32_t p = corners_.previous(c); at[p] == w) sides_.push_back(p);
    }
    if (sides_.size() > 1) std::sort(sides_.begin(), sides_.end());
}

void EdgeCosts::measure(size_t e)
{
    cosine = 1;
    left = right = none;
    length = glm::distance(glm::dvec3(mesh_.positions()[a(e)]), glm::dvec3(mesh_.positions()[b(e)]));
    findSides(e);
    const auto runsUp = [&](uint32_t c) { return mesh_.cornerVertex()[c] == a(e); };
    // Of very many faces on one edge only neighbours in the list are compared: else it would take the square of their number.
    for (size_t i = 0; i < sides_.size(); ++i)
        for (size_t j = i + 1; j < std::min(sides_.size(), i + 16); ++j) {
            const FaceMeasure &m = measures_[corners_.faceOf(sides_[i])], &n = measures_[corners_.faceOf(sides_[j])];
            if (!(m.area > 0) || !(n.area > 0)) continue;
            const double c = std::clamp((runsUp(sides_[i]) == runsUp(sides_[j]) ? -1 : 1) * glm::dot(m.normal, n.normal), -1.0, 1.0);
            if (left != none && c >= cosine) continue;
            cosine = c;
            left = corners_.faceOf(sides_[i]);
            right = corners_.faceOf(sides_[j]);
        }
    if (left == none && !sides_.empty()) left = corners_.faceOf(sides_[0]);
    const double angle = std::acos(cosine), share = longest > 0 ? length / longest : 0, k1 = parameters_.k1, k2 = parameters_.k2;
    double cost = k1 * angle + k2 * length;
    if (parameters_.form == EdgeDihedral::Form::Normalised) cost = k1 * angle / std::numbers::pi + k2 * share;
    if (parameters_.form == EdgeDihedral::Form::Cosine) cost = k1 * (1 - cosine) / 2 + k2 * share;
    table.columns[0].values[e] = cost;
    table.columns[1].values[e] = angle * 180 / std::numbers::pi;
    table.columns[2].values[e] = length;
}

}  // namespace

Generator edgeDihedral(Mesh input, EdgeDihedral parameters, Stage<Table>& stage)
{
    co_yield Step("gather").number("faces", double(input.faceCount())).progress(0);
    input.rings();  // kept with the mesh
    if (!stage.watched()) co_yield Step("gather").progress(0);
    EdgeCosts costs(input, parameters);
    for (int part = 0; costs.gather(part); ++part)
        if (!stage.watched()) co_yield Step("gather").progress(0);
    const double all = double(costs.size());
    std::vector<uint32_t> faces;
    stage.show([&costs] { return costs.table; });
    double sum = 0, greatest = 0;
    for (size_t e = 0; e < costs.size(); ++e) {
        costs.measure(e);
        const double cost = costs.table.columns[0].values[e];
        sum += cost;
        greatest = std::max(greatest, cost);
        if (!stage.watched()) {
            if ((e & 8191) == 0) co_yield Step("measure").progress(double(e) / all);
            continue;
        }
        faces.clear();
        for (const uint32_t f : {costs.left, costs.right})
            if (f != none) faces.push_back(f);
        co_yield Step("measure")
            .edge(costs.a(e), costs.b(e), Role::Current, "e")
            .ring(ElementKind::Face, Role::Neighbour, faces)
            .number("form", double(parameters.form))
            .number("faces", double(faces.size()))
            .number("cosine", costs.cosine)
            .number("angle", costs.table.columns[1].values[e])
            .number("length", costs.length)
            .number("longest", costs.longest)
            .number("k1", parameters.k1)
            .number("k2", parameters.k2)
            .number("cost", cost)
            .progress(double(e) / all);
    }
    costs.table.summary = {{"edges", all}, {"mean", all > 0 ? sum / all : 0}, {"greatest", greatest}, {"longest edge", costs.longest}};
    stage.finish(std::move(costs.table));
}

}  // namespace mw
