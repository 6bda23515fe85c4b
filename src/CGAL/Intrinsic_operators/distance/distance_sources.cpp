// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/distance/distance_sources.h>
#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

double distance_to_segment(std::complex<double> p, std::complex<double> a, std::complex<double> b) {
  const std::complex<double> along = b - a;
  const double squared = std::norm(along);
  const double x =
      squared > 0 ? std::clamp(std::real(std::conj(along) * (p - a)) / squared, 0.0, 1.0) : 0;
  return std::abs(p - a - x * along);
}

// Lowers values of rows to their distances along edges from each other, up to the greatest value.
static void lower_along_edges(const Face_table& table, std::map<int, double>& values) {
  double farthest = 0;
  for (const auto& [row, value] : values) farthest = std::max(farthest, value);
  struct Edge {
    int from, to;
    double length;
  };
  std::vector<Edge> edges;
  table.for_each_edge([&](const Table_face& f, std::size_t k) {
    const double length = f.length(k);
    if (length >= farthest) return;
    edges.push_back({f.rows[k], f.rows[(k + 1) % 3], length});
    edges.push_back({f.rows[(k + 1) % 3], f.rows[k], length});
  });
  std::vector<double> best(table.number_of_rows, farthest);
  for (const auto& [row, value] : values) best[static_cast<std::size_t>(row)] = value;
  // paths have few edges, since none is longer than the edges of the faces with sources
  for (bool is_lowered = true; is_lowered;) {
    is_lowered = false;
    for (const Edge& e : edges) {
      const double there = best[static_cast<std::size_t>(e.from)] + e.length;
      double& known = best[static_cast<std::size_t>(e.to)];
      if (!(there < known)) continue;
      known = there;
      is_lowered = true;
    }
  }
  for (auto& [row, value] : values) value = best[static_cast<std::size_t>(row)];
}

std::map<int, double> distances_near_sources(const Face_table& table,
                                             const Source_places& sources) {
  std::map<int, double> values;
  for (const Source_segment& s : sources.segments) {
    const Table_face& f = table.faces[s.face];
    const auto corners = f.layout();
    const auto a = place_in_layout(corners, s.from), b = place_in_layout(corners, s.to);
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = distance_to_segment(corners[k], a, b);
      double& value = values.insert({f.rows[k], d}).first->second;
      value = std::min(value, d);
    }
  }
  const bool may_be_shorter = !values.empty();
  for (const int row : sources.rows) values[row] = 0;
  for (const Source_side& s : sources.sides)
    for (const std::size_t k : {s.side, (s.side + 1) % 3}) values[table.faces[s.face].rows[k]] = 0;
  if (may_be_shorter) lower_along_edges(table, values);
  return values;
}

} // namespace CGAL::Intrinsic_triangulations::internal
