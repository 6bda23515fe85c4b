// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_COPIES_OF_ROWS_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_COPIES_OF_ROWS_H

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <vector>

/*!
\file
Chooses, on a cover, one of the copies of each vertex: vectors belong to copies, and files and
arrays have one row for all of them.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief returns the first copy of the vertex of each row.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\return numbers of a `Tangent_field`; without a cover, each row itself
\complexity linear
*/
template <NumberedTriangulation Triangulation>
std::vector<std::uint32_t> first_copies_of_rows(const Triangulation& t) {
  const Vertex_copies<Triangulation> copies(t);
  std::vector<std::uint32_t> first(t.number_of_vertices(), Gluing::none);
  for (const typename Triangulation::vertex_descriptor v : vertices(t.mesh()))
    first[t.input_vertex(v)] = std::min(first[t.input_vertex(v)], copies(v));
  return first;
}

/*!
\brief returns the first copy of the vertex of each row with a vector that is known, or the first
one.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param field a vector per copy, by the numbers of a `Tangent_field`
\return numbers of a `Tangent_field`
\pre the field has a vector per copy
\complexity linear
*/
template <NumberedTriangulation Triangulation>
std::vector<std::uint32_t> known_copies_of_rows(const Triangulation& t,
                                                const std::vector<std::complex<double>>& field) {
  const Vertex_copies<Triangulation> copies(t);
  std::vector<std::uint32_t> known = first_copies_of_rows(t);
  for (const typename Triangulation::vertex_descriptor v : vertices(t.mesh())) {
    std::uint32_t& best = known[t.input_vertex(v)];
    const std::uint32_t i = copies(v);
    if (internal::is_known(field[i]) && (i < best || !internal::is_known(field[best]))) best = i;
  }
  return known;
}

/*!
\brief returns the copy of the vertex of each row that has the shortest vector, such as the nearest
one in a logarithmic map.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param field a vector per copy, by the numbers of a `Tangent_field`; unknown ones count as infinite
\return numbers of a `Tangent_field`
\pre the field has a vector per copy
\complexity linear
*/
template <NumberedTriangulation Triangulation>
std::vector<std::uint32_t> nearest_copies_of_rows(const Triangulation& t,
                                                  const std::vector<std::complex<double>>& field) {
  const Vertex_copies<Triangulation> copies(t);
  std::vector<std::uint32_t> nearest(t.number_of_vertices(), Gluing::none);
  for (const typename Triangulation::vertex_descriptor v : vertices(t.mesh())) {
    std::uint32_t& best = nearest[t.input_vertex(v)];
    if (best == Gluing::none || !std::isfinite(std::abs(field[best])) ||
        std::abs(field[copies(v)]) < std::abs(field[best]))
      best = copies(v);
  }
  return nearest;
}

namespace internal {

// The first copy of the vertex of each copy, by its number.
template <class Triangulation>
std::vector<std::uint32_t> first_copies(const Triangulation& t) {
  const Vertex_copies<Triangulation> copies(t);
  const std::vector<std::uint32_t> of_row = first_copies_of_rows(t);
  std::vector<std::uint32_t> result(copies.size());
  for (const typename Triangulation::vertex_descriptor v : vertices(t.mesh()))
    result[copies(v)] = of_row[t.input_vertex(v)];
  return result;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_COPIES_OF_ROWS_H
