// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRACING_GEODESIC_FACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRACING_GEODESIC_FACE_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <array>
#include <concepts>
#include <cstdint>

/*!
\file
Faces in the plane, and angles about vertices, read by number from the input or from the intrinsic
triangulation (§2.3.7 and §2.4 of the course).

Both are models of `NumberedComplex`: `Input`, `Intrinsic_view`.
*/

namespace CGAL::Intrinsic_triangulations {

/// returns the sides of the face of `h`, from `h` on.
template <NumberedTriangles Complex>
std::array<std::uint32_t, 3> sides_of_face(const Complex& complex, std::uint32_t h) {
  const std::uint32_t n = complex.next(h);
  return {h, n, complex.next(n)};
}

/// returns the squared lengths of the sides of the face of `h`, from `h` on.
template <NumberedComplex Complex>
std::array<double, 3> squared_lengths_of_face(const Complex& complex, std::uint32_t h) {
  const auto [ij, jk, ki] = sides_of_face(complex, h);
  return {complex.squared_length(ij / 2), complex.squared_length(jk / 2),
          complex.squared_length(ki / 2)};
}

/*!
\brief returns where the third corner of the face of `h` is if the ends of `h` are at 0 and 1.
\tparam Complex a model of `NumberedComplex`
\pre `h` has a face, and a length
*/
template <NumberedComplex Complex>
Plane_vector<double> apex_above_side(const Complex& complex, std::uint32_t h) {
  const auto [ij, jk, ki] = squared_lengths_of_face(complex, h);
  return apex(ij, jk, ki, complex.quadruple_area(complex.face(h)));
}

/// returns a functor from a halfedge to the values of its face, from it on, as doubles.
template <NumberedComplex Complex>
auto approximate_values(const Complex& complex) {
  return [&complex](std::uint32_t h) {
    return Face_values<double>{squared_lengths_of_face(complex, h),
                               complex.quadruple_area(complex.face(h))};
  };
}

/*!
\brief is a face laid out in the plane, in the frame of one of its halfedges: the source is at the
origin, the target on the positive x-axis, the apex above.

Sides are stored as vectors, see `planar_sides()`; they are in scaled units, those of the complex.
*/
struct Geodesic_face {
  std::array<std::uint32_t, 3> side;        ///< the halfedge of the frame, the next and the last
  std::array<Plane_vector<double>, 3> edge; ///< vector along each side
  std::array<double, 3> length;             ///< length of each side

  /*!
  \brief lays out the face of `h`.
  \tparam Complex a model of `NumberedComplex`
  \pre `h` has a face
  */
  template <NumberedComplex Complex>
  Geodesic_face(const Complex& complex, std::uint32_t h) : side(sides_of_face(complex, h)) {
    const auto [ij, jk, ki] = squared_lengths_of_face(complex, h);
    length = {0, std::sqrt(jk), std::sqrt(ki)};
    if (ij > 0) {
      edge = planar_sides(ij, jk, ki, complex.quadruple_area(complex.face(h)));
      length[0] = edge[0].x;
    } else // two corners in one place: the other two sides lie on each other
      edge = {{{0, 0}, {0, length[1]}, {0, -length[2]}}};
  }

  /// returns the vector from a point to a corner; the differences are taken between corners.
  Plane_vector<double> to_corner(const std::array<double, 3>& weights, unsigned corner) const {
    const unsigned n = (corner + 1) % 3, p = (corner + 2) % 3;
    return weights[p] * edge[p] - weights[n] * edge[corner];
  }

  /// returns where a point is.
  Plane_vector<double> position(const std::array<double, 3>& weights) const {
    return Plane_vector<double>{0, 0} - to_corner(weights, 0);
  }

  /// returns a vector, in any units, relative to side `s`: along it, and to the left of it.
  template <class Units = void>
  Plane_vector<double, Units> relative_to(unsigned s, const Plane_vector<double, Units>& v) const {
    const Plane_vector<double, Units> along{edge[s].x, edge[s].y};
    return length[s] > 0 ? in_frame(along, v) / length[s] : v;
  }

  /// returns a vector, in any units, that is given relative to side `s`.
  template <class Units = void>
  Plane_vector<double, Units> from_relative_to(unsigned s,
                                               const Plane_vector<double, Units>& v) const {
    const Plane_vector<double, Units> along{edge[s].x, edge[s].y};
    return length[s] > 0 ? along * v / length[s] : v;
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

/// The sum of the angles of a fan of faces about a vertex.
struct Fan_angle {
  double sum;        ///< the sum
  bool is_on_border; ///< whether the fan ends at the border
};

/*!
\brief adds the angles about the source of a halfedge, counterclockwise, until the fan is closed or
at the border.
\tparam Complex a model of `NumberedComplex`
\param complex the complex
\param first the halfedge
\param visit called with each halfedge and the sum of the angles before it
*/
template <NumberedComplex Complex, std::invocable<std::uint32_t, double> Visit>
Fan_angle measure_fan(const Complex& complex, std::uint32_t first, const Visit& visit) {
  double sum = 0;
  std::uint32_t h = first;
  do {
    visit(h, sum);
    if (complex.is_border(h)) return {sum, true};
    sum += angle_at_source(complex, h);
    h = next_around_source(complex, h);
  } while (h != first);
  return {sum, false};
}

/*!
\brief returns the sum of the angles about the source of `h`, over the fan of faces of `h` if it is
a nonmanifold vertex.
\tparam Complex a model of `NumberedComplex`
\param complex the complex
\param h a halfedge
\param is_on_border becomes true where the fan is not closed
\complexity linear in the degree
*/
template <NumberedComplex Complex>
double cone_angle(const Complex& complex, std::uint32_t h, bool& is_on_border) {
  auto [sum, ends] = measure_fan(complex, h, [](std::uint32_t, double) {});
  is_on_border = ends;
  if (!ends) return sum;
  for (std::uint32_t g = h; !complex.is_border(g ^ 1U);) {
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
\param d where to start, and by what angle to turn: any number; replaced by the corner that is
reached
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

/*!
\brief describes a point of the input from another halfedge of the same face.
\pre `base` and the halfedge of `p` have one face
*/
template <NumberedTriangles Input>
Surface_point seen_from(const Input& input, const Surface_point& p, std::uint32_t base) {
  const std::array<double, 3>& w = p.weights;
  if (p.halfedge == base) return p;
  if (p.halfedge == input.next(base)) return {base, {w[2], w[0], w[1]}};
  return {base, {w[1], w[2], w[0]}};
}

/// \cond
extern template bool turn(const Input&, Corner_direction&, double);
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRACING_GEODESIC_FACE_H
