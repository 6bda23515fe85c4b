// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Changes the lengths of a mesh with a very thin needle so that doubles can compute with them, and
// prints the smallest angle before and after.

#include <CGAL/Intrinsic_triangulations.h>

#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>; // not exact

int main() {
  // a square with a vertex 1e-13 away from one of its corners
  IT::Triangle_soup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1e-13, 1e-14, 0}};
  soup.triangles = {{0, 1, 4}, {4, 1, 2}, {4, 2, 3}, {0, 4, 3}};

  //! [amount]
  IT::Intrinsic_input input(soup, IT::Mollification::nearly_degenerate);
  input.mollification_amount = 1e-4; // of the mean edge: by so much triangle inequalities hold
  const Triangulation t(input);
  const IT::Mollification_report done = t.report().mollification; // what was added to all lengths
  //! [amount]

  const Triangulation before(IT::Intrinsic_input(soup, IT::Mollification::none));
  std::cout << "added " << done.delta << " to all lengths\nsmallest angle, in degrees: "
            << IT::measure_quality(before).minimum_angle << ", now "
            << IT::measure_quality(t).minimum_angle << '\n';
  return done.kind == IT::Mollification::lengths && done.delta > 0 && done.delta < 1e-3 ? 0 : 1;
}
