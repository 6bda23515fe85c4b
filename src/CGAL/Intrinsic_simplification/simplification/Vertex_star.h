// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_VERTEX_STAR_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_VERTEX_STAR_H

#include <CGAL/Intrinsic_simplification/simplification/Coarse_mesh.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The faces at a vertex, counterclockwise, and the squared lengths of their sides: those of spokes
// are multiplied by a factor s while the vertex becomes flat, and those of edges from the vertex to
// itself by s^2. The corner of face k is between spokes k and k + 1.
class Vertex_star {
public:
  // A sum of angles, and by how much it falls with the logarithm of s.
  struct Angles {
    double sum = 0, slope = 0;
  };

  // A factor at which an edge is no longer Delaunay, or a face no longer a triangle.
  struct Bound {
    double factor;
    std::uint32_t side;                // of the edge; none: a face
    std::uint32_t face = Gluing::none; // the face, by its number in the star; none: not known
  };

  // Finds the faces. Returns whether there are any.
  bool find(const Coarse_mesh& mesh, std::uint32_t v);
  // Whether no edge is from the vertex to itself: each face is there once.
  bool is_proper() const { return is_proper_; }

  std::size_t size() const { return sides_.size(); }
  bool is_on_border() const { return is_on_border_; }
  // The side from the vertex that begins the corner of face k.
  std::uint32_t side(std::size_t k) const { return sides_[k]; }
  const std::vector<std::uint32_t>& sides() const { return sides_; }
  double spoke(std::size_t k) const { return spoke_[k]; }
  std::size_t number_of_spokes() const { return spoke_.size(); }
  double rim(std::size_t k) const { return rim_[k]; }
  // The spoke after spoke k.
  std::size_t after(std::size_t k) const { return k + 1 == spoke_.size() ? 0 : k + 1; }
  // The side that starts where spoke k ends: of the rim, on the border the last one of the star.
  std::uint32_t rim_corner(std::size_t k) const {
    return k < sides_.size() ? Coarse_mesh::next(sides_[k]) : Coarse_mesh::previous(sides_[k - 1]);
  }

  // The angles at the vertex for a factor.
  Angles angles(const Coarse_mesh& mesh, double factor) const;
  // The sum of the angles when the star is flat.
  double flat_angle() const;
  // The smallest factor above 1 with which the triangulation changes, and the greatest below 1; if
  // it does already, 1.
  Bound bound_above(const Coarse_mesh& mesh) const;
  Bound bound_below(const Coarse_mesh& mesh) const;
  // Multiplies spokes, here and in the mesh.
  void scale(Coarse_mesh& mesh, double factor);

private:
  double scaled(const Coarse_mesh& mesh, std::uint32_t h, double factor) const;
  double cosine(const Coarse_mesh& mesh, std::uint32_t h, double factor) const;
  Angles angles_with_loops(const Coarse_mesh& mesh, double factor) const;
  std::uint32_t changed_edge(const Coarse_mesh& mesh, double factor) const;
  Bound search_bound(const Coarse_mesh& mesh, bool above) const;

  std::vector<std::uint32_t> sides_;
  std::vector<double> spoke_; // one more than faces on the border
  std::vector<double> rim_;
  std::uint32_t vertex_ = Gluing::none;
  bool is_on_border_ = false;
  bool is_proper_ = true;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_VERTEX_STAR_H
