// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_METRIC_ANGLE_ENCLOSURES_H
#define CGAL_INTRINSIC_CONFORMAL_METRIC_ANGLE_ENCLOSURES_H

#include <CGAL/Intrinsic_conformal/angles/Ideal_surface.h>
#include <CGAL/Intrinsic_conformal/angles/Prescribed_angles.h>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// Enclosures of the angles at the corners opposite the sides of a triangle: a Euclidean one, or the
// hyperbolic one whose sides have lengths l with lambda = 2 sinh(l/2). The functions of the C
// library may err by four units in the last place: that of GNU documents one, for each direction of
// rounding.
// \param surplus see `surpluses()`
// \pre rounding is upwards
std::array<Interval_nt<false>, 3> enclosed_angles(const std::array<Interval_nt<false>, 3>& sides,
                                                  const std::array<Interval_nt<false>, 3>& surplus);
std::array<Interval_nt<false>, 3>
enclosed_hyperbolic_angles(const std::array<Interval_nt<false>, 3>& lambda,
                           const std::array<Interval_nt<false>, 3>& surplus);

// A bound of the differences between the angles at vertices and prescribed ones, in radians;
// nothing if the surface does not enclose values. It holds with the factors of the surface, and
// with those and u as they are rounded. An edge that is Delaunay with the former is nearly so with
// these: its flip would change angles by the square of the difference only.
// \param metric by which the surface is scaled
std::optional<double> proven_residual(const Ideal_surface& surface, const Conformal_metric& metric,
                                      const Prescribed_angles& angles, Geometry geometry);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_CONFORMAL_METRIC_ANGLE_ENCLOSURES_H
