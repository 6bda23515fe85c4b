// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Usage: nearest_sources [MESH.off]
// A sample of vertices far from each other, and which of them is the nearest to each vertex.

#include <CGAL/Intrinsic_geodesics.h>

#include <cstddef>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

int main(int argc, char** argv) {
  const IT::Corresponding_triangulation t(
      IT::read_triangle_soup(argc > 1 ? argv[1] : "data/part.off"));

  //! [farthest]
  IT::Polyhedral_distance distance(t, *vertices(t.mesh()).begin());
  const auto sample = IT::farthest_points(distance, 9); // now there are ten sources
  std::cout << "all vertices are within " << sample.radius << " of the sources\n";
  //! [farthest]

  //! [nearest]
  std::vector<std::size_t> sizes(distance.number_of_sources());
  for (const auto v : vertices(t.mesh())) ++sizes[distance.nearest_source(v)];
  //! [nearest]
  for (const std::size_t n : sizes) std::cout << n << " vertices\n";
  return 0;
}
