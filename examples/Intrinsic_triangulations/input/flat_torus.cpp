// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds an abstract metric from a gluing and squared lengths alone: a flat torus of two triangles,
// one vertex and three edges, which embeds nowhere in space as it is.

#include <CGAL/Intrinsic_triangulations.h>

#include <iostream>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

int main() {
  //! [torus]
  // sides 0, 1, 2 of face 0 are glued to sides 0, 1, 2 of face 1: halfedge 3 f + k is side k of f
  IT::Gluing gluing;
  gluing.number_of_vertices = 1;
  gluing.origin = {0, 0, 0, 0, 0, 0};
  gluing.glue = {3, 4, 5, 0, 1, 2};
  // the parallelogram spanned by (1, 0) and (3, 1) with its diagonal (4, 1)
  IT::Intrinsic_input input(IT::Gluing_map(gluing), std::vector<double>{1, 10, 17});

  IT::Intrinsic_triangulation<> torus(std::move(input));
  IT::flip_to_delaunay(torus);
  //! [torus]
  std::cout << "squared lengths:";
  for (const auto e : edges(torus.mesh())) std::cout << ' ' << torus.squared_length(e);

  // the Delaunay tessellation of this torus is a square: its diagonal is an exact tie
  const auto report = IT::check_delaunay(torus);
  std::cout << "\ncocircular edges: " << report.cocircular_edges.size() << '\n';
  return report.cocircular_edges.size() == 1 && report.non_delaunay_edges == 0 ? 0 : 1;
}
