// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TRACE_EDGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TRACE_EDGE_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Crossing_parameters.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/corner_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/follow_curve.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate_on_input.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// A place where an intrinsic edge crosses an input edge.
struct Traced_crossing {
  std::uint32_t entered; ///< input halfedge of the face that the intrinsic edge enters
  double on_input;       ///< 0 at the source of that halfedge, 1 at its target
  double on_intrinsic;   ///< 0 at the start of the intrinsic edge, 1 at its end
};

namespace internal {

// The input halfedges that halfedge 2e crosses: read, or found by following the curves.
template <class Triangulation, class Coordinates>
std::vector<std::uint32_t> entered_on(const Triangulation& t, const Coordinates& coordinates,
                                      std::uint32_t edge) {
  std::vector<std::uint32_t> entered;
  if constexpr (requires { coordinates.entered_on(edge); }) {
    const std::span<const std::uint32_t> list = coordinates.entered_on(edge);
    entered.assign(list.begin(), list.end());
  } else {
    const Intrinsic_view<Triangulation> view(t);
    const Normal_coordinate n = crossings(coordinates.normal_coordinate(edge));
    entered.resize(static_cast<std::size_t>(n));
    std::vector<Curve_bundle> stack;
    follow_curves(view, coordinates, {2 * edge, 0, n, 0}, stack,
                  [&](Normal_coordinate i, const Curve_end& end) {
                    // the curve crosses from left to right; the way back starts along its opposite
                    entered[static_cast<std::size_t>(i)] = input_halfedge(coordinates, end) ^ 1U;
                  });
  }
  return entered;
}

} // namespace internal

/*!
\brief traces an intrinsic edge over the input, from the source of its halfedge `2 * edge`.
\tparam Triangulation an instance of `Intrinsic_triangulation`
\tparam Coordinates a model of `CurveCoordinates`: `Explicit_crossings`, `Integer_coordinates`
\param t the triangulation
\param coordinates its correspondence
\param edge the number of the edge
\return its crossings, in order; none if the edge lies in one face, or runs along an input edge
\complexity linear in the number of crossings; with `Integer_coordinates`, in the number of steps of
`follow_curves()`
*/
template <class Triangulation, class Coordinates>
std::vector<Traced_crossing> trace_edge(const Triangulation& t, const Coordinates& coordinates,
                                        std::uint32_t edge) {
  const std::vector<std::uint32_t> entered = internal::entered_on(t, coordinates, edge);
  std::vector<Traced_crossing> trace;
  if (entered.empty()) return trace;
  const Intrinsic_view<Triangulation> view(t);
  internal::Edge_strip strip(coordinates.input());
  strip.unfold(corner_on_input(coordinates, 2 * edge, view.source(2 * edge)),
               corner_on_input(coordinates, 2 * edge + 1, view.target(2 * edge)), entered);
  trace.reserve(entered.size());
  double last = 0;
  for (std::size_t i = 0; i < entered.size(); ++i) {
    const double x = strip.parameter(i);
    last = std::max(last, strip.along(i, x)); // in order whatever rounding does
    trace.push_back({entered[i], x, last});
  }
  return trace;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TRACE_EDGE_H
