// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "asked_curves.h"
#include "commands.h"
#include "levels.h"
#include "option_groups.h"

#include <cstddef>
#include <string>
#include <vector>

// The table of commands, and the options that only one of them has.

namespace program {

namespace {

CLI::Validator level_list() {
  return CLI::Validator([](std::string& text) { return levels_misuse(text); }, "N|LIST");
}

// ---- delaunay, refine, laplacian, transfer -----------------------------------------------------

// Matrices of the refined triangulation; and that it is refined.
void add_refined_matrices(CLI::App& command, Options& options) {
  Option_adder{command}("--laplacian", options.laplacian, {file_of({Contents::matrix})},
                        "write the Laplacian of the refined triangulation in Matrix Market format");
  add_matrix_options(command, options);
  command.callback([&options] { options.refines = true; });
}

void add_laplacian_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  add("-o", options.laplacian, {file_of({Contents::matrix})},
      "write the Laplacian in Matrix Market format");
  add_matrix_options(command, options);
  add("--no-flip", options.no_flip, "take the triangulation as it is");
  command.callback(
      [&options] { options.correspondence = needs_subdivision(options) ? "integer" : "none"; });
}

void add_transfer_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  command.get_option("IN")->allow_extra_args(false); // what follows is the field
  add("FIELD", options.field,
      "text file: on each line the values at a vertex, in the order of rows")
      ->required();
  add("--from", options.from, {CLI::IsMember({"input", "intrinsic"})},
      "triangulation that has the values: input (default) or intrinsic");
  add("--method", options.method, {CLI::IsMember({"l2", "pointwise"})},
      "l2 (the nearest function, default) or pointwise (values at vertices)");
  add_output_option(command, options, "-o", options.output,
                    {Contents::values, Contents::valued_subdivision});
  add_view_option(command, options, "the functions");
}

void add_shown_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  command.get_option("IN")->allow_extra_args(false); // what follows is shown
  add("FILE", options.shown,
      "what the page shows: values, a text file with the values at a vertex on each line, whole "
      "numbers in colours of their own; or curves, an .obj file with lines")
      ->expected(0, -1);
  add("-o", options.view, {file_name},
      "write the page to this file; by default to a temporary one, which a browser opens");
  add("--view-limit", options.view_limit, {between(2, 2000), Type{"MB"}},
      "most megabytes of the page, which shows less if it needs more; default 30");
}

// ---- geodesic, cut -----------------------------------------------------------------------------

void add_curve_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  Geodesic_options& g = options.geodesic;
  add_joined_curve_options(command, options);
  add("--bezier", g.bezier, {curve_points(2)}, "Bezier curve with these control points; alone");
  add("--source", g.source, {curve_points(1)},
      "geodesics from a point to all vertices, in one triangulation; alone");
  add("--method", g.method, {CLI::IsMember({"exact", "flips"})},
      "exact (shortest paths, default), or flips (they start along edges: found faster, geodesic, "
      "but often longer)");
  add("--shorten-to", g.relative_length, {between(1e-9, 1)},
      "stop when the length is at most this part of what it was");
  add("--joint-angle", g.joint_angle, {between(0, 180)},
      "stop when all joints have at least this angle, in degrees");
}

void add_curve_output_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  add("-o", options.output,
      {file_of({Contents::curves, Contents::subdivision, Contents::triangulation})},
      "write " + listed_with_extensions({Contents::curves, Contents::triangulation}));
  add("--subdivision", options.geodesic.writes_subdivision,
      "-o writes the common subdivision, with the number of the curve at its vertices, to " +
          extensions_of(Contents::subdivision));
  add_view_option(command, options, "the curves");
  add("--refine", options.refines,
      "then flip to Delaunay and refine, as the command refine does; curves are kept");
}

void add_cut_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  CLI::Option* const levels =
      add("--levels", options.cut.levels, {level_list()},
          "cut along isolines: how many, evenly spaced, or a list of values with commas");
  add("--source", options.application.sources, {levels, curve_points(1)},
      "isolines of the exact distance from points, separated by commas");
  add("--values", options.field, {levels, file_name},
      "isolines of a function: a text file with a number for each vertex of the mesh");
  add("--to-disk", options.cut.makes_disks,
      "make a disk of each component by a short cut along geodesics");
  add_output_option(command, options, "-o", options.output, {Contents::cut_surface});
  add("--labels", options.cut.labels, {file_of({Contents::values})},
      "write on each line the component of a face, and the face of the mesh that it is in, to "
      ".txt");
  add_view_option(command, options, "the pieces");
}

// ---- Problems on the triangulation -------------------------------------------------------------

// Where distances start, and where the search for them ends.
void add_distance_searches(CLI::App& command, Options& options) {
  const Option_adder add(command);
  Application_options& a = options.application;
  add_results(command, options, true,
              {Contents::values, Contents::subdivision, Contents::full_matrix});
  command.get_option("--source")->required(false);
  add_time_option(command, options);
  add("--method", a.distance, {CLI::IsMember({"exact", "heat"})},
      "exact (along shortest paths from points, default), or heat (smooth; the default with "
      "--curve)");
  command.callback([&a] {
    if (a.distance.empty()) a.distance = a.curves.empty() ? defaults::distance_method : "heat";
  });
  add("--targets", a.targets, {curve_points(1)},
      "points; the exact search ends when their distances are known");
  add("--max-distance", a.maximum_distance, {positive()}, "the exact search ends at this distance");
  add("--curve", a.curves, {curve_points(2)},
      "a curve through points, along edges of the triangulation; closed if the last point is the "
      "first");
  add("--signed", a.is_signed, "distances on the left of curves are negative");
  add("--pairs", a.pairs, {file_name},
      "text file: the numbers of two vertices on each line; their distances are found");
  add("--sources", a.source_sets, {file_name},
      "text file: on each line the vertices of a set; the distances from each set are found, a "
      "row of a matrix each");
}

// Lines of equal distance, and lines between cells.
void add_distance_lines(CLI::App& command, Options& options) {
  const Option_adder add(command);
  Application_options& a = options.application;
  CLI::Option* const isolines =
      add("--isolines", a.isolines, {file_of({Contents::curves})},
          "write the lines of equal distance, with the number of their level, to " +
              extensions_of(Contents::curves));
  add("--levels", a.levels, {level_list(), isolines},
      "distances of these lines: how many, evenly spaced (default 10), or a list, separated by "
      "commas; a whole number alone is how many");
  CLI::Option* const voronoi = add("--voronoi", a.voronoi, {file_of({Contents::curves})},
                                   "write the lines between the cells of the "
                                   "nearest source, or set of --sources, to " +
                                       extensions_of(Contents::curves));
  add("--cell-tolerance", a.cell_tolerance, {positive(), voronoi},
      "how far off these lines may be, in units of the file; default a thousandth of the mean "
      "edge");
}

void add_parametrize_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  add("--method", options.application.map,
      {CLI::IsMember({"harmonic", "conformal", "spectral", "lscm"})},
      "harmonic (to a circle, default), conformal (with scale 1 on the border of disks), spectral "
      "(nearly conformal, also of points) or lscm");
  add("--cut", options.application.cut,
      "auto (default): cut open along few edges unless it is a disk; or a file that lists the "
      "edges, two vertices a line");
  add_start_option(command, options);
  command.callback([&options] {
    if (options.application.cut.empty() && options.application.map != "conformal")
      options.application.cut = defaults::cut;
  });
}

void add_uniformize_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  Uniformize_options& u = options.uniformize;
  add_output_option(command, options, "-o", options.output,
                    {Contents::values, Contents::subdivision});
  add_view_option(command, options, "a checkerboard of the layout, or the logarithm of the scale");
  add_metric_option(command, options);
  CLI::Option* const angles =
      add("--angles", u.angles, {file_name},
          "text file: the angle around each vertex on a line of its own, in radians, as a multiple "
          "of pi (3/2pi), or free; by default 2pi, and free on the border");
  add("--cones", u.cones, {Type{"NUMBER|RATIO|FILE"}},
      "how many vertices have other angles, which are chosen; or, such as 10x, the largest ratio "
      "of scales, for as many as are needed; or a text file: the number of such a vertex and its "
      "angle on each line")
      ->excludes(angles);
  add_start_option(command, options);
  add("--target", u.target, {CLI::IsMember({"plane", "sphere", "torus", "disk"})},
      "plane (flat but for cones), sphere (the round one), torus (flat, with its period) or disk "
      "(hyperbolic, in Poincaré's disk); by default, without --angles and --cones, sphere, torus "
      "and disk for closed surfaces of genus 0, 1 and more, else plane");
}

void add_transport_options(CLI::App& command, Options& options) {
  add_time_option(command, options);
  Option_adder{command}("--vectors", options.application.vectors,
                        "text file: on each line the number of a vertex, an angle in degrees from "
                        "the first edge there, and a length or none")
      ->required();
}

void add_logmap_options(CLI::App& command, Options& options) {
  add_results(command, options, true);
  add_time_option(command, options);
  Option_adder{command}(
      "--method", options.application.logarithm, {CLI::IsMember({"exact", "affine", "polar"})},
      "exact (by shortest paths, default), affine (by heat, also on points) or polar (by heat)");
}

void add_field_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  Application_options& a = options.application;
  add("--degree", a.degree, {CLI::Range(1, 12)},
      "number of equivalent directions at a vertex: 1 vectors, 2 lines, 4 crosses (default)");
  add("--vectors", a.vectors, "text file of vectors that are kept, as for transport");
  add("--singularities", a.singularities, {file_of({Contents::points})},
      "write the singularities, points with their index, to " + extensions_of(Contents::points));
  add("--align", a.alignment, {CLI::NonNegativeNumber},
      "how strongly the field follows the directions of principal curvature; 0: as little as "
      "possible");
}

void add_eigen_options(CLI::App& command, Options& options) {
  Option_adder{command}("--count", options.application.count, {CLI::PositiveNumber},
                        "how many; default " + std::to_string(defaults::count));
}

void add_edit_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  add("--handles", options.application.handles,
      "text file: on each line the number of a vertex and its displacement")
      ->required();
  add("--energy", options.application.energy, {CLI::IsMember({"biharmonic", "harmonic"})},
      "energy to minimize: biharmonic (default) or harmonic");
}

// All that follows goes to the other program.
void add_study_words(CLI::App& command, Options& options) {
  command.prefix_command()->set_help_flag();
  command.callback([&] { options.study = command.remaining(); });
}

// ---- The table ---------------------------------------------------------------------------------

constexpr Option_group common = add_common_options;

const std::vector<Command> table{
    {"delaunay",
     "flip to the intrinsic Delaunay triangulation",
     run_delaunay,
     {common, add_constraint_options, add_metric_option, add_correspondence_options}},
    {"refine",
     "insert vertices until all faces are well shaped, keeping the Delaunay property",
     run_delaunay,
     {common, add_constraint_options, add_correspondence_options, add_metric_option,
      add_refinement_options, add_adaptive_options, add_refined_matrices}},
    {"laplacian",
     "write the cotangent Laplacian of the intrinsic Delaunay triangulation",
     run_delaunay,
     {common, add_constraint_options, add_metric_option, add_laplacian_options}},
    {"transfer",
     "take functions from a mesh to its intrinsic triangulation, or back",
     run_transfer,
     {common, add_transfer_options, add_refine_flag, add_constraint_options, add_metric_option,
      add_refinement_options, add_adaptive_options}},
    {"view",
     "show a mesh or an intrinsic triangulation as it is in a browser, with values and curves",
     run_view,
     {common, add_shown_options}},
    {"geodesic",
     "make curves on the surface geodesic: paths, loops, networks",
     run_geodesic,
     {common, add_curve_options, add_metric_option, add_curve_output_options,
      add_refinement_options},
     geodesic_misuse},
    {"cut",
     "cut the mesh open along curves or isolines, and label the pieces",
     run_cut,
     {common, add_joined_curve_options, add_cut_options},
     cut_misuse},
    {"distance",
     "compute distances from points and curves, exactly or by the flow of heat",
     run_distance,
     {common, add_distance_searches, add_distance_lines},
     distance_misuse},
    {"parametrize",
     "map a surface to the plane, and certify that it is injective",
     run_parametrize,
     {common, add_result_options, add_parametrize_options},
     parametrize_misuse},
    {"uniformize",
     "scale the surface at its vertices until the angles there are prescribed ones",
     run_uniformize,
     {common, add_uniformize_options}},
    {"transport",
     "take tangent vectors from some vertices to all, along shortest paths",
     run_transport,
     {common, add_result_options, add_transport_options}},
    {"logmap",
     "unroll the surface about a point: directions and distances from there",
     run_logmap,
     {common, add_logmap_options}},
    {"field",
     "find the smoothest field of vectors, lines or crosses",
     run_field,
     {common, add_result_options, add_field_options},
     field_misuse},
    {"eigen",
     "compute the smallest eigenvalues of the Laplacian, and their eigenfunctions",
     run_eigen,
     {common, add_result_options, add_eigen_options}},
    {"edit",
     "deform the surface: move some vertices, others follow smoothly",
     run_edit,
     {common, add_result_options, add_edit_options}},
    {"embed",
     "find the convex polyhedron whose surface has the lengths of the input",
     run_embed,
     {common, add_metric_option, add_polyhedron_option}},
    {"info",
     "describe a mesh or an intrinsic triangulation as it is, and say whether it is "
     "Delaunay",
     run_info,
     {common}},
    {"study",
     "compare arithmetics: run each on each mesh (the program intrinsic-study)",
     run_study,
     {add_study_words}}};
} // namespace

const std::vector<Command>& commands() { return table; }

} // namespace program
