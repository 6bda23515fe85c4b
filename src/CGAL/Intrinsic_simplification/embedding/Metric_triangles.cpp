// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/embedding/Angle_product.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

Double_double halved(const Double_double& x) { return x.scaled(0.5); }

// Twice the scalar product of the sides with squared lengths a and b, opposite c.
Double_double twice_product(const Double_double& a, const Double_double& b,
                            const Double_double& c) {
  return a + b - c;
}

// Four times the area of a triangle; 0 if rounding has spoilt the triangle inequality.
Double_double four_areas(const Double_double& a, const Double_double& b, const Double_double& c) {
  const Double_double p = twice_product(a, b, c), squared = (a * b).scaled(4) - p * p;
  return squared.to_double() > 0 ? sqrt(squared) : Double_double(0);
}

} // namespace

std::array<double, 2> Metric_diamond::sines() const {
  const Double_double at_i = kx * my + mx * ky, jk = length - kx, jm = length - mx,
                      at_j = jk * my + jm * ky;
  const auto norm = [](const Double_double& x, const Double_double& y) {
    return std::hypot(x.to_double(), y.to_double());
  };
  return {at_i.to_double() / (norm(kx, ky) * norm(mx, my)),
          at_j.to_double() / (norm(jk, ky) * norm(jm, my))};
}

Metric_triangles::Metric_triangles(Gluing gluing, std::vector<Double_double> squared)
    : gluing_(std::move(gluing)), squared_(std::move(squared)), length_(squared_.size()),
      sine_(squared_.size()), cosine_(squared_.size()), stretch_(squared_.size() / 3, 0),
      outgoing_(gluing_.number_of_vertices, Gluing::none) {
  for (std::uint32_t h = 0; h < number_of_halfedges(); ++h) {
    set_length(h, squared_[h]);
    outgoing_[source(h)] = h;
  }
  for (std::uint32_t f = 0; f < number_of_faces(); ++f) set_corners(f);
}

void Metric_triangles::glue(std::uint32_t g, std::uint32_t h) {
  gluing_.glue[g] = h;
  gluing_.glue[h] = g;
}

void Metric_triangles::set_length(std::uint32_t h, const Double_double& squared) {
  squared_[h] = squared;
  length_[h] = std::sqrt(squared.to_double());
}

void Metric_triangles::set_corners(std::uint32_t face) {
  const std::uint32_t h = 3 * face;
  const double area = four_areas(squared_[h], squared_[h + 1], squared_[h + 2]).to_double();
  for (std::uint32_t k = h; k < h + 3; ++k) {
    const std::uint32_t p = previous(k);
    const double twice = 2 * length_[k] * length_[p];
    sine_[k] = area / twice;
    cosine_[k] = twice_product(squared_[k], squared_[p], squared_[next(k)]).to_double() / twice;
  }
}

std::vector<double> Metric_triangles::curvatures() const {
  std::vector<double> result(number_of_vertices(), 2 * std::numbers::pi);
  for (std::uint32_t h = 0; h < number_of_halfedges(); ++h)
    if (!is_removed(h / 3)) result[source(h)] -= std::atan2(sine_[h], cosine_[h]);
  return result;
}

double Metric_triangles::curvature(std::uint32_t v) const {
  double guess = 2 * std::numbers::pi;
  Angle_product left;
  for_outgoing(v, [&](std::uint32_t h) {
    const std::uint32_t n = next(h), p = previous(h);
    guess -= std::atan2(sine_[h], cosine_[h]);
    left.multiply(twice_product(squared_[h], squared_[p], squared_[n]),
                  -four_areas(squared_[h], squared_[p], squared_[n]));
  });
  return left.near(guess);
}

std::uint32_t Metric_triangles::degree(std::uint32_t v) const {
  std::uint32_t number = 0;
  for_outgoing(v, [&](std::uint32_t) { ++number; });
  return number;
}

double Metric_triangles::stretch_exponent() const {
  double most = 0;
  for (const double s : stretch_) most = std::max(most, s);
  return most;
}

// A quadratic form with the values q on the sides e of a triangle is, for a vector x, the sum of
// (sum(q) / 2 - q_i) (x cross e_i)^2 / (4 A^2). With the change of squared lengths for q, and
// |x cross e_i| <= |x| |e_i|, that bounds the relative change of |x|^2.
void Metric_triangles::add_stretch(std::uint32_t face, const std::array<Double_double, 3>& before) {
  constexpr double rounding = 1 + 1e-7;
  std::array<double, 3> change{};
  for (std::uint32_t k = 0; k < 3; ++k)
    change[k] = (squared_[3 * face + k] - before[k]).to_double();
  const double half = (change[0] + change[1] + change[2]) / 2,
               area = four_areas(before[0], before[1], before[2]).to_double();
  double relative = 0;
  for (std::size_t k = 0; k < 3; ++k)
    relative += 4 * std::abs(half - change[k]) * before[k].to_double();
  relative *= rounding / (area * area);
  stretch_[face] += relative < 1 ? -std::log1p(-relative) / 2 * rounding
                                 : std::numeric_limits<double>::infinity();
}

void Metric_triangles::change_lengths(const std::vector<Double_double>& squared) {
  for (std::uint32_t f = 0; f < number_of_faces(); ++f) {
    if (is_removed(f)) continue;
    const std::uint32_t h = 3 * f;
    const std::array<Double_double, 3> before{squared_[h], squared_[h + 1], squared_[h + 2]};
    for (std::uint32_t k = h; k < h + 3; ++k) set_length(k, squared[k]);
    set_corners(f);
    add_stretch(f, before);
  }
}

// \param before the squared lengths of the outgoing halfedges, in order
void Metric_triangles::scale_edges(std::uint32_t vertex, const std::vector<Double_double>& before,
                                   const Double_double& factor) {
  std::size_t n = 0;
  for_outgoing(vertex, [&](std::uint32_t h) {
    const Double_double length = before[n++] * (target(h) == vertex ? factor * factor : factor);
    set_length(h, length);
    set_length(opposite(h), length);
  });
  for_outgoing(vertex, [&](std::uint32_t h) { set_corners(h / 3); });
}

// An angle, from an area with 106 bits, is wrong by its inverse sine times 2^-103 or so. The factor
// is 1 + x, found by the secant method: the curvature is nearly linear.
bool Metric_triangles::flatten(std::uint32_t vertex) {
  double left = curvature(vertex), slope = 0, flat = 0;
  for_outgoing(vertex, [&](std::uint32_t h) { flat += 0x1p-98 / sine_[h]; });
  if (std::isfinite(flat) && std::abs(left) <= flat) return true;
  std::vector<Double_double> spokes;
  std::map<std::uint32_t, std::array<Double_double, 3>> faces;
  for_outgoing(vertex, [&](std::uint32_t h) {
    const std::uint32_t f = h / 3;
    spokes.push_back(squared_[h]);
    faces[f] = {squared_[3 * f], squared_[3 * f + 1], squared_[3 * f + 2]};
    slope += squared_[next(h)].to_double() / (2 * length_[h] * length_[previous(h)] * sine_[h]);
  });
  if (!std::isfinite(flat + slope)) { // a face without area
    stretch_[outgoing_[vertex] / 3] = std::numeric_limits<double>::infinity();
    return false;
  }
  Double_double x(0);
  for (int k = 0; k < 20 && std::abs(left) > flat; ++k) {
    const double change = -left / slope;
    const Double_double next = x + Double_double(change);
    scale_edges(vertex, spokes, Double_double(1) + next);
    const double now = curvature(vertex);
    if (!(std::abs(now) < std::abs(left))) { // also not a number
      scale_edges(vertex, spokes, Double_double(1) + x);
      break;
    }
    slope = (now - left) / change;
    left = now;
    x = next;
  }
  for (const auto& [face, before] : faces) add_stretch(face, before);
  const bool is_flat = std::abs(left) <= flat;
  if (!is_flat) stretch_[outgoing_[vertex] / 3] = std::numeric_limits<double>::infinity();
  return is_flat;
}

Metric_diamond Metric_triangles::unfold(std::uint32_t h) const {
  const std::uint32_t g = opposite(h);
  const Double_double &ij = squared_[h], &jk = squared_[next(h)], &ki = squared_[previous(h)],
                      &im = squared_[next(g)], &mj = squared_[previous(g)];
  const Double_double l = sqrt(ij), twice = l + l;
  return {l, twice_product(ij, ki, jk) / twice, halved(four_areas(ij, jk, ki)) / l,
          twice_product(ij, im, mj) / twice, halved(four_areas(ij, im, mj)) / l};
}

void Metric_triangles::flip(std::uint32_t h, const Metric_diamond& d) {
  if (!removed_in_.empty()) move_removed(h, d);
  const std::uint32_t g = opposite(h), h1 = next(h), h2 = next(h1), g1 = next(g), g2 = next(g1);
  const std::uint32_t i = source(h), j = source(g), k = source(h2), m = source(g2);
  const std::array<Double_double, 4> sides{squared_[h2], squared_[g1], squared_[g2], squared_[h1]};
  std::array<std::uint32_t, 4> others{opposite(h2), opposite(g1), opposite(g2), opposite(h1)};
  // new faces: m k i at h, k m j at g
  const std::array<std::uint32_t, 4> before{h2, g1, g2, h1}, after{h1, h2, g1, g2};
  for (std::uint32_t& other : others)
    for (std::size_t n = 0; n < 4; ++n)
      if (other == before[n]) {
        other = after[n];
        break;
      }
  const std::array<std::uint32_t, 4> from{k, i, m, j};
  for (std::size_t n = 0; n < 4; ++n) {
    gluing_.origin[after[n]] = from[n];
    set_length(after[n], sides[n]);
    glue(after[n], others[n]);
    outgoing_[from[n]] = after[n];
  }
  gluing_.origin[h] = m;
  gluing_.origin[g] = k;
  const Double_double x = d.kx - d.mx, y = d.ky + d.my, squared = x * x + y * y;
  set_length(h, squared);
  set_length(g, squared);
  stretch_[h / 3] = stretch_[g / 3] = std::max(stretch_[h / 3], stretch_[g / 3]);
  set_corners(h / 3);
  set_corners(g / 3);
}

void Metric_triangles::move_removed(std::uint32_t h, const Metric_diamond& d) {
  const std::uint32_t g = opposite(h);
  std::vector<std::uint32_t> moved;
  for (const std::uint32_t f : {h / 3, g / 3}) {
    moved.insert(moved.end(), removed_in_[f].begin(), removed_in_[f].end());
    removed_in_[f].clear();
  }
  const Double_double x = d.kx - d.mx, y = d.ky + d.my; // from m to k
  const auto cross = [](const Double_double& ax, const Double_double& ay, const Double_double& bx,
                        const Double_double& by) { return ax * by - ay * bx; };
  const double least = 0x1p-80 * (x * x + y * y).to_double();
  for (const std::uint32_t r : moved) {
    Removed_vertex& p = removed_[r];
    const bool is_above = p.face == h / 3;
    const std::uint32_t first = (is_above ? h : g) % 3;
    const Double_double &a = p.weights[first], &b = p.weights[(first + 1) % 3],
                        &c = p.weights[(first + 2) % 3];
    const Double_double px = is_above ? b * d.length + c * d.kx : a * d.length + c * d.mx;
    const Double_double py = is_above ? c * d.ky : -(c * d.my);
    const Double_double side = cross(x, y, px - d.mx, py + d.my); // positive on the side of i
    // no point lies in a face without area
    const bool is_at_i = side.to_double() >= 0 && cross(x, y, -d.mx, d.my).to_double() > least;
    const Double_double ex = is_at_i ? Double_double(0) : d.length; // the end i or j
    const Double_double all = cross(x, y, ex - d.mx, d.my);
    const Double_double of_end = side / all;
    const Double_double of_k = cross(ex - d.mx, d.my, px - d.mx, py + d.my) / -all;
    const Double_double of_m = Double_double(1) - of_end - of_k;
    const std::uint32_t at = is_at_i ? h : g;
    p.face = at / 3;
    p.weights[at % 3] = is_at_i ? of_m : of_k;
    p.weights[(at + 1) % 3] = is_at_i ? of_k : of_m;
    p.weights[(at + 2) % 3] = of_end;
    removed_in_[p.face].push_back(r);
  }
}

void Metric_triangles::remove(std::uint32_t vertex) {
  // faces v a b, v b c, v c a
  const std::uint32_t va = outgoing_[vertex], vb = opposite(previous(va)),
                      vc = opposite(previous(vb)), face = va / 3;
  const std::array<std::uint32_t, 3> rim{next(va), next(vb), next(vc)};
  place_in_rim(vertex, rim);
  std::array<std::uint32_t, 3> others{}, sources{};
  std::array<Double_double, 3> sides;
  for (std::uint32_t k = 0; k < 3; ++k) {
    sources[k] = source(rim[k]);
    sides[k] = squared_[rim[k]];
    const auto in_rim = std::find(rim.begin(), rim.end(), opposite(rim[k]));
    others[k] = in_rim == rim.end() ? opposite(rim[k])
                                    : 3 * face + static_cast<std::uint32_t>(in_rim - rim.begin());
  }
  for (const std::uint32_t f : {vb / 3, vc / 3}) {
    stretch_[face] = std::max(stretch_[face], stretch_[f]);
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) gluing_.origin[h] = Gluing::none;
  }
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t h = 3 * face + k;
    gluing_.origin[h] = sources[k];
    set_length(h, sides[k]);
    glue(h, others[k]);
    outgoing_[sources[k]] = h;
  }
  outgoing_[vertex] = Gluing::none;
  set_corners(face);
}

void Metric_triangles::place_in_rim(std::uint32_t vertex, const std::array<std::uint32_t, 3>& rim) {
  if (removed_in_.empty()) removed_in_.resize(number_of_faces());
  std::array<Double_double, 3> areas;
  Double_double sum(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t h = rim[k];
    areas[k] = four_areas(squared_[h], squared_[next(h)], squared_[previous(h)]);
    sum = sum + areas[k];
  }
  // corner k is where side k of the rim begins, opposite side k + 1
  const std::array<Double_double, 3> weights{areas[1] / sum, areas[2] / sum, areas[0] / sum};
  const std::uint32_t face = rim[0] / 3;
  std::vector<std::uint32_t> moved;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t h = rim[k];
    for (const std::uint32_t r : removed_in_[h / 3]) {
      const std::array<Double_double, 3> old = removed_[r].weights;
      std::array<Double_double, 3>& now = removed_[r].weights;
      for (std::size_t c = 0; c < 3; ++c) now[c] = old[previous(h) % 3] * weights[c];
      now[k] = now[k] + old[h % 3];
      now[(k + 1) % 3] = now[(k + 1) % 3] + old[next(h) % 3];
      removed_[r].face = face;
      moved.push_back(r);
    }
    removed_in_[h / 3].clear();
  }
  moved.push_back(static_cast<std::uint32_t>(removed_.size()));
  removed_.push_back({vertex, face, weights});
  removed_in_[face] = std::move(moved);
}

} // namespace CGAL::Intrinsic_triangulations::internal
