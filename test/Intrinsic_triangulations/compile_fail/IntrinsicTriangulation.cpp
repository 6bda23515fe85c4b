// expect: satisfaction of .IntrinsicTriangulation<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh without a metric has no Delaunay triangulation.

#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/is_delaunay.h>

int main() {
  CGAL::Intrinsic_triangulations::Gluing_map mesh;
  return CGAL::Intrinsic_triangulations::is_delaunay(mesh);
}
