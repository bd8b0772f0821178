// The quadric error metric: a weighed sum of squared distances to planes, kept as ten numbers. Book (3.6)-(3.10), Garland and Heckbert 1997,
// "Surface simplification using quadric error metrics".
#pragma once
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace mw {

/// at(x) = x^T A x + 2 b^T x + c with a symmetric A: the upper rows of the 4x4 matrix Q of the book.
struct Quadric {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;  // A
    double bx = 0, by = 0, bz = 0, c = 0;

    /// `weight` times the squared distance to the plane n.x + d = 0, n of length 1.
    void addPlane(const glm::dvec3& n, double d, double weight)
    {
        const glm::dvec3 w = weight * n;
        xx += w.x * n.x, xy += w.x * n.y, xz += w.x * n.z, yy += w.y * n.y, yz += w.y * n.z, zz += w.z * n.z;
        bx += w.x * d, by += w.y * d, bz += w.z * d, c += weight * d * d;
    }
    /// `weight` times the squared distance to a point.
    void addPoint(const glm::dvec3& p, double weight)
    {
        xx += weight, yy += weight, zz += weight;
        bx -= weight * p.x, by -= weight * p.y, bz -= weight * p.z, c += weight * glm::dot(p, p);
    }
    Quadric& operator+=(const Quadric& q)
    {
        xx += q.xx, xy += q.xy, xz += q.xz, yy += q.yy, yz += q.yz, zz += q.zz, bx += q.bx, by += q.by, bz += q.bz, c += q.c;
        return *this;
    }
    friend Quadric operator+(Quadric a, const Quadric& b) { return a += b; }

    double at(const glm::dvec3& p) const
    {
        const glm::dvec3 ap(xx * p.x + xy * p.y + xz * p.z, xy * p.x + yy * p.y + yz * p.z, xz * p.x + yz * p.y + zz * p.z);
        return glm::dot(ap, p) + 2 * (bx * p.x + by * p.y + bz * p.z) + c;
    }

    /// The point of least value: A p = -b, by the adjugate. False where A has (nearly) no inverse.
    bool least(glm::dvec3& p) const
    {
        const double axx = yy * zz - yz * yz, axy = xz * yz - xy * zz, axz = xy * yz - xz * yy;
        const double ayy = xx * zz - xz * xz, ayz = xy * xz - xx * yz, azz = xx * yy - xy * xy;
        const double det = xx * axx + xy * axy + xz * axz, trace = xx + yy + zz;
        if (!(det > 1e-14 * trace * trace * trace)) return false;
        const double s = -1 / det;
        p = s * glm::dvec3(axx * bx + axy * by + axz * bz, axy * bx + ayy * by + ayz * bz, axz * bx + ayz * by + azz * bz);
        return true;
    }

    /// How ill A is: norm of A times norm of its inverse (Frobenius), infinite when it has none.
    double condition() const
    {
        const double axx = yy * zz - yz * yz, axy = xz * yz - xy * zz, axz = xy * yz - xz * yy;
        const double ayy = xx * zz - xz * xz, ayz = xy * xz - xx * yz, azz = xx * yy - xy * xy;
        const double det = xx * axx + xy * axy + xz * axz;
        const auto norm = [](double a, double b, double e, double f, double g, double h) {
            return std::sqrt(a * a + f * f + h * h + 2 * (b * b + e * e + g * g));
        };
        return norm(xx, xy, xz, yy, yz, zz) * norm(axx, axy, axz, ayy, ayz, azz) / std::abs(det);
    }
};

}  // namespace mw
