// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_DISTANCE_DISTANCES_H
#define CGAL_INTRINSIC_OPERATORS_DISTANCE_DISTANCES_H

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/distance/batches.h>
#include <CGAL/Intrinsic_operators/distance/Distance_options.h>
#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/distance/heat_distances.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Twin_points.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The numbers of the places, those of equal places together.
std::vector<std::vector<std::size_t>> equal_places(const std::vector<Place>& places);

} // namespace internal

/*!
\brief finds distances between places that a user names, by either method, with the tables of exact
distances and the factored matrices of heat kept from call to call.

On a cover, a place has points on all sheets. Points of a cloud that lie at the place of another
have its distance.
\tparam Triangulation a model of `CorrespondingTriangulation` and `MeasuredTriangulation`
*/
template <QueriedTriangulation Triangulation>
class Distances {
public:
  /// Places that are sources together: the distance is that from the nearest one.
  using Source_set = std::vector<Place>;

  /// prepares calls on a triangulation, which must outlive this object unchanged.
  explicit Distances(const Triangulation& t) : t_(t), find_(t), twins_(t) {}
  explicit Distances(const Triangulation&&) = delete; // it would end before
  Distances(const Distances&) = delete;
  Distances& operator=(const Distances&) = delete;

  /*!
  \brief finds the distances of all vertices from sources, and of targets.
  \param sources the sources
  \param options how
  \param targets where an exact search ends as soon as their distances are known; by heat, values
    are linear in faces of the triangulation
  \throws Invalid_input if there is no source, a place does not exist, or a face has no area
  \throws std::invalid_argument, std::runtime_error see `Heat_distance`
  \complexity see `Polyhedral_distance` and `Heat_distance`
  */
  Found_distances from(const Source_set& sources, const Distance_options& options = {},
                       const std::vector<Place>& targets = {}) {
    expect_sources(sources);
    const Using use(*this, options);
    Found_distances found = options.method == Distance_method::exact ? exact(sources, targets)
                                                                     : by_heat(sources, targets);
    twins_.copy(found.by_row);
    return found;
  }

  /*!
  \brief finds the distances of all vertices from each of many sets.
  \param sets the sets of sources
  \param out a column per set, a row per vertex; columns are contiguous
  \param options how
  \return `done`; `cap` if a search has met its cap; `cancelled`: not all columns are written
  \throws Invalid_input, std::invalid_argument, std::runtime_error as `from()`, or if `out` has
    another size
  */
  Status columns(const std::vector<Source_set>& sets, std::span<double> out,
                 const Distance_options& options = {}) {
    return fill(sets, out, options);
  }
  /// the same, rounded.
  Status columns(const std::vector<Source_set>& sets, std::span<float> out,
                 const Distance_options& options = {}) {
    return fill(sets, out, options);
  }

  /*!
  \brief finds the same columns, many at a time, so that all need not be in memory.
  \param sets the sets of sources
  \param take called with the number of each set, in order, and its distances by rows
  \param options how
  \return see `columns()`
  */
  template <class Take>
  Status for_each_column(const std::vector<Source_set>& sets, const Take& take,
                         const Distance_options& options = {}) {
    constexpr std::size_t most_numbers = std::size_t{1} << 25; // 256 MiB in memory at a time
    const std::size_t rows = t_.number_of_vertices();
    const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t step = std::max(most_numbers / std::max(rows, std::size_t{1}), threads);
    std::vector<double> block;
    Status status = Status::done;
    for (std::size_t i = 0; i < sets.size(); i += step) {
      const std::span of_part = std::span(sets).subspan(i, std::min(step, sets.size() - i));
      const std::vector<Source_set> part(of_part.begin(), of_part.end());
      block.resize(part.size() * rows);
      Distance_options in_all = options;
      if (options.progress)
        in_all.progress = [&](Distance_step s, std::uint64_t done, std::uint64_t all) {
          const bool is_part = s == Distance_step::parts;
          return options.progress(s, is_part ? i + done : done, is_part ? sets.size() : all);
        };
      if (const Status s = columns(part, block, in_all); s != Status::done) status = s;
      if (status == Status::cancelled) return status;
      for (std::size_t k = 0; k < part.size(); ++k)
        take(i + k, std::span<const double>(block).subspan(k * rows, rows));
    }
    return status;
  }

  /*!
  \brief finds the distance of each pair of places. Those with the same first place share a search
  or a solution: let places that repeat be first.
  \param from the first places
  \param to the second ones, as many
  \param options how
  \return a distance per pair; infinity between components
  \throws Invalid_input, std::invalid_argument, std::runtime_error as `from()`, or if there are not
    as many second places
  */
  std::vector<double> of_pairs(const std::vector<Place>& from, const std::vector<Place>& to,
                               const Distance_options& options = {}) {
    if (from.size() != to.size())
      throw Invalid_input(Element_kind::none, 0,
                          "there are " + std::to_string(from.size()) + " first places and " +
                              std::to_string(to.size()) + " second ones; give as many");
    return options.method == Distance_method::exact ? exact_pairs(from, to, options)
                                                    : heat_of_pairs(from, to, options);
  }

  /// returns the search for exact distances, for cells and paths: that of the last call of `from()`
  /// unless a target was inside a face.
  Polyhedral_distance<Triangulation>& exact_search() {
    if (!search_) search_.emplace(Polyhedral_distance<Triangulation>::on_faces(t_));
    return *search_;
  }
  /// frees the tables of exact distances.
  void forget_exact_search() { search_.reset(); }

  /// returns the time of the flow of heat, in units of area of the input.
  double heat_time(const Distance_options& options) {
    const Using use(*this, options);
    return heat().time();
  }

private:
  using Heat = Heat_distance<Triangulation>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // What calls ask for, while they last: matrices that are kept ask it whether to go on.
  struct Using {
    Distances& distances;
    Using(Distances& d, const Distance_options& o) : distances(d) { d.options_ = &o; }
    ~Using() {
      distances.options_ = nullptr;
      if (distances.heat_ && distances.heat_->status() == Status::cancelled)
        distances.heat_.reset();
    }
  };
  bool progress(Distance_step step, std::uint64_t done, std::uint64_t all) const {
    return options_ == nullptr || !options_->progress || options_->progress(step, done, all);
  }
  struct Visitor {
    const Distances* of;
    bool progress(Heat_step) { return of->progress(Distance_step::matrices, 0, 0); }
    bool progress(std::uint64_t windows, double) {
      return of->progress(Distance_step::windows, windows, 0);
    }
    bool progress(std::size_t done, std::size_t all) {
      return of->progress(Distance_step::parts, done, all);
    }
  };

  static void expect_sources(const Source_set& sources) {
    if (sources.empty())
      throw Invalid_input(Element_kind::none, 0, "distances need a source; give one at least");
  }

  Found_distances exact(const Source_set& sources, const std::vector<Place>& targets) {
    Polyhedral_distance<Triangulation>& search = exact_search();
    Found_distances found;
    found.status = search.search(find_.points(sources),
                                 parameters::maximum_distance(options_->maximum_distance)
                                     .targets(find_.points(targets))
                                     .visitor(Visitor{this}));
    found.reached = search.reached_distance();
    found.by_row = search.distances();
    for (const Place& p : targets) {
      double least = infinity;
      for (const Surface_point& q : find_.points(p)) least = std::min(least, search.distance(q));
      found.at_targets.push_back(least);
    }
    // distances inside faces have taken windows, which are large
    if (!std::all_of(targets.begin(), targets.end(), std::mem_fn(&Place::is_vertex)))
      forget_exact_search();
    return found;
  }

  Heat& heat() {
    if (heat_ && heat_factor_ != options_->time_factor) heat_.reset();
    heat_factor_ = options_->time_factor;
    if (!heat_) heat_.emplace(t_, parameters::time_factor(heat_factor_).visitor(Visitor{this}));
    return *heat_;
  }

  Found_distances by_heat(const Source_set& sources, const std::vector<Place>& targets) {
    Found_distances found;
    const Eigen::VectorXd rows = heat().distances(find_.points(sources));
    found.status = heat().status();
    found.time = heat().time();
    if (found.status == Status::cancelled) return found;
    found.by_row.assign(rows.begin(), rows.end());
    for (const Place& p : targets) found.at_targets.push_back(value_at(p, found.by_row));
    return found;
  }

  // Linear in the face of a place.
  double value_at(const Place& p, std::span<const double> rows) {
    const Surface_point q = find_.points(p).front();
    auto h = t_.numbers().halfedge_at(q.halfedge);
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k, h = next(h, t_.mesh()))
      if (q.weights[k] != 0) sum += q.weights[k] * rows[t_.input_vertex(source(h, t_.mesh()))];
    return sum;
  }

  template <class Number>
  Status fill(const std::vector<Source_set>& sets, std::span<Number> out,
              const Distance_options& options) {
    const Using use(*this, options);
    std::vector<std::vector<Surface_point>> points;
    for (const Source_set& set : sets) {
      expect_sources(set);
      points.push_back(find_.points(set));
    }
    const auto np = parameters::number_of_threads(options.number_of_threads).visitor(Visitor{this});
    const Status status =
        options.method == Distance_method::exact
            ? polyhedral_distances(t_, points, out, np.maximum_distance(options.maximum_distance))
            : heat_distances(heat(), points, out, np);
    const std::size_t rows = t_.number_of_vertices();
    for (std::size_t i = 0; i < sets.size(); ++i) {
      const std::span<Number> column = out.subspan(i * rows, rows);
      twins_.copy(column);
    }
    return status;
  }

  // A copy of a vertex is one point for exact distances; other places have one on each sheet.
  std::vector<Surface_point> points_for_pairs(const Place& p) {
    std::vector<Surface_point> points = find_.points(p);
    if (p.is_vertex()) points.resize(1);
    return points;
  }

  std::vector<double> exact_pairs(const std::vector<Place>& from, const std::vector<Place>& to,
                                  const Distance_options& options) {
    const Using use(*this, options);
    std::vector<Surface_point> starts, ends;
    std::vector<std::size_t> pair;
    for (std::size_t i = 0; i < from.size(); ++i)
      for (const Surface_point& p : points_for_pairs(from[i]))
        for (const Surface_point& q : points_for_pairs(to[i])) {
          starts.push_back(p);
          ends.push_back(q);
          pair.push_back(i);
        }
    const std::vector<double> all = pair_distances(
        t_, starts, ends,
        parameters::number_of_threads(options.number_of_threads).visitor(Visitor{this}));
    std::vector<double> result(from.size(), infinity);
    for (std::size_t k = 0; k < all.size(); ++k)
      result[pair[k]] = std::min(result[pair[k]], all[k]);
    return result;
  }

  // A solution for each place that is the first of a pair.
  std::vector<double> heat_of_pairs(const std::vector<Place>& from, const std::vector<Place>& to,
                                    const Distance_options& options) {
    const std::vector<std::vector<std::size_t>> pairs = internal::equal_places(from);
    std::vector<Source_set> sets;
    for (const std::vector<std::size_t>& members : pairs) sets.push_back({from[members.front()]});
    std::vector<double> result(from.size());
    for_each_column(
        sets,
        [&](std::size_t k, std::span<const double> column) {
          for (const std::size_t i : pairs[k]) result[i] = value_at(to[i], column);
        },
        options);
    return result;
  }

  const Triangulation& t_;
  Place_finder<Triangulation> find_;
  Twin_points twins_;
  std::optional<Polyhedral_distance<Triangulation>> search_;
  std::optional<Heat> heat_;
  double heat_factor_ = 0;
  const Distance_options* options_ = nullptr; // of the call that lasts
};

/// finds the distances of all vertices from sources, and of targets: one call of
/// `Distances::from()`, see there.
template <QueriedTriangulation Triangulation>
Found_distances distances(const Triangulation& t, const std::vector<Place>& sources,
                          const Distance_options& options = {},
                          const std::vector<Place>& targets = {}) {
  return Distances<Triangulation>(t).from(sources, options, targets);
}

/// \cond
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
extern template class Distances<
    Intrinsic_triangulation<Gluing_map, Exact_euclidean_traits, Integer_coordinates>>;
extern template class Distances<
    Intrinsic_triangulation<Gluing_map, Euclidean_traits<double>, Integer_coordinates>>;
#endif
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_DISTANCE_DISTANCES_H
