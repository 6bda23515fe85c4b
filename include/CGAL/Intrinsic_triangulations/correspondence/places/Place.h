// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_PLACES_PLACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_PLACES_PLACE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <array>
#include <cstdint>

/*!
\file
Points as users name them, by numbers of their vertices and faces, and the one way to read them.
*/

namespace CGAL::Intrinsic_triangulations {

class Input;

/*!
\brief is a point that a user names: a vertex, or a point in one of the user's triangles.

The same point may be named in several ways: a corner as a vertex and in each of its faces, a point
on an edge in two faces. `normalized()` and `Place_finder` make all of them one.
*/
struct Place {
  /// The vertex by its row in matrices, also that of an inserted vertex; `Gluing::none`: the place
  /// is in a face.
  std::uint32_t vertex = Gluing::none;
  /// The user's face in which the point was named; `Gluing::none` if it was named as a vertex.
  std::uint32_t face = Gluing::none;
  /// Weights of the corners of the face, in the order in which it lists them; they sum to 1. Faces
  /// of a BGL mesh begin with the source of their halfedge, as in CGAL's `Face_location`.
  std::array<double, 3> weights{1, 0, 0};

  /// returns the place at a vertex.
  static Place at_vertex(std::uint32_t row) { return {row, Gluing::none, {1, 0, 0}}; }
  /// returns the place in a face with weights of its corners.
  static Place in_face(std::uint32_t face, const std::array<double, 3>& weights) {
    return {Gluing::none, face, weights};
  }

  /// tells whether it is known to be a vertex; `normalized()` finds that out.
  bool is_vertex() const { return vertex != Gluing::none; }
  /// tells whether it was named in a face, to whose frame directions refer.
  bool has_face() const { return face != Gluing::none; }
};

/*!
\brief reads a place: weights are made to sum to 1, and a place at a corner becomes a vertex.

It keeps the face in which it was named, whose frame directions refer to.
\param input the surface; on a cover, faces are those of the user
\param place the place
\throws Invalid_input naming the face if it does not exist or is a polygon, or if weights are
  negative or not finite, or do not sum to 1 up to 1e-6
\complexity constant; for meshes with polygons and for covers, logarithmic
*/
Place normalized(const Input& input, const Place& place);

/*!
\brief returns a point of the input at a place, as its face names it: the halfedge begins the face.

On a cover this is the front of the face. A place without a face is a corner of the vertex, on a
cover of the first of its copies.
\param input the surface
\param place a place that is normalized
\pre a vertex without a face is one of the input, and not isolated
\complexity that of `normalized()`
*/
Surface_point point_on_input(const Input& input, const Place& place);

namespace internal {

// The same point, of which a name is chosen by where it is, not by the face that named it: on an
// edge, in the frame of its even halfedge, unless that has no face.
Surface_point with_one_name(const Input& input, const Surface_point& p);

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_PLACES_PLACE_H
