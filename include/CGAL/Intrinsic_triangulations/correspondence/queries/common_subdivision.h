// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_COMMON_SUBDIVISION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_COMMON_SUBDIVISION_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/ideal_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Curve_queries.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

/// Cuts the intrinsic faces along the curves that cross them (§3.6 of the course).
template <class Triangulation, class Coordinates>
class Subdivider {
public:
  Subdivider(const Triangulation& t, const Coordinates& coordinates)
      : t_(t), coordinates_(coordinates), view_(t), crossings_(edge_crossings(t, coordinates)) {}

  Common_subdivision subdivide() {
    add_vertices();
    add_crossings();
    reserve();
    for (const typename Triangulation::face_descriptor f : faces(t_.mesh())) cut(t_.index(f));
    return std::move(s_);
  }

private:
  static constexpr std::uint32_t none = Common_subdivision::none;

  std::uint32_t user_vertex(std::uint32_t v) const { return t_.input().names().row(v); }
  std::uint32_t user_face(std::uint32_t f) const { return t_.input().names().faces.user(f); }

  std::uint32_t row(std::uint32_t v) const { return t_.input_vertex(t_.numbers().vertex_at(v)); }

  void add_vertices() {
    s_.number_of_input_vertices = t_.input().number_of_rows();
    for (const typename Triangulation::vertex_descriptor d : vertices(t_.mesh())) {
      const std::uint32_t v = t_.numbers().vertex(d);
      if (v >= vertex_.size()) vertex_.resize(v + 1, none);
      vertex_[v] = static_cast<std::uint32_t>(s_.vertices.size());
      s_.vertices.push_back(vertex(v));
    }
    s_.number_of_intrinsic_vertices = t_.number_of_vertices();
  }

  Common_subdivision::Vertex vertex(std::uint32_t v) const {
    const auto& input = coordinates_.input();
    Common_subdivision::Vertex r;
    r.intrinsic = row(v);
    if (!coordinates_.is_inserted(v)) {
      r.kind = Subdivision_vertex_kind::input;
      r.on_input = {1, {user_vertex(v), none, none}, {1, 0, 0}};
      if (input.mesh().halfedge(Gluing_map::Vertex{v}).index != none)
        r.input_face = user_face(input.face(input.outgoing_halfedge(v)));
      return r;
    }
    const Surface_point& p = coordinates_.location(v);
    r.kind = Subdivision_vertex_kind::inserted;
    r.input_face = user_face(input.face(p.halfedge));
    r.input_halfedge = p.halfedge;
    r.on_input = weighted_vertices(t_, p);
    return r;
  }

  void add_crossings() {
    const Crossing_parameters p = parameters();
    const auto& input = coordinates_.input();
    s_.crossings.resize(crossings_.size());
    for (std::uint32_t e = 0; e + 1 < crossings_.begin.size(); ++e)
      for (std::uint32_t i = crossings_.begin[e]; i < crossings_.begin[e + 1]; ++i) {
        const std::uint32_t x = crossings_.entered[i] & ~1U;
        s_.crossings[i] = {
            {x / 2, {user_vertex(input.source(x)), user_vertex(input.target(x))}, p.on_input[i]},
            {e, {row(view_.source(2 * e)), row(view_.target(2 * e))}, p.on_intrinsic[i]}};
      }
  }

  Crossing_parameters parameters() const {
    if constexpr (Scales_vertices<typename Triangulation::Metric>)
      return ideal_crossing_parameters(t_, coordinates_, crossings_);
    else
      return crossing_parameters(t_, coordinates_, crossings_);
  }

  void reserve() {
    // each crossing of a face by a curve adds one face; a curve crosses one more face than edges
    const std::size_t curves = crossings_.size() + crossings_.curve_begin.size() - 1;
    const std::size_t cells = num_faces(t_.mesh()) + curves;
    s_.face_begin.reserve(cells + 1);
    s_.input_face.reserve(cells);
    s_.intrinsic_face.reserve(cells);
    const std::size_t corners = 3 * num_faces(t_.mesh()) + 2 * crossings_.size() + 2 * curves;
    s_.corner.reserve(corners);
    s_.side.reserve(corners);
    s_.intrinsic_halfedge.reserve(corners);
    s_.input_halfedge.reserve(corners);
  }

  // ---- One intrinsic face ----

  void cut(std::uint32_t f) {
    face_ = f;
    sides_ = sides_of_face(view_, view_.halfedge_of_face(f));
    corners_ = corner_coordinates(view_, coordinates_, sides_[0]);
    for (unsigned k = 0; k < 3; ++k) {
      if (view_.is_border(sides_[k] ^ 1U)) ++s_.number_of_border_edges;
      cut_off_corner(k);
    }
    const unsigned fan = corners_.fan_corner();
    if (fan == 3)
      add_middle();
    else
      add_fan(fan);
  }

  std::uint32_t crossing(unsigned side, Normal_coordinate position) const {
    return static_cast<std::uint32_t>(s_.vertices.size()) +
           crossings_.crossing(sides_[side], position);
  }
  // crossing number `i` from corner `k` on the side that comes to it
  std::uint32_t coming(unsigned k, Normal_coordinate i) const {
    const unsigned side = (k + 2) % 3;
    return crossing(side, coordinates_.normal_coordinate(sides_[side] / 2) - 1 - i);
  }
  std::uint32_t corner_vertex(unsigned k) const { return vertex_[view_.source(sides_[k])]; }

  void add_corner(std::uint32_t vertex, std::uint32_t h, std::uint32_t input_halfedge,
                  Common_subdivision::Side side) {
    s_.corner.push_back(vertex);
    s_.side.push_back(side);
    s_.intrinsic_halfedge.push_back(h);
    s_.input_halfedge.push_back(input_halfedge);
  }
  // before a curve along input halfedge `x`, to the left of which the cell is
  void add_corner_before_curve(std::uint32_t vertex, unsigned side, std::uint32_t x) {
    add_corner(vertex, sides_[side], x, {x / 2, none});
  }
  // after a curve along input halfedge `x`
  void add_corner_on_side(std::uint32_t vertex, unsigned side, std::uint32_t x) {
    const std::uint32_t h = sides_[side];
    const bool shared = coordinates_.normal_coordinate(h / 2) < 0;
    add_corner(
        vertex, h, x,
        {shared ? coordinates_.fans().halfedge(coordinates_.roundabout(h)) / 2 : none, h / 2});
  }
  // at the first cell of corner `k`
  void add_vertex_on_side(unsigned k) {
    const Surface_point p = corner_on_input(view_, coordinates_, sides_[k]);
    const bool is_at_target = p.weights[1] == 1;
    add_corner_on_side(corner_vertex(k), k,
                       is_at_target ? coordinates_.input().next(p.halfedge) : p.halfedge);
  }
  void finish_cell(std::uint32_t input_face) {
    s_.face_begin.push_back(static_cast<std::uint32_t>(s_.corner.size()));
    s_.input_face.push_back(user_face(input_face));
    if (t_.input().names().is_cover()) // the names of front and back are consecutive
      s_.sheet.push_back(static_cast<std::uint8_t>(s_.input_face.back() % 2));
    s_.intrinsic_face.push_back(face_);
  }

  void cut_off_corner(unsigned k) {
    for (Normal_coordinate i = 0; i < corners_.cutting[k]; ++i) {
      const std::uint32_t entered = crossings_.entered_by(sides_[k], i);
      add_past_corner(k, i);
      add_corner_before_curve(crossing(k, i), k, entered ^ 1U);
      add_corner_on_side(coming(k, i), (k + 2) % 3, entered ^ 1U);
      finish_cell(coordinates_.input().face(entered ^ 1U));
    }
  }

  // walks past corner `k`, along the last of `n` curves that cut it off if there is one
  void add_past_corner(unsigned k, Normal_coordinate n) {
    if (n > 0) {
      const std::uint32_t entered = crossings_.entered_by(sides_[k], n - 1);
      add_corner_before_curve(coming(k, n - 1), (k + 2) % 3, entered);
      add_corner_on_side(crossing(k, n - 1), k, entered);
    } else {
      add_vertex_on_side(k);
    }
  }

  void add_middle() {
    const auto& c = corners_.cutting;
    for (unsigned k = 0; k < 3; ++k) add_past_corner(k, c[k]);
    const auto& input = coordinates_.input();
    for (unsigned k = 0; k < 3; ++k)
      if (c[k] > 0) return finish_cell(input.face(crossings_.entered_by(sides_[k], c[k] - 1)));
    finish_cell(input.face(corner_on_input(view_, coordinates_, sides_[0]).halfedge));
  }

  void add_fan(unsigned k) {
    const unsigned opposite = (k + 1) % 3;
    const Normal_coordinate first = corners_.cutting[opposite], count = corners_.emanating[k];
    std::uint32_t last = none; // halfedge entered by the last curve
    for (Normal_coordinate i = 0; i <= count; ++i) {
      const std::uint32_t entered =
          i < count ? crossings_.entered_by(sides_[opposite], first + i) : none;
      if (i == 0)
        add_vertex_on_side(k), add_past_corner(opposite, first);
      else {
        add_corner_before_curve(corner_vertex(k), k, last);
        add_corner_on_side(crossing(opposite, first + i - 1), opposite, last);
      }
      if (i < count)
        add_corner_before_curve(crossing(opposite, first + i), opposite, entered ^ 1U);
      else
        add_past_corner((k + 2) % 3, corners_.cutting[(k + 2) % 3]);
      finish_cell(coordinates_.input().face(i == 0 ? entered ^ 1U : last));
      last = entered;
    }
  }

  const Triangulation& t_;
  const Coordinates& coordinates_;
  Intrinsic_view<Triangulation> view_;
  Edge_crossings crossings_;
  Common_subdivision s_;
  std::vector<std::uint32_t> vertex_; // number in the subdivision of each intrinsic vertex
  // of the face that is being cut
  std::uint32_t face_ = 0;
  std::array<std::uint32_t, 3> sides_{};
  Corner_coordinates corners_{};
};

// Extracts the common subdivision (§3.6 of the course), see `common_subdivision()`.
template <class Triangulation, class Coordinates>
Common_subdivision extract_subdivision(const Triangulation& t, const Coordinates& coordinates) {
  return Subdivider<Triangulation, Coordinates>(t, coordinates).subdivide();
}

} // namespace internal

/*!
\brief extracts the common subdivision of an intrinsic triangulation and its input (§3.6 of the
course).

Its connectivity follows from integers alone, so that rounding of the crossings cannot invalidate
it. For where crossings are with an ideal hyperbolic metric, see `ideal_crossing_parameters()`.
\tparam Triangulation a model of `CorrespondingTriangulation`; or of `IndexedTriangulation`, with an
  ideal hyperbolic metric and a correspondence by curves
\param t the triangulation
\throws std::length_error if there are more than 2^31 crossings
\throws Invalid_input naming an intrinsic edge whose path signposts cannot find
\complexity linear in the size of the result
*/
template <QueriedTriangulation Triangulation>
Common_subdivision common_subdivision(const Triangulation& t) {
  return internal::extract_subdivision(t, internal::queries(t).curves());
}

/// \cond the same with an ideal hyperbolic metric: doxygen cannot tell the two apart
template <IndexedTriangulation Triangulation>
  requires internal::Scales_vertices<typename Triangulation::Metric> &&
      internal::Has_curves<Triangulation>
          Common_subdivision common_subdivision(const Triangulation& ideal) {
    return internal::extract_subdivision(ideal, ideal.correspondence());
  }

CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(common_subdivision)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_COMMON_SUBDIVISION_H
