// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "option_groups.h"
#include "asked_curves.h"
#include "levels.h"
#include "support/surface_words.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

// The input, and how it is read.
void add_input_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  add("IN", options.inputs,
      "mesh (" + extensions_of(Contents::mesh) + "), points (" +
          extensions_of(Contents::point_set) +
          ", or a mesh without faces) or intrinsic triangulation (" +
          extensions_of(Contents::triangulation) +
          "); - is standard input. With several, {} in options is the name of each without folder "
          "and extension: -o {}.ply")
      ->required();
  add("--standard-input", options.is_standard_input, "IN has the contents of standard input")
      ->group(""); // for runs that this program starts
  add("--input-format", options.input_format, {CLI::IsMember(input_formats())},
      "format of standard input, by default guessed from its contents");
  const Words arithmetics({{"exact", "certified predicates"}, {"double", ""}},
                          defaults::arithmetic);
  add("--arithmetic", options.arithmetic, {arithmetics.check()}, arithmetics.help())
      ->each([&options](const std::string&) { options.is_arithmetic_given = true; });
  const Words mollifications({{"automatic", "only where flips cannot remove them"},
                              {"none", ""},
                              {"lengths", ""},
                              {"squared", ""}},
                             defaults::mollification);
  add("--mollification", options.mollification, {mollifications.check()},
      "treatment of faces without area: " + mollifications.help())
      ->each([&options](const std::string&) { options.is_mollification_given = true; });
  add("--domain", options.domain, {CLI::IsMember(surface_words)}, surface_description);
  add("--neighbors", options.neighbors, {in_range(ranges::neighbors), Type{"K"}},
      "number of neighbors of each point to triangulate; " + default_is(defaults::neighbors));
  const Words polygons({{"fan", "triangles in space"},
                        {"planar", "the planar polygon with the same sides and nearest angles"}},
                       defaults::polygons);
  add("--polygons", options.polygons, {polygons.check()},
      "what to make from polygons that are not planar: " + polygons.help());
}

// What is written about the work, and when it ends.
void add_report_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  add("--stats", options.stats, {file_name}, "write statistics as JSON; - is standard output");
  add("--records", options.records, {file_name},
      "write all records of lists that statistics shorten to 1000, as JSON Lines");
  add("--time-limit", options.time_limit, {in_range({1e-6, 1e9}), Type{"SECONDS"}},
      "seconds after which the program gives up, with exit code 1, and writes nothing");
  add("--progress", options.logs_progress, "write lines with the current step to standard error");
  CLI::Option* const quiet = add("--quiet", options.is_quiet, "print only errors");
  add("--verbose", options.is_verbose,
      "print more than the answer: what the input is, the triangulation, times")
      ->excludes(quiet);
}

} // namespace

Completion file_of(std::vector<Contents> offered) {
  const auto complete = [offered = std::move(offered)](std::string& path) {
    if (path == "-") path += first_extension_of(offered.front());
    for (const Contents contents : offered)
      if (is_file_of(contents, path)) return std::string();
    return path + ": the format is not offered; write " + listed_with_extensions(offered);
  };
  return {CLI::Validator(complete, ""), file_name};
}

CLI::Validator curve_points(std::size_t least) {
  return CLI::Validator([least](std::string& text) { return curve_points_misuse(text, least); },
                        "POINTS");
}

CLI::Validator level_list() {
  return CLI::Validator([](std::string& text) { return levels_misuse(text); }, "N|LIST");
}

void add_output_option(CLI::App& command, Options& options, const std::string& name,
                       std::string& path, const std::vector<Contents>& offered) {
  const Option_adder add(command);
  add(name, path, {file_of(offered)}, "write " + listed_with_extensions(offered));
  const auto is_surface = [](Contents c) {
    return c == Contents::subdivision || c == Contents::valued_subdivision;
  };
  if (std::ranges::any_of(offered, is_surface)) add_plain_flag(command, options);
}

void add_plain_flag(CLI::App& command, Options& options) {
  Option_adder{command}(
      "--plain", options.is_plain,
      "write surfaces as .ply without labels and edges, .off of triangles without colours, and "
      ".obj cut open where places in the plane differ, for readers that take nothing else");
}

void add_view_option(CLI::App& command, Options& options, const std::string& what) {
  const Option_adder add(command);
  CLI::Option* const view =
      add("--view", options.view, {file_name}, "write a page that shows " + what);
  add("--view-limit", options.view_limit, {in_range(page_megabytes), Type{"MB"}, view},
      "most megabytes of the page, which shows less if it needs more; " +
          default_is(options.view_limit));
}

void add_common_options(CLI::App& command, Options& options) {
  add_input_options(command, options);
  add_report_options(command, options);
}

void add_isometry_options(CLI::App& command, Options& options) {
  command.get_option("IN")->allow_extra_args(false); // what follows is the other surface
  Option_adder{command}("OTHER", options.other, {file_name},
                        "mesh or triangulation that is compared with IN; by default IN itself, "
                        "whose symmetries are found");
}

void add_info_options(CLI::App& command, Options& options) {
  Option_adder{command}("--hash", options.hashes,
                        "compute a number that is the same for all isometric surfaces");
}

void add_constraint_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  add("--sharp-angle", options.sharp_angle, {in_range(ranges::sharp_angle)},
      "keep edges whose faces deviate by more than so many degrees from a plane");
  add("--keep", options.constraints, {file_name},
      "keep the edges that a text file lists: the numbers of two vertices on each line");
}

void add_metric_option(CLI::App& command, Options& options) {
  Option_adder{command}("--metric", options.metric, {file_name},
                        "change lengths: a text file with a factor per vertex, or with a tensor xx "
                        "xy xz yy yz zz per face");
}

void add_polyhedron_option(CLI::App& command, Options& options) {
  add_output_option(command, options, "-o", options.output, {Contents::polyhedron});
  add_view_option(command, options, "the polyhedron");
}

void add_refinement_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  IT::Refine_criteria& r = options.refinement;
  add("--min-angle", r.minimum_angle, {in_range(ranges::min_angle)},
      "least angle in degrees; " + default_is(defaults::min_angle) + "; up to " +
          std::to_string(static_cast<int>(greatest_safe_angle)) + " refinement always ends");
  add("--max-circumradius", r.maximum_circumradius, {in_range(ranges::max_circumradius)},
      "largest circumradius of faces");
  command
      .add_option_function<std::string>(
          "--max-edge-length",
          [&options](const std::string& word) {
            if (double x = 0; CLI::detail::lexical_cast(word, x))
              options.refinement.maximum_edge_length = x;
            else
              options.sizes = word;
          },
          "largest length of edges; or at each vertex of the input: a text file with a number per "
          "vertex")
      ->check(in_range_or_name(ranges::max_edge_length));
  add("--max-insertions", r.maximum_insertions, {in_range(ranges::max_insertions)},
      "cap on the number of insertions; default a million and ten per face");
  const Words orders({{"first", ""}, {"largest", ""}, {"worst", ""}}, defaults::order);
  command
      .add_option_function<std::string>(
          "--order", [&r](const std::string& word) { r.order = IT::refinement_order(word); },
          "which face comes next: " + orders.help())
      ->check(orders.check());
  add("--conforming", r.is_conforming, "split kept edges until all edges are Delaunay");
  add("--odt-length", r.odt_length, {in_range(ranges::odt_length)},
      "then move inserted vertices to an optimal Delaunay triangulation, split edges longer than "
      "this, and refine to the least angle again");
}

void add_adaptive_options(CLI::App& command, Options& options, bool has_vertex) {
  const Option_adder add(command);
  IT::Adapt_criteria& a = options.adaptive;
  CLI::Option* const adaptive =
      add("--adaptive", options.is_adaptive,
          "refine where the Green's function of a vertex has large errors");
  for (const char* other : {"--max-circumradius", "--max-edge-length", "--max-insertions",
                            "--order", "--conforming", "--odt-length"})
    adaptive->excludes(other);
  if (has_vertex) add("--source", a.source, {adaptive}, "the vertex; " + default_is(a.source));
  add("--heat-time", a.heat_time, {in_range(ranges::heat_time), adaptive},
      "refine for the heat kernel after this time instead, in squares of the mean edge");
  add("--tolerance", a.tolerance, {in_range(ranges::tolerance), adaptive},
      "estimated error to reach, divided by the root of the area, or with --heat-time by the norm "
      "of the kernel; " +
          default_is(defaults::tolerance));
  add("--max-vertices", a.maximum_vertices, {in_range(ranges::max_vertices), adaptive},
      "cap on the number of vertices; " + default_is(defaults::max_vertices));
}

void add_matrix_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  const auto matrix = [&](const char* name, std::string& path, const std::string& what) {
    return add(name, path, {file_of({Contents::matrix})},
               "write " + what + " in Matrix Market format");
  };
  CLI::Option* const mass = matrix("--mass", options.mass, "the mass matrix");
  const Words kinds({{"lumped", "diagonal"},
                     {"galerkin", ""},
                     {"voronoi", "diagonal, the areas of cells, which may be negative"}},
                    defaults::mass_kind);
  add("--mass-kind", options.mass_kind, {mass, kinds.check()}, kinds.help());
  matrix("--interpolation", options.interpolation,
         "the interpolation from the vertices of the triangulation to the common subdivision");
  matrix("--input-interpolation", options.input_interpolation,
         "the interpolation from the vertices of the input to the common subdivision");
}

void add_correspondence_options(CLI::App& command, Options& options) {
  const Words kinds(
      {{"integer", "coordinates"}, {"signposts", ""}, {"crossings", ""}, {"none", ""}}, "integer");
  Option_adder{command}("--correspondence", options.correspondence, {kinds.check()},
                        "how to store where edges run on the input: " + kinds.help());
  add_output_option(command, options, "-o", options.output,
                    {Contents::subdivision, Contents::triangulation});
  add_view_option(command, options, "the triangulation");
}

void make_refinement_options_need_refine(CLI::App& command) {
  CLI::Option* const refine = command.get_option_no_throw("--refine");
  if (refine == nullptr) return;
  for (const char* const name :
       {"--min-angle", "--max-circumradius", "--max-edge-length", "--max-insertions", "--order",
        "--conforming", "--odt-length", "--adaptive"})
    if (CLI::Option* const option = command.get_option_no_throw(name)) option->needs(refine);
}

void add_adaptive_options(CLI::App& command, Options& options) {
  add_adaptive_options(command, options, true);
}

void add_refine_flag(CLI::App& command, Options& options) {
  Option_adder{command}("--refine", options.refines,
                        "refine the triangulation, as the command refine does");
}

void add_joined_curve_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  Geodesic_options& g = options.geodesic;
  add("--path", g.paths, {curve_points(2)},
      "path through points, separated by commas: numbers of vertices, or face:b0:b1:b2; may be "
      "repeated")
      ->allow_extra_args(false);
  add("--loop", g.loops, {curve_points(3)}, "closed curve through points; may be repeated")
      ->allow_extra_args(false);
  add("--network", g.network, {file_name},
      "text file of curves: on each line the vertices of a path, or after the word loop of a "
      "closed curve");
  add("--marked", options.constraints, {file_name},
      "text file of edges that become curves: the numbers of two vertices on each line");
  add("--sharp-angle", options.sharp_angle, {in_range(ranges::sharp_angle)},
      "edges whose faces deviate by more than so many degrees from a plane become curves");
  add("--waypoints", g.has_waypoints, "curves stay at all points that are given");
}

void add_results(CLI::App& command, Options& options, bool has_sources,
                 const std::vector<Contents>& outputs) {
  const Option_adder add(command);
  add_output_option(command, options, "-o", options.output, outputs);
  const Words places(
      {{"subdivision", "on the common subdivision"}, {"input", ""}, {"intrinsic", "values only"}},
      options.application.on);
  add("--on", options.application.on, {places.check()}, "where results are: " + places.help());
  add_view_option(command, options, "the result");
  add_refine_flag(command, options);
  add_constraint_options(command, options);
  add_metric_option(command, options);
  add_refinement_options(command, options);
  add_adaptive_options(command, options, !has_sources);
  if (has_sources)
    add("--source", options.application.sources, {curve_points(1)},
        "points, separated by commas: vertices as numbered in the file, from 0, or face:b0:b1:b2")
        ->required()
        ->allow_extra_args(false); // what follows is another mesh
}

void add_result_options(CLI::App& command, Options& options) {
  add_results(command, options, false);
}

void add_time_option(CLI::App& command, Options& options) {
  Option_adder{command}("--time-factor", options.application.time_factor,
                        {in_range(ranges::time_factor)},
                        "how long heat flows, in squares of the mean edge length; with --signed, "
                        "in squares of half of it; " +
                            default_is(defaults::time_factor));
}

void add_start_option(CLI::App& command, Options& options) {
  const Words starts(
      {{"delaunay", "those of the intrinsic Delaunay triangulation"}, {"input", "of the mesh"}},
      defaults::start);
  Option_adder{command}("--start", options.uniformize.start, {starts.check()},
                        "triangles whose lengths are scaled: " + starts.help());
}

} // namespace program
