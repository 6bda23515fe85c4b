// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "load.h"
#include "output_files.h"
#include "progress.h"
#include "report.h"
#include "statistics.h"

#include <CGAL/Intrinsic_triangulations/IO/write_intrinsic_triangulation.h>

#include <iostream>

namespace program {

namespace {

template <class Triangulation>
void delaunay(Loaded<Triangulation>& loaded, const Options& options, Progress& progress) {
  Json json = flip_and_measure(loaded, true, options, progress);
  if (const Json& count = json["delaunay"]["non_delaunay_edges"]; count != 0)
    std::cerr << options.input << ": " << count
              << " edges are not Delaunay as far as double arithmetic can tell; --arithmetic exact "
                 "decides them\n";
  Stopwatch watch;
  Output_files files;
  if (!options.output.empty()) {
    progress.show("writing");
    IT::write_intrinsic_triangulation(files.open(options.output), loaded.triangulation);
  }
  finish(json, options, files, watch);
  print_summary_on_terminal(json);
}

} // namespace

void run_delaunay(const Options& options) {
  Progress progress;
  with_loaded(options, progress, [&](auto& loaded) { delaunay(loaded, options, progress); });
}

} // namespace program
