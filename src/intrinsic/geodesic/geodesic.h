// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_GEODESIC_GEODESIC_H
#define INTRINSIC_GEODESIC_GEODESIC_H

#include "../delaunay.h"
#include "../support/file_formats.h"
#include "curves.h"

#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <ostream>
#include <string>
#include <vector>

namespace program {

/// prints what became of curves to standard error if that is a terminal.
void print_geodesic_summary_on_terminal(const Json& json);
/// reports curves that are not known to be geodesic.
void warn_of_cap(const Json& json, const Options& options);

/// returns for each vertex of a common subdivision the number of a curve that passes it, or -1.
template <class Triangulation>
IT::Subdivision_field curve_field(const Triangulation& t, const IT::Common_subdivision& s,
                                  const Edge_labels<Triangulation>& labels) {
  std::vector<double> curve(s.number_of_vertices(), -1);
  std::vector<std::uint32_t> label(t.numbers().edge_capacity(t.mesh()), 0);
  for (const typename Triangulation::edge_descriptor e : edges(t.mesh()))
    label[t.index(e)] = get(labels, e);
  IT::for_each_subdivision_edge(
      s, [&](std::uint32_t a, std::uint32_t b, const IT::Common_subdivision::Side& side) {
        if (side.intrinsic_edge == IT::Common_subdivision::none || label[side.intrinsic_edge] == 0)
          return;
        for (const std::uint32_t v : {a, b}) curve[v] = label[side.intrinsic_edge] - 1;
      });
  return {"curve", std::move(curve)};
}

/// writes the common subdivision with curves, and the page that shows them.
template <class Triangulation>
void write_curves_on_subdivision(const Loaded<Triangulation>& loaded,
                                 const IT::Curves_along_edges<Triangulation>& found,
                                 const Options& options, Json& json, Output_files& files,
                                 Progress& progress, Stopwatch& watch) {
  progress.show("subdividing");
  const Drawn_subdivision drawn = drawn_subdivision(loaded, options, json);
  json["seconds"]["subdivide"] = watch.lap();
  progress.show("writing");
  const Triangulation& t = loaded.triangulation;
  if (options.geodesic.writes_subdivision)
    files.write(options.output, [&](std::ostream& out) {
      const IT::Subdivision_field field = curve_field(t, drawn.s, found.labels);
      IT::write_common_subdivision(out, std::filesystem::path(options.output).extension().string(),
                                   drawn.s, drawn.points, std::span(&field, 1));
    });
  if (!options.view.empty())
    files.write(options.view, [&](std::ostream& out) {
      const std::vector<Point> points = input_points(loaded);
      const auto curves = polylines(t, found, points);
      const auto initial = polylines(t, found, points, &IT::Found_curve::initial);
      Viewed viewed{curves, initial};
      viewed.is_plain = true; // curves are not to be looked for among colours
      write_view(out, drawn.s, drawn.points, options, json, viewed);
    });
}

/// makes curves geodesic, refines and writes files, as options say.
template <class Triangulation>
void geodesic(Loaded<Triangulation>& loaded, const Options& options, Progress& progress) {
  Triangulation& t = loaded.triangulation;
  IT::Curves_along_edges<Triangulation> found{{}, Edge_labels<Triangulation>(t)};
  const auto shorten = [&](Json& json) {
    found = find_curves(loaded, options, true, json, progress);
    return found.labels;
  };
  Json json;
  if (options.refines) {
    json = improve_and_measure(loaded, options, progress, {}, shorten);
  } else {
    json = loaded_json(loaded, options);
    shorten(json);
  }
  warn_of_cap(json, options);
  Stopwatch watch;
  Output_files files;
  if (options.geodesic.writes_subdivision || !options.view.empty())
    write_curves_on_subdivision(loaded, found, options, json, files, progress, watch);
  if (!options.output.empty() && !options.geodesic.writes_subdivision) {
    progress.show("writing");
    files.write(options.output, [&](std::ostream& out) {
      if (is_file_of(Contents::curves, options.output)) {
        expect_points(loaded, options);
        IT::write_polylines(out, std::filesystem::path(options.output).extension().string(),
                            polylines(t, found, input_points(loaded)));
      } else {
        IT::write_intrinsic_triangulation(out, t);
      }
    });
  }
  finish(json, options, files, watch);
  print_geodesic_summary_on_terminal(json);
}

} // namespace program

#endif // INTRINSIC_GEODESIC_GEODESIC_H
