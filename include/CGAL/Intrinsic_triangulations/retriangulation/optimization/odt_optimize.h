// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIMIZE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIMIZE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/Odt_optimizer.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Constrained_segments.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Delaunay_refiner.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_settings.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Surface_check.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Refines faces in which moves left angles below the bound, and keeps the parts of constrained
// edges.
template <class Triangulation, class Optimizer>
Constrained_segments restore_angles(Triangulation& t, const Refinement_settings& asked,
                                    const Optimizer& optimizer, Odt_result& result) {
  std::vector<char> is_kept(t.numbers().edge_capacity(t.mesh()), 0);
  for (const auto e : edges(t.mesh()))
    is_kept[t.index(e)] = optimizer.whole(t.index(e)) != Gluing::none ? 1 : 0;
  auto refined = refine(t, asked, is_kept, {});
  result.insertions = refined.result.counts.inserted_vertices();
  result.unsatisfied_faces = refined.result.unsatisfied.size();
  if (refined.result.status != Status::done) result.status = refined.result.status;
  result.energy_after = odt_energy(t);
  return std::move(refined.segments);
}

} // namespace internal

/*!
\brief improves a triangulation by moving the vertices that were inserted, towards an optimal
Delaunay triangulation (§4.5 of the course; Chen and Holst, Efficient mesh optimization schemes
based on optimal Delaunay triangulations, 2011).

Each iteration splits the edges that are too long at their midpoints, then moves every inserted
vertex to the mean of the circumcenters of the faces about it, weighted by their areas, or part of
the way if that is outside of its star, and flips edges to Delaunay. Areas become even, at the cost
of some smaller angles than `delaunay_refine()` leaves. If a least angle is given,
`delaunay_refine()` follows, which also splits edges that are still too long. The surface, the
vertices of the input, and vertices inserted on the border and on constrained edges stay. Moved
vertices get new descriptors. With inexact traits the result is checked, see `delaunay_refine()`.

\tparam Triangulation a model of `RefinableTriangulation`
\tparam NP a chain of named parameters
\param t the triangulation; it may have been refined before
\param np optional named parameters:
  - `maximum_edge_length(x)`: edges that are longer are split, in the units of the input. Default:
    none is.
  - `minimum_angle(x)`: least angle of faces in the end, in degrees, kept by inserting vertices.
    Default: 0, any.
  - `number_of_iterations(n)`: cap on the number of iterations. Default: 100.
  - `maximum_insertions(n)`: cap on the number of vertices inserted. Default: a million and ten per
    face.
  - `convergence(x)`: stops when an iteration without splits lowers the energy by less than this
    fraction. Default: 1e-3.
  - `edge_is_constrained_map(m)`: see `delaunay_refine()`
  - `visitor(v)`: see `Odt_visitor`
\return status, counts, energies, the least angle that there is
\throws std::invalid_argument if the largest length is not positive
\complexity usually linear in the number of vertices for each iteration
*/
template <RefinableTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Odt_result odt_optimize(Triangulation& t, const NP& np = parameters::default_values()) {
  using namespace internal::tags;
  using Edge = typename Triangulation::edge_descriptor;
  internal::expect_names<maximum_edge_length, minimum_angle, number_of_iterations,
                         maximum_insertions, convergence, edge_is_constrained_map, visitor>(np);
  const auto constrained = internal::constrained_map<Edge>(np);
  auto stored_visitor = internal::object_or<visitor>(np, Odt_visitor());
  auto& observed = internal::unwrapped(stored_visitor);
  const internal::Surface_check<Triangulation> check(t);
  static_assert(requires(const Odt_result& r) { bool(observed.progress(r)); },
                "a visitor of odt_optimize() derives from Odt_visitor, or has its function "
                "progress()");
  internal::Odt_optimizer<Triangulation> optimizer(
      t, np, [&observed](const Odt_result& r) { return bool(observed.progress(r)); });
  const internal::Constrained_parts parts(t, constrained);
  Odt_result result = optimizer.run(constrained);
  internal::Refinement_settings asked(np);
  asked.minimum_angle = internal::value_or<minimum_angle>(np, 0.);
  if constexpr (internal::Has_parameter<maximum_insertions, NP>) {
    const std::optional<std::uint64_t> most =
        internal::value_or<maximum_insertions>(np, std::optional<std::uint64_t>());
    if (most) asked.maximum_insertions = result.splits < *most ? *most - result.splits : 0;
  }
  Constrained_segments segments;
  const bool is_refined = asked.minimum_angle > 0 && result.status != Status::cancelled;
  if (is_refined) segments = internal::restore_angles(t, asked, optimizer, result);
  check.conclude(result);
  Quality quality;
  internal::sharpen_for_statistics(t);
  internal::measure_faces(t, quality, [](const auto&...) {});
  result.minimum_angle = quality.minimum_angle;
  parts.write(t, [&](std::uint32_t e) {
    if (!is_refined) return optimizer.whole(e);
    return segments.is_constrained(e) ? optimizer.whole(segments.whole(e)) : Gluing::none;
  });
  return result;
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MISTAKES(odt_optimize, RefinableTriangulation,
                                              "number_of_iterations(10)")
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIMIZE_H
