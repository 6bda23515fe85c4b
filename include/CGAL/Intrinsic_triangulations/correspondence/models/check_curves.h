// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_CHECK_CURVES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_CHECK_CURVES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
Proof that integer coordinates which were not built by moves describe curves that are the input
edges.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

/// Finds the first intrinsic edge at which coordinates are inconsistent or contradict the places of
/// vertices. In every face curves meet (Eqs. 9 and 10 of the course), around every vertex each slot
/// is the start of one curve (Eq. 12), and every curve ends where its input edge ends, or its part
/// between inserted vertices.
template <class Triangulation, class Coordinates>
class Curve_check {
public:
  Curve_check(const Triangulation& t, const Coordinates& coordinates)
      : t_(t), view_(t), coordinates_(coordinates),
        edge_at_slot_(coordinates.fans().number_of_slots(), Gluing::none),
        is_used_(edge_at_slot_.size(), 0),
        left_(2 * std::size_t{coordinates.number_of_edges()}, Gluing::none) {}

  /// returns an edge, or none if all is right.
  std::uint32_t first_bad_edge() {
    // each step relies on those before
    check_numbers();
    if (bad_ == Gluing::none) check_faces();
    if (bad_ == Gluing::none) check_slots();
    if (bad_ == Gluing::none) follow_all();
    if (bad_ == Gluing::none) check_starts();
    return bad_;
  }

private:
  void fail(std::uint32_t edge) {
    if (bad_ == Gluing::none) bad_ = edge;
  }

  Normal_coordinate normal(std::uint32_t h) const { return coordinates_.normal_coordinate(h / 2); }

  std::uint32_t along(std::uint32_t h) const {
    return coordinates_.fans().halfedge(coordinates_.roundabout(h));
  }

  // the part of an input edge between two vertices that a curve along it joins
  double extent(std::uint32_t x, std::uint32_t from, std::uint32_t to) const {
    return parameter_on_halfedge(coordinates_, to, x, false) -
           parameter_on_halfedge(coordinates_, from, x, true);
  }
  void check_numbers() {
    for (std::uint32_t e = 0; e < coordinates_.number_of_edges(); ++e)
      if (coordinates_.normal_coordinate(e) < 0 &&
          (coordinates_.roundabout(2 * e) == Gluing::none ||
           coordinates_.roundabout(2 * e + 1) == Gluing::none))
        fail(e);
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

  void follow_all() {
    std::int64_t unseen = 0; // closed curves are not input edges
    for (std::uint32_t e = 0; e < coordinates_.number_of_edges(); ++e)
      unseen += crossings(coordinates_.normal_coordinate(e));
    for (const typename Triangulation::face_descriptor f : faces(t_.mesh())) {
      std::uint32_t h = view_.halfedge_of_face(t_.index(f));
      const Corner_coordinates c = corner_coordinates(view_, coordinates_, h);
      for (unsigned k = 0; k < 3; ++k, h = view_.next(h)) {
        for (Normal_coordinate i = 0; i < c.emanating[k]; ++i) unseen -= follow({h, i});
        if (normal(h) < 0) check_shared(h);
      }
    }
    if (unseen != 0) fail(0);
  }

  // Returns the number of crossings.
  std::int64_t follow(const Curve_end& start) {
    const std::uint32_t x = input_halfedge(coordinates_, start);
    if (x % 2 != 0) return 0; // is followed from its other end
    std::int64_t count = 0;
    const Curve_end end =
        follow_curve(view_, coordinates_, first_crossing(view_, coordinates_, start),
                     [&](const Curve_crossing& c) {
                       ++count; // seen from the left of the curve
                       if (c.position == 0) left_[c.halfedge] = x ^ 1U;
                       if (c.position == normal(c.halfedge) - 1) left_[c.halfedge ^ 1U] = x;
                     });
    if (input_halfedge(coordinates_, end) != (x ^ 1U) ||
        !(extent(x, view_.source(start.halfedge), view_.source(end.halfedge)) > 0))
      fail(end.halfedge / 2);
    return count;
  }

  void check_shared(std::uint32_t h) {
    const std::uint32_t x = along(h);
    if (along(h ^ 1U) != (x ^ 1U) || !(extent(x, view_.source(h), view_.target(h)) > 0))
      fail(h / 2);
  }

  // ---- each edge starts in the input face that it leaves, or ends in

  void check_starts() {
    const auto& input = coordinates_.input();
    for (const typename Triangulation::edge_descriptor e : edges(t_.mesh()))
      for (const std::uint32_t h : {2 * t_.index(e), 2 * t_.index(e) + 1}) {
        if (normal(h) < 0) continue;
        const std::uint32_t f = input.face(start(h)),
                            g = input.face(normal(h) == 0 ? start(h ^ 1U) : left_[h]);
        if (f == Gluing::none || f != g) fail(h / 2);
      }
  }
  std::uint32_t start(std::uint32_t h) const {
    return corner_on_input(view_, coordinates_, h).halfedge;
  }

  const Triangulation& t_;
  Intrinsic_view<Triangulation> view_;
  const Coordinates& coordinates_;
  std::uint32_t bad_ = Gluing::none;
  std::vector<std::uint32_t> edge_at_slot_; // some edge with that roundabout
  std::vector<char> is_used_;               // per slot: a curve starts there
  std::vector<std::uint32_t>
      left_; // by each intrinsic halfedge: the first input halfedge it crosses
};

} // namespace internal

/*!
\brief checks that coordinates are those of the input edges, all by integers.

In every face curves meet (Eqs. 9 and 10 of the course), around every vertex each slot is the start
of one curve (Eq. 12), every curve ends where its input edge ends, or its part between inserted
vertices, and every vertex is in an input face that the edges start in.
\param t the triangulation
\param coordinates normal coordinates and roundabouts
\return the first edge that is found to be wrong; none if there is none
\complexity linear in the number of edges and crossings; memory linear in the number of edges
*/
template <NumberedTriangulation Triangulation, CurveCoordinates Coordinates>
std::uint32_t first_inconsistent_edge(const Triangulation& t, const Coordinates& coordinates) {
  return internal::Curve_check<Triangulation, Coordinates>(t, coordinates).first_bad_edge();
}

/*!
\brief checks that every intrinsic edge has the length of the straight line between its ends through
the input faces over which it runs by coordinates.
\param t the triangulation
\param coordinates that pass `first_inconsistent_edge()`
\return the first edge whose length differs by more than 1e-8 of the mean length of all edges; none
if there is none
\complexity linear in the number of edges and crossings
*/
template <NumberedTriangulation Triangulation, CurveCoordinates Coordinates>
std::uint32_t first_wrong_length(const Triangulation& t, const Coordinates& coordinates) {
  const auto& input = coordinates.input();
  const Intrinsic_view<Triangulation> view(t);
  const Edge_crossings crossings = edge_crossings(t, coordinates);
  internal::Edge_strip strip(input);
  const auto length_on_input = [&](std::uint32_t e) {
    const std::uint32_t h = 2 * e;
    if (coordinates.normal_coordinate(e) < 0) {
      const std::uint32_t x = coordinates.fans().halfedge(coordinates.roundabout(h));
      return (parameter_on_halfedge(coordinates, view.target(h), x, false) -
              parameter_on_halfedge(coordinates, view.source(h), x, true)) *
             std::sqrt(input.squared_length(x / 2));
    }
    const auto entered = crossings.entered_on(e);
    if (!entered.empty()) strip.unfold(view, coordinates, h, entered);
    const Plane_vector<double> v =
        !entered.empty() ? strip.vector()
                         : scaled(vector_between(input, corner_on_input(view, coordinates, h),
                                                 corner_on_input(view, coordinates, h ^ 1U)),
                                  input.scale_exponent());
    return std::hypot(v.x, v.y);
  };
  double tolerance = 0;
  for (const typename Triangulation::edge_descriptor d : edges(t.mesh()))
    tolerance += std::sqrt(view.squared_length(t.index(d)));
  tolerance *= 1e-8 / static_cast<double>(num_edges(t.mesh()));
  for (const typename Triangulation::edge_descriptor d : edges(t.mesh())) {
    const std::uint32_t e = t.index(d);
    const double error = length_on_input(e) - std::sqrt(view.squared_length(e));
    if (!(std::abs(error) <= tolerance)) return e;
  }
  return Gluing::none;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_CHECK_CURVES_H
