// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_LAYOUT_DISK_PIECES_H
#define CGAL_INTRINSIC_CONFORMAL_LAYOUT_DISK_PIECES_H

#include <CGAL/Intrinsic_conformal/layout/Developer.h>
#include <CGAL/Intrinsic_conformal/layout/Glued_pieces.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_in_disk.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <complex>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The motion along the real axis of Poincaré's disk that moves its centre by a distance.
Disk_motion translation_along_axis(double distance);

// The place of a point of a side that lies on the positive axis from the centre: in the hyperboloid
// model on the line between the ends of the side, at a part of it.
double place_on_axis(double length, double part);

// Hyperbolic triangles, each with corner 0 in the centre of its frame, and side 0 on the positive
// real axis. For each side the motion that takes the centre to its start and the positive axis to
// the side. Lengths are hyperbolic ones.
// \throws Invalid_input naming a face that no triangle has the sides of
std::vector<Disk_motion> frames_of_sides(const Surface_to_cut& s);

// The motion from the frame of the triangle beyond a side to that before it, where both have the
// side of this length.
Disk_motion motion_across(const Disk_motion& side, double length, const Disk_motion& partner);

// A point of Poincaré's disk, with 1 - |z|^2 to the last digits.
struct Disk_point {
  std::complex<double> z = 0;
  double gap = 1;

  static Disk_point at(std::complex<double> z) { return {z, 1 - std::norm(z)}; }
  explicit operator std::complex<double>() const { return z; }
  double distance(const Disk_point& p) const;
  Disk_point moved(const Disk_motion& m) const;
};

// Convex polygons of the hyperbolic plane, each known in a frame of its own.
struct Disk_pieces : Glued_pieces {
  using Point = Disk_point;
  using Frame = Disk_motion; // from the frame of a piece to the disk

  std::vector<Disk_point> place; // of each corner
  // of each side that is glued or cut: from the frame across to that of the piece
  std::vector<Disk_motion> turn;

  double length(std::uint32_t i, std::uint32_t c) const {
    return place[c].distance(place[next(i, c)]);
  }
  static int size_class(double) { return 0; } // one class: breadth first
  Frame across(const Frame& frame, std::uint32_t c) const;
  Point start(const Frame& frame, std::uint32_t c) const { return place[c].moved(frame); }
  Point end(const Frame& frame, std::uint32_t i, std::uint32_t c, const Point&) const {
    return place[next(i, c)].moved(frame);
  }
  double error(const Frame&, std::uint32_t i, std::uint32_t c, const Point& from,
               const Point& to) const {
    return std::abs(from.distance(to) - length(i, c));
  }
};

// Pieces laid out next to each other, each component about its centre.
struct Developed_disk : Developed<Disk_pieces> {
  double radius = 0; // largest distance from the centre
};

// Lays pieces out that form disks, from those at their centres.
Developed_disk develop(const Disk_pieces& pieces);

// Moves the sides of seams to their partners.
// \param is_cone for each vertex of the pieces
Side_pairings side_pairings(const Disk_pieces& pieces, const Developed_disk& developed,
                            std::vector<Border_seam> seams, const std::vector<char>& is_cone);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_CONFORMAL_LAYOUT_DISK_PIECES_H
