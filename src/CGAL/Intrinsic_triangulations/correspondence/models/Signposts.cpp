// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/reserve_at_least.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/tracing/tangent_frames.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

void Signposts::start_on(std::shared_ptr<const Input> input) {
  input_ = std::move(input);
  frames_ = std::make_shared<const Tangent_frames>(*input_);
  location_.clear();
  signpost_.resize(input_->number_of_halfedges());
  outgoing_.resize(frames_->number_of_fans());
  for (std::uint32_t h = 0; h < signpost_.size(); ++h)
    signpost_[h] = {frames_->cone_angle(h), frames_->fan_of(h)};
  for (std::uint32_t f = 0; f < outgoing_.size(); ++f)
    outgoing_[f] = frames_->halfedge(frames_->fan(f).begin);
}

void Signposts::make_room(std::uint32_t vertices, std::uint32_t edges) {
  reserve_at_least(signpost_, 2 * std::size_t{edges});
  reserve_at_least(location_, vertices - input_->number_of_vertices());
}

internal::Geodesic_walk<Input> Signposts::walk(std::uint32_t h, double turn) const {
  const std::uint32_t f = signpost_[h].fan, fans = number_of_fans();
  const double a = reduced(f, signpost_[h].angle + turn);
  if (f < fans) return {*input_, frames_->corner(f, a)};
  return {*input_, location_[(f - fans) / 2], {std::cos(a), std::sin(a)}};
}

Signposts::Flipped Signposts::before_flip(const Flip& move) const {
  Flipped values{};
  for (unsigned side = 0; side < 2; ++side) {
    const Signpost& s = values.signposts[side] = signpost_[move.ij ^ side];
    values.outgoing[side] = s.fan < number_of_fans() ? outgoing_[s.fan] : Gluing::none;
  }
  return values;
}

void Signposts::store_flip(const Flip& move, const Flipped& values) noexcept {
  for (unsigned side = 0; side < 2; ++side) {
    const Signpost& s = signpost_[move.ij ^ side] = values.signposts[side];
    if (s.fan < number_of_fans()) outgoing_[s.fan] = values.outgoing[side];
  }
}

std::uint32_t Signposts::add_location(std::uint32_t vertex, bool is_on_border) {
  const std::uint32_t i = vertex - input_->number_of_vertices();
  if (i >= location_.size()) location_.resize(i + std::size_t{1});
  location_[i] = inserted_;
  return number_of_fans() + 2 * i + (is_on_border ? 1 : 0);
}

Surface_point Signposts::point_between(std::uint32_t h, std::uint32_t source, std::uint32_t target,
                                       double parameter) const {
  const double from = parameter_on_halfedge(*this, source, h, true),
               to = parameter_on_halfedge(*this, target, h, false);
  const double x = from + parameter * (to - from);
  return {h, {1 - x, x, 0}};
}

} // namespace CGAL::Intrinsic_triangulations
