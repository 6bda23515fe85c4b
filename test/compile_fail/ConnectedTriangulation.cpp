// expect: satisfaction of .ConnectedTriangulation<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Integers have no angles to transport vectors by.

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_operators/operators/connection_laplacian.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  const Integer_only_triangulation<>* t = nullptr;
  connection_laplacian(*t);
}
