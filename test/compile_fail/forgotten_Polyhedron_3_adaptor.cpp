// expect at once: for a Polyhedron_3 Polyhedron_3_adaptor.h
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// BGL knows a polyhedron, but its elements have no numbers without ids.

#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

int main() {
  const CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>> mesh;
  CGAL::Intrinsic_triangulations::Corresponding_triangulation t(mesh);
}
