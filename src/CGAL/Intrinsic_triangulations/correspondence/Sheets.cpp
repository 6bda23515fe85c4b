// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

bool Sheets::is_seam(std::uint32_t edge) const {
  return !input_.is_border(2 * edge) && !input_.is_border(2 * edge + 1) &&
         edges_over(2 * edge, 3).size() != 2;
}

std::vector<char> Sheets::wide_seams() const {
  constexpr double limit = (1 - 0x1p-20) * std::numbers::pi / 3; // equilateral faces are wide
  std::vector<char> result(input_.number_of_edges(), 0);
  for (std::uint32_t e = 0; e < result.size(); ++e) result[e] = is_seam(e) ? 1 : 0;
  std::vector<std::uint32_t> narrow;
  for (std::uint32_t h = 0; h < 2 * result.size(); ++h) {
    double angle = 0;
    std::uint32_t g = h; // from one seam to the next, counterclockwise
    do {
      if (result[h / 2] == 0 || input_.is_border(g)) break;
      angle += angle_at_source(input_, g);
      g = next_around_source(input_, g);
    } while (angle < limit && result[g / 2] == 0);
    if (angle > 0 && angle < limit && result[g / 2] != 0) narrow.insert(narrow.end(), {h, g});
  }
  for (const std::uint32_t h : narrow)
    for (const std::uint32_t copy : edges_over(h)) result[copy / 2] = 0;
  return result;
}

bool Sheets::has_branches() const {
  for (std::uint32_t e = 0; e < input_.number_of_edges(); ++e)
    if (edges_over(2 * e, 3).size() > 2) return true;
  return false;
}

std::vector<char> Sheets::one_sheet() const {
  std::vector<char> is_on(input_.number_of_faces(), 0), is_known(is_on);
  std::vector<std::uint32_t> next;
  const auto choose = [&](std::uint32_t f) {
    if (is_known[f] != 0) return;
    is_on[f] = is_known[f] = is_known[other_face(f)] = 1;
    next.push_back(f);
  };
  for (std::uint32_t name = 0; name < is_on.size(); ++name) {
    choose(input_.names().faces.here(name));
    while (!next.empty()) {
      const std::uint32_t f = next.back();
      next.pop_back();
      for (const std::uint32_t h : sides_of(f))
        if (!input_.is_border(h ^ 1U) && !is_seam(h / 2)) choose(input_.face(h ^ 1U));
    }
  }
  return is_on;
}

std::vector<Surface_point> Sheets::others(Surface_point p) const {
  std::vector<Surface_point> result;
  p = with_zero_last(p);
  if (p.weights[2] != 0) {
    result.push_back({other_side(p.halfedge), {p.weights[1], p.weights[0], p.weights[2]}});
    return result;
  }
  const std::vector<std::uint32_t> edges = edges_over(p.halfedge);
  for (std::size_t i = 1; i < edges.size(); ++i)
    result.push_back(input_.is_border(edges[i])
                         ? Surface_point{edges[i] ^ 1U, {p.weights[1], p.weights[0], 0}}
                         : Surface_point{edges[i], p.weights});
  return result;
}

std::pair<std::uint32_t, std::array<double, 3>> Sheets::name(const Surface_point& p) const {
  const auto named = [this](const Surface_point& q) { return name_here(q); };
  auto least = named(p);
  for (const Surface_point& q : others(p)) least = std::min(least, named(q));
  return least;
}

std::uint32_t Sheets::other_side(std::uint32_t h) const {
  const std::uint32_t f = input_.face(h);
  const std::array<std::uint32_t, 3> sides = sides_of(f), others = sides_of(other_face(f));
  const auto k = static_cast<std::size_t>(std::find(sides.begin(), sides.end(), h) - sides.begin());
  return others[(3 - k) % 3];
}

std::uint32_t Sheets::other_face(std::uint32_t f) const {
  return input_.names().faces.here(input_.names().faces.user(f) ^ 1U);
}

std::array<std::uint32_t, 3> Sheets::sides_of(std::uint32_t f) const {
  const std::uint32_t h = input_.halfedge_of_face(f), n = input_.next(h);
  return {h, n, input_.next(n)};
}

std::vector<std::uint32_t> Sheets::edges_over(std::uint32_t h, std::size_t most) const {
  std::vector<std::uint32_t> result{h};
  std::uint32_t x = h;
  while (!input_.is_border(x) && result.size() < most) {
    x = other_side(x) ^ 1U;
    if (x == h) return result;
    result.push_back(x);
  }
  for (x = h; !input_.is_border(x ^ 1U) && result.size() < most;) { // there is border at both ends
    x = other_side(x ^ 1U);
    result.push_back(x);
  }
  return result;
}

Surface_point Sheets::with_zero_last(Surface_point p) const {
  const auto& w = p.weights;
  for (int k = 0; k < 2 && w[2] != 0; ++k)
    if (w[0] == 0 || w[1] == 0) p = {input_.next(p.halfedge), {w[1], w[2], w[0]}};
  return p;
}

std::pair<std::uint32_t, std::array<double, 3>> Sheets::name_here(Surface_point p) const {
  p = with_zero_last(p);
  if (p.weights[2] == 0)
    return {p.halfedge & ~1U,
            p.halfedge % 2 == 0 ? p.weights : std::array<double, 3>{p.weights[1], p.weights[0], 0}};
  const std::uint32_t first = input_.halfedge_of_face(input_.face(p.halfedge));
  while (p.halfedge != first)
    p = {input_.next(p.halfedge), {p.weights[1], p.weights[2], p.weights[0]}};
  return {first, p.weights};
}

bool Sheets::has_two_sides() const {
  const Input_names& names = input_.names();
  if (names.sheets % 2 != 0 || input_.number_of_faces() % 2 != 0) return false;
  const auto row = [&](std::uint32_t v) { return names.row(v); };
  for (std::uint32_t f = 0; f < input_.number_of_faces(); ++f) {
    if (other_face(f) >= input_.number_of_faces()) return false;
    for (const std::uint32_t h : sides_of(f)) {
      const std::uint32_t o = other_side(h);
      if (row(input_.source(h)) != row(input_.target(o))) return false;
    }
  }
  return true;
}

} // namespace CGAL::Intrinsic_triangulations::internal
