// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A user's program: flips a flat torus exactly, which needs what the library links.

#include "checks.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/is_delaunay.h>

#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

bool expect(bool condition, const char* what) {
  if (!condition) std::cerr << "failed: " << what << '\n';
  return condition;
}

// the lattice of (1, 0) and (3, 1), that of the integers: all squares, diagonals are exact ties
bool check_torus() {
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

} // namespace

int main() {
  bool good = expect(check_torus(), "torus");
#ifdef DOWNSTREAM_HAS_everything
  good &= expect(check_everything(), "everything");
#endif
#ifdef DOWNSTREAM_HAS_operators
  good &= expect(check_operators(), "operators");
#endif
#ifdef DOWNSTREAM_HAS_openmesh
  good &= expect(check_openmesh(), "openmesh");
#endif
  return good ? 0 : 1;
}
