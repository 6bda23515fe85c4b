// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "improve.h"
#include "load.h"
#include "output_files.h"
#include "statistics.h"
#include "support/progress.h"

#include <iostream>
#include <stdexcept>

namespace program {

void run_info(const Options& options) {
  Progress_line progress(options.logs_progress);
  with_loaded(options, progress, [&](auto& loaded) {
    Options as_it_is = options;
    as_it_is.no_flip = true;
    Json json = improve_and_measure(loaded, as_it_is, progress);
    Stopwatch watch;
    Output_files files;
    finish(json, options, files, watch);
    if (!options.stats.empty()) return;
    print_summary(std::cout, json);
    if (!std::cout.flush())
      throw std::runtime_error("standard output cannot be written; is the disk full?");
  });
}

} // namespace program
