// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_DEFAULTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_DEFAULTS_H

#include <CGAL/Intrinsic_triangulations/support/Report.h>

/*!
\file
What is done unless something else is asked for: one table for the options of the library, of the
program and of Python, with the names that they have in Python.

The least angle is 25 degrees and not 30, up to which refinement always ends: on eight meshes of
CGAL's data set 30 degrees take 1.9 to 4.3 times as many insertions. Directions are crosses, as only
even degrees can follow curvature.
*/

/// \cond
// clang-format off
#define CGAL_INTRINSIC_TRIANGULATIONS_DEFAULTS(is) \
  is(domain, "auto") \
  is(arithmetic, "exact") \
  is(mollification, "automatic") \
  is(polygons, "fan") \
  is(neighbors, 30) \
  is(min_angle, 25.) \
  is(order, "first") \
  is(tolerance, 0.01) \
  is(max_vertices, 100000) \
  is(mass_kind, "lumped") \
  is(transfer_method, "l2") \
  is(distance_method, "exact") \
  is(time_factor, 1.) \
  is(levels, 10) \
  is(curve_method, "exact") \
  is(map_method, "harmonic") \
  is(cut, "auto") \
  is(start, "delaunay") \
  is(degree, 4) \
  is(count, 10) \
  is(energy, "biharmonic") \
  is(removal_cost, "stretch")
// clang-format on
/// \endcond

namespace CGAL::Intrinsic_triangulations {

/// What is done unless something else is asked for.
namespace defaults {

/// \cond
#define CGAL_INTRINSIC_TRIANGULATIONS_DEFAULT(name, value) inline constexpr auto name = value;
CGAL_INTRINSIC_TRIANGULATIONS_DEFAULTS(CGAL_INTRINSIC_TRIANGULATIONS_DEFAULT)
#undef CGAL_INTRINSIC_TRIANGULATIONS_DEFAULT
/// \endcond

} // namespace defaults

/// reports all defaults by their names.
inline Report report_of_defaults() {
  Report report;
#define CGAL_INTRINSIC_TRIANGULATIONS_DEFAULT(name, value) report[#name] = value;
  CGAL_INTRINSIC_TRIANGULATIONS_DEFAULTS(CGAL_INTRINSIC_TRIANGULATIONS_DEFAULT)
#undef CGAL_INTRINSIC_TRIANGULATIONS_DEFAULT
  return report;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_DEFAULTS_H
