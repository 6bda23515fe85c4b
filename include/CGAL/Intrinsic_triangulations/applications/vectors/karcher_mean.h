// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_KARCHER_MEAN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_KARCHER_MEAN_H

#include <CGAL/Intrinsic_triangulations/applications/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_triangulations/applications/vectors/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <stdexcept>
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
  Status status = Status::done; ///< `cap`: the number of steps did not suffice
};

/*!
\brief finds the centre of points on a surface: a point where the mean of the vectors to them vanishes, a local minimum of the mean of squared distances.

Each step goes along that mean, as far as the energy falls, from the point of greatest weight. Points at vertices are moved by a
thousandth of an edge.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param heat logarithmic maps on the triangulation
\param points points of it, and their weights
\param tolerance the residual to reach, in mean lengths of edges
\param maximum_steps the number of steps after which to give up
\return the centre
\throws std::invalid_argument if there are no points, or a weight is negative or not finite, or all are zero
\complexity for each step, that of a logarithmic map and of tracing a geodesic
*/
template <internal::Connected_triangulation Triangulation>
Karcher_mean karcher_mean(const Vector_heat_method<Triangulation>& heat,
                          const std::vector<std::pair<Surface_point, double>>& points,
                          double tolerance = 1e-4, std::size_t maximum_steps = 50) {
  using Complex = std::complex<double>;
  double all = 0, greatest = 0;
  Karcher_mean mean;
  for (const auto& [p, w] : points) {
    if (!(w >= 0) || !std::isfinite(w))
      throw std::invalid_argument("the weights of points must be finite and not negative");
    all += w;
    if (w > greatest) mean.point = internal::off_vertex(p), greatest = w;
  }
  if (!(greatest > 0)) throw std::invalid_argument("there must be a point with a positive weight");
  const auto look_around = [&](const Surface_point& p, double& energy) {
    const std::vector<Complex> log = heat.logarithmic_map(p);
    Complex sum = 0;
    energy = 0;
    for (const auto& [q, w] : points) {
      const Complex z = heat.logarithm_at(log, p, q);
      sum += w / all * z;
      energy += w / all * std::norm(z);
    }
    return sum;
  };
  Complex step = look_around(mean.point, mean.energy);
  mean.residual = std::abs(step);
  const double enough = tolerance * heat.mean_edge_length();
  double part = 1;
  for (mean.steps = 1; mean.residual > enough; ++mean.steps) {
    if (mean.steps >= maximum_steps) {
      mean.status = Status::cap;
      break;
    }
    if (part < 0x1p-10) break; // the energy falls no more, up to the errors of logarithmic maps
    const Surface_point there = internal::off_vertex(
        exponential_map(heat.triangulation(), mean.point, part * step).points.back());
    double energy = 0;
    const Complex next = look_around(there, energy);
    if (energy >= mean.energy && std::abs(next) >= mean.residual) {
      part /= 2;
      continue;
    }
    step = next;
    mean = {there, std::abs(next), energy, mean.steps, mean.status};
  }
  return mean;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_KARCHER_MEAN_H
