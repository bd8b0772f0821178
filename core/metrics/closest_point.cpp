// Query: the closest point of a surface, box by box, then as the book has it for the triangle that was found.
#include "core/metrics/closest_point.h"

#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/math/point_triangle.h"
#include "core/mesh/triangle_tree.h"

namespace mw {

namespace {

using Event = ClosestWalk::Event;

/// Corner i of a box: bit 0, 1, 2 says which end along x, y, z.
glm::vec3 cornerOf(const BoundingBox& b, int i)
{
    return {i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z};
}

void addBox(Step& s, const BoundingBox& b, Role role)
{
    for (int i = 0; i < 8; ++i)
        for (const int bit : {1, 2, 4})
            if (!(i & bit)) std::move(s).segment(cornerOf(b, i), cornerOf(b, i | bit), role);
}

class Search {
public:
    Search(const Mesh& mesh, const glm::dvec3& p) : tree(mesh), walk(tree, p), mesh_(mesh), p_(p)
    {
        table.rows = ElementKind::Face;
        table.columns.push_back({"distance", "m", Array<double>(mesh.faceCount(), std::numeric_limits<double>::quiet_NaN()), false});
    }
    Event next();
    double nearest() const { return std::sqrt(walk.best().distance2); }
    double nodeDistance() const { return std::sqrt(walk.nodeDistance2()); }
    PointTriangle found() const;
    void summarise();

    Table table;
    TriangleTree tree;
    ClosestWalk walk;
    size_t opened = 0, passed = 0, tried = 0;
    std::vector<uint32_t> faces;  // of the last leaf

private:
    const Mesh& mesh_;
    glm::dvec3 p_;
};

Event Search::next()
{
    const Event e = walk.next();
    if (e == Event::Opened) ++opened;
    if (e == Event::Pruned) ++passed;
    if (e != Event::Leaf) return e;
    faces.clear();
    for (uint32_t i = walk.node().first; i < walk.node().last; ++i) {
        ClosestPoint one;
        tree.offer(i, p_, one);
        double& shown = table.columns[0].values[one.face];
        shown = std::isnan(shown) ? std::sqrt(one.distance2) : std::min(shown, std::sqrt(one.distance2));  // of a polygon its nearest triangle
        faces.push_back(one.face);
        ++tried;
    }
    return e;
}

PointTriangle Search::found() const
{
    const uint32_t t = walk.best().triangle;
    glm::dvec3 corner[3];
    for (size_t k = 0; k < 3; ++k) corner[k] = mesh_.positions()[mesh_.triangulation().vertices[3 * t + k]];
    return pointTriangle(p_, corner[0], corner[1], corner[2]);
}

void Search::summarise()
{
    const ClosestPoint& best = walk.best();
    const PointTriangle r = found();
    table.summary = {{"distance", nearest()},
                     {"face", double(best.face)},
                     {"x", best.at.x},
                     {"y", best.at.y},
                     {"z", best.at.z},
                     {"D", r.distance},
                     {"foot x", r.foot.x},
                     {"foot y", r.foot.y},
                     {"foot z", r.foot.z},
                     {"t1", r.t.x},
                     {"t2", r.t.y},
                     {"t3", r.t.z},
                     {"inside", double(r.inside)},
                     {"lambda1", best.weights.x},
                     {"lambda2", best.weights.y},
                     {"lambda3", best.weights.z},
                     {"boxes opened", double(opened)},
                     {"boxes passed over", double(passed)},
                     {"triangles tried", double(tried)}};
}

const char* phaseOf(Event e)
{
    return e == Event::Opened ? "open" : e == Event::Leaf ? "try" : "pass";
}

}  // namespace

Generator closestPointQuery(Mesh input, ClosestPointQuery parameters, Stage<Table>& stage)
{
    if (input.triangulation().faces.empty()) throw Error("closest-point: the mesh has no faces; give one that has a surface");
    const glm::vec3 at(parameters.point);
    co_yield Step("build").point(at, Role::Current, "P").number("triangles", double(input.triangulation().faces.size())).progress(0);
    Search s(input, parameters.point);
    stage.show([&s] { return s.table; });
    for (Event e = s.next(); e != Event::End; e = s.next()) {
        if (!stage.watched()) continue;
        const Role role = e == Event::Pruned ? Role::Rejected : Role::Neighbour;
        Step step(phaseOf(e));
        addBox(step, s.tree.boxes().box(s.walk.node().node), role);
        std::move(step).point(at, Role::Current, "P").number("box", s.nodeDistance()).number("least", s.nearest());
        std::move(step).number("opened", double(s.opened)).number("passed over", double(s.passed)).number("tried", double(s.tried));
        if (s.walk.best().triangle != none) std::move(step).segment(at, glm::vec3(s.walk.best().at), Role::New);
        if (e == Event::Leaf) std::move(step).ring(ElementKind::Face, Role::Neighbour, s.faces);
        co_yield std::move(step);
    }
    const PointTriangle r = s.found();
    const glm::vec3 foot(r.foot), closest(r.closest);
    const uint32_t t = 3 * s.walk.best().triangle;
    const Shared<uint32_t>& corner = input.triangulation().vertices;
    co_yield Step("foot")
        .face(s.walk.best().face, Role::Neighbour)
        .point(at, Role::Current, "P")
        .segment(at, foot, Role::New, "D")
        .point(foot, Role::New, "Q")
        .number("D", r.distance)
        .number("qx", r.foot.x)
        .number("qy", r.foot.y)
        .number("qz", r.foot.z)
        .progress(0.8);
    co_yield Step("inclusion")
        .face(s.walk.best().face, Role::Neighbour)
        .vertex(corner[t], Role::Neighbour, "A")
        .vertex(corner[t + 1], Role::Neighbour, "B")
        .vertex(corner[t + 2], Role::Neighbour, "C")
        .point(foot, Role::New, "Q")
        .segment(input.positions()[corner[t]], foot, Role::New)
        .segment(input.positions()[corner[t + 1]], foot, Role::New)
        .segment(input.positions()[corner[t + 2]], foot, Role::New)
        .number("t1", r.t.x)
        .number("t2", r.t.y)
        .number("t3", r.t.z)
        .number("inside", double(r.inside))
        .progress(0.9);
    co_yield Step("closest")
        .face(s.walk.best().face, Role::Neighbour)
        .point(at, Role::Current, "P")
        .segment(at, closest, Role::New, "d")
        .point(closest, Role::New, "X")
        .number("distance", s.nearest())
        .number("inside", double(r.inside))
        .number("l1", s.walk.best().weights.x)
        .number("l2", s.walk.best().weights.y)
        .number("l3", s.walk.best().weights.z)
        .number("opened", double(s.opened))
        .number("tried", double(s.tried))
        .progress(1);
    s.summarise();
    stage.finish(std::move(s.table));
}

}  // namespace mw
