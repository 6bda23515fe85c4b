// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRACING_GEODESIC_FACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRACING_GEODESIC_FACE_H

#include <CGAL/Intrinsic_triangulations/connectivity/NumberedComplex.h>
#include <CGAL/Intrinsic_triangulations/formulas/corner_angles.h>
#include <CGAL/Intrinsic_triangulations/formulas/local_coordinates.h>

#include <array>
#include <cmath>
#include <cstdint>

/*!
\file
Faces in the plane, and angles about vertices, read by number from the input or from the intrinsic
triangulation (§2.3.7 and §2.4 of the course).

What they are read from is a model of `NumberedComplex`: `Input`, `Intrinsic_view`.
*/

namespace CGAL::Intrinsic_triangulations {

/// Inner product of vectors in the plane.
inline double planar_dot(const Planar_vector<double>& a, const Planar_vector<double>& b) {
  return a[0] * b[0] + a[1] * b[1];
}

/// Cross product of vectors in the plane: positive if `b` is to the left of `a`.
inline double planar_cross(const Planar_vector<double>& a, const Planar_vector<double>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// returns the sides of the face of `h`, from `h` on.
template <class Complex>
std::array<std::uint32_t, 3> sides_of_face(const Complex& complex, std::uint32_t h) {
  const std::uint32_t n = complex.next(h);
  return {h, n, complex.next(n)};
}

/// returns the squared lengths of the sides of the face of `h`, from `h` on.
template <class Complex>
std::array<double, 3> squared_lengths_of_face(const Complex& complex, std::uint32_t h) {
  const auto [ij, jk, ki] = sides_of_face(complex, h);
  return {complex.squared_length(ij / 2), complex.squared_length(jk / 2),
          complex.squared_length(ki / 2)};
}

/*!
\brief is a face laid out in the plane, in the frame of one of its halfedges: the source is at the
origin, the target on the positive x-axis, the apex above.

Sides are stored as vectors, each computed for itself: that from the target to the apex does not lose
what the difference of their positions would (Eqs. 25 and 26, as p / (2 l) and a / (2 l)).
*/
struct Geodesic_face {
  std::array<std::uint32_t, 3> side;         ///< the halfedge of the frame, the next and the last
  std::array<Planar_vector<double>, 3> edge; ///< vector along each side
  std::array<double, 3> length;              ///< length of each side

  /*!
  \brief lays out the face of `h`.
  \tparam Complex a model of `NumberedComplex`
  \pre `h` has a face
  */
  template <NumberedComplex Complex>
  Geodesic_face(const Complex& complex, std::uint32_t h) : side(sides_of_face(complex, h)) {
    const auto [ij, jk, ki] = squared_lengths_of_face(complex, h);
    length = {std::sqrt(ij), std::sqrt(jk), std::sqrt(ki)};
    const double two_l = 2 * length[0];
    if (two_l > 0) {
      const double height = complex.quadruple_area(complex.face(h)) / two_l;
      edge = {{{length[0], 0},
               {-twice_inner_product(jk, ki, ij) / two_l, height},
               {-twice_inner_product(ij, jk, ki) / two_l, -height}}};
    } else { // two corners in one place: the other two sides lie on each other
      edge = {{{0, 0}, {0, length[1]}, {0, -length[2]}}};
    }
  }

  /// returns the vector from a point to a corner; the differences are taken between corners.
  Planar_vector<double> to_corner(const std::array<double, 3>& weights, unsigned corner) const {
    const unsigned n = (corner + 1) % 3, p = (corner + 2) % 3;
    return {weights[p] * edge[p][0] - weights[n] * edge[corner][0],
            weights[p] * edge[p][1] - weights[n] * edge[corner][1]};
  }

  /// returns where a point is.
  Planar_vector<double> position(const std::array<double, 3>& weights) const {
    const Planar_vector<double> back = to_corner(weights, 0);
    return {0 - back[0], 0 - back[1]};
  }

  /// returns a direction relative to side `s`: along it, and to the left of it.
  Planar_vector<double> relative_to(unsigned s, const Planar_vector<double>& v) const {
    if (!(length[s] > 0)) return v;
    return {planar_dot(edge[s], v) / length[s], planar_cross(edge[s], v) / length[s]};
  }

  /// returns a direction that is given relative to side `s`.
  Planar_vector<double> from_relative_to(unsigned s, const Planar_vector<double>& v) const {
    if (!(length[s] > 0)) return v;
    return {(edge[s][0] * v[0] - edge[s][1] * v[1]) / length[s],
            (edge[s][1] * v[0] + edge[s][0] * v[1]) / length[s]};
  }
};

/*!
\brief returns the angle at the source of `h` in the face of `h`.
\tparam Complex a model of `NumberedComplex`
\pre `h` has a face
*/
template <NumberedComplex Complex>
double angle_at_source(const Complex& complex, std::uint32_t h) {
  const auto [ij, jk, ki] = squared_lengths_of_face(complex, h);
  return corner_angle(complex.quadruple_area(complex.face(h)), twice_inner_product(ij, jk, ki));
}

/// returns the halfedge with the same source that comes after `h` counterclockwise. \pre `h` has a
/// face
template <NumberedComplex Complex>
std::uint32_t next_around_source(const Complex& complex, std::uint32_t h) {
  return complex.next(complex.next(h)) ^ 1U;
}

/*!
\brief returns the sum of the angles about the source of `h`, over the fan of faces of `h` if it is a
nonmanifold vertex.
\tparam Complex a model of `NumberedComplex`
\param complex the complex
\param h a halfedge
\param is_on_border becomes true where the fan is not closed
\complexity linear in the degree
*/
template <NumberedComplex Complex>
double cone_angle(const Complex& complex, std::uint32_t h, bool& is_on_border) {
  is_on_border = false;
  double sum = 0;
  std::uint32_t g = h;
  while (!complex.is_border(g)) {
    sum += angle_at_source(complex, g);
    g = next_around_source(complex, g);
    if (g == h) return sum;
  }
  is_on_border = true;
  for (g = h; !complex.is_border(g ^ 1U);) {
    g = complex.next(g ^ 1U);
    sum += angle_at_source(complex, g);
  }
  return sum;
}

/// A direction from a vertex into a face.
struct Corner_direction {
  std::uint32_t halfedge; ///< starts at the vertex and has a face
  double angle;           ///< from it counterclockwise, between zero and the angle of the corner
};

/*!
\brief turns counterclockwise about the source of a halfedge, or clockwise if the angle is negative.
\tparam Complex a model of `NumberedComplex`
\param complex the complex
\param d where to start, and by what angle to turn: any number; replaced by the corner that is reached
\param tolerance angle beyond the border that is taken for rounding
\return false if the direction points beyond the border
\complexity linear in the number of corners passed, at most in the degree, whatever the angle
*/
template <NumberedComplex Complex>
bool turn(const Complex& complex, Corner_direction& d, double tolerance = 0x1p-48) {
  bool is_reduced = false;
  const std::uint32_t first = d.halfedge;
  const auto reduce = [&] { // once around: the angle modulo that of the cone is left
    if (is_reduced) return false;
    is_reduced = true;
    bool is_on_border = false;
    const double all = cone_angle(complex, d.halfedge, is_on_border);
    d.angle = all > 0 ? std::fmod(d.angle, all) : 0;
    return true;
  };
  while (d.angle < 0) {
    if (complex.is_border(d.halfedge ^ 1U)) {
      const bool is_rounding = d.angle >= -tolerance && !complex.is_border(d.halfedge);
      d.angle = 0;
      return is_rounding;
    }
    d.halfedge = complex.next(d.halfedge ^ 1U);
    d.angle += angle_at_source(complex, d.halfedge);
    if (d.halfedge == first && d.angle < 0 && !reduce()) d.angle = 0;
  }
  if (complex.is_border(d.halfedge)) {
    if (complex.is_border(d.halfedge ^ 1U) || d.angle > tolerance) return false;
    d.halfedge = complex.next(d.halfedge ^ 1U);
    d.angle = angle_at_source(complex, d.halfedge);
  }
  for (double corner; d.angle > (corner = angle_at_source(complex, d.halfedge));) {
    const std::uint32_t after = next_around_source(complex, d.halfedge);
    if (complex.is_border(after)) {
      const bool is_rounding = d.angle - corner <= tolerance;
      d.angle = corner;
      return is_rounding;
    }
    d.halfedge = after;
    d.angle -= corner;
    if (d.halfedge == first && !reduce()) d.angle = 0;
  }
  return true;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRACING_GEODESIC_FACE_H
