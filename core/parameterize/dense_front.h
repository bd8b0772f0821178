// Dense kernels of the sparse direct solver. Matrices are stored by columns.
#pragma once
#include <cstddef>

namespace mw {

/// Doubles that may be read (never written) behind a matrix of own columns.
inline constexpr size_t frontPadding = 8;

/// Cholesky of the first `own` columns of a front of `rows` rows: on return they hold L, with the inverses of its entries on the diagonal. Above
/// the diagonal there is nothing of use. False when a pivot is not above 0; `failed` is its column.
bool factorColumns(double* columns, size_t rows, size_t own, size_t& failed);
/// LU without pivoting: `lower` becomes the columns of L (unit diagonal) with the inverse pivots on its diagonal, `upper` holds and becomes the rows
/// of U, each as a column. False when a pivot is 0 or no number.
bool factorColumns(double* lower, double* upper, size_t rows, size_t own, size_t& failed);

/// C[i, j] -= sum over p < depth of A[i, p] B[j, p] for a C of `rows` x `columns`, `cStride` entries a column; A and B have `stride`.
/// `lower`: only i >= j is of use. `set`: from C = 0, whatever it holds. Parts of C may be done in any order or at once, the result is the same.
void subtractProduct(double* c, size_t cStride, size_t rows, size_t columns, const double* a, const double* b, size_t stride, size_t depth,
                     bool lower, bool set = false);

/// Substitution in a front for two right sides: x and y have `rows` entries, the first `own` are solved, forward() takes their part from the others.
void forwardFront(const double* lower, size_t rows, size_t own, bool unit, double* x, double* y);
void backwardFront(const double* upper, const double* diagonal, size_t rows, size_t own, double* x, double* y);

}  // namespace mw
