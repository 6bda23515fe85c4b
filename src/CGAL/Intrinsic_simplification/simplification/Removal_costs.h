// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_REMOVAL_COSTS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_REMOVAL_COSTS_H

#include <CGAL/Intrinsic_simplification/simplification/Coarse_mesh.h>
#include <CGAL/Intrinsic_simplification/simplification/Fine_surface.h>
#include <CGAL/Intrinsic_simplification/simplification/Simplification.h>
#include <CGAL/Intrinsic_simplification/simplification/Vertex_star.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// What removals cost: the stretch that they cause, or the mass that they move, times how far it has
// come, as Liu et al. (2023) do. They remember a vector for that; here it is a distance.
class Removal_costs {
public:
  Removal_costs(const Fine_surface& fine, const Coarse_mesh& mesh, const Simplify_options& options);

  double cost(const Coarse_mesh& mesh, const Vertex_star& star, std::uint32_t v);
  // The greatest cost that is allowed, in the units of `cost()`: mass is in scaled units.
  double bound() const;
  // Remembers the neighbours of a vertex, before it becomes flat.
  void remember(const Coarse_mesh& mesh, const Vertex_star& star);
  // Moves the mass of a vertex that is gone to the neighbours that are remembered.
  void move_mass(std::uint32_t v);
  bool moves_mass() const { return !mass_.empty(); }
  // Whether costs are spreads of the bounds of faces, expected ones.
  bool are_stretches() const { return !moves_mass() && !options_.own_cost; }

private:
  // A mass at a vertex, and how far it is from where it was, in the mean.
  struct Mass {
    double amount = 0, distance = 0;
  };
  static constexpr std::size_t channels = 3; // positive and negative curvature, area

  double cost_of_stretch(const Coarse_mesh& mesh, const Vertex_star& star, double curvature,
                         double slope) const;
  double cost_of_mass(const Vertex_star& star, std::uint32_t v);
  Removal_candidate candidate(const Vertex_star& star, std::uint32_t v, double curvature,
                              double stretch) const;
  void find_shares(const Vertex_star& star);

  const Fine_surface& fine_;
  const Simplify_options& options_;
  std::vector<std::array<Mass, channels>> mass_; // of each vertex; empty: not asked for
  std::vector<double> shares_;                   // of the spokes of a star
  struct Neighbour {
    std::uint32_t vertex;
    double share, distance;
  };
  std::vector<Neighbour> neighbours_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_REMOVAL_COSTS_H
