// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "option_groups.h"
#include "geodesic/asked_curves.h"
#include "levels.h"
#include "support/file_formats.h"
#include "support/surface_words.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

CLI::Validator curve_points(std::size_t least) {
  return CLI::Validator([least](std::string& text) { return curve_points_misuse(text, least); },
                        "POINTS");
}

CLI::Validator level_list() {
  return CLI::Validator([](std::string& text) { return levels_misuse(text); }, "N|LIST");
}

// what means nothing without refinement
constexpr std::array refinement_options{"min-angle",       "max-circumradius",
                                        "max-edge-length", "size",
                                        "max-insertions",  "order",
                                        "conforming",      "odt",
                                        "adaptive"};

// However they are spelled, and through links of either kind.
bool are_same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  const auto path = [](const std::string& name) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(name));
  };
  return path(a) == path(b) || (std::filesystem::is_regular_file(a, ignored) &&
                                std::filesystem::equivalent(a, b, ignored));
}

std::vector<std::string> outputs(const Options& o) {
  std::vector<std::string> names{o.output,
                                 o.application.singularities,
                                 o.application.isolines,
                                 o.application.voronoi,
                                 o.mass,
                                 o.laplacian,
                                 o.interpolation,
                                 o.input_interpolation,
                                 o.stats,
                                 o.records,
                                 o.view,
                                 o.cut.labels};
  std::erase_if(names, [](const std::string& name) { return name.empty() || name == "-"; });
  return names;
}

bool names_a_file_twice(const Options& o) {
  const std::vector<std::string> names = outputs(o);
  for (auto i = names.begin(); i != names.end(); ++i)
    if (std::any_of(i + 1, names.end(), [&](const auto& n) { return are_same_file(*i, n); }))
      return true;
  return false;
}

// An output that is a file to be read, which may be a pipe or a terminal; empty if there is none.
std::string overwritten_input(const Options& o) {
  const Application_options& a = o.application;
  for (const std::string& in : {o.input, o.constraints, o.metric, o.sizes, o.field,
                                o.geodesic.network, a.vectors, a.handles, a.pairs, a.source_sets})
    for (const std::string& out : outputs(o))
      if (std::error_code ignored;
          !in.empty() && std::filesystem::is_regular_file(in, ignored) && are_same_file(in, out))
        return out;
  return {};
}

bool lacks_correspondence(const Options& o) {
  return o.correspondence == "none" && needs_correspondence(o);
}

bool has_other_correspondence(const Options& o) {
  return o.adaptive.is_asked_for && !o.correspondence.empty() && o.correspondence != "integer";
}

void add_view_option(CLI::App& command, Options& options, const std::string& what) {
  CLI::Option* const view =
      command.add_option("--view", options.view, "write a page that shows " + what)
          ->type_name("FILE");
  command
      .add_option("--view-limit", options.view_limit,
                  "most megabytes of the page, which shows less if it needs more; default 30")
      ->check(between(2, 2000))
      ->type_name("MB")
      ->needs(view);
}

// What is wrong with the file of curves.
std::string curve_output_misuse(const Options& o) {
  const bool is_subdivision = o.geodesic.writes_subdivision;
  if (is_subdivision && !is_mesh_output(o))
    return "--subdivision needs -o with " + extensions_of(Contents::subdivision);
  if (!is_subdivision && is_mesh_output(o) && !is_file_of(Contents::curves, o.output))
    return o.output + ": write curves to " + extensions_of(Contents::curves) +
           ", or the common subdivision with --subdivision";
  return {};
}

} // namespace

CLI::Validator file_of(std::vector<Contents> offered) {
  return CLI::Validator(
      [offered = std::move(offered)](std::string& path) {
        for (const Contents contents : offered)
          if (is_file_of(contents, path)) return std::string();
        return path + ": the format is not offered; write " + listed_with_extensions(offered);
      },
      "FILE");
}

CLI::Option* add_output_option(CLI::App& command, const std::string& name, std::string& path,
                               const std::vector<Contents>& offered) {
  return command.add_option(name, path, "write " + listed_with_extensions(offered))
      ->check(file_of(offered));
}

void add_common_options(CLI::App& command, Options& options) {
  command
      .add_option("IN", options.input,
                  "mesh (" + extensions_of(Contents::mesh) + "), points (" +
                      extensions_of(Contents::point_set) +
                      ", or a mesh without faces) or intrinsic triangulation (" +
                      extensions_of(Contents::triangulation) + ")")
      ->required();
  command
      .add_option_function<std::string>(
          "--arithmetic",
          [&options](const std::string& word) {
            options.arithmetic = word;
            options.is_arithmetic_given = true;
          },
          "exact (certified predicates, default) or double")
      ->check(CLI::IsMember({"exact", "double"}));
  command
      .add_option_function<std::string>(
          "--mollification",
          [&options](const std::string& word) {
            options.mollification = word;
            options.is_mollification_given = true;
          },
          "treatment of faces without area: automatic (only where flips cannot remove them, "
          "default), none, lengths or squared")
      ->check(CLI::IsMember({"automatic", "none", "lengths", "squared"}));
  command.add_option("--domain", options.domain, surface_description)
      ->check(CLI::IsMember(surface_words));
  command
      .add_option("--neighbors", options.neighbors,
                  "number of neighbors of each point to triangulate; default 30")
      ->check(between(2, 1e9))
      ->type_name("K");
  command
      .add_option(
          "--polygons", options.polygons,
          "what to make from polygons that are not planar: fan (triangles in space, default) or "
          "planar (the planar polygon with the same sides and the nearest angles)")
      ->check(CLI::IsMember({"fan", "planar"}));
  command.add_option("--stats", options.stats, "write statistics as JSON; - is standard output")
      ->type_name("FILE");
  command
      .add_option("--records", options.records,
                  "write all records of lists that statistics shorten to 1000, as JSON Lines")
      ->type_name("FILE");
  command
      .add_option("--time-limit", options.time_limit,
                  "seconds after which the program gives up, with exit code 1, and writes nothing")
      ->check(between(1e-6, 1e9))
      ->type_name("SECONDS");
  command.add_flag("--progress", options.logs_progress,
                   "write lines with the current step to standard error");
}

void add_constraint_options(CLI::App& command, Options& options) {
  command
      .add_option("--sharp-angle", options.sharp_angle,
                  "keep edges whose faces deviate by more than so many degrees from a plane")
      ->check(between(0, 180));
  command
      .add_option("--constrain", options.constraints,
                  "keep the edges that a text file lists: the numbers of two vertices on each line")
      ->type_name("FILE");
}

void add_metric_option(CLI::App& command, Options& options) {
  command
      .add_option(
          "--metric", options.metric,
          "change lengths: a text file with a factor per vertex, or with a tensor xx xy xz yy "
          "yz zz per face")
      ->type_name("FILE");
}

void add_refinement_options(CLI::App& command, Options& options) {
  Refinement_criteria& r = options.refinement;
  command.add_option("--min-angle", r.minimum_angle, "least angle in degrees; default 30")
      ->check(between(0, 59));
  command.add_option("--max-circumradius", r.maximum_circumradius, "largest circumradius of faces")
      ->check(positive());
  command.add_option("--max-edge-length", r.maximum_edge_length, "largest length of edges")
      ->check(positive());
  command
      .add_option("--size", options.sizes,
                  "largest length of edges at each vertex of the input: a text file with a number "
                  "per vertex")
      ->type_name("FILE");
  command
      .add_option("--max-insertions", r.maximum_insertions,
                  "cap on the number of insertions; default a million and ten per face")
      ->check(between(0, 1e18));
  command
      .add_option_function<std::string>(
          "--order",
          [&r](const std::string& word) {
            r.order = word == "worst"     ? IT::Refinement_order::worst_first
                      : word == "largest" ? IT::Refinement_order::largest_first
                                          : IT::Refinement_order::first_come;
          },
          "which face comes next: first (default), largest or worst")
      ->check(CLI::IsMember({"largest", "worst", "first"}));
  command.add_flag("--conforming", r.is_conforming,
                   "split kept edges until all edges are Delaunay");
  command
      .add_option("--odt", options.odt_length,
                  "then move inserted vertices to an optimal Delaunay triangulation, split edges "
                  "longer than "
                  "this, and refine to the least angle again")
      ->check(positive());
}

// The vertex may be named by another option.
void add_adaptive_options(CLI::App& command, Options& options, bool has_vertex) {
  Adaptive_criteria& a = options.adaptive;
  CLI::Option* const adaptive =
      command.add_flag("--adaptive", a.is_asked_for,
                       "refine where the Green's function of a vertex has large errors");
  for (const char* other : {"--max-circumradius", "--max-edge-length", "--size", "--max-insertions",
                            "--order", "--conforming", "--odt"})
    adaptive->excludes(other);
  if (has_vertex)
    command.add_option("--source", a.source, "the vertex; default 0")->needs(adaptive);
  command
      .add_option("--heat-time", a.heat_time,
                  "refine for the heat kernel after this time instead, in squares of the mean edge")
      ->check(positive())
      ->needs(adaptive);
  command
      .add_option("--tolerance", a.tolerance,
                  "estimated error to reach, divided by the root of the area, or with "
                  "--heat-time by the norm of the kernel; default 0.01")
      ->check(positive())
      ->needs(adaptive);
  command
      .add_option("--max-vertices", a.maximum_vertices,
                  "cap on the number of vertices; default 100000")
      ->check(between(1, 1e9))
      ->needs(adaptive);
}

void add_adaptive_options(CLI::App& command, Options& options) {
  add_adaptive_options(command, options, true);
}

void add_matrix_options(CLI::App& command, Options& options) {
  const auto matrix = [&command](const char* name, std::string& path, const char* what) {
    command.add_option(name, path, std::string("write ") + what + " in Matrix Market format")
        ->check(file_of({Contents::matrix}));
  };
  matrix("--mass", options.mass, "the mass matrix");
  command.add_option("--mass-kind", options.mass_kind, "lumped (diagonal, default) or galerkin")
      ->check(CLI::IsMember({"lumped", "galerkin"}));
  matrix("--interpolation", options.interpolation,
         "the interpolation from the vertices of the triangulation to the common subdivision");
  matrix("--input-interpolation", options.input_interpolation,
         "the interpolation from the vertices of the input to the common subdivision");
}

void add_correspondence_options(CLI::App& command, Options& options) {
  command
      .add_option("--correspondence", options.correspondence,
                  "how to store where edges run on the input: integer (coordinates, default), "
                  "signposts, crossings or none")
      ->check(CLI::IsMember({"none", "integer", "signposts", "crossings"}));
  add_output_option(command, "-o", options.output,
                    {Contents::subdivision, Contents::triangulation});
  add_view_option(command, options, "the triangulation");
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

std::string cut_misuse(const Options& o) {
  const Geodesic_options& g = o.geodesic;
  const bool has_curves =
      !g.paths.empty() || !g.loops.empty() || !g.network.empty() || has_constraints(o);
  const int kinds =
      (has_curves ? 1 : 0) + (o.cut.levels.empty() ? 0 : 1) + (o.cut.makes_disks ? 1 : 0);
  if (kinds == 0)
    return "there is nothing to cut along; name curves with --path, --loop, --network, --marked or "
           "--sharp-angle, isolines with --levels, or give --to-disk";
  if (kinds > 1)
    return "curves, isolines and cuts to disks would divide each other; give either curves, "
           "--levels or --to-disk";
  if (!o.cut.levels.empty() && o.application.sources.empty() == o.field.empty())
    return "--levels needs a function: give --source for distances, or --values, a file of numbers";
  return {};
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

// Adaptive refinement is about the first of them.
void add_source_option(CLI::App& command, Options& options) {
  command
      .add_option("--source", options.application.sources,
                  "points, separated by commas: vertices as numbered in the file, from 0, or "
                  "face:b0:b1:b2")
      ->required()
      ->check(curve_points(1));
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
  Application_options& a = options.application;
  command.get_option("--source")->required(false);
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

namespace {

// What is wrong with options of batches of distances.
std::string batch_misuse(const Options& o) {
  const Application_options& a = o.application;
  if (!a.pairs.empty() && !a.source_sets.empty())
    return "--pairs and --sources have different results; give one of them";
  if (!a.sources.empty() || !a.curves.empty() || !a.targets.empty() || a.is_signed)
    return "--pairs and --sources say where distances start; give them without --source, "
           "--targets, --curve and --signed";
  if (o.adaptive.is_asked_for)
    return "--adaptive refines about one point; give it with --source, or another criterion";
  if (!a.voronoi.empty() && !a.pairs.empty())
    return "--voronoi divides the surface among sources; give them with --source or --sources";
  if (!o.view.empty() || !a.isolines.empty())
    return "a page and isolines show one function; for one set give --source, not --pairs or "
           "--sources";
  if (!a.pairs.empty() && a.maximum_distance)
    return "searches between pairs end where they arrive; leave --max-distance out";
  if (!a.pairs.empty() && !o.output.empty() && !is_file_of(Contents::values, o.output))
    return o.output + ": write distances of pairs to " + extensions_of(Contents::values);
  if (!a.source_sets.empty() && !a.voronoi.empty()) {
    if (!o.output.empty() && !is_file_of(Contents::values, o.output))
      return "with --voronoi, --sources gives the distance of the nearest set; write it with -o "
             "to " +
             extensions_of(Contents::values);
    return {};
  }
  if (!a.source_sets.empty() && !is_file_of(Contents::full_matrix, o.output))
    return "--sources makes a matrix; write it with -o to " + extensions_of(Contents::full_matrix);
  return {};
}

} // namespace

std::string distance_misuse(const Options& o) {
  const Application_options& a = o.application;
  if (a.sources.empty() && a.curves.empty() && !has_batch(a))
    return "distances need a source; give points with --source, or a curve with --curve, or a file "
           "with --pairs or --sources";
  if (has_batch(a))
    if (const std::string misuse = batch_misuse(o); !misuse.empty()) return misuse;
  if (!a.voronoi.empty() &&
      (a.distance != "exact" || !a.targets.empty() || a.maximum_distance.has_value()))
    return "cells need exact distances everywhere; give --voronoi with --method exact, without "
           "--targets and --max-distance";
  if (!has_batch(a) && !o.output.empty() && is_file_of(Contents::full_matrix, o.output))
    return o.output +
           ": a matrix has a column for each set of sources; give them with --sources, "
           "or write values to " +
           extensions_of(Contents::values);
  if (a.is_signed && (a.curves.empty() || !a.sources.empty()))
    return "only curves have sides; with --signed, give --curve and no --source";
  const bool is_exact = a.distance == "exact";
  if (is_exact && (!a.curves.empty() || a.time_factor != 1))
    return "exact distances start at points and need no time; leave --curve, --signed and --time "
           "out, or use --method heat";
  if (!is_exact && (!a.targets.empty() || a.maximum_distance))
    return "only the search for exact distances can end early; give --targets and --max-distance "
           "with --method exact";
  return {};
}

std::string parametrize_misuse(const Options& o) {
  if (o.application.map != "conformal")
    return o.uniformize.start.empty()
               ? ""
               : "lengths of triangles are scaled by conformal maps alone; give --start with "
                 "--method conformal";
  if (!o.application.cut.empty() || o.refines || has_constraints(o))
    return "--method conformal maps disks, between their vertices, and flips all edges; leave "
           "--cut, --refine, --sharp-angle and --marked out";
  return {};
}

std::string field_misuse(const Options& o) {
  if (o.application.alignment && o.application.degree % 2 != 0)
    return "directions of curvature have no sign; with --align, give an even --degree: 2 for "
           "lines, 4 for crosses";
  return {};
}

void add_time_option(CLI::App& command, Options& options) {
  command
      .add_option(
          "--time", options.application.time_factor,
          "how long heat flows, in squares of the mean edge length; with --signed, in squares of "
          "half of it (default 1)")
      ->check(CLI::PositiveNumber);
}

void make_refinement_options_need(CLI::Option& refine, CLI::App& command) {
  for (CLI::Option* const option : command.get_options())
    for (const char* const name : refinement_options)
      if (option->check_lname(name)) option->needs(&refine);
}

std::string geodesic_misuse(const Options& o) {
  const Geodesic_options& g = o.geodesic;
  const bool has_curves =
      !g.paths.empty() || !g.loops.empty() || !g.network.empty() || has_constraints(o);
  const int alone = (g.bezier.empty() ? 0 : 1) + (g.source.empty() ? 0 : 1);
  if (alone == 0 && !has_curves)
    return "there is no curve; name some with --path, --loop, --bezier, --source, --network, "
           "--marked or --sharp-angle";
  if (alone > 1 || (alone == 1 && has_curves))
    return "--bezier and --source flip edges wherever they need to; give them without other curves";
  return curve_output_misuse(o);
}

std::string misuse(const Options& options) {
  if (names_a_file_twice(options)) return "two outputs are the same file; give each its own";
  if (const std::string name = overwritten_input(options); !name.empty())
    return name + ": the output is also an input; give it another name";
  if (lacks_correspondence(options))
    return "the common subdivision, --size and --adaptive need a correspondence; use "
           "--correspondence integer, or write the intrinsic triangulation to .idt";
  if (has_other_correspondence(options))
    return "--adaptive keeps integer coordinates; use --correspondence integer";
  return {};
}

} // namespace program
