// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_VERTEX_STAR_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_VERTEX_STAR_H

#include <CGAL/Intrinsic_simplification/simplification/Coarse_mesh.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
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

  std::size_t size() const { return size_; }
  bool is_on_border() const { return is_on_border_; }
  // The side from the vertex that begins the corner of face k.
  std::uint32_t side(std::size_t k) const { return sides_[k]; }
  std::span<const std::uint32_t> sides() const { return {sides_.data(), size_}; }
  double spoke(std::size_t k) const { return spoke_[k]; }
  std::size_t number_of_spokes() const { return size_ + (is_on_border_ ? 1 : 0); }
  double rim(std::size_t k) const { return rim_[k]; }
  // The spoke after spoke k.
  std::size_t after(std::size_t k) const { return k + 1 == number_of_spokes() ? 0 : k + 1; }
  // The side that starts where spoke k ends: of the rim, on the border the last one of the star.
  std::uint32_t rim_corner(std::size_t k) const {
    return k < size_ ? Coarse_mesh::next(sides_[k]) : Coarse_mesh::previous(sides_[k - 1]);
  }

  // The angles at the vertex for a factor.
  Angles angles(const Coarse_mesh& mesh, double factor) const;
  // The angles as they are, found once: costs need them, and then the search for the factor.
  const Angles& angles(const Coarse_mesh& mesh) {
    if (!std::exchange(has_angles_, true)) angles_ = angles(mesh, 1);
    return angles_;
  }
  // The greatest spread of the faces.
  double spread() const { return static_cast<double>(spread_); }
  // The sum of the angles when the star is flat.
  double flat_angle() const;
  // The smallest factor above 1 with which the triangulation changes, and the greatest below 1; if
  // it does already, 1.
  Bound bound_above(const Coarse_mesh& mesh) const;
  Bound bound_below(const Coarse_mesh& mesh) const;
  // Multiplies spokes, here and in the mesh.
  void scale(Coarse_mesh& mesh, double factor);

private:
  // a constant, and a factor of s
  struct Linear_value {
    double constant = 0, slope = 0;
  };

  void grow();
  double scaled(const Coarse_mesh& mesh, std::uint32_t h, double factor) const;
  Angles angles_with_loops(const Coarse_mesh& mesh, double factor) const;
  Linear_value cosine(const Coarse_mesh& mesh, std::uint32_t h) const;
  Bound bound_with_loops(const Coarse_mesh& mesh, bool above) const;

  // as long as the largest star so far, and one more
  std::vector<std::uint32_t> sides_;
  std::vector<double> spoke_; // one more than faces on the border
  std::vector<double> rim_;
  std::size_t size_ = 0; // number of faces
  Angles angles_;
  float spread_ = 0;
  bool has_angles_ = false;
  std::uint32_t vertex_ = Gluing::none;
  bool is_on_border_ = false;
  bool is_proper_ = true;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_VERTEX_STAR_H
