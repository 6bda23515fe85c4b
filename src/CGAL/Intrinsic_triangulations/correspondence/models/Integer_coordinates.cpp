// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Crossing_run.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/reserve_at_least.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
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

std::vector<std::uint32_t> Integer_coordinates::entered_on(std::uint32_t edge) const {
  std::vector<std::uint32_t> result;
  for_each_run_of(2 * edge, 0, crossings(normal_[edge]), [&](const Crossing_run& run) {
    for (std::uint32_t i = 0; i < run.count(); ++i) result.push_back(run(fans_, i));
  });
  return result;
}

void Integer_coordinates::make_room(std::uint32_t vertices, std::uint32_t edges) {
  reserve_at_least(location_, vertices - input_->number_of_vertices());
  reserve_at_least(normal_, edges);
  reserve_at_least(roundabout_, 2 * std::size_t{edges});
  fans_.make_room();
  if (kept_) kept_.make_room(edges);
}

void Integer_coordinates::grow(std::uint32_t halfedge) {
  const std::size_t edges = halfedge / 2 + 1;
  if (edges <= normal_.size()) return;
  normal_.resize(edges);
  roundabout_.resize(2 * edges, Gluing::none);
  if (kept_) kept_.grow(edges);
}

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

void Integer_coordinates::follow(const Insertion_in_face& move) {
  const std::array<std::uint32_t, 3>& to = move.spokes;
  for (const std::uint32_t s : to) grow(s);
  set_location(move.vertex, insertion_.location);
  for (unsigned k = 0; k < 3; ++k) {
    normal_[to[k] / 2] = insertion_.normal[k];
    roundabout_[to[k]] = insertion_.roundabout[k];
    roundabout_[to[k] ^ 1U] = Gluing::none;
    if (kept_) kept_.store_spoke(fans_, k, to[k], insertion_.normal[k]);
  }
  if (insertion_.along_side)
    start_curves_on_side(move.sides[0], to);
  else if (insertion_.region.is_on_curve)
    start_curves_in_face(to);
}

void Integer_coordinates::follow(const Insertion_on_border& move) {
  const auto [ip, pk, pj] = std::array{move.ip, move.pk, move.pj};
  for (const std::uint32_t s : {ip, pk, pj}) grow(s);
  set_location(move.vertex, insertion_.location);
  const std::uint32_t slot = fans_.add_fan_on_edge(insertion_.location.halfedge);
  normal_[ip / 2] = normal_[pj / 2] = -1;
  normal_[pk / 2] = insertion_.normal[2];
  roundabout_[pk ^ 1U] = insertion_.roundabout[2];
  roundabout_[pj ^ 1U] = roundabout_[ip ^ 1U];
  roundabout_[pj] = slot;
  roundabout_[pk] = roundabout_[ip ^ 1U] = slot + 1;
  // parts of the border edge have no crossings
  if (kept_) kept_.store_spoke(fans_, 2, pk ^ 1U, insertion_.normal[2]);
}

void Integer_coordinates::follow(const Removal_from_face& move) {
  const std::array<std::uint32_t, 3>&to = move.spokes, &sides = move.sides;
  for (unsigned k = 0; k < 3; ++k) {
    const std::uint32_t a = to[k], b = to[(k + 1) % 3];
    if (normal_[a / 2] >= 0 || normal_[b / 2] >= 0) continue;
    // a and b are two parts of one straight curve, which the side between their ends lies on
    normal_[sides[k] / 2] = -1;
    roundabout_[sides[k]] = roundabout_[a];
    roundabout_[sides[k] ^ 1U] = roundabout_[b];
  }
  if (roundabout_[to[0] ^ 1U] != Gluing::none) fans_.remove_fan(roundabout_[to[0] ^ 1U]);
  for (const std::uint32_t s : to) normal_[s / 2] = 0;
  if (kept_)
    for (const std::uint32_t s : to) kept_.clear(s / 2);
}

void Integer_coordinates::follow(const Removal_from_border& move) {
  fans_.remove_fan(roundabout_[move.pj]);
  roundabout_[move.ip ^ 1U] = roundabout_[move.pj ^ 1U];
  normal_[move.pj / 2] = normal_[move.pk / 2] = 0;
  if (kept_) kept_.clear(move.pk / 2);
}

} // namespace CGAL::Intrinsic_triangulations
