// Quadrics as the quick decimation keeps them: centred at their own vertex, so that six numbers are all there is and nothing cancels; and the cost of
// an edge. Four floats at a time in the compiler's vector types: the same operations in the same order on every machine.
#pragma once
#include <cmath>
#include <cstdint>

namespace mw::quick {

#define MW_INLINE inline __attribute__((always_inline))

using Float4 = float __attribute__((vector_size(16)));

MW_INLINE float dot(Float4 a, Float4 b)
{
    const Float4 p = a * b;
    return p[0] + p[1] + p[2];
}
MW_INLINE Float4 cross(Float4 a, Float4 b)
{
    const Float4 r = a * __builtin_shufflevector(b, b, 1, 2, 0, 3) - __builtin_shufflevector(a, a, 1, 2, 0, 3) * b;
    return __builtin_shufflevector(r, r, 1, 2, 0, 3);
}

/// A symmetric 3 x 3 matrix: xx xy xz yy and yz zz 0 0. As a quadric of a vertex at p, (x - p)^T A (x - p) is the weighed sum of squared distances
/// of x to planes through p: at p itself it is 0, hence no linear and no constant part (Garland and Heckbert 1997 have ten numbers).
struct Symmetric {
    Float4 a, b;
    MW_INLINE Symmetric operator+(const Symmetric& s) const { return {a + s.a, b + s.b}; }
    MW_INLINE Symmetric operator-(const Symmetric& s) const { return {a - s.a, b - s.b}; }
    MW_INLINE Symmetric operator*(float s) const { return {a * s, b * s}; }
};
constexpr Symmetric zero{{0, 0, 0, 0}, {0, 0, 0, 0}}, identity{{1, 0, 0, 1}, {0, 1, 0, 0}};

MW_INLINE Symmetric square(Float4 n)
{
    return {__builtin_shufflevector(n, n, 0, 0, 0, 1) * __builtin_shufflevector(n, n, 0, 1, 2, 1),
            __builtin_shufflevector(n, n, 1, 2, 3, 3) * __builtin_shufflevector(n, n, 2, 2, 3, 3)};
}

constexpr float pull = 1e-5f;  // of a vertex to its own place, against the planes of its faces: flat regions stay well-conditioned

/// Of a face with normal n, |n| twice its area: its plane, weighed with twice the area, and the pull.
MW_INLINE Symmetric faceQuadric(Float4 n, float length, float inverse)
{
    return square(n) * inverse + identity * (pull * length);
}
MW_INLINE Symmetric faceQuadric(Float4 n)
{
    const float length = std::sqrt(dot(n, n));
    return faceQuadric(n, length, length > 0 ? 1 / length : 0);
}

/// The adjugate of A + B in double: the matrices are nearly singular where the surface is flat.
struct Adjugate {
    double xx, xy, xz, yy, yz, zz, determinant;

    MW_INLINE Adjugate(const Symmetric& A, const Symmetric& B)
    {
        const double a = double(A.a[0]) + B.a[0], b = double(A.a[1]) + B.a[1], c = double(A.a[2]) + B.a[2];
        const double d = double(A.a[3]) + B.a[3], e = double(A.b[0]) + B.b[0], f = double(A.b[1]) + B.b[1];
        xx = d * f - e * e, xy = c * e - b * f, xz = b * e - c * d;
        yy = a * f - c * c, yz = b * c - a * e, zz = a * d - b * b;
        determinant = a * xx + b * xy + c * xz;
    }
    MW_INLINE void times(double x, double y, double z, double (&out)[3]) const
    {
        out[0] = xx * x + xy * y + xz * z;
        out[1] = xy * x + yy * y + yz * z;
        out[2] = xz * x + yz * y + zz * z;
    }
};

MW_INLINE void product(const Symmetric& q, double x, double y, double z, double (&out)[3])
{
    out[0] = q.a[0] * x + q.a[1] * y + q.a[2] * z;
    out[1] = q.a[1] * x + q.a[3] * y + q.b[0] * z;
    out[2] = q.a[2] * x + q.b[0] * y + q.b[1] * z;
}
MW_INLINE double valueAt(const Symmetric& q, double x, double y, double z)
{
    double r[3];
    product(q, x, y, z, r);
    return r[0] * x + r[1] * y + r[2] * z;
}

/// Where an edge would go, from its first end, and what that costs.
struct Target {
    float x, y, z, cost;
};

/// With t = x - a and d = b - a the error is t^T A t + (t - d)^T B (t - d): least where (A + B) t = B d, and then d^T B (d - t).
MW_INLINE Target bestTarget(const Symmetric& A, const Symmetric& B, Float4 d)
{
    const double x = d[0], y = d[1], z = d[2];
    double r[3], t[3];
    product(B, x, y, z, r);
    const Adjugate inverse(A, B);
    const double scale = inverse.determinant > 0 ? 1 / inverse.determinant : 0;
    inverse.times(r[0], r[1], r[2], t);
    t[0] *= scale, t[1] *= scale, t[2] *= scale;
    const double cost = r[0] * x + r[1] * y + r[2] * z - (r[0] * t[0] + r[1] * t[1] + r[2] * t[2]);
    return {float(t[0]), float(t[1]), float(t[2]), cost > 0 ? float(cost) : 0.f};
}
/// To the first end, or to the second one.
MW_INLINE Target firstEnd(const Symmetric& B, Float4 d)
{
    const double cost = valueAt(B, d[0], d[1], d[2]);
    return {0, 0, 0, cost > 0 ? float(cost) : 0.f};
}
MW_INLINE Target secondEnd(const Symmetric& A, Float4 d)
{
    const double cost = valueAt(A, d[0], d[1], d[2]);
    return {d[0], d[1], d[2], cost > 0 ? float(cost) : 0.f};
}

}  // namespace mw::quick
