// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "constraints.h"
#include "support/text_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace program {

namespace {

using Halfedge = IT::Gluing_map::Halfedge;

// Diagonals of polygons are not edges of the file.
bool is_diagonal(const Surface_with_edges& s, std::uint32_t e) {
  if (s.names.polygon_of_triangle.empty()) return false;
  std::uint32_t f = s.mesh.face(Halfedge{2 * e}).index, g = s.mesh.face(Halfedge{2 * e + 1}).index;
  if (f == IT::Gluing::none || g == IT::Gluing::none) return false;
  f = s.names.faces.user(f);
  g = s.names.faces.user(g);
  // the sides of a triangle are consecutive
  return f / s.names.sheets != g / s.names.sheets &&
         s.names.polygon_of_triangle[f] == s.names.polygon_of_triangle[g];
}

// The unit normal of a face; NaN if it has no area. It scales sides to length 1, so that no square
// underflows.
Point normal(const Surface_with_edges& s, IT::Gluing_map::Face f) {
  std::array<Point, 2> side{};
  const std::array<Halfedge, 3> sides = s.mesh.sides(f);
  for (unsigned i = 0; i < 2; ++i) {
    const Point& p = s.points[s.mesh.source(sides[i]).index];
    const Point& q = s.points[s.mesh.target(sides[i]).index];
    for (unsigned k = 0; k < 3; ++k) side[i][k] = q[k] - p[k];
    const double length = std::hypot(side[i][0], side[i][1], side[i][2]);
    for (double& x : side[i]) x /= length;
  }
  Point n{};
  for (unsigned k = 0; k < 3; ++k)
    n[k] =
        side[0][(k + 1) % 3] * side[1][(k + 2) % 3] - side[0][(k + 2) % 3] * side[1][(k + 1) % 3];
  const double length = std::hypot(n[0], n[1], n[2]);
  for (double& x : n) x /= length;
  return n;
}

// The angle in degrees by which the two faces at an edge deviate from a plane; NaN if unknown.
double fold(const Point& n, const Point& m) {
  double cosine = 0;
  Point cross{};
  for (unsigned k = 0; k < 3; ++k) {
    cosine += n[k] * m[k];
    cross[k] = n[(k + 1) % 3] * m[(k + 2) % 3] - n[(k + 2) % 3] * m[(k + 1) % 3];
  }
  return std::atan2(std::hypot(cross[0], cross[1], cross[2]), cosine) * (180 / std::numbers::pi);
}

std::pair<std::uint32_t, std::uint32_t> ordered(std::uint32_t i, std::uint32_t j) {
  return {std::min(i, j), std::max(i, j)};
}

} // namespace

void mark_sharp_edges(const Surface_with_edges& s, double angle, std::vector<char>& is_marked) {
  const IT::Gluing_map& mesh = s.mesh;
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    const IT::Gluing_map::Face f = mesh.face(Halfedge{2 * e}), g = mesh.face(Halfedge{2 * e + 1});
    if (f.index == IT::Gluing::none || g.index == IT::Gluing::none || is_diagonal(s, e)) continue;
    Point n = normal(s, g);
    if (mesh.is_reversed({e}))
      for (double& x : n) x = -x;
    if (fold(normal(s, f), n) > angle) is_marked[e] = 1;
  }
}

Edge_finder::Edge_finder(const Surface_with_edges& s) {
  const IT::Gluing_map& mesh = s.mesh;
  edges_.reserve(mesh.number_of_edges());
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    const Halfedge inner{mesh.face(Halfedge{2 * e}).index == IT::Gluing::none ? 2 * e + 1 : 2 * e};
    if (!is_diagonal(s, e))
      edges_.push_back(
          {ordered(s.names.row(mesh.source(inner).index), s.names.row(mesh.target(inner).index)),
           e});
  }
  std::sort(edges_.begin(), edges_.end());
}

bool Edge_finder::mark(std::uint32_t i, std::uint32_t j, std::vector<char>& is_marked) const {
  auto edge = std::lower_bound(edges_.begin(), edges_.end(), std::pair(ordered(i, j), 0U));
  const bool is_found = edge != edges_.end() && edge->first == ordered(i, j);
  for (; edge != edges_.end() && edge->first == ordered(i, j); ++edge) is_marked[edge->second] = 1;
  return is_found;
}

namespace {

// The edges between the vertices that the lines of a file name.
void constrain_listed_edges(const Surface_with_edges& s, const Options& options, Constraints& c) {
  const Edge_finder edges(s);
  Text_lines lines(options.constraints);
  while (lines.next()) {
    lines.expect_words(2, "the numbers of two vertices");
    const std::size_t n = s.names.number_of_rows(s.mesh.number_of_vertices());
    const std::uint32_t i = lines.element(0, "vertex", n), j = lines.element(1, "vertex", n);
    if (!edges.mark(i, j, c.is_constrained))
      lines.refuse("no edge of " + options.input + " joins vertices " + std::to_string(i) +
                   " and " + std::to_string(j) + "; constrain a path of edges");
  }
}

// \pre options ask for constraints
void constrain(const Surface_with_edges& s, const Options& options, Constraints& c) {
  c.is_asked_for = true;
  c.is_constrained.assign(s.mesh.number_of_edges(), 0);
  if (options.sharp_angle) mark_sharp_edges(s, *options.sharp_angle, c.is_constrained);
  if (!options.constraints.empty()) constrain_listed_edges(s, options, c);
  c.count =
      static_cast<std::size_t>(std::count(c.is_constrained.begin(), c.is_constrained.end(), 1));
}

} // namespace

Constraints constraints_of(const Mesh_file& file, const Options& options) {
  Constraints c;
  const IT::Intrinsic_input& in = file.input;
  if (!has_constraints(options)) return c;
  constrain({in.mesh, in.points, in.names}, options, c);
  if (c.count > 0) c.mesh = in.mesh;
  return c;
}

Constraints constraints_of(const IT::Input& input, const Options& options) {
  Constraints c;
  c.is_stored = true;
  if (!has_constraints(options)) return c;
  if (options.sharp_angle && !input.metric().is_embedded())
    throw std::runtime_error(options.input +
                             ": the stored triangulation has lengths and no points, so that no "
                             "edge is sharp; name edges with --constrain");
  constrain({input.mesh(), input.metric().points(), input.names()}, options, c);
  return c;
}

} // namespace program
