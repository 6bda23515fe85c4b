// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "html_table.h"
#include "study_report_parts.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <tuple>

namespace program {

namespace {

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

std::string same_of(const Agreement& a) {
  return a.compared == 0 ? "\u2013" : grouped(a.same) + " of " + grouped(a.compared);
}

void write_decisions(std::ostream& out, const Study_results& results) {
  Html_table table{{"arithmetic", "flips", "different decisions", "flips not convex",
                    "refused flips", "cycles", "edges not Delaunay", "in so many meshes",
                    "same result as exact", "area drift", "cone angle drift", "interval width"},
                   {}};
  for (const std::string& a : results.arithmetics()) {
    std::vector<std::string> row = {a};
    for (const char* const key : {"flips", "different_decisions", "nonconvex_flips",
                                  "refused_flips", "cycles", "non_delaunay_edges"})
      row.push_back(grouped(total(results, a, key)));
    row.push_back(grouped(static_cast<std::uint64_t>(
        std::count_if(results.meshes().begin(), results.meshes().end(), [&](const Study_mesh& m) {
          const Study_line* const l = m.line(a);
          return l != nullptr && l->count("non_delaunay_edges") > 0;
        }))));
    row.push_back(same_of(agreement(results, a, "exact")));
    for (const char* const key : {"area_drift", "cone_angle_drift", "largest_interval_width"})
      row.push_back(short_number(worst(results, a, key), 2));
    table.rows.push_back(row);
  }
  write_table(out, table);
}

// A table of meshes by arithmetics, of the meshes with a value that is not zero, largest first.
void write_matrix(std::ostream& out, const Study_results& results,
                  const std::vector<std::string>& columns,
                  const std::function<std::int64_t(const Study_mesh&, const std::string&)>& value) {
  using Row = std::tuple<std::int64_t, std::string, std::vector<std::string>>;
  std::vector<Row> rows;
  for (const Study_mesh& m : results.meshes()) {
    Row row{0, m.name, {m.name, grouped(m.faces())}};
    for (const std::string& a : columns) {
      const std::int64_t x = value(m, a);
      const auto size = static_cast<std::uint64_t>(x < 0 ? -x : x);
      std::get<0>(row) = std::min(std::get<0>(row), -static_cast<std::int64_t>(size));
      std::get<2>(row).push_back(x == 0 ? "" : (x < 0 ? "\u2212" : "") + grouped(size));
    }
    if (std::get<0>(row) != 0) rows.push_back(row);
  }
  std::sort(rows.begin(), rows.end());
  if (rows.empty()) {
    out << "<p>None.</p>\n";
    return;
  }
  Html_table table{{"mesh", "faces"}, {}};
  table.head.insert(table.head.end(), columns.begin(), columns.end());
  for (Row& row : rows) table.rows.push_back(std::move(std::get<2>(row)));
  write_table(out, table, 25);
}

std::int64_t extra_flips(const Study_mesh& m, const std::string& arithmetic) {
  const Study_line* const l = m.line(arithmetic);
  const Study_line* const exact = m.done("exact");
  if (l == nullptr || exact == nullptr || !l->number("flips")) return 0;
  return static_cast<std::int64_t>(l->count("flips")) -
         static_cast<std::int64_t>(exact->count("flips"));
}

std::string how_it_ended(const Study_line* l) {
  if (l == nullptr) return "";
  if (l->is_done()) return short_number(l->seconds(), 2) + " s";
  std::string words = l->status();
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

bool is_unfinished(const Study_line& l) {
  const std::string s = l.status();
  return s == "timed_out" || s == "out_of_memory" || s == "crashed" || s == "cap";
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

void write_harm(std::ostream& out, const Study_results& results) {
  std::vector<std::string> inexact;
  for (const std::string& a : results.arithmetics())
    if (!is_certified(a) && !is_naive_exact(a)) inexact.push_back(a);
  const auto counts = [](const char* key) {
    return [key](const Study_mesh& m, const std::string& a) {
      const Study_line* const l = m.line(a);
      return l == nullptr ? 0 : static_cast<std::int64_t>(l->count(key));
    };
  };
  out << "<h3>Edges of the result that are not Delaunay</h3>\n";
  write_matrix(out, results, inexact, counts("non_delaunay_edges"));
  out << "<h3>Flips more, or fewer, than with exact predicates</h3>\n";
  write_matrix(out, results, inexact, extra_flips);
  out << "<h3>Cycles: flips that undo the last flip of the same edge</h3>\n";
  write_matrix(out, results, inexact, counts("cycles"));
  out << "<h3>Flips of diamonds that are not convex</h3>\n";
  write_matrix(out, results, inexact, counts("nonconvex_flips"));
}

void write_unfinished(std::ostream& out, const Study_results& results) {
  std::set<std::string> shown = {"double", "exact"};
  std::vector<const Study_mesh*> meshes;
  for (const Study_mesh& m : results.meshes()) {
    bool is_listed = false;
    for (const auto& [a, l] : m.lines)
      if (is_unfinished(l)) {
        shown.insert(a);
        is_listed = true;
      }
    if (is_listed) meshes.push_back(&m);
  }
  if (meshes.empty()) {
    out << "<p>All arithmetics finished everything that they apply to.</p>\n";
    return;
  }
  std::stable_sort(meshes.begin(), meshes.end(), [](const Study_mesh* a, const Study_mesh* b) {
    return a->faces() < b->faces();
  });
  Html_table table{{"mesh", "faces"}, {}};
  for (const Study_mesh* const m : meshes) table.rows.push_back({m->name, grouped(m->faces())});
  for (const std::string& a : results.arithmetics()) {
    if (!shown.contains(a)) continue;
    table.head.push_back(a);
    for (std::size_t i = 0; i < meshes.size(); ++i)
      table.rows[i].push_back(how_it_ended(meshes[i]->line(a)));
  }
  write_table(out, table, 25);
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
