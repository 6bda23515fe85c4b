// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_BATCHES_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_BATCHES_H

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief observes a batch of distances; the default visitor does nothing. It is called in the thread
  that has asked for the batch.
*/
struct Batch_visitor {
  /*!
  \brief is called after each part of the batch.
  \param done number of parts that are done
  \param all number of parts: columns, or pairs
  \return whether to go on
  */
  bool progress([[maybe_unused]] std::size_t done, [[maybe_unused]] std::size_t all) {
    return true;
  }
};

namespace internal {

/*!
\brief calls a function with each number below `size`, in several threads.
\param size number of calls
\param threads number of threads, 0 for as many as there are processors
\param make_worker called once in each thread; returns the function
\param progress called for each call of the function, some time after it, in the thread that calls
  `for_each_in_threads()`; returns whether to go on
\return whether all calls were made
\throws what a call throws, after the others have ended
*/
bool for_each_in_threads(std::size_t size, std::size_t threads,
                         const std::function<std::function<void(std::size_t)>()>& make_worker,
                         const std::function<bool(std::size_t)>& progress);

// Throws std::invalid_argument unless there is place for a number per row and column.
void expect_columns(std::size_t rows, std::size_t columns, std::size_t places);

// Calls a function with a `Polyhedral_distance` that its thread has alone, and each number below
// `size`. Takes `number_of_threads` and `visitor`. Returns whether all calls were made.
template <class Distance, class NP, class Function>
bool search_in_threads(const Distance& surface, std::size_t size, const NP& np,
                       const Function& search) {
  auto stored_visitor = object_or<tags::visitor>(np, Batch_visitor());
  auto& observed = unwrapped(stored_visitor);
  return for_each_in_threads(
      size, value_or<tags::number_of_threads>(np, std::size_t{0}),
      [&] {
        return [&, own = std::make_shared<Distance>(surface.without_sources())](std::size_t i) {
          search(*own, i);
        };
      },
      [&](std::size_t done) { return observed.progress(done, size); });
}

// What orders the places of pairs.
template <class Triangulation>
std::uint32_t key_of_place(const Triangulation& t, typename Triangulation::vertex_descriptor v) {
  return t.index(v);
}
template <class Triangulation>
std::pair<std::uint32_t, std::array<double, 3>> key_of_place(const Triangulation&,
                                                             const Surface_point& p) {
  return {p.halfedge, p.weights};
}

} // namespace internal

/*!
\brief finds the exact distances of all vertices from each of many sets of sources.

The results are those of `Polyhedral_distance` for each set. Every thread reads the triangulation
into tables of its own, once for all sets that it searches.

\tparam Triangulation a model of `NumberedTriangulation`
\tparam SourceSets a random access range; each element is what `Polyhedral_distance` takes as
  sources
\tparam Number `float` or `double`
\tparam NP a chain of named parameters
\param t the triangulation
\param sets the sets of sources
\param out where the distances go: a column per set, a row per vertex, see
  `Intrinsic_triangulation::input_vertex()`; columns are contiguous. Infinity where the search did
  not arrive.
\param np optional named parameters:
  - `number_of_threads(n)`: 0, the default, is the number of processors;
  - `maximum_distance(d)`, `targets(p)`, `maximum_number(n)`: see `Polyhedral_distance`; the same
    for all sets;
  - `visitor(v)`: see `Batch_visitor`.
\return `done`; `cap` if a search has met the cap on windows; `cancelled` if the visitor has ended
  the batch: columns that were not searched are not written
\throws std::invalid_argument if `out` has another size than vertices times sets
\complexity that of the searches. Memory: see `Polyhedral_distance`, for each thread
*/
template <NumberedTriangulation Triangulation, std::ranges::random_access_range SourceSets,
          std::floating_point Number, NamedParameters NP = parameters::Parameters<>>
Status polyhedral_distances(const Triangulation& t, const SourceSets& sets, std::span<Number> out,
                            const NP& np = parameters::default_values()) {
  using namespace internal::tags;
  internal::expect_names<number_of_threads, maximum_distance, targets, maximum_number, visitor>(np);
  const std::size_t columns = std::ranges::size(sets), rows = t.number_of_vertices();
  internal::expect_columns(rows, columns, out.size());
  const auto surface = Polyhedral_distance<Triangulation>::on_faces(t);
  const auto limits =
      parameters::maximum_distance(
          internal::value_or<maximum_distance>(np, std::numeric_limits<double>::infinity()))
          .maximum_number(internal::value_or<maximum_number>(np, surface.default_cap()))
          .targets(internal::object_or<targets>(np, std::array<Surface_point, 0>()));
  std::vector<Status> statuses(columns, Status::done);
  const bool is_complete =
      internal::search_in_threads(surface, columns, np, [&](auto& own, std::size_t i) {
        statuses[i] = own.search(std::ranges::begin(sets)[std::ptrdiff_t(i)], limits);
        own.copy_distances(out.subspan(i * rows, rows));
      });
  if (!is_complete) return Status::cancelled;
  const bool has_cap = std::find(statuses.begin(), statuses.end(), Status::cap) != statuses.end();
  return has_cap ? Status::cap : Status::done;
}

/*!
\brief finds the exact distances between vertices or points, pair by pair.

Pairs with the same first place share a search, which stops when its distances are final. Distances
are symmetric: give the places that repeat first.

\tparam Triangulation a model of `NumberedTriangulation`
\tparam Place its vertex, or `Surface_point`
\tparam NP a chain of named parameters
\param t the triangulation
\param from the first places
\param to the second places, as many
\param np optional named parameters: `number_of_threads(n)`, `maximum_number(n)` and `visitor(v)`,
  see `polyhedral_distances()`
\return the distance of each pair, in the units of the input; infinity between components, and not
  a number for pairs that the visitor has prevented
\throws std::invalid_argument if there are not as many second places as first ones
\complexity a search for each place that is the first of a pair, as far as its farthest partner
*/
template <NumberedTriangulation Triangulation,
          internal::Place_on<Triangulation> Place = typename Triangulation::vertex_descriptor,
          NamedParameters NP = parameters::Parameters<>>
std::vector<double> pair_distances(const Triangulation& t, const std::vector<Place>& from,
                                   const std::vector<Place>& to,
                                   const NP& np = parameters::default_values()) {
  using namespace internal::tags;
  internal::expect_names<number_of_threads, maximum_number, visitor>(np);
  if (from.size() != to.size())
    throw std::invalid_argument("pairs need as many second places as first ones, not " +
                                std::to_string(to.size()) + " for " + std::to_string(from.size()));
  std::vector<std::size_t> order(from.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) { return internal::key_of_place(t, from[i]); };
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
  std::vector<std::size_t> begins; // of pairs with the same first place
  for (std::size_t k = 0; k < order.size(); ++k)
    if (k == 0 || key(order[k]) != key(order[k - 1])) begins.push_back(k);
  begins.push_back(order.size());
  const auto surface = Polyhedral_distance<Triangulation>::on_faces(t);
  std::vector<double> result(from.size(), std::numeric_limits<double>::quiet_NaN());
  internal::search_in_threads(surface, begins.size() - 1, np, [&](auto& own, std::size_t group) {
    const auto pairs = std::span(order).subspan(begins[group], begins[group + 1] - begins[group]);
    std::vector<Place> partners;
    for (const std::size_t i : pairs) partners.push_back(to[i]);
    own.search(from[pairs.front()],
               parameters::targets(partners).maximum_number(
                   internal::value_or<maximum_number>(np, surface.default_cap())));
    for (const std::size_t i : pairs) result[i] = own.distance(to[i]);
  });
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_BATCHES_H
