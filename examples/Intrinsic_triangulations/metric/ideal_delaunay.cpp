// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// An ideal Delaunay triangulation, decided exactly, for factors of vertices over eight powers of
// ten; then for factors of one again.

#include <CGAL/Intrinsic_triangulations.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

int main(int argc, char* argv[]) {
  //! [ideal]
  using Triangulation =
      IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_ideal_hyperbolic_traits,
                                  IT::Integer_coordinates>;
  Triangulation t(IT::read_triangle_soup(argc > 1 ? argv[1] : "data/part.off"));
  const auto first = IT::flip_to_delaunay(t);

  std::vector<double> factors(t.number_of_vertices()); // by row: the order of the file
  for (std::size_t v = 0; v < factors.size(); ++v)
    factors[v] = std::pow(10, 4 * std::sin(static_cast<double>(v)));
  t.scale_vertices(factors);
  const auto scaled = IT::flip_to_delaunay(t);
  const IT::Delaunay_certificate certificate = IT::certify_delaunay(t);
  //! [ideal]
  std::cout << first.flips << " flips, then " << scaled.flips << " with factors; "
            << (certificate.is_delaunay() ? "ideal Delaunay, certified\n" : "not Delaunay\n");

  //! [subdivision]
  const IT::Common_subdivision s = IT::common_subdivision(t);
  //! [subdivision]
  std::cout << s.number_of_faces() << " pieces of input faces\n";

  //! [back]
  t.scale_vertices(std::vector<double>(factors.size(), 1)); // exactly the metric of before
  const auto back = IT::flip_to_delaunay(t);
  //! [back]
  std::cout << back.flips << " flips back\n";
  return certificate.is_delaunay() && IT::certify_delaunay(t).is_delaunay() ? EXIT_SUCCESS
                                                                            : EXIT_FAILURE;
}
