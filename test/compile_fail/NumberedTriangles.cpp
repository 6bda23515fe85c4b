// expect: satisfaction of .NumberedTriangles<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh gives halfedges, no numbers.

#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  const Gluing_map mesh;
  sides_of_face(mesh, 0);
}
