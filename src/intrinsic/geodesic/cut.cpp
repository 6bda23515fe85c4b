// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "../support/text_lines.h"
#include "Range.h"
#include "geodesic.h"

#include <CGAL/Intrinsic_geodesics/compiled.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_along.h>
#include <CGAL/Intrinsic_geodesics/cuts/flip_to_geodesic_cut.h>
#include <CGAL/Intrinsic_geodesics/cuts/write_cut_surface.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/isolines/isolines.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace program {

namespace {

// A number per row: of the file of `--values`, or the distance from the points of `--source`.
template <class Triangulation>
std::vector<double> values_of_rows(Triangulation& t, const Loaded<Triangulation>& loaded,
                                   const Options& options) {
  const std::size_t rows = t.input().number_of_rows();
  if (!options.field.empty()) {
    const std::string what = "vertices of " + options.input;
    const Number_table table = read_numbers(options.field, rows, what, Infinity::taken);
    if (table.columns != 1) table.refuse(0, "give one number on each line");
    table.expect_rows(rows, what);
    return table.values;
  }
  std::vector<IT::Surface_point> sources;
  IT::Place_finder<Triangulation> find(t);
  for (const Asked_curve& list : asked_points(options, rows, loaded.facts.polygons))
    naming_file(list.name + ": " + options.input, [&] {
      for (const IT::Place& p : list.places) find.append(p, sources);
    });
  return IT::Polyhedral_distance<Triangulation>(t, sources).distances();
}

template <class Triangulation>
auto isoline_labels(Loaded<Triangulation>& loaded, const Options& options, Json& json) {
  Triangulation& t = loaded.triangulation;
  const std::vector<double> values = values_of_rows(t, loaded, options);
  const Range range = range_of(values);
  const std::vector<double> levels = levels_in(range, options.cut.levels);
  const std::vector<IT::Isoline> lines = IT::isolines(t, values, levels);
  json["isolines"] = {
      {"levels", levels}, {"lines", lines.size()}, {"min", range.least}, {"max", range.greatest}};
  if (lines.empty())
    throw std::runtime_error(options.input + ": no isoline has one of the levels, as values are " +
                             "from " + std::to_string(range.least) + " to " +
                             std::to_string(range.greatest) + "; choose levels between");
  return naming_file(options.input, [&] { return IT::insert_isolines(t, lines); });
}

// Cuts as options say.
template <class Triangulation>
IT::Cut_surface cut_surface(Loaded<Triangulation>& loaded, const Options& options, Json& json,
                            Progress& progress, IT::Stopwatch& watch) {
  Triangulation& t = loaded.triangulation;
  const auto cut_along = [&](const auto& curves) {
    json["seconds"]["curves"] = watch.lap();
    progress.show("cutting");
    return naming_file(options.input, [&] { return IT::cut_along(t, curves); });
  };
  if (!options.cut.levels.empty()) return cut_along(isoline_labels(loaded, options, json));
  if (!options.cut.makes_disks) {
    const auto found = find_curves(loaded, options, false, json, progress);
    return cut_along(found);
  }
  progress.show("finding a cut");
  const auto cut = naming_file(options.input, [&] { return IT::flip_to_geodesic_cut(t); });
  json["shortening"] = {{"flips", cut.shortening.flips}};
  return cut_along(cut.edges);
}

Json components_json(const IT::Cut_surface& s, const std::vector<Point>& points) {
  std::vector<std::size_t> faces(s.number_of_components, 0);
  std::vector<double> areas(s.number_of_components, 0);
  for (std::size_t f = 0; f < s.component.size(); ++f) {
    const auto v = s.face(f);
    ++faces[s.component[f]];
    areas[s.component[f]] += IT::area_in_space(points[v[0]], points[v[1]], points[v[2]]);
  }
  Json result = Json::array();
  for (std::size_t c = 0; c < faces.size(); ++c)
    result.push_back({{"faces", faces[c]}, {"area", areas[c]}});
  return result;
}

Json cut_json(const IT::Cut_surface& s, const std::vector<Point>& points) {
  const IT::Gluing_map map = IT::Gluing_map::from_valid(s.gluing);
  std::map<std::uint32_t, std::size_t> pieces;
  for (const std::uint32_t triangle : s.input_triangle) ++pieces[triangle];
  return {
      {"vertices", s.vertices.size()},
      {"faces", s.input_face.size()},
      {"divided_faces", std::ranges::count_if(pieces, [](const auto& p) { return p.second > 1; })},
      {"edges", s.seams.size()},
      {"border_loops", IT::boundary_loops(map).size()},
      {"euler_characteristic", IT::euler_characteristic(map)},
      {"components", components_json(s, points)}};
}

void write_labels(std::ostream& out, const IT::Cut_surface& s) {
  out << "# for each face: its component, and the face of the input that it is in\n";
  for (std::size_t f = 0; f < s.component.size(); ++f)
    out << s.component[f] << ' ' << s.input_face[f] << '\n';
}

template <class Triangulation>
void cut(Loaded<Triangulation>& loaded, const Options& options, Progress& progress) {
  const Triangulation& t = loaded.triangulation;
  naming_file(options.input, [&] { IT::expect_one_sheet(t.input()); });
  expect_points(loaded, options);
  Json json = loaded_json(loaded, options);
  IT::Stopwatch watch;
  const IT::Cut_surface s = cut_surface(loaded, options, json, progress, watch);
  const std::vector<Point> points = IT::positions(s, input_points(loaded), t.input());
  json["cut"] = cut_json(s, points);
  json["seconds"]["cut"] = watch.lap();
  progress.show("writing");
  Output_files files;
  if (!options.output.empty())
    files.write(options.output, [&](std::ostream& out, const std::string& extension) {
      IT::write_cut_surface(out, extension, s, points);
    });
  if (!options.cut.labels.empty())
    files.write(options.cut.labels, [&](std::ostream& out) { write_labels(out, s); });
  if (!options.view.empty())
    files.write(options.view, [&](std::ostream& out) {
      write_view(out, IT::drawn_as_subdivision(s), points, options, json, {});
    });
  finish(json, options, files, watch);
}

} // namespace

void run_cut(const Options& options) {
  Progress progress(options.logs_progress, options.is_quiet);
  with_loaded<IT::Integer_coordinates>(options, progress,
                                       [&](auto& loaded) { cut(loaded, options, progress); });
}

} // namespace program
