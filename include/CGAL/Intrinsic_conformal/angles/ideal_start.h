// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_ANGLES_IDEAL_START_H
#define CGAL_INTRINSIC_CONFORMAL_ANGLES_IDEAL_START_H

#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <cstddef>
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

// The squared lengths of edges, by number. With exact traits each is rounded from an interval of
// 106 bits, so that lengths that are equal stay equal as doubles: an edge on the front of a double
// and its copy on the back. Solvers sum angles over both, and beside a needle of 1e-9 of the edges
// around it, a unit in the last place of a length changes angles by 1e-7. If copies differed by it,
// neither side would be flat, but only both on average.
template <MeasuredTriangulation Triangulation>
std::vector<double> nearest_squared_lengths(const Triangulation& t) {
  std::vector<double> result(t.numbers().edge_capacity(t.mesh()));
  if constexpr (Has_enclosures<typename Triangulation::Metric> && requires { t.decider(); }) {
    constexpr unsigned bits = 106; // those of `Double_double`, twice those of the result
    const typename Triangulation::Metric::Scope scope;
    std::vector<Indexed_face> sides;
    for (const typename Triangulation::face_descriptor f : faces(t.mesh()))
      sides.push_back(indexed_face(t, f));
    const auto store = [&](std::size_t i, const Face_values<Interval_nt<false>>& values) {
      for (std::size_t k = 0; k < 3; ++k)
        result[sides[i].edges[k]] = std::ldexp(CGAL::to_double(values.squared_lengths[k]),
                                               -2 * t.metric().scale_exponent());
    };
    t.decider().for_each_enclosure(sides, bits, store);
  } else {
    for (const typename Triangulation::edge_descriptor e : edges(t.mesh()))
      result[t.index(e)] = t.squared_length(e);
  }
  return result;
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
\complexity linear; with exact traits also in the number of crossings with the edges of the input
*/
template <MeasuredTriangulation Triangulation>
Intrinsic_input ideal_start(const Triangulation& t) {
  Intrinsic_input in(internal::numbered_copy(t.mesh(), t.numbers()),
                     internal::nearest_squared_lengths(t), Mollification::none);
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
