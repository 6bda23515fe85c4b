// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_COVERS_RESTORE_INPUT_EDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_COVERS_RESTORE_INPUT_EDGES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/CurveCoordinates.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/covers/restore_input_edge.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reports what `restore_input_edges()` did.
*/
struct Restored_edges {
  std::uint64_t flips = 0; ///< Edges flipped.
  /// Number in `t.input()` of the first edge that could not be restored; `Gluing::none`: all are there.
  std::uint32_t missing = Gluing::none;
};

/*!
\brief flips edges until some edges of the input are edges of the triangulation again, or chains of edges through vertices that
were inserted on them.

Other edges may not be Delaunay afterwards. With constraints on those that were restored (`constrained_input_edges()`),
`flip_to_delaunay()` makes the constrained Delaunay triangulation, as if no flip had come before.
\tparam Triangulation an `Intrinsic_triangulation` with a model of `CurveCoordinates` as correspondence
\param t the triangulation
\param is_wanted nonzero for each edge to be restored, by its number in `t.input()`; the others are as they may
\return what was done; an edge that crosses a face more than once may stay away
\complexity quadratic in the number of edges that cross an edge
*/
template <class Triangulation>
  requires CurveCoordinates<typename Triangulation::Correspondence>
      Restored_edges restore_input_edges(Triangulation& t, const std::vector<char>& is_wanted) {
    Restored_edges result;
    typename Triangulation::Session session(t);
    for (std::size_t e = 0; e < is_wanted.size() && result.missing == Gluing::none; ++e) {
      const auto number = static_cast<std::uint32_t>(e);
      if (is_wanted[e] != 0 &&
          !internal::restore_input_edge(t, session, t.correspondence(), 2 * number, result.flips))
        result.missing = number;
    }
    return result;
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_COVERS_RESTORE_INPUT_EDGES_H
