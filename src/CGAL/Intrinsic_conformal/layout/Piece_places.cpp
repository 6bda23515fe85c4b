// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/Disk_pieces.h>
#include <CGAL/Intrinsic_conformal/layout/Piece_places.h>
#include <CGAL/Intrinsic_conformal/layout/Plane_pieces.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// x (1 - x) for a number between 0 and 1. Where x is rounded to one of them, half of the distance
// to the next double stands for the digits that are lost, so that quotients stay finite.
double product_with_complement(double x) {
  return std::max(x, std::numeric_limits<double>::min()) * std::max(1 - x, 0x1p-54);
}

} // namespace

Piece_places::Piece_places(const Flat_subdivision& in)
    : in_(in), s_(in.subdivision),
      pieces_(in.overlay == nullptr ? in.subdivision : in.overlay->subdivision) {
  if (in.is_hyperbolic)
    frames_ = frames_of_sides(in.flat);
  else
    sides_ = sides_of_triangles(in.flat);
  if (in.overlay == nullptr) return;
  next_.resize(s_.corner.size());
  for (std::size_t f = 0; f < s_.number_of_faces(); ++f)
    for (std::uint32_t c = s_.face_begin[f]; c < s_.face_begin[f + 1]; ++c)
      next_[c] = c + 1 == s_.face_begin[f + 1] ? s_.face_begin[f] : c + 1;
}

Piece_places::Weighted Piece_places::at(std::uint32_t c) const {
  const std::uint32_t i = own(c);
  if (in_.overlay == nullptr || pieces_.corner[c] < pieces_.vertices.size()) return at_own(i);
  const double part =
      along(pieces_, c, pieces_.intrinsic_halfedge[c], &Common_subdivision::Crossing::on_intrinsic);
  return between(at_own(i), at_own(next_[i]), part);
}

std::uint32_t Piece_places::side(std::uint32_t c) const {
  const std::uint32_t i = own(c);
  return pieces_.side[c].intrinsic_edge == Gluing::none || s_.side[i].intrinsic_edge == Gluing::none
             ? Gluing::none
             : flat_side(i);
}

Piece_places::Complex Piece_places::turn(std::uint32_t side, std::uint32_t partner) const {
  return turn_across(sides_[side], sides_[partner]);
}

Disk_motion Piece_places::motion(std::uint32_t side, std::uint32_t partner) const {
  return motion_across(frames_[side], in_.flat.length[side], frames_[partner]);
}

Piece_places::Weighted Piece_places::at_own(std::uint32_t own) const {
  const double part =
      along(s_, own, s_.intrinsic_halfedge[own], &Common_subdivision::Crossing::on_intrinsic);
  return {place(flat_side(own), part), weight(own)};
}

Piece_places::Complex Piece_places::place(std::uint32_t h, double along) const {
  if (in_.is_hyperbolic) return frames_[h](place_on_axis(in_.flat.length[h], along));
  Complex z = 0;
  for (std::uint32_t i = h - h % 3; i < h; ++i) z += sides_[i];
  return z + along * sides_[h];
}

double Piece_places::weight(std::uint32_t own) const {
  if (in_.input_lengths.empty()) return std::numeric_limits<double>::quiet_NaN();
  const std::uint32_t h = flat_side(own);
  if (s_.corner[own] < s_.vertices.size()) {
    const double w = in_.factors.empty() ? 1 : in_.factors[in_.flat.gluing.origin[h]];
    return 1 / (w * w);
  }
  const Common_subdivision::Crossing& x = s_.crossings[s_.corner[own] - s_.vertices.size()];
  const double p = x.on_input.parameter, q = x.on_intrinsic.parameter;
  const double l = in_.flat.length[h], lambda = in_.is_hyperbolic ? 2 * std::sinh(l / 2) : l;
  const double result = in_.input_lengths[x.on_input.edge] / lambda *
                        std::sqrt(product_with_complement(p) / product_with_complement(q));
  return in_.is_hyperbolic ? result * std::sqrt(1 + q * (1 - q) * lambda * lambda) : result;
}

// Homogeneous coordinates are linear: q times (z, 1), or times the point of the hyperboloid.
Piece_places::Weighted Piece_places::between(const Weighted& a, const Weighted& b,
                                             double along) const {
  const double p = (1 - along) * a.q, r = along * b.q;
  if (!in_.is_hyperbolic) return {(p * a.z + r * b.z) / (p + r), p + r};
  const double gap_a = 1 - std::norm(a.z), gap_b = 1 - std::norm(b.z);
  // of a sum of time-like vectors of lengths p and r
  const double q =
      std::sqrt((p + r) * (p + r) + 4 * p * r * std::norm(a.z - b.z) / (gap_a * gap_b));
  const double time = p * (1 + std::norm(a.z)) / gap_a + r * (1 + std::norm(b.z)) / gap_b;
  return {(2 * p / gap_a * a.z + 2 * r / gap_b * b.z) / (q + time), q};
}

double along(const Common_subdivision& s, std::uint32_t c, std::uint32_t halfedge,
             Common_subdivision::Edge_point Common_subdivision::Crossing::*on) {
  if (s.corner[c] < s.vertices.size()) return 0;
  const double p = (s.crossings[s.corner[c] - s.vertices.size()].*on).parameter;
  return halfedge % 2 == 0 ? p : 1 - p;
}

} // namespace CGAL::Intrinsic_triangulations::internal
