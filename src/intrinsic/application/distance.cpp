// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "../levels.h"
#include "../status_name.h"
#include "../support/Number_rows.h"
#include "../support/Range.h"
#include "../support/progress.h"
#include "Column_writer.h"
#include "Distance_columns.h"
#include "application.h"
#include "vertex_sets.h"

#include <CGAL/Intrinsic_geodesics/compiled.h>
#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/distance/batches.h>
#include <CGAL/Intrinsic_geodesics/queries/insert_places.h>
#include <CGAL/Intrinsic_geodesics/voronoi/voronoi_cells.h>
#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/distance/Signed_heat_distance.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Twin_points.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

using Curve = std::vector<IT::Gluing_map::Halfedge>;
using Places = std::span<const std::vector<IT::Place>>;

// the shortest ways along edges from each point of a curve to the next one
template <class Triangulation>
Curve along_edges(const Triangulation& t, const Vertices& points, const std::string& name) {
  IT::Edge_path_finder<Triangulation> find(t);
  Curve curve;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Curve way = find(points[i], points[i + 1]);
    if (way.empty())
      throw std::runtime_error("--curve " + name +
                               ": no edges lead from a point to the next one; choose different "
                               "points of one component");
    curve.insert(curve.end(), way.begin(), way.end());
  }
  return curve;
}

template <class Triangulation>
Computed computed_distances(const Triangulation& t, Eigen::VectorXd distances,
                            const Application_options& o) {
  Computed computed{"distance", {}, {}};
  IT::Twin_points(t).copy(distances);
  const Range range = range_of(distances);
  computed.json = {{"method", o.distance},
                   {"sources", o.sources.size()},
                   {"curves", o.curves.size()},
                   {"signed", o.is_signed},
                   {"min", finite_or_null(range.least)},
                   {"max", finite_or_null(range.greatest)},
                   {"unreached_vertices", range.infinite}};
  if (!o.isolines.empty()) {
    computed.levels = levels_of(o.levels, range.least, range.greatest);
    computed.json["levels"] = computed.levels;
  }
  computed.functions.push_back({"distance", std::move(distances)});
  computed.isolines = 25;
  return computed;
}

// The points of all places in lists; on a cover, a place has several. `first`: the number of the
// first point of each place, and that of points.
struct Joined_points {
  std::vector<IT::Surface_point> points;
  std::vector<std::size_t> first;

  std::span<const IT::Surface_point> of_place(std::size_t i) const {
    return std::span(points).subspan(first[i], first[i + 1] - first[i]);
  }
  std::size_t number_of_places() const { return first.size() - 1; }
  std::vector<std::uint32_t> place_of_point() const {
    std::vector<std::uint32_t> result(points.size());
    for (std::size_t i = 0; i + 1 < first.size(); ++i)
      std::fill(result.begin() + static_cast<std::ptrdiff_t>(first[i]),
                result.begin() + static_cast<std::ptrdiff_t>(first[i + 1]),
                static_cast<std::uint32_t>(i));
    return result;
  }
};

template <class Triangulation>
Joined_points joined(const Triangulation& t, Places lists) {
  IT::Place_finder<Triangulation> find(t);
  Joined_points result{{}, {0}};
  for (const std::vector<IT::Place>& list : lists)
    for (const IT::Place& p : list) {
      find.append(p, result.points);
      result.first.push_back(result.points.size());
    }
  return result;
}

template <class Triangulation>
Computed heat_distances(Triangulation& t, const Sources& sources, const Application_options& o) {
  std::vector<Curve> curves; // their vertices are there
  for (std::size_t i = 0; i < o.curves.size(); ++i)
    curves.push_back(
        along_edges(t, IT::insert_places(t, sources[o.sources.size() + i]), o.curves[i]));
  const auto with_time = [&](Eigen::VectorXd distances, double time) {
    Computed computed = computed_distances(t, std::move(distances), o);
    computed.json["time"] = time;
    return computed;
  };
  const auto factor = IT::parameters::time_factor(o.time_factor);
  if (o.is_signed) {
    IT::Signed_heat_distance heat(t, factor);
    return with_time(heat.distances(curves), heat.time());
  }
  const auto points = joined(t, Places(sources).first(o.sources.size())).points;
  IT::Heat_distance heat(t, factor);
  return with_time(curves.empty()   ? heat.distances(points)
                   : points.empty() ? heat.distances(curves)
                                    : heat.distances(points).cwiseMin(heat.distances(curves)),
                   heat.time());
}

template <class Triangulation>
IT::Voronoi_cells cells_of(const IT::Polyhedral_distance<Triangulation>& search,
                           const std::vector<std::uint32_t>& cell_of_source,
                           const Application_options& o) {
  return o.cell_tolerance ? IT::voronoi_cells(search, cell_of_source,
                                              IT::parameters::tolerance(*o.cell_tolerance))
                          : IT::voronoi_cells(search, cell_of_source);
}

// Divides the surface among the sources, or sets of them.
template <class Triangulation>
void add_cells(const IT::Polyhedral_distance<Triangulation>& search,
               const std::vector<std::uint32_t>& cell_of_source, const Application_options& o,
               Computed& computed) {
  const Triangulation& t = search.triangulation();
  IT::Voronoi_cells cells = cells_of(search, cell_of_source, o);
  std::vector<std::size_t> sizes(cells.areas.size());
  Function nearest{"nearest_source", computed.functions.front().values};
  for (const auto v : vertices(t.mesh())) {
    const std::uint32_t source = search.nearest_source(v);
    const bool is_reached = source != IT::Gluing::none;
    nearest.values[t.input_vertex(v)] = is_reached ? double(cell_of_source[source]) : -1;
    if (is_reached) ++sizes[cell_of_source[source]];
  }
  IT::Twin_points(t).copy(nearest.values);
  computed.functions.push_back(std::move(nearest));
  computed.json["cells"] = {{"vertices", sizes},
                            {"areas", cells.areas},
                            {"boundaries", cells.boundaries.size()},
                            {"junctions", cells.junctions.size()},
                            {"status", program::name(cells.status)}};
  computed.cell_boundaries =
      [&t, cells = std::move(cells)](const std::vector<std::array<double, 3>>& points) {
        return IT::polylines(t, cells, points);
      };
}

// The distances that a search has found, and how it ended.
template <class Triangulation>
Computed found_distances(const IT::Polyhedral_distance<Triangulation>& search,
                         const Application_options& o) {
  const std::vector<double> by_row = search.distances();
  const auto rows = static_cast<Eigen::Index>(by_row.size());
  Computed computed = computed_distances(search.triangulation(),
                                         Eigen::Map<const Eigen::VectorXd>(by_row.data(), rows), o);
  computed.json["status"] = program::name(search.status());
  return computed;
}

template <class Triangulation>
Computed exact_distances(const Triangulation& t, const Sources& sources,
                         const Application_options& o) {
  const Joined_points from = joined(t, Places(sources).first(o.sources.size())),
                      to = joined(t, Places(sources).subspan(o.sources.size()));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  auto search = IT::Polyhedral_distance<Triangulation>::on_faces(t);
  search.search(
      from.points,
      IT::parameters::maximum_distance(o.maximum_distance.value_or(infinity)).targets(to.points));
  Computed computed = found_distances(search, o);
  Json to_targets = Json::array();
  for (std::size_t i = 0; i < to.number_of_places(); ++i) {
    double least = infinity;
    for (const IT::Surface_point& p : to.of_place(i)) least = std::min(least, search.distance(p));
    to_targets.push_back(finite_or_null(least));
  }
  computed.json["reached"] = finite_or_null(search.reached_distance());
  computed.json["targets"] = std::move(to_targets);
  if (!o.voronoi.empty()) add_cells(search, from.place_of_point(), o, computed);
  return computed;
}

// The distance of the nearest set of sources in a file, and the cells of the sets.
template <class Triangulation>
Computed cells_of_sets(const Triangulation& t, const Application_options& o) {
  const std::vector<Vertices> sets =
      vertices_of(t, read_vertex_sets(o.source_sets, t.input().number_of_rows(), false));
  auto search = IT::Polyhedral_distance<Triangulation>::on_faces(t);
  search.search(sets);
  Computed computed = found_distances(search, o);
  computed.json["sets"] = sets.size();
  std::vector<std::uint32_t> set_of_source;
  for (std::size_t i = 0; i < sets.size(); ++i)
    set_of_source.insert(set_of_source.end(), sets[i].size(), static_cast<std::uint32_t>(i));
  add_cells(search, set_of_source, o, computed);
  return computed;
}

// Writes the distances of the vertices of the file, a column for each set of sources.
template <class Triangulation>
Computed distance_matrix(const Triangulation& t, const Options& options, Progress& progress) {
  const std::size_t rows = t.input().number_of_rows();
  const Vertex_sets asked = read_vertex_sets(options.application.source_sets, rows, false);
  Computed computed{"distance", {}, {}};
  computed.json = {{"method", options.application.distance}, {"sets", asked.rows.size()}};
  computed.write = [&t, &options, &progress, rows, sets = vertices_of(t, asked)](std::ostream& out,
                                                                                 Json& json) {
    const Distance_columns<Triangulation> columns(t, options.application, progress);
    Column_writer file(out, options.output, rows, sets.size());
    Range range;
    const IT::Status status =
        columns.for_each(sets, [&](std::size_t, std::span<const double> column) {
          for (const double d : column.first(rows)) range.add(d);
          file.write(column.first(rows));
        });
    file.finish();
    columns.report(json);
    json["status"] = program::name(status);
    json["min"] = finite_or_null(range.least);
    json["max"] = finite_or_null(range.greatest);
    json["unreached"] = range.infinite;
  };
  return computed;
}

// By heat: a solution for each vertex that is the first of a pair.
template <class Triangulation>
std::vector<double> heat_of_pairs(const Triangulation& t, const Vertices& from, const Vertices& to,
                                  const Distance_columns<Triangulation>& columns) {
  std::vector<std::size_t> order(from.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return t.index(from[i]); });
  std::vector<Vertices> sources;
  for (const std::size_t i : order)
    if (sources.empty() || from[i] != sources.back().front()) sources.push_back({from[i]});
  std::vector<double> result(from.size());
  auto next = order.begin();
  columns.for_each(sources, [&](std::size_t set, std::span<const double> column) {
    for (; next != order.end() && from[*next] == sources[set].front(); ++next)
      result[*next] = column[t.input_vertex(to[*next])];
  });
  return result;
}

template <class Triangulation>
Computed distances_of_pairs(const Triangulation& t, const Options& options, Progress& progress) {
  const Application_options& o = options.application;
  Vertices from, to;
  for (const Vertices& pair :
       vertices_of(t, read_vertex_sets(o.pairs, t.input().number_of_rows(), true))) {
    from.push_back(pair[0]);
    to.push_back(pair[1]);
  }
  const Distance_columns<Triangulation> columns(t, o, progress);
  const std::vector<double> distances =
      o.distance == "exact"
          ? IT::pair_distances(t, from, to, IT::parameters::visitor(Batch_progress{progress}))
          : heat_of_pairs(t, from, to, columns);
  const Range range = range_of(distances);
  Computed computed{"distance", {}, {}};
  computed.json = {{"method", o.distance}, {"pairs", from.size()}};
  columns.report(computed.json);
  computed.json["min"] = finite_or_null(range.least);
  computed.json["max"] = finite_or_null(range.greatest);
  computed.json["unreached"] = range.infinite;
  computed.json["distances"] = Json::array();
  for (const double d : distances) computed.json["distances"].push_back(finite_or_null(d));
  computed.write = [distances](std::ostream& out, Json&) {
    Number_rows numbers(out);
    for (const double d : distances) {
      numbers.put(d);
      numbers.end_row();
    }
  };
  return computed;
}

} // namespace

void run_distance(const Options& options) {
  run_application(options, [&](auto& t, const Sources& sources, const Points&, Progress& progress) {
    const Application_options& o = options.application;
    if (!o.pairs.empty()) return distances_of_pairs(t, options, progress);
    if (!o.source_sets.empty())
      return o.voronoi.empty() ? distance_matrix(t, options, progress) : cells_of_sets(t, o);
    return o.distance == "exact" ? exact_distances(t, sources, o) : heat_distances(t, sources, o);
  });
}

} // namespace program
