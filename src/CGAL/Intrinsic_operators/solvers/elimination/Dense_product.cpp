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

// Reads four rows of each column. It is inlined, so that it takes the instructions of its caller.
[[gnu::always_inline]] static inline void
load_rows(const Dense_panel::Columns& column, std::ptrdiff_t i, Quad (&x)[Dense_panel::columns]) {
  std::memcpy(&x[0], column[0] + i, sizeof x[0]);
  std::memcpy(&x[1], column[1] + i, sizeof x[1]);
  std::memcpy(&x[2], column[2] + i, sizeof x[2]);
  std::memcpy(&x[3], column[3] + i, sizeof x[3]);
}

CGAL_INTRINSIC_CLONES_FOR_AVX2
void Dense_panel::add(const Columns& column, const double* factor, std::ptrdiff_t rows,
                      double* to) {
  const double f0 = factor[0], f1 = factor[1], f2 = factor[2], f3 = factor[3];
  const Columns c = column; // which no store to the vector may change
  std::ptrdiff_t i = 0;
  for (; i + 4 <= rows; i += 4) {
    Quad x[columns], y;
    load_rows(c, i, x);
    std::memcpy(&y, to + i, sizeof y);
    y += (x[0] * f0 + x[1] * f1) + (x[2] * f2 + x[3] * f3);
    std::memcpy(to + i, &y, sizeof y);
  }
  for (; i < rows; ++i) to[i] += (c[0][i] * f0 + c[1][i] * f1) + (c[2][i] * f2 + c[3][i] * f3);
}

CGAL_INTRINSIC_CLONES_FOR_AVX2
std::ptrdiff_t Dense_panel::sum(const Columns& column, const double* vector, std::ptrdiff_t rows,
                                double* sums) {
  Quad s0{}, s1{}, s2{}, s3{};
  std::ptrdiff_t i = 0;
  for (; i + 4 <= rows; i += 4) {
    Quad x[columns], y;
    load_rows(column, i, x);
    std::memcpy(&y, vector + i, sizeof y);
    s0 += x[0] * y;
    s1 += x[1] * y;
    s2 += x[2] * y;
    s3 += x[3] * y;
  }
  std::memcpy(sums, &s0, sizeof s0);
  std::memcpy(sums + 4, &s1, sizeof s1);
  std::memcpy(sums + 8, &s2, sizeof s2);
  std::memcpy(sums + 12, &s3, sizeof s3);
  return i;
}

} // namespace CGAL::Intrinsic_triangulations::internal
