// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_VORONOI_CENTRES_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_VORONOI_CENTRES_H

#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <Eigen/Core>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds points on a surface, each the centre of the vertices that are nearest to it.
*/
struct Voronoi_centres {
  std::vector<Surface_point> sites; ///< the points
  /// Of each vertex, by the numbers of a `Tangent_field`, the nearest site; `Gluing::none` on components without one.
  std::vector<std::uint32_t> cell;
  double largest_move = 0; ///< by which a site moved in the last step
  std::size_t steps = 0;   ///< number of steps
  Status status =
      Status::done; ///< `cap`: sites still moved in the last step; `cancelled` by the caller
};

namespace internal {

// The nearest of several sites for each vertex: that from which most heat comes.
template <class Triangulation>
std::vector<std::uint32_t> voronoi_cells(const Vector_heat_method<Triangulation>& heat,
                                         const std::vector<Surface_point>& sites) {
  Eigen::VectorXd most;
  std::vector<std::uint32_t> cell(heat.relative_areas().size(), Gluing::none);
  for (std::uint32_t s = 0; s < sites.size(); ++s) {
    const Eigen::VectorXd from = heat.log_heat(sites[s]);
    if (s == 0)
      most = Eigen::VectorXd::Constant(from.size(), -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      if (!(from[k] > most[k])) continue;
      most[k] = from[k];
      cell[i] = s;
    }
  }
  return cell;
}

} // namespace internal

/*!
\brief moves points on a surface to the centres of their cells (Lloyd's method, as in §8.4 of Sharp et al. 2019): a sampling that is even.

Each step finds the vertices nearest to each site, and moves the site along the mean of the vectors to them, weighted by area. Sites at vertices are moved by a
thousandth of an edge.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param heat logarithmic maps on the triangulation
\param sites points of it, where to start
\param maximum_steps the number of steps
\param tolerance the move of all sites at which to stop, in mean lengths of edges
\param progress is called with what was reached before each step, if given; tells whether to go on
\return the sites and their cells
\throws std::invalid_argument if there are no sites
\complexity for each step and site, that of a logarithmic map and of solving with a factored matrix
*/
template <internal::Connected_triangulation Triangulation>
Voronoi_centres voronoi_centres(const Vector_heat_method<Triangulation>& heat,
                                std::vector<Surface_point> sites, std::size_t maximum_steps = 20,
                                double tolerance = 0.01,
                                const std::function<bool(const Voronoi_centres&)>& progress = {}) {
  if (sites.empty()) throw std::invalid_argument("there must be a site");
  for (Surface_point& p : sites) p = internal::off_vertex(p);
  Voronoi_centres result{std::move(sites), {}, 0, 0, Status::done};
  result.cell = internal::voronoi_cells(heat, result.sites);
  const std::vector<double>& areas = heat.relative_areas();
  result.status = Status::cap;
  while (result.steps < maximum_steps) {
    if (progress && !progress(result)) {
      result.status = Status::cancelled;
      break;
    }
    result.largest_move = 0;
    for (std::uint32_t s = 0; s < result.sites.size(); ++s) {
      const std::vector<std::complex<double>> log =
          heat.logarithmic_map(result.sites[s], Logarithm_method::affine);
      std::complex<double> sum = 0;
      double area = 0;
      for (std::size_t i = 0; i < log.size(); ++i) {
        if (result.cell[i] != s || !internal::is_known(log[i])) continue;
        sum += areas[i] * log[i];
        area += areas[i];
      }
      if (!(area > 0)) continue; // between the vertices of other cells
      const Geodesic g = exponential_map(heat.triangulation(), result.sites[s], sum / area);
      result.sites[s] = internal::off_vertex(g.points.back());
      result.largest_move = std::max(result.largest_move, g.length);
    }
    result.cell = internal::voronoi_cells(heat, result.sites);
    ++result.steps;
    if (result.largest_move > tolerance * heat.mean_edge_length()) continue;
    result.status = Status::done;
    break;
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_VORONOI_CENTRES_H
