// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "html_table.h"
#include "study_report_parts.h"

#include <algorithm>
#include <map>

namespace program {

namespace {

const char* const unknown = "\u2013";

// Sums of a key over all lines of an arithmetic that have it.
std::uint64_t total(const Study_results& results, const std::string& arithmetic, const char* key) {
  std::uint64_t sum = 0;
  for (const Study_mesh& m : results.meshes())
    if (const Study_line* const l = m.line(arithmetic)) sum += l->count(key);
  return sum;
}

std::optional<double> worst(const Study_results& results, const std::string& arithmetic,
                            const char* key) {
  std::optional<double> most;
  for (const Study_mesh& m : results.meshes())
    if (const Study_line* const l = m.line(arithmetic))
      if (const auto x = l->number(key)) most = std::max(most.value_or(*x), *x);
  return most;
}

std::size_t number_of(const Study_results& results, const std::string& arithmetic,
                      const char* status) {
  return static_cast<std::size_t>(
      std::count_if(results.meshes().begin(), results.meshes().end(), [&](const Study_mesh& m) {
        const Study_line* const l = m.line(arithmetic);
        return l != nullptr && l->status() == status;
      }));
}

std::size_t jobs(const Study_results& results, const std::string& arithmetic) {
  return static_cast<std::size_t>(
      std::count_if(results.meshes().begin(), results.meshes().end(),
                    [&](const Study_mesh& m) { return m.line(arithmetic) != nullptr; }));
}

std::vector<const Study_mesh*> all_meshes(const Study_results& results) {
  std::vector<const Study_mesh*> meshes;
  for (const Study_mesh& m : results.meshes()) meshes.push_back(&m);
  return meshes;
}

void write_ends(std::ostream& out, const Study_results& results) {
  const char* const statuses[] = {
      "done", "cap", "timed_out", "out_of_memory", "crashed", "not_applicable", "refused_input"};
  Html_table table{{"arithmetic", "jobs", "done", "cap on flips", "timed out", "out of memory",
                    "crashed", "not applicable", "input refused", "largest memory (MiB)"},
                   {}};
  for (const std::string& a : results.arithmetics()) {
    std::vector<std::string> row = {a, grouped(jobs(results, a))};
    for (const char* const status : statuses) row.push_back(grouped(number_of(results, a, status)));
    row.push_back(short_number(worst(results, a, "peak_rss_mib")));
    table.rows.push_back(row);
  }
  write_table(out, table);
}

void write_times(std::ostream& out, const Study_results& results) {
  const std::vector<std::string> finishing = finishing_arithmetics(results);
  const std::vector<const Study_mesh*> common = common_meshes(results, finishing);
  out << "<p>Seconds of building and flipping, without any of the comparisons. <i>Common</i> "
         "meshes "
         "are those done by every arithmetic that has done nine meshes in ten; there are "
      << grouped(common.size()) << ".</p>\n";
  Html_table table{{"arithmetic", "time on common (s)", "ratio to double",
                    "ratio to double where done", "over so many meshes"},
                   {}};
  for (const std::string& a : results.arithmetics()) {
    const bool finishes = std::find(finishing.begin(), finishing.end(), a) != finishing.end();
    const Time_ratio c = time_ratio(common, a), own = time_ratio(all_meshes(results), a);
    const auto if_finishing = [finishes](std::optional<double> x) {
      return short_number(finishes ? x : std::nullopt);
    };
    table.rows.push_back({a, if_finishing(c.seconds), if_finishing(c.ratio()),
                          short_number(own.ratio()), grouped(own.meshes)});
  }
  write_table(out, table);
}

std::string share_of(std::size_t some, std::size_t all) {
  return all == 0 ? unknown : grouped(some) + " of " + grouped(all);
}

// Comparisons end early where the exact metric cannot follow, or at limits.
std::string compared_to_the_end(const Study_results& results, const std::string& arithmetic) {
  std::size_t all = 0, complete = 0;
  for (const Study_mesh& m : results.meshes()) {
    const Study_line* const l = m.line(arithmetic);
    if (l == nullptr || l->text("comparison").empty()) continue;
    ++all;
    complete += l->text("comparison") == "complete" ? 1 : 0;
  }
  return share_of(complete, all);
}

void write_decisions(std::ostream& out, const Study_results& results) {
  Html_table table{{"arithmetic", "flips", "different decisions", "flips not convex",
                    "refused flips", "cycles", "inverted faces", "edges not Delaunay",
                    "in so many meshes", "compared to the end", "same result as exact",
                    "area drift", "cone angle drift", "interval width"},
                   {}};
  for (const std::string& a : results.arithmetics()) {
    std::vector<std::string> row = {a};
    for (const char* const key :
         {"flips", "different_decisions", "nonconvex_flips", "refused_flips", "cycles",
          "inverted_faces", "non_delaunay_edges"})
      row.push_back(grouped(total(results, a, key)));
    row.push_back(grouped(static_cast<std::uint64_t>(
        std::count_if(results.meshes().begin(), results.meshes().end(), [&](const Study_mesh& m) {
          const Study_line* const l = m.line(a);
          return l != nullptr && l->count("non_delaunay_edges") > 0;
        }))));
    row.push_back(compared_to_the_end(results, a));
    const Agreement agree = agreement(results, a, "exact");
    row.push_back(share_of(agree.same, agree.compared));
    for (const char* const key : {"area_drift", "cone_angle_drift", "largest_interval_width"})
      row.push_back(short_number(worst(results, a, key), 2));
    table.rows.push_back(row);
  }
  write_table(out, table);
}

} // namespace

std::vector<std::string> finishing_arithmetics(const Study_results& results) {
  std::vector<std::string> names;
  for (const std::string& a : results.arithmetics())
    if (10 * number_of(results, a, "done") >= 9 * results.meshes().size()) names.push_back(a);
  return names;
}

std::vector<const Study_mesh*> common_meshes(const Study_results& results,
                                             const std::vector<std::string>& arithmetics) {
  std::vector<const Study_mesh*> meshes = all_meshes(results);
  std::erase_if(meshes, [&](const Study_mesh* m) {
    return arithmetics.empty() ||
           !std::all_of(arithmetics.begin(), arithmetics.end(), [m](const std::string& a) {
             return m->done(a) != nullptr && m->done(a)->seconds();
           });
  });
  return meshes;
}

Time_ratio time_ratio(const std::vector<const Study_mesh*>& meshes, const std::string& arithmetic) {
  Time_ratio result;
  for (const Study_mesh* const m : meshes) {
    const Study_line *const l = m->done(arithmetic), *const reference = m->done("double");
    if (l == nullptr || !l->seconds()) continue;
    if (reference == nullptr || !reference->seconds()) continue;
    ++result.meshes;
    result.seconds += *l->seconds();
    result.reference += *reference->seconds();
  }
  return result;
}

Agreement agreement(const Study_results& results, const std::string& a, const std::string& b) {
  Agreement agreement;
  for (const Study_mesh& m : results.meshes()) {
    const Study_line *const x = m.done(a), *const y = m.done(b);
    if (x == nullptr || y == nullptr || x->text("result").empty() || y->text("result").empty())
      continue;
    ++agreement.compared;
    if (x->text("result") == y->text("result")) {
      ++agreement.same;
    } else {
      agreement.different.push_back(m.name);
    }
  }
  return agreement;
}

void write_summary(std::ostream& out, const Study_results& results) {
  write_ends(out, results);
  write_times(out, results);
  write_decisions(out, results);
}

Decided_by decided_by(const Study_results& results, const std::string& arithmetic) {
  std::map<unsigned, std::uint64_t> bits;
  for (const Study_mesh& m : results.meshes())
    for (const auto& [a, l] : m.lines)
      for (const auto& [b, n] : l.escalations()) bits[b] += a == arithmetic ? n : 0;
  Decided_by steps = {{"integers", total(results, arithmetic, "integer")}};
  for (const auto& [b, n] : bits) steps.emplace_back(std::to_string(b) + " bits", n);
  steps.emplace_back("zero, proven", total(results, arithmetic, "certified_zero"));
  steps.emplace_back("zero, probably", total(results, arithmetic, "probable_zero"));
  steps.emplace_back("undecided", total(results, arithmetic, "undecided"));
  return steps;
}

void write_escalations(std::ostream& out, const Study_results& results) {
  Html_table table{{"arithmetic", "checks", "filter failures"}, {}};
  for (const std::string& a : results.arithmetics()) {
    if (total(results, a, "filter_failures") == 0 && !is_certified(a)) continue;
    std::vector<std::string> row = {a, grouped(total(results, a, "checks")),
                                    grouped(total(results, a, "filter_failures"))};
    const Decided_by steps = decided_by(results, a);
    for (const auto& [name, n] : steps) row.push_back(grouped(n));
    if (table.rows.empty())
      for (const auto& [name, n] : steps) table.head.push_back(name);
    table.rows.push_back(row);
  }
  if (!table.rows.empty()) write_table(out, table);
}

} // namespace program
