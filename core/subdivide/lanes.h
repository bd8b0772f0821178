// Points four numbers at a time, for the loops in which subdivision spends its time.
#pragma once
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <glm/vec3.hpp>

#include "core/mesh/large_pages.h"

// Compiled several times, the right one is taken when the program starts. Sanitizers and clang do without.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define MW_LOOP_FOR_EACH_MACHINE __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define MW_LOOP_FOR_EACH_MACHINE
#endif

namespace mw::lanes {

typedef float Floats __attribute__((vector_size(16)));
typedef double Doubles __attribute__((vector_size(32)));
typedef long long Halves __attribute__((vector_size(16)));

/// A sum of a few points, rounded as they are themselves; the fourth number means nothing.
struct Sum {
    Floats v;
    glm::dvec3 point() const { return {double(v[0]), double(v[1]), double(v[2])}; }
};

/// Reads the float after the point, too: see paddedPoints(). Macros, as functions that return such a vector would be called differently on each
/// machine.
#define MW_LANES(target, point) \
    mw::lanes::Floats target;   \
    std::memcpy(&target, &(point), sizeof target);
// Number by number: g++ 12 makes one instruction of this, and four of __builtin_convertvector.
#define MW_DOUBLES(f) (mw::lanes::Doubles{double((f)[0]), double((f)[1]), double((f)[2]), double((f)[3])})
#define MW_FLOATS(lanesOfDoubles) __builtin_convertvector(lanesOfDoubles, mw::lanes::Floats)
#define MW_PUT_POINT(point, sum)                                        \
    {                                                                   \
        const mw::lanes::Floats mwFloats = MW_FLOATS(sum);              \
        const mw::lanes::Halves mwHalves = (mw::lanes::Halves)mwFloats; \
        const long long mwLow = mwHalves[0];                            \
        const float mwHigh = mwFloats[2];                               \
        std::memcpy(&(point), &mwLow, sizeof mwLow);                    \
        std::memcpy(&(point).z, &mwHigh, sizeof mwHigh);                \
    }

/// Not filled. Reading four floats at the last point stays within the memory.
inline Array<glm::vec3> paddedPoints(size_t n)
{
    Array<glm::vec3> a;
    a.reserve(n + 1);
    preferLargePages(a);
    a.resize(n + 1);
    a.back() = glm::vec3(0);
    a.pop_back();
    return a;
}

inline Array<Sum> zeroSums(size_t n)
{
    Array<Sum> a = largeArray<Sum>(n);
    if (n > 0) std::memset(static_cast<void*>(a.data()), 0, n * sizeof(Sum));
    return a;
}

/// Points in memory that goes on after the last one; copied when they are not.
class PaddedView {
public:
    explicit PaddedView(const Array<glm::vec3>& points) : points_(&points)
    {
        if (points.capacity() > points.size()) return;
        copy_ = paddedPoints(points.size());
        std::copy(points.begin(), points.end(), copy_.begin());
        points_ = &copy_;
    }
    PaddedView(const PaddedView&) = delete;
    PaddedView& operator=(const PaddedView&) = delete;
    const glm::vec3* data() const { return points_->data(); }
    const Array<glm::vec3>& points() const { return *points_; }

private:
    const Array<glm::vec3>* points_;
    Array<glm::vec3> copy_;
};

inline Array<glm::vec3> padded(std::span<const glm::vec3> points)
{
    Array<glm::vec3> a = paddedPoints(points.size());
    std::copy(points.begin(), points.end(), a.begin());
    return a;
}

/// The starts of n faces of `corners` each, and the end of the last.
inline Array<uint32_t> evenStarts(size_t n, uint32_t corners)
{
    Array<uint32_t> a = largeArray<uint32_t>(n + 1);
    for (size_t f = 0; f <= n; ++f) a[f] = uint32_t(f) * corners;
    return a;
}

}  // namespace mw::lanes
