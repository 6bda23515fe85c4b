// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "study_report.h"
#include "html_table.h"
#include "study_report_parts.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <set>
#include <string>

namespace program {

namespace {

const char* const page_start = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Arithmetics of Delaunay flips</title>
<style>
body { font: 15px/1.45 sans-serif; color: #111; background: #fff; max-width: 1280px;
  margin: 0 auto; padding: 1em 2em 4em; }
h1, h2, h3 { line-height: 1.2; }
h2 { margin-top: 2.2em; border-bottom: 1px solid #bbb; }
p, li { max-width: 50em; }
table { border-collapse: collapse; margin: 0.8em 0; font-size: 13px; }
th, td { padding: 3px 10px; text-align: right; vertical-align: bottom; }
td { font-variant-numeric: tabular-nums; white-space: nowrap; }
th:first-child { text-align: left; }
thead th { border-bottom: 2px solid #444; max-width: 8em; }
tbody th { font-weight: normal; white-space: nowrap; }
tbody tr:nth-child(even) { background: #f3f6f8; }
.wide { overflow-x: auto; }
svg { display: block; width: 100%; max-width: 900px; margin: 1em 0; }
svg text { font: 13px sans-serif; }
summary { cursor: pointer; color: #0072B2; }
</style>
</head>
<body>
)";

std::string plural(std::size_t n, const std::string& one, const std::string& many) {
  return grouped(n) + " " + (n == 1 ? one : many);
}

// A number that people have chosen.
std::string plain(std::optional<double> x) {
  if (!x) return "unknown";
  char text[32];
  std::snprintf(text, sizeof(text), "%.6g", *x);
  return text;
}

void write_item(std::ostream& out, const std::string& text) {
  out << "<li>" << escaped(text) << "</li>\n";
}

// The limits of all jobs: results of several machines may be merged.
std::string limits(const Study_results& results) {
  std::set<std::string> different;
  for (const Study_mesh& m : results.meshes())
    for (const auto& [a, l] : m.lines)
      if (const auto s = l.number("limits", "seconds"))
        different.insert(plain(s) + " s and " + plain(l.number("limits", "mib")) + " MiB");
  std::string text;
  for (const std::string& d : different) text += (text.empty() ? "" : "; ") + d;
  return text.empty() ? "none known" : text;
}

void write_exact_items(std::ostream& out, const Study_results& results) {
  const auto common = common_meshes(results, finishing_arithmetics(results));
  for (const char* const a : {"exact", "exact-integer"}) {
    if (!results.has(a)) continue;
    std::size_t jobs = 0, done = 0, left = 0;
    for (const Study_mesh& m : results.meshes()) {
      jobs += m.line(a) != nullptr ? 1 : 0;
      done += m.done(a) != nullptr ? 1 : 0;
      if (m.done(a) != nullptr) left += m.done(a)->count("non_delaunay_edges");
    }
    std::string text = std::string(a) + " finishes " + grouped(done) + " of " +
                       plural(jobs, "mesh", "meshes") + " and leaves " +
                       plural(left, "edge that is", "edges that are") + " not Delaunay";
    if (const auto ratio = time_ratio(common, a).ratio())
      text += "; it takes " + short_number(ratio) + " times as long as double in total";
    write_item(out, text + ".");
  }
}

void write_agreement_items(std::ostream& out, const Study_results& results) {
  const Agreement agree = agreement(results, "exact", "exact-integer");
  if (agree.compared == 0) return;
  write_item(out, "exact and exact-integer have the same result on " + grouped(agree.same) +
                      " of " + plural(agree.compared, "mesh", "meshes") + ".");
  for (const std::string& name : agree.different) write_item(out, "They differ on " + name + ".");
}

// What an arithmetic did wrong in some meshes, and the mesh to name.
struct Harm {
  std::uint64_t sum = 0, most = 0;
  std::size_t meshes = 0;
  std::string worst;

  void add(std::uint64_t n, const std::string& mesh) {
    if (n == 0) return;
    sum += n;
    ++meshes;
    if (n <= most) return;
    most = n;
    worst = mesh;
  }
};

void write_harm_item(std::ostream& out, const Harm& harm, const std::string& verb,
                     const std::string& one, const std::string& many) {
  if (harm.sum > 0)
    write_item(out, verb + " " + plural(harm.sum, one, many) + " in " +
                        plural(harm.meshes, "mesh", "meshes") + ", " + grouped(harm.most) +
                        " of them in " + harm.worst + ".");
}

std::uint64_t flips_beyond_exact(const Study_mesh& m, const Study_line& l) {
  const Study_line* const exact = m.done("exact");
  if (exact == nullptr || l.count("flips") < exact->count("flips")) return 0;
  return l.count("flips") - exact->count("flips");
}

void write_unfinished_item(std::ostream& out, const Study_results& results, const std::string& a) {
  std::size_t jobs = 0, stuck = 0;
  const Study_mesh* smallest = nullptr;
  for (const Study_mesh& m : results.meshes()) {
    const Study_line* const l = m.line(a);
    if (l == nullptr || l->status() == "not_applicable" || l->status() == "refused_input") continue;
    ++jobs;
    if (l->is_done()) continue;
    ++stuck;
    if (smallest == nullptr || m.faces() < smallest->faces()) smallest = &m;
  }
  if (stuck > 0)
    write_item(out, a + " does not finish " + grouped(stuck) + " of " +
                        plural(jobs, "mesh", "meshes") + "; the smallest is " + smallest->name +
                        " with " + plural(smallest->faces(), "face", "faces") + ".");
}

void write_inexact_items(std::ostream& out, const Study_results& results) {
  for (const std::string& a : results.arithmetics()) {
    if (is_certified(a)) continue;
    Harm edges, flips, cycles;
    for (const Study_mesh& m : results.meshes()) {
      const Study_line* const l = m.line(a);
      if (l == nullptr) continue;
      edges.add(l->count("non_delaunay_edges"), m.name);
      flips.add(flips_beyond_exact(m, *l), m.name);
      cycles.add(l->count("cycles"), m.name);
    }
    write_harm_item(out, edges, a + " leaves", "edge that is not Delaunay",
                    "edges that are not Delaunay");
    write_harm_item(out, flips, a + " makes", "flip more than exact", "flips more than exact");
    write_harm_item(out, cycles, a + " undoes", "flip at once", "flips at once");
    write_unfinished_item(out, results, a);
  }
}

void write_start(std::ostream& out, const Study_results& results) {
  std::size_t jobs = 0;
  for (const Study_mesh& m : results.meshes()) jobs += m.lines.size();
  out << page_start << "<h1>Arithmetics of Delaunay flips</h1>\n<p>"
      << plural(results.meshes().size(), "mesh", "meshes") << ", "
      << plural(results.arithmetics().size(), "arithmetic", "arithmetics") << ", "
      << plural(jobs, "job", "jobs")
      << ", each in a process of its own. Limits: " << escaped(limits(results)) << ".</p>\n<ul>\n";
  write_exact_items(out, results);
  write_agreement_items(out, results);
  write_inexact_items(out, results);
  out << "</ul>\n";
}

void write_summaries(std::ostream& out, const Study_results& results) {
  out << "<h2>Summary</h2>\n<p>All that follows a decision was tested with exact arithmetic: which "
         "predicates of an arithmetic are wrong on the way, which flips were of diamonds that are "
         "not "
         "convex, and which edges of the result are not Delaunay. Drifts are the worst over "
         "meshes: "
         "of the total area, relative; of cone angles, in radians. Interval widths are "
         "relative.</p>\n";
  write_summary(out, results);
  const Study_results files = results.only_files(true), stress = results.only_files(false);
  if (files.meshes().empty() || stress.meshes().empty()) return;
  out << "<details><summary>Mesh files only</summary>\n";
  write_summary(out, files);
  out << "</details>\n<details><summary>Stress families only</summary>\n";
  write_summary(out, stress);
  out << "</details>\n";
}

// What a job that failed has to say, each message once.
void write_messages(std::ostream& out, const Study_results& results) {
  Html_table table{{"mesh", "arithmetic", "end", "message"}, {}};
  for (const Study_mesh& m : results.meshes())
    for (const std::string& a : results.arithmetics()) {
      const Study_line* const l = m.line(a);
      if (l == nullptr || (l->status() != "crashed" && l->status() != "refused_input")) continue;
      table.rows.push_back({m.name, a, l->status(), l->text("message")});
    }
  if (table.rows.empty()) return;
  out << "<h3>Crashes and refusals</h3>\n";
  write_table(out, table, 15);
}

} // namespace

void write_study_report(const std::vector<nlohmann::ordered_json>& lines, std::ostream& html) {
  const Study_results results(lines);
  write_start(html, results);
  write_summaries(html, results);
  html << "<h2>Time</h2>\n";
  plot_times(html, results);
  plot_profile(html, results);
  html << "<h2>What inexact arithmetic does</h2>\n";
  write_harm(html, results);
  html << "<h2>By amount of stress</h2>\n<p>Meshes of a stress family that differ in the amount "
          "only, and "
          "arithmetics that leave such edges. Axes are logarithmic, with a place for zero.</p>\n";
  plot_stress(html, results);
  html << "<h2>What does not finish</h2>\n<p>Meshes on which some arithmetic reached its limits, "
          "small ones first; times of those that finish.</p>\n";
  write_unfinished(html, results);
  write_messages(html, results);
  html << "<h2>What exact decisions take</h2>\n";
  write_escalations(html, results);
  plot_escalations(html, results);
  html << "</body>\n</html>\n";
}

} // namespace program
