// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGONS_POINT_KERNEL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGONS_POINT_KERNEL_H

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Filtered_predicate.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>

namespace CGAL::Intrinsic_triangulations::internal {

// Points with doubles and exact predicates, as those of
// `CGAL::Exact_predicates_inexact_constructions_kernel`, which takes five times as long to compile.
// Predicates are named here; global functions such as `CGAL::orientation()` would round.
struct Point_kernel : Simple_cartesian<double> {
  using Exact_kernel = Simple_cartesian<Gmpq>;
  using Approximate_kernel = Simple_cartesian<Interval_nt<false>>;
  using C2E = Cartesian_converter<Simple_cartesian<double>, Exact_kernel>;
  using C2F = Cartesian_converter<Simple_cartesian<double>, Approximate_kernel>;
  enum { Has_filtered_predicates = true };

  template <class Exact, class Approximate>
  using Exactly = Filtered_predicate<Exact, Approximate, C2E, C2F>;
  using Are_collinear = Exactly<Exact_kernel::Collinear_3, Approximate_kernel::Collinear_3>;
  using Find_orientation = Exactly<Exact_kernel::Orientation_3, Approximate_kernel::Orientation_3>;
  using Find_orientation_in_plane =
      Exactly<Exact_kernel::Coplanar_orientation_3, Approximate_kernel::Coplanar_orientation_3>;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGONS_POINT_KERNEL_H
