// expect: satisfaction of .NumberedTriangulation<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh has places, but no input that it was built from.

#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  Gluing_map mesh;
  point_in_space(mesh, Surface_point{}, mesh);
}
