// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_LAYOUT_FLAT_TORUS_H
#define CGAL_INTRINSIC_CONFORMAL_LAYOUT_FLAT_TORUS_H

#include <CGAL/Intrinsic_conformal/layout/lay_out_in_plane.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>

#include <Eigen/Core>

#include <array>
#include <complex>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a flat torus: the plane modulo two translations.
*/
struct Flat_torus {
  /// A fundamental domain in the plane, turned so that the first translation is along the x-axis.
  Flat_layout layout;
  /// The two translations: the shortest one, and the shortest one of other directions, to its left.
  std::array<std::complex<double>, 2> translations;
  /// \brief The second translation divided by the first. It determines the torus up to similarity.
  ///
  /// It is in the modular domain: its modulus is at least 1, and its real part is between -1/2 and
  /// 1/2. Of two such numbers on the rim, the one with positive real part is taken; those within
  /// 1e-9 of the rim are taken to be there.
  std::complex<double> period;
  /// Coordinates of each vertex of `layout.surface` in the basis of the translations: texture
  /// coordinates that repeat, with differences across seams that are integers, but for rounding.
  Eigen::MatrixX2d coordinates;
};

namespace internal {

// `flat_torus()`. \param is_flat whether it is known to be so: where triangles are smaller than the
// distance of doubles, their places do not tell
Flat_torus lay_out_torus(const Surface_to_cut& s, std::size_t roots, bool is_flat);

} // namespace internal

/*!
\brief lays a flat torus out in the plane, and computes its period.

The translations of the seams of a cut generate all; the shortest ones are found by the reduction of
Lagrange and Gauss.
\param s a closed surface of genus 1 with Euclid's lengths, with angles that sum to 2 pi everywhere
\param roots how many roots the search for a short cut tries
\return the torus
\throws Invalid_input if the surface is not connected, closed and of genus 1, if it is not flat
  (triangles of the layout differ by more than 1e-6), and as `lay_out_in_plane()` does
\pre `validate(s.gluing)` does not throw
\complexity that of `lay_out_in_plane()`
*/
Flat_torus flat_torus(const Surface_to_cut& s, std::size_t roots = 8);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_CONFORMAL_LAYOUT_FLAT_TORUS_H
