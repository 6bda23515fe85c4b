// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "options.h"
#include "output_files.h"
#include "support/command_line.h"
#include "time_limit.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using program::extension;
using program::Options;
using Command = void (*)(const Options&);

CLI::Validator triangulation_or_mesh() {
  return CLI::Validator(
      [](std::string& path) {
        const std::string extension = std::filesystem::path(path).extension().string();
        return extension == ".idt" || IT::is_common_subdivision_extension(extension)
                   ? std::string()
                   : path + ": the format is not offered; write the common subdivision to .ply, "
                            ".obj, .off, .stl or .vtp, or the intrinsic triangulation to .idt";
      },
      "FILE");
}

void add_common_options(CLI::App& command, Options& options) {
  command
      .add_option("IN", options.input,
                  "mesh (.off .obj .ply .stl .ts) or intrinsic triangulation (.idt)")
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
  command.add_option("--stats", options.stats, "write statistics as JSON; - is standard output")
      ->type_name("FILE");
  command
      .add_option("--time-limit", options.time_limit,
                  "seconds after which the program gives up, with exit code 1, and writes nothing")
      ->check(program::between(1e-6, 1e9))
      ->type_name("SECONDS");
  command.add_flag("--progress", options.logs_progress,
                   "write lines of what is being done to standard error");
}

// where edges run on the input, and what is written of it
void add_correspondence_options(CLI::App& command, Options& options) {
  command
      .add_option("--correspondence", options.correspondence,
                  "what is kept of where edges run on the input: integer (coordinates, default), "
                  "signposts, crossings or none")
      ->check(CLI::IsMember({"none", "integer", "signposts", "crossings"}));
  command
      .add_option("-o", options.output,
                  "write the common subdivision (.ply .obj .off .stl .vtp) or the intrinsic "
                  "triangulation (.idt)")
      ->check(triangulation_or_mesh());
  command.add_option("--view", options.view, "write a page that shows the triangulation")
      ->type_name("FILE");
}

void add_delaunay(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command =
      *app.add_subcommand("delaunay", "flip to the intrinsic Delaunay triangulation");
  add_common_options(command, options);
  add_correspondence_options(command, options);
  command.callback([&chosen] { chosen = program::run_delaunay; });
}

void add_refine(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "refine", "insert vertices until all faces are well shaped, keeping the Delaunay property");
  add_common_options(command, options);
  add_correspondence_options(command, options);
  program::Refinement_criteria& r = options.refinement;
  command.add_option("--min-angle", r.minimum_angle, "least angle in degrees; default 30")
      ->check(program::between(0, 59));
  command.add_option("--max-circumradius", r.maximum_circumradius, "largest circumradius of faces")
      ->check(program::positive());
  command.add_option("--max-edge-length", r.maximum_edge_length, "largest length of edges")
      ->check(program::positive());
  command
      .add_option("--max-insertions", r.maximum_insertions,
                  "cap on the number of insertions; default a million and ten per face")
      ->check(program::between(0, 1e18));
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
  command
      .add_option(
          "--odt", options.odt_length,
          "then move inserted vertices to an optimal Delaunay triangulation, and split edges "
          "longer than this")
      ->check(program::positive());
  command
      .add_option("--laplacian", options.laplacian,
                  "write the Laplacian of the refined triangulation in Matrix Market format")
      ->check(extension(".mtx", "matrices in Matrix Market format"));
  command.callback([&options, &chosen] {
    options.refines = true;
    chosen = program::run_delaunay;
  });
}

void add_laplacian(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "laplacian", "write the cotangent Laplacian of the intrinsic Delaunay triangulation");
  add_common_options(command, options);
  command.add_option("-o", options.output, "write the Laplacian in Matrix Market format")
      ->check(extension(".mtx", "matrices in Matrix Market format"));
  command.add_option("--mass", options.mass, "write the mass matrix in Matrix Market format")
      ->check(extension(".mtx", "matrices in Matrix Market format"));
  command.add_option("--mass-kind", options.mass_kind, "lumped (diagonal, default) or galerkin")
      ->check(CLI::IsMember({"lumped", "galerkin"}));
  command.add_flag("--no-flip", options.no_flip, "take the triangulation as it is");
  command.callback([&chosen] { chosen = program::run_laplacian; });
}

void add_info(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "info", "describe a mesh or an intrinsic triangulation as it is, and tell "
              "whether it is Delaunay");
  add_common_options(command, options);
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

// However they are spelled, and through links.
bool names_a_file_twice(const Options& o) {
  std::vector<std::filesystem::path> paths;
  for (const std::string& name : {o.output, o.mass, o.laplacian, o.stats, o.view})
    if (!name.empty() && name != "-")
      paths.push_back(std::filesystem::weakly_canonical(std::filesystem::absolute(name)));
  std::sort(paths.begin(), paths.end());
  return std::adjacent_find(paths.begin(), paths.end()) != paths.end();
}

bool lacks_correspondence(const Options& o) {
  return o.correspondence == "none" && (program::is_mesh_output(o) || !o.view.empty());
}

int run(int argc, char** argv) {
  Options options;
  Command chosen = nullptr;
  CLI::App app("Intrinsic triangulations of triangle meshes, with exact predicates", "intrinsic");
  app.set_version_flag("--version", std::string("intrinsic ") + INTRINSIC_TRIANGULATIONS_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(32);
  app.failure_message([](const CLI::App* a, const CLI::Error& e) {
    return program::legible(CLI::FailureMessage::simple(a, e), program::longest_argument);
  });
  add_delaunay(app, options, chosen);
  add_refine(app, options, chosen);
  add_laplacian(app, options, chosen);
  add_info(app, options, chosen);
  add_study(app, options, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_name() == "RequiredError" && app.get_subcommands().empty() && argc > 1) {
      std::cerr << "intrinsic: there is no command \""
                << program::legible(argv[1], program::longest_argument)
                << "\"; use delaunay, refine, laplacian, info or study, or --help\n";
      return program::misused;
    }
    return app.exit(e) == 0 ? 0 : program::misused;
  }
  if (names_a_file_twice(options)) {
    std::cerr << "intrinsic: two outputs are the same file; give each its own\n";
    return program::misused;
  }
  if (lacks_correspondence(options)) {
    std::cerr
        << "intrinsic: without correspondence nothing is known of the common subdivision; use "
           "--correspondence integer, or write the intrinsic triangulation to .idt\n";
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
