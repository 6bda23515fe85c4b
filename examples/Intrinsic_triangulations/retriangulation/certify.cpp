// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips with doubles, then decides exactly whether the result is Delaunay: from integers and the
// input alone.

#include <CGAL/Intrinsic_triangulations.h>

#include <cstdlib>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;

int main(int argc, char* argv[]) {
  //! [certify]
  using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>,
                                                    IT::Integer_coordinates>;
  Triangulation t(IT::read_triangle_soup(argc > 1 ? argv[1] : "data/part.off"));
  IT::flip_to_delaunay(t);
  const IT::Delaunay_certificate doubles = IT::certify_delaunay(t);
  //! [certify]
  std::cout << "doubles: " << doubles.non_delaunay_edges << " edges are not Delaunay, "
            << doubles.ties << " are ties, " << doubles.inverted_faces << " faces are inverted\n";

  //! [integer only]
  IT::Integer_only_triangulation<> exact(t); // goes on from where doubles stopped
  const auto result = IT::flip_to_delaunay(exact);
  const bool is_delaunay = IT::certify_delaunay(exact).is_delaunay();
  //! [integer only]
  std::cout << "integers: " << result.flips << " more flips, "
            << (is_delaunay ? "Delaunay, certified\n" : "not Delaunay\n");
  return is_delaunay && result.flips >= doubles.non_delaunay_edges / 5 ? EXIT_SUCCESS
                                                                       : EXIT_FAILURE;
}
