// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_POINTS_ON_INPUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_POINTS_ON_INPUT_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Crossing_run.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <CGAL/enum.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
Where vertices and edges of the intrinsic triangulation are on the input, by integer coordinates.
*/

namespace CGAL::Intrinsic_triangulations {

/// returns the input halfedge along which a curve starts.
template <CurveCoordinates Coordinates>
std::uint32_t input_halfedge(const Coordinates& coordinates, const Curve_end& start) {
  const std::uint32_t h = start.halfedge;
  const std::uint32_t on_it = coordinates.normal_coordinate(h / 2) < 0 ? 1 : 0;
  return coordinates.fans().halfedge(coordinates.fans().advance(
      coordinates.roundabout(h), on_it + static_cast<std::uint32_t>(start.index)));
}

namespace internal {

/*!
\brief finds the input halfedges of the faces that an intrinsic halfedge enters: reads them, or
follows the curves.
\param view, coordinates the triangulation
\param h the halfedge
\param from, to number of the first one, and of that behind the last one
\param entered they are put there, at their numbers
\param stack memory to use
\return the number of steps along curves
*/
template <class View, CurveCoordinates Coordinates>
std::size_t find_entered(const View& view, const Coordinates& coordinates, std::uint32_t h,
                         Normal_coordinate from, Normal_coordinate to,
                         std::vector<std::uint32_t>& entered, std::vector<Curve_bundle>& stack) {
  if (from == to) return 0;
  if constexpr (requires { coordinates.knows_crossings(); })
    if (coordinates.knows_crossings()) {
      std::uint32_t* place = entered.data() + from;
      coordinates.for_each_run_of(h, from, to, [&](const Crossing_run& run) {
        for (std::uint32_t i = 0; i < run.count(); ++i) *place++ = run(coordinates.fans(), i);
      });
      return 0;
    }
  return follow_curves(view, coordinates, {h, from, to - from, from}, stack,
                       [&](Normal_coordinate i, const Curve_end& end) {
                         // the curve crosses from left to right; the way back starts along its
                         // opposite
                         entered[static_cast<std::size_t>(i)] =
                             input_halfedge(coordinates, end) ^ 1U;
                       });
}

/*!
\brief finds all of them for a side of a face; it does not follow curves from the opposite corner.
\return the number of steps along curves
*/
template <class View, CurveCoordinates Coordinates>
std::size_t find_entered_from_face(const View& view, const Coordinates& coordinates,
                                   std::uint32_t side, std::vector<std::uint32_t>& entered,
                                   std::vector<Curve_bundle>& stack) {
  const Corner_coordinates c = corner_coordinates(view, coordinates, side);
  const Normal_coordinate n = crossings(coordinates.normal_coordinate(side / 2)),
                          from = c.emanating[2] > 0 ? c.cutting[0] : n, to = from + c.emanating[2];
  entered.resize(static_cast<std::size_t>(n));
  const std::uint32_t last = view.next(view.next(side));
  for (Normal_coordinate i = from; i < to; ++i)
    entered[static_cast<std::size_t>(i)] = input_halfedge(coordinates, Curve_end{last, i - from});
  return find_entered(view, coordinates, side, 0, from, entered, stack) +
         find_entered(view, coordinates, side, to, n, entered, stack);
}

/*!
\brief appends the same as `find_entered()` to runs: those that are stored, or single ones.
\return the number of steps along curves
*/
template <class View, CurveCoordinates Coordinates>
std::size_t append_entered(const View& view, const Coordinates& coordinates, std::uint32_t h,
                           Normal_coordinate from, Normal_coordinate to,
                           std::vector<Crossing_run>& runs, std::vector<Curve_bundle>& stack) {
  if (from == to) return 0;
  if constexpr (requires { coordinates.knows_crossings(); })
    if (coordinates.knows_crossings()) {
      coordinates.for_each_run_of(h, from, to,
                                  [&](const Crossing_run& run) { runs.push_back(run); });
      return 0;
    }
  const std::size_t before = runs.size();
  runs.resize(before + static_cast<std::size_t>(to - from));
  return follow_curves(
      view, coordinates, {h, from, to - from, 0}, stack,
      [&](Normal_coordinate i, const Curve_end& end) {
        runs[before + static_cast<std::size_t>(i)] = {input_halfedge(coordinates, end) ^ 1U, 1};
      });
}

/// appends the same as `find_entered_from_face()`.
template <class View, CurveCoordinates Coordinates>
std::size_t append_entered_from_face(const View& view, const Coordinates& coordinates,
                                     std::uint32_t side, std::vector<Crossing_run>& runs,
                                     std::vector<Curve_bundle>& stack) {
  const Corner_coordinates c = corner_coordinates(view, coordinates, side);
  const Normal_coordinate n = crossings(coordinates.normal_coordinate(side / 2)),
                          count = c.emanating[2], from = count > 0 ? c.cutting[0] : n;
  const std::size_t steps = append_entered(view, coordinates, side, 0, from, runs, stack);
  const std::uint32_t last = view.next(view.next(side));
  if (count > 2) // from a vertex on an input edge, only two start
    runs.emplace_back(input_halfedge(coordinates, Curve_end{last, 0}),
                      static_cast<std::uint32_t>(count));
  else
    for (Normal_coordinate i = 0; i < count; ++i)
      runs.emplace_back(input_halfedge(coordinates, Curve_end{last, i}), 1);
  return steps + append_entered(view, coordinates, side, from + count, n, runs, stack);
}

/// returns all of them.
template <class View, CurveCoordinates Coordinates>
std::vector<std::uint32_t> find_entered(const View& view, const Coordinates& coordinates,
                                        std::uint32_t h) {
  const Normal_coordinate n = crossings(coordinates.normal_coordinate(h / 2));
  std::vector<std::uint32_t> entered(static_cast<std::size_t>(n));
  std::vector<Curve_bundle> stack;
  find_entered(view, coordinates, h, 0, n, entered, stack);
  return entered;
}

} // namespace internal

/// returns the face of an input halfedge and its slot there. \pre it has a face
inline Face_side input_side(const Input& input, std::uint32_t halfedge) {
  const std::uint32_t f = input.face(halfedge), first = input.halfedge_of_face(f);
  if (halfedge == first) return {f, 0};
  return {f, halfedge == input.next(first) ? 1U : 2U};
}

/*!
\brief returns the position of a vertex on an input halfedge: 0 at its source, 1 at its target.
\param coordinates a correspondence with the locations of inserted vertices
\param vertex an intrinsic vertex
\param halfedge an input halfedge, of which a part starts or ends at the vertex
\param starts whether a part of it starts from the vertex
*/
template <class Coordinates>
  requires requires(const Coordinates& c, std::uint32_t v) {
    { c.is_inserted(v) } -> std::same_as<bool>;
    { c.location(v) } -> std::convertible_to<Surface_point>;
  }
double parameter_on_halfedge(const Coordinates& coordinates, std::uint32_t vertex,
                             std::uint32_t halfedge, bool starts) {
  if (!coordinates.is_inserted(vertex)) return starts ? 0 : 1;
  const Surface_point& p = coordinates.location(vertex);
  return p.halfedge == halfedge ? p.weights[1] : p.weights[0];
}

/// returns the vector from a point of a complex to another one of the same face, in the frame of
/// the first.
template <NumberedComplex Complex>
Unscaled_vector vector_between(const Complex& complex, const Surface_point& from,
                               const Surface_point& to) {
  const Geodesic_face face(complex, from.halfedge);
  return unscaled(face.to_corner(from.weights, 0) -
                      face.to_corner(seen_from(complex, to, from.halfedge).weights, 0),
                  complex.scale_exponent());
}

/*!
\brief returns the point of the input at a corner of an intrinsic face, in the input face in which
the corner begins, counterclockwise from its first side.
\param view the intrinsic triangulation
\param coordinates the correspondence
\param side first side of the corner
*/
template <NumberedComplex View, CurveCoordinates Coordinates>
Surface_point corner_on_input(const View& view, const Coordinates& coordinates,
                              std::uint32_t side) {
  const std::uint32_t slot = coordinates.roundabout(side), vertex = view.source(side);
  if (slot == Gluing::none) return coordinates.location(vertex);
  const std::uint32_t h = coordinates.fans().halfedge(slot);
  const double x = parameter_on_halfedge(coordinates, vertex, h, true);
  return coordinates.normal_coordinate(side / 2) < 0 ? Surface_point{h, {1 - x, x, 0}}
                                                     : Surface_point{h ^ 1U, {x, 1 - x, 0}};
}

/*!
\brief returns the point of the input at a point of an intrinsic edge that runs along an input edge.
\param view the intrinsic triangulation
\param coordinates the correspondence
\param h a halfedge of the edge, with a face
\param parameter 0 at the source of `h`, 1 at its target
\return a point on a halfedge of the input with the direction of `h`
*/
template <NumberedComplex View, CurveCoordinates Coordinates>
Surface_point location_on_side(const View& view, const Coordinates& coordinates, std::uint32_t h,
                               double parameter) {
  const std::uint32_t x = coordinates.fans().halfedge(coordinates.roundabout(h));
  const double from = parameter_on_halfedge(coordinates, view.source(h), x, true);
  const double to = parameter_on_halfedge(coordinates, view.target(h), x, false);
  const double along = from + parameter * (to - from);
  return {x, {1 - along, along, 0}};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_POINTS_ON_INPUT_H
