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

} // namespace

Plane_charts::Plane_charts(const Gluing_map& mesh, const std::vector<std::uint32_t>& first_side,
                           const std::vector<char>& is_face_wanted,
                           const Squared_length& squared_length)
    : squared_length_(&squared_length), chart_(first_side.size(), none),
      point_(mesh.number_of_halfedges(), none), squared_area_(first_side.size()),
      bits_(first_side.size(), 0) {
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
}

std::optional<Rational_triangle> Plane_charts::triangle(const Gluing_map& mesh, Halfedge h) const {
  std::array<Gmpq, 3> lengths;
  for (Gmpq& l : lengths) {
    const std::optional<Gmpq>& x = (*squared_length_)(h.index / 2);
    if (!x) return std::nullopt;
    l = *x;
    h = mesh.next(h);
  }
  return Rational_triangle(lengths);
}

bool Plane_charts::start_chart(const Gluing_map& mesh, Halfedge first) {
  const std::optional<Rational_triangle> t = triangle(mesh, first);
  if (!t) return false;
  const std::uint32_t face = mesh.face(first).index;
  chart_[face] = face;
  squared_area_[face] = t->squared_area;
  bits_[face] = most_bits(t->lengths);
  for (const Plane_number& p : t->corners) {
    point_[first.index] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
    first = mesh.next(first);
  }
  return true;
}

// With i where o starts, j where it ends, and the apex k: k = i + (j - i) (p + i a) / (2 |ij|^2).
bool Plane_charts::place_across(const Gluing_map& mesh, Halfedge h) {
  const Halfedge o = Gluing_map::opposite(h), n = mesh.next(o);
  const std::uint32_t chart = chart_[mesh.face(h).index];
  const std::optional<Rational_triangle> t = triangle(mesh, o);
  if (!t) return false;
  const Gmpq& q = squared_area_[chart];
  Gmpq area;
  if (!rational_square_root(t->squared_area / q, area)) return false;
  const Plane_number i = source(mesh.next(h)), j = source(h), &corner = t->corners[2];
  const Plane_number apex = i + product(j - i, {corner.x, corner.y * area}, q);
  // In a plane, x is a quotient of squared lengths, and y one of areas: of six lengths together.
  // Where faces turn on and on, as on a cone, numbers grow: then another chart begins.
  const std::size_t most = 8 * std::max(most_bits(t->lengths), bits_[chart]);
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

std::optional<Plane_motion> Plane_charts::motion_across(const Gluing_map& mesh, Halfedge h) const {
  const Halfedge o = Gluing_map::opposite(h), hn = mesh.next(h), on = mesh.next(o);
  const auto are_equal = [this](Halfedge x, Halfedge y) {
    return point_[x.index] == point_[y.index] || source(x) == source(y);
  };
  if (are_equal(h, on) && are_equal(hn, o)) return std::nullopt;
  const std::uint32_t chart = chart_[mesh.face(h).index];
  const Gmpq& q = squared_area_[chart];
  const Plane_number turn = quotient(source(hn) - source(h), source(o) - source(on), q);
  return Plane_motion{chart, turn, source(h) - product(turn, source(on), q)};
}

Plane_motion Plane_charts::composed(const Plane_motion& a, const Plane_motion& b) const {
  const Gmpq& q = squared_area_[a.chart];
  return {a.chart, product(a.turn, b.turn, q), product(a.turn, b.shift, q) + a.shift};
}

Plane_motion Plane_charts::inverse(const Plane_motion& a) const {
  const Gmpq& q = squared_area_[a.chart];
  const Plane_number turn = quotient({1, 0}, a.turn, q);
  return {a.chart, turn, -product(turn, a.shift, q)};
}

} // namespace CGAL::Intrinsic_triangulations::internal
