// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "statistics.h"
#include "answers.h"
#include "summary.h"
#include "support/Figures.h"
#include "support/warnings.h"

#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>

#include <cstddef>
#include <iterator>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <sys/resource.h>

namespace program {

Json json_of(const IT::Report& report) {
  return std::visit(
      []<class Value>(const Value& x) -> Json {
        if constexpr (std::is_same_v<Value, std::monostate>) {
          return nullptr;
        } else if constexpr (std::is_same_v<Value, IT::Report::Figures>) {
          Json json = Json::object();
          for (const IT::Report::Figure& f : x) json[f.name] = json_of(f.value);
          return json;
        } else if constexpr (std::is_same_v<Value, IT::Report::List>) {
          Json json = Json::array();
          for (const IT::Report& r : x) json.push_back(json_of(r));
          return json;
        } else {
          return x;
        }
      },
      report.value());
}

Json metric_json(const Metric_report& report) {
  return {{"violating_faces", report.violating_faces},
          {"changed_edges", report.changed_edges},
          {"largest_relative_change", report.largest_relative_change}};
}

double peak_rss_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

namespace {

// Calls a function with the lists of records, and the long lists of numbers, and their names.
template <class Any_json, class Function>
void for_each_list(Any_json& json, const std::string& name, const Function& function) {
  for (auto& [key, value] : json.items()) {
    const std::string full = name.empty() ? key : name + "." + key;
    if (value.is_object()) for_each_list(value, full, function);
    if (value.is_array() && !value.empty() &&
        (value.front().is_object() || value.size() > most_records))
      function(full, value);
  }
}

// Writes each record as a line, with its list and its number there.
void write_records(std::ostream& out, const std::string& list, const Json& records) {
  for (std::size_t i = 0; i < records.size(); ++i) {
    Json line = {{"list", list}, {"number", i}};
    if (records[i].is_object())
      line.update(records[i]);
    else
      line["value"] = records[i];
    out << line.dump() << '\n';
  }
}

// Writes all records to a file if options name one. Returns the statistics with the first records
// of long lists, and how many there are.
Json with_short_lists(const Json& json, const Options& options, Output_files& files) {
  Json result = json;
  Json sizes = Json::object();
  for_each_list(result, "", [&](const std::string& name, Json& records) {
    if (records.size() <= most_records) return;
    sizes[name] = records.size();
    records.erase(std::next(records.begin(), most_records), records.end());
  });
  if (!sizes.empty()) result["records"] = std::move(sizes);
  if (options.records.empty()) return result;
  files.write(options.records, [&](std::ostream& out) {
    for_each_list(json, "", [&](const std::string& name, const Json& records) {
      write_records(out, name, records);
    });
  });
  return result;
}

} // namespace

void finish(Json& json, const Options& options, Output_files& files, IT::Stopwatch& watch) {
  json["seconds"]["write"] = watch.lap();
  json["peak_rss_mib"] = peak_rss_mib();
  const Json shown = with_short_lists(json, options, files);
  if (!options.stats.empty()) files.open(options.stats) << shown.dump(2) << '\n';
  for (const std::string& warning : warnings_of(Figures(json), options)) warn(warning);
  const std::vector<std::string> written = files.paths();
  files.commit();
  print_answer(json, options, written);
  print_warnings(options);
}

} // namespace program
