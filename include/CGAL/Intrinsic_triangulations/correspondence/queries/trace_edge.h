// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TRACE_EDGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TRACE_EDGE_H

#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/trace_by_curves.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/trace_signpost.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>

#include <cstdint>

/*!
\file
Edges of one triangulation traced over the other, by whatever correspondence there is.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief traces an intrinsic edge over the input.
\tparam Triangulation an instance of `Intrinsic_triangulation` with any correspondence but
  `No_correspondence`
\param t the triangulation
\param e the edge
\return its way, from the source of its halfedge `2 * t.index(e)`
\complexity linear in the number of crossings; with `Integer_coordinates`, in the number of steps of
  `follow_curves()`
*/
template <class Triangulation>
Edge_path trace_edge(const Triangulation& t, typename Triangulation::edge_descriptor e) {
  internal::expect_correspondence<Triangulation>();
  if constexpr (internal::Has_curves<Triangulation>)
    return internal::trace_edge_by_curves(t, t.correspondence(), t.index(e));
  else
    return internal::trace_edge_by_signposts(t, t.correspondence(), t.index(e));
}

/*!
\brief traces an edge of the input over the intrinsic triangulation.
\tparam Triangulation as for `trace_edge()`
\param t the triangulation
\param x a halfedge of the input, by its number
\return its way, from the source of the halfedge
\complexity linear in the number of crossings, in the degrees of its ends, and with `Signposts` in the number of
  inserted vertices
*/
template <class Triangulation>
Edge_path trace_input_edge(const Triangulation& t, std::uint32_t x) {
  internal::expect_correspondence<Triangulation>();
  if constexpr (internal::Has_curves<Triangulation>)
    return internal::trace_input_edge_by_curves(t, t.correspondence(), x);
  else
    return internal::trace_input_edge_by_signposts(t, t.correspondence(), x);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TRACE_EDGE_H
