// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_LAYOUT_PLANE_PIECES_H
#define CGAL_INTRINSIC_CONFORMAL_LAYOUT_PLANE_PIECES_H

#include <CGAL/Intrinsic_conformal/layout/Developer.h>
#include <CGAL/Intrinsic_conformal/layout/Glued_pieces.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <complex>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Convex polygons that are glued along sides, each known in a frame of its own.
struct Plane_pieces : Glued_pieces {
  using Complex = std::complex<double>;
  using Point = Complex;
  using Frame = Complex; // a rotation: of length 1

  std::vector<Complex> side; // from each corner to the next one of its piece
  std::vector<Complex> turn; // of each side that is glued: the frame across, in that of the piece

  double length(std::uint32_t, std::uint32_t c) const { return std::abs(side[c]); }
  // Each class has sizes a thousand times those of the one before; 1 is the largest size, so that
  // classes do not depend on the unit of lengths.
  static int size_class(double size) { return std::ilogb(size) / 10; }
  Frame across(const Frame& frame, std::uint32_t c) const {
    const Frame r = frame * turn[c];
    return r / std::abs(r); // the length is 1 but for rounding
  }
  // where a component begins, and where a side ends that starts from a place
  Point start(const Frame&, std::uint32_t) const { return 0; }
  Point end(const Frame& frame, std::uint32_t, std::uint32_t c, const Point& from) const {
    return from + frame * side[c];
  }
  double error(const Frame& frame, std::uint32_t, std::uint32_t c, const Point& from,
               const Point& to) const {
    return std::abs(to - from - frame * side[c]);
  }
};

// Lays pieces out that form disks, each component from its smallest piece. Frames follow from each
// other; places are those of least squares for relative differences of sides.
Developed<Plane_pieces> develop(const Plane_pieces& pieces);

// The sides of triangles, each in the frame of its side 0, as complex numbers.
// \throws Invalid_input naming a face that no triangle has the sides of, or with sides beyond the
//   range of doubles
std::vector<std::complex<double>> sides_of_triangles(const Surface_to_cut& s);

// The frame beyond a side in the frame before it, from the vectors of that side in both.
std::complex<double> turn_across(std::complex<double> side, std::complex<double> partner);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_CONFORMAL_LAYOUT_PLANE_PIECES_H
