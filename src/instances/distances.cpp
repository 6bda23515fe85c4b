// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances on the usual triangulations.

#include <CGAL/Intrinsic_operators/distance/Distances.h>

namespace CGAL::Intrinsic_triangulations {

template class Distances<
    Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, Integer_coordinates>>;
template class Distances<
    Intrinsic_triangulation<Gluing_map, Euclidean_traits<double>, Integer_coordinates>>;

} // namespace CGAL::Intrinsic_triangulations
