// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Input_edges.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The angle in degrees by which two faces with these normals deviate from a plane; NaN if unknown.
static double fold_in_degrees(const std::array<double, 3>& n, const std::array<double, 3>& m) {
  double cosine = 0;
  std::array<double, 3> cross{};
  for (unsigned k = 0; k < 3; ++k) {
    cosine += n[k] * m[k];
    cross[k] = n[(k + 1) % 3] * m[(k + 2) % 3] - n[(k + 2) % 3] * m[(k + 1) % 3];
  }
  return std::atan2(std::hypot(cross[0], cross[1], cross[2]), cosine) * (180 / std::numbers::pi);
}

} // namespace internal

Input_edges::Input_edges(const Intrinsic_input& input)
    : mesh_(&input.mesh), points_(&input.points), names_(&input.names) {}

Input_edges::Input_edges(const Input& input)
    : mesh_(&input.mesh()), points_(&input.metric().points()), names_(&input.names()) {}

bool Input_edges::is_diagonal(std::uint32_t e) const {
  if (names_->polygon_of_triangle.empty()) return false;
  std::uint32_t f = mesh_->face({2 * e}).index, g = mesh_->face({2 * e + 1}).index;
  if (f == Gluing::none || g == Gluing::none) return false;
  f = names_->faces.user(f);
  g = names_->faces.user(g);
  // the sides of a triangle are consecutive
  return f / names_->sheets != g / names_->sheets &&
         names_->polygon_of_triangle[f] == names_->polygon_of_triangle[g];
}

// The unit normal of a face; NaN if it has no area. It scales sides to length 1, so that no square
// underflows.
std::array<double, 3> Input_edges::normal(Gluing_map::Face f) const {
  std::array<std::array<double, 3>, 2> side{};
  const std::array<Gluing_map::Halfedge, 3> sides = mesh_->sides(f);
  for (unsigned i = 0; i < 2; ++i) {
    const auto& p = (*points_)[mesh_->source(sides[i]).index];
    const auto& q = (*points_)[mesh_->target(sides[i]).index];
    for (unsigned k = 0; k < 3; ++k) side[i][k] = q[k] - p[k];
    const double length = std::hypot(side[i][0], side[i][1], side[i][2]);
    for (double& x : side[i]) x /= length;
  }
  std::array<double, 3> n{};
  for (unsigned k = 0; k < 3; ++k)
    n[k] =
        side[0][(k + 1) % 3] * side[1][(k + 2) % 3] - side[0][(k + 2) % 3] * side[1][(k + 1) % 3];
  const double length = std::hypot(n[0], n[1], n[2]);
  for (double& x : n) x /= length;
  return n;
}

void Input_edges::mark_sharp(double degrees, std::vector<char>& marks) const {
  for (std::uint32_t e = 0; e < mesh_->number_of_edges(); ++e) {
    const Gluing_map::Face f = mesh_->face({2 * e}), g = mesh_->face({2 * e + 1});
    if (f.index == Gluing::none || g.index == Gluing::none || is_diagonal(e)) continue;
    std::array<double, 3> n = normal(g);
    if (mesh_->is_reversed({e}))
      for (double& x : n) x = -x;
    if (internal::fold_in_degrees(normal(f), n) > degrees) marks[e] = 1;
  }
}

bool Input_edges::mark(std::uint32_t i, std::uint32_t j, std::vector<char>& marks) {
  const Ends ends = std::minmax(i, j);
  if (edges_.empty()) {
    edges_.reserve(mesh_->number_of_edges());
    for (std::uint32_t e = 0; e < mesh_->number_of_edges(); ++e) {
      const bool is_outer = mesh_->face({2 * e}).index == Gluing::none;
      const Gluing_map::Halfedge inner{is_outer ? 2 * e + 1 : 2 * e};
      const std::uint32_t p = names_->row(mesh_->source(inner).index),
                          q = names_->row(mesh_->target(inner).index);
      if (!is_diagonal(e)) edges_.emplace_back(std::minmax(p, q), e);
    }
    std::sort(edges_.begin(), edges_.end());
  }
  auto edge = std::lower_bound(edges_.begin(), edges_.end(), std::pair(ends, 0U));
  const bool is_found = edge != edges_.end() && edge->first == ends;
  for (; edge != edges_.end() && edge->first == ends; ++edge) marks[edge->second] = 1;
  return is_found;
}

} // namespace CGAL::Intrinsic_triangulations
