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

Input_vector Vertex_sectors::on_input(const Fan& fan, std::complex<double> z) const {
  double angle = std::arg(z);
  if (angle < 0) angle += 2 * pi;
  const Sector* sector = &sectors_[fan.begin];
  const Sector* const last = &sectors_[fan.end - 1];
  if (fan.is_on_border && angle > pi) { // what is left of the circle beyond the border
    const double inside = pi * fan.factor;
    if (angle < 1.5 * pi) sector = last;
    angle = inside + (angle - pi) / pi * (2 * pi - inside);
  } else {
    angle *= fan.factor;
    while (sector != last && sector[1].angle <= angle) ++sector;
  }
  const double length = std::hypot(z.real(), z.imag()), turn = angle - sector->angle;
  return {sector->halfedge, {length * std::cos(turn), length * std::sin(turn)}};
}

void Vertex_sectors::place(std::span<const std::array<double, 3>> points) {
  points_.reserve(input_->number_of_vertices());
  for (std::uint32_t v = 0; v < input_->number_of_vertices(); ++v)
    points_.push_back(points[input_->names().row(v)]);
}

std::vector<std::array<double, 3>> Vertex_sectors::in_space(const Tangent_field& field) const {
  internal::expect_size(field, size());
  std::vector<std::array<double, 3>> result(field.size(), {0, 0, 0});
  const auto source = [this](std::uint32_t h) -> const std::array<double, 3>& {
    return points_[input_->source(h)];
  };
  // in a loop of their own, short enough that the reads of several faces overlap
  std::vector<Input_vector> vectors;
  vectors.reserve(fans_.size());
  for (const Fan& fan : fans_) vectors.push_back(on_input(fan, field[fan.vertex]));
  for (std::size_t i = 0; i < fans_.size(); ++i)
    result[fans_[i].vertex] = internal::vector_in_space(*input_, vectors[i], source);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
