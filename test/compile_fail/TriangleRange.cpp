// expect: satisfaction of .TriangleRange<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers of vertices that are not in triples are no triangles.

#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>

#include <vector>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  gluing_from_triangles(3, std::vector<int>{0, 1, 2});
}
