// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_LAYOUT_LAY_OUT_ON_SPHERE_H
#define CGAL_INTRINSIC_CONFORMAL_LAYOUT_LAY_OUT_ON_SPHERE_H

#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/*!
\file
Layouts of surfaces of genus 0 on the unit sphere (Springborn, Schröder, Pinkall, Conformal
equivalence of triangle meshes, 2008): one vertex is moved to infinity, the other vertices are laid
out in the plane, and the plane is projected to the sphere.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a map of vertices to the unit sphere.
*/
struct Sphere_layout {
  /// The vertex that is at infinity in the plane; on the sphere it is at (0, 0, 1).
  std::uint32_t pole = 0;
  /// The place of each vertex, of length 1 but for rounding.
  std::vector<std::array<double, 3>> positions;
  /// The length of the mean of the places, by their weights: zero if centring has succeeded.
  double distance_of_mean = 0;
  /// The number of steps of centring.
  std::size_t iterations = 0;
  /// Whether `distance_of_mean` is as small as rounding permits, or the steps ended before.
  bool is_centred = false;
  /// The error of the layout in the plane, see `Flat_layout`.
  double largest_side_error = 0;
  /// The number of triangles that are not counterclockwise seen from outside: that do not have the
  /// centre of the sphere on their inner side. It is exact for the places as they are.
  std::size_t flipped_faces = 0;

  /// tells whether rays from the centre meet the triangles in one point each.
  bool is_injective() const { return flipped_faces == 0; }
};

/*!
\brief lays a closed surface of genus 0 out on the unit sphere.

The triangles without `pole` have Euclid's lengths, and angles that sum to 2 pi at vertices that no
triangle of `pole` has. If these lengths are \f$\lambda_{ij} w_i w_j\f$, and \f$\lambda_{ip}
w_i\f$ is the same for all neighbours i of the pole p, then the layout is discretely conformal to
the lengths \f$\lambda\f$.

Motions of hyperbolic space, which move the sphere by Möbius transformations, put the mean of all
vertices to the centre. The point that is moved there is the minimum of a convex function
(Springborn, A unique representation of polyhedral types, 2005), which Newton's method finds, with a
search along each step. The minimum exists if no point has half of all the weight.

\param s the surface; lengths of the triangles at the pole do not matter
\param pole the vertex to put to infinity
\param weights a weight per vertex, such as its area; empty: all are equal
\return the layout
\throws Invalid_input if the surface is not a closed sphere, if the triangles without the pole are
  not a disk with all other vertices, if sizes disagree or a weight is negative or not finite, and
  as `lay_out_in_plane()` does
\pre `validate(s.gluing)` does not throw
\complexity that of a sparse factorization, and linear in the number of steps, at most 100
*/
Sphere_layout lay_out_on_sphere(const Surface_to_cut& s, std::uint32_t pole,
                                std::span<const double> weights = {});

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_CONFORMAL_LAYOUT_LAY_OUT_ON_SPHERE_H
