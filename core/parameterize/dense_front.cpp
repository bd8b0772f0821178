// Written for vectors of eight doubles that the compiler cuts to what the machine has. Every entry is summed in the same order whatever the width,
// so results do not depend on the machine.
#include "core/parameterize/dense_front.h"

#include <algorithm>
#include <cmath>

// Compiled several times, the right one is taken when the program starts. Sanitizers and clang do without.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define MW_FOR_EACH_MACHINE __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define MW_FOR_EACH_MACHINE
#endif

namespace mw {
namespace {

constexpr size_t width = 8, tileColumns = 6, panel = 8;
using Lane = double __attribute__((vector_size(64), aligned(8), may_alias));

/// C[i, j] and what belongs to it, for eight rows and six columns or as many of them as there are.
struct Tile {
    double* c;
    size_t cStride;
    const double *a, *b;
    size_t stride, depth, high, wide;
    bool set;  ///< C is not read
};

// Eight rows of A and six of B are read always: six sums in flight, which fill the sixteen registers of half their width.
[[gnu::always_inline]] inline void subtract(const Tile& t)
{
    Lane sums[tileColumns] = {};
    const double *a = t.a, *b = t.b;
    for (size_t p = 0; p < t.depth; ++p, a += t.stride, b += t.stride) {
        const Lane v = *reinterpret_cast<const Lane*>(a);
#pragma GCC unroll 6
        for (size_t j = 0; j < tileColumns; ++j) sums[j] += v * b[j];
    }
    if (t.high >= width && t.wide >= tileColumns) {
#pragma GCC unroll 6
        for (size_t j = 0; j < tileColumns; ++j) {
            Lane& c = *reinterpret_cast<Lane*>(t.c + j * t.cStride);
            c = t.set ? -sums[j] : c - sums[j];
        }
        return;
    }
    const Lane rest[tileColumns] = {sums[0], sums[1], sums[2], sums[3], sums[4], sums[5]};  // so that the sums stay in registers
    for (size_t j = 0; j < std::min(t.wide, tileColumns); ++j)
        for (size_t i = 0; i < std::min(t.high, width); ++i) {
            double& c = t.c[j * t.cStride + i];
            c = t.set ? -rest[j][i] : c - rest[j][i];
        }
}

/// Columns first..last by each other, over all rows below the diagonal.
MW_FOR_EACH_MACHINE bool factorPanel(double* l, size_t rows, size_t first, size_t last, size_t& failed)
{
    for (size_t j = first; j < last; ++j) {
        double* column = l + j * rows;
        const double pivot = column[j];
        if (!(pivot > 0) || !std::isfinite(pivot)) {
            failed = j;
            return false;
        }
        const double inverse = 1 / std::sqrt(pivot);
        for (size_t i = j + 1; i < rows; ++i) column[i] *= inverse;
        column[j] = inverse;
        for (size_t c = j + 1; c < last; ++c) {
            double* other = l + c * rows;
            const double f = column[c];
            for (size_t i = c; i < rows; ++i) other[i] -= f * column[i];
        }
    }
    return true;
}

MW_FOR_EACH_MACHINE bool factorPanel(double* l, double* u, size_t rows, size_t first, size_t last, size_t& failed)
{
    for (size_t j = first; j < last; ++j) {
        double *lower = l + j * rows, *upper = u + j * rows;
        const double inverse = 1 / lower[j];
        if (!std::isfinite(inverse)) {
            failed = j;
            return false;
        }
        for (size_t i = j + 1; i < rows; ++i) lower[i] *= inverse;
        lower[j] = inverse;
        for (size_t c = j + 1; c < last; ++c) {
            double *otherLower = l + c * rows, *otherUpper = u + c * rows;
            const double fromUpper = upper[c], fromLower = lower[c];
            for (size_t i = c; i < rows; ++i) otherLower[i] -= fromUpper * lower[i];
            for (size_t i = c + 1; i < rows; ++i) otherUpper[i] -= fromLower * upper[i];
        }
    }
    return true;
}

}  // namespace

MW_FOR_EACH_MACHINE void subtractProduct(double* c, size_t cStride, size_t rows, size_t columns, const double* a, const double* b, size_t stride,
                                         size_t depth, bool lower, bool set)
{
    for (size_t j = 0; j < columns; j += tileColumns)
        for (size_t i = lower ? j : 0; i < rows; i += width)
            subtract({c + j * cStride + i, cStride, a + i, b + j, stride, depth, rows - i, columns - j, set});
}

bool factorColumns(double* l, size_t rows, size_t own, size_t& failed)
{
    for (size_t j = 0; j < own; j += panel) {
        const size_t next = std::min(j + panel, own);
        if (!factorPanel(l, rows, j, next, failed)) return false;
        const double* done = l + j * rows + next;
        subtractProduct(l + next * rows + next, rows, rows - next, own - next, done, done, rows, next - j, true);
    }
    return true;
}

bool factorColumns(double* l, double* u, size_t rows, size_t own, size_t& failed)
{
    for (size_t j = 0; j < own; j += panel) {
        const size_t next = std::min(j + panel, own), done = j * rows + next, rest = next * rows + next;
        if (!factorPanel(l, u, rows, j, next, failed)) return false;
        if (next == own) break;
        subtractProduct(l + rest, rows, rows - next, own - next, l + done, u + done, rows, next - j, true);
        subtractProduct(u + rest, rows, rows - next, own - next, u + done, l + done, rows, next - j, true);
    }
    return true;
}

MW_FOR_EACH_MACHINE void forwardFront(const double* lower, size_t rows, size_t own, bool unit, double* x, double* y)
{
    for (size_t p = 0; p < own; ++p) {
        const double* column = lower + p * rows;
        if (!unit) {
            x[p] *= column[p];
            y[p] *= column[p];
        }
        const double fx = x[p], fy = y[p];
        for (size_t i = p + 1; i < rows; ++i) {
            x[i] -= column[i] * fx;
            y[i] -= column[i] * fy;
        }
    }
}

MW_FOR_EACH_MACHINE void backwardFront(const double* upper, const double* diagonal, size_t rows, size_t own, double* x, double* y)
{
    for (size_t p = own; p-- > 0;) {
        const double* column = upper + p * rows;
        Lane sx{}, sy{};
        size_t i = p + 1;
        for (; i + width <= rows; i += width) {
            const Lane v = *reinterpret_cast<const Lane*>(column + i);
            sx += v * *reinterpret_cast<const Lane*>(x + i);
            sy += v * *reinterpret_cast<const Lane*>(y + i);
        }
        double ax = 0, ay = 0;
        for (; i < rows; ++i) {
            ax += column[i] * x[i];
            ay += column[i] * y[i];
        }
        for (size_t k = 0; k < width; ++k) {
            ax += sx[k];
            ay += sy[k];
        }
        const double inverse = diagonal[p * rows + p];
        x[p] = (x[p] - ax) * inverse;
        y[p] = (y[p] - ay) * inverse;
    }
}

}  // namespace mw
