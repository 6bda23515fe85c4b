// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_IMPROVE_AND_MEASURE_H
#define CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_IMPROVE_AND_MEASURE_H

#include <CGAL/Intrinsic_operators/improvement/Improve_options.h>
#include <CGAL/Intrinsic_operators/improvement/Improvement.h>
#include <CGAL/Intrinsic_operators/improvement/improve.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/input/mollification.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <array>
#include <cstdint>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is thrown if rounding has spoilt a triangulation: take exact traits.

Messages name options as the program does.
*/
class Rounding_error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// What `improve_soundly()` has done, and what `measure_improved()` has found.
struct Improved_surface {
  Improvement done{};      ///< of `improve_soundly()`
  Measurements measured{}; ///< of `measure_improved()`
  /// of `measure_improved()`: see `area_of_points()`; where moves were exact, and lengths are those
  /// between points, the area before
  double input_area = 0;
  bool is_exact = false;           ///< whether predicates were exact
  double seconds_of_measuring = 0; ///< of `measure_improved()`

  /// returns how sure it is that the triangulation is Delaunay: "exact", all edges that are not
  /// kept are proven to be; "interval", the same but for probable ties; or "none".
  /// \pre `measure_improved()` was called
  const char* certificate() const {
    const std::uint64_t probable = done.statistics.probable_zero + measured.edges.probable_zero;
    return !is_exact || measured.edges.non_delaunay > 0 ? "none"
           : probable > 0                               ? "interval"
                                                        : "exact";
  }
  /// returns what could not be done, in words; empty: all was.
  std::string shortcoming() const {
    if (!done.refined || done.refined->status != Status::stalled) return {};
    return "no vertex could be inserted for " + std::to_string(done.refined->unsatisfied[2]) +
           " faces that do not meet the criteria: rounding hides its place";
  }
};

namespace internal {

// What rounding has done to areas, to the end of a sentence.
inline void append_areas(std::ostream& message, double before, double after) {
  message.precision(10);
  message << "the total area was " << before << " and is " << after << "; ";
}

[[noreturn]] inline void refuse_spoilt(const std::string& how) {
  throw Rounding_error("rounding has spoilt the triangulation: " + how +
                       "nothing was written; use --arithmetic exact");
}

inline void refuse_spoilt(const Inaccuracy& i) {
  const std::string face = "face " + std::to_string(i.face);
  using Kind = Inaccuracy::Kind;
  std::ostringstream message;
  message << (i.kind == Kind::face         ? face + " has no positive area or length; "
              : i.kind == Kind::shape      ? "the sides of " + face + " do not span its area; "
              : i.kind == Kind::total_area ? "area was lost or made, most likely at " + face + "; "
                                           : "the Euler characteristic has changed; ");
  if (!(std::abs(i.area_after - i.area_before) <= 1e-9 * i.area_before))
    append_areas(message, i.area_before, i.area_after);
  refuse_spoilt(message.str());
}

inline void expect_sound(const Improvement& done) {
  if (done.flips.status == Status::cap)
    throw Rounding_error("flipping did not end after " + std::to_string(done.flips.flips) +
                         " flips in double arithmetic; use --arithmetic exact");
  if (done.inaccuracy) refuse_spoilt(*done.inaccuracy);
}

// Whether the area of the input is only a figure, which can be found after moves, too.
template <class Triangulation>
inline constexpr bool knows_input_later =
    Triangulation::Metric::is_exact&& Triangulation::has_correspondence;

// The area of the input, after moves that were exact. That of the faces before is the same where
// their lengths are those between the points.
template <class Triangulation>
double area_after_moves(const Triangulation& t, const std::vector<std::array<double, 3>>& points,
                        const Improvement& done) {
  const bool is_of_points =
      !t.input().metric().points().empty() && t.report().mollification.kind == Mollification::none;
  return is_of_points ? done.area_before : area_of_points(t, points);
}

} // namespace internal

/*!
\brief labels the intrinsic edges along some edges of the input with 1, for `improve()`.
\tparam Triangulation see `constrained_input_edges()`
\param t the triangulation
\param is_kept nonzero for each edge of the input that is kept, by its number; empty: none is
\return labels of all edges
\complexity that of `constrained_input_edges()`, and linear in the number of edges
*/
template <NumberedTriangulation Triangulation>
Marked_edges<Triangulation, std::uint32_t> labelled_input_edges(const Triangulation& t,
                                                                const std::vector<char>& is_kept) {
  Marked_edges<Triangulation, std::uint32_t> labels(t);
  if (is_kept.empty()) return labels;
  const Marked_edges<Triangulation> marks = constrained_input_edges(t, is_kept);
  for (const typename Triangulation::edge_descriptor e : edges(t.mesh()))
    if (get(marks, e)) put(labels, e, 1);
  return labels;
}

/*!
\brief improves a triangulation, and refuses it if rounding has spoilt it. It is not measured yet.
\tparam Triangulation see `improve()`
\param t the triangulation
\param points where each row is, in the units of the input; none: an abstract metric
\param options what is done
\param constrained marks the edges that are kept
\throws Rounding_error if rounding has spoilt the triangulation; never with exact traits
\throws Invalid_input as `improve()` does
\complexity that of `improve()`
*/
template <RefinableTriangulation Triangulation>
Improved_surface improve_soundly(Triangulation& t, const std::vector<std::array<double, 3>>& points,
                                 const Improve_options& options,
                                 const Marked_edges<Triangulation, std::uint32_t>& constrained) {
  Improved_surface result;
  result.is_exact = Triangulation::Metric::is_exact;
  if (!internal::knows_input_later<Triangulation>) result.input_area = area_of_points(t, points);
  result.done = improve(t, options, constrained);
  internal::expect_sound(result.done);
  return result;
}

/*!
\brief refuses a triangulation that was improved if rounding has changed its area.
\param t the triangulation
\param are_lengths_changed whether lengths are not those between the points
\param improved the result of `improve_soundly()`
\throws Rounding_error if rounding has spoilt the triangulation; never with exact traits
\complexity linear; constant with exact traits
*/
template <RefinableTriangulation Triangulation>
void expect_area_kept(const Triangulation& t, bool are_lengths_changed,
                      const Improved_surface& improved) {
  if (improved.is_exact) return;
  const double area = improved.input_area, after = stored_area(t);
  const bool is_known = std::isfinite(area) && area > 0 && !are_lengths_changed &&
                        t.report().mollification.kind != Mollification::lengths;
  const double before = is_known ? area : improved.done.area_before;
  if (std::abs(after - before) <= 1e-6 * before) return; // false for what is not a number
  std::ostringstream message;
  internal::append_areas(message, before, after);
  internal::refuse_spoilt(message.str());
}

/*!
\brief measures a triangulation that was improved, and refuses it if rounding has changed its area.

With exact traits, what is stored becomes more accurate: values that are computed afterwards do not
depend on what was asked before.
\param t the triangulation
\param points see `improve_soundly()`
\param constrained marks the edges that are kept
\param are_lengths_changed whether lengths are not those between the points
\param improved the result of `improve_soundly()`, which gets what was measured
\throws Rounding_error if rounding has spoilt the triangulation; never with exact traits
\complexity that of `measure()`
*/
template <RefinableTriangulation Triangulation>
void measure_improved(Triangulation& t, const std::vector<std::array<double, 3>>& points,
                      const Marked_edges<Triangulation, std::uint32_t>& constrained,
                      bool are_lengths_changed, Improved_surface& improved) {
  Stopwatch watch;
  // the metric does not know coordinates of inserted vertices
  const bool has_points = num_vertices(t.mesh()) == t.input().number_of_vertices();
  improved.measured =
      measure(t, constrained, has_points ? points : std::vector<std::array<double, 3>>());
  if (internal::knows_input_later<Triangulation>)
    improved.input_area = internal::area_after_moves(t, points, improved.done);
  expect_area_kept(t, are_lengths_changed, improved);
  improved.seconds_of_measuring = watch.lap();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_IMPROVE_AND_MEASURE_H
