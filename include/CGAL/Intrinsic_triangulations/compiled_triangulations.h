// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED_TRIANGULATIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_COMPILED_TRIANGULATIONS_H

/*!
\file
The usual triangulations, which the library has compiled; see `compilation.h`.
*/

#include <CGAL/Intrinsic_triangulation.h>

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED

/// calls a macro with each of the usual triangulations, to instantiate what is compiled of it.
#define CGAL_INTRINSIC_TRIANGULATIONS_FOR_USUAL_TRIANGULATIONS(instances)                          \
  instances(Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, No_correspondence>);       \
  instances(Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, Integer_coordinates>);     \
  instances(Intrinsic_triangulation<Gluing_map, Euclidean_traits<double>, No_correspondence>);     \
  instances(Intrinsic_triangulation<Gluing_map, Euclidean_traits<double>, Integer_coordinates>)

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE extern template
#endif

#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCES(...)                                 \
  CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE class __VA_ARGS__;                          \
  CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE class Predicate_session<__VA_ARGS__>;       \
  CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE class Move_session<__VA_ARGS__>;            \
  CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE class internal::Mover<__VA_ARGS__>;         \
  CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE class internal::Vertex_remover<__VA_ARGS__>

/// the same for what knows where vertices are, which triangulations with exact traits have.
#define CGAL_INTRINSIC_TRIANGULATIONS_PLACES_INSTANCES(...)                                        \
  CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE class internal::Vertex_places<__VA_ARGS__>; \
  CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE class internal::Exact_values<__VA_ARGS__>

/// the same for what unfolds input triangles, with each of the number types that do.
#define CGAL_INTRINSIC_TRIANGULATIONS_UNFOLDING_INSTANCES(...)                                     \
  CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE class Unfolded_face<__VA_ARGS__>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_FOR_USUAL_TRIANGULATIONS(
    CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCES);
CGAL_INTRINSIC_TRIANGULATIONS_PLACES_INSTANCES(
    Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, No_correspondence>);
CGAL_INTRINSIC_TRIANGULATIONS_PLACES_INSTANCES(
    Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, Integer_coordinates>);
CGAL_INTRINSIC_TRIANGULATIONS_UNFOLDING_INSTANCES(double);
CGAL_INTRINSIC_TRIANGULATIONS_UNFOLDING_INSTANCES(Interval_nt<false>);
CGAL_INTRINSIC_TRIANGULATIONS_UNFOLDING_INSTANCES(Ball<Double_double>);
CGAL_INTRINSIC_TRIANGULATIONS_UNFOLDING_INSTANCES(Ball<Mpfr_number>);
CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE
internal::Prepared_input<Exact_euclidean_metric, Input> internal::prepare(Intrinsic_input&&);
CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE
internal::Prepared_input<Exact_euclidean_metric, Input_definition>
internal::prepare(Intrinsic_input&&);
CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE
internal::Prepared_input<Euclidean_metric<double>, Input> internal::prepare(Intrinsic_input&&);
CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE
internal::Prepared_input<Euclidean_metric<double>, Input_definition>
internal::prepare(Intrinsic_input&&);
CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE class internal::First_copies<
    Integer_coordinates>;

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMPILED

#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMPILED_TRIANGULATIONS_H
