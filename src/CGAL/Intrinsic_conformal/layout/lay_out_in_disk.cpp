// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/Disk_pieces.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_in_disk.h>
#include <CGAL/Intrinsic_conformal/layout/turn_back.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_round_disk.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// The determinant of the points of Klein's model with homogeneous coordinates (2 x, 2 y, 1 + x^2 +
// y^2), but for a positive factor. Rows are differences from the first one: points are near each
// other.
template <class Number>
Number determinant_in_disk(const std::array<std::complex<double>, 3>& points) {
  const Number x(points[0].real()), y(points[0].imag());
  std::array<Number, 2> dx, dy, dw;
  for (std::size_t k = 0; k < 2; ++k) {
    const Number other_x(points[k + 1].real()), other_y(points[k + 1].imag());
    dx[k] = other_x - x;
    dy[k] = other_y - y;
    dw[k] = dx[k] * (other_x + x) + dy[k] * (other_y + y);
  }
  return x * (dy[0] * dw[1] - dy[1] * dw[0]) - y * (dx[0] * dw[1] - dx[1] * dw[0]) +
         (Number(1) + x * x + y * y) * (dx[0] * dy[1] - dx[1] * dy[0]);
}

Disk_pieces triangles_in_disk(const Surface_to_cut& s, const Opened_surface& opened) {
  Disk_pieces pieces{pieces_of(opened.gluing), {}, {}};
  const std::vector<Disk_motion> frames = frames_of_sides(s);
  pieces.turn.resize(frames.size());
  for (std::size_t h = 0; h < frames.size(); ++h) {
    pieces.place.push_back(Disk_point::at(frames[h](0)));
    if (const std::uint32_t entry = s.gluing.glue[h]; entry != Gluing::none)
      pieces.turn[h] = motion_across(frames[h], s.length[h], frames[Gluing::partner(entry)]);
  }
  return pieces;
}

} // namespace

} // namespace internal

int orientation_in_disk(std::complex<double> p, std::complex<double> q, std::complex<double> r) {
  const std::array<std::complex<double>, 3> points{p, q, r};
  {
    const Protect_FPU_rounding<true> upwards(CGAL_FE_UPWARD);
    const auto d = internal::determinant_in_disk<Interval_nt<false>>(points);
    if (d.inf() > 0) return 1;
    if (d.sup() < 0) return -1;
  }
  return static_cast<int>(CGAL::sign(internal::determinant_in_disk<CGAL::Gmpq>(points)));
}

Disk_layout lay_out_in_disk(const Surface_to_cut& s, std::span<const std::uint32_t> cones,
                            std::size_t centers) {
  internal::expect_oriented(s.gluing);
  Disk_layout result;
  result.surface = cut_open(s.gluing, cut_to_round_disk(s, cones, centers));
  const internal::Disk_pieces pieces = internal::triangles_in_disk(s, result.surface);
  const internal::Developed_disk developed = internal::develop(pieces);
  result.positions = developed.rows();
  result.largest_side_error = developed.largest_error;
  result.radius = developed.radius;
  const std::vector<char> is_cone = internal::copies_of(result.surface, cones);
  result.pairings = internal::side_pairings(
      pieces, developed, internal::seams_of(result.surface, pieces, is_cone), is_cone);
  const std::vector<std::uint32_t>& v = pieces.vertex;
  for (std::uint32_t f = 0; f < pieces.size(); ++f)
    if (internal::is_turned_in_disk(result.positions, {v[3 * f], v[3 * f + 1], v[3 * f + 2]}))
      ++result.flipped_faces;
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
