// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_LAYOUT_PIECE_PLACES_H
#define CGAL_INTRINSIC_CONFORMAL_LAYOUT_PIECE_PLACES_H

#include <CGAL/Intrinsic_conformal/layout/lay_out_in_disk.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_subdivision.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <complex>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Where the corners of pieces are in the flat or hyperbolic triangles that contain them, each in a
// frame of its own.
class Piece_places {
public:
  using Complex = std::complex<double>;

  // A place, and the number q there: homogeneous coordinates are linear on pieces.
  struct Weighted {
    Complex z;
    double q;
  };

  explicit Piece_places(const Flat_subdivision& in);

  // The faces that are laid out.
  const Common_subdivision& pieces() const { return pieces_; }
  // The place of a corner of the pieces; without input lengths q is not a number.
  Weighted at(std::uint32_t c) const;
  // The side of the flat surface on which the side of a corner lies, or `Gluing::none`.
  std::uint32_t side(std::uint32_t c) const;
  // The vertex of the flat surface at a corner at a vertex of the input.
  std::uint32_t vertex(std::uint32_t c) const { return in_.flat.gluing.origin[flat_side(own(c))]; }
  // From the frame across a side to that of the triangle, in the plane and in the disk.
  Complex turn(std::uint32_t side, std::uint32_t partner) const;
  Disk_motion motion(std::uint32_t side, std::uint32_t partner) const;

private:
  // the corner of the subdivision at which a corner of the pieces is, or from which its side starts
  std::uint32_t own(std::uint32_t c) const {
    return in_.overlay == nullptr ? c : in_.overlay->corner[pieces_.intrinsic_halfedge[c]];
  }
  std::uint32_t flat_side(std::uint32_t own) const {
    return in_.flat.side[s_.intrinsic_halfedge[own]];
  }
  Weighted at_own(std::uint32_t own) const;
  Complex place(std::uint32_t h, double along) const;
  double weight(std::uint32_t own) const;
  Weighted between(const Weighted& a, const Weighted& b, double along) const;

  const Flat_subdivision& in_;
  const Common_subdivision &s_, &pieces_;
  std::vector<Complex> sides_;      // in the plane
  std::vector<Disk_motion> frames_; // in the disk
  std::vector<std::uint32_t> next_; // of each corner of the subdivision, with an overlay
};

// Where corner `c` is along a halfedge that it lies on, if it is the point of an edge.
double along(const Common_subdivision& s, std::uint32_t c, std::uint32_t halfedge,
             Common_subdivision::Edge_point Common_subdivision::Crossing::*on);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_CONFORMAL_LAYOUT_PIECE_PLACES_H
