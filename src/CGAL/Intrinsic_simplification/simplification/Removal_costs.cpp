// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/Removal_costs.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

double area_of(const Vertex_star& star) { // a third of the faces
  double sum = 0;
  for (std::size_t k = 0; k < star.size(); ++k)
    sum += quadruple_area_of(star.spoke(k), star.spoke(star.after(k)), star.rim(k));
  return sum / 12;
}

} // namespace

Removal_costs::Removal_costs(const Fine_surface& fine, const Coarse_mesh& mesh,
                             const Simplify_options& options)
    : fine_(fine), options_(options) {
  if (options.order == Removal_cost::stretch || options.own_cost) return;
  mass_.resize(fine.gluing.number_of_vertices);
  Vertex_star star;
  for (std::uint32_t v = 0; v < mass_.size(); ++v) {
    if (!star.find(mesh, v)) continue;
    const double k = star.flat_angle() - star.angles(mesh, 1).sum;
    if (options.order == Removal_cost::area)
      mass_[v][2].amount = area_of(star);
    else
      mass_[v][k > 0 ? 0 : 1].amount = std::abs(k);
  }
}

// The spread of the faces at the vertex, and what their factor adds to it: that is about the
// curvature divided by the sum of the cotangent weights, a Newton step.
double Removal_costs::cost_of_stretch(const Coarse_mesh& mesh, const Vertex_star& star,
                                      double curvature, double slope) const {
  float spread = 0;
  for (std::size_t n = 0; n < star.size(); ++n)
    spread = std::max(spread, mesh.face(star.side(n) / 3).spread);
  return static_cast<double>(spread) + 2 * std::abs(curvature) / std::max(slope, 1e-9);
}

// Which part of the curvature each neighbour gets: to first order, that of the cotangent weights.
void Removal_costs::find_shares(const Vertex_star& star) {
  shares_.assign(star.number_of_spokes(), 0);
  for (std::size_t k = 0; k < star.size(); ++k) {
    const std::size_t j = star.after(k);
    const double a = star.spoke(k), b = star.spoke(j), e = star.rim(k);
    const double area = quadruple_area_of(a, b, e);
    if (!(area > 0)) continue;
    shares_[k] += (b + e - a) / area;
    shares_[j] += (a + e - b) / area;
  }
  double sum = 0;
  for (double& s : shares_) sum += s = std::max(s, 0.); // kept edges need not be Delaunay
  for (double& s : shares_) s = sum > 0 ? s / sum : 1 / static_cast<double>(shares_.size());
}

double Removal_costs::cost_of_mass(const Vertex_star& star, std::uint32_t v) {
  find_shares(star);
  double sum = 0;
  for (const Mass& m : mass_[v])
    if (m.amount > 0)
      for (std::size_t k = 0; k < shares_.size(); ++k)
        sum += m.amount * shares_[k] * (m.distance + std::sqrt(star.spoke(k)));
  return sum;
}

double Removal_costs::bound() const {
  if (!moves_mass()) return options_.cost;
  const int units = options_.order == Removal_cost::area ? 3 : 1; // of length
  return std::ldexp(options_.cost, units * fine_.scale_exponent);
}

Removal_candidate Removal_costs::candidate(const Vertex_star& star, std::uint32_t v,
                                           double curvature, double stretch) const {
  double length = 0;
  for (std::size_t k = 0; k < star.number_of_spokes(); ++k) length += std::sqrt(star.spoke(k));
  return {fine_.row[v], curvature, std::ldexp(area_of(star), -2 * fine_.scale_exponent),
          std::ldexp(length / static_cast<double>(star.number_of_spokes()), -fine_.scale_exponent),
          stretch};
}

double Removal_costs::cost(const Coarse_mesh& mesh, const Vertex_star& star, std::uint32_t v) {
  if (moves_mass()) return cost_of_mass(star, v);
  const Vertex_star::Angles angles = star.angles(mesh, 1);
  const double curvature = star.flat_angle() - angles.sum;
  const double stretch = cost_of_stretch(mesh, star, curvature, angles.slope);
  return options_.own_cost ? options_.own_cost(candidate(star, v, curvature, stretch)) : stretch;
}

void Removal_costs::remember(const Coarse_mesh& mesh, const Vertex_star& star) {
  find_shares(star);
  neighbours_.clear();
  for (std::size_t k = 0; k < shares_.size(); ++k)
    neighbours_.push_back({mesh.origin(star.rim_corner(k)), shares_[k], std::sqrt(star.spoke(k))});
}

void Removal_costs::move_mass(std::uint32_t v) {
  for (const Neighbour& to : neighbours_) {
    if (to.vertex == v) continue;
    for (std::size_t c = 0; c < channels; ++c) {
      const Mass& m = mass_[v][c];
      Mass& n = mass_[to.vertex][c];
      const double moved = m.amount * to.share;
      if (!(moved > 0)) continue;
      n.distance =
          (n.amount * n.distance + moved * (m.distance + to.distance)) / (n.amount + moved);
      n.amount += moved;
    }
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
