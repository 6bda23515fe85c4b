// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "direction_lines.h"

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace program {

namespace {

// A line from a point along a vector, or an arrow, the tip of which has another colour.
void append_direction(std::vector<IT::Polyline>& lines, const Point& from, const Point& vector,
                      double scale, bool is_arrow) {
  Point middle, to;
  for (std::size_t c = 0; c < 3; ++c) {
    middle[c] = from[c] + 0.7 * scale * vector[c];
    to[c] = from[c] + scale * vector[c];
  }
  lines.push_back({{from, is_arrow ? middle : to}, false, 1});
  if (is_arrow) lines.push_back({{middle, to}, false, 0});
}

double length(const Point& p) { return std::hypot(p[0], p[1], p[2]); }

// The factor by which to draw vectors.
double scale_of_lines(const Drawn_directions& directions, const Drawn_subdivision& drawn) {
  double longest = 0, sum = 0;
  for (const Point& p : directions.at_vertices.front()) longest = std::max(longest, length(p));
  std::size_t count = 0;
  const std::vector<Point>& x = drawn.points;
  IT::for_each_subdivision_edge(
      drawn.s, [&](std::uint32_t a, std::uint32_t b, const IT::Common_subdivision::Side& side) {
        if (side.intrinsic_edge == IT::Common_subdivision::none) return;
        ++count;
        sum += length({x[a][0] - x[b][0], x[a][1] - x[b][1], x[a][2] - x[b][2]});
      });
  return longest > 0 && count > 0 ? sum / static_cast<double>(count) / 2 / longest : 0;
}

} // namespace

std::vector<IT::Polyline> direction_lines(const Drawn_directions& directions,
                                          const Drawn_subdivision& drawn) {
  std::vector<IT::Polyline> lines;
  if (directions.at_vertices.empty()) return lines;
  const double scale = scale_of_lines(directions, drawn);
  const bool are_arrows = directions.at_vertices.size() == 1;
  for (const std::vector<Point>& vectors : directions.at_vertices)
    for (std::size_t v = 0; v < drawn.s.vertices.size(); ++v)
      append_direction(lines, drawn.points[v], vectors[v], scale, are_arrows);
  return lines;
}

void append_fields(std::vector<IT::Subdivision_field>& fields, const std::string& name,
                   const Drawn_directions& directions) {
  using Place = IT::Subdivision_field::Place;
  const std::size_t degree = directions.at_vertices.size();
  for (std::size_t k = 0; k < degree; ++k) {
    const std::string numbered = degree == 1 ? name : name + "_" + std::to_string(k);
    fields.push_back({numbered, directions.at_vertices[k]});
    if (!directions.at_faces.empty())
      fields.push_back({numbered, directions.at_faces[k], Place::faces});
  }
  if (!directions.index.empty()) fields.push_back({"index", directions.index, Place::faces});
}

} // namespace program
