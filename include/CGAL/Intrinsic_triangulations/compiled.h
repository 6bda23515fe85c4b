// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED_H
#define CGAL_INTRINSIC_TRIANGULATIONS_COMPILED_H

/*!
\file
Declares the templates that the library has instantiated for the usual triangulations.
`CGAL/Intrinsic_triangulation.h` includes this file for programs that link the library. A macro
below lists the instances of each group after a prefix: `extern template` here, `template` in the
sources of the library, see `src/instances/`.
*/

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

/// \cond
// calls a macro with a prefix and each of the usual triangulations that are not exact.
#define CGAL_INTRINSIC_TRIANGULATIONS_FOR_ROUNDED(instances, prefix)                               \
  instances(prefix,                                                                                \
            Intrinsic_triangulation<Gluing_map, Euclidean_traits<double>, No_correspondence>);     \
  instances(prefix,                                                                                \
            Intrinsic_triangulation<Gluing_map, Euclidean_traits<double>, Integer_coordinates>)
// calls a macro with a prefix and each of the usual exact triangulations.
#define CGAL_INTRINSIC_TRIANGULATIONS_FOR_EXACT(instances, prefix)                                 \
  instances(prefix,                                                                                \
            Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, No_correspondence>);       \
  instances(prefix,                                                                                \
            Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, Integer_coordinates>)
// calls a macro with a prefix and each of the usual triangulations with a correspondence.
#define CGAL_INTRINSIC_TRIANGULATIONS_FOR_INTEGERS(instances, prefix)                              \
  instances(prefix,                                                                                \
            Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, Integer_coordinates>);     \
  instances(prefix,                                                                                \
            Intrinsic_triangulation<Gluing_map, Euclidean_traits<double>, Integer_coordinates>)
// calls a macro with a prefix and each exact triangulation with another correspondence.
#define CGAL_INTRINSIC_TRIANGULATIONS_FOR_MODELS(instances, prefix)                                \
  instances(prefix,                                                                                \
            Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, Explicit_crossings>);      \
  instances(prefix, Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, Signposts>)

// instantiates a triangulation.
#define CGAL_INTRINSIC_TRIANGULATIONS_OWNER(prefix, ...)                                           \
  prefix class __VA_ARGS__;                                                                        \
  prefix class Predicate_session<__VA_ARGS__>;                                                     \
  prefix class Move_session<__VA_ARGS__>;                                                          \
  prefix class internal::Mover<__VA_ARGS__>;                                                       \
  prefix class internal::Vertex_inserter<__VA_ARGS__>;                                             \
  prefix class internal::Vertex_remover<__VA_ARGS__>
// instantiates what decides for an exact triangulation, and where its vertices are.
#define CGAL_INTRINSIC_TRIANGULATIONS_PLACES(prefix, ...)                                          \
  prefix class internal::Vertex_places<__VA_ARGS__>;                                               \
  prefix class internal::Figure_finder<__VA_ARGS__, internal::Vertex_places<__VA_ARGS__>>;         \
  prefix class internal::Euclidean_decider<__VA_ARGS__>
// instantiates the usual functions on a triangulation.
#define CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHMS(prefix, ...)                                      \
  prefix Flip_to_delaunay_result internal::flip_from(                                              \
      __VA_ARGS__&, const Iterator_range<boost::graph_traits<Gluing_map>::edge_iterator>&,         \
      const Static_boolean_property_map<Gluing_map::Edge, false>&, const internal::Flip_progress&, \
      std::uint64_t);                                                                              \
  prefix Flip_to_delaunay_result flip_to_delaunay(__VA_ARGS__&, const parameters::Parameters<>&);  \
  prefix bool is_delaunay(const __VA_ARGS__&);                                                     \
  prefix Delaunay_report<Gluing_map::Edge> check_delaunay(const __VA_ARGS__&);                     \
  prefix class internal::Delaunay_flipper<__VA_ARGS__>;                                            \
  prefix class internal::Refinement_moves<__VA_ARGS__>;                                            \
  prefix internal::Refined<Gluing_map::Face> internal::refine(                                     \
      __VA_ARGS__&, const internal::Refinement_settings&, const std::vector<char>&,                \
      const internal::Refinement_questions<__VA_ARGS__>&);                                         \
  prefix class internal::Delaunay_refiner<__VA_ARGS__>;                                            \
  prefix Refinement_result<Gluing_map::Face> delaunay_refine(__VA_ARGS__&,                         \
                                                             const parameters::Parameters<>&)
// instantiates the preparation of inputs of triangulations with a metric.
#define CGAL_INTRINSIC_TRIANGULATIONS_PREPARED(prefix, ...)                                        \
  prefix internal::Prepared_input<__VA_ARGS__, Input> internal::prepare(Intrinsic_input&&);        \
  prefix internal::Prepared_input<__VA_ARGS__, Input_definition> internal::prepare(                \
      Intrinsic_input&&)

// instantiates the usual triangulations.
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCES(prefix)                              \
  CGAL_INTRINSIC_TRIANGULATIONS_FOR_EXACT(CGAL_INTRINSIC_TRIANGULATIONS_OWNER, prefix);            \
  CGAL_INTRINSIC_TRIANGULATIONS_FOR_EXACT(CGAL_INTRINSIC_TRIANGULATIONS_PLACES, prefix);           \
  CGAL_INTRINSIC_TRIANGULATIONS_FOR_ROUNDED(CGAL_INTRINSIC_TRIANGULATIONS_OWNER, prefix);          \
  CGAL_INTRINSIC_TRIANGULATIONS_PREPARED(prefix, Exact_euclidean_metric);                          \
  CGAL_INTRINSIC_TRIANGULATIONS_PREPARED(prefix, Euclidean_metric<double>)
// instantiates the usual functions on the usual triangulations.
#define CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCES(prefix)                                  \
  CGAL_INTRINSIC_TRIANGULATIONS_FOR_EXACT(CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHMS, prefix);       \
  CGAL_INTRINSIC_TRIANGULATIONS_FOR_ROUNDED(CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHMS, prefix);     \
  prefix Common_subdivision common_subdivision(                                                    \
      const Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, Integer_coordinates>&);    \
  prefix Common_subdivision common_subdivision(                                                    \
      const Intrinsic_triangulation<Gluing_map, Euclidean_traits<double>, Integer_coordinates>&)
// instantiates the other exact triangulations, and the usual functions on them.
#define CGAL_INTRINSIC_TRIANGULATIONS_MODEL_INSTANCES(prefix)                                      \
  CGAL_INTRINSIC_TRIANGULATIONS_FOR_MODELS(CGAL_INTRINSIC_TRIANGULATIONS_OWNER, prefix);           \
  CGAL_INTRINSIC_TRIANGULATIONS_FOR_MODELS(CGAL_INTRINSIC_TRIANGULATIONS_PLACES, prefix);          \
  CGAL_INTRINSIC_TRIANGULATIONS_FOR_MODELS(CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHMS, prefix)

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCES(extern template);
CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCES(extern template);
CGAL_INTRINSIC_TRIANGULATIONS_MODEL_INSTANCES(extern template);

} // namespace CGAL::Intrinsic_triangulations
#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
/// \endcond

#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMPILED_H
