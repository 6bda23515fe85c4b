// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_UNFOLDED_FACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_UNFOLDED_FACE_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Face_development.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Turned_positions.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief places points of an intrinsic face on the input triangles over which it lies.

These are developed into the plane, such that the first side of the first triangle runs from 0 to 1.
\tparam FT `double`, `Interval_nt<false>` or a `Ball`
*/
template <FieldNumber FT>
class Unfolded_face {
public:
  /// A point of the plane.
  using Point = Plane_vector<FT>;
  /// A point of the face.
  using Place = Place_in_face;
  /// A functor from an input halfedge to the values of its face from it.
  using Values = typename internal::Turned_positions<FT>::Values;
  /// Relative distance within which a point is put on a curve: a few roundings of a circumcenter.
  static constexpr double usual_nearness = 0x1p-40;
  /// The unit of weights.
  static constexpr double least_nearness = 0x1p-52;

  /*!
  \brief unfolds the face of a halfedge.
  \param values gives the values of the face of an input halfedge, from it; it and the coordinates
    must live as long as points are placed
  \complexity see `Face_development`
  */
  template <NumberedTriangles Complex, CurveCoordinates Coordinates>
  void unfold(const Complex& complex, const Coordinates& coordinates, std::uint32_t h,
              Values values) {
    face_.unfold(complex, coordinates, h);
    other_ = nullptr;
    z_.develop(face_.triangles(), coordinates.input(), coordinates.fans(), std::move(values));
  }
  /// unfolds a face that was unfolded in other numbers, which must live unchanged as long as points
  /// are placed: its triangles, which may be thousands, are not copied.
  template <FieldNumber Other>
  void unfold(const Unfolded_face<Other>& face, Values values) {
    other_ = &face.development();
    z_.develop(development().triangles(), face.positions().input(), face.positions().fans(),
               std::move(values));
  }

  /// returns the triangles under the face, and how they were found.
  const Face_development& development() const { return other_ != nullptr ? *other_ : face_; }
  /// returns where the points of these triangles are.
  const internal::Turned_positions<FT>& positions() const { return z_; }

  /*!
  \brief places a point of the face on the input: finds the triangle that contains it, and rounds
  its barycentric coordinates there, which then define it. A point within rounding of a curve is put
  on it.
  \param weights barycentric coordinates of the point in the face, approximately
  \param nearness distance from a curve within which a point is put on it, relative to the height of
    the triangle; what is represented beside it is at least `least_nearness` away
  \return the place; nothing if it is within rounding of a vertex of the input
  */
  std::optional<Place> place(const std::array<double, 3>& weights,
                             double nearness = usual_nearness) const;

  /*!
  \brief places a point of the first side, which runs along an input edge.
  \param input the input
  \param location a point of the input halfedge that runs beside the face, approximately
  \return the place; nothing if it is within rounding of an end
  */
  std::optional<Place> place_on_side(const Input& input, const Surface_point& location) const;

  /*!
  \brief places a point whose place on the input is known.
  \param input the input
  \param wanted the place: multiples of 2^-52; on an edge if the last weight is zero
  \param weights barycentric coordinates of the point in the face, approximately: they select the
    place if the face lies twice over an input triangle
  \return the place; nothing if the place is not under the face, or its edge runs along a side of
  the face
  */
  std::optional<Place> place_at(const Input& input, const Surface_point& wanted,
                                const std::array<double, 3>& weights) const;

  /// tells whether errors of points are too large for the middles of their intervals.
  template <class Interval = FT> // other numbers have no bounds
  bool is_vague() const {
    return z_.template is_vague<Interval>();
  }

  /*!
  \brief computes the values at a vertex that is inserted at a place.
  \return squared lengths of ip, jp, kp and quadruple areas of ijp, jkp, kip, which are positive if
  and only if the place is in the face
  */
  Vertex_move_values<FT> values(const Place& p) const;

  /// returns the values of the face, from its first side on.
  Face_values<FT> face_values() const;

  /// returns the corner that is farthest from a place: its direction is the most accurate one.
  Seen_corner farthest_corner(const Input& input, const Place& p) const;

  /*!
  \brief finds the point of the input at a point of the face, without rounding it.
  \param weights barycentric coordinates of the point in the face
  \return the point, and the direction of its halfedge from the first side of the face
  */
  Mapped_point locate(const std::array<double, 3>& weights) const;

private:
  using Corner = Face_development::Corner;
  using Rounded = Plane_vector<double>;

  std::uint32_t halfedge(std::uint32_t t) const { return development().triangles().side(t); }
  Point point(std::uint32_t t, std::size_t k) const {
    return z_[development().triangles().points(t)[k]];
  }
  static Rounded approximate(const Point& p);
  Rounded rounded_point(std::uint32_t t, std::size_t k) const { return approximate(point(t, k)); }

  Point position(const Corner& c) const;

  // from a place to a corner of the face; in one triangle differences of weights are exact
  Point to_corner(const Place& from, unsigned k) const;

  Rounded in_face(const std::array<double, 3>& weights) const;
  Rounded in_triangle(std::uint32_t t, const std::array<double, 3>& weights) const;
  std::array<double, 3> weights_in_triangle(std::uint32_t t, const Rounded& p) const;

  // the region and the triangle of a point
  Place region_of(const Rounded& p) const;

  // a place on the input from the first side of a triangle, if it is in it
  std::optional<Surface_point> seen_in(const Input& input, std::uint32_t t,
                                       const Surface_point& p) const;

  // a point of a triangle, from its first side on
  std::optional<Place> at(std::uint32_t t, const Surface_point& p) const;

  // the direction of the halfedge of the location, on the side of the edge where the place is
  Rounded along(const Input& input, const Place& p) const;

  bool rounded(std::array<double, 3> w, double nearness, Place& result) const;

  // on the curve over which a triangle is entered, opposite a corner of the triangle of the place
  bool put_on_curve(std::uint32_t child, unsigned opposite, std::array<double, 3> w,
                    Place& result) const;

  Face_development face_;
  const Face_development* other_ = nullptr; // in place of that
  internal::Turned_positions<FT> z_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_UNFOLDED_FACE_H
