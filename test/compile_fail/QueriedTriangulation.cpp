// expect: satisfaction of .QueriedTriangulation<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh is on no other surface.

#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  locate_on_input(Gluing_map(), Surface_point{});
}
