// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "application_options.h"
#include "coarse_options.h"
#include "commands.h"
#include "option_groups.h"

#include <cstddef>
#include <string>
#include <vector>

// The table of commands, and the options that only one of them has.

namespace program {

namespace {

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
  const Words places({{"input", ""}, {"intrinsic", ""}}, options.from);
  add("--from", options.from, {places.check()},
      "triangulation that has the values: " + places.help());
  const Words methods({{"l2", "the nearest function"}, {"pointwise", "values at vertices"}},
                      defaults::transfer_method);
  add("--method", options.method, {methods.check()}, methods.help());
  add_output_option(command, options, "-o", options.output,
                    {Contents::values, Contents::valued_subdivision});
  add_view_option(command, options, "the functions");
}

void add_shown_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  command.get_option("IN")->allow_extra_args(false); // what follows is shown
  add("FILE", options.shown,
      "what the page shows: values, a text file with the values at a vertex or on a face on each "
      "line, whole numbers in colours of their own; or curves, " +
          extensions_of(Contents::curves))
      ->expected(0, -1);
  add("-o", options.view, {file_name},
      "write the page to this file; by default to a temporary one, which a browser opens");
  add("--view-limit", options.view_limit, {in_range(page_megabytes), Type{"MB"}},
      "most megabytes of the page, which shows less if it needs more; " +
          default_is(options.view_limit));
}

// ---- geodesic, cut -----------------------------------------------------------------------------

void add_curve_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  Geodesic_options& g = options.geodesic;
  add_joined_curve_options(command, options);
  add("--bezier", g.bezier, {curve_points(2)}, "Bezier curve with these control points; alone");
  add("--source", g.source, {curve_points(1)},
      "geodesics from a point to all vertices, in one triangulation; alone");
  const Words methods(
      {{"exact", "shortest paths"},
       {"flips", "they start along edges: found faster, geodesic, but often longer"}},
      defaults::curve_method);
  add("--method", g.method, {methods.check()}, methods.help());
  add("--shorten-to", g.relative_length, {in_range({1e-9, 1})},
      "stop when the length is at most this part of what it was");
  add("--joint-angle", g.joint_angle, {in_range({0, 180})},
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
  add_plain_flag(command, options);
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
    {"simplify",
     "make a surface with fewer vertices, and prove by how much lengths change",
     run_simplify,
     {common, add_constraint_options, add_metric_option, add_simplify_options}},
    {"isometry",
     "say whether two surfaces are isometric, or find the symmetries of one, exactly",
     run_isometry,
     {common, add_isometry_options}},
    {"embed",
     "find the convex polyhedron whose surface has the lengths of the input",
     run_embed,
     {common, add_metric_option, add_embed_options, add_polyhedron_option}},
    {"info",
     "describe a mesh or an intrinsic triangulation as it is, and say whether it is "
     "Delaunay",
     run_info,
     {common, add_info_options}},
    {"study",
     "compare arithmetics: run each on each mesh (the program intrinsic-study)",
     run_study,
     {add_study_words}}};
} // namespace

const std::vector<Command>& commands() { return table; }

} // namespace program
