// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Dense_product.h>

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

} // namespace CGAL::Intrinsic_triangulations::internal
