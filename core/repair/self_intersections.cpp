// A tree of boxes over all triangles; each triangle is held against those behind it in the order of the tree.
#include "core/repair/self_intersections.h"

#include <algorithm>
#include <tbb/parallel_for.h>

#include "core/mesh/box_tree.h"
#include "core/repair/coincident.h"
#include "core/repair/triangle_overlap.h"

namespace mw {

namespace {

struct Triangle {
    Corners corners;
    uint32_t vertex[3];
    uint32_t face;
};

BoundingBox boxOf(const Corners& t)
{
    BoundingBox b{t.at[0], t.at[0]};
    for (int k = 1; k < 3; ++k) b.add({t.at[k], t.at[k]});
    return b;
}

/// All triangles with an area.
std::vector<Triangle> trianglesOf(const Mesh& mesh, bool byPlace)
{
    const Mesh::Triangulation& cut = mesh.triangulation();
    const Array<uint32_t> same = byPlace ? lowestAtPlace(mesh) : Array<uint32_t>();
    std::vector<Triangle> out;
    out.reserve(cut.faces.size());
    for (size_t t = 0; t < cut.faces.size(); ++t) {
        Triangle x;
        x.face = cut.faces[t];
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t v = cut.vertices[3 * t + k];
            x.vertex[k] = byPlace ? same[v] : v;
            x.corners.at[k] = mesh.positions()[v];
        }
        if (!onOneLine(x.corners)) out.push_back(x);
    }
    return out;
}

/// Two triangles whose boxes overlap: by the number of common vertices.
bool intersect(const Triangle& s, const Triangle& t)
{
    int ofS[3], ofT[3], common = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (s.vertex[i] == t.vertex[j]) {
                ofS[common] = i;
                ofT[common++] = j;
                break;
            }
    const Corners &a = s.corners, &b = t.corners;
    if (common == 0) return meet(a, b);
    if (common == 1) return meetBeyondCorner(a, ofS[0], b, ofT[0]);
    if (common == 2) return meetBeyondSide(a.at[ofS[0]], a.at[ofS[1]], a.at[3 - ofS[0] - ofS[1]], b.at[3 - ofT[0] - ofT[1]]);
    return true;
}

/// The triangles in the order of a tree of boxes.
class Tree {
public:
    Tree(std::vector<Triangle> triangles, Progress* progress);
    size_t size() const { return triangles_.size(); }
    /// Pairs of faces of the triangles first..last-1 with those behind them; stops beyond `most`.
    std::vector<FacePair> pairs(size_t first, size_t last, size_t most) const;

private:
    std::vector<Triangle> triangles_;
    std::vector<BoundingBox> own_;
    BoxTree boxes_;
};

Tree::Tree(std::vector<Triangle> triangles, Progress* progress)
{
    std::vector<BoundingBox> boxes(triangles.size());
    for (size_t i = 0; i < boxes.size(); ++i) boxes[i] = boxOf(triangles[i].corners);
    boxes_ = BoxTree(boxes, progress);
    triangles_.reserve(boxes.size());
    own_.reserve(boxes.size());
    for (const uint32_t i : boxes_.order()) {
        triangles_.push_back(triangles[i]);
        own_.push_back(boxes[i]);
    }
}

std::vector<FacePair> Tree::pairs(size_t first, size_t last, size_t most) const
{
    std::vector<FacePair> out;
    std::vector<BoxTree::Range> open;
    for (size_t i = first; i < last && out.size() <= most; ++i) {
        const Triangle& s = triangles_[i];
        open.push_back(boxes_.root());
        while (!open.empty()) {
            const BoxTree::Range r = open.back();
            open.pop_back();
            if (r.last <= i + 1 || !boxes_.box(r.node).overlaps(own_[i])) continue;
            if (!boxes_.isLeaf(r)) {
                open.push_back(BoxTree::right(r));
                open.push_back(BoxTree::left(r));
                continue;
            }
            for (size_t j = std::max<size_t>(r.first, i + 1); j < r.last; ++j) {
                const Triangle& t = triangles_[j];
                if (s.face != t.face && own_[i].overlaps(own_[j]) && intersect(s, t)) out.push_back(std::minmax(s.face, t.face));
            }
        }
    }
    return out;
}

void makeUnique(std::vector<FacePair>& pairs, size_t most)
{
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());  // polygons meet by several triangles
    if (pairs.size() > most) pairs.resize(most);
}

/// The search in pieces, so that whoever asked can look up in between.
class Search {
public:
    Search(std::vector<Triangle> triangles, size_t most, Progress* progress) : tree_(std::move(triangles), progress), most_(most) {}
    bool done() const { return at_ >= tree_.size() || found_.size() > most_; }
    double fraction() const { return tree_.size() ? double(at_) / double(tree_.size()) : 1; }
    void next();
    std::vector<FacePair> result()
    {
        makeUnique(found_, most_);
        return std::move(found_);
    }

private:
    static constexpr size_t piece = 1024, pieces = 16;
    Tree tree_;
    size_t most_, at_ = 0;
    std::vector<FacePair> found_;
};

void Search::next()
{
    std::vector<std::vector<FacePair>> found(pieces);
    tbb::parallel_for(size_t(0), pieces, [&](size_t k) {
        const size_t first = std::min(tree_.size(), at_ + k * piece), last = std::min(tree_.size(), first + piece);
        found[k] = tree_.pairs(first, last, most_);
    });
    for (const auto& f : found) found_.insert(found_.end(), f.begin(), f.end());
    at_ += piece * pieces;
}

}  // namespace

std::vector<FacePair> selfIntersectionsOf(const Mesh& mesh, const IntersectionOptions& options, Progress* progress)
{
    const float from = progress ? progress->fraction.load() : 0;
    Search search(trianglesOf(mesh, options.byPlace), options.most, progress);
    while (!search.done()) {
        search.next();
        if (progress) progress->at(from + (1 - from) * float(search.fraction()));
    }
    return search.result();
}

Generator selfIntersections(Mesh input, SelfIntersections p, Stage<Table>& stage)
{
    co_yield Step("boxes").progress(0);
    std::vector<Triangle> triangles = trianglesOf(input, p.byPlace);
    co_yield Step("boxes").progress(0);
    Search search(std::move(triangles), IntersectionOptions().most, nullptr);
    while (!search.done()) {
        search.next();
        co_yield Step("pairs").progress(search.fraction());
    }
    const std::vector<FacePair> pairs = search.result();
    Table table;
    table.rows = ElementKind::Face;
    Array<double> count(input.faceCount(), 0.);
    std::vector<uint32_t> flat;
    for (const auto& [a, b] : pairs) {
        ++count[a];
        ++count[b];
        flat.push_back(a);
        flat.push_back(b);
    }
    const double faces = double(std::count_if(count.begin(), count.end(), [](double n) { return n > 0; }));
    table.columns.push_back({"intersections", "", std::move(count), false});
    table.summary = {{"pairs", double(pairs.size())}, {"faces", faces}};
    table.lists = {{"pairs", std::move(flat)}};
    stage.finish(std::move(table));
}

}  // namespace mw
