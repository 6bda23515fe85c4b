// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_GREEN_PROBLEM_H
#define CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_GREEN_PROBLEM_H

#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>
#include <CGAL/Intrinsic_operators/operators/residual_indicators.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <numbers>
#include <sstream>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// returns the area of the faces that a triangulation is of, in units of the input.
template <class Triangulation>
double total_area(const Triangulation& t) {
  double area = 0;
  for (const typename Triangulation::face_descriptor f : faces(t.mesh())) area += t.area(f);
  return area / t.input().names().sheets;
}

// returns the mean length of the edges, in units of the input.
template <class Triangulation>
double mean_edge_length(const Triangulation& t) {
  double sum = 0;
  std::size_t count = 0; // `num_edges()` is of numbers, also of those that no edge has any more
  for (const typename Triangulation::edge_descriptor e : edges(t.mesh())) {
    sum += t.length(e);
    ++count;
  }
  return sum / static_cast<double>(count);
}

} // namespace internal

/*!
\brief is the function for which a mesh is refined: the harmonic Green's function of a vertex, or
its heat kernel.
\tparam Triangulation a model of `CorrespondingTriangulation`
*/
template <QueriedTriangulation Triangulation>
class Green_problem {
public:
  /*!
  \brief takes the time of the kernel from the edges of a triangulation before it is refined.
  \param source the vertex, by its row
  \param heat_time of the kernel, in squares of the mean edge; 0: the Green's function
  \throws Invalid_input if the time is out of range
  */
  Green_problem(const Triangulation& t, std::uint32_t source, double heat_time)
      : source_(source), area_(internal::total_area(t)) {
    if (heat_time > 0) time_ = kernel_time(heat_time, internal::mean_edge_length(t));
  }

  /// solves, and estimates the error in the L2 norm of every face.
  auto operator()(Triangulation& t) const {
    const Eigen::VectorXd u =
        time_ > 0 ? short_time_heat_kernel(t, source_, time_) : harmonic_green_function(t, source_);
    const Eigen::VectorXd f = Eigen::VectorXd::Constant(u.size(), time_ > 0 ? 0 : -1 / area_);
    const Reaction_diffusion equation{time_ > 0 ? time_ : 1, time_ > 0 ? 1. : 0.};
    return residual_indicators(t, equation, u, f, Error_norm::L2);
  }

  /// returns what errors are given in: the norm of the kernel in the plane, K0(r / sqrt(t)) /
  /// (2 pi t), or the root of the area.
  double unit() const {
    return time_ > 0 ? 1 / std::sqrt(4 * std::numbers::pi * time_) : std::sqrt(area_);
  }

private:
  // Above 1e8 areas, the kernel is constant but for rounding; below 1e-100 squares of the edges, it
  // falls by powers of ten that doubles do not have.
  double kernel_time(double heat_time, double edge) const {
    const double greatest = 1e8 * std::max(area_ / (edge * edge), 1.);
    if (heat_time >= 1e-100 && heat_time <= greatest) return heat_time * edge * edge;
    std::ostringstream message;
    message << "the heat time is " << heat_time << std::setprecision(2)
            << "; give a number from 1e-100 to " << greatest
            << " squares of the mean edge, after which heat has spread evenly";
    throw Invalid_input(Element_kind::none, 0, message.str());
  }

  std::uint32_t source_;
  double area_, time_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_GREEN_PROBLEM_H
