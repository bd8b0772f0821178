// Expansions: sums of doubles that do not overlap, so the last one has the sign of the whole (Shewchuk 1997, "Adaptive precision
// floating-point arithmetic and fast robust geometric predicates"). Floats are so small beside doubles that nothing over- or underflows.
#include "core/math/predicates.h"

#include <vector>

namespace mw {

namespace {

using Expansion = std::vector<double>;

/// Adds one number, exactly.
void grow(Expansion& e, double b)
{
    double sum = b;
    size_t kept = 0;
    for (const double x : e) {
        const double s = sum + x, part = s - sum, rest = (sum - (s - part)) + (x - part);
        if (rest != 0) e[kept++] = rest;
        sum = s;
    }
    e.resize(kept);
    if (sum != 0) e.push_back(sum);
}

Expansion difference(double a, double b)
{
    Expansion e;
    grow(e, a);
    grow(e, -b);
    return e;
}

Expansion product(const Expansion& a, const Expansion& b)
{
    Expansion e;
    for (const double x : a)
        for (const double y : b) {
            const double p = x * y;
            grow(e, std::fma(x, y, -p));
            grow(e, p);
        }
    return e;
}

Expansion sum(Expansion a, const Expansion& b, double sign = 1)
{
    for (const double x : b) grow(a, sign * x);
    return a;
}

Expansion cross(const Expansion& a, const Expansion& b, const Expansion& c, const Expansion& d)
{
    return sum(product(a, d), product(b, c), -1);
}

int signOf(const Expansion& e)
{
    return e.empty() ? 0 : e.back() > 0 ? 1 : -1;
}

}  // namespace

int exactOrientation(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d)
{
    Expansion p[3][3];
    const glm::vec3* corner[3] = {&a, &b, &c};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) p[i][k] = difference((*corner[i])[k], d[k]);
    Expansion det = product(p[0][2], cross(p[1][0], p[1][1], p[2][0], p[2][1]));
    det = sum(std::move(det), product(p[1][2], cross(p[2][0], p[2][1], p[0][0], p[0][1])));
    det = sum(std::move(det), product(p[2][2], cross(p[0][0], p[0][1], p[1][0], p[1][1])));
    return signOf(det);
}

int exactOrientation(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c)
{
    return signOf(cross(difference(a.x, c.x), difference(a.y, c.y), difference(b.x, c.x), difference(b.y, c.y)));
}

}  // namespace mw
