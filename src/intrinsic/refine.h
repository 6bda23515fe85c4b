// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_REFINE_H
#define INTRINSIC_REFINE_H

#include "accuracy.h"
#include "constraints.h"
#include "load.h"
#include "options.h"
#include "sizes.h"
#include "statistics.h"
#include "support/progress.h"

#include <CGAL/Intrinsic_triangulations/connectivity/status_name.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/odt_optimize.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace program {

/// Shows progress.
struct Refinement_progress : IT::Refinement_visitor {
  /// where to show it
  Progress* line = nullptr;
  /// how long edges may be
  Sizes sizes;
  /// tells whether a face has a side that is too long
  template <class Triangulation>
  bool is_bad(const Triangulation& t, typename Triangulation::face_descriptor f) const {
    if constexpr (!Triangulation::has_correspondence)
      return false;
    else
      return !sizes.empty() && sizes.longest_side(t, f) > 1;
  }
  /// is called while refining
  bool progress(const IT::Refinement_counts& counts) {
    return line->show("refining",
                      std::to_string(counts.inserted_vertices()) + " vertices inserted");
  }
};

/// Shows progress.
struct Odt_progress {
  /// where to show it
  Progress* line = nullptr;
  /// is called while vertices are moved
  bool progress(const IT::Odt_result& r) {
    return line->show("moving vertices", std::to_string(r.iterations) + " iterations");
  }
};

/// refuses edges so short that the default cap on insertions would only end hours of work.
template <class Triangulation>
void expect_few_vertices(const Triangulation& t, const Options& options) {
  long double area = 0;
  for (const typename Triangulation::face_descriptor f : faces(t.mesh()))
    area += t.metric().approximate_quadruple_area(t.index(f)) / 4;
  // of equilateral faces, two per vertex
  const double length = std::ldexp(options.odt_length, t.metric().scale_exponent()),
               vertices = static_cast<double>(area) / length / length / (std::sqrt(3.) / 2),
               cap = 1e6 + 10 * static_cast<double>(num_faces(t.mesh()));
  if (vertices > cap)
    throw IT::Invalid_input(IT::Element_kind::none, 0,
                            options.input + ": edges of the length " +
                                Json(options.odt_length).dump() + " need more than " +
                                std::to_string(static_cast<std::uint64_t>(cap)) +
                                " vertices; give a longer one, or a cap on insertions");
}

/// moves inserted vertices, and reports it.
/// \param inserted how many vertices refinement has inserted before
template <class Triangulation, class Constrained>
void optimize(Triangulation& t, const Constrained& constrained, const Options& options,
              std::uint64_t inserted, Json& json, Progress& progress) {
  std::optional<std::uint64_t> most = options.refinement.maximum_insertions;
  if (most)
    *most -= std::min(*most, inserted);
  else
    expect_few_vertices(t, options);
  Stopwatch watch;
  Odt_progress visitor{&progress};
  progress.show("moving vertices");
  const auto result = IT::odt_optimize(t, IT::parameters::maximum_edge_length(options.odt_length)
                                              .minimum_angle(options.refinement.minimum_angle)
                                              .maximum_insertions(most)
                                              .edge_is_constrained_map(constrained)
                                              .visitor(std::ref(visitor)));
  expect_accurate(result.inaccuracy, options);
  json["seconds"]["odt"] = watch.lap();
  json["odt"] = {{"status", result.status == IT::Status::done ? "converged" : "cap"},
                 {"target_length", options.odt_length},
                 {"iterations", result.iterations},
                 {"splits", result.splits},
                 {"moves", result.moves},
                 {"refused", result.refused},
                 {"energy_before", result.energy_before},
                 {"energy_after", result.energy_after},
                 {"insertions", result.insertions},
                 {"min_angle_deg", result.minimum_angle},
                 {"unsatisfied_faces", result.unsatisfied_faces}};
}

/// returns the least angle of the faces that are not in a list, in degrees; 180 if all are.
template <class Triangulation>
double minimum_angle_without(
    const Triangulation& t,
    const std::vector<IT::Unsatisfied_face<typename Triangulation::face_descriptor>>& list) {
  const auto& mesh = t.mesh();
  std::vector<char> is_listed(t.numbers().face_capacity(mesh), 0);
  for (const auto& u : list) is_listed[t.index(u.face)] = 1;
  const auto squared_length = [&](auto h) {
    return t.metric().approximate_squared_length(t.index(edge(h, mesh)));
  };
  double least = 180;
  for (const typename Triangulation::face_descriptor f : faces(mesh)) {
    if (is_listed[t.index(f)] != 0) continue;
    const auto h = halfedge(f, mesh), n = next(h, mesh);
    const double a = squared_length(h), b = squared_length(n), c = squared_length(next(n, mesh));
    const double cotangent_numerator = a + b + c - 2 * std::min({a, b, c});
    least = std::min(
        least, std::atan2(t.metric().approximate_quadruple_area(t.index(f)), cotangent_numerator) *
                   (180 / std::numbers::pi));
  }
  return least;
}

/// reports the longest side of a face relative to the sizes that were asked for, if there are any.
template <class Triangulation>
void report_longest_side(const Triangulation& t, const Sizes& sizes, Json& json) {
  if constexpr (Triangulation::has_correspondence)
    if (!sizes.empty()) {
      double longest = 0;
      for (const typename Triangulation::face_descriptor f : faces(t.mesh()))
        longest = std::max(longest, sizes.longest_side(t, f));
      json["refine"]["max_relative_edge_length"] = longest;
    }
}

/// refines the triangulation and reports it.
template <class Triangulation, class Constrained>
void refine(Loaded<Triangulation>& loaded, const Constrained& constrained, const Options& options,
            Json& json, Progress& progress) {
  Triangulation& t = loaded.triangulation;
  json["quality_before"] = quality_json(quality_of(t, check(t, constrained)));
  Stopwatch watch;
  Refinement_progress visitor;
  visitor.line = &progress;
  visitor.sizes = Sizes(loaded.sizes);
  progress.show("refining");
  const Refinement_criteria& criteria = options.refinement;
  const auto result =
      IT::delaunay_refine(t, IT::parameters::minimum_angle(criteria.minimum_angle)
                                 .maximum_circumradius(criteria.maximum_circumradius)
                                 .maximum_edge_length(criteria.maximum_edge_length)
                                 .maximum_insertions(criteria.maximum_insertions)
                                 .order(criteria.order)
                                 .conforming(criteria.is_conforming)
                                 .edge_is_constrained_map(constrained)
                                 .visitor(std::ref(visitor)));
  expect_accurate(result.inaccuracy, options);
  json["seconds"]["refine"] = watch.lap();
  const IT::Refinement_counts& counts = result.counts;
  // negative if more vertices of an earlier refinement, or of curves, were removed
  const auto inserted = static_cast<std::int64_t>(counts.inserted_vertices());
  std::array<std::size_t, 4> reasons{};
  for (const auto& u : result.unsatisfied) ++reasons[static_cast<std::size_t>(u.reason)];
  if (result.status == IT::Status::stalled)
    progress.warn(options.input + ": no vertex could be inserted for " +
                  std::to_string(reasons[2]) +
                  " faces that do not meet the criteria: rounding hides its place");
  json["refine"] = {{"status", IT::name_of(result.status)},
                    {"asked_angle_deg", options.refinement.minimum_angle},
                    {"insertions", inserted},
                    {"points", t.number_of_vertices() - t.input().number_of_rows()},
                    {"circumcenters", counts.circumcenters},
                    {"segment_splits", counts.segment_splits},
                    {"removals", counts.removals},
                    {"flips", counts.flips},
                    {"refused", counts.refused},
                    {"without_copies", counts.without_copies},
                    {"min_angle_deg", minimum_angle_without(t, {})},
                    {"satisfied_min_angle_deg", minimum_angle_without(t, result.unsatisfied)},
                    {"unsatisfied_faces", result.unsatisfied.size()},
                    {"unsatisfied",
                     {{"needle", reasons[0]},
                      {"small_angle", reasons[1]},
                      {"refused", reasons[2]},
                      {"stopped", reasons[3]}}}};
  report_longest_side(t, visitor.sizes, json);
  if (options.odt_length > 0)
    optimize(t, constrained, options,
             static_cast<std::uint64_t>(std::max<std::int64_t>(inserted, 0)), json, progress);
}

} // namespace program

#endif // INTRINSIC_REFINE_H
