// expect: satisfaction of .MeasuredTriangulation<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A triangulation that stores no lengths has no cotangents.

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  const Integer_only_triangulation<>* t = nullptr;
  cotangent_laplacian(*t);
}
