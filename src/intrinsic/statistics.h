// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STATISTICS_H
#define INTRINSIC_STATISTICS_H

#include "constraints.h"
#include "load.h"
#include "options.h"
#include "output_files.h"

#include <CGAL/Intrinsic_operators/improvement/Improvement.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>

namespace program {

/// JSON with keys in the order in which they are set. Numbers that are not finite become null.
using Json = nlohmann::ordered_json;

/// returns what is known of input and mollification, and the program's version.
Json input_json(const Options& options, const std::string& arithmetic,
                const std::string& correspondence, const Input_facts& facts,
                const IT::Input_report& report);
/// returns which surface was made of the file, and why.
Json domain_json(const IT::Domain_report& report,
                 const std::optional<IT::Point_cloud_report>& cloud, std::size_t vertices);
/// returns what was made of polygons.
Json polygons_json(const IT::Polygon_report& report);
/// returns what changed lengths needed.
Json metric_json(const Metric_report& report);
/// adds what was done to a triangulation.
void add_improvement(Json& json, const IT::Improvement& done, const Options& options);
/// adds what was measured after that.
/// \param input_area from points, as `IT::area_of_points()` finds it
void add_measurements(Json& json, const IT::Measurements& measured, const IT::Improvement& done,
                      const Constraints& constraints, double input_area, bool is_exact);
/// returns the peak of resident memory so far, in MiB.
double peak_rss_mib();

/// returns what is known of what was loaded, and how long that took.
template <class Triangulation>
Json loaded_json(const Loaded<Triangulation>& loaded, const Options& options) {
  const Triangulation& t = loaded.triangulation;
  Json json = input_json(options, Triangulation::Metric::is_exact ? "exact" : "double",
                         Triangulation::Correspondence::name, loaded.facts, t.report());
  if (!loaded.domain.reason.empty())
    json["domain"] = domain_json(loaded.domain, loaded.cloud, t.input().number_of_rows());
  else if (t.input().names().is_cover())
    json["domain"] = {{"kind", "stored"},
                      {"reason", "the file has a cover"},
                      {"sheets", t.input().names().sheets},
                      {"vertices", t.input().number_of_rows()}};
  if (options.polygons != "fan") json["polygons"] = polygons_json(loaded.polygons);
  if (!options.metric.empty()) json["metric"] = metric_json(loaded.metric);
  json["seconds"] = {{"read", loaded.seconds.read},
                     {"build", loaded.seconds.build},
                     {"topology", loaded.seconds.topology}};
  return json;
}

/// prints statistics for people.
void print_summary(std::ostream& out, const Json& json);
/// prints the summary to standard error if that is a terminal.
void print_summary_on_terminal(const Json& json);

/// Lists have so many records in the statistics at most.
inline constexpr std::size_t most_records = 1000;

/*!
\brief completes all outputs: adds the last measurements, writes the statistics and, if options name
a file for them, all records, and commits the files.
\param json the statistics
\param options where they go
\param files the files written so far
\param watch started when writing began
*/
void finish(Json& json, const Options& options, Output_files& files, Stopwatch& watch);

} // namespace program

#endif // INTRINSIC_STATISTICS_H
