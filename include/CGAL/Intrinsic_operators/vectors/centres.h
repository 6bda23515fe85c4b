// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_CENTRES_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_CENTRES_H

#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <Eigen/Core>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds the centre of points on a surface.
*/
struct Karcher_mean {
  Surface_point point;   ///< where it is
  double residual = 0;   ///< length of the mean of the vectors to the points, zero at a centre
  double energy = 0;     ///< mean of the squared distances
  std::size_t steps = 0; ///< number of logarithmic maps
  Status status =
      Status::done; ///< `cap`: the number of steps did not suffice; `cancelled` by the caller
};

namespace internal {

// Points with weights, and their mean as seen from a point.
template <class Triangulation>
class Weighted_points {
public:
  using Points = std::vector<std::pair<Surface_point, double>>;

  Weighted_points(const Vector_heat_method<Triangulation>& heat, const Points& points)
      : heat_(heat), points_(points) {
    for (const auto& [p, w] : points) {
      if (!(w >= 0) || !std::isfinite(w))
        throw std::invalid_argument("the weights of points must be finite and not negative");
      all_ += w;
      if (w > greatest_) heaviest_ = p, greatest_ = w;
    }
    if (!(greatest_ > 0))
      throw std::invalid_argument("there must be a point with a positive weight");
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points[i].second > 0 && !heat.are_connected(points[i].first, heaviest_))
        throw std::invalid_argument(
            "point " + std::to_string(i) +
            " is not on the component of the heaviest point, so the points have no mean; give the "
            "points of one component");
  }

  // the one of greatest weight
  const Surface_point& heaviest() const { return heaviest_; }

  // the mean of the vectors from a point, and of their squared lengths
  std::complex<double> mean(const Surface_point& from, double& energy) const {
    const std::vector<std::complex<double>> log =
        heat_.logarithmic_map(from, Logarithm_method::affine);
    std::complex<double> sum = 0;
    energy = 0;
    for (const auto& [q, w] : points_) {
      const std::complex<double> z = heat_.logarithm_at(log, from, q);
      if (w == 0 || !is_known(z)) continue; // on another component, or beyond all directions
      sum += w / all_ * z;
      energy += w / all_ * std::norm(z);
    }
    return sum;
  }

private:
  const Vector_heat_method<Triangulation>& heat_;
  const Points& points_;
  double all_ = 0, greatest_ = 0;
  Surface_point heaviest_;
};

} // namespace internal

/*!
\brief finds the centre of points on a surface: a point where the mean of the vectors to them
vanishes, a local minimum of the mean of squared distances.

It starts at the point of greatest weight; each step goes along that mean as far as the energy
falls. Points at vertices move by a thousandth of an edge first.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param heat logarithmic maps on the triangulation
\param points points of it, and their weights
\param np optional named parameters:
  - `tolerance(x)`: the residual to reach, in mean lengths of edges. Default: 1e-4.
  - `maximum_rounds(n)`: the number of steps after which to give up. Default: 50.
  - `visitor(v)`: `v.progress(mean)` is called with the `Karcher_mean` so far after each logarithmic
    map but the last, and returns whether to go on.
\return the centre
\throws std::invalid_argument if there are no points, a weight is negative or not finite, or all are
  zero, or points of positive weight are on different components of the surface
\complexity for each step, that of a logarithmic map and of tracing a geodesic
*/
template <ConnectedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Karcher_mean karcher_mean(const Vector_heat_method<Triangulation>& heat,
                          const std::vector<std::pair<Surface_point, double>>& points,
                          const NP& np = parameters::default_values()) {
  namespace tags = internal::tags;
  internal::expect_names<tags::tolerance, tags::maximum_rounds, tags::visitor>(np);
  const auto maximum_steps = internal::value_or<tags::maximum_rounds>(np, std::size_t{50});
  auto visitor = internal::object_or<tags::visitor>(np, internal::Silent_visitor());
  const internal::Weighted_points<Triangulation> seen(heat, points);
  Karcher_mean mean;
  mean.point = internal::off_vertex(seen.heaviest());
  std::complex<double> step = seen.mean(mean.point, mean.energy);
  mean.residual = std::abs(step);
  const double enough = internal::value_or<tags::tolerance>(np, 1e-4) * heat.mean_edge_length();
  double part = 1; // of the step; below it, errors of logarithmic maps dominate the energy
  for (mean.steps = 1; mean.residual > enough && part >= 0x1p-10; ++mean.steps) {
    if (mean.steps >= maximum_steps) {
      mean.status = Status::cap;
      break;
    }
    if (!internal::unwrapped(visitor).progress(std::as_const(mean))) {
      mean.status = Status::cancelled;
      break;
    }
    const Surface_point there = internal::off_vertex(
        exponential_map(heat.triangulation(), mean.point, part * step).points.back());
    double energy = 0;
    const std::complex<double> next = seen.mean(there, energy);
    if (energy >= mean.energy && std::abs(next) >= mean.residual) {
      part /= 2;
    } else {
      step = next;
      mean = {there, std::abs(next), energy, mean.steps, mean.status};
    }
  }
  return mean;
}

/*!
\brief holds points on a surface, each the centre of the vertices that are nearest to it.
*/
struct Voronoi_centres {
  std::vector<Surface_point> sites; ///< the points
  /// The nearest site of each vertex, by the numbers of a `Tangent_field`; `Gluing::none` on
  /// components without a site.
  std::vector<std::uint32_t> cell;
  double largest_move = 0; ///< by which a site moved in the last step
  std::size_t steps = 0;   ///< number of steps
  Status status =
      Status::done; ///< `cap`: sites still moved in the last step; `cancelled` by the caller
};

namespace internal {

// The nearest of several sites for each vertex: the one that sends most heat.
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
\brief moves points on a surface to the centres of their cells (Lloyd's method, as in §8.4 of Sharp
et al. 2019), for an even sampling.

Each step finds the vertices nearest to each site, and moves the site along the mean of the vectors
to them, weighted by area. Sites at vertices move by a thousandth of an edge first.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param heat logarithmic maps on the triangulation
\param sites points of it, where to start
\param np optional named parameters:
  - `maximum_rounds(n)`: the number of steps. Default: 20.
  - `tolerance(x)`: the move of all sites at which to stop, in mean lengths of edges. Default: 0.01.
  - `visitor(v)`: `v.progress(centres)` is called with the `Voronoi_centres` so far before each
    step, and returns whether to go on.
\return the sites and their cells
\throws std::invalid_argument if there are no sites
\complexity for each step and site, that of a logarithmic map and of solving with a factored matrix
*/
template <ConnectedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Voronoi_centres voronoi_centres(const Vector_heat_method<Triangulation>& heat,
                                std::vector<Surface_point> sites,
                                const NP& np = parameters::default_values()) {
  namespace tags = internal::tags;
  internal::expect_names<tags::tolerance, tags::maximum_rounds, tags::visitor>(np);
  const auto maximum_steps = internal::value_or<tags::maximum_rounds>(np, std::size_t{20});
  const double enough = internal::value_or<tags::tolerance>(np, 0.01) * heat.mean_edge_length();
  auto visitor = internal::object_or<tags::visitor>(np, internal::Silent_visitor());
  if (sites.empty()) throw std::invalid_argument("there must be a site");
  for (Surface_point& p : sites) p = internal::off_vertex(p);
  Voronoi_centres result{std::move(sites), {}, 0, 0, Status::done};
  result.cell = internal::voronoi_cells(heat, result.sites);
  const std::vector<double>& areas = heat.relative_areas();
  result.status = Status::cap;
  while (result.steps < maximum_steps) {
    if (!internal::unwrapped(visitor).progress(std::as_const(result))) {
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
    if (result.largest_move > enough) continue;
    result.status = Status::done;
    break;
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_CENTRES_H
