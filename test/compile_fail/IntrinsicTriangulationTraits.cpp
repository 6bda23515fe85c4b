// expect: satisfaction of .IntrinsicTriangulationTraits<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A number type is not yet a traits class.

#include <CGAL/Intrinsic_triangulation.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  Intrinsic_triangulation<Gluing_map, double>* none = nullptr;
  return none != nullptr;
}
