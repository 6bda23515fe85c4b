// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "delaunay.h"
#include "commands.h"

#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>

#include <string>

namespace program {

// with correspondences, and hashes, that the program `intrinsic-applications` has
void run_delaunay_elsewhere(const Options& options);

void run_delaunay(const Options& options) {
  const bool is_stored = is_triangulation_file(options.input);
  const std::string& asked = options.correspondence;
  const bool is_needed = !is_stored || needs_correspondence(options) || asked == "integer";
  // of a stored triangulation, coordinates tell where edges of the input are
  const bool tells_constraints = is_stored && has_constraints(options);
  if (!tells_constraints && (asked == "none" || !is_needed))
    run_delaunay_with<IT::No_correspondence>(options);
  else if (asked == "crossings" || asked == "signposts")
    run_delaunay_elsewhere(options);
  else
    run_delaunay_with<IT::Integer_coordinates>(options);
}

void run_info(const Options& options) {
  if (options.hashes) return run_delaunay_elsewhere(options);
  Progress progress(options.logs_progress, options.is_quiet);
  with_loaded(options, progress, [&](auto& loaded) {
    Options as_it_is = options;
    as_it_is.no_flip = true;
    Json json = improve_and_measure(loaded, as_it_is, progress);
    IT::Stopwatch watch;
    Output_files files;
    finish(json, options, files, watch);
  });
}

} // namespace program
