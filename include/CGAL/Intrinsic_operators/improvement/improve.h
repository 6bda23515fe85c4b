// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_IMPROVE_H
#define CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_IMPROVE_H

#include <CGAL/Intrinsic_operators/improvement/Green_problem.h>
#include <CGAL/Intrinsic_operators/improvement/Improve_options.h>
#include <CGAL/Intrinsic_operators/improvement/Improvement.h>
#include <CGAL/Intrinsic_operators/improvement/Wanted_lengths.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/has_accurate_values.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/odt_optimize.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/adaptive_refine.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>
#include <CGAL/Intrinsic_triangulations/support/caps.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// What improves a triangulation.
template <class Triangulation, class Constrained>
class Improver {
  using Face = typename Triangulation::face_descriptor;

public:
  Improver(Triangulation& t, const Improve_options& options, const Constrained& constrained)
      : t_(t), options_(options), constrained_(constrained) {}

  Improvement operator()() {
    result_.area_before = stored_area(t_);
    t_.metric().statistics() = {};
    if (options_.flips) flip();
    result_.seconds_of_flips = watch_.lap();
    if (result_.flips.status == Status::cap) return result_;
    bool is_adapted = false;
    if constexpr (std::is_same_v<typename Triangulation::Correspondence, Integer_coordinates>)
      if (options_.adapt) {
        adapt();
        is_adapted = true;
      }
    if (options_.refine && !is_adapted) refine();
    result_.statistics = t_.metric().statistics();
    return result_;
  }

private:
  // Visits all steps.
  struct Visitor : Refinement_visitor {
    const Improve_options* options = nullptr;
    Wanted_lengths lengths{};

    bool progress(const Flip_to_delaunay_result& r) {
      return tell(Improve_step::flipping, r.flips);
    }
    bool progress(const Refinement_counts& c) {
      return tell(Improve_step::refining, c.inserted_vertices());
    }
    bool progress(const Odt_result& r) { return tell(Improve_step::moving, r.iterations); }
    bool progress(const Adaptive_refinement_round& r) {
      return tell(Improve_step::adapting, r.vertices);
    }
    bool is_bad(const Triangulation& t, Face f) const {
      if constexpr (!Triangulation::has_correspondence)
        return false;
      else
        return !lengths.empty() && lengths.longest_side(t, f) > 1;
    }
    bool tell(Improve_step step, std::uint64_t count) const {
      return !options->progress || options->progress(step, count);
    }
  };

  Visitor visitor_of() const {
    Visitor v;
    v.options = &options_;
    return v;
  }

  void flip() {
    Visitor visitor = visitor_of();
    visitor.tell(Improve_step::flipping, 0);
    result_.flips = flip_to_delaunay(
        t_, edges(t_.mesh()),
        parameters::edge_is_constrained_map(constrained_).visitor(std::ref(visitor)));
  }

  void adapt() {
    const Adapt_criteria& criteria = *options_.adapt;
    const std::size_t rows = t_.input().number_of_rows();
    if (criteria.source >= rows)
      throw Invalid_input(Element_kind::vertex, criteria.source,
                          "vertex " + std::to_string(criteria.source) +
                              " does not exist; give --source a number below " +
                              std::to_string(rows));
    const Green_problem problem(t_, criteria.source, criteria.heat_time);
    Visitor visitor = visitor_of();
    visitor.tell(Improve_step::adapting, 0);
    Adapted_faces& adapted = result_.adapted.emplace();
    adapted.unit = problem.unit();
    try {
      adapted.result = adaptive_refine(t_, problem,
                                       parameters::tolerance(criteria.tolerance * problem.unit())
                                           .minimum_angle(criteria.minimum_angle)
                                           .maximum_vertices(criteria.maximum_vertices)
                                           .edge_is_constrained_map(constrained_)
                                           .visitor(std::ref(visitor)));
    } catch (const std::invalid_argument& e) { // a vertex without faces, or several components
      throw Invalid_input(Element_kind::vertex, criteria.source,
                          std::string(e.what()) +
                              "; give another --source, or a connected part of the mesh");
    }
    result_.inaccuracy = adapted.result.inaccuracy;
    adapted.seconds = watch_.lap();
  }

  void refine() {
    const Refine_criteria& criteria = *options_.refine;
    Refined_faces& refined = result_.refined.emplace();
    refined.quality_before = measure_shapes(t_, constrained_).quality;
    watch_.lap();
    Visitor visitor = visitor_of();
    visitor.lengths = Wanted_lengths(criteria.lengths);
    visitor.tell(Improve_step::refining, 0);
    const auto result = delaunay_refine(t_, parameters::minimum_angle(criteria.minimum_angle)
                                                .maximum_circumradius(criteria.maximum_circumradius)
                                                .maximum_edge_length(criteria.maximum_edge_length)
                                                .maximum_insertions(criteria.maximum_insertions)
                                                .order(criteria.order)
                                                .conforming(criteria.is_conforming)
                                                .edge_is_constrained_map(constrained_)
                                                .visitor(std::ref(visitor)));
    result_.inaccuracy = result.inaccuracy;
    if (result.inaccuracy) return;
    refined.seconds = watch_.lap();
    refined.status = result.status;
    refined.counts = result.counts;
    refined.points = t_.number_of_vertices() - t_.input().number_of_rows();
    refined.minimum_angle = least_angle({});
    refined.satisfied_minimum_angle =
        result.unsatisfied.empty() ? refined.minimum_angle : least_angle(result.unsatisfied);
    for (const auto& u : result.unsatisfied) ++refined.unsatisfied[std::size_t(u.reason)];
    if constexpr (Triangulation::has_correspondence)
      if (!visitor.lengths.empty()) {
        refined.longest_side.emplace(0);
        for (const Face f : faces(t_.mesh()))
          *refined.longest_side =
              std::max(*refined.longest_side, visitor.lengths.longest_side(t_, f));
      }
    if (criteria.odt_length > 0) optimize(criteria, refined);
  }

  void optimize(const Refine_criteria& criteria, Refined_faces& refined) {
    std::optional<std::uint64_t> most = criteria.maximum_insertions;
    if (most)
      *most -= std::min(*most, static_cast<std::uint64_t>(std::max<std::int64_t>(
                                   std::int64_t(refined.counts.inserted_vertices()), 0)));
    else
      expect_few_vertices(criteria.odt_length);
    watch_.lap();
    Visitor visitor = visitor_of();
    visitor.tell(Improve_step::moving, 0);
    refined.odt = odt_optimize(t_, parameters::maximum_edge_length(criteria.odt_length)
                                       .minimum_angle(criteria.minimum_angle)
                                       .maximum_insertions(most)
                                       .edge_is_constrained_map(constrained_)
                                       .visitor(std::ref(visitor)));
    result_.inaccuracy = refined.odt->inaccuracy;
    refined.seconds_of_odt = watch_.lap();
  }

  // Refuses edges so short that the default cap on insertions would only end hours of work.
  void expect_few_vertices(double length) const {
    // of equilateral faces, two per vertex
    const double vertices = stored_area(t_) * t_.input().names().sheets / length / length /
                            (std::sqrt(3.) / 2),
                 cap = static_cast<double>(insertion_cap(num_faces(t_.mesh())));
    if (vertices <= cap) return;
    std::ostringstream message;
    message << "edges of the length " << length << " need more than "
            << static_cast<std::uint64_t>(cap)
            << " vertices; give a longer one, or a cap on insertions";
    throw Invalid_input(Element_kind::none, 0, message.str());
  }

  // The least angle of the faces that are not in a list, in degrees; 180 if all are.
  double least_angle(const std::vector<Unsatisfied_face<Face>>& list) const {
    const auto& mesh = t_.mesh();
    std::vector<char> is_listed(t_.numbers().face_capacity(mesh), 0);
    for (const auto& u : list) is_listed[t_.index(u.face)] = 1;
    const auto squared_length = [&](auto h) {
      return t_.metric().approximate_squared_length(t_.index(edge(h, mesh)));
    };
    // by cotangents, which take no arc tangent per face
    double greatest = -std::numeric_limits<double>::infinity(), least = 180;
    for (const Face f : faces(mesh)) {
      if (is_listed[t_.index(f)] != 0) continue;
      const auto h = halfedge(f, mesh), n = next(h, mesh);
      const double a = squared_length(h), b = squared_length(n), c = squared_length(next(n, mesh)),
                   area = t_.metric().approximate_quadruple_area(t_.index(f));
      const double numerator = a + b + c - 2 * std::min({a, b, c}); // of the cotangent
      if (!(numerator / area > greatest)) continue;
      greatest = numerator / area;
      least = std::atan2(area, numerator) * (180 / std::numbers::pi);
    }
    return least;
  }

  Triangulation& t_;
  const Improve_options& options_;
  const Constrained& constrained_;
  Improvement result_;
  Stopwatch watch_;
};

} // namespace internal

/*!
\brief flips a triangulation to Delaunay, and refines it by criteria or where a function has large
errors; vertices may then be moved.

In doubles, rounding may spoil a triangulation: then `Improvement::inaccuracy` says how, or the
status of the flips is `cap`, and nothing more was done.
\tparam Triangulation a model of `RefinableTriangulation`, `MeasuredTriangulation` and
  `NumberedTriangulation`; only one with `Integer_coordinates` can be adapted
\param t the triangulation
\param options what is done
\param constrained marks the edges that are kept; its entries follow splits
\return what was done; what the triangulation is afterwards `measure()` finds
\throws Invalid_input if the source or the time of adaptive refinement is out of range, or the
  length of edges would need more than some million vertices
\complexity see `flip_to_delaunay()`, `delaunay_refine()`, `adaptive_refine()`, `odt_optimize()`
*/
template <RefinableTriangulation Triangulation>
Improvement improve(Triangulation& t, const Improve_options& options,
                    const Marked_edges<Triangulation, std::uint32_t>& constrained) {
  return internal::Improver(t, options, constrained)();
}

/// improves a triangulation, and keeps no edges.
template <RefinableTriangulation Triangulation>
Improvement improve(Triangulation& t, const Improve_options& options = {}) {
  return improve(t, options, Marked_edges<Triangulation, std::uint32_t>(t));
}

/// \cond
// instantiates what improves and measures a triangulation.
#define CGAL_INTRINSIC_OPERATORS_IMPROVEMENTS(prefix, ...)                                         \
  prefix Improvement improve(__VA_ARGS__&, const Improve_options&,                                 \
                             const Marked_edges<__VA_ARGS__, std::uint32_t>&);                     \
  prefix Measurements measure(__VA_ARGS__&, const Marked_edges<__VA_ARGS__, std::uint32_t>&,       \
                              const std::vector<std::array<double, 3>>&);                          \
  prefix bool has_accurate_values(const __VA_ARGS__&)
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
CGAL_INTRINSIC_TRIANGULATIONS_FOR_EXACT(CGAL_INTRINSIC_OPERATORS_IMPROVEMENTS, extern template);
CGAL_INTRINSIC_TRIANGULATIONS_FOR_ROUNDED(CGAL_INTRINSIC_OPERATORS_IMPROVEMENTS, extern template);
#endif
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_IMPROVE_H
