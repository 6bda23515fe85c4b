// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/Star_removal.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

// How the polygon around a vertex becomes triangles, and in which of them a point is.

namespace CGAL::Intrinsic_triangulations::internal {

void Star_removal::start_polygon(const Coarse_mesh& mesh, const Vertex_star& star) {
  for (auto* list : {&before_, &after_, &corners_, &outside_}) list->clear();
  polygon_sides_.clear();
  triangles_.clear();
  new_faces_.clear();
  const auto n = static_cast<std::uint32_t>(points_.size());
  for (std::uint32_t k = 0; k < n; ++k) {
    before_.push_back(k == 0 ? n - 1 : k - 1);
    after_.push_back(k + 1 == n ? 0 : k + 1);
    if (k == star.size()) { // along the border
      polygon_sides_.push_back(
          {k, Gluing::none, Gluing::none, squared_norm(minus(points_[k], points_[0])), false});
      corners_.push_back(mesh.origin(Coarse_mesh::previous(star.side(k - 1))));
      outside_.push_back(Gluing::none);
    } else {
      const std::uint32_t h = Coarse_mesh::next(star.side(k));
      polygon_sides_.push_back({k, Gluing::none, mesh.glued(h), star.rim(k), mesh.is_kept_side(h)});
      corners_.push_back(mesh.origin(h));
      outside_.push_back(mesh.glued(h));
    }
  }
  side_of_rim_.assign(n, Gluing::none);
  triangle_of_rim_.assign(n, Gluing::none);
}

bool Star_removal::is_ear(std::uint32_t b) const {
  const std::uint32_t a = before_[b], c = after_[b];
  const auto turn = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
    return cross(minus(points_[q], points_[p]), minus(points_[r], points_[p]));
  };
  if (!is_proven_left_turn(points_[a], points_[b], points_[c])) return false;
  // about the centre, points are in order: only the tip is between the others
  if (is_proven_left_turn(points_[a], points_[c], middle_of_star)) return true;
  for (std::uint32_t p = after_[c]; p != a; p = after_[p])
    if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
  return true;
}

// The power of the centre by the circle of an ear, times -1: the least one is a Delaunay triangle
// of the polygon of a Delaunay star (Devillers, On deletion in Delaunay triangulations, 1999).
double Star_removal::ear_rank(std::uint32_t tip) const {
  const Exact_point &a = points_[before_[tip]], &b = points_[tip], &c = points_[after_[tip]];
  const double area = cross(minus(b, a), minus(c, a));
  if (!(area > 0)) return std::numeric_limits<double>::infinity();
  return (squared_norm(a) * cross(b, c) - squared_norm(b) * cross(a, c) +
          squared_norm(c) * cross(a, b)) /
         area;
}

void Star_removal::cut_ear(std::uint32_t tip, std::uint32_t face) {
  const std::uint32_t a = before_[tip], c = after_[tip];
  const bool is_last = before_[a] == c;
  new_faces_.push_back(face);
  New_triangle t{{a, tip, c}, {polygon_sides_[a], polygon_sides_[tip], {}}};
  if (is_last)
    t.sides[2] = polygon_sides_[c];
  else
    t.sides[2] = {Gluing::none, Gluing::none, Gluing::none,
                  squared_norm(minus(points_[a], points_[c])), false};
  const auto number = static_cast<std::uint32_t>(triangles_.size());
  for (std::uint32_t k = 0; k < 3; ++k) {
    const Rim_side& s = t.sides[k];
    if (s.rim != Gluing::none) {
      side_of_rim_[s.rim] = 3 * face + k;
      triangle_of_rim_[s.rim] = number;
    } else if (s.triangle != Gluing::none) { // comes before this one
      triangles_[s.triangle].sides[2].glued = 3 * face + k;
      triangles_[s.triangle].sides[2].triangle = number;
    }
  }
  polygon_sides_[a] = {Gluing::none, number, 3 * face + 2, t.sides[2].length, false};
  triangles_.push_back(t);
  after_[a] = c;
  before_[c] = a;
}

// An ear about the centre may have other points in it, and waits until they are gone: few at a time
// do, as their angles at the centre are above pi.
bool Star_removal::cut_ears(const Vertex_star& star) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto n = static_cast<std::uint32_t>(points_.size());
  const auto rank = [&](std::uint32_t tip) {
    const double r = ear_rank(tip);
    ears_.set(tip, r < infinity ? r : infinity);
  };
  ears_.start(n);
  waiting_.clear();
  for (std::uint32_t tip = 0; tip < n; ++tip) rank(tip);
  while (triangles_.size() + 2 < n) {
    const std::uint32_t tip = ears_.least();
    if (ears_.value(tip) == infinity) return false;
    if (!is_ear(tip)) {
      waiting_.emplace_back(tip, ears_.value(tip));
      ears_.set(tip, infinity);
      continue;
    }
    const std::uint32_t a = before_[tip], c = after_[tip];
    cut_ear(tip, star.side(triangles_.size()) / 3);
    if (triangles_.size() + 2 == n) break;
    ears_.set(tip, infinity);
    for (const auto& [other, old] : waiting_) ears_.set(other, old);
    waiting_.clear();
    rank(c);
    rank(a);
  }
  return true;
}

// Walks from triangle to triangle, across a side that the point is behind.
Star_removal::Located Star_removal::locate(const Exact_point& place, std::uint32_t from) const {
  Located best{from, {}, -std::numeric_limits<double>::infinity()};
  const auto see = [&](std::uint32_t i) {
    const std::array<double, 3> w = weights_in(new_triangle(triangles_[i]), place);
    const double least = std::min({w[0], w[1], w[2]});
    if (least > best.least) best = {i, w, least};
    return w;
  };
  std::uint32_t at = from, before = Gluing::none;
  for (std::size_t steps = 0; steps < triangles_.size() && at != Gluing::none; ++steps) {
    const std::array<double, 3> w = see(at);
    if (best.least >= 0) return best;
    std::uint32_t to = Gluing::none;
    double most = 0;
    for (std::uint32_t s = 0; s < 3; ++s) { // opposite the corner s + 2
      const Rim_side& side = triangles_[at].sides[s];
      if (side.rim != Gluing::none || side.triangle == before || !(w[(s + 2) % 3] < most)) continue;
      most = w[(s + 2) % 3];
      to = side.triangle;
    }
    before = std::exchange(at, to);
  }
  // behind a bay of the rim, or outside by rounding
  for (std::uint32_t i = 0; i < triangles_.size() && best.least < 0; ++i) see(i);
  return best;
}

} // namespace CGAL::Intrinsic_triangulations::internal
