// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Isometry_run.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_charts.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_number.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

std::size_t number_of_bits(const Gmpq& x) {
  return mpz_sizeinbase(mpq_numref(x.mpq()), 2) + mpz_sizeinbase(mpq_denref(x.mpq()), 2);
}

std::size_t most_bits(const std::array<Gmpq, 3>& lengths) {
  std::size_t most = 0;
  for (const Gmpq& l : lengths) most = std::max(most, number_of_bits(l));
  return most;
}

Rational_triangle triangle_with(const std::array<const Gmpq*, 3>& lengths) {
  return Rational_triangle({*lengths[0], *lengths[1], *lengths[2]});
}

constexpr std::size_t number_of_placed = 256;

} // namespace

Plane_charts::Plane_charts(const Gluing_map& mesh, const std::vector<std::uint32_t>& first_side,
                           const std::vector<char>& is_face_wanted,
                           const Squared_length& squared_length)
    : squared_length_(&squared_length), chart_(first_side.size(), none),
      point_(mesh.number_of_halfedges(), none), placed_(number_of_placed) {
  std::vector<std::uint32_t> queue;
  for (std::uint32_t first = 0; first < chart_.size(); ++first) {
    if (is_face_wanted[first] == 0 || chart_[first] != none) continue;
    if (!start_chart(mesh, Halfedge{first_side[first]})) continue;
    queue.assign(1, first_side[first]);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      expect_to_go_on();
      Halfedge h{queue[i]};
      for (int k = 0; k < 3; ++k, h = mesh.next(h)) {
        const Halfedge o = Gluing_map::opposite(h);
        const std::uint32_t face = mesh.face(o).index;
        if (face == none || is_face_wanted[face] == 0 || chart_[face] != none) continue;
        if (place_across(mesh, h)) queue.push_back(o.index);
      }
    }
  }
  squared_length_ = nullptr;
  placed_.clear();
  find_grids(mesh);
}

std::optional<Plane_charts::Sides> Plane_charts::sides_of(const Gluing_map& mesh,
                                                          Halfedge h) const {
  Sides result{};
  for (const Gmpq*& l : result) {
    l = (*squared_length_)(h.index / 2);
    if (l == nullptr) return std::nullopt;
    h = mesh.next(h);
  }
  return result;
}

bool Plane_charts::start_chart(const Gluing_map& mesh, Halfedge first) {
  const std::optional<Sides> s = sides_of(mesh, first);
  if (!s) return false;
  const Rational_triangle t = triangle_with(*s);
  if (t.squared_area == 0) return false; // no unit across its first side
  const std::uint32_t face = mesh.face(first).index;
  chart_[face] = face;
  charts_[face] = {t.squared_area, most_bits(t.lengths), Chart_grid(t)};
  for (const Plane_number& p : t.corners) {
    point_[first.index] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
    first = mesh.next(first);
  }
  return true;
}

// On grids, few triangles follow each other again and again.
const Plane_charts::Placed_triangle& Plane_charts::placed(const Sides& sides, std::uint32_t chart) {
  std::size_t hash = chart;
  for (const Gmpq* l : sides) hash = 31 * hash + std::hash<const Gmpq*>()(l) / alignof(Gmpq);
  Placed_triangle& known = placed_[hash % number_of_placed];
  if (known.sides == sides && known.chart == chart) return known;
  const Rational_triangle t = triangle_with(sides);
  known = {sides, chart, std::nullopt, most_bits(t.lengths)};
  Gmpq area;
  if (rational_square_root(t.squared_area / squared_area(chart), area))
    known.apex = {t.corners[2].x, t.corners[2].y * area};
  return known;
}

// With i where o starts, j where it ends, and the apex k: k = i + (j - i) (p + i a) / (2 |ij|^2).
bool Plane_charts::place_across(const Gluing_map& mesh, Halfedge h) {
  const Halfedge o = Gluing_map::opposite(h), n = mesh.next(o);
  const std::uint32_t chart = chart_[mesh.face(h).index];
  const std::optional<Sides> s = sides_of(mesh, o);
  if (!s) return false;
  const Placed_triangle& t = placed(*s, chart);
  if (!t.apex) return false;
  const Plane_number i = source(mesh.next(h)), j = source(h);
  const Plane_number apex = i + product(j - i, *t.apex, squared_area(chart));
  // In a plane, x is a quotient of squared lengths, and y one of areas: of six lengths together.
  // Where faces turn on and on, as on a cone, numbers grow: then another chart begins.
  const std::size_t most = 8 * std::max(t.bits, charts_.at(chart).bits);
  if (std::max(number_of_bits(apex.x), number_of_bits(apex.y)) > most) return false;
  point_[o.index] = point_[mesh.next(h).index];
  point_[n.index] = point_[h.index];
  point_[mesh.next(n).index] = number(mesh, o, apex);
  chart_[mesh.face(o).index] = chart;
  return true;
}

// Takes the number that a neighbour has for the apex, so that the next test for equality is fast.
std::uint32_t Plane_charts::number(const Gluing_map& mesh, Halfedge o, const Plane_number& apex) {
  const std::uint32_t chart = chart_[mesh.face(Gluing_map::opposite(o)).index];
  const Halfedge n = mesh.next(o), l = mesh.next(n);
  for (const Halfedge x : {Gluing_map::opposite(n), mesh.next(Gluing_map::opposite(l))}) {
    const std::uint32_t face = mesh.face(x).index;
    if (face != none && chart_[face] == chart && source(x) == apex) return point_[x.index];
  }
  points_.push_back(apex);
  return static_cast<std::uint32_t>(points_.size()) - 1;
}

void Plane_charts::find_grids(const Gluing_map& mesh) {
  grid_points_.resize(points_.size());
  std::vector<Chart_grid*> grid(points_.size(), nullptr);
  std::vector<Plane_number> coordinates(points_.size());
  for (std::uint32_t h = 0; h < point_.size(); ++h) {
    const std::uint32_t n = point_[h];
    if (n == none || grid[n] != nullptr) continue;
    grid[n] = &charts_.at(chart_[mesh.face(Halfedge{h}).index]).grid;
    if (!grid[n]->exists()) continue;
    coordinates[n] = grid[n]->coordinates(points_[n]);
    grid[n]->include(coordinates[n]);
  }
  for (std::size_t n = 0; n < points_.size(); ++n) {
    if (!grid[n]->exists()) continue;
    if (const std::optional<Grid_point> p = grid[n]->point(coordinates[n]))
      grid_points_[n] = *p;
    else
      grid[n]->drop();
  }
}

std::optional<Plane_motion> Plane_charts::motion_across(const Gluing_map& mesh, Halfedge h) const {
  const Halfedge o = Gluing_map::opposite(h), hn = mesh.next(h), on = mesh.next(o);
  const auto are_equal = [this](Halfedge x, Halfedge y) {
    return point_[x.index] == point_[y.index] || source(x) == source(y);
  };
  if (are_equal(h, on) && are_equal(hn, o)) return std::nullopt;
  const std::uint32_t chart = chart_[mesh.face(h).index];
  const Gmpq& q = squared_area(chart);
  const Plane_number turn = quotient(source(hn) - source(h), source(o) - source(on), q);
  return Plane_motion{chart, turn, source(h) - product(turn, source(on), q)};
}

Plane_motion Plane_charts::composed(const Plane_motion& a, const Plane_motion& b) const {
  const Gmpq& q = squared_area(a.chart);
  return {a.chart, product(a.turn, b.turn, q), product(a.turn, b.shift, q) + a.shift};
}

Plane_motion Plane_charts::inverse(const Plane_motion& a) const {
  const Gmpq& q = squared_area(a.chart);
  const Plane_number turn = quotient({1, 0}, a.turn, q);
  return {a.chart, turn, -product(turn, a.shift, q)};
}

} // namespace CGAL::Intrinsic_triangulations::internal
