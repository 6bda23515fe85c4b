// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "html_table.h"
#include "study_report_parts.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <set>
#include <tuple>

// Tables with meshes as rows and arithmetics as columns.

namespace program {

namespace {

// Nothing where there is nothing to say.
using Cell = std::optional<std::int64_t>;

std::string text_of(const Cell& cell, bool is_done) {
  if (!cell) return is_done ? "?" : "";
  if (*cell == 0) return "";
  const std::int64_t x = *cell;
  return (x < 0 ? "\u2212" : "") + grouped(static_cast<std::uint64_t>(x < 0 ? -x : x));
}

// A table of meshes by arithmetics, of the meshes with a value that is not zero, largest first.
void write_matrix(std::ostream& out, const Study_results& results,
                  const std::vector<std::string>& columns,
                  const std::function<Cell(const Study_mesh&, const std::string&)>& value) {
  using Row = std::tuple<std::int64_t, std::string, std::vector<std::string>>;
  std::vector<Row> rows;
  for (const Study_mesh& m : results.meshes()) {
    Row row{0, m.name, {m.name, grouped(m.faces())}};
    for (const std::string& a : columns) {
      const Cell x = value(m, a);
      std::get<0>(row) = std::min(std::get<0>(row), -std::abs(x.value_or(0)));
      std::get<2>(row).push_back(text_of(x, m.done(a) != nullptr));
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

Cell extra_flips(const Study_mesh& m, const std::string& arithmetic) {
  const Study_line* const l = m.line(arithmetic);
  const Study_line* const exact = m.done("exact");
  if (l == nullptr || exact == nullptr || !l->number("flips")) return std::nullopt;
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

void write_harm(std::ostream& out, const Study_results& results) {
  std::vector<std::string> inexact;
  for (const std::string& a : results.arithmetics())
    if (!is_certified(a) && !is_naive_exact(a)) inexact.push_back(a);
  const auto counts = [](const char* key) {
    return [key](const Study_mesh& m, const std::string& a) -> Cell {
      const Study_line* const l = m.line(a);
      if (l == nullptr || !l->number(key)) return std::nullopt;
      return static_cast<std::int64_t>(l->count(key));
    };
  };
  out << "<p>Meshes with the largest numbers first. A question mark is where the exact comparison "
         "did not get that far.</p>\n<h3>Edges of the result that are not Delaunay</h3>\n";
  write_matrix(out, results, inexact, counts("non_delaunay_edges"));
  out << "<h3>Flips more, or fewer, than with exact predicates</h3>\n";
  write_matrix(out, results, inexact, extra_flips);
  out << "<h3>Cycles: flips that undo the last flip of the same edge</h3>\n";
  write_matrix(out, results, inexact, counts("cycles"));
  out << "<h3>Flips of diamonds that are not convex</h3>\n";
  write_matrix(out, results, inexact, counts("nonconvex_flips"));
  out << "<h3>Faces of the result that are inverted</h3>\n";
  write_matrix(out, results, inexact, counts("inverted_faces"));
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

} // namespace program
