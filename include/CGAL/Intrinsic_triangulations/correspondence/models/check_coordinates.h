// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_CHECK_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_CHECK_COORDINATES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/follow_signposts.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

#include <algorithm>
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
class Coordinate_check {
public:
  Coordinate_check(const Triangulation& t, const Coordinates& coordinates,
                   const Edge_traces& traces)
      : t_(t), view_(t), coordinates_(coordinates), traces_(traces),
        edge_at_slot_(coordinates.fans().number_of_slots(), Gluing::none),
        is_used_(edge_at_slot_.size(), 0), strip_(coordinates.input()) {}

  /// returns an edge, or none if all is right.
  std::uint32_t first_bad_edge() {
    // each step relies on those before
    check_numbers();
    if (bad_ == Gluing::none) check_faces();
    if (bad_ == Gluing::none) check_slots();
    if (bad_ == Gluing::none) check_curves();
    if (bad_ == Gluing::none) check_lengths();
    return bad_;
  }

private:
  void fail(std::uint32_t edge) {
    if (bad_ == Gluing::none) bad_ = edge;
  }

  Normal_coordinate normal(std::uint32_t h) const { return coordinates_.normal_coordinate(h / 2); }

  void check_numbers() {
    for (std::uint32_t e = 0; e < coordinates_.number_of_edges(); ++e) {
      const Normal_coordinate n = coordinates_.normal_coordinate(e);
      if ((n < 0) != (traces_.along[e] != Gluing::none) ||
          static_cast<std::size_t>(crossings(n)) != traces_[e].size() ||
          (n < 0 && (coordinates_.roundabout(2 * e) == Gluing::none ||
                     coordinates_.roundabout(2 * e + 1) == Gluing::none)))
        fail(e);
    }
  }

  // ---- curves in each face and around each vertex (Eq. 9, 10, 12 of the course)

  void check_faces() {
    for (const typename Triangulation::face_descriptor f : faces(t_.mesh())) {
      const auto s = sides_of_face(view_, view_.halfedge_of_face(t_.index(f)));
      const Corner_coordinates c = corner_coordinates(view_, coordinates_, s[0]);
      for (unsigned k = 0; k < 3; ++k) {
        const unsigned next = (k + 1) % 3, last = (k + 2) % 3;
        const Normal_coordinate ends = std::max(
            0, crossings(normal(s[k])) + crossings(normal(s[last])) - crossings(normal(s[next])));
        if (c.cutting[k] < 0 || 2 * c.cutting[k] + c.emanating[next] + c.emanating[last] != ends)
          fail(s[k] / 2);
        check_corner(s[k], s[last] ^ 1U, c.emanating[k]);
      }
    }
  }

  // of the halfedges `h` and `after` counterclockwise
  void check_corner(std::uint32_t h, std::uint32_t after, Normal_coordinate emanating) {
    const std::uint32_t slot = coordinates_.roundabout(h);
    const auto count = static_cast<std::uint32_t>(parallels(normal(h)) + emanating);
    if (slot == Gluing::none) {
      if (count > 0 || coordinates_.roundabout(after) != Gluing::none) fail(h / 2);
      return;
    }
    edge_at_slot_[slot] = h / 2;
    for (std::uint32_t i = 0; i < count && bad_ == Gluing::none; ++i)
      use(coordinates_.fans().advance(slot, i), h / 2);
    if (bad_ != Gluing::none) return;
    if (coordinates_.roundabout(after) != coordinates_.fans().advance(slot, count)) fail(h / 2);
    if (!view_.is_border(h ^ 1U)) return;
    if (normal(h) >= 0 || coordinates_.roundabout(h ^ 1U) == Gluing::none)
      fail(h / 2);
    else
      use(coordinates_.roundabout(h ^ 1U), h / 2);
  }

  void use(std::uint32_t slot, std::uint32_t edge) {
    if (is_used_[slot] != 0) fail(edge);
    is_used_[slot] = 1;
  }

  void check_slots() {
    for (std::uint32_t slot = 0; slot < is_used_.size(); ++slot) {
      if (is_used_[slot] != 0) continue;
      std::uint32_t s = slot; // an edge of the same vertex is to blame
      do {
        s = coordinates_.fans().advance(s, 1);
      } while (edge_at_slot_[s] == Gluing::none && s != slot);
      fail(edge_at_slot_[s] == Gluing::none ? 0 : edge_at_slot_[s]);
    }
  }

  // ---- each curve from end to end

  void check_curves() {
    for (const typename Triangulation::face_descriptor f : faces(t_.mesh())) {
      std::uint32_t h = view_.halfedge_of_face(t_.index(f));
      const Corner_coordinates c = corner_coordinates(view_, coordinates_, h);
      for (unsigned k = 0; k < 3; ++k, h = view_.next(h)) {
        for (Normal_coordinate i = 0; i < c.emanating[k]; ++i) follow({h, i});
        if (normal(h) < 0) check_shared(h);
      }
    }
  }

  void follow(const Curve_end& start) {
    const std::uint32_t x = input_halfedge(coordinates_, start);
    if (x % 2 != 0) return; // is followed from its other end
    const Curve_end end =
        follow_curve(view_, coordinates_, first_crossing(view_, coordinates_, start),
                     [&](const Curve_crossing& c) {
                       const auto p = static_cast<std::size_t>(
                           c.halfedge % 2 == 0 ? c.position : normal(c.halfedge) - 1 - c.position);
                       // the halfedge of the face that the intrinsic edge leaves
                       if (traces_[c.halfedge / 2][p].halfedge != (x ^ 1U ^ (c.halfedge & 1U)))
                         fail(c.halfedge / 2);
                     });
    if (input_halfedge(coordinates_, end) != (x ^ 1U) ||
        !(extent(x, view_.source(start.halfedge), view_.source(end.halfedge)) > 0))
      fail(end.halfedge / 2);
  }

  void check_shared(std::uint32_t h) {
    const std::uint32_t x = along(h);
    if (along(h ^ 1U) != (x ^ 1U) || !(extent(x, view_.source(h), view_.target(h)) > 0))
      fail(h / 2);
  }

  std::uint32_t along(std::uint32_t h) const {
    return coordinates_.fans().halfedge(coordinates_.roundabout(h));
  }

  // the part of an input edge between two vertices that a curve along it joins
  double extent(std::uint32_t x, std::uint32_t from, std::uint32_t to) const {
    return parameter_on_halfedge(coordinates_, to, x, false) -
           parameter_on_halfedge(coordinates_, from, x, true);
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
      const Planar_vector<double> v = vector_between(input, a, b);
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

  const Triangulation& t_;
  Intrinsic_view<Triangulation> view_;
  const Coordinates& coordinates_;
  const Edge_traces& traces_;
  std::vector<std::uint32_t> edge_at_slot_; // some edge with that roundabout
  std::vector<char> is_used_;               // per slot: a curve starts there
  std::vector<std::uint32_t> entered_;
  std::uint32_t bad_ = Gluing::none;

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
