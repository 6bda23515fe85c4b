// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "options.h"
#include "output_files.h"
#include "study_job.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using program::Options;
using program::Study_options;
using Command = void (*)(const Options&);

// Exit codes: valid usage that failed, and usage that is not valid.
constexpr int failed = 1, misused = 2;

CLI::Validator extension(const std::string& wanted, const std::string& what) {
  return CLI::Validator(
      [=](std::string& path) {
        return std::filesystem::path(path).extension() == wanted
                   ? std::string()
                   : path + ": this version writes " + what + ", to a file with extension " +
                         wanted + " only";
      },
      "FILE" + wanted);
}

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
      ->check(CLI::Range(0.0, 59.0));
  command.add_option("--max-circumradius", r.maximum_circumradius, "largest circumradius of faces")
      ->check(CLI::PositiveNumber);
  command.add_option("--max-edge-length", r.maximum_edge_length, "largest length of edges")
      ->check(CLI::PositiveNumber);
  command.add_option("--max-insertions", r.maximum_insertions,
                     "cap on the number of insertions; default a million and ten per face");
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
      ->check(CLI::PositiveNumber);
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

void add_study_limits(CLI::App& command, Study_options& study) {
  command
      .add_option("--time-limit", study.limits.seconds,
                  "seconds that an arithmetic may take on a mesh; default 60")
      ->check(CLI::Range(0.001, 1e9));
  command
      .add_option("--memory-limit", study.limits.mib,
                  "MiB of address space that it may take; default 4096")
      ->check(CLI::Range(std::uint64_t{64}, std::uint64_t{1} << 40U));
}

void add_study(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "study", "compare arithmetics: run each on each mesh, in a process of its own");
  Study_options& study = options.study;
  command
      .add_option("CORPUS", study.corpus,
                  "meshes, directories of meshes, stress:FAMILY[:key=value]..., or stress (the "
                  "standard list); or results (.jsonl) to be merged into a report")
      ->required();
  command
      .add_option("--arithmetic", study.arithmetics,
                  "arithmetics, separated by commas; default all")
      ->delimiter(',')
      ->check(CLI::IsMember(program::study_arithmetics()));
  command
      .add_option("-o", options.output,
                  "append results to this file, one JSON object per line, unless it has them; "
                  "default study.jsonl")
      ->check(extension(".jsonl", "JSON lines"));
  command.add_option("--report", study.report, "write a page with tables and plots")
      ->check(extension(".html", "pages"));
  command.add_option("--jobs", study.jobs, "processes at a time; default 1")
      ->check(CLI::Range(1U, 1024U));
  add_study_limits(command, study);
  command.callback([&chosen] { chosen = program::run_study; });
}

// What `study` starts for every mesh and arithmetic.
void add_study_job(CLI::App& app, Options& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand("study-job")->group("");
  command.add_option("--source", options.study.corpus)->required()->expected(1);
  command.add_option("--arithmetic", options.study.arithmetics)
      ->required()
      ->expected(1)
      ->check(CLI::IsMember(program::study_arithmetics()));
  add_study_limits(command, options.study);
  command.callback([&chosen] { chosen = program::run_study_job; });
}

bool merges_wrongly(const Options& o) {
  return program::is_study_merge(o.study) &&
         (o.study.report.empty() || !o.output.empty() ||
          !std::all_of(o.study.corpus.begin(), o.study.corpus.end(), [](const std::string& path) {
            return std::filesystem::path(path).extension() == ".jsonl";
          }));
}

bool names_a_file_twice(const Options& o) {
  std::vector<std::string> names;
  for (const std::string& name : {o.output, o.mass, o.laplacian, o.stats, o.view, o.study.report})
    if (!name.empty()) names.push_back(name);
  std::sort(names.begin(), names.end());
  return std::adjacent_find(names.begin(), names.end()) != names.end();
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
  add_delaunay(app, options, chosen);
  add_refine(app, options, chosen);
  add_laplacian(app, options, chosen);
  add_info(app, options, chosen);
  add_study(app, options, chosen);
  add_study_job(app, options, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_name() == "RequiredError" && app.get_subcommands().empty() && argc > 1) {
      std::cerr << "intrinsic: there is no command \"" << argv[1]
                << "\"; use delaunay, refine, laplacian, info or study, or --help\n";
      return misused;
    }
    return app.exit(e) == 0 ? 0 : misused;
  }
  if (names_a_file_twice(options)) {
    std::cerr << "intrinsic: two outputs have the same file name; give each its own\n";
    return misused;
  }
  if (lacks_correspondence(options)) {
    std::cerr
        << "intrinsic: without correspondence nothing is known of the common subdivision; use "
           "--correspondence integer, or write the intrinsic triangulation to .idt\n";
    return misused;
  }
  if (merges_wrongly(options)) {
    std::cerr << "intrinsic: results are merged with nothing but results, and into a report only; "
                 "use --report\n";
    return misused;
  }
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
    std::cerr << "intrinsic: " << e.what() << '\n';
  }
  return failed;
}
