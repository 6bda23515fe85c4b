// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Usage: distance_batches [MESH.off]
// The distances from every hundredth vertex to all vertices, and those of some pairs.

#include <CGAL/Intrinsic_geodesics.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <span>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

int main(int argc, char** argv) {
  const IT::Corresponding_triangulation t(
      IT::read_triangle_soup(argc > 1 ? argv[1] : "data/part.off"));
  using Vertex = decltype(t)::vertex_descriptor;
  const std::vector<Vertex> all(vertices(t.mesh()).begin(), vertices(t.mesh()).end());

  //! [batch]
  std::vector<Vertex> sources; // each is a set of one; a vector of vectors has sets of many
  for (std::size_t i = 0; i < all.size(); i += 100) sources.push_back(all[i]);
  std::vector<float> matrix(t.number_of_vertices() * sources.size()); // a column per set
  IT::polyhedral_distances(t, sources, std::span(matrix));
  //! [batch]
  std::cout << sources.size() << " columns, greatest distance " << std::ranges::max(matrix) << '\n';

  //! [pairs]
  const std::vector<Vertex> from(3, all.front()), to{all[1], all[all.size() / 2], all.back()};
  for (const double d : IT::pair_distances(t, from, to)) std::cout << d << '\n';
  //! [pairs]
  return 0;
}
