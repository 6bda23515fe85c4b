// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "option_groups.h"
#include "support/file_formats.h"
#include "support/surface_words.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

// what means nothing without refinement
constexpr std::array refinement_options{"min-angle",       "max-circumradius",
                                        "max-edge-length", "size",
                                        "max-insertions",  "order",
                                        "conforming",      "odt",
                                        "adaptive"};

// The input, and how it is read.
void add_input_options(CLI::App& command, Options& options) {
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
}

// What is written about the work, and when it ends.
void add_report_options(CLI::App& command, Options& options) {
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

void add_common_options(CLI::App& command, Options& options) {
  add_input_options(command, options);
  add_report_options(command, options);
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
  CGAL::Intrinsic_triangulations::Refine_criteria& r = options.refinement;
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
      .add_option("--odt", r.odt_length,
                  "then move inserted vertices to an optimal Delaunay triangulation, split edges "
                  "longer than "
                  "this, and refine to the least angle again")
      ->check(positive());
}

// The vertex may be named by another option.
void add_adaptive_options(CLI::App& command, Options& options, bool has_vertex) {
  CGAL::Intrinsic_triangulations::Adapt_criteria& a = options.adaptive;
  CLI::Option* const adaptive =
      command.add_flag("--adaptive", options.is_adaptive,
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

void make_refinement_options_need(CLI::Option& refine, CLI::App& command) {
  for (CLI::Option* const option : command.get_options())
    for (const char* const name : refinement_options)
      if (option->check_lname(name)) option->needs(&refine);
}

} // namespace program
