// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_PLACES_TANGENTS_AT_PLACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_PLACES_TANGENTS_AT_PLACES_H

#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <array>
#include <complex>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

using Vector_in_space = std::array<double, 3>;

// Projects vectors in space to faces of the input.
class Space_projector {
public:
  // \param points where the user's vertices are; both must outlive this object
  Space_projector(const Input& input, const std::vector<Vector_in_space>& points)
      : input_(input), points_(points), sheets_(input) {}

  // to the nearest face at a point that is no vertex
  Tangent_vector at_point(const Surface_point& p, const Vector_in_space& v) const;
  // to the nearest face about all copies of a vertex of the input, which is not isolated
  Tangent_vector at_vertex(std::uint32_t vertex, const Vector_in_space& v) const;

private:
  const Input& input_;
  const std::vector<Vector_in_space>& points_;
  Sheets sheets_;
};

} // namespace internal

/*!
\brief finds tangent vectors at places that a user names: two coordinates in the tangent plane, or
vectors in space.

In a face, the real axis of the tangent plane runs along its first side; at a place that is named as
a vertex, coordinates are polar, see `Tangent_field`. A vector in space is projected to the face of
the place, whichever face named it: on an edge to the nearer one of both, and of more than two to
the nearest one that it does not point out of; at a vertex it keeps its length and is turned into
the face whose plane is nearest to it. At the border the planes of the first and the last face go on
beyond it: a vector that points out of the surface stays outside. On a cover, vectors are on the
front of the nearest face.
\tparam Triangulation a model of `CorrespondingTriangulation`
*/
template <QueriedTriangulation Triangulation>
class Tangents_at_places {
public:
  /// Vertex of the triangulation.
  using vertex_descriptor = typename Triangulation::vertex_descriptor;

  /// prepares the search. \param t the triangulation \param points coordinates of the user's
  /// vertices, none of an abstract metric; both must outlive this object unchanged
  /// \complexity linear
  Tangents_at_places(const Triangulation& t, const std::vector<std::array<double, 3>>& points)
      : t_(t), points_(points), find_(t), project_(t.input(), points) {}

  /// returns the vector on the triangulation that has coordinates in the tangent plane.
  /// \param place the place, normalized \throws Invalid_input as `Place_finder`
  /// \complexity that of `tangent_to_intrinsic()`
  Tangent_vector operator()(const Place& place, const std::complex<double>& z) {
    if (!place.has_face()) return tangent_vector(t_, find_.vertex(place.vertex), z);
    return find_.tangent(place, {z.real(), z.imag()});
  }
  /// returns the vector on the triangulation that is the projection of one in space.
  /// \throws Invalid_input also if the vector is not finite, there are no points, or the place is
  /// an inserted vertex
  /// \complexity that of `tangent_to_intrinsic()`; at a vertex, linear in the degrees of all copies
  Tangent_vector operator()(const Place& place, const std::array<double, 3>& v) {
    return tangent_to_intrinsic(t_, on_input(place, v)).value();
  }

  /// returns the vector on the input that has coordinates in the tangent plane, see above.
  Tangent_vector on_input(const Place& place, const std::complex<double>& z) {
    if (place.has_face()) return {point_on_input(t_.input(), place), {z.real(), z.imag()}};
    return tangent_to_input(t_, (*this)(place, z)).value();
  }
  /// returns the projection to the input of a vector in space, see above.
  Tangent_vector on_input(const Place& place, const std::array<double, 3>& v) {
    if (points_.empty())
      throw Invalid_input(Element_kind::none, 0,
                          "vectors in space need points, and this surface has lengths alone; give "
                          "a complex number, two coordinates in the tangent plane");
    const double norm = std::hypot(v[0], v[1], v[2]);
    if (!std::isfinite(norm))
      throw Invalid_input(Element_kind::none, 0, "a vector is not finite; give others");
    if (!place.is_vertex()) return project_.at_point(point_on_input(t_.input(), place), v);
    const vertex_descriptor at = find_.vertex(place.vertex);
    if (t_.is_inserted(at))
      throw Invalid_input::about(Element_kind::vertex, place.vertex,
                                 " was inserted; give two coordinates in its tangent plane");
    Tangent_vector result = project_.at_vertex(t_.index(at), v);
    const double length = std::hypot(result.vector[0], result.vector[1]);
    if (length > 0) result.vector = (norm / length) * result.vector;
    return result;
  }

  /// returns what finds places.
  Place_finder<Triangulation>& places() { return find_; }

private:
  const Triangulation& t_;
  const std::vector<std::array<double, 3>>& points_;
  Place_finder<Triangulation> find_;
  internal::Space_projector project_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_PLACES_TANGENTS_AT_PLACES_H
