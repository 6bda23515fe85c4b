// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "option_groups.h"
#include "options.h"
#include "output_files.h"
#include "support/command_line.h"
#include "support/file_formats.h"
#include "time_limit.h"

#include <array>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <utility>

namespace {

using program::Options;
using Command = void (*)(const Options&);

void add_delaunay(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command =
      *app.add_subcommand("delaunay", "flip to the intrinsic Delaunay triangulation");
  program::add_common_options(command, options);
  program::add_constraint_options(command, options);
  program::add_metric_option(command, options);
  program::add_correspondence_options(command, options);
  command.callback([&chosen] { chosen = program::run_delaunay; });
}

void add_refine(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "refine", "insert vertices until all faces are well shaped, keeping the Delaunay property");
  program::add_common_options(command, options);
  program::add_constraint_options(command, options);
  program::add_correspondence_options(command, options);
  program::add_metric_option(command, options);
  program::add_refinement_options(command, options);
  program::add_adaptive_options(command, options);
  command
      .add_option("--laplacian", options.laplacian,
                  "write the Laplacian of the refined triangulation in Matrix Market format")
      ->check(program::file_of({program::Contents::matrix}));
  program::add_matrix_options(command, options);
  command.callback([&options, &chosen] {
    options.refines = true;
    chosen = program::run_delaunay;
  });
}

void add_laplacian(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "laplacian", "write the cotangent Laplacian of the intrinsic Delaunay triangulation");
  program::add_common_options(command, options);
  program::add_constraint_options(command, options);
  program::add_metric_option(command, options);
  command.add_option("-o", options.laplacian, "write the Laplacian in Matrix Market format")
      ->check(program::file_of({program::Contents::matrix}));
  program::add_matrix_options(command, options);
  command.add_flag("--no-flip", options.no_flip, "take the triangulation as it is");
  command.callback([&options, &chosen] {
    options.correspondence = program::needs_subdivision(options) ? "integer" : "none";
    chosen = program::run_delaunay;
  });
}

void add_transfer(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "transfer", "take functions from a mesh to its intrinsic triangulation, or back");
  program::add_common_options(command, options);
  command
      .add_option("FIELD", options.field,
                  "text file: on each line the values at a vertex, in the order of rows")
      ->required();
  command
      .add_option("--from", options.from,
                  "triangulation that has the values: input (default) or intrinsic")
      ->check(CLI::IsMember({"input", "intrinsic"}));
  command
      .add_option("--method", options.method,
                  "L2 (the nearest function, default) or pointwise (values at vertices)")
      ->check(CLI::IsMember({"L2", "pointwise"}));
  program::add_output_option(command, "-o", options.output,
                             {program::Contents::values, program::Contents::valued_subdivision});
  CLI::Option* const refine = command.add_flag(
      "--refine", options.refines, "refine the triangulation, as the command refine does");
  program::add_constraint_options(command, options);
  program::add_metric_option(command, options);
  program::add_refinement_options(command, options);
  program::add_adaptive_options(command, options);
  program::make_refinement_options_need(*refine, command);
  command.callback([&chosen] { chosen = program::run_transfer; });
}

void add_geodesic(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "geodesic", "make curves on the surface geodesic: paths, loops, networks");
  program::add_common_options(command, options);
  program::add_curve_options(command, options);
  program::add_metric_option(command, options);
  program::add_curve_output_options(command, options);
  CLI::Option* const refine = command.add_flag(
      "--refine", options.refines,
      "then flip to Delaunay and refine, as the command refine does; curves are kept");
  program::add_refinement_options(command, options);
  program::make_refinement_options_need(*refine, command);
  command.callback([&chosen] { chosen = program::run_geodesic; });
}

void add_cut(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "cut", "cut the mesh open along curves or isolines, and label the pieces");
  program::add_common_options(command, options);
  program::add_cut_options(command, options);
  command.callback([&chosen] { chosen = program::run_cut; });
}

void add_distance(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "distance", "compute distances from points and curves, by the flow of heat or exactly");
  using program::Contents;
  program::add_application_options(
      command, options, true, {Contents::values, Contents::subdivision, Contents::full_matrix});
  program::add_time_option(command, options);
  program::add_distance_options(command, options);
  command.callback([&chosen] { chosen = program::run_distance; });
}

void add_parametrize(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "parametrize", "map a surface to the plane, and certify that it is injective");
  program::add_application_options(command, options);
  command
      .add_option(
          "--method", options.application.map,
          "harmonic (to a circle, default), conformal (with scale 1 on the border of disks), "
          "spectral (nearly conformal, also of points) or lscm")
      ->check(CLI::IsMember({"harmonic", "conformal", "spectral", "lscm"}));
  command.add_option("--cut", options.application.cut,
                     "auto (default): cut open along few edges unless it is a disk; or a file that "
                     "lists the edges, two vertices a line");
  program::add_start_option(command, options);
  command.callback([&chosen, &options] {
    if (options.application.cut.empty() && options.application.map != "conformal")
      options.application.cut = "auto";
    chosen = program::run_parametrize;
  });
}

void add_uniformize(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "uniformize", "scale the surface at its vertices until the angles there are prescribed ones");
  program::add_uniformize_options(command, options);
  command.callback([&chosen] { chosen = program::run_uniformize; });
}

void add_transport(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "transport", "take tangent vectors from some vertices to all, along shortest paths");
  program::add_application_options(command, options);
  program::add_time_option(command, options);
  command
      .add_option("--vectors", options.application.vectors,
                  "text file: on each line the number of a vertex, an angle in degrees from the "
                  "first edge there, and a length or none")
      ->required();
  command.callback([&chosen] { chosen = program::run_transport; });
}

void add_logmap(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "logmap", "unroll the surface about a point: directions and distances from there");
  program::add_application_options(command, options, true);
  program::add_time_option(command, options);
  command
      .add_option("--method", options.application.logarithm,
                  "exact (by shortest paths, default), affine (by heat, also on points) or polar "
                  "(by heat)")
      ->check(CLI::IsMember({"exact", "affine", "polar"}));
  command.callback([&chosen] { chosen = program::run_logmap; });
}

void add_field(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command =
      *app.add_subcommand("field", "find the smoothest field of vectors, lines or crosses");
  program::add_application_options(command, options);
  command
      .add_option(
          "--degree", options.application.degree,
          "number of equivalent directions at a vertex: 1 vectors (default), 2 lines, 4 crosses")
      ->check(CLI::Range(1, 12));
  command.add_option("--vectors", options.application.vectors,
                     "text file of vectors that are kept, as for transport");
  command
      .add_option("--singularities", options.application.singularities,
                  "write the singularities, points with their index, to " +
                      program::extensions_of(program::Contents::points))
      ->check(program::file_of({program::Contents::points}));
  command
      .add_option("--align", options.application.alignment,
                  "how strongly the field follows the directions of principal curvature; 0: as "
                  "little as possible")
      ->check(CLI::NonNegativeNumber);
  command.callback([&chosen] { chosen = program::run_field; });
}

void add_eigen(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "eigen", "compute the smallest eigenvalues of the Laplacian, and their eigenfunctions");
  program::add_application_options(command, options);
  command.add_option("--count", options.application.count, "how many (default 10)")
      ->check(CLI::PositiveNumber);
  command.callback([&chosen] { chosen = program::run_eigen; });
}

void add_edit(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command =
      *app.add_subcommand("edit", "deform the surface: move some vertices, others follow smoothly");
  program::add_application_options(command, options);
  command
      .add_option("--handles", options.application.handles,
                  "text file: on each line the number of a vertex and its displacement")
      ->required();
  command
      .add_option("--energy", options.application.energy,
                  "energy to minimize: biharmonic (default) or harmonic")
      ->check(CLI::IsMember({"biharmonic", "harmonic"}));
  command.callback([&chosen] { chosen = program::run_edit; });
}

void add_info(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command =
      *app.add_subcommand("info", "describe a mesh or an intrinsic triangulation as it is, and say "
                                  "whether it is Delaunay");
  program::add_common_options(command, options);
  command.callback([&chosen] { chosen = program::run_info; });
}

// All that follows goes to the other program.
void add_study(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "study", "compare arithmetics: run each on each mesh (the program intrinsic-study)");
  command.prefix_command()->set_help_flag();
  command.callback([&command, &options, &chosen] {
    options.study = command.remaining();
    chosen = program::run_study;
  });
}

// In the order of the help.
constexpr std::array add_commands{add_delaunay,   add_refine,    add_laplacian, add_transfer,
                                  add_geodesic,   add_cut,       add_distance,  add_parametrize,
                                  add_uniformize, add_transport, add_logmap,    add_field,
                                  add_eigen,      add_edit,      add_info,      add_study};

// What is wrong with the options of a command, in itself or together with others; empty: nothing.
std::string misuse_of(Command chosen, const Options& options) {
  std::string misuse = program::misuse(options);
  using Misuse = std::string (*)(const Options&);
  for (const auto& [command, its_misuse] :
       {std::pair<Command, Misuse>(program::run_geodesic, program::geodesic_misuse),
        std::pair<Command, Misuse>(program::run_cut, program::cut_misuse),
        std::pair<Command, Misuse>(program::run_distance, program::distance_misuse),
        std::pair<Command, Misuse>(program::run_parametrize, program::parametrize_misuse),
        std::pair<Command, Misuse>(program::run_field, program::field_misuse)})
    if (misuse.empty() && chosen == command) misuse = its_misuse(options);
  return misuse;
}

// Reports what is wrong with the command line, or prints the help; returns the exit code.
int report_parse_error(const CLI::App& app, const CLI::ParseError& e, int argc, char** argv) {
  if (e.get_name() == "RequiredError" && app.get_subcommands().empty() && argc > 1) {
    std::cerr << "intrinsic: there is no command \""
              << program::legible(argv[1], program::longest_argument)
              << "\"; use delaunay, refine, laplacian, transfer, geodesic, cut, distance, "
                 "parametrize, uniformize, transport, logmap, "
                 "field, eigen, edit, info or "
                 "study, or --help\n";
    return program::misused;
  }
  return app.exit(e) == 0 ? 0 : program::misused;
}

int run(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) options.arguments.emplace_back(argv[i]);
  Command chosen = nullptr;
  CLI::App app("Intrinsic triangulations of triangle meshes, with exact predicates", "intrinsic");
  app.set_version_flag("--version", std::string("intrinsic ") + INTRINSIC_TRIANGULATIONS_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(32);
  app.failure_message([](const CLI::App* a, const CLI::Error& e) {
    return program::legible(CLI::FailureMessage::simple(a, e), program::longest_argument);
  });
  for (const auto add : add_commands) add(app, options, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return report_parse_error(app, e, argc, argv);
  }
  const std::string misuse = misuse_of(chosen, options);
  if (!misuse.empty()) {
    std::cerr << "intrinsic: " << misuse << '\n';
    return program::misused;
  }
  if (options.time_limit) program::end_at_time_limit(options);
  chosen(options);
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  program::remove_incomplete_files_on_signals();
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "intrinsic: there is not enough memory; use a machine with more, or a smaller "
                 "mesh\n";
  } catch (const std::exception& e) {
    std::cerr << "intrinsic: " << program::legible(e.what()) << '\n';
  }
  return program::failed;
}
