// Signs of orientations alone: which side of a plane, and in a plane which side of a line. Nothing is constructed, so nothing is rounded.
#include "core/repair/triangle_overlap.h"

#include <algorithm>

#include "core/math/predicates.h"

namespace mw {

namespace {

/// Along one axis to a plane; what lies in the plane of a triangle stays apart when the triangle keeps an area.
class Projection {
public:
    explicit Projection(const Corners& t)
    {
        for (axis_ = 0; axis_ < 2; ++axis_)
            if (orientation(flat(t.at[0]), flat(t.at[1]), flat(t.at[2])) != 0) return;
    }
    glm::vec2 flat(const glm::vec3& p) const { return {p[(axis_ + 1) % 3], p[(axis_ + 2) % 3]}; }

private:
    int axis_ = 0;
};

bool within(const glm::vec2& p, const glm::vec2& a, const glm::vec2& b)
{
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

bool segmentsMeet(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c, const glm::vec2& d)
{
    const int abc = orientation(a, b, c), abd = orientation(a, b, d), cda = orientation(c, d, a), cdb = orientation(c, d, b);
    if (abc * abd < 0 && cda * cdb < 0) return true;
    return (abc == 0 && within(c, a, b)) || (abd == 0 && within(d, a, b)) || (cda == 0 && within(a, c, d)) || (cdb == 0 && within(b, c, d));
}

bool contains(const glm::vec2 (&t)[3], const glm::vec2& p)
{
    const int x = orientation(t[0], t[1], p), y = orientation(t[1], t[2], p), z = orientation(t[2], t[0], p);
    return (x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0);
}

/// All in one plane.
bool segmentMeetsFlat(const Corners& t, const glm::vec3& p, const glm::vec3& q)
{
    const Projection onto(t);
    const glm::vec2 f[3] = {onto.flat(t.at[0]), onto.flat(t.at[1]), onto.flat(t.at[2])}, a = onto.flat(p), b = onto.flat(q);
    if (contains(f, a) || contains(f, b)) return true;
    for (int k = 0; k < 3; ++k)
        if (segmentsMeet(f[k], f[(k + 1) % 3], a, b)) return true;
    return false;
}

/// `sp` and `sq`: sides of the plane of t on which p and q lie.
bool segmentMeets(const Corners& t, const glm::vec3& p, const glm::vec3& q, int sp, int sq)
{
    if (sp * sq > 0) return false;
    if (sp == 0 && sq == 0) return segmentMeetsFlat(t, p, q);
    const int x = orientation(p, q, t.at[0], t.at[1]), y = orientation(p, q, t.at[1], t.at[2]);
    if (x * y < 0) return false;
    const int z = orientation(p, q, t.at[2], t.at[0]);
    return x * z >= 0 && y * z >= 0;
}

int side(const Corners& t, const glm::vec3& p)
{
    return orientation(t.at[0], t.at[1], t.at[2], p);
}

bool allOnOneSide(const int (&s)[3])
{
    return (s[0] > 0 && s[1] > 0 && s[2] > 0) || (s[0] < 0 && s[1] < 0 && s[2] < 0);
}

bool meetFlat(const Corners& s, const Corners& t)
{
    for (int k = 0; k < 3; ++k)
        if (segmentMeetsFlat(t, s.at[k], s.at[(k + 1) % 3])) return true;
    return segmentMeetsFlat(s, t.at[0], t.at[1]);  // t within s
}

}  // namespace

bool onOneLine(const Corners& t)
{
    for (int k = 0; k < 3; ++k) {
        const int u = (k + 1) % 3, v = (k + 2) % 3;
        const glm::vec2 a(t.at[0][u], t.at[0][v]), b(t.at[1][u], t.at[1][v]), c(t.at[2][u], t.at[2][v]);
        if (orientation(a, b, c) != 0) return false;
    }
    return true;
}

bool meet(const Corners& s, const Corners& t)
{
    int ofT[3], ofS[3];
    for (int k = 0; k < 3; ++k) ofT[k] = side(s, t.at[k]);
    if (allOnOneSide(ofT)) return false;
    if (ofT[0] == 0 && ofT[1] == 0 && ofT[2] == 0) return meetFlat(s, t);
    for (int k = 0; k < 3; ++k) ofS[k] = side(t, s.at[k]);
    if (allOnOneSide(ofS)) return false;
    for (int k = 0; k < 3; ++k) {
        const int n = (k + 1) % 3;
        if (segmentMeets(s, t.at[k], t.at[n], ofT[k], ofT[n]) || segmentMeets(t, s.at[k], s.at[n], ofS[k], ofS[n])) return true;
    }
    return false;
}

bool meetBeyondCorner(const Corners& s, int i, const Corners& t, int j)
{
    const glm::vec3 &p = t.at[(j + 1) % 3], &q = t.at[(j + 2) % 3];
    const int sp = side(s, p), sq = side(s, q);
    if (sp * sq > 0) return false;  // t meets the plane of s in the common corner alone
    const glm::vec3 &u = s.at[(i + 1) % 3], &v = s.at[(i + 2) % 3];
    const int su = side(t, u), sv = side(t, v);
    if (su * sv > 0) return false;
    return segmentMeets(s, p, q, sp, sq) || segmentMeets(t, u, v, su, sv);
}

bool meetBeyondSide(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d)
{
    if (orientation(a, b, c, d) != 0) return false;
    const Corners t{{a, b, c}};
    const Projection onto(t);
    return orientation(onto.flat(a), onto.flat(b), onto.flat(c)) == orientation(onto.flat(a), onto.flat(b), onto.flat(d));
}

}  // namespace mw
