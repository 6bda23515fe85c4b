// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STATISTICS_H
#define INTRINSIC_STATISTICS_H

#include "constraints.h"
#include "load.h"
#include "options.h"
#include "output_files.h"
#include "support/Json.h"
#include "support/input_name.h"
#include "support/messages.h"

#include <CGAL/Intrinsic_operators/improvement/reports.h>
#include <CGAL/Intrinsic_triangulations/support/Report.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>

#include <cstddef>

namespace program {

/// returns a report as JSON.
Json json_of(const IT::Report& report);
/// returns what changed lengths needed.
Json metric_json(const Metric_report& report);
/// returns the peak of resident memory so far, in MiB.
double peak_rss_mib();

/// returns what is known of what was loaded, and how long that took.
template <class Triangulation>
Json loaded_json(const Loaded<Triangulation>& loaded, const Options& options) {
  Json json = {{"version", INTRINSIC_TRIANGULATIONS_VERSION}};
  json.update(json_of(IT::surface_report(as_utf8(with_input_named(options.input)),
                                         loaded.triangulation, loaded.facts)));
  const Json seconds = json["seconds"];
  json.erase("seconds"); // which come last
  if (options.polygons != "fan")
    json["polygons"] = json_of(IT::polygon_report(loaded.facts.planar_polygons));
  if (!options.metric.empty()) json["metric"] = metric_json(loaded.metric);
  json["seconds"] = seconds;
  return json;
}

/// Lists have so many records in the statistics at most.
inline constexpr std::size_t most_records = 1000;

/*!
\brief completes a run: adds the last measurements, writes the statistics and, if options name a
file for them, all records, commits the files, and prints the answer and what it lacks.
\param json the statistics
\param options where they go
\param files the files written so far
\param watch started when writing began
*/
void finish(Json& json, const Options& options, Output_files& files, IT::Stopwatch& watch);

} // namespace program

#endif // INTRINSIC_STATISTICS_H
