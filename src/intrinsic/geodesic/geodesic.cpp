// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geodesic.h"
#include "../commands.h"

#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>

#include <iostream>
#include <stdexcept>

#include <unistd.h>

namespace program {

std::string geodesic_status(IT::Status status, bool is_contracted) {
  switch (status) {
  case IT::Status::done:
    return is_contracted ? "contracted" : "geodesic";
  case IT::Status::stopped:
    return "stopped";
  case IT::Status::cancelled:
    return "cancelled";
  default:
    return "cap";
  }
}

void warn_of_cap(const Json& json, const Options& options) {
  if (json["geodesic"]["status"] == "cap")
    std::cerr << options.input << ": shortening did not end after " << json["geodesic"]["flips"]
              << " flips in double arithmetic; use --arithmetic exact\n";
}

void print_geodesic_summary_on_terminal(const Json& json) {
  if (isatty(STDERR_FILENO) == 0) return;
  const Json& g = json["geodesic"];
  std::cerr << "curves          " << g["curves"].size() << ": " << g["status"].get<std::string>()
            << (g["certified"] ? ", certified" : "") << "\nlength          " << g["length"]
            << ", before " << g["initial_length"] << "\nflips           " << g["flips"] << "; "
            << g["joints"] << " joints, " << g["exact_ties"] << " exact ties\n";
  if (json.contains("refine")) print_summary_on_terminal(json);
}

void run_geodesic(const Options& options) {
  Progress_line progress(options.logs_progress);
  with_loaded<IT::Integer_coordinates>(
      options, progress, [&](auto& loaded) { geodesic(loaded, options, progress); });
}

} // namespace program
