// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <cmath>
#include <utility>
#include <vector>

// Flips a flat torus exactly: the lattice of (1, 0) and (3, 1), that of the integers: all squares, diagonals are exact ties
bool check_torus() {
  namespace IT = CGAL::Intrinsic_triangulations;
  IT::Gluing gluing;
  gluing.number_of_vertices = 1;
  gluing.origin = {0, 0, 0, 0, 0, 0};
  gluing.glue = {3, 4, 5, 0, 1, 2};
  IT::Intrinsic_input input(IT::Gluing_map(gluing), std::vector<double>{1, 10, 17});
  IT::Intrinsic_triangulation<> torus(std::move(input));
  const IT::Flip_to_delaunay_result result = IT::flip_to_delaunay(torus);
  double sum = 0;
  for (const auto e : edges(torus.mesh())) sum += torus.squared_length(e);
  const auto report = IT::check_delaunay(torus);
  return result.flips > 0 && std::abs(sum - (1 + 1 + 2)) < 1e-12 &&
         report.cocircular_edges.size() == 1 && report.non_delaunay_edges == 0;
}
