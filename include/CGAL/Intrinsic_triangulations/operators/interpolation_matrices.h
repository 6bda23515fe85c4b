// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_INTERPOLATION_MATRICES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_INTERPOLATION_MATRICES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

/*!
\file
From values at the vertices of the input, or of the intrinsic triangulation, to values at the vertices
of their common subdivision (§4.11.1 of the course): both are piecewise linear there.
*/

namespace CGAL::Intrinsic_triangulations {

/// A sparse matrix by rows, one per vertex of the common subdivision.
using Interpolation_matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

namespace internal {

// A vertex of the input has one number in both triangulations, that of the input, as in all operators.
inline std::vector<std::uint32_t> operator_numbers(const Common_subdivision& s) {
  std::vector<std::uint32_t> number(s.number_of_intrinsic_vertices, 0);
  for (const Common_subdivision::Vertex& v : s.vertices)
    number[v.intrinsic] =
        v.kind == Subdivision_vertex_kind::input ? v.on_input.vertices[0] : v.intrinsic;
  return number;
}

// entries of one row; sorted, and equal columns added up
inline void append_row(Weighted_vertices w, Interpolation_matrix& m, Eigen::Index row) {
  m.startVec(row);
  for (const std::size_t i : {1U, 2U, 1U})
    if (i < w.size && w.vertices[i] < w.vertices[i - 1]) {
      std::swap(w.vertices[i], w.vertices[i - 1]);
      std::swap(w.weights[i], w.weights[i - 1]);
    }
  for (std::size_t i = 0; i < w.size;) {
    const std::uint32_t column = w.vertices[i];
    double sum = 0;
    for (; i < w.size && w.vertices[i] == column; ++i) sum += w.weights[i];
    if (sum != 0) m.insertBackByOuterInner(row, column) = sum;
  }
}

// `locate(v)` returns the location of vertex `v` of the subdivision
template <class Locate>
Interpolation_matrix interpolation_matrix(const Common_subdivision& s, std::uint32_t columns,
                                          const Locate& locate) {
  const std::size_t rows = s.number_of_vertices();
  if (3 * rows > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw Invalid_input(Element_kind::none, 0,
                        "the common subdivision has " + std::to_string(rows) +
                            " vertices, more than Eigen's index type can count; split the mesh");
  Interpolation_matrix m(static_cast<Eigen::Index>(rows), columns);
  m.reserve(static_cast<Eigen::Index>(s.vertices.size() + 2 * s.crossings.size()));
  for (std::size_t v = 0; v < rows; ++v) append_row(locate(v), m, static_cast<Eigen::Index>(v));
  m.finalize();
  return m;
}

} // namespace internal

/*!
\brief assembles P_ext (§4.11.1 of the course): it takes values at the vertices of the input to values
at the vertices of the common subdivision.

Its shape is |V_S| x |V_ext|. Rows are barycentric coordinates: at most three entries, which sum to 1 up to
rounding. Zero weights are not stored.
\param s the subdivision
\return a compressed matrix; columns are numbered like the vertices of the input
\throws Invalid_input if the subdivision is too large for the index type of Eigen
\complexity linear
*/
inline Interpolation_matrix interpolation_from_input(const Common_subdivision& s) {
  return internal::interpolation_matrix(s, s.number_of_input_vertices,
                                        [&s](std::size_t v) { return s.on_input(v); });
}

/*!
\brief assembles P_int (§4.11.1 of the course): it takes values at the vertices of the intrinsic
triangulation to values at the vertices of the common subdivision.

Its shape is |V_S| x |V_int|. Rows have one or two entries, since the faces of the intrinsic triangulation
have no vertices inside. Columns are numbered as in all operators: vertices of the input as there,
then the inserted ones. Columns of removed vertices are empty.
\param s the subdivision
\return a compressed matrix
\throws Invalid_input if the subdivision is too large for the index type of Eigen
\complexity linear
*/
inline Interpolation_matrix interpolation_from_intrinsic(const Common_subdivision& s) {
  const std::vector<std::uint32_t> number = internal::operator_numbers(s);
  return internal::interpolation_matrix(s, s.number_of_intrinsic_vertices, [&](std::size_t v) {
    Weighted_vertices w = s.on_intrinsic(v);
    for (std::size_t i = 0; i < w.size; ++i) w.vertices[i] = number[w.vertices[i]];
    return w;
  });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_INTERPOLATION_MATRICES_H
