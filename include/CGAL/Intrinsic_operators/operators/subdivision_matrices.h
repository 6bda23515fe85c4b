// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_SUBDIVISION_MATRICES_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_SUBDIVISION_MATRICES_H

#include <CGAL/Intrinsic_operators/operators/symmetric_assembly.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/*!
\file
Integrals over the faces of a common subdivision. Areas need no positions in space: they come
  from the places of the corners in one of the two faces that contain them.

Also the matrices that interpolate values from the vertices of the input, or of the intrinsic
triangulation, at the vertices of the common subdivision (§4.11.1 of the course).
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// of the triangle of three points, as a fraction of the face: a determinant
inline double area_fraction(const std::array<double, 3>& p, const std::array<double, 3>& q,
                            const std::array<double, 3>& r) {
  const double x1 = q[1] - p[1], y1 = q[2] - p[2], x2 = r[1] - p[1], y2 = r[2] - p[2];
  return std::max(0.0, x1 * y2 - x2 * y1); // the corners of convex faces turn left, up to rounding
}

// Places the corners of a subdivision face in the smaller of the two faces that contain it:
// rounding of barycentric coordinates changes areas in proportion to that face. So the areas add up
// well where slivers and large faces cut each other.
template <class Triangulation>
class Cell_in_face {
public:
  Cell_in_face(const Triangulation& t, const Common_subdivision& s, std::size_t f)
      : s_(s), input_(t.input()), view_(t), base_(view_.halfedge_of_face(s.intrinsic_face[f])),
        area_(t.area(t.numbers().face_at(s.intrinsic_face[f]))) {
    const std::uint32_t g = input_.names().faces.here(s.input_face[f]);
    const double area = std::ldexp(input_.quadruple_area(g), -2 * input_.scale_exponent() - 2);
    if (!(area < area_)) return;
    base_ = input_.halfedge_of_face(g);
    is_on_input_ = true;
    area_ = area;
  }

  double area() const { return area_; }
  std::array<double, 3> corner(std::size_t c) const {
    return is_on_input_ ? corner_in_input_face(input_, s_, base_, c)
                        : corner_in_face(view_, s_, base_, c);
  }

private:
  const Common_subdivision& s_;
  const Input& input_;
  Intrinsic_view<Triangulation> view_;
  std::uint32_t base_;
  double area_;
  bool is_on_input_ = false;
};

} // namespace internal

/*!
\brief calls a function for each triangle of the faces of a common subdivision, which are cut into
fans from their first corners.
\tparam Triangulation a model of `NumberedTriangulation`
\tparam Function called as `function(f, v, area)`: the face, an array of the three vertices, and the
  area in units of area of the input, zero at least
\param t the triangulation
\param s its common subdivision with the input
\param function the function
\complexity linear
*/
template <NumberedTriangulation Triangulation,
          std::invocable<std::size_t, std::array<std::uint32_t, 3>, double> Function>
void for_each_subdivision_triangle(const Triangulation& t, const Common_subdivision& s,
                                   Function function) {
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    const internal::Cell_in_face<Triangulation> cell(t, s, f);
    const std::size_t begin = s.face_begin[f], end = s.face_begin[f + 1];
    const std::array<double, 3> first = cell.corner(begin);
    std::array<double, 3> last = cell.corner(begin + 1);
    for (std::size_t c = begin + 2; c < end; ++c) {
      const std::array<double, 3> here = cell.corner(c);
      function(f, std::array{s.corner[begin], s.corner[c - 1], s.corner[c]},
               cell.area() * internal::area_fraction(first, last, here));
      last = here;
    }
  }
}

/// returns the area of each face of a common subdivision, in units of area of the input; see
/// `for_each_subdivision_triangle()`.
template <NumberedTriangulation Triangulation>
std::vector<double> subdivision_areas(const Triangulation& t, const Common_subdivision& s) {
  std::vector<double> result(s.number_of_faces(), 0);
  for_each_subdivision_triangle(
      t, s, [&](std::size_t f, const auto&, double area) { result[f] += area; });
  return result;
}

/*!
\brief assembles the Galerkin mass matrix of a common subdivision (§2.5.1 and §4.11.1 of the
course).

With the matrices of interpolation, P_ext^T M_S P_ext is the mass matrix of the input, P_int^T M_S
P_int that of the intrinsic triangulation, and u^T P_ext^T M_S P_int v the integral of u v for u on
the input and v on the intrinsic triangulation: all exactly, up to rounding.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param s its common subdivision with the input
\return a compressed matrix with a row and column per vertex of the subdivision, in units of area of
  the input, symmetric bit by bit; every diagonal entry is stored
\throws Invalid_input if the subdivision is too large for the index type of Eigen
\complexity linear
*/
template <NumberedTriangulation Triangulation>
Eigen::SparseMatrix<double> subdivision_mass_matrix(const Triangulation& t,
                                                    const Common_subdivision& s) {
  const std::size_t size = s.number_of_vertices();
  internal::expect_countable(6 * s.corner.size() + size, "the common subdivision has " +
                                                             std::to_string(s.corner.size()) +
                                                             " corners");
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(size));
  std::vector<Symmetric_entry> entries;
  entries.reserve(3 * (s.corner.size() - 2 * s.number_of_faces()));
  for_each_subdivision_triangle(
      t, s, [&](std::size_t, const std::array<std::uint32_t, 3>& v, double area_on_sheet) {
        const double area = area_on_sheet / t.input().names().sheets;
        for (std::size_t k = 0; k < 3; ++k) {
          const auto i = static_cast<int>(v[k]), j = static_cast<int>(v[(k + 1) % 3]);
          diagonal[i] += area / 6;
          if (i == j)
            diagonal[i] += area / 6; // the pair (i, j) and the pair (j, i)
          else
            entries.push_back({i, j, area / 12});
        }
      });
  return symmetric_matrix(entries, diagonal);
}

/// A sparse matrix by rows, one per vertex of the common subdivision.
using Interpolation_matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/*!
\brief assembles P_ext (§4.11.1 of the course): it takes values at the vertices of the input to
values at the vertices of the common subdivision.

Its shape is |V_S| x |V_ext|. Rows are barycentric coordinates: at most three entries, which sum to
1 up to rounding. Zero weights are not stored.
\param s the subdivision
\return a compressed matrix; columns are numbered like the vertices of the input
\throws Invalid_input if the subdivision is too large for the index type of Eigen
\complexity linear
*/
Interpolation_matrix interpolation_from_input(const Common_subdivision& s);

/*!
\brief assembles P_int (§4.11.1 of the course): it takes values at the vertices of the intrinsic
triangulation to values at the vertices of the common subdivision.

Its shape is |V_S| x |V_int|. Rows have one or two entries, since the faces of the intrinsic
triangulation have no vertices inside. Columns are numbered as in all operators: vertices of the
input as there, then the inserted ones.
\param s the subdivision
\return a compressed matrix
\throws Invalid_input if the subdivision is too large for the index type of Eigen
\complexity linear
*/
Interpolation_matrix interpolation_from_intrinsic(const Common_subdivision& s);

/// takes values that name classes to the vertices of a common subdivision: each gets the one of the
/// vertex with the largest weight, the first of several. \param interpolation see above
Eigen::VectorXd nearest_values(const Interpolation_matrix& interpolation,
                               const Eigen::VectorXd& values);

/*!
\brief takes numbers at vertices to a field of the common subdivision: linearly or, if they name
classes, by `nearest_values()`.
\param name the name of the field
\param interpolation from the vertices of the input, or of the intrinsic triangulation
\param values a number for each column of the matrix; it does not read further ones
\param has_classes whether the numbers name classes
*/
Subdivision_field interpolated_field(std::string name, const Interpolation_matrix& interpolation,
                                     const Eigen::VectorXd& values, bool has_classes = false);

/*!
\brief does the same with the matrix that fits the number of values.
\param values a number for each vertex of the intrinsic triangulation, or of the input
\throws std::invalid_argument if there are as many values as neither has vertices
*/
Subdivision_field interpolated_field(std::string name, const Common_subdivision& s,
                                     const Eigen::VectorXd& values, bool has_classes = false);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_SUBDIVISION_MATRICES_H
