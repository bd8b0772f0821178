// Several vectors at once, one coordinate beside the other: four floats in the compiler's vector types, the same operations in the same order on
// every machine.
#pragma once
#include <algorithm>
#include <cmath>

#include "core/simplify/quick_quadric.h"

namespace mw::quick {

using Int4 = int __attribute__((vector_size(16)));
constexpr int lanes = 4;

/// Four vectors.
struct Vectors {
    Float4 x, y, z;
    MW_INLINE Vectors operator-(const Vectors& v) const { return {x - v.x, y - v.y, z - v.z}; }
    MW_INLINE Vectors operator+(const Vectors& v) const { return {x + v.x, y + v.y, z + v.z}; }
};
MW_INLINE Float4 dot(const Vectors& a, const Vectors& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
MW_INLINE Vectors cross(const Vectors& a, const Vectors& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
MW_INLINE Float4 all(float s)
{
    return Float4{s, s, s, s};
}
/// One vector four times.
MW_INLINE Vectors all(Float4 v)
{
    return {all(v[0]), all(v[1]), all(v[2])};
}

/// The lanes where the condition holds, 0 elsewhere.
MW_INLINE Float4 where(Int4 condition, Float4 v)
{
    return Float4(condition & Int4(v));
}
MW_INLINE Vectors where(Int4 condition, const Vectors& v)
{
    return {where(condition, v.x), where(condition, v.y), where(condition, v.z)};
}
/// Whether it holds anywhere.
MW_INLINE bool any(Int4 condition)
{
    using Long2 = long long __attribute__((vector_size(16)));
    const Long2 both = Long2(condition);
    return (both[0] | both[1]) != 0;
}
/// Lanes first, first + 1, ... below `limit`.
MW_INLINE Int4 below(int first, int limit)
{
    return Int4{first, first + 1, first + 2, first + 3} < Int4{limit, limit, limit, limit};
}

/// Rows become columns.
MW_INLINE void transpose(Float4 (&r)[4])
{
    const Float4 a = __builtin_shufflevector(r[0], r[1], 0, 4, 1, 5), b = __builtin_shufflevector(r[2], r[3], 0, 4, 1, 5),
                 c = __builtin_shufflevector(r[0], r[1], 2, 6, 3, 7), d = __builtin_shufflevector(r[2], r[3], 2, 6, 3, 7);
    r[0] = __builtin_shufflevector(a, b, 0, 1, 4, 5), r[1] = __builtin_shufflevector(a, b, 2, 3, 6, 7);
    r[2] = __builtin_shufflevector(c, d, 0, 1, 4, 5), r[3] = __builtin_shufflevector(c, d, 2, 3, 6, 7);
}
/// The sum over the lanes.
MW_INLINE Float4 sum(const Vectors& v)
{
    Float4 r[4] = {v.x, v.y, v.z, Float4{}};
    transpose(r);
    return (r[0] + r[1]) + (r[2] + r[3]);
}

/// Four symmetric matrices.
struct Symmetrics {
    Float4 xx{}, xy{}, xz{}, yy{}, yz{}, zz{};

    MW_INLINE Symmetrics operator+(const Symmetrics& s) const { return {xx + s.xx, xy + s.xy, xz + s.xz, yy + s.yy, yz + s.yz, zz + s.zz}; }
    MW_INLINE Symmetrics operator-(const Symmetrics& s) const { return {xx - s.xx, xy - s.xy, xz - s.xz, yy - s.yy, yz - s.yz, zz - s.zz}; }
    MW_INLINE void split(Symmetric (&out)[lanes]) const
    {
        Float4 a[4] = {xx, xy, xz, yy}, b[4] = {yz, zz, Float4{}, Float4{}};
        transpose(a), transpose(b);
        for (int k = 0; k < lanes; ++k) out[k] = {a[k], b[k]};
    }
};
MW_INLINE Symmetrics where(Int4 condition, const Symmetrics& s)
{
    return {where(condition, s.xx), where(condition, s.xy), where(condition, s.xz),
            where(condition, s.yy), where(condition, s.yz), where(condition, s.zz)};
}
MW_INLINE Symmetric sum(const Symmetrics& s)
{
    Symmetric r[lanes];
    s.split(r);
    return (r[0] + r[1]) + (r[2] + r[3]);
}
/// Of four faces, with the squares of the lengths of their normals.
MW_INLINE Symmetrics faceQuadrics(const Vectors& n, Float4 square)
{
    Float4 length, inverse;
    for (int k = 0; k < lanes; ++k) length[k] = std::sqrt(square[k]);
    for (int k = 0; k < lanes; ++k) inverse[k] = 1 / std::max(1e-30f, length[k]);
    const Float4 x = n.x * inverse, y = n.y * inverse, z = n.z * inverse, self = length * pull;
    return {n.x * x + self, n.x * y, n.x * z, n.y * y + self, n.y * z, n.z * z + self};
}

/// A list of vectors that is worked on four at a time, from any place.
template <int capacity>
struct VectorList {
    alignas(16) float x[capacity], y[capacity], z[capacity];

    MW_INLINE static Float4 load(const float* from)
    {
        Float4 v;
        __builtin_memcpy(&v, from, sizeof v);
        return v;
    }
    MW_INLINE Vectors from(int i) const { return {load(x + i), load(y + i), load(z + i)}; }
    MW_INLINE void set(int i, const Vectors& v)
    {
        __builtin_memcpy(x + i, &v.x, sizeof v.x);
        __builtin_memcpy(y + i, &v.y, sizeof v.y);
        __builtin_memcpy(z + i, &v.z, sizeof v.z);
    }
    MW_INLINE Float4 operator[](int i) const { return Float4{x[i], y[i], z[i], 0}; }
};

}  // namespace mw::quick
