// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_sectors.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/vector_field.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace {

constexpr double pi = std::numbers::pi;

} // namespace

void Vertex_sectors::add(std::uint32_t vertex, const Surface_point& p,
                         const Plane_vector<double>& axis) {
  const auto begin = static_cast<std::uint32_t>(sectors_.size());
  Fan fan{vertex, begin, begin, false, 1};
  const Geodesic_face face(*input_, p.halfedge);
  const auto angle_from = [&](unsigned side) {
    const Plane_vector<double> v = face.relative_to(side, axis);
    return std::atan2(v[1], v[0]);
  };
  const auto zero = std::ranges::find(p.weights, 0.);
  if (const unsigned corner = internal::corner_of(p); corner < 3) {
    add_about_vertex(fan, face.side[corner], angle_from(corner));
  } else if (zero != p.weights.end()) {
    const auto side = static_cast<unsigned>(zero - p.weights.begin() + 1) % 3;
    add_beside_edge(fan, face.side[side], angle_from(side));
  } else {
    sectors_.push_back({p.halfedge, -angle_from(0)});
  }
  fan.end = static_cast<std::uint32_t>(sectors_.size());
  fan_[vertex] = static_cast<std::uint32_t>(fans_.size());
  fans_.push_back(fan);
}

void Vertex_sectors::add_about_vertex(Fan& fan, std::uint32_t h, double angle) {
  const Fan_angle all = measure_fan(*input_, h, [&](std::uint32_t g, double before) {
    if (!input_->is_border(g)) sectors_.push_back({g, before - angle});
  });
  fan.is_on_border = all.is_on_border;
  if (!fan.is_on_border) sectors_.push_back({h, all.sum - angle}); // the rest of the first face
  fan.factor = 1 / internal::polar_scale(all);
}

void Vertex_sectors::add_beside_edge(Fan& fan, std::uint32_t h, double angle) {
  fan.is_on_border = input_->is_border(h ^ 1U);
  sectors_.push_back({h, -angle});
  if (fan.is_on_border) return;
  sectors_.push_back({h ^ 1U, pi - angle});
  sectors_.push_back({h, 2 * pi - angle});
}

// A vector is turned, never measured: its length takes longer than to find its sector.
Vertex_sectors::In_sector Vertex_sectors::in_sector(const Fan& fan, std::complex<double> z) const {
  const double polar = std::arg(z);
  double angle = polar < 0 ? polar + 2 * pi : polar;
  std::size_t sector = fan.begin;
  const std::size_t last = fan.end - 1;
  if (fan.is_on_border && angle > pi) { // what is left of the circle beyond the border
    const double inside = pi * fan.factor;
    if (angle < 1.5 * pi) sector = last;
    angle = inside + (angle - pi) / pi * (2 * pi - inside);
  } else {
    angle *= fan.factor;
    while (sector != last && sectors_[sector + 1].angle <= angle) ++sector;
  }
  const double turn = angle - sectors_[sector].angle - polar;
  const double c = std::cos(turn), s = std::sin(turn);
  return {sector, {z.real() * c - z.imag() * s, z.real() * s + z.imag() * c}};
}

void Vertex_sectors::place(std::span<const std::array<double, 3>> points) {
  const internal::Placed_input source{*input_, points};
  axes_.reserve(sectors_.size());
  for (const Sector& s : sectors_) {
    const auto axes = internal::face_axes_in_space(*input_, s.halfedge, source);
    // beyond a face without area: by the same turn for all vectors
    axes_.push_back(
        axes ? *axes
             : Axes{internal::vector_beyond_face(*input_, {s.halfedge, {1, 0}}, source),
                    internal::vector_beyond_face(*input_, {s.halfedge, {0, 1}}, source)});
  }
}

std::vector<std::array<double, 3>> Vertex_sectors::in_space(const Tangent_field& field) const {
  internal::expect_size(field, size());
  std::vector<std::array<double, 3>> result(field.size(), {0, 0, 0});
  for (const Fan& fan : fans_) {
    const auto [sector, v] = in_sector(fan, field[fan.vertex]);
    result[fan.vertex] = internal::along(axes_[sector], {v.real(), v.imag()});
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
