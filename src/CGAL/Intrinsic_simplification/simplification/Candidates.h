// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_CANDIDATES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_CANDIDATES_H

#include <CGAL/Intrinsic_simplification/simplification/Coarse_mesh.h>
#include <CGAL/Intrinsic_simplification/simplification/Fine_surface.h>
#include <CGAL/Intrinsic_simplification/simplification/Vertex_star.h>
#include <CGAL/Intrinsic_simplification/simplification/removal_costs.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// What costs are asked about: vertices that could be removed, in the units of the user.
class Candidates {
public:
  Candidates(const Fine_surface& fine, Asked_cost& cost)
      : fine_(fine), cost_(cost), axis_(cost.needs_vectors() ? fine.row.size() : 0, 0) {}

  double cost(const Coarse_mesh& mesh, Vertex_star& star, std::uint32_t v);
  // Whether costs are spreads of the bounds of faces, expected ones.
  bool are_stretches() const { return cost_.is_stretch(); }
  // Whether directions at vertices are needed.
  bool need_vectors() const { return cost_.needs_vectors(); }
  // Whether the cost follows removals: `describe_all()` has to be called before each of them.
  bool remember() const { return cost_.remembers(); }
  // Describes copies of a vertex, and their neighbours, before they become flat.
  // \param star_of returns the star of a copy
  void describe_all(const Coarse_mesh& mesh, std::span<const std::uint32_t> copies,
                    const auto& star_of) {
    described_.resize(copies.size());
    for (std::size_t n = 0; n < copies.size(); ++n) {
      describe(mesh, star_of(copies[n]), copies[n]);
      described_[n].candidate = candidate_;
      std::swap(described_[n].neighbors, neighbors_);
    }
  }
  // The vertices that were described are gone.
  void remove(const Coarse_mesh& mesh);

private:
  // A direction at a vertex.
  struct Direction {
    double polar; // its polar angle
    double scale; // of angles on the surface
  };

  struct Described {
    Removal_candidate candidate;
    std::vector<Removal_neighbor> neighbors;
  };

  void describe(const Coarse_mesh& mesh, Vertex_star& star, std::uint32_t v);
  void find_shares(const Vertex_star& star);
  double mean_squared_length(const Vertex_star& star) const;
  Direction direction(const Coarse_mesh& mesh, std::uint32_t side) const;
  void find_neighbors(const Coarse_mesh& mesh, const Vertex_star& star, std::uint32_t v);
  void find_vectors(const Coarse_mesh& mesh, const Vertex_star& star);

  const Fine_surface& fine_;
  Asked_cost& cost_;
  Removal_candidate candidate_;
  std::vector<Removal_neighbor> neighbors_;
  std::vector<Described> described_;
  std::vector<double> shares_;        // of the spokes of a star
  std::vector<std::size_t> spoke_of_; // of each neighbour: loops have none
  std::vector<double> axis_;          // the polar angle of the outgoing side of each vertex
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_CANDIDATES_H
