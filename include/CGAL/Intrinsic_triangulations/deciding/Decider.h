// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_DECIDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_DECIDER_H

#include <CGAL/Intrinsic_triangulations/correspondence/models/Vertex_places.h>
#include <CGAL/Intrinsic_triangulations/deciding/Euclidean_decider.h>
#include <CGAL/Intrinsic_triangulations/deciding/Exact_memory.h>
#include <CGAL/Intrinsic_triangulations/deciding/Ideal_decider.h>
#include <CGAL/Intrinsic_triangulations/deciding/Integer_decider.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// What decides for a triangulation whose metric leaves questions open.
template <class Triangulation, class Places, class Metric = typename Triangulation::Metric>
using Decider = std::conditional_t<
    Scales_vertices<Metric>, Ideal_decider<Triangulation>,
    std::conditional_t<Stores_nothing<Metric>, Integer_decider<Triangulation, Places>,
                       Euclidean_decider<Triangulation, Places>>>;

// Where the vertices are on the input, if they define the metric.
template <class Triangulation, class Metric>
using Places_of = std::conditional_t<Answers_if_certain<Metric> && !Stores_nothing<Metric>,
                                     Vertex_places<Triangulation>, No_vertex_places<Triangulation>>;

// What a decider stores.
template <class Metric>
using Memory_of = std::conditional_t<Answers_if_certain<Metric>, Exact_memory, No_exact_memory>;

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_DECIDER_H
