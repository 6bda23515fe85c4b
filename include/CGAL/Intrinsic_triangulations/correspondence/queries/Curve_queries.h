// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_CURVE_QUERIES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_CURVE_QUERIES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/CurveCoordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Intrinsic_locator.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Unfolded_face.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/trace_by_curves.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstdint>
#include <optional>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief answers all that queries ask of a correspondence, by curves.

A correspondence that is no model of `CurveCoordinates` has a member template `queries(t)`, which returns an object with the
same functions: `locate_on_input()` and all other queries ask that.
\tparam Triangulation an `Intrinsic_triangulation`
\tparam Coordinates a model of `CurveCoordinates`
*/
template <class Triangulation, CurveCoordinates Coordinates>
class Curve_queries {
public:
  /// refers to a triangulation and to what tells how it lies on its input.
  Curve_queries(const Triangulation& t, const Coordinates& curves) : t_(t), curves_(curves) {}

  /// returns the point of the input at a point of the triangulation; nothing: it is not found.
  std::optional<Mapped_point> on_input(const Surface_point& p) const {
    Unfolded_face<double> face;
    face.unfold(Intrinsic_view<Triangulation>(t_), curves_, p.halfedge,
                approximate_values(curves_.input()));
    return face.locate(p.weights);
  }
  /// returns the point of the triangulation at a point of the input; nothing: it is not found.
  std::optional<Mapped_point> on_intrinsic(const Surface_point& p) const {
    return internal::Intrinsic_locator<Triangulation, Coordinates>(t_, curves_).locate(p);
  }
  /// returns the way of halfedge `2 * edge` of the triangulation over the input.
  Edge_path path_on_input(std::uint32_t edge) const {
    return internal::trace_edge_by_curves(t_, curves_, edge);
  }
  /// returns the way of halfedge `x` of the input over the triangulation.
  Edge_path path_on_intrinsic(std::uint32_t x) const {
    return internal::trace_input_edge_by_curves(t_, curves_, x);
  }
  /// returns the edge of the input that an edge of the triangulation runs along; none: it does not.
  std::uint32_t input_edge_along(std::uint32_t edge) const {
    if (curves_.normal_coordinate(edge) >= 0) return Gluing::none;
    return curves_.fans().halfedge(curves_.roundabout(2 * edge)) / 2;
  }
  /// starts a geodesic on the input from the source of a halfedge of the triangulation, at an angle from it.
  Geodesic_walk<Input> walk_on_input(std::uint32_t h, double turn) const {
    return internal::walk_by_curves(t_, curves_, h, turn);
  }
  /// returns the direction on the triangulation at an angle from halfedge `x` of the input, at its source.
  std::optional<Corner_direction> direction_on_intrinsic(std::uint32_t x, double turn) const {
    auto direction = internal::direction_on_intrinsic(t_, curves_, x);
    if (direction) direction->angle += turn;
    return direction;
  }
  /// returns coordinates that a common subdivision is made from.
  const Coordinates& curves() const { return curves_; }

private:
  const Triangulation& t_;
  const Coordinates& curves_;
};

namespace internal {

// What answers queries about a triangulation.
template <class Triangulation>
auto queries(const Triangulation& t) {
  const auto& correspondence = t.correspondence();
  if constexpr (requires { correspondence.queries(t); })
    return correspondence.queries(t);
  else
    return Curve_queries(t, correspondence);
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_CURVE_QUERIES_H
