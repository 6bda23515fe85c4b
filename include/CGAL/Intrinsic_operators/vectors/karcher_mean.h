// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_KARCHER_MEAN_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_KARCHER_MEAN_H

#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
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
  std::size_t steps = 0; ///< number of logarithmic maps that were found
  Status status =
      Status::done; ///< `cap`: the number of steps did not suffice; `cancelled` by the caller
};

namespace internal {

// Points with weights, as they are seen from a point.
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
            " is on another component of the surface than the heaviest one, "
            "so that they have no mean; give the points of one component");
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
\brief finds the centre of points on a surface: a point where the mean of the vectors to them vanishes, a local minimum of the mean of squared distances.

Each step goes along that mean, as far as the energy falls, from the point of greatest weight. Points at vertices are moved by a
thousandth of an edge.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param heat logarithmic maps on the triangulation
\param points points of it, and their weights
\param tolerance the residual to reach, in mean lengths of edges
\param maximum_steps the number of steps after which to give up
\param progress is called with what was reached after each logarithmic map but the last, if given; tells whether to go on
\return the centre
\throws std::invalid_argument if there are no points, a weight is negative or not finite, or all are zero, or points of positive weight are on different
  components of the surface
\complexity for each step, that of a logarithmic map and of tracing a geodesic
*/
template <internal::Connected_triangulation Triangulation>
Karcher_mean karcher_mean(const Vector_heat_method<Triangulation>& heat,
                          const std::vector<std::pair<Surface_point, double>>& points,
                          double tolerance = 1e-4, std::size_t maximum_steps = 50,
                          const std::function<bool(const Karcher_mean&)>& progress = {}) {
  const internal::Weighted_points<Triangulation> seen(heat, points);
  Karcher_mean mean;
  mean.point = internal::off_vertex(seen.heaviest());
  std::complex<double> step = seen.mean(mean.point, mean.energy);
  mean.residual = std::abs(step);
  const double enough = tolerance * heat.mean_edge_length();
  double part =
      1; // of the step; so small that the energy falls no more for the errors of logarithmic maps
  for (mean.steps = 1; mean.residual > enough && part >= 0x1p-10; ++mean.steps) {
    if (mean.steps >= maximum_steps) {
      mean.status = Status::cap;
      break;
    }
    if (progress && !progress(mean)) {
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

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_KARCHER_MEAN_H
