// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_STUDY_H
#define INTRINSIC_STUDY_STUDY_H

#include <cstdint>
#include <string>
#include <vector>

namespace program {

/// What a job of the study may take.
struct Study_limits {
  double seconds = 60;
  std::uint64_t mib = 4096;
};

/// The options of the study on the command line.
struct Study_options {
  std::vector<std::string> corpus;      ///< see `study_sources()`
  std::vector<std::string> arithmetics; ///< empty: all
  std::string domain = "auto";          ///< the surfaces of meshes, see `surface_options()`
  std::string output = "study.jsonl";   ///< where results are appended
  unsigned jobs = 1;                    ///< processes at a time
  Study_limits limits;
};

/*!
\brief runs arithmetics on meshes, and appends the results that a file does not have yet.
\throws std::exception naming what is missing, or what is wrong with the file
*/
void run_study(const Study_options& study);

/// Exit code of a job that has run out of memory, and must not allocate any more.
constexpr int exit_out_of_memory = 3;

/*!
\brief limits this process, runs a job in it, and writes results to standard output: JSON lines,
each of which contains more than the one before.
\param job one location, one arithmetic, its surface and limits
*/
void run_study_job(const Study_options& job);

} // namespace program

#endif // INTRINSIC_STUDY_STUDY_H
