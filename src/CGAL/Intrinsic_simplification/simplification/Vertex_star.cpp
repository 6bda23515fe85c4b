// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/Vertex_star.h>

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

bool Vertex_star::find(const Coarse_mesh& mesh, std::uint32_t v) {
  const std::uint32_t first = mesh.outgoing(v);
  vertex_ = v;
  size_ = 0;
  spread_ = 0;
  is_on_border_ = has_angles_ = false;
  is_proper_ = true;
  if (first == Gluing::none) return false;
  for (std::uint32_t h = first;;) {
    const Coarse_face& f = mesh.face(h / 3);
    const std::uint32_t k = h % 3, n = Gluing::next(k), l = Gluing::next(n);
    if (size_ + 2 > sides_.size()) grow();
    sides_[size_] = h;
    spoke_[size_] = f.length[k];
    rim_[size_++] = f.length[n];
    spread_ = std::max(spread_, f.spread);
    if (f.origin[n] == v || f.origin[l] == v) is_proper_ = false;
    h = f.glue[l];
    if (h == Gluing::none) {
      is_on_border_ = true;
      spoke_[size_] = f.length[l];
      break;
    }
    if (h == first) break;
  }
  return true;
}

void Vertex_star::grow() {
  const std::size_t size = 2 * sides_.size() + 16;
  sides_.resize(size);
  spoke_.resize(size);
  rim_.resize(size);
}

Vertex_star::Angles Vertex_star::angles(const Coarse_mesh& mesh, double factor) const {
  if (!is_proper_) return angles_with_loops(mesh, factor);
  // the angles as arguments of complex numbers, whose product is kept in the upper half plane
  double x = 1, y = 0, slope = 0;
  int half_turns = 0;
  for (std::size_t k = 0; k < size_; ++k) {
    const double a = factor * spoke_[k], b = factor * spoke_[after(k)], e = rim_[k];
    const double area = quadruple_area_of(a, b, e), p = a + b - e;
    const double scale = 1 / (std::abs(p) + area), c = p * scale, s = area * scale;
    const double turned = x * c - y * s;
    y = x * s + y * c;
    x = turned;
    // where it turns cannot be predicted: nothing branches on it
    const bool turns = (y < 0) | ((y == 0) & (x < 0));
    constexpr std::array<double, 2> signs{1, -1};
    x *= signs[turns];
    y *= signs[turns];
    half_turns += turns;
    if (area > 0) slope += e / area;
    if (std::abs(x) + y < 0x1p-500) { // vertices of huge degree
      x *= 0x1p500;
      y *= 0x1p500;
    }
  }
  return {half_turns * std::numbers::pi + std::atan2(y, x), slope};
}

double Vertex_star::flat_angle() const { return (is_on_border_ ? 1 : 2) * std::numbers::pi; }

// A spoke is Delaunay while the cosines of the angles opposite to it do not sum below zero: times
// the root of s, that is linear in s.
Vertex_star::Bound Vertex_star::bound_above(const Coarse_mesh& mesh) const {
  if (!is_proper_) return bound_with_loops(mesh, true);
  Bound result{std::numeric_limits<double>::infinity(), Gluing::none};
  const std::size_t n = size_;
  for (std::size_t k = 0; k < n; ++k) {
    const double a = spoke_[k], b = spoke_[after(k)], d = std::sqrt(a) - std::sqrt(b);
    if (d == 0 || !(rim_[k] / (d * d) < result.factor)) continue;
    result = {rim_[k] / (d * d), Gluing::none, static_cast<std::uint32_t>(k)};
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
  if (!is_proper_) return bound_with_loops(mesh, false);
  Bound result{0, Gluing::none};
  for (std::size_t k = 0; k < size_; ++k) {
    const double c = std::sqrt(spoke_[k]) + std::sqrt(spoke_[after(k)]);
    if (rim_[k] / (c * c) > result.factor)
      result = {rim_[k] / (c * c), Gluing::none, static_cast<std::uint32_t>(k)};
  }
  for (std::size_t k = 0; k < size_; ++k) {
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

double Vertex_star::scaled(const Coarse_mesh& mesh, std::uint32_t h, double factor) const {
  double l = mesh.length(h);
  if (mesh.origin(h) == vertex_) l *= factor;
  if (mesh.origin(Coarse_mesh::next(h)) == vertex_) l *= factor;
  return l;
}

// With loops: the angles of a face at two of its corners change as much as that at the third one,
// the other way.
Vertex_star::Angles Vertex_star::angles_with_loops(const Coarse_mesh& mesh, double factor) const {
  Angles result;
  for (const std::uint32_t h : sides()) {
    const std::uint32_t next = Coarse_mesh::next(h), last = Coarse_mesh::previous(h);
    const double a = scaled(mesh, h, factor), e = scaled(mesh, next, factor),
                 b = scaled(mesh, last, factor);
    const double area = quadruple_area_of(a, b, e);
    result.sum += std::atan2(area, a + b - e);
    const bool is_first = mesh.origin(next) == vertex_, is_second = mesh.origin(last) == vertex_;
    if (area > 0 && !(is_first && is_second))
      result.slope += (is_first ? a / 2 : is_second ? b / 2 : e) / area;
  }
  return result;
}

// Twice the cosine of the angle opposite a side, times a power of s that is the same on the other
// side of the edge. A side with k ends at the vertex is multiplied by s^k, in a face with m corners
// there. Each of a, b and e in (a + b - e) / sqrt(a b) then has the power k + 1 - m: 0 or 1.
Vertex_star::Linear_value Vertex_star::cosine(const Coarse_mesh& mesh, std::uint32_t h) const {
  const std::array<std::uint32_t, 3> sides{h, Coarse_mesh::next(h), Coarse_mesh::previous(h)};
  const auto ends = [&](std::uint32_t s) { return mesh.origin(s) == vertex_ ? 1 : 0; };
  const int corners = ends(sides[0]) + ends(sides[1]) + ends(sides[2]);
  Linear_value result;
  for (std::size_t i = 0; i < 3; ++i) {
    const int power = ends(sides[i]) + ends(sides[(i + 1) % 3]) + 1 - corners;
    (power == 0 ? result.constant : result.slope) += (i == 0 ? -1 : 1) * mesh.length(sides[i]);
  }
  const double root = std::sqrt(mesh.length(sides[1]) * mesh.length(sides[2]));
  return {result.constant / root, result.slope / root};
}

// Edges as above, and also those that are not Delaunay now. A face that becomes straight gives no
// bound if its longest side cannot be flipped. Edges from the vertex to itself can stay cocircular
// for all factors: the tolerance keeps rounding from flipping them for ever.
Vertex_star::Bound Vertex_star::bound_with_loops(const Coarse_mesh& mesh, bool above) const {
  constexpr double tolerance = 1e-11; // of sums of cosines, far above rounding
  Bound result{above ? std::numeric_limits<double>::infinity() : 0, Gluing::none};
  for (const std::uint32_t side : sides())
    for (const std::uint32_t h : {side, Coarse_mesh::next(side)}) {
      if (!mesh.is_flippable(h)) continue;
      const Linear_value c = cosine(mesh, h), d = cosine(mesh, mesh.glued(h));
      const double slope = c.slope + d.slope, constant = c.constant + d.constant + tolerance;
      if (constant + slope < 0) return {1, h};
      if (!(above ? slope < 0 : slope > 0)) continue; // the sum grows
      const double s = -constant / slope;
      if (above ? s < result.factor : s > result.factor) result = {s, h};
    }
  result.factor = above ? std::max(result.factor, 1.) : std::min(result.factor, 1.);
  return result;
}

void Vertex_star::scale(Coarse_mesh& mesh, double factor) {
  has_angles_ = false;
  if (!is_proper_) {
    std::vector<std::pair<std::uint32_t, double>> lengths; // before any of them changes
    for (const std::uint32_t s : sides())
      for (const std::uint32_t h : {s, Coarse_mesh::next(s), Coarse_mesh::previous(s)})
        lengths.emplace_back(h, scaled(mesh, h, factor));
    for (const auto& [h, l] : lengths) mesh.change(h / 3).length[h % 3] = l;
    return;
  }
  for (std::size_t k = 0; k < number_of_spokes(); ++k) spoke_[k] *= factor;
  for (std::size_t k = 0; k < size_; ++k) {
    Coarse_face& f = mesh.change(sides_[k] / 3);
    f.length[sides_[k] % 3] = spoke_[k];
    f.length[Coarse_mesh::previous(sides_[k]) % 3] = spoke_[after(k)];
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
