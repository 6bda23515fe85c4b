// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/Simplifier.h>

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <numbers>

// How a vertex becomes flat, while the triangulation stays Delaunay.

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Sums of angles this near to a flat one are flat up to rounding.
double angle_tolerance(const Vertex_star& star) {
  return 2e-15 + 4e-16 * static_cast<double>(star.size());
}

} // namespace

// Whether the angles at a bound are not flat yet, or just so.
bool Simplifier::is_reached(const Vertex_star::Bound& bound, bool grows) const {
  const double rest = star_.angles(mesh_, bound.factor).sum - star_.flat_angle();
  return (rest > 0) == grows || std::abs(rest) <= angle_tolerance(star_);
}

// The logarithm of the factor with which the angles are flat, between 1 and a bound: Newton's
// steps, and halving where they leave what is known.
// \param slope of the angles
// \param rest the angles minus the flat ones; on return zero, or something else if the bound is
//   reached before
double Simplifier::factor_within(const Vertex_star::Bound& bound, bool grows, double slope,
                                 double& rest) {
  const double tolerance = angle_tolerance(star_), end = std::log(bound.factor);
  double low = grows ? 0 : end, high = grows ? end : 0; // angles fall from low to high
  bool is_end_known = !std::isfinite(end);
  double u = 0;
  unsigned steps = 0;
  while (std::abs(rest) > tolerance && ++steps < 100) {
    double to = u + rest / slope;
    if (!(to > low && to < high)) {
      if (!is_end_known && is_reached(bound, grows)) {
        u = end;
        break;
      }
      is_end_known = true;
      to = std::isfinite(low + high) ? (low + high) / 2 : grows ? u + 1 : u - 1;
    }
    if (to == u) break; // no double is better
    u = to;
    const Vertex_star::Angles now = star_.angles(mesh_, std::exp(u));
    rest = now.sum - star_.flat_angle();
    slope = now.slope;
    (rest > 0 ? low : high) = u;
  }
  if (u != end && std::abs(rest) < 1e-9) rest = 0; // as near as doubles are, far below any turn
  step_.newton_steps += steps;
  most_newton_steps_ = std::max(most_newton_steps_, steps);
  return u;
}

// At a bound, a face becomes straight: its longest side cannot be flipped. If that is on the
// border, no other face needs its length: it becomes that of a face with a right angle, which
// allows other factors. Where the border is all around, similar faces would come again for ever.
bool Simplifier::bend_straight_face(const Vertex_star::Bound& bound, bool grows) {
  if (bound.face == Gluing::none) return false;
  const std::uint32_t h = star_.side(bound.face), n = Coarse_mesh::next(h),
                      l = Coarse_mesh::previous(h);
  const std::uint32_t longest = !grows ? n : mesh_.length(h) > mesh_.length(l) ? h : l;
  const auto is_free = [&](std::uint32_t s) {
    return mesh_.glued(s) == Gluing::none && !mesh_.is_kept_side(s);
  };
  if (!is_free(longest)) return false;
  if (!grows && std::ranges::all_of(star_.sides(), [&](std::uint32_t s) {
        return mesh_.glued(Coarse_mesh::next(s)) == Gluing::none;
      }))
    return false;
  star_.scale(mesh_, bound.factor);
  mesh_.change(h / 3);
  mesh_.set_length(longest, mesh_.length(Coarse_mesh::next(longest)) +
                                mesh_.length(Coarse_mesh::previous(longest)));
  return true;
}

// Multiplies the edges at a vertex, whose star is known, by a factor until it is flat; edges are
// flipped on the way.
Simplifier::Fate Simplifier::flatten(std::uint32_t v) {
  for (std::size_t events = 0; events < 1000; ++events) {
    if (events > 0 && !star_.find(mesh_, v)) return Fate::failed;
    const Vertex_star::Angles angles = star_.angles(mesh_);
    double rest = angles.sum - star_.flat_angle();
    if (std::abs(rest) <= angle_tolerance(star_)) return Fate::open;
    const bool grows = rest > 0;
    const Vertex_star::Bound bound = grows ? star_.bound_above(mesh_) : star_.bound_below(mesh_);
    const double u = factor_within(bound, grows, angles.slope, rest);
    if (rest == 0) {
      star_.scale(mesh_, std::exp(u));
      return Fate::open;
    }
    if (bound.side == Gluing::none) {
      if (!bend_straight_face(bound, grows)) return Fate::blocked;
      continue;
    }
    star_.scale(mesh_, bound.factor);
    if (!mesh_.flip(bound.side)) return Fate::failed;
    ++step_.ptolemy_flips;
  }
  return Fate::failed;
}

} // namespace CGAL::Intrinsic_triangulations::internal
