// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "asked_curves.h"
#include "levels.h"
#include "option_groups.h"
#include "support/file_formats.h"

#include <cstddef>
#include <string>
#include <vector>

namespace program {

namespace {

CLI::Validator curve_points(std::size_t least) {
  return CLI::Validator([least](std::string& text) { return curve_points_misuse(text, least); },
                        "POINTS");
}

CLI::Validator level_list() {
  return CLI::Validator([](std::string& text) { return levels_misuse(text); }, "N|LIST");
}

// Curves that may be given together.
void add_joined_curve_options(CLI::App& command, Options& options) {
  Geodesic_options& g = options.geodesic;
  const auto list = [&](const char* name, std::vector<std::string>& all, std::size_t least,
                        const char* what) {
    command.add_option(name, all, what)->allow_extra_args(false)->check(curve_points(least));
  };
  list("--path", g.paths, 2,
       "path through points, separated by commas: numbers of vertices, or face:b0:b1:b2; may be "
       "repeated");
  list("--loop", g.loops, 3, "closed curve through points; may be repeated");
  command
      .add_option(
          "--network", g.network,
          "text file of curves: on each line the vertices of a path, or after the word loop "
          "of a closed curve")
      ->type_name("FILE");
  command
      .add_option("--marked", options.constraints,
                  "text file of edges that become curves: the numbers of two vertices on each line")
      ->type_name("FILE");
  command
      .add_option(
          "--sharp-angle", options.sharp_angle,
          "edges whose faces deviate by more than so many degrees from a plane become curves")
      ->check(between(0, 180));
  command.add_flag("--waypoints", g.has_waypoints, "curves stay at all points that are given");
}

// Adaptive refinement is about the first of them.
void add_source_option(CLI::App& command, Options& options) {
  command
      .add_option("--source", options.application.sources,
                  "points, separated by commas: vertices as numbered in the file, from 0, or "
                  "face:b0:b1:b2")
      ->required()
      ->check(curve_points(1));
}

// Where distances start, and where the search for them ends.
void add_distance_searches(CLI::App& command, Application_options& a) {
  command
      .add_option("--method", a.distance,
                  "heat (smooth, default), or exact (along shortest paths from points)")
      ->check(CLI::IsMember({"heat", "exact"}));
  command
      .add_option("--targets", a.targets,
                  "with --method exact: points; the search ends when their distances are known")
      ->check(curve_points(1));
  command
      .add_option("--max-distance", a.maximum_distance,
                  "with --method exact: the search ends at this distance")
      ->check(positive());
  command
      .add_option("--curve", a.curves,
                  "a curve through points, along edges of the triangulation; closed if the last "
                  "point is the first")
      ->check(curve_points(2));
  command.add_flag("--signed", a.is_signed, "distances on the left of curves are negative");
  command
      .add_option("--pairs", a.pairs,
                  "text file: the numbers of two vertices on each line; their distances are found")
      ->type_name("FILE");
  command
      .add_option("--sources", a.source_sets,
                  "text file: on each line the vertices of a set; the distances from each set are "
                  "found, a column of a matrix each")
      ->type_name("FILE");
}

// Lines of equal distance, and lines between cells.
void add_distance_lines(CLI::App& command, Application_options& a) {
  CLI::Option* const isolines =
      command
          .add_option("--isolines", a.isolines,
                      "write the lines of equal distance, with the number of their level, to " +
                          extensions_of(Contents::curves))
          ->check(file_of({Contents::curves}));
  command
      .add_option("--levels", a.levels,
                  "distances of these lines: how many, evenly spaced (default 10), or a list, "
                  "separated by commas; a whole number alone is how many")
      ->check(level_list())
      ->needs(isolines);
  CLI::Option* const voronoi =
      command
          .add_option("--voronoi", a.voronoi,
                      "with --method exact: write the lines between the cells of the nearest "
                      "source, or set of --sources, to " +
                          extensions_of(Contents::curves))
          ->check(file_of({Contents::curves}));
  command
      .add_option("--cell-tolerance", a.cell_tolerance,
                  "how far off these lines may be, in units of the file; default a thousandth of "
                  "the mean edge")
      ->check(positive())
      ->needs(voronoi);
}

} // namespace

void add_curve_options(CLI::App& command, Options& options) {
  Geodesic_options& g = options.geodesic;
  add_joined_curve_options(command, options);
  command.add_option("--bezier", g.bezier, "Bezier curve with these control points; alone")
      ->check(curve_points(2));
  command
      .add_option("--source", g.source,
                  "geodesics from a point to all vertices, in one triangulation; alone")
      ->check(curve_points(1));
  command.add_flag("--along-edges", g.is_along_edges,
                   "curves start as shortest paths along edges: faster, geodesic, but often "
                   "longer");
  command
      .add_option("--shorten-to", g.relative_length,
                  "stop when the length is at most this part of what it was")
      ->check(between(1e-9, 1));
  command
      .add_option("--joint-angle", g.joint_angle,
                  "stop when all joints have at least this angle, in degrees")
      ->check(between(0, 180));
}

void add_cut_options(CLI::App& command, Options& options) {
  add_joined_curve_options(command, options);
  CLI::Option* const levels =
      command
          .add_option(
              "--levels", options.cut.levels,
              "cut along isolines: how many, evenly spaced, or a list of values with commas")
          ->check(level_list());
  command
      .add_option("--source", options.application.sources,
                  "isolines of the exact distance from points, separated by commas")
      ->needs(levels)
      ->check(curve_points(1));
  command
      .add_option("--values", options.field,
                  "isolines of a function: a text file with a number for each vertex of the mesh")
      ->needs(levels)
      ->type_name("FILE");
  command.add_flag("--to-disk", options.cut.makes_disks,
                   "make a disk of each component by a short cut along geodesics");
  add_output_option(command, "-o", options.output, {Contents::cut_surface});
  command
      .add_option("--labels", options.cut.labels,
                  "write on each line the component of a face, and the face of the mesh that it is "
                  "in, to .txt")
      ->check(file_of({Contents::values}));
  add_view_option(command, options, "the pieces");
}

void add_curve_output_options(CLI::App& command, Options& options) {
  command
      .add_option("-o", options.output,
                  "write " + listed_with_extensions({Contents::curves, Contents::triangulation}))
      ->check(file_of({Contents::curves, Contents::subdivision, Contents::triangulation}));
  command.add_flag(
      "--subdivision", options.geodesic.writes_subdivision,
      "-o writes the common subdivision, with the number of the curve at its vertices, "
      "to " +
          extensions_of(Contents::subdivision));
  add_view_option(command, options, "the curves");
}

void add_application_options(CLI::App& command, Options& options, bool has_sources,
                             const std::vector<Contents>& outputs) {
  add_common_options(command, options);
  add_output_option(command, "-o", options.output, outputs);
  command
      .add_option("--on", options.application.on,
                  "where results are: subdivision (on the common subdivision, default), input, or "
                  "intrinsic (values only)")
      ->check(CLI::IsMember({"subdivision", "input", "intrinsic"}));
  add_view_option(command, options, "the result");
  CLI::Option* const refine = command.add_flag(
      "--refine", options.refines, "refine the triangulation, as the command refine does");
  add_constraint_options(command, options);
  add_metric_option(command, options);
  add_refinement_options(command, options);
  add_adaptive_options(command, options, !has_sources);
  if (has_sources) add_source_option(command, options);
  make_refinement_options_need(*refine, command);
}

void add_start_option(CLI::App& command, Options& options) {
  command
      .add_option("--start", options.uniformize.start,
                  "triangles whose lengths are scaled: delaunay (those of the intrinsic Delaunay "
                  "triangulation) or input (those of the mesh); by default delaunay")
      ->check(CLI::IsMember({"delaunay", "input"}));
}

void add_uniformize_options(CLI::App& command, Options& options) {
  Uniformize_options& u = options.uniformize;
  add_common_options(command, options);
  add_output_option(command, "-o", options.output, {Contents::values, Contents::subdivision});
  add_view_option(command, options, "a checkerboard of the layout, or the logarithm of the scale");
  add_metric_option(command, options);
  CLI::Option* const angles = command.add_option(
      "--angles", u.angles,
      "text file: the angle around each vertex on a line of its own, in radians, as a multiple of "
      "pi (3/2pi), or free; by default 2pi, and free on the border");
  angles->type_name("FILE");
  command
      .add_option("--cones", u.cones,
                  "how many vertices have other angles, which are chosen; or, such as 10x, the "
                  "largest ratio of scales, for as many as are needed; or a text file: the number "
                  "of such a vertex and its angle on each line")
      ->excludes(angles)
      ->type_name("NUMBER|RATIO|FILE");
  add_start_option(command, options);
  command
      .add_option("--target", u.target,
                  "plane (flat but for cones), sphere (the round one), torus (flat, with its "
                  "period) or disk (hyperbolic, in Poincaré's disk); by default, without --angles "
                  "and --cones, sphere, torus and disk for closed surfaces of genus 0, 1 and more, "
                  "else plane")
      ->check(CLI::IsMember({"plane", "sphere", "torus", "disk"}));
}

void add_distance_options(CLI::App& command, Options& options) {
  command.get_option("--source")->required(false);
  add_distance_searches(command, options.application);
  add_distance_lines(command, options.application);
}

void add_time_option(CLI::App& command, Options& options) {
  command
      .add_option(
          "--time", options.application.time_factor,
          "how long heat flows, in squares of the mean edge length; with --signed, in squares of "
          "half of it (default 1)")
      ->check(CLI::PositiveNumber);
}

} // namespace program
