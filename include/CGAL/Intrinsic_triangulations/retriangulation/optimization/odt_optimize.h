// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIMIZE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIMIZE_H

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/Odt_optimizer.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/Odt_options.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <stdexcept>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief improves a triangulation by moving the vertices that were inserted, towards an optimal Delaunay
triangulation (§4.5 of the course; Chen and Holst, Efficient mesh optimization schemes based on optimal
Delaunay triangulations, 2011).

Each iteration splits the edges that are longer than the target at their midpoints, then moves every
inserted vertex to the mean of the circumcenters of the faces about it, weighted by their areas, or part of
the way where that is outside of its star, and flips edges to Delaunay. Areas become even, at the cost of
some smaller angles than `delaunay_refine()` leaves. The vertices of the input stay, and the surface is
what it was; so do vertices inserted on the border and on constrained edges. Moved vertices get new
descriptors.

\tparam Triangulation an instance of `Intrinsic_triangulation`
\tparam NamedParameters a sequence of named parameters
\param t the triangulation; it may have been refined before
\param options target and caps
\param np optional named parameters:
  - `edge_is_constrained_map(m)`: a property map from edges to `bool`; constrained edges are never
    flipped. If it is writable, it is true of the parts of constrained edges in the end, and false of other
    edges. Default: none is.
  - `visitor(v)`: see `Odt_visitor`. It is copied; pass `std::ref(v)` to have `v` itself called.
\return status, counts, energies
\throws std::invalid_argument if the target is not positive
\complexity linear in the number of vertices for each iteration, as a rule
*/
template <class Triangulation, class NamedParameters = parameters::Default_named_parameters>
Odt_result odt_optimize(Triangulation& t, const Odt_options& options = {},
                        const NamedParameters& np = parameters::default_values()) {
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Edge = typename Triangulation::edge_descriptor;
  if (!(options.target_length > 0))
    throw std::invalid_argument("the target length must be positive");
  auto constrained = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                      Static_boolean_property_map<Edge, false>());
  auto stored_visitor = choose_parameter(get_parameter(np, internal_np::visitor), Odt_visitor());
  auto& visitor = internal::unwrapped(stored_visitor);
  internal::Odt_optimizer<Triangulation, std::remove_reference_t<decltype(visitor)>> optimizer(
      t, options, visitor);
  const Odt_result result = optimizer.run(constrained);
  using Map = decltype(constrained);
  if constexpr (std::is_convertible_v<typename boost::property_traits<Map>::category,
                                      boost::writable_property_map_tag>)
    for (const Edge e : edges(t.mesh()))
      put(constrained, e, optimizer.is_constrained_edge(t.index(e)));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIMIZE_H
