// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_OPTIONS_H
#define INTRINSIC_STUDY_OPTIONS_H

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
  std::string domain = "auto";          ///< the surfaces of meshes, see `surface_named()`
  std::string output = "study.jsonl";   ///< where results are appended
  unsigned jobs = 1;                    ///< processes at a time
  Study_limits limits;
};

} // namespace program

#endif // INTRINSIC_STUDY_OPTIONS_H
