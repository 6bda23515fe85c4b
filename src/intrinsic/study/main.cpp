// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../support/command_line.h"
#include "../support/surface_words.h"
#include "arithmetics.h"
#include "study.h"

#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

// The program `intrinsic-study`, which `intrinsic study` starts.

namespace {

using program::Study_options;

CLI::Validator is_arithmetic() {
  std::vector<std::string> names;
  for (const program::Arithmetic& a : program::arithmetics()) names.push_back(a.name);
  return CLI::IsMember(names);
}

CLI::Validator is_no_result() {
  return CLI::Validator(
      [](std::string& path) {
        return std::filesystem::path(path).extension() == ".jsonl"
                   ? path + ": results are no meshes; workflow/study/report.py makes a page of them"
                   : std::string();
      },
      "");
}

// The surfaces of meshes, and what an arithmetic may take on one.
void add_common(const program::Option_adder& add, Study_options& study) {
  add("--domain", study.domain, {CLI::IsMember(program::surface_words)},
      program::surface_description);
  add("--time-limit", study.limits.seconds, {program::in_range({0.001, 1e9})},
      "seconds that an arithmetic may take on a mesh; default 60");
  add("--memory-limit", study.limits.mib, {CLI::Range(std::uint64_t{64}, std::uint64_t{1} << 40U)},
      "MiB of address space that it may take; default 4096");
}

CLI::Validator lines_file() {
  return CLI::Validator(
      [](std::string& path) {
        return std::filesystem::path(path).extension() == ".jsonl"
                   ? std::string()
                   : path + ": write JSON lines to a file with extension .jsonl";
      },
      "FILE.jsonl");
}

void add_options(CLI::App& app, Study_options& study) {
  app.set_version_flag("--version", std::string("intrinsic ") + INTRINSIC_TRIANGULATIONS_VERSION);
  const program::Option_adder add(app);
  add("CORPUS", study.corpus, {is_no_result()},
      "meshes, directories of meshes, stress:FAMILY[:key=value]..., or stress (the standard list)")
      ->required();
  add("--arithmetic", study.arithmetics, {is_arithmetic()},
      "arithmetics, separated by commas; default all")
      ->delimiter(',');
  add("-o", study.output, {lines_file()},
      "append results to this file, one JSON object per line, unless it has them; default "
      "study.jsonl");
  add("--jobs", study.jobs, {CLI::Range(1U, 1024U)}, "processes at a time; default 1");
  add_common(add, study);
}

// What this program starts of itself for every mesh and arithmetic.
void add_job_options(CLI::App& app, Study_options& study) {
  const program::Option_adder add(app);
  app.add_flag("--job")->required();
  add("--source", study.corpus, "")->required()->expected(1);
  add("--arithmetic", study.arithmetics, {is_arithmetic()}, "")->required()->expected(1);
  add_common(add, study);
}

int run(int argc, char** argv) {
  const bool is_job = argc > 1 && std::string(argv[1]) == "--job";
  CLI::App app("Compares arithmetics: runs each on each mesh, in a process of its own. "
               "workflow/study/report.py makes a page of the results.",
               "intrinsic study");
  Study_options study;
  (is_job ? add_job_options : add_options)(app, study);
  app.get_formatter()->column_width(32);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : program::misused;
  }
  if (is_job)
    program::run_study_job(study);
  else
    program::run_study(study);
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& e) {
    std::cerr << "intrinsic study: " << e.what() << '\n';
  }
  return program::failed;
}
