// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_CONFORMAL_DISKS_H
#define INTRINSIC_APPLICATION_CONFORMAL_DISKS_H

#include "../status_name.h"
#include "application.h"
#include "conformal_layout.h"

#include <CGAL/Intrinsic_operators/conformal/conformal_metric.h>
#include <CGAL/Intrinsic_operators/conformal/flat_angles.h>
#include <CGAL/Intrinsic_operators/conformal/flat_surface.h>
#include <CGAL/Intrinsic_operators/conformal/lay_out_scaled.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace program {

/// returns the double of a surface before the first move, with its vertices in the order of the
/// file, as the start of an ideal hyperbolic triangulation.
/// \throws std::runtime_error if it does not consist of disks
IT::Intrinsic_input ideal_double(const IT::Input& surface);

/// returns u and v of a layout of disks at each vertex of the file, and facts about the metric.
Computed computed_of(const IT::Conformal_metric& metric, Laid_out laid_out, std::size_t vertices,
                     Json json);

/*!
\brief maps disks to the plane with full turns at the vertices inside, and scale 1 on the border.
\tparam Triangulation a triangulation with Euclid's metric
\param t the triangulation, the input of which is mapped
\param points where the vertices of the mesh are
\throws std::runtime_error if the input does not consist of disks
*/
template <class Triangulation>
Computed conformal_map_of_disks(const Triangulation& t, const Points& points) {
  using Traits =
      std::conditional_t<Triangulation::Metric::is_exact, IT::Exact_ideal_hyperbolic_traits,
                         IT::Ideal_hyperbolic_traits<double>>;
  IT::Intrinsic_triangulation<IT::Gluing_map, Traits, IT::Integer_coordinates> ideal(
      ideal_double(t.input()));
  IT::Flat_surface start = IT::flat_surface(ideal);
  const IT::Prescribed_angles angles = IT::flat_angles(ideal);
  const IT::Conformal_metric metric = IT::conformal_metric(ideal, angles);
  Json json;
  Laid_out laid_out = shown_layout(
      IT::lay_out_scaled(IT::scaled_surface(ideal, std::move(start), metric.scale_factors, angles,
                                            ideal.input().names())),
      points, json);
  return computed_of(metric, std::move(laid_out), t.number_of_vertices(), std::move(json));
}

} // namespace program

#endif // INTRINSIC_APPLICATION_CONFORMAL_DISKS_H
