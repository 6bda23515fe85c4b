// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_DELAUNAY_H
#define INTRINSIC_DELAUNAY_H

#include "accuracy.h"
#include "load.h"
#include "options.h"
#include "output_files.h"
#include "refine.h"
#include "statistics.h"
#include "support/progress.h"
#include "view.h"

#include <CGAL/Intrinsic_triangulations/IO/idt/write_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulations/operators/matrix_market.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace program {

/// returns one point per vertex of the input, in its order and units.
template <class Triangulation>
std::vector<Point> input_points(const Loaded<Triangulation>& loaded) {
  const Triangulation& t = loaded.triangulation;
  const std::vector<Point>& scaled = loaded.scaled_points();
  std::vector<Point> points(scaled.size());
  for (std::uint32_t v = 0; v < scaled.size(); ++v) {
    Point& p = points[t.input_vertex({v})];
    p = scaled[v];
    for (double& x : p) x = std::ldexp(x, -t.metric().scale_exponent());
  }
  return points;
}

/// extracts the common subdivision, labelled with the faces of the file. \throws std::runtime_error
template <class Triangulation>
IT::Common_subdivision subdivide(const Loaded<Triangulation>& loaded, const Options& options) {
  try {
    IT::Common_subdivision s = IT::common_subdivision(loaded.triangulation);
    IT::label_with_polygons(s, loaded.polygon_of_triangle);
    return s;
  } catch (const std::exception& e) {
    throw std::runtime_error(options.input + ": " + e.what());
  }
}

/// returns the area of a common subdivision.
inline double area(const IT::Common_subdivision& s, const std::vector<Point>& points) {
  long double sum = 0;
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    const auto corners = s.face(f);
    for (std::size_t k = 2; k < corners.size(); ++k)
      sum += area(points[corners[0]], points[corners[k - 1]], points[corners[k]]);
  }
  return static_cast<double>(sum);
}

/// writes the common subdivision, and the page that shows it.
template <class Triangulation>
void write_subdivision(const Loaded<Triangulation>& loaded, const Options& options, Json& json,
                       Output_files& files, Progress& progress, Stopwatch& watch) {
  progress.show("subdividing");
  const IT::Common_subdivision s = subdivide(loaded, options);
  json["subdivision"] = {{"vertices", s.number_of_vertices()},
                         {"edges", s.number_of_edges()},
                         {"faces", s.number_of_faces()}};
  const std::vector<Point> points = IT::positions(s, input_points(loaded));
  json["subdivision"]["area"] = area(s, points);
  if constexpr (!Triangulation::Metric::is_exact)
    expect_covered(json["area"]["input"], json["subdivision"]["area"], options);
  json["seconds"]["subdivide"] = watch.lap();
  progress.show("writing");
  if (is_mesh_output(options))
    files.write(options.output, [&](std::ostream& out) {
      const std::string extension = std::filesystem::path(options.output).extension().string();
      IT::write_common_subdivision(out, extension, s, points);
    });
  if (!options.view.empty())
    files.write(options.view,
                [&](std::ostream& out) { write_view(out, s, points, options, json); });
}

/// flips to Delaunay, refines if that is asked for, and writes what is asked for
template <class Triangulation>
void delaunay(Loaded<Triangulation>& loaded, const Options& options, Progress& progress) {
  Json json = flip_and_measure(loaded, true, options, progress, [&](Json& j) {
    if (options.refines) refine(loaded.triangulation, options, j, progress);
  });
  if (const Json& count = json["delaunay"]["non_delaunay_edges"]; count != 0)
    std::cerr << options.input << ": " << count
              << " edges are not Delaunay as far as double arithmetic can tell; --arithmetic exact "
                 "decides them\n";
  Stopwatch watch;
  Output_files files;
  if constexpr (!std::is_same_v<typename Triangulation::Correspondence, IT::No_correspondence>)
    if (is_mesh_output(options) || !options.view.empty())
      write_subdivision(loaded, options, json, files, progress, watch);
  if (!options.output.empty() && !is_mesh_output(options)) {
    progress.show("writing");
    files.write(options.output, [&](std::ostream& out) {
      IT::write_intrinsic_triangulation(out, loaded.triangulation);
    });
  }
  if (!options.laplacian.empty())
    files.write(options.laplacian, [&](std::ostream& out) {
      IT::write_matrix_market(out, IT::cotangent_laplacian(loaded.triangulation),
                              "cotangent Laplacian, positive semidefinite; rows of the input's "
                              "vertices in their order, then of those inserted");
    });
  finish(json, options, files, watch);
  print_summary_on_terminal(json);
}

/// runs the command with a correspondence
template <class Correspondence>
void run_delaunay_with(const Options& options) {
  Progress progress(options.logs_progress);
  with_loaded<Correspondence>(options, progress,
                              [&](auto& loaded) { delaunay(loaded, options, progress); });
}

} // namespace program

#endif // INTRINSIC_DELAUNAY_H
