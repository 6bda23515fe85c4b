// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "study.h"
#include "../support/progress.h"
#include "arithmetics.h"
#include "lines.h"
#include "processes.h"
#include "sources.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

using Key = std::pair<std::string, std::string>;

Key key_of(const Json& line) {
  return {line["mesh"].get<std::string>(), line["arithmetic"].get<std::string>()};
}

// Whether a job that ended so would end otherwise with these limits.
bool wants_more(const Json& line, const Study_limits& limits) {
  const Json had = line.value("limits", Json::object());
  const auto ended = [&line](const char* how) {
    return line.value("status", "") == how || line.value("comparison", "") == how;
  };
  return (ended("timed_out") && had.value("seconds", 0.0) < limits.seconds) ||
         (ended("out_of_memory") && had.value("mib", std::uint64_t{0}) < limits.mib);
}

std::vector<Study_job> missing_jobs(const Study_options& study, const std::vector<Json>& lines) {
  std::map<Key, bool> is_settled; // by the last line
  for (const Json& line : lines) is_settled[key_of(line)] = !wants_more(line, study.limits);
  std::vector<std::string> names = study.arithmetics;
  if (names.empty())
    for (const Arithmetic& a : arithmetics()) names.push_back(a.name);
  std::vector<Study_job> jobs;
  for (const Study_source& source : study_sources(study.corpus, study.domain))
    for (const std::string& arithmetic : names)
      if (!is_settled[{source.name, arithmetic}]) jobs.push_back({source, arithmetic});
  return jobs;
}

// Says how all runs of the file have ended, the last one of each mesh and arithmetic.
void print_answer(const std::vector<Json>& lines, std::size_t added, const std::string& path) {
  std::map<Key, std::string> last;
  for (const Json& line : lines) last[key_of(line)] = line["status"].get<std::string>();
  std::map<std::string, std::size_t> count;
  for (const auto& [key, status] : last) ++count[status];
  std::cout << "results         " << last.size() << ", " << added << " of them new";
  for (const auto& [status, n] : count)
    std::cout << (status == count.begin()->first ? ": " : ", ") << n << ' ' << status;
  std::cout << "\nwritten         " << path
            << ": a line for each mesh and arithmetic; workflow/study/report.py makes a page\n";
}

} // namespace

void run_study(const Study_options& study) {
  std::size_t complete = 0;
  std::vector<Json> lines;
  if (std::filesystem::exists(study.output)) lines = read_study_lines(study.output, complete);
  const std::vector<Study_job> jobs = missing_jobs(study, lines);
  Study_file file(study.output, complete);
  {
    Progress progress(false, false);
    std::size_t done = 0;
    run_study_jobs(jobs, study.jobs, study.limits, [&](const Json& findings) {
      file.append(study_line(findings));
      lines.push_back(findings);
      progress.show("studying", std::to_string(++done) + " of " + std::to_string(jobs.size()) +
                                    ", " + findings["mesh"].get<std::string>() + ' ' +
                                    findings["arithmetic"].get<std::string>());
    });
  }
  print_answer(lines, jobs.size(), study.output);
}

} // namespace program
