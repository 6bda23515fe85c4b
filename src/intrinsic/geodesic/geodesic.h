// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_GEODESIC_GEODESIC_H
#define INTRINSIC_GEODESIC_GEODESIC_H

#include "../asked_curves.h"
#include "../constraints.h"
#include "../delaunay.h"
#include "../load.h"
#include "../options.h"
#include "../statistics.h"
#include "../support/file_formats.h"
#include "../support/naming_file.h"
#include "../support/progress.h"

#include <CGAL/Intrinsic_geodesics/compiled.h>
#include <CGAL/Intrinsic_geodesics/finding/find_curves.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace program {

/// Shows what is done to find curves, and measures the time.
class Curve_progress {
public:
  /// begins. \param json gets the seconds
  Curve_progress(Json& json, Progress& progress) : json_(json), progress_(progress) {}
  /// is called with what is done next.
  bool operator()(IT::Curve_stage stage, std::uint64_t count);
  /// notes the time of the last stage.
  void end();

private:
  Json& json_;
  Progress& progress_;
  IT::Stopwatch watch_;
  const char* timed_ = "paths";
};

/// returns what is reported of curves.
Json curves_json(const IT::Found_curves& found);

/*!
\brief finds the curves that options ask for, and reports them.
\param is_drawn whether their ways are wanted
\throws std::runtime_error naming what cannot be found, and the remedy
*/
template <class Triangulation>
IT::Curves_along_edges<Triangulation> find_curves(Loaded<Triangulation>& loaded,
                                                  const Options& options, bool is_drawn, Json& json,
                                                  Progress& progress) {
  const Geodesic_options& g = options.geodesic;
  const bool is_viewed = is_drawn && !options.view.empty();
  Curve_progress shown(json, progress);
  IT::Find_curves_options how;
  how.is_along_edges = g.method == "flips";
  how.are_edges = options.refines || g.writes_subdivision ||
                  (!options.output.empty() && !is_file_of(Contents::curves, options.output));
  how.is_traced = is_viewed || (is_drawn && !options.output.empty());
  how.keeps_initial = is_viewed && g.source.empty();
  how.relative_length = g.relative_length;
  how.minimum_joint_angle = g.joint_angle;
  how.progress = std::ref(shown);
  IT::Edge_marker<Triangulation> mark;
  if (has_constraints(options))
    mark = [&](const Triangulation& t) { return marked_edges(t, loaded.constraints); };
  const std::vector<Asked_curve> asked =
      asked_curves(options, loaded.triangulation.input().number_of_rows(), loaded.facts.polygons);
  IT::Curves_along_edges<Triangulation> found = naming_file(
      options.input, [&] { return IT::find_curves(loaded.triangulation, asked, how, mark); });
  if (found.curves.empty())
    throw std::runtime_error(options.input +
                             ": no edge is marked, so there is no curve; mark edges, or choose a "
                             "smaller --sharp-angle");
  json["geodesic"] = curves_json(found);
  shown.end();
  return found;
}

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
                                 Progress& progress, IT::Stopwatch& watch) {
  progress.show("subdividing");
  const Drawn_subdivision drawn = drawn_subdivision(loaded, options, json);
  json["seconds"]["subdivide"] = watch.lap();
  progress.show("writing");
  const Triangulation& t = loaded.triangulation;
  if (options.geodesic.writes_subdivision)
    files.write(options.output, [&](std::ostream& out, const std::string& extension) {
      const IT::Subdivision_field field = curve_field(t, drawn.s, found.labels);
      write_mesh(out, extension, drawn.s, drawn.points, std::span(&field, 1), options);
    });
  if (!options.view.empty())
    files.write(options.view, [&](std::ostream& out) {
      const std::vector<Point> points = input_points(loaded);
      const auto curves = polylines(t, found, points);
      const auto initial = polylines(t, found, points, &IT::Found_curve::initial);
      IT::Html_view view;
      view.curves = curves;
      view.initial_curves = initial;
      view.has_edges = view.has_face_colors = false; // curves are not looked for among colours
      write_view(out, drawn.s, drawn.points, options, json, view);
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
  IT::Stopwatch watch;
  Output_files files;
  if (options.geodesic.writes_subdivision || !options.view.empty())
    write_curves_on_subdivision(loaded, found, options, json, files, progress, watch);
  if (!options.output.empty() && !options.geodesic.writes_subdivision) {
    progress.show("writing");
    files.write(options.output, [&](std::ostream& out, const std::string& extension) {
      if (is_file_of(Contents::curves, options.output)) {
        expect_points(loaded, options);
        IT::write_polylines(out, extension, polylines(t, found, input_points(loaded)));
      } else {
        IT::write_intrinsic_triangulation(out, t);
      }
    });
  }
  finish(json, options, files, watch);
}

} // namespace program

#endif // INTRINSIC_GEODESIC_GEODESIC_H
