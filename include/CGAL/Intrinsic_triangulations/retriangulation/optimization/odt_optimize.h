// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIMIZE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIMIZE_H

#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/Odt_optimizer.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Constrained_parts.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Surface_check.h>
#include <CGAL/Intrinsic_triangulations/triangulation/RefinableTriangulation.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>

#include <cstdint>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief improves a triangulation by moving the vertices that were inserted, towards an optimal Delaunay
triangulation (§4.5 of the course; Chen and Holst, Efficient mesh optimization schemes based on optimal
Delaunay triangulations, 2011).

Each iteration splits the edges that are too long at their midpoints, then moves every
inserted vertex to the mean of the circumcenters of the faces about it, weighted by their areas, or part of
the way where that is outside of its star, and flips edges to Delaunay. Areas become even, at the cost of
some smaller angles than `delaunay_refine()` leaves. The vertices of the input stay, and the surface is
what it was; so do vertices inserted on the border and on constrained edges. Moved vertices get new
descriptors. With inexact traits the result is checked, see `delaunay_refine()`.

\tparam Triangulation a model of `RefinableTriangulation`
\tparam NP a chain of named parameters
\param t the triangulation; it may have been refined before
\param np optional named parameters:
  - `maximum_edge_length(x)`: edges that are longer are split, in the units of the input. Default: none is.
  - `number_of_iterations(n)`: cap on the number of iterations. Default: 100.
  - `maximum_insertions(n)`: cap on the number of vertices inserted. Default: a million and ten per face.
  - `convergence(x)`: it is done when an iteration without splits lowers the energy by less than this
    fraction. Default: 1e-3.
  - `edge_is_constrained_map(m)`: see `delaunay_refine()`
  - `visitor(v)`: see `Odt_visitor`
\return status, counts, energies
\throws std::invalid_argument if the largest length is not positive
\complexity linear in the number of vertices for each iteration, as a rule
*/
template <RefinableTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Odt_result odt_optimize(Triangulation& t, const NP& np = parameters::default_values()) {
  using namespace internal::tags;
  using Edge = typename Triangulation::edge_descriptor;
  internal::expect_names<maximum_edge_length, number_of_iterations, maximum_insertions, convergence,
                         edge_is_constrained_map, visitor>(np);
  const auto constrained = internal::constrained_map<Edge>(np);
  auto stored_visitor = internal::object_or<visitor>(np, Odt_visitor());
  auto& observed = internal::unwrapped(stored_visitor);
  const internal::Surface_check<Triangulation> check(t);
  internal::Odt_optimizer<Triangulation, std::remove_reference_t<decltype(observed)>> optimizer(
      t, np, observed);
  const internal::Constrained_parts parts(t, constrained);
  Odt_result result = optimizer.run(constrained);
  check.conclude(result);
  parts.write(t, [&](std::uint32_t e) { return optimizer.whole(e); });
  return result;
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MISTAKES(odt_optimize, RefinableTriangulation,
                                              "number_of_iterations(10)")
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIMIZE_H
