// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED_ALGORITHMS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_COMPILED_ALGORITHMS_H

/*!
\file
What most programs do with the usual triangulations, which the library has compiled; see `compilation.h`.
*/

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCE
#define CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCE extern template
#endif

#define CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCES(...)                                     \
  CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCE Flip_to_delaunay_result internal::flip_from(    \
      __VA_ARGS__&, const Iterator_range<boost::graph_traits<Gluing_map>::edge_iterator>&,         \
      const Static_boolean_property_map<Gluing_map::Edge, false>&, Flip_to_delaunay_visitor&,      \
      std::uint64_t);                                                                              \
  CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCE Flip_to_delaunay_result flip_to_delaunay(       \
      __VA_ARGS__&, const parameters::Parameters<>&);                                              \
  CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCE bool is_delaunay(const __VA_ARGS__&);           \
  CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCE Delaunay_report<Gluing_map::Edge>               \
  check_delaunay(const __VA_ARGS__&);                                                              \
  CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCE class internal::Delaunay_flipper<__VA_ARGS__>;  \
  CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCE class internal::Refinement_moves<__VA_ARGS__>;  \
  CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCE internal::Refined<Gluing_map::Face>             \
  internal::refine(__VA_ARGS__&, const internal::Refinement_settings&, const std::vector<char>&,   \
                   Refinement_visitor&);                                                           \
  CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCE Refinement_result<Gluing_map::Face>             \
  delaunay_refine(__VA_ARGS__&, const parameters::Parameters<>&)

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_FOR_USUAL_TRIANGULATIONS(
    CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCES);

CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCE Common_subdivision common_subdivision(
    const Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, Integer_coordinates>&);
CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCE Common_subdivision common_subdivision(
    const Intrinsic_triangulation<Gluing_map, Euclidean_traits<double>, Integer_coordinates>&);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMPILED

#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMPILED_ALGORITHMS_H
