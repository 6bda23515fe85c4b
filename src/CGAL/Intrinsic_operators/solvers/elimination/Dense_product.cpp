// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/elimination/Dense_product.h>

#include <cstring>

// A processor with AVX2 computes four products at a time, even if the library is compiled for all
// processors. No operations are fused, so that results are the same on all of them.
#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__clang__)
#define CGAL_INTRINSIC_CLONES_FOR_AVX2 __attribute__((target_clones("avx2", "default")))
#else
#define CGAL_INTRINSIC_CLONES_FOR_AVX2
#endif

namespace CGAL::Intrinsic_triangulations::internal {

using Quad __attribute__((vector_size(32))) = double;

CGAL_INTRINSIC_CLONES_FOR_AVX2
void Dense_product::multiply(const double* left, const double* right, int depth, double* sums) {
  Quad upper[columns]{}, lower[columns]{};
  for (int k = 0; k < depth; ++k, left += rows, right += columns) {
    Quad x, y;
    std::memcpy(&x, left, sizeof x);
    std::memcpy(&y, left + rows / 2, sizeof y);
    upper[0] += x * right[0]; // no loop, so that sums stay in registers
    lower[0] += y * right[0];
    upper[1] += x * right[1];
    lower[1] += y * right[1];
    upper[2] += x * right[2];
    lower[2] += y * right[2];
    upper[3] += x * right[3];
    lower[3] += y * right[3];
  }
  for (int c = 0; c < columns; ++c, sums += rows) {
    std::memcpy(sums, &upper[c], sizeof upper[c]);
    std::memcpy(sums + rows / 2, &lower[c], sizeof lower[c]);
  }
}

CGAL_INTRINSIC_CLONES_FOR_AVX2
void Dense_panel::add(const Columns& column, const double* factor, std::ptrdiff_t rows,
                      double* to) {
  const double f0 = factor[0], f1 = factor[1], f2 = factor[2], f3 = factor[3];
  const double *c0 = column[0], *c1 = column[1], *c2 = column[2], *c3 = column[3];
  std::ptrdiff_t i = 0;
  for (; i + 4 <= rows; i += 4) {
    Quad x0, x1, x2, x3, y;
    std::memcpy(&x0, c0 + i, sizeof x0);
    std::memcpy(&x1, c1 + i, sizeof x1);
    std::memcpy(&x2, c2 + i, sizeof x2);
    std::memcpy(&x3, c3 + i, sizeof x3);
    std::memcpy(&y, to + i, sizeof y);
    y += (x0 * f0 + x1 * f1) + (x2 * f2 + x3 * f3);
    std::memcpy(to + i, &y, sizeof y);
  }
  for (; i < rows; ++i) to[i] += (c0[i] * f0 + c1[i] * f1) + (c2[i] * f2 + c3[i] * f3);
}

CGAL_INTRINSIC_CLONES_FOR_AVX2
std::ptrdiff_t Dense_panel::sum(const Columns& column, const double* vector, std::ptrdiff_t rows,
                                double* sums) {
  const double *c0 = column[0], *c1 = column[1], *c2 = column[2], *c3 = column[3];
  Quad s0{}, s1{}, s2{}, s3{};
  std::ptrdiff_t i = 0;
  for (; i + 4 <= rows; i += 4) {
    Quad x0, x1, x2, x3, y;
    std::memcpy(&x0, c0 + i, sizeof x0);
    std::memcpy(&x1, c1 + i, sizeof x1);
    std::memcpy(&x2, c2 + i, sizeof x2);
    std::memcpy(&x3, c3 + i, sizeof x3);
    std::memcpy(&y, vector + i, sizeof y);
    s0 += x0 * y;
    s1 += x1 * y;
    s2 += x2 * y;
    s3 += x3 * y;
  }
  std::memcpy(sums, &s0, sizeof s0);
  std::memcpy(sums + 4, &s1, sizeof s1);
  std::memcpy(sums + 8, &s2, sizeof s2);
  std::memcpy(sums + 12, &s3, sizeof s3);
  return i;
}

} // namespace CGAL::Intrinsic_triangulations::internal
