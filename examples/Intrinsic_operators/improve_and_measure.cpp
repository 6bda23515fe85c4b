// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Usage: improve_and_measure [MESH.off]
// Flips and refines in one call, as the program `intrinsic refine` does, and measures the result.

#include <CGAL/Intrinsic_operators.h>

#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;

int main(int argc, char** argv) {
  IT::Corresponding_triangulation t(IT::read_triangle_soup(argc > 1 ? argv[1] : "data/part.off"));

  //! [improve]
  IT::Improve_options options;
  options.refine.emplace().minimum_angle = 25;
  const IT::Improvement done = IT::improve(t, options);
  const IT::Measurements measured = IT::measure(t);
  //! [improve]
  std::cout << done.flips.flips << " flips, " << done.refined->points
            << " vertices more, angles from " << measured.quality.minimum_angle << " degrees, "
            << done.refined->unsatisfied_faces() << " faces cannot have more\n";
  return measured.edges.non_delaunay == 0 ? 0 : 1;
}
