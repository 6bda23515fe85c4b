// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "study_report_parts.h"

#include <algorithm>
#include <map>
#include <set>

namespace program {

namespace {

// The palette of Okabe and Ito (2008), which color-blind people can tell apart; relatives share a color
// and differ by marker and dashes. Yellow is left out: it does not show on white.
Series_style style_of(const std::string& arithmetic) {
  static const std::map<std::string, Series_style> styles = {
      {"double", {"#000000", Marker::circle, ""}},
      {"double-1e-12", {"#E69F00", Marker::circle, ""}},
      {"double-1e-6", {"#E69F00", Marker::square, "7 3"}},
      {"double-1e-5", {"#E69F00", Marker::triangle, "2 3"}},
      {"long-double", {"#777777", Marker::diamond, "7 3"}},
      {"interval", {"#56B4E9", Marker::circle, "2 3"}},
      {"boost-100", {"#009E73", Marker::square, ""}},
      {"boost-200", {"#009E73", Marker::diamond, "7 3"}},
      {"gmpq", {"#CC79A7", Marker::triangle, ""}},
      {"core-expr", {"#D55E00", Marker::triangle, ""}},
      {"lazy-core-expr", {"#D55E00", Marker::cross, "7 3"}},
      {"exact", {"#0072B2", Marker::circle, ""}},
      {"exact-integer", {"#0072B2", Marker::square, "7 3"}},
  };
  const auto i = styles.find(arithmetic);
  return i == styles.end() ? Series_style{"#999999", Marker::cross, "1 2"} : i->second;
}

// Where a job that ran out of time would be at the earliest.
std::optional<double> time_or_bound(const Study_line& l) {
  return l.status() == "timed_out" ? l.number("limits", "seconds") : l.seconds();
}

Plot_point time_point(const Study_mesh& m, const Study_line& l, const std::string& arithmetic) {
  const bool is_bound = !l.is_done();
  return {static_cast<double>(m.faces()), *time_or_bound(l),
          m.name + ", " + arithmetic + (is_bound ? ", not finished" : ""), is_bound};
}

// Times of an arithmetic in multiples of those of double, sorted.
std::vector<double> sorted_ratios(const Study_results& results, const std::string& arithmetic) {
  std::vector<double> ratios;
  for (const Study_mesh& m : results.meshes()) {
    const Study_line *const reference = m.done("double"), *const l = m.done(arithmetic);
    if (reference == nullptr || l == nullptr || !l->seconds() || !reference->seconds()) continue;
    // what takes no time that can be measured takes as long as double
    if (*reference->seconds() > 0)
      ratios.push_back(*l->seconds() / *reference->seconds());
    else
      ratios.push_back(1);
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

using Amounts = std::map<double, double>; // number of edges by amount

// Of meshes with this name but for the amount.
std::map<std::string, Amounts> non_delaunay_by_amount(const Study_results& results,
                                                      const std::string& name) {
  std::map<std::string, Amounts> counts;
  for (const Study_mesh& m : results.meshes()) {
    if (!m.amount() || m.name_without_amount() != name) continue;
    for (const auto& [a, l] : m.lines)
      if (l.number("non_delaunay_edges"))
        counts[a][*m.amount()] = static_cast<double>(l.count("non_delaunay_edges"));
  }
  return counts;
}

// Arithmetics that leave none anywhere are left out: their lines would hide each other.
std::vector<Series> stress_series(const Study_results& results, const std::string& name) {
  const auto counts = non_delaunay_by_amount(results, name);
  std::vector<Series> all;
  for (const std::string& a : results.arithmetics()) {
    const auto i = counts.find(a);
    if (i == counts.end()) continue;
    Series series{a, style_of(a), Series_kind::line_with_points, {}};
    double sum = 0;
    for (const auto& [amount, n] : i->second) {
      series.points.push_back({amount, n, a, false});
      sum += n;
    }
    if (sum > 0) all.push_back(series);
  }
  return all;
}

// Names without amount, of which there are meshes with several.
std::set<std::string> stressed_names(const Study_results& results) {
  std::map<std::string, std::set<double>> amounts;
  for (const Study_mesh& m : results.meshes())
    if (m.family != "files" && m.amount()) amounts[m.name_without_amount()].insert(*m.amount());
  std::set<std::string> names;
  for (const auto& [name, different] : amounts)
    if (different.size() > 1) names.insert(name);
  return names;
}

} // namespace

void plot_times(std::ostream& out, const Study_results& results) {
  Plot plot{"Time to build and flip", {"faces"}, {"seconds (hollow: limit reached)"}, {}};
  for (const std::string& a : results.arithmetics()) {
    Series series{a, style_of(a), Series_kind::points, {}};
    for (const Study_mesh& m : results.meshes()) {
      const Study_line* const l = m.line(a);
      if (l != nullptr && m.faces() > 0 && time_or_bound(*l).value_or(0) > 0)
        series.points.push_back(time_point(m, *l, a));
    }
    if (!series.points.empty()) plot.series.push_back(series);
  }
  if (!plot.series.empty()) write_svg(out, plot);
}

void plot_profile(std::ostream& out, const Study_results& results) {
  std::map<std::string, std::vector<double>> ratios;
  double most = 1;
  for (const std::string& a : results.arithmetics()) {
    ratios[a] = sorted_ratios(results, a);
    if (!ratios[a].empty()) most = std::max(most, ratios[a].back());
  }
  const auto meshes = static_cast<double>(ratios["double"].size());
  if (meshes == 0) return;
  Plot plot{"Share of meshes done within x times the time of double",
            {"x"},
            {"share of the meshes that double has done", false},
            {}};
  for (const std::string& a : results.arithmetics()) {
    if (ratios[a].empty()) continue;
    Series series{a, style_of(a), Series_kind::steps, {}};
    double done = 0;
    for (const double r : ratios[a]) series.points.push_back({r, ++done / meshes, "", false});
    series.points.push_back({most, done / meshes, "", false});
    plot.series.push_back(series);
  }
  write_svg(out, plot);
}

void plot_escalations(std::ostream& out, const Study_results& results) {
  Bar_chart chart{"What decided where the filter did not", "step", "predicates", {}, {}};
  std::uint64_t sum = 0;
  for (const std::string& a : results.arithmetics()) {
    if (!is_certified(a)) continue;
    Bar_chart::Bars bars{a, style_of(a), {}};
    if (a == "exact-integer") bars.style.color = "#56B4E9"; // bars have neither markers nor dashes
    chart.categories.clear();
    for (const auto& [name, n] : decided_by(results, a)) {
      chart.categories.push_back(name);
      bars.heights.push_back(static_cast<double>(n));
      sum += n;
    }
    chart.bars.push_back(bars);
  }
  if (sum > 0) write_svg(out, chart);
}

void plot_stress(std::ostream& out, const Study_results& results) {
  bool has_any = false;
  for (const std::string& name : stressed_names(results)) {
    const Plot plot{name + ": edges that are not Delaunay",
                    {"amount"},
                    {"edges of the result"},
                    stress_series(results, name)};
    if (plot.series.empty()) continue;
    has_any = true;
    write_svg(out, plot);
  }
  if (!has_any) out << "<p>None.</p>\n";
}

} // namespace program
