// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_ADAPTIVE_H
#define INTRINSIC_ADAPTIVE_H

#include "accuracy.h"
#include "options.h"
#include "statistics.h"
#include "support/progress.h"

#include <CGAL/Intrinsic_triangulations/operators/reaction_diffusion.h>
#include <CGAL/Intrinsic_triangulations/operators/residual_indicators.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/adaptive_refine.h>

#include <Eigen/Core>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

namespace program {

/// Shows progress.
struct Adaptive_progress {
  /// where to show it
  Progress* line = nullptr;
  /// is called after every estimate
  bool progress(const IT::Adaptive_refinement_round& round) {
    line->show("refining adaptively", std::to_string(round.vertices) + " vertices");
    return true;
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

/*!
\brief refines where the harmonic Green's function of a vertex has large errors, and reports it.
\throws std::runtime_error if there is no such function
*/
template <class Triangulation>
void refine_adaptively(Triangulation& t, const IT::Marked_edges<Triangulation>& constrained,
                       const Options& options, Json& json, Progress& progress) {
  const Adaptive_criteria& criteria = options.adaptive;
  if (criteria.source >= t.input().number_of_rows())
    throw std::runtime_error(options.input + ": vertex " + std::to_string(criteria.source) +
                             " does not exist; give --source a number below " +
                             std::to_string(t.input().number_of_rows()));
  Stopwatch watch;
  const double area = total_area(t);
  const auto estimate = [&](Triangulation& now) {
    const Eigen::VectorXd u = IT::harmonic_green_function(now, criteria.source);
    const Eigen::VectorXd density = Eigen::VectorXd::Constant(u.size(), -1 / area);
    return IT::residual_indicators(now, {.diffusion = 1, .reaction = 0}, u, density,
                                   IT::Error_norm::L2);
  };
  Adaptive_progress visitor{&progress};
  progress.show("refining adaptively");
  try {
    const IT::Adaptive_refinement_result result =
        IT::adaptive_refine(t, estimate,
                            IT::parameters::tolerance(criteria.tolerance * std::sqrt(area))
                                .minimum_angle(options.refinement.minimum_angle)
                                .maximum_vertices(criteria.maximum_vertices)
                                .edge_is_constrained_map(constrained)
                                .visitor(std::ref(visitor)));
    expect_accurate(result.inaccuracy, options);
    json["adaptive"] = adaptive_json(result, criteria, std::sqrt(area));
  } catch (const std::invalid_argument& e) { // a vertex without faces, or several components
    throw std::runtime_error(options.input + ": " + e.what() +
                             "; give another --source, or a connected part of the mesh");
  }
  json["seconds"]["refine"] = watch.lap();
}

} // namespace program

#endif // INTRINSIC_ADAPTIVE_H
