// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_LAYOUT_PLANE_PIECES_H
#define CGAL_INTRINSIC_CONFORMAL_LAYOUT_PLANE_PIECES_H

#include <CGAL/Intrinsic_conformal/layout/Glued_pieces.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>

#include <Eigen/Core>

#include <complex>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Convex polygons that are glued along sides, each known in a frame of its own.
struct Plane_pieces : Glued_pieces {
  using Complex = std::complex<double>;

  std::vector<Complex> side; // from each corner to the next one of its piece
  std::vector<Complex> turn; // of each side that is glued: the frame across, in that of the piece

  // the longest side of a piece
  double extent(std::uint32_t p) const;
};

// Pieces laid out next to each other.
struct Developed_pieces {
  std::vector<std::complex<double>> position; // of each vertex
  std::vector<std::complex<double>> rotation; // of the frame of each piece, of length 1
  double largest_error = 0;                   // of a side, relative to the longest one of its piece
};

// Lays pieces out that form disks. Frames follow from each other, breadth first, small pieces
// before much larger ones; places are those of least squares for relative differences of sides.
Developed_pieces develop(const Plane_pieces& pieces);

// The sides of triangles, each in the frame of its side 0, as complex numbers.
// \throws Invalid_input naming a face that no triangle has the sides of, or with sides beyond the
//   range of doubles
std::vector<std::complex<double>> sides_of_triangles(const Surface_to_cut& s);

// The frame beyond a side in the frame before it, from the vectors of that side in both.
std::complex<double> turn_across(std::complex<double> side, std::complex<double> partner);

// Points as rows.
Eigen::MatrixX2d rows_of_points(const std::vector<std::complex<double>>& points);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_CONFORMAL_LAYOUT_PLANE_PIECES_H
