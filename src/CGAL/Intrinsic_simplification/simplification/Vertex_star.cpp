// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/Vertex_star.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace CGAL::Intrinsic_triangulations::internal {

bool Vertex_star::find(const Coarse_mesh& mesh, std::uint32_t v) {
  sides_.clear();
  spoke_.clear();
  rim_.clear();
  const std::uint32_t first = mesh.outgoing(v);
  is_on_border_ = false;
  if (first == Gluing::none) return false;
  bool is_proper = true;
  for (std::uint32_t h = first;;) {
    sides_.push_back(h);
    spoke_.push_back(mesh.length(h));
    rim_.push_back(mesh.length(Coarse_mesh::next(h)));
    is_proper = is_proper && mesh.origin(Coarse_mesh::next(h)) != v;
    const std::uint32_t last = Coarse_mesh::previous(h);
    is_proper = is_proper && mesh.origin(last) != v;
    h = mesh.glued(last);
    if (h == Gluing::none) {
      is_on_border_ = true;
      spoke_.push_back(mesh.length(last));
      break;
    }
    if (h == first) break;
  }
  return is_proper;
}

Vertex_star::Angles Vertex_star::angles(double factor) const {
  Angles result;
  for (std::size_t k = 0; k < rim_.size(); ++k) {
    const double a = factor * spoke_[k], b = factor * spoke_[after(k)], e = rim_[k];
    const double area = quadruple_area_of(a, b, e);
    result.sum += std::atan2(area, a + b - e);
    if (area > 0) result.slope += e / area;
  }
  return result;
}

double Vertex_star::flat_angle() const { return (is_on_border_ ? 1 : 2) * std::numbers::pi; }

// A spoke is Delaunay while the cosines of the angles opposite to it do not sum below zero: times
// the root of s, that is linear in s.
Vertex_star::Bound Vertex_star::bound_above(const Coarse_mesh& mesh) const {
  Bound result{std::numeric_limits<double>::infinity(), Gluing::none};
  const std::size_t n = rim_.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double a = spoke_[k], b = spoke_[after(k)], d = std::sqrt(a) - std::sqrt(b);
    if (d != 0) result.factor = std::min(result.factor, rim_[k] / (d * d));
  }
  for (std::size_t k = is_on_border_ ? 1 : 0; k < n; ++k) {
    if (!mesh.is_flippable(sides_[k])) continue;
    const std::size_t j = k == 0 ? n - 1 : k - 1;
    const double a = spoke_[k], b = spoke_[j], c = spoke_[after(k)];
    const double p = (b - a) / std::sqrt(b * rim_[j]) + (c - a) / std::sqrt(c * rim_[k]);
    if (!(p < 0)) continue;
    const double s = (std::sqrt(rim_[j] / b) + std::sqrt(rim_[k] / c)) / -p;
    if (s <= result.factor) result = {s, sides_[k]};
  }
  result.factor = std::max(result.factor, 1.);
  return result;
}

// A rim edge, likewise; the angle opposite to it across the star does not change, unless that is
// in the star.
Vertex_star::Bound Vertex_star::bound_below(const Coarse_mesh& mesh) const {
  Bound result{0, Gluing::none};
  for (std::size_t k = 0; k < rim_.size(); ++k) {
    const double c = std::sqrt(spoke_[k]) + std::sqrt(spoke_[after(k)]);
    result.factor = std::max(result.factor, rim_[k] / (c * c));
  }
  for (std::size_t k = 0; k < rim_.size(); ++k) {
    const std::uint32_t h = Coarse_mesh::next(sides_[k]);
    if (!mesh.is_flippable(h)) continue;
    const std::uint32_t g = mesh.glued(h), next = Coarse_mesh::next(g),
                        last = Coarse_mesh::previous(g);
    const double e = rim_[k], root = std::sqrt(spoke_[k] * spoke_[after(k)]);
    const double c = mesh.length(next), d = mesh.length(last), other = std::sqrt(c * d);
    double constant = (spoke_[k] + spoke_[after(k)]) / root, falling = e / root;
    if (mesh.origin(last) == mesh.origin(sides_[k])) { // the face across is in the star
      constant += (c + d) / other;
      falling += e / other;
    } else {
      constant += (c + d - e) / other;
    }
    const double s = falling / constant;
    if (constant > 0 && s >= result.factor) result = {s, h};
  }
  result.factor = std::min(result.factor, 1.);
  return result;
}

void Vertex_star::scale(Coarse_mesh& mesh, double factor) {
  for (double& a : spoke_) a *= factor;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    Coarse_face& f = mesh.change(sides_[k] / 3);
    f.length[sides_[k] % 3] = spoke_[k];
    f.length[Coarse_mesh::previous(sides_[k]) % 3] = spoke_[after(k)];
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
