// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TANGENT_TRANSFER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TANGENT_TRANSFER_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Crossing_parameters.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_edge.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/tangent_frames.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
Tangent vectors at vertices, from the input to the intrinsic triangulation and back, by correspondences
that store no directions: the integers tell the sector, the input's geometry the angle within it.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The point of the first input face of a halfedge that starts between two input halfedges: where it
// leaves that face, or its end. The halfedge crosses the input halfedges `entered`, from that with
// the number 2e; `first` is the side of the face that starts at its source.
template <class View, class Coordinates>
Surface_point end_in_first_face(const View& view, const Coordinates& coordinates, std::uint32_t h,
                                const std::vector<std::uint32_t>& entered, std::uint32_t first) {
  const std::uint32_t even = h & ~1U;
  const auto& input = coordinates.input();
  if (entered.empty())
    return seen_from(input, corner_on_input(coordinates, h ^ 1U, view.target(h)), first);
  Edge_strip strip(input);
  strip.unfold(corner_on_input(coordinates, even, view.source(even)),
               corner_on_input(coordinates, even ^ 1U, view.target(even)), entered);
  // the weight of the end of the side that `first` points to
  if (h == even) return {first, {0, strip.parameter(0), 1 - strip.parameter(0)}};
  const double last = strip.parameter(entered.size() - 1);
  return {first, {0, 1 - last, last}};
}

} // namespace internal

/*!
\brief returns the direction of an intrinsic halfedge that starts at a vertex of the input, as a cone
angle in the frame of the input (§2.4 of the course).

It is what `Signposts` store, but each is computed for itself: from the sector that the roundabout
tells, and from the straight line through the faces of the input that the edge crosses. The error does not
grow with the number of moves.
\tparam Triangulation an instance of `Intrinsic_triangulation`
\tparam Coordinates a model of `CurveCoordinates`: `Integer_coordinates`, `Explicit_crossings`
\param t the triangulation
\param coordinates its correspondence
\param frames the directions of its input, `Tangent_frames(coordinates.input())`
\param h the halfedge
\pre the source of `h` is a vertex of the input
\complexity that of `trace_edge()`
*/
template <class Triangulation, class Coordinates>
double cone_angle_on_input(const Triangulation& t, const Coordinates& coordinates,
                           const Tangent_frames& frames, std::uint32_t h) {
  const Intrinsic_view<Triangulation> view(t);
  const auto& input = coordinates.input();
  const std::uint32_t after = coordinates.fans().halfedge(coordinates.roundabout(h));
  if (coordinates.normal_coordinate(h / 2) < 0) return frames.cone_angle(after);
  const std::uint32_t first = input.next(after ^ 1U); // before `h`, counterclockwise
  const Surface_point p = internal::end_in_first_face(
      view, coordinates, h, internal::entered_on(t, coordinates, h / 2), first);
  const Planar_vector<double> back = Geodesic_face(input, first).to_corner(p.weights, 0);
  return frames.cone_angle(first) + std::atan2(std::max(0.0, -back[1]), -back[0]);
}

/*!
\brief takes a tangent vector at a vertex of the input to the frame of an intrinsic halfedge that starts
there.
\param t the triangulation
\param coordinates its correspondence
\param frames the directions of its input
\param h the halfedge
\param v the vector in the polar coordinates of the input
\return the vector in a plane in which `h` runs along the first axis, and its face is above it
\pre the source of `h` is a vertex of the input
\complexity that of `cone_angle_on_input()`
*/
template <class Triangulation, class Coordinates>
Planar_vector<double> vector_to_intrinsic(const Triangulation& t, const Coordinates& coordinates,
                                          const Tangent_frames& frames, std::uint32_t h,
                                          const Polar_vector& v) {
  const std::uint32_t x = coordinates.fans().halfedge(coordinates.roundabout(h));
  return planar_vector(frames.fan(frames.fan_of(x)), cone_angle_on_input(t, coordinates, frames, h),
                       v);
}

/*!
\brief takes a tangent vector from the frame of an intrinsic halfedge to the polar coordinates of the
input at its source.
\param t the triangulation
\param coordinates its correspondence
\param frames the directions of its input
\param h the halfedge
\param v the vector, see `vector_to_intrinsic()`
\pre the source of `h` is a vertex of the input
\complexity that of `cone_angle_on_input()`
*/
template <class Triangulation, class Coordinates>
Polar_vector vector_to_input(const Triangulation& t, const Coordinates& coordinates,
                             const Tangent_frames& frames, std::uint32_t h,
                             const Planar_vector<double>& v) {
  const std::uint32_t x = coordinates.fans().halfedge(coordinates.roundabout(h));
  return polar_vector(frames.fan(frames.fan_of(x)), cone_angle_on_input(t, coordinates, frames, h),
                      v);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TANGENT_TRANSFER_H
