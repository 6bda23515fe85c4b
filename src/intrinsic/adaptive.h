// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_ADAPTIVE_H
#define INTRINSIC_ADAPTIVE_H

#include "accuracy.h"
#include "options.h"
#include "statistics.h"
#include "support/progress.h"

#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>
#include <CGAL/Intrinsic_operators/operators/residual_indicators.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/adaptive_refine.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

namespace program {

/// Shows progress.
struct Adaptive_progress {
  /// where to show it
  Progress* line = nullptr;
  /// is called after every estimate
  bool progress(const IT::Adaptive_refinement_round& round) {
    return line->show("refining adaptively", std::to_string(round.vertices) + " vertices");
  }
};

/// returns what adaptive refinement did. \param unit what errors are given in
Json adaptive_json(const IT::Adaptive_refinement_result& result, const Adaptive_criteria& criteria,
                   double unit);

/// returns the area of the faces that a triangulation is of, in units of the input.
template <class Triangulation>
double total_area(const Triangulation& t) {
  double area = 0;
  for (const typename Triangulation::face_descriptor f : faces(t.mesh())) area += t.area(f);
  return area / t.input().names().sheets;
}

/// returns the mean length of the edges, in units of the input.
template <class Triangulation>
double mean_edge_length(const Triangulation& t) {
  double sum = 0;
  for (const typename Triangulation::edge_descriptor e : edges(t.mesh())) sum += t.length(e);
  return sum / static_cast<double>(num_edges(t.mesh()));
}

/*!
\brief is the function for which a mesh is refined: the harmonic Green's function of a vertex, or
its heat kernel.
\tparam Triangulation a model of `CorrespondingTriangulation`
*/
template <class Triangulation>
class Adaptive_problem {
public:
  /// takes the time of the kernel from the edges of a triangulation before it is refined.
  Adaptive_problem(const Triangulation& t, const Adaptive_criteria& criteria)
      : source_(criteria.source), area_(total_area(t)) {
    if (criteria.heat_time > 0) time_ = kernel_time(criteria.heat_time, mean_edge_length(t));
  }

  /// solves, and estimates the error in the L2 norm of every face.
  auto operator()(Triangulation& t) const {
    const Eigen::VectorXd u = time_ > 0 ? IT::short_time_heat_kernel(t, source_, time_)
                                        : IT::harmonic_green_function(t, source_);
    const Eigen::VectorXd f = Eigen::VectorXd::Constant(u.size(), time_ > 0 ? 0 : -1 / area_);
    const IT::Reaction_diffusion equation{time_ > 0 ? time_ : 1, time_ > 0 ? 1. : 0.};
    return IT::residual_indicators(t, equation, u, f, IT::Error_norm::L2);
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
    throw IT::Invalid_input(IT::Element_kind::none, 0, message.str());
  }

  std::uint32_t source_;
  double area_, time_ = 0;
};

/*!
\brief refines where the harmonic Green's function of a vertex, or its heat kernel, has large
errors, and reports it.
\throws Invalid_input if the time is out of range
\throws std::runtime_error if there is no such function
*/
template <class Triangulation>
void refine_adaptively(Triangulation& t, const Edge_labels<Triangulation>& constrained,
                       const Options& options, Json& json, Progress& progress) {
  const Adaptive_criteria& criteria = options.adaptive;
  if (criteria.source >= t.input().number_of_rows())
    throw std::runtime_error(options.input + ": vertex " + std::to_string(criteria.source) +
                             " does not exist; give --source a number below " +
                             std::to_string(t.input().number_of_rows()));
  Stopwatch watch;
  const Adaptive_problem<Triangulation> problem(t, criteria);
  Adaptive_progress visitor{&progress};
  progress.show("refining adaptively");
  try {
    const IT::Adaptive_refinement_result result =
        IT::adaptive_refine(t, problem,
                            IT::parameters::tolerance(criteria.tolerance * problem.unit())
                                .minimum_angle(options.refinement.minimum_angle)
                                .maximum_vertices(criteria.maximum_vertices)
                                .edge_is_constrained_map(constrained)
                                .visitor(std::ref(visitor)));
    expect_accurate(result.inaccuracy, options);
    json["adaptive"] = adaptive_json(result, criteria, problem.unit());
  } catch (const std::invalid_argument& e) { // a vertex without faces, or several components
    throw std::runtime_error(options.input + ": " + e.what() +
                             "; give another --source, or a connected part of the mesh");
  }
  json["seconds"]["refine"] = watch.lap();
}

} // namespace program

#endif // INTRINSIC_ADAPTIVE_H
