// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

Integer_coordinates::Integer_coordinates() = default;
Integer_coordinates::Integer_coordinates(const Integer_coordinates&) = default;
Integer_coordinates::Integer_coordinates(Integer_coordinates&&) = default;
Integer_coordinates& Integer_coordinates::operator=(const Integer_coordinates&) = default;
Integer_coordinates& Integer_coordinates::operator=(Integer_coordinates&&) = default;
Integer_coordinates::~Integer_coordinates() = default;

Integer_coordinates::Integer_coordinates(std::shared_ptr<const Input> input, Vertex_fans fans,
                                         std::vector<Normal_coordinate> normal,
                                         std::vector<std::uint32_t> roundabout,
                                         std::vector<Surface_point> location)
    : input_(std::move(input)), fans_(std::move(fans)), normal_(std::move(normal)),
      roundabout_(std::move(roundabout)), location_(std::move(location)) {}

void Integer_coordinates::set_location(std::uint32_t vertex, const Surface_point& location) {
  const std::size_t i = vertex - input_->number_of_vertices();
  if (i >= location_.size()) location_.resize(i + 1);
  location_[i] = location;
}

void Integer_coordinates::start_curves_on_side(std::uint32_t h,
                                               const std::array<std::uint32_t, 3>& to) {
  const std::uint32_t to_target = fans_.add_fan_on_edge(insertion_.location.halfedge);
  roundabout_[to[0] ^ 1U] = roundabout_[to[2] ^ 1U] = to_target + 1;
  roundabout_[to[1] ^ 1U] = to_target;
  roundabout_[to[0]] = roundabout_[h];
  roundabout_[to[1]] = roundabout_[h ^ 1U];
  normal_[h / 2] = 0;
  roundabout_[h ^ 1U] = fans_.advance(roundabout_[h ^ 1U], 1);
}

void Integer_coordinates::start_curves_in_face(const std::array<std::uint32_t, 3>& to) {
  const unsigned k = insertion_.region.corner;
  const bool in_fan = k == insertion_.region.fan_corner;
  // the location's halfedge leaves the face through side k, or starts from corner k
  const std::uint32_t slot = fans_.add_fan_on_edge(insertion_.location.halfedge);
  const std::uint32_t ahead = slot, back = slot + 1;
  const auto out = [&](unsigned corner) -> std::uint32_t& {
    return roundabout_[to[corner % 3] ^ 1U];
  };
  out(k) = in_fan ? back : ahead;
  out(k + 1) = in_fan ? ahead : back;
  out(k + 2) = back;
}

} // namespace CGAL::Intrinsic_triangulations
