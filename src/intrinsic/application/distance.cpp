// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "../geodesic/Range.h"
#include "../support/Number_rows.h"
#include "../support/naming_file.h"
#include "../support/progress.h"
#include "../support/text_lines.h"
#include "Row_writer.h"
#include "application.h"

#include <CGAL/Intrinsic_geodesics/compiled.h>
#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/queries/insert_places.h>
#include <CGAL/Intrinsic_geodesics/voronoi/voronoi_cells.h>
#include <CGAL/Intrinsic_operators/distance/Distances.h>
#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/distance/Signed_heat_distance.h>
#include <CGAL/Intrinsic_operators/distance/divide_among.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Twin_points.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

using Places = std::vector<IT::Place>;

IT::Distance_options asked_of(const Application_options& o, Progress& progress) {
  IT::Distance_options asked;
  asked.method = o.distance == "exact" ? IT::Distance_method::exact : IT::Distance_method::heat;
  asked.maximum_distance = o.maximum_distance.value_or(asked.maximum_distance);
  asked.time_factor = o.time_factor;
  asked.progress = [&progress](IT::Distance_step step, std::uint64_t done, std::uint64_t all) {
    return step != IT::Distance_step::parts ||
           progress.show("solving", std::to_string(done) + " of " + std::to_string(all));
  };
  return asked;
}

// Reads a text file with numbers of vertices on each line, two for pairs.
// \throws std::runtime_error naming the line that is wrong, or has a vertex without faces
template <class Triangulation>
Sources read_places(const Triangulation& t, const std::string& path, bool are_pairs) {
  IT::Place_finder<Triangulation> find(t);
  Text_lines lines(path);
  Sources sets;
  while (lines.next()) {
    if (are_pairs) lines.expect_words(2, "the numbers of two vertices");
    Places& places = sets.emplace_back();
    for (std::size_t i = 0; i < lines.words().size(); ++i) try {
        places.push_back(
            IT::Place::at_vertex(lines.element(i, "vertex", t.input().number_of_rows())));
        (void)find.vertex(places.back().vertex);
      } catch (const IT::Invalid_input& e) {
        lines.refuse(e.what());
      }
  }
  if (sets.empty())
    throw std::runtime_error(path + ": the file has no vertices; give " +
                             (are_pairs ? "two" : "the sources of a column") + " on each line");
  return sets;
}

// The places of lists, one after another.
Places joined(const Sources& lists, std::size_t from, std::size_t to) {
  Places result;
  for (std::size_t i = from; i < to; ++i)
    result.insert(result.end(), lists[i].begin(), lists[i].end());
  return result;
}

void add_range(Json& json, const Range& range) {
  json["min"] = range.least;
  json["max"] = range.greatest;
  json["unreached"] = range.infinite;
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
                   {"min", range.least},
                   {"max", range.greatest},
                   {"unreached_vertices", range.infinite}};
  if (!o.isolines.empty()) {
    computed.levels = levels_in(range, o.levels);
    computed.json["levels"] = computed.levels;
  }
  computed.functions.push_back({"distance", std::move(distances)});
  computed.isolines = 25;
  return computed;
}

// By heat from curves along edges, and points.
template <class Triangulation>
Computed distances_from_curves(Triangulation& t, const Sources& sources,
                               const Application_options& o) {
  std::vector<std::vector<typename Triangulation::halfedge_descriptor>> curves;
  for (std::size_t i = 0; i < o.curves.size(); ++i) // their vertices are there
    curves.push_back(naming_file("--curve " + o.curves[i], [&] {
      return IT::Edge_path_finder(t).through(IT::insert_places(t, sources[o.sources.size() + i]));
    }));
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
  const auto points = IT::Place_finder(t).points(joined(sources, 0, o.sources.size()));
  IT::Heat_distance heat(t, factor);
  return with_time(points.empty() ? heat.distances(curves)
                                  : heat.distances(points).cwiseMin(heat.distances(curves)),
                   heat.time());
}

// Divides the surface among the sources, or sets of them.
template <class Triangulation>
void add_cells(const Triangulation& t, IT::Found_cells found, Computed& computed) {
  Function nearest{"nearest_source", Eigen::VectorXd(computed.functions.front().values.size())};
  std::ranges::copy(found.nearest, nearest.values.begin());
  nearest.has_classes = true;
  computed.functions.push_back(std::move(nearest));
  computed.shown = computed.functions.size() - 1;
  computed.json["cells"] = {{"vertices", found.vertices},
                            {"areas", found.cells.areas},
                            {"boundaries", found.cells.boundaries.size()},
                            {"junctions", found.cells.junctions.size()},
                            {"status", IT::name_of(found.cells.status)}};
  computed.cell_boundaries = [&t, cells = std::move(found.cells)](const Points& points) {
    return IT::polylines(t, cells, points);
  };
}

// From points in lists, and from sets of them to targets; divides the surface among the sets.
template <class Triangulation>
Computed distances_of(const Triangulation& t, const Sources& sets, const Places& targets,
                      const Application_options& o, Progress& progress) {
  const IT::Distance_options asked = asked_of(o, progress);
  IT::Distances<Triangulation> find(t);
  IT::Found_cells found;
  if (o.voronoi.empty())
    static_cast<IT::Found_distances&>(found) =
        find.from(joined(sets, 0, sets.size()), asked, targets);
  else
    found = IT::divide_among(find, sets, o.cell_tolerance, asked);
  Computed computed = computed_distances(
      t, Eigen::VectorXd::Map(found.by_row.data(), static_cast<Eigen::Index>(found.by_row.size())),
      o);
  if (asked.method == IT::Distance_method::heat) {
    computed.json["time"] = found.time;
    return computed;
  }
  computed.json["status"] = IT::name_of(found.status);
  if (!o.source_sets.empty())
    computed.json["sets"] = sets.size();
  else {
    computed.json["reached"] = found.reached;
    computed.json["targets"] = found.at_targets;
  }
  if (!o.voronoi.empty()) add_cells(t, std::move(found), computed);
  return computed;
}

// Writes the distances of the vertices of the file, a row for each set of sources.
template <class Triangulation>
Computed distance_matrix(const Triangulation& t, const Sources& sets, const Options& options,
                         Progress& progress) {
  Computed computed{"distance", {}, {}};
  computed.json = {{"method", options.application.distance}, {"sets", sets.size()}};
  computed.write = [&t, &options, &progress, sets](std::ostream& out, Json& json) {
    const IT::Distance_options asked = asked_of(options.application, progress);
    const std::size_t rows = t.input().number_of_rows();
    IT::Distances<Triangulation> find(t);
    Row_writer file(out, options.output, sets.size(), rows);
    Range range;
    const IT::Status status = find.for_each_column(
        sets,
        [&](std::size_t, std::span<const double> column) {
          for (const double d : column.first(rows)) range.add(d);
          file.write(column.first(rows));
        },
        asked);
    file.finish();
    if (asked.method == IT::Distance_method::heat) json["time"] = find.heat_time(asked);
    json["status"] = IT::name_of(status);
    add_range(json, range);
  };
  return computed;
}

template <class Triangulation>
Computed distances_of_pairs(const Triangulation& t, const Application_options& o,
                            Progress& progress) {
  const IT::Distance_options asked = asked_of(o, progress);
  Places from, to;
  for (const Places& pair : read_places(t, o.pairs, true)) {
    from.push_back(pair[0]);
    to.push_back(pair[1]);
  }
  IT::Distances<Triangulation> find(t);
  const std::vector<double> distances = find.of_pairs(from, to, asked);
  Computed computed{"distance", {}, {}};
  computed.json = {{"method", o.distance}, {"pairs", from.size()}};
  if (asked.method == IT::Distance_method::heat) computed.json["time"] = find.heat_time(asked);
  add_range(computed.json, range_of(distances));
  computed.json["distances"] = distances;
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
    if (!o.pairs.empty()) return distances_of_pairs(t, o, progress);
    if (!o.curves.empty()) return distances_from_curves(t, sources, o);
    if (o.source_sets.empty()) {
      Sources sets; // each point has a cell of its own
      for (const IT::Place& p : joined(sources, 0, o.sources.size())) sets.push_back({p});
      return distances_of(t, sets, joined(sources, o.sources.size(), sources.size()), o, progress);
    }
    const Sources sets = read_places(t, o.source_sets, false);
    return o.voronoi.empty() ? distance_matrix(t, sets, options, progress)
                             : distances_of(t, sets, {}, o, progress);
  });
}

} // namespace program
