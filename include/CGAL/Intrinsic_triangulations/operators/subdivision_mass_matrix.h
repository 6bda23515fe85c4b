// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SUBDIVISION_MASS_MATRIX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SUBDIVISION_MASS_MATRIX_H

#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/operators/symmetric_assembly.h>
#include <CGAL/Intrinsic_triangulations/triangulation/NumberedTriangulation.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

/*!
\file
Integrals over the faces of a common subdivision. Areas are intrinsic: they come from the places of
the corners in the intrinsic face and need no positions in space.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// of the triangle of three points, as a fraction of the face: a determinant
inline double area_fraction(const std::array<double, 3>& p, const std::array<double, 3>& q,
                            const std::array<double, 3>& r) {
  const double x1 = q[1] - p[1], y1 = q[2] - p[2], x2 = r[1] - p[1], y2 = r[2] - p[2];
  return std::max(0.0, x1 * y2 - x2 * y1); // the corners of convex faces turn left, up to rounding
}

} // namespace internal

/*!
\brief calls a function for each triangle of the faces of a common subdivision, which are cut into
fans from their first corners.
\tparam Triangulation an instance of `Intrinsic_triangulation`
\tparam Function called as `function(f, v, area)`: the face, an array of the three vertices, and the area in
  units of area of the input, zero at least
\param t the triangulation
\param s its common subdivision with the input
\param function the function
\complexity linear
*/
template <class Triangulation, class Function>
void for_each_subdivision_triangle(const Triangulation& t, const Common_subdivision& s,
                                   Function function) {
  const Intrinsic_view<Triangulation> view(t);
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    const std::uint32_t base = view.halfedge_of_face(s.intrinsic_face[f]);
    const double area = t.area(t.numbers().face_at(s.intrinsic_face[f]));
    const std::size_t begin = s.face_begin[f], end = s.face_begin[f + 1];
    const std::array<double, 3> first = internal::corner_in_face(view, s, base, begin);
    std::array<double, 3> last = internal::corner_in_face(view, s, base, begin + 1);
    for (std::size_t c = begin + 2; c < end; ++c) {
      const std::array<double, 3> here = internal::corner_in_face(view, s, base, c);
      function(f, std::array{s.corner[begin], s.corner[c - 1], s.corner[c]},
               area * internal::area_fraction(first, last, here));
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
\brief assembles the Galerkin mass matrix of a common subdivision (§2.5.1 and §4.11.1 of the course).

With the matrices of `interpolation_matrices.h`, P_ext^T M_S P_ext is the mass matrix of the input, P_int^T
M_S P_int that of the intrinsic triangulation, and u^T P_ext^T M_S P_int v the integral of u v for u on the
input and v on the intrinsic triangulation: all exactly, up to rounding.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param s its common subdivision with the input
\return a compressed matrix with a row and column per vertex of the subdivision, in units of area of the
  input, symmetric bit by bit; every diagonal entry is stored
\throws Invalid_input if the subdivision is too large for the index type of Eigen
\complexity linear
*/
template <NumberedTriangulation Triangulation>
Eigen::SparseMatrix<double> subdivision_mass_matrix(const Triangulation& t,
                                                    const Common_subdivision& s) {
  const std::size_t size = s.number_of_vertices();
  if (6 * s.corner.size() + size > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw Invalid_input(Element_kind::none, 0,
                        "the common subdivision has " + std::to_string(s.corner.size()) +
                            " corners, more than Eigen's index type can count; split the mesh");
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(size));
  std::vector<Symmetric_entry> entries;
  entries.reserve(3 * (s.corner.size() - 2 * s.number_of_faces()));
  for_each_subdivision_triangle(
      t, s, [&](std::size_t, const std::array<std::uint32_t, 3>& v, double area) {
        for (std::size_t k = 0; k < 3; ++k) {
          const auto i = static_cast<int>(v[k]), j = static_cast<int>(v[(k + 1) % 3]);
          diagonal[i] += area / 6;
          if (i == j)
            diagonal[i] += area / 6; // the pair (i, j) and the pair (j, i)
          else
            entries.push_back({i, j, area / 12});
        }
      });
  Eigen::SparseMatrix<double> m =
      symmetric_matrix_with_zero_diagonal(entries, static_cast<int>(size));
  for (int c = 0; c < m.outerSize(); ++c) m.coeffRef(c, c) = diagonal[c];
  return m;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SUBDIVISION_MASS_MATRIX_H
