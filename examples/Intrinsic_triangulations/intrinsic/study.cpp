// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "output_files.h"
#include "progress.h"
#include "study_job.h"
#include "study_lines.h"
#include "study_processes.h"
#include "study_report.h"
#include "study_sources.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>

namespace program {

namespace {

using Key = std::pair<std::string, std::string>;

Key key_of(const Json& line) {
  return {line["mesh"].get<std::string>(), line["arithmetic"].get<std::string>()};
}

bool is_results_file(const std::string& path) {
  return std::filesystem::path(path).extension() == ".jsonl";
}

void write_report(const std::vector<Json>& lines, const std::string& path) {
  if (path.empty()) return;
  Output_files files;
  write_study_report(lines, files.open(path));
  files.commit();
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
  const std::vector<std::string> arithmetics =
      study.arithmetics.empty() ? study_arithmetics() : study.arithmetics;
  std::vector<Study_job> jobs;
  for (const Study_source& source : study_sources(study.corpus))
    for (const std::string& arithmetic : arithmetics)
      if (!is_settled[{source.name, arithmetic}]) jobs.push_back({source, arithmetic});
  return jobs;
}

void merge(const Study_options& study) {
  std::vector<Json> lines;
  for (const std::string& path : study.corpus) {
    std::size_t complete = 0;
    for (Json& line : read_study_lines(path, complete)) lines.push_back(std::move(line));
  }
  write_report(lines, study.report);
}

} // namespace

bool is_study_merge(const Study_options& study) {
  return std::any_of(study.corpus.begin(), study.corpus.end(), is_results_file);
}

void run_study(const Options& options) {
  const Study_options& study = options.study;
  if (is_study_merge(study)) {
    merge(study);
    return;
  }
  const std::string path = options.output.empty() ? "study.jsonl" : options.output;
  std::size_t complete = 0;
  std::vector<Json> lines;
  if (std::filesystem::exists(path)) lines = read_study_lines(path, complete);
  const std::vector<Study_job> jobs = missing_jobs(study, lines);
  Study_file file(path, complete);
  Progress progress;
  std::size_t done = 0;
  run_study_jobs(jobs, study.jobs, study.limits, [&](const Json& findings) {
    file.append(study_line(findings));
    lines.push_back(findings);
    progress.show("studying: " + std::to_string(++done) + " of " + std::to_string(jobs.size()) +
                  ", " + findings["mesh"].get<std::string>() + ' ' +
                  findings["arithmetic"].get<std::string>());
  });
  write_report(lines, study.report);
}

void run_study_job(const Options& options) {
  const Study_options& study = options.study;
  run_study_job(study.corpus.at(0), study.arithmetics.at(0), study.limits);
}

} // namespace program
