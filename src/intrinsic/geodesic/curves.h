// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_GEODESIC_CURVES_H
#define INTRINSIC_GEODESIC_CURVES_H

#include "../asked_curves.h"
#include "../constraints.h"
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

#include <cstddef>
#include <cstdint>
#include <iterator>
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
  Stopwatch watch_;
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
  how.is_along_edges = g.is_along_edges;
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

} // namespace program

#endif // INTRINSIC_GEODESIC_CURVES_H
