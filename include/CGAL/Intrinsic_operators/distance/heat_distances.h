// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_DISTANCE_HEAT_DISTANCES_H
#define CGAL_INTRINSIC_OPERATORS_DISTANCE_HEAT_DISTANCES_H

#include <CGAL/Intrinsic_geodesics/distance/batches.h>
#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/distance/Heat_solver.h>
#include <CGAL/Intrinsic_operators/distance/distance_sources.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// What a batch reads of a `Heat_distance`.
struct Heat_batch {
  const Heat_solver& solver;
  const std::vector<std::array<double, 3>>& positions;
  bool is_stopped; // during construction

  template <class Triangulation>
  explicit Heat_batch(const Heat_distance<Triangulation>& heat)
      : solver(heat.solver_), positions(heat.positions_), is_stopped(heat.is_stopped_) {}

  template <class Triangulation>
  static const Triangulation& triangulation(const Heat_distance<Triangulation>& heat) {
    return *heat.t_;
  }
};

/*!
\brief solves for the distances from many sets of sources, several of them together, in threads.
\param take called with the number of a set and its distances by rows, by several threads at once
\param progress called after each set, in the thread of the caller, with the number of sets done;
  returns whether to go on
\return whether all sets were done
*/
bool for_each_heat_column(const Heat_batch& batch, std::span<const Source_places> sets,
                          std::size_t threads,
                          const std::function<void(std::size_t, std::span<const double>)>& take,
                          const std::function<bool(std::size_t)>& progress);

} // namespace internal

/*!
\brief finds distances of all vertices by heat, from each of many sets of sources.

The matrices are those of `heat`, factored once. Each thread solves for eight sets at a time, which
reads the factors once for all of them. The results are those of `heat.distances()` for each set,
bit by bit, for any number of threads.

Large matrices of distances need not fit in memory: `out` may be a file that is mapped to memory,
and calls with parts of the sets share `heat`.

\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\tparam SourceSets a random access range; each element is what `Heat_distance::distances()` takes
\tparam Number `float` or `double`
\tparam NP a chain of named parameters
\param heat the factored matrices; it is not changed
\param sets the sets of sources
\param out where the distances go: a column per set, a row per vertex, see
  `Intrinsic_triangulation::input_vertex()`; columns are contiguous. Infinity where no path leads to
  a source.
\param np optional named parameters:
  - `number_of_threads(n)`: 0, the default, is the number of processors;
  - `visitor(v)`: see `Batch_visitor`.
\return `done`, or `cancelled` if the visitor has ended the batch, or had ended the construction of
  `heat`: columns that were not computed are not written
\throws std::invalid_argument if `out` has another size than vertices times sets, or for a set that
  `Heat_distance::distances()` refuses; then nothing is written
\throws std::runtime_error if rounding makes a matrix indefinite
\complexity that of the solutions. Sets with more than twenty sources need a factorization each.
  Memory: about 50 numbers per vertex and thread
*/
template <NumberedTriangulation Triangulation, std::ranges::random_access_range SourceSets,
          std::floating_point Number, NamedParameters NP = parameters::Parameters<>>
  requires MeasuredTriangulation<Triangulation>
      Status heat_distances(const Heat_distance<Triangulation>& heat, const SourceSets& sets,
                            std::span<Number> out, const NP& np = parameters::default_values()) {
    using namespace internal::tags;
    internal::expect_names<number_of_threads, visitor>(np);
    const Triangulation& t = internal::Heat_batch::triangulation(heat);
    const internal::Heat_batch batch(heat);
    const std::size_t columns = std::ranges::size(sets), rows = t.number_of_vertices();
    internal::expect_columns(rows, columns, out.size());
    if (batch.is_stopped) return Status::cancelled;
    std::vector<internal::Source_places> places;
    for (const auto& set : sets)
      places.push_back(internal::Source_reader<Triangulation>(t, batch.solver.table()).read(set));
    auto stored_visitor = internal::object_or<visitor>(np, Batch_visitor());
    auto& observed = internal::unwrapped(stored_visitor);
    const bool is_complete = internal::for_each_heat_column(
        batch, places, internal::value_or<number_of_threads>(np, std::size_t{0}),
        [&](std::size_t i, std::span<const double> column) {
          std::transform(column.begin(), column.end(), out.subspan(i * rows, rows).begin(),
                         [](double d) { return static_cast<Number>(d); });
        },
        [&](std::size_t done) { return observed.progress(done, columns); });
    return is_complete ? Status::done : Status::cancelled;
  }

/*!
\brief factors the matrices of the heat flow and finds the distances from each of many sets of
  sources.

See the overload for a `Heat_distance`, which this function constructs.
\param t the triangulation
\param sets the sets of sources
\param out where the distances go
\param np optional named parameters: `number_of_threads(n)` and `visitor(v)` as above;
  `time_factor(x)` and `border_condition(c)` as for `Heat_distance`
\return as above
\throws Invalid_input if a face has no area
\throws std::invalid_argument,std::runtime_error as the constructor of `Heat_distance` and as above
\complexity that of the factorizations and of the solutions
*/
template <NumberedTriangulation Triangulation, std::ranges::random_access_range SourceSets,
          std::floating_point Number, NamedParameters NP = parameters::Parameters<>>
  requires MeasuredTriangulation<Triangulation>
      Status heat_distances(const Triangulation& t, const SourceSets& sets, std::span<Number> out,
                            const NP& np = parameters::default_values()) {
    using namespace internal::tags;
    internal::expect_names<number_of_threads, visitor, time_factor, border_condition>(np);
    const Heat_distance<Triangulation> heat(
        t, parameters::time_factor(internal::value_or<time_factor>(np, 1.0))
               .border_condition(internal::value_or<border_condition>(np, Heat_border::average)));
    return heat_distances(
        heat, sets, out,
        parameters::number_of_threads(internal::value_or<number_of_threads>(np, std::size_t{0}))
            .visitor(internal::object_or<visitor>(np, Batch_visitor())));
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_DISTANCE_HEAT_DISTANCES_H
