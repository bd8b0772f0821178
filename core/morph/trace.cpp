#include "core/morph/trace.h"

#include "core/error.h"

namespace mw {

namespace {

using Kind = Location::Kind;

/// The place of v in a triangle from its sides against the three edges; none of them negative.
Location inTriangle(const DomainMesh& mesh, uint32_t f, const int (&o)[3])
{
    const uint32_t h = 3 * f;
    const int zeros = (o[0] == 0) + (o[1] == 0) + (o[2] == 0);
    if (zeros == 0) return {Kind::Triangle, f};
    if (zeros == 1) return {Kind::Edge, o[0] == 0 ? h : o[1] == 0 ? h + 1 : h + 2};
    return {Kind::Vertex, mesh.from(o[2] == 0 && o[0] == 0 ? h : o[0] == 0 ? h + 1 : h + 2)};
}

class Walk {
public:
    Walk(const DomainMesh& mesh, const Direction& u, const Direction& v, std::vector<Hop>* hops) : mesh_(mesh), u_(u), v_(v), hops_(hops) {}

    Location run(Location from)
    {
        switch (from.kind) {
            case Kind::Triangle:
                fromTriangle(from.index);
                break;
            case Kind::Edge:
                fromEdge(from.index);
                break;
            case Kind::Vertex:
                vertex_ = from.index;
                break;
        }
        // Each turn passes a triangle or a vertex, and none of them twice.
        for (size_t turns = 0; !done_; ++turns) {
            if (turns > 2 * mesh_.corners().size() + 8) throw Error("the walk through the other mesh goes round in circles; its map is folded");
            if (vertex_ != none)
                fromVertex();
            else
                enter();
        }
        return at_;
    }

private:
    int sideOf(uint32_t vertex) const { return side(u_, v_, mesh_.at(vertex)); }
    /// Which side of a half-edge v lies on.
    int beyond(uint32_t h) const { return side(mesh_.at(mesh_.from(h)), mesh_.at(mesh_.to(h)), v_); }

    void finish(Location at, uint32_t within, int8_t along = 0)
    {
        if (hops_) hops_->push_back({within, none, along, Hop::Met::End});
        at_ = at;
        done_ = true;
    }
    void cross(uint32_t h)
    {
        if (hops_) hops_->push_back({h / 3, h, 0, Hop::Met::Edge});
        goThrough(h);
    }
    void pass(uint32_t vertex, uint32_t within, int8_t along = 0)
    {
        if (hops_) hops_->push_back({within, vertex, along, Hop::Met::Vertex});
        vertex_ = vertex;
        entry_ = none;
    }
    void goThrough(uint32_t h)
    {
        vertex_ = none;
        entry_ = mesh_.opposite(h);
        if (entry_ == none) throw Error("the borders of the two maps do not agree");
    }

    /// From a place strictly inside a triangle.
    void fromTriangle(uint32_t f)
    {
        const uint32_t h = 3 * f;
        const int o[3] = {beyond(h), beyond(h + 1), beyond(h + 2)};
        if (o[0] >= 0 && o[1] >= 0 && o[2] >= 0) return finish(inTriangle(mesh_, f, o), f);
        const int s[3] = {sideOf(mesh_.from(h)), sideOf(mesh_.from(h + 1)), sideOf(mesh_.from(h + 2))};
        for (int k = 0; k < 3; ++k) {
            if (s[k] < 0 && s[(k + 1) % 3] > 0) return cross(h + uint32_t(k));
            if (s[k] == 0 && s[(k + 1) % 3] > 0 && s[(k + 2) % 3] < 0) return pass(mesh_.from(h + uint32_t(k)), f);
        }
        throw Error("the map of the other mesh is folded");
    }

    /// Along half-edge h, from its tail or from inside it: v within it, at its head, or beyond.
    void runAlong(uint32_t h)
    {
        const int o = beyond(DomainMesh::next(h));
        if (o > 0) return finish({Kind::Edge, h}, h, 1);
        if (o == 0) return finish({Kind::Vertex, mesh_.to(h)}, h, 1);
        pass(mesh_.to(h), h, 1);
    }
    /// The same against its direction; said of the opposite half-edge where there is one.
    void runBack(uint32_t h)
    {
        const uint32_t o = mesh_.opposite(h);
        if (o != none) return runAlong(o);
        const int s = beyond(DomainMesh::previous(h));
        if (s > 0) return finish({Kind::Edge, h}, h, -1);
        if (s == 0) return finish({Kind::Vertex, mesh_.from(h)}, h, -1);
        pass(mesh_.from(h), h, -1);
    }

    void fromEdge(uint32_t h)
    {
        const int a = sideOf(mesh_.from(h)), b = sideOf(mesh_.to(h));
        if (a == 0 && b == 0) return sideOf(mesh_.from(DomainMesh::previous(h))) > 0 ? runAlong(h) : runBack(h);
        if (a < 0)
            goThrough(h);
        else
            entry_ = h;
    }

    /// Through the half-edge `entry_` into its triangle.
    void enter()
    {
        const uint32_t q = DomainMesh::next(entry_), r = DomainMesh::previous(entry_), f = entry_ / 3;
        const int o1 = beyond(q), o2 = beyond(r);
        if (o1 >= 0 && o2 >= 0) {
            if (o1 > 0 && o2 > 0) return finish({Kind::Triangle, f}, f);
            if (o1 == 0 && o2 == 0) return finish({Kind::Vertex, mesh_.from(r)}, f);
            return finish({Kind::Edge, o1 == 0 ? q : r}, f);
        }
        const int s = sideOf(mesh_.from(r));
        if (s == 0) return pass(mesh_.from(r), f);
        cross(s < 0 ? r : q);
    }

    void fromVertex()
    {
        const uint32_t x = vertex_;
        for (const uint32_t h : mesh_.outgoing(x)) {
            const uint32_t last = DomainMesh::previous(h), far = DomainMesh::next(h), f = h / 3;
            const int right = sideOf(mesh_.to(h)), left = sideOf(mesh_.from(last));
            if (right == 0 && left > 0) return runAlong(h);
            if (left == 0 && right < 0) return runBack(last);
            if (right >= 0 || left <= 0) continue;
            const int o = beyond(far);
            if (o > 0) return finish({Kind::Triangle, f}, f);
            if (o == 0) return finish({Kind::Edge, far}, f);
            return cross(far);
        }
        throw Error("the borders of the two maps do not agree");
    }

    const DomainMesh& mesh_;
    const Direction &u_, &v_;
    std::vector<Hop>* hops_;
    uint32_t vertex_ = none, entry_ = none;  // where the walk stands: at a vertex, or on a half-edge whose triangle it enters
    bool done_ = false;
    Location at_;
};

}  // namespace

Location located(const DomainMesh& mesh, const Direction& place)
{
    for (uint32_t f = 0; f < mesh.triangles(); ++f) {
        int o[3];
        bool inside = true;
        for (uint32_t k = 0; k < 3 && inside; ++k) {
            const uint32_t h = 3 * f + k;
            o[k] = side(mesh.at(mesh.from(h)), mesh.at(mesh.to(h)), place);
            inside = o[k] >= 0;
        }
        if (inside) return inTriangle(mesh, f, o);
    }
    throw Error("a vertex lies outside the map of the other mesh");
}

Location traced(const DomainMesh& mesh, const Direction& u, const Direction& v, Location from, std::vector<Hop>* hops)
{
    return Walk(mesh, u, v, hops).run(from);
}

}  // namespace mw
