// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report.h"

#include <iostream>
#include <stdexcept>

namespace program {

void finish(Json& json, const Options& options, Output_files& files, Stopwatch& watch) {
  json["seconds"]["write"] = watch.lap();
  json["peak_rss_mib"] = peak_rss_mib();
  const bool to_standard_output = options.stats == "-";
  if (!options.stats.empty() && !to_standard_output)
    files.open(options.stats) << json.dump(2) << '\n';
  files.commit();
  if (to_standard_output && !(std::cout << json.dump(2) << std::endl))
    throw std::runtime_error("standard output cannot be written");
}

} // namespace program
