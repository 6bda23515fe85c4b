// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/Candidates.h>

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <numbers>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

double area_of(const Vertex_star& star) { // a third of the faces
  double sum = 0;
  for (std::size_t k = 0; k < star.size(); ++k)
    sum += quadruple_area_of(star.spoke(k), star.spoke(star.after(k)), star.rim(k));
  return sum / 12;
}

double mean_length_of(const Vertex_star& star) {
  double sum = 0;
  for (std::size_t k = 0; k < star.number_of_spokes(); ++k) sum += std::sqrt(star.spoke(k));
  return sum / static_cast<double>(star.number_of_spokes());
}

// The spread of the faces at the vertex, and what their factor adds to it: that is about the
// curvature divided by the sum of the cotangent weights, a Newton step.
double expected_stretch(const Vertex_star& star, double curvature, double slope) {
  return star.spread() + 2 * std::abs(curvature) / std::max(slope, 1e-9);
}

} // namespace

// What part of the curvature each neighbour gets, up to a factor: to first order, that of the
// cotangent weight of its edge.
void Candidates::find_shares(const Vertex_star& star) {
  shares_.assign(star.number_of_spokes(), 0);
  for (std::size_t k = 0; k < star.size(); ++k) {
    const std::size_t j = star.after(k);
    const double a = star.spoke(k), b = star.spoke(j), e = star.rim(k);
    const double area = quadruple_area_of(a, b, e);
    if (!(area > 0)) continue;
    shares_[k] += (b + e - a) / area;
    shares_[j] += (a + e - b) / area;
  }
  for (double& s : shares_) s = std::max(s, 0.); // kept edges need not be Delaunay
}

// Angles from the outgoing side counterclockwise, until the star is closed or at the border.
Candidates::Direction Candidates::direction(const Coarse_mesh& mesh, std::uint32_t side) const {
  const std::uint32_t v = mesh.origin(side), first = mesh.outgoing(v);
  double sum = 0, before = 0, full = 2 * std::numbers::pi;
  for (std::uint32_t h = first;;) {
    if (h == side) before = sum;
    sum += mesh.corner_angle(h);
    h = mesh.glued(Coarse_mesh::previous(h));
    if (h == first) break;
    if (h != Gluing::none) continue;
    full = std::numbers::pi;
    break;
  }
  const double scale = sum > 0 ? full / sum : 1;
  return {axis_[v] + scale * before, scale};
}

// With shares as weights.
double Candidates::mean_squared_length(const Vertex_star& star) const {
  double sum = 0, shares = 0;
  for (std::size_t k = 0; k < shares_.size(); ++k) {
    sum += shares_[k] * star.spoke(k);
    shares += shares_[k];
  }
  return shares > 0 ? sum / shares : 0;
}

void Candidates::find_neighbors(const Coarse_mesh& mesh, const Vertex_star& star, std::uint32_t v) {
  neighbors_.clear();
  spoke_of_.clear();
  double sum = 0;
  for (std::size_t k = 0; k < shares_.size(); ++k) {
    const std::uint32_t n = mesh.origin(star.rim_corner(k));
    if (n == v) continue;
    sum += shares_[k];
    spoke_of_.push_back(k);
    neighbors_.push_back({mesh.number(n), shares_[k],
                          std::ldexp(std::sqrt(star.spoke(k)), -fine_.scale_exponent), 0, 0});
  }
  for (Removal_neighbor& n : neighbors_)
    n.share = sum > 0 ? n.share / sum : 1 / static_cast<double>(neighbors_.size());
}

void Candidates::find_vectors(const Coarse_mesh& mesh, const Vertex_star& star) {
  const Direction first = direction(mesh, star.side(0));
  double here = first.polar;
  for (std::size_t k = 0, n = 0; n < neighbors_.size(); ++k) {
    const bool has_face = k < star.size();
    if (spoke_of_[n] == k) {
      // the side starts the corner that the edge to the vertex ends; on the border it is that edge
      const std::uint32_t s = star.rim_corner(k);
      const Direction there = direction(mesh, s);
      const double back = there.polar + (has_face ? there.scale * mesh.corner_angle(s) : 0);
      neighbors_[n].turn = std::polar(1., back + std::numbers::pi - here);
      neighbors_[n].back = std::polar(neighbors_[n].length, back);
      ++n;
    }
    if (has_face) here += first.scale * mesh.corner_angle(star.side(k));
  }
}

void Candidates::describe(const Coarse_mesh& mesh, Vertex_star& star, std::uint32_t v) {
  const Vertex_star::Angles& angles = star.angles(mesh);
  candidate_.curvature = star.flat_angle() - angles.sum;
  candidate_.stretch = expected_stretch(star, candidate_.curvature, angles.slope);
  if (cost_.is_stretch()) return; // asks for nothing else
  candidate_.number = mesh.number(v);
  candidate_.vertex = fine_.row[candidate_.number];
  candidate_.area = std::ldexp(area_of(star), -2 * fine_.scale_exponent);
  candidate_.mean_length = std::ldexp(mean_length_of(star), -fine_.scale_exponent);
  find_shares(star);
  candidate_.squared_length = std::ldexp(mean_squared_length(star), -2 * fine_.scale_exponent);
  if (cost_.remembers()) find_neighbors(mesh, star, v);
  if (cost_.needs_vectors()) find_vectors(mesh, star);
}

double Candidates::cost(const Coarse_mesh& mesh, Vertex_star& star, std::uint32_t v) {
  describe(mesh, star, v);
  return cost_.cost(candidate_, neighbors_);
}

void Candidates::remove(const Coarse_mesh& mesh) {
  for (const Turned_side& t : mesh.turned_sides())
    if (const std::uint32_t h = mesh.outgoing(t.vertex); h != Gluing::none)
      axis_[t.vertex] += t.angle * direction(mesh, h).scale;
  for (const Described& d : described_) cost_.remove(d.candidate, d.neighbors);
}

} // namespace CGAL::Intrinsic_triangulations::internal
