// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_ANGLES_IDEAL_START_H
#define CGAL_INTRINSIC_CONFORMAL_ANGLES_IDEAL_START_H

#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Keeps the numbers of elements, and the user's vertices.
inline void name_vertices(Intrinsic_input& in, const Input_names& names) {
  in.may_renumber = false;
  in.names.vertices = names.vertices;
  in.names.row_of_vertex = names.row_of_vertex;
  in.names.sheets = names.sheets;
}

} // namespace internal

/*!
\brief makes the input of an ideal hyperbolic triangulation from a Euclidean one, with its edges and
lengths.

A discrete conformal class belongs to a triangulation: the length of an edge after Ptolemy's flip is
Euclid's only in a cocircular diamond. After `flip_to_delaunay(t)` the class depends on the surface
alone, not on the triangles of the file.

Vertices, edges and faces of the result have the numbers they have in `t`; its names of vertices are
those of `t`, so that rows of matrices stay the same.

\tparam Triangulation a model of `MeasuredTriangulation`, without inserted vertices
\param t the triangulation
\return an input for `Intrinsic_triangulation` with ideal hyperbolic traits
\complexity linear
*/
template <MeasuredTriangulation Triangulation>
Intrinsic_input ideal_start(const Triangulation& t) {
  const auto& mesh = t.mesh();
  Intrinsic_input in(internal::numbered_copy(mesh, t.numbers()),
                     std::vector<double>(t.numbers().edge_capacity(mesh)), Mollification::none);
  for (const typename Triangulation::edge_descriptor e : edges(mesh))
    in.squared_lengths[t.index(e)] = t.squared_length(e);
  internal::name_vertices(in, t.input().names());
  return in;
}

/*!
\brief makes the input of an ideal hyperbolic triangulation from a surface before the first move,
with its own triangles.
\param surface the surface
\return an input for `Intrinsic_triangulation` with ideal hyperbolic traits; elements keep their
  numbers
\complexity linear
*/
inline Intrinsic_input ideal_start(const Input& surface) {
  Intrinsic_input in(surface.mesh(), std::vector<double>(surface.number_of_edges()),
                     Mollification::none);
  for (std::uint32_t e = 0; e < surface.number_of_edges(); ++e)
    in.squared_lengths[e] = std::ldexp(surface.squared_length(e), -2 * surface.scale_exponent());
  internal::name_vertices(in, surface.names());
  return in;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_CONFORMAL_ANGLES_IDEAL_START_H
