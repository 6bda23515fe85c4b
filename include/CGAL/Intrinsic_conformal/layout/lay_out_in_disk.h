// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_LAYOUT_LAY_OUT_IN_DISK_H
#define CGAL_INTRINSIC_CONFORMAL_LAYOUT_LAY_OUT_IN_DISK_H

#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/*!
\file
Layouts of hyperbolic surfaces in Poincaré's disk: the surface is cut to a disk, and the disk is
developed, triangle after triangle.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a motion of the hyperbolic plane that keeps orientations: in Poincaré's disk the Möbius
transformation \f$z \mapsto (a z + b) / (\bar b z + \bar a)\f$, with \f$|a|^2 - |b|^2 = 1\f$.

Two of them with opposite signs of both numbers are the same motion.
*/
struct Disk_motion {
  std::complex<double> a = 1; ///< its modulus is cosh(d/2) if the centre is moved by d
  std::complex<double> b = 0; ///< its modulus is sinh(d/2)

  /// returns the image of a point.
  std::complex<double> operator()(std::complex<double> z) const {
    return (a * z + b) / (std::conj(b) * z + std::conj(a));
  }
  /// returns the motion `m` followed by this one.
  Disk_motion operator*(const Disk_motion& m) const {
    return {a * m.a + b * std::conj(m.b), a * m.b + b * std::conj(m.a)};
  }
  /// returns the inverse.
  Disk_motion inverse() const { return {std::conj(a), -b}; }
};

/*!
\brief is a part of a cut with one motion: it takes the places of points on one side to those on the
other.
*/
struct Disk_seam {
  /// Sides of faces with the one copy of the seam, one after another.
  std::vector<std::uint32_t> sides;
  /// The sides with the other copy, in the same order; each runs against its partner.
  std::vector<std::uint32_t> partners;
  /// The motion.
  Disk_motion motion;
};

/*!
\brief holds the motions by which copies of a cut in the hyperbolic plane fit together. Those of a
closed surface without cones generate its fundamental group, as a discrete group of motions.
*/
struct Side_pairings {
  /// The parts of the cut.
  std::vector<Disk_seam> seams;
  /// The largest hyperbolic distance by which the motion of a seam misses a vertex.
  double largest_seam_error = 0;
  /// \brief How far products of motions are from the identity.
  ///
  /// Around each vertex of the cut that is not a cone, the motions of the seams there have the
  /// product 1: the relations of the group. This is the largest distance of entries of a product,
  /// in the frame of the vertex, from those of plus or minus the unit matrix.
  double largest_relation_error = 0;
};

/*!
\brief is the layout of a hyperbolic surface in Poincaré's disk.
*/
struct Disk_layout {
  /// The surface cut open: disks, and their vertices.
  Opened_surface surface;
  /// The place of each vertex of `surface` in the unit disk. Each component lies about the centre.
  Eigen::MatrixX2d positions;
  /// The parts of the cut.
  Side_pairings pairings;
  /// The largest difference of the distance of the ends of a side from its length, relative to the
  /// longest side of the triangle.
  double largest_side_error = 0;
  /// The largest hyperbolic distance of a vertex from the centre.
  double radius = 0;
  /// The number of triangles that are not counterclockwise; it is exact for the places as they are.
  std::size_t flipped_faces = 0;
};

/*!
\brief lays a surface with hyperbolic triangles out in Poincaré's disk.

The surface is cut by `cut_to_round_disk()`, through all cones, and triangles are placed next to
each other, breadth first, from the one at the centre: motions of the plane take the frame of a
triangle to that of its neighbour. The centre is the point for which the sum of the hyperbolic
cosines of the distances to all vertices is least. Doubles reach as far as
about 30 from the centre.

Triangles of the plane have geodesic sides, which are arcs in Poincaré's disk. In Klein's model of
the plane, where z is at 2 z / (1 + |z|^2), they are straight, so that the orientation of a triangle
is a sign of rational numbers.

\param s the surface with hyperbolic lengths, such as `hyperbolic_surface()` returns
\param cones the vertices inside where angles do not sum to 2 pi
\param centers how many faces are tried as centres of the cut
\return the layout. Its errors tell where the surface is not hyperbolic at a vertex that is not a
  cone
\throws Invalid_input if the surface is not oriented, or no triangle has the sides of a face
\pre `validate(s.gluing)` does not throw
\complexity that of `cut_to_round_disk()`, and linear
*/
Disk_layout lay_out_in_disk(const Surface_to_cut& s, std::span<const std::uint32_t> cones = {},
                            std::size_t centers = 8);

/*!
\brief tells exactly how three points of Poincaré's disk turn as corners of a hyperbolic triangle.
\param p, q, r the points
\return 1 if they are counterclockwise, -1 if clockwise, 0 if on one geodesic
*/
int orientation_in_disk(std::complex<double> p, std::complex<double> q, std::complex<double> r);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_CONFORMAL_LAYOUT_LAY_OUT_IN_DISK_H
