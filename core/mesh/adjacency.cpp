// The nine adjacency queries: three kinds of walk over half-edges, and what is picked up on the way.
//
//   about a vertex    h leaves the vertex; h := h.pair.next, until the first one comes again    V:-V  V:-E  V:-F  E:-E  F:-F across vertices
//   round a face      h := h.next, until the first one comes again                              F:-V  F:-E  F:-F across edges
//   both halves       h and h.pair                                                              E:-V  E:-F
#include "core/mesh/adjacency.h"

#include <algorithm>
#include <set>

#include "core/error.h"
#include "core/mesh/halfedge_walk.h"
#include "core/mesh/select.h"

namespace mw {

namespace {

using Query = Adjacency::Query;
using Pair = std::pair<uint32_t, uint32_t>;  // an edge, the lower vertex first; of other kinds the index twice

constexpr ElementKind kinds[] = {ElementKind::Vertex, ElementKind::Edge, ElementKind::Face};
constexpr const char* names[] = {"vertex", "edge", "face"};

enum Outcome { New, Known, Nothing, Itself };

Pair edgeOf(uint32_t a, uint32_t b)
{
    return std::minmax(a, b);
}

/// What is asked, where the walk is, and what has been found.
class Search {
public:
    Search(const Mesh& mesh, const Adjacency& parameters);

    const HalfedgeWalk walk;
    bool nextCentre();  ///< the next vertex to walk about
    uint32_t centre() const { return centre_; }
    std::vector<uint32_t> side() const;    ///< the half-edge to walk round the face from; none where the query has no use for it
    std::vector<uint32_t> halves() const;  ///< those of the asked edge, when the query wants them
    void visit(uint32_t h);
    bool visitLeftOut();  ///< degenerate faces; false when there is none
    Step step(const char* phase, uint32_t h, uint32_t next) const;
    ElementSet answer() const;

private:
    Pair askedFrom(const std::string& text) const;
    bool circles() const;
    void take(uint32_t vertexOrFace) { take(Pair(vertexOrFace, vertexOrFace)); }
    void take(Pair element);
    void takeFacesAt(Pair edge);
    void takeSides(uint32_t face);
    std::vector<Pair> sidesOf(uint32_t face) const;
    Step marked(Step step, Pair element, ElementKind kind, Role role, const char* label) const;

    Mesh mesh_;
    Adjacency parameters_;
    Query query_;
    Pair asked_;
    std::vector<uint32_t> leftOut_;
    std::vector<uint32_t> centres_;
    size_t next_ = 0, ringEnd_ = 0;  // of the centres; of those found, how many have been centres
    int64_t ring_ = 1;
    uint32_t centre_ = none;
    std::set<Pair> found_;
    std::vector<uint32_t> order_;  // as found, for vertices and faces; edges as pairs
    std::vector<Pair> here_;       // met at this step
    Outcome outcome_ = Nothing;
};

Search::Search(const Mesh& mesh, const Adjacency& parameters)
    : walk(mesh), mesh_(mesh), parameters_(parameters), query_(parameters.query), asked_(askedFrom(parameters.element)), leftOut_(walk.leftOut())
{
    if (!circles()) return;
    if (askedKind(query_) == ElementKind::Vertex) centres_ = {asked_.first};
    if (askedKind(query_) == ElementKind::Edge) centres_ = {asked_.first, asked_.second};
    if (askedKind(query_) == ElementKind::Face)
        for (const uint32_t v : mesh.face(asked_.first))
            if (std::find(centres_.begin(), centres_.end(), v) == centres_.end()) centres_.push_back(v);
}

Pair Search::askedFrom(const std::string& text) const
{
    const ElementKind kind = askedKind(query_);
    const char* name = names[int(query_) / 3];
    const size_t below = kind == ElementKind::Face ? mesh_.faceCount() : mesh_.vertexCount();
    if (below == 0) throw Error(std::string("the mesh has no ") + name + " to ask about");
    const ElementSet set = parsedElements(kind, text, below);
    if (countOf(set) != 1)
        throw Error("element \"" + text.substr(0, 40) + "\" names " + std::to_string(countOf(set)) + " elements; name one " + name + ", as in " +
                    (kind == ElementKind::Edge ? "3~7" : "12"));
    if (kind != ElementKind::Edge) return {set.indices[0], set.indices[0]};
    const Pair edge = edgeOf(set.indices[0], set.indices[1]);
    bool isEdge = !walk.between(edge.first, edge.second).empty();
    for (const uint32_t f : isEdge ? std::vector<uint32_t>() : walk.leftOut())
        for (const Pair& s : sidesOf(f)) isEdge = isEdge || s == edge;
    if (!isEdge)
        throw Error("no edge joins the vertices " + std::to_string(edge.first) + " and " + std::to_string(edge.second) +
                    "; the query vertex-vertices tells which ones a vertex is joined to");
    return edge;
}

bool Search::circles() const
{
    return query_ <= Query::VertexFaces || query_ == Query::EdgeEdges || (query_ == Query::FaceFaces && parameters_.acrossVertices);
}

/// When a ring of vertices has been walked about, those it found are the next to walk about, as often as is asked.
bool Search::nextCentre()
{
    if (next_ == centres_.size() && query_ == Query::VertexVertices && ring_ < parameters_.ring && ringEnd_ < order_.size()) {
        centres_.assign(order_.begin() + std::ptrdiff_t(ringEnd_), order_.end());
        ringEnd_ = order_.size();
        next_ = 0;
        ++ring_;
    }
    if (next_ == centres_.size()) return false;
    centre_ = centres_[next_++];
    return true;
}

std::vector<uint32_t> Search::side() const
{
    if (circles() || askedKind(query_) != ElementKind::Face) return {};
    const uint32_t h = walk.ofFace(asked_.first);
    return h == none ? std::vector<uint32_t>() : std::vector<uint32_t>{h};
}

std::vector<uint32_t> Search::halves() const
{
    if (circles() || askedKind(query_) != ElementKind::Edge) return {};
    return walk.between(asked_.first, asked_.second);
}

void Search::take(Pair element)
{
    here_.push_back(element);
    outcome_ = Itself;
    if (askedKind(query_) == foundKind(query_) && element == asked_) return;
    outcome_ = Known;
    if (!found_.insert(element).second) return;
    outcome_ = New;
    order_.push_back(element.first);
    if (foundKind(query_) == ElementKind::Edge) order_.push_back(element.second);
}

void Search::visit(uint32_t h)
{
    here_.clear();
    outcome_ = Nothing;
    switch (query_) {
        case Query::VertexVertices:
        case Query::EdgeVertices:
        case Query::FaceVertices:
            return take(walk.target(h));
        case Query::VertexEdges:
        case Query::EdgeEdges:
        case Query::FaceEdges:
            return take(edgeOf(walk.source(h), walk.target(h)));
        case Query::VertexFaces:
        case Query::EdgeFaces:
            if (walk.face(h) != none) take(walk.face(h));
            return;
        case Query::FaceFaces:
            if (!circles()) return takeFacesAt(edgeOf(walk.source(h), walk.target(h)));
            if (walk.face(h) != none) take(walk.face(h));
            return;
    }
}

/// Of a plain edge the face of the pair; where more than two faces meet, of all half-edges there.
void Search::takeFacesAt(Pair edge)
{
    for (const uint32_t g : walk.between(edge.first, edge.second))
        if (walk.face(g) != none && walk.face(g) != asked_.first) take(walk.face(g));
}

std::vector<Pair> Search::sidesOf(uint32_t face) const
{
    std::vector<Pair> out;
    const auto corners = mesh_.face(face);
    for (size_t i = 0; i < corners.size(); ++i)
        if (const Pair p = edgeOf(corners[i], corners[(i + 1) % corners.size()]); p.first != p.second) out.push_back(p);
    return out;
}

/// Of a degenerate face all that is asked for.
void Search::takeSides(uint32_t face)
{
    for (const Pair& s : sidesOf(face)) {
        const bool atCentre = s.first == centre_ || s.second == centre_;
        if (query_ == Query::VertexVertices && atCentre) take(s.first == centre_ ? s.second : s.first);
        if ((query_ == Query::VertexEdges || query_ == Query::EdgeEdges) && atCentre) take(s);
        if (query_ == Query::EdgeFaces && s == asked_) take(face);
        if (query_ == Query::FaceEdges && face == asked_.first) take(s);
        if (query_ == Query::FaceFaces && !circles() && face == asked_.first) takeFacesAt(s);
        if (query_ == Query::FaceFaces && !circles() && face != asked_.first)
            for (const Pair& own : sidesOf(asked_.first))
                if (own == s) take(face);
    }
    const auto corners = mesh_.face(face);
    const bool hasCentre = std::find(corners.begin(), corners.end(), centre_) != corners.end();
    if ((query_ == Query::VertexFaces || (query_ == Query::FaceFaces && circles())) && hasCentre) take(face);
    if (query_ == Query::FaceVertices && face == asked_.first)
        for (const uint32_t v : corners) take(v);
    if (query_ == Query::EdgeVertices) take(asked_.first), take(asked_.second);
}

bool Search::visitLeftOut()
{
    here_.clear();
    outcome_ = Nothing;
    for (const uint32_t f : leftOut_) takeSides(f);
    return !leftOut_.empty();
}

Step Search::marked(Step step, Pair element, ElementKind kind, Role role, const char* label) const
{
    if (kind == ElementKind::Edge) return std::move(step).edge(element.first, element.second, role, label);
    return std::move(step).element(kind, element.first, role, label);
}

Step Search::step(const char* phase, uint32_t h, uint32_t next) const
{
    static constexpr Role roles[] = {Role::New, Role::Rejected, Role::Rejected, Role::Rejected};
    Step s = marked(Step(phase), asked_, askedKind(query_), Role::Current, "a");
    if (h != none) s = std::move(s).edge(walk.source(h), walk.target(h), Role::Current, "h").number("half-edge", h);
    if (h != none) s = std::move(s).number("from", walk.source(h)).number("to", walk.target(h)).number("pair", walk.pair(h)).number("next", next);
    for (const Pair& p : here_) s = marked(std::move(s), p, foundKind(query_), roles[outcome_], "b");
    return std::move(s)
        .ring(foundKind(query_), Role::Neighbour, order_)
        .number("outcome", outcome_)
        .number("found", double(found_.size()))
        .number("ring", double(ring_));
}

ElementSet Search::answer() const
{
    return sorted({foundKind(query_), order_});
}

}  // namespace

ElementKind askedKind(Query query)
{
    return kinds[int(query) / 3];
}

ElementKind foundKind(Query query)
{
    return kinds[int(query) % 3];
}

Generator adjacency(Mesh input, Adjacency parameters, Stage<ElementSet>& stage)
{
    Search search(input, parameters);
    const HalfedgeWalk& walk = search.walk;
    stage.show([&] { return search.answer(); });
    size_t turns = 0;
    co_yield search.step("ask", none, none);
    while (search.nextCentre()) {
        for (const uint32_t first : walk.fans(search.centre())) {
            uint32_t h = first;
            do {
                search.visit(h);
                if (stage.watched() || (++turns & 1023) == 0) co_yield search.step("about", h, walk.next(walk.pair(h)));
                h = walk.next(walk.pair(h));
            } while (h != first);
        }
        const bool any = search.visitLeftOut();
        if (any && stage.watched()) co_yield search.step("left out", none, none);
    }
    for (const uint32_t first : search.side()) {
        uint32_t h = first;
        do {
            search.visit(h);
            if (stage.watched()) co_yield search.step("round", h, walk.next(h));
            h = walk.next(h);
        } while (h != first);
    }
    for (const uint32_t h : search.halves()) {
        search.visit(h);
        if (stage.watched()) co_yield search.step("halves", h, walk.pair(h));
    }
    if (search.centre() == none && search.visitLeftOut() && stage.watched()) co_yield search.step("left out", none, none);
    stage.finish(search.answer());
}

}  // namespace mw
