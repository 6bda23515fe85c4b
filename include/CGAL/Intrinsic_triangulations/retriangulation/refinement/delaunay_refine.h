// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_DELAUNAY_REFINE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_DELAUNAY_REFINE_H

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Delaunay_refiner.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_options.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief inserts vertices until faces meet criteria, and keeps the triangulation Delaunay (§4.3 of the
course, Algorithms 3 to 5; with constraints, §4.4).

A face that does not meet them gets a vertex at its circumcenter. Where an edge of the border or a
constrained one is in between, that is split, and vertices inserted before are removed near it. Some
faces cannot meet a bound of angles: those that wrap around a vertex whose total angle is too small,
and those between border or constrained edges that make too small an angle. They are left alone,
and listed. So are faces where the triangulation refuses an insertion. All others meet
the criteria; with exact traits that is certain, and so is that every edge is locally Delaunay unless it is
constrained.

\tparam Triangulation an instance of `Intrinsic_triangulation`
\tparam NamedParameters a sequence of named parameters
\param t the triangulation
\param options the criteria
\param np optional named parameters:
  - `edge_is_constrained_map(m)`: a property map from edges to `bool`; constrained edges are never
    flipped. If it is writable, it is true of the parts of constrained edges in the end, and false of
    other edges that are new. Default: none is.
  - `visitor(v)`: see `Refinement_visitor`. It is copied; pass `std::ref(v)` to have `v` itself called.
\return status, counts, and the faces that do not meet the criteria
\throws std::invalid_argument if a bound makes no sense
\complexity linear in the number of vertices inserted, as a rule
*/
template <class Triangulation, class NamedParameters = parameters::Default_named_parameters>
Refinement_result<typename Triangulation::face_descriptor>
delaunay_refine(Triangulation& t, const Refinement_options& options = {},
                const NamedParameters& np = parameters::default_values()) {
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Edge = typename Triangulation::edge_descriptor;
  auto constrained = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                      Static_boolean_property_map<Edge, false>());
  auto stored_visitor =
      choose_parameter(get_parameter(np, internal_np::visitor), Refinement_visitor());
  auto& visitor = internal::unwrapped(stored_visitor);
  internal::Delaunay_refiner<Triangulation, std::remove_reference_t<decltype(visitor)>> refiner(
      t, options, visitor);
  auto result = refiner.run(constrained);
  using Map = decltype(constrained);
  if constexpr (std::is_convertible_v<typename boost::property_traits<Map>::category,
                                      boost::writable_property_map_tag>)
    for (const Edge e : edges(t.mesh()))
      put(constrained, e, refiner.segments().is_constrained(t.index(e)));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_DELAUNAY_REFINE_H
