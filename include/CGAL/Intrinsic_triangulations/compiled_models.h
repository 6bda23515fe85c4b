// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED_MODELS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_COMPILED_MODELS_H

/*!
\file
What the library has compiled of triangulations with other correspondences than integers, for those who include these;
see `compilation.h`.
*/

#include <CGAL/Intrinsic_triangulations/compiled_algorithms.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED

#define CGAL_INTRINSIC_TRIANGULATIONS_MODEL_INSTANCES(...)                                         \
  CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCES(__VA_ARGS__);                              \
  CGAL_INTRINSIC_TRIANGULATIONS_PLACES_INSTANCES(__VA_ARGS__);                                     \
  CGAL_INTRINSIC_TRIANGULATIONS_ALGORITHM_INSTANCES(__VA_ARGS__)

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_MODEL_INSTANCES(
    Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, Explicit_crossings>);
CGAL_INTRINSIC_TRIANGULATIONS_MODEL_INSTANCES(
    Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, Signposts>);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMPILED

#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMPILED_MODELS_H
