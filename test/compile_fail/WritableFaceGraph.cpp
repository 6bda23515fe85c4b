// expect: satisfaction of .WritableFaceGraph<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A constant mesh is not built.

#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  const Gluing_map mesh;
  copy_gluing_map(mesh, mesh);
}
