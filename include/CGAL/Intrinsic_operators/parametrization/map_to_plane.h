// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_MAP_TO_PLANE_H
#define CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_MAP_TO_PLANE_H

#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/harmonic_map.h>
#include <CGAL/Intrinsic_operators/parametrization/measure_distortion.h>
#include <CGAL/Intrinsic_operators/parametrization/parametrize.h>
#include <CGAL/Intrinsic_operators/parametrization/point_cloud_map.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/points_of_rows.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/defaults.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// How `map_to_plane()` maps a surface.
struct Map_options {
  Map_method method = Map_method::harmonic; ///< clouds of points have only `spectral`
  /// Whether edges stay as they are. Flips and splits of edges make harmonic maps injective; else
  /// they may not be.
  bool keeps_edges = false;
  Linear_solver solver = Linear_solver::automatic; ///< of linear problems
  /// Of each point of a cloud, see `conformal_map_of_points()`.
  std::size_t neighbors = defaults::neighbors;
  /// Is called with the number of rounds of a harmonic map, or of solutions of another; returns
  /// whether to go on.
  std::function<bool(std::uint64_t)> progress{};
};

/// A map to the plane, and what is known of it. Of a cloud of points, which has no faces, that is
/// nothing.
struct Map_to_plane : Injective_map {
  std::optional<Map_distortion> distortion{};  ///< none of a cloud
  std::optional<bool> is_injective_on_input{}; ///< on the triangles of the input; none of a cloud

  /// tells whether the surface has faces, so that the map has a certificate and a distortion.
  bool has_faces() const { return distortion.has_value(); }
};

namespace internal {

// Asks the caller of a map whether to go on.
struct Map_visitor {
  const Map_options* options;

  bool ask(std::uint64_t count) const { return !options->progress || options->progress(count); }
  bool progress(const Injective_map& map) const { return ask(map.rounds); }
  bool progress(std::size_t solutions) const { return ask(solutions); }
};

template <class Triangulation>
Injective_map map_as_asked(Triangulation& t, const Map_options& options) {
  const Map_visitor visitor{&options};
  if (options.method != Map_method::harmonic || !options.keeps_edges)
    return parametrize(t, options.method, options.solver, parameters::visitor(visitor));
  if (!visitor.ask(0)) return {Status::cancelled, {}, {}};
  Injective_map map = certified_map(t, harmonic_map(t, options.solver)); // in one round
  if (!visitor.ask(1)) return {Status::cancelled, {}, {}};
  return map;
}

} // namespace internal

/*!
\brief maps a surface to the plane as `parametrize()` does, and measures the map; a cloud of points
as `conformal_map_of_points()` does.
\tparam Triangulation a model of `RefinableTriangulation` and of `CorrespondingTriangulation`
\param t the triangulation, of one or several disks: see `cut_to_disks()`. Harmonic maps are made
  injective by flips and splits of edges
\param points where the user's vertices are; only clouds of points need them
\param options how
\return the map; `cancelled` without points
\throws Invalid_input as these functions do, or if the method does not suit a cloud
\complexity that of the map, of its certificate, and linear
*/
template <RefinableTriangulation Triangulation>
  requires QueriedTriangulation<Triangulation>
      Map_to_plane map_to_plane(Triangulation& t, const std::vector<std::array<double, 3>>& points,
                                const Map_options& options = {}) {
    if (t.input().names().is_cloud()) {
      if (options.method != Map_method::spectral)
        throw Invalid_input(Element_kind::none, 0,
                            "for a cloud of points only --method spectral works");
      internal::expect_factor_of_spectral_map(options.solver);
      Map_to_plane map;
      map.uv = conformal_map_of_points(points_of_rows(t, points), options.neighbors,
                                       parameters::visitor(internal::Map_visitor{&options}));
      if (map.uv.rows() == 0) map.status = Status::cancelled;
      return map;
    }
    Map_to_plane map{internal::map_as_asked(t, options)};
    if (map.status == Status::cancelled) return map;
    map.distortion = measure_distortion(t, map.uv);
    map.is_injective_on_input = certify_map(t.input(), map.uv).is_injective();
    return map;
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_MAP_TO_PLANE_H
