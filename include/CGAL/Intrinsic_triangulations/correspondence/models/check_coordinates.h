// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_CHECK_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_CHECK_COORDINATES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/check_curves.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/follow_signposts.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

/*!
\file
Proof that integer coordinates which were not built by moves describe curves that are the input edges.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

/// Finds the first intrinsic edge at which coordinates contradict themselves or the traces of edges.
template <class Triangulation, class Coordinates>
class Coordinate_check : Curve_check<Triangulation, Coordinates> {
  using Base = Curve_check<Triangulation, Coordinates>;
  using Base::along;
  using Base::bad_;
  using Base::coordinates_;
  using Base::extent;
  using Base::fail;
  using Base::normal;
  using Base::t_;
  using Base::view_;

public:
  Coordinate_check(const Triangulation& t, const Coordinates& coordinates,
                   const Edge_traces& traces)
      : Base(t, coordinates), traces_(traces), strip_(coordinates.input()) {}

  /// returns an edge, or none if all is right.
  std::uint32_t first_bad_edge() {
    // each step relies on those before
    check_traces();
    if (bad_ == Gluing::none)
      Base::check_curves([this](const Curve_crossing& c, std::uint32_t x) {
        const auto p = static_cast<std::size_t>(
            c.halfedge % 2 == 0 ? c.position : normal(c.halfedge) - 1 - c.position);
        // the halfedge of the face that the intrinsic edge leaves
        if (traces_[c.halfedge / 2][p].halfedge != (x ^ 1U ^ (c.halfedge & 1U)))
          fail(c.halfedge / 2);
      });
    if (bad_ == Gluing::none) check_lengths();
    return bad_;
  }

private:
  void check_traces() {
    for (std::uint32_t e = 0; e < coordinates_.number_of_edges(); ++e) {
      const Normal_coordinate n = coordinates_.normal_coordinate(e);
      if ((n < 0) != (traces_.along[e] != Gluing::none) ||
          static_cast<std::size_t>(crossings(n)) != traces_[e].size())
        fail(e);
    }
  }

  // ---- the straight line through the faces that were passed

  void check_lengths() {
    double mean = 0;
    for (const typename Triangulation::edge_descriptor d : edges(t_.mesh()))
      mean += std::sqrt(view_.squared_length(t_.index(d)));
    mean /= static_cast<double>(num_edges(t_.mesh()));
    for (const typename Triangulation::edge_descriptor d : edges(t_.mesh())) {
      const std::uint32_t e = t_.index(d);
      const double error = length_on_input(e) - std::sqrt(view_.squared_length(e));
      if (!(std::abs(error) <= tolerance * mean)) fail(e); // no number: no path
    }
  }

  double length_on_input(std::uint32_t e) {
    const auto& input = coordinates_.input();
    const std::uint32_t h = 2 * e;
    if (normal(h) < 0)
      return extent(along(h), view_.source(h), view_.target(h)) *
             std::sqrt(input.squared_length(along(h) / 2));
    const Surface_point a = corner_on_input(view_, coordinates_, h),
                        b = corner_on_input(view_, coordinates_, h ^ 1U);
    if (normal(h) == 0) {
      if (input.face(a.halfedge) != input.face(b.halfedge)) return std::nan("");
      const Plane_vector<double> v = vector_between(input, a, b);
      return std::hypot(v[0], v[1]);
    }
    entered_.clear();
    for (const Geodesic_crossing& c : traces_[e]) entered_.push_back(c.halfedge ^ 1U);
    if (input.face(a.halfedge) != input.face(entered_.front() ^ 1U) ||
        input.face(b.halfedge) != input.face(entered_.back()))
      return std::nan("");
    strip_.unfold(a, b, entered_);
    return std::hypot(strip_.vector().x, strip_.vector().y);
  }

  static constexpr double tolerance = 1e-8;

  const Edge_traces& traces_;
  std::vector<std::uint32_t> entered_;

  using Input = std::remove_cvref_t<decltype(std::declval<const Coordinates&>().input())>;
  Edge_strip<Input> strip_;
};

} // namespace internal

/*!
\brief checks that coordinates are those of the input edges, given the paths of the intrinsic edges
that were found by tracing.

The proof is in integers: in every face curves meet (Eqs. 9 and 10 of the course), around every vertex
each slot is the start of one curve (Eq. 12), every curve ends where its input edge ends, or its part
between inserted vertices, and crosses each intrinsic edge where the trace of that edge says. Besides,
the straight line between the ends of each path has the length of the edge, up to 1e-8 of the
mean length of all edges.
\tparam Triangulation an instance of `Intrinsic_triangulation`
\tparam Coordinates `Integer_coordinates`
\param t the triangulation
\param coordinates normal coordinates and roundabouts
\param traces the paths of all edges, for the same edge numbers
\return the first edge that is found to be wrong; none if there is none
\complexity linear in the number of edges and crossings
*/
template <class Triangulation, class Coordinates>
std::uint32_t first_inconsistent_edge(const Triangulation& t, const Coordinates& coordinates,
                                      const Edge_traces& traces) {
  return internal::Coordinate_check<Triangulation, Coordinates>(t, coordinates, traces)
      .first_bad_edge();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_CHECK_COORDINATES_H
