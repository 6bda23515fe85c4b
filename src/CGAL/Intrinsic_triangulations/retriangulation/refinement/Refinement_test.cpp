// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_test.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <stdexcept>

namespace CGAL::Intrinsic_triangulations {

void Face_queue::push(std::uint32_t face, double priority) {
  resize(face);
  if (ticket_[face] == 0) ++waiting_;
  ticket_[face] = ++tickets_;
  heap_.push({priority, tickets_, face});
}

std::uint32_t Face_queue::pop() {
  while (ticket_[heap_.top().face] != heap_.top().ticket) heap_.pop();
  const std::uint32_t face = heap_.top().face;
  heap_.pop();
  remove(face);
  return face;
}

void Face_queue::resize(std::uint32_t face) {
  if (face < ticket_.size()) return;
  ticket_.resize(face + std::size_t{1}, 0);
  is_marked_.resize(face + std::size_t{1}, 0);
}

Refinement_test::Refinement_test(double minimum_angle, double maximum_circumradius,
                                 double maximum_edge_length, int scale_exponent) {
  if (!(minimum_angle >= 0 && minimum_angle < 60))
    throw std::invalid_argument("the minimum angle must be at least 0 and below 60 degrees");
  if (!(maximum_circumradius > 0) || !(maximum_edge_length > 0))
    throw std::invalid_argument("the bounds of circumradius and edge length must be positive");
  if (minimum_angle > 0)
    // a little less, since rounding of the tangent should not let smaller angles pass
    cotangent_ = (1 - 0x1p-50) / std::tan(minimum_angle * std::numbers::pi / 180);
  squared_radius_ = squared(maximum_circumradius, scale_exponent);
  squared_length_ = squared(maximum_edge_length, scale_exponent);
}

} // namespace CGAL::Intrinsic_triangulations
