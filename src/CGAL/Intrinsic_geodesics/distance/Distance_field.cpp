// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/distance/Window.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

void Stored_windows::keep(std::size_t sides) {
  blocks_.clear();
  first_.assign(sides, Gluing::none);
  size_ = 0;
}

void Stored_windows::add(const Window& w, std::uint32_t side, double length) {
  const auto rounded = [length](double x, double up) {
    const double part = std::clamp(x / length, 0.0, 1.0);
    const double root = part < 0.5 ? std::sqrt(part / 2) : 1 - std::sqrt((1 - part) / 2);
    return static_cast<std::uint32_t>(std::min(root * units + up, units));
  };
  if (size_ % block_size == 0)
    blocks_.push_back(std::make_unique_for_overwrite<Record[]>(block_size));
  at(size_) = {w.image, rounded(w.begin, 0), rounded(w.end, 1), w.source, first_[side]};
  first_[side] = size_++;
}

Distance_field::Distance_field(Corner_table t)
    : table(std::move(t)), vertices(table.first_corner.size()) {}

void Distance_field::clear() {
  vertices.assign(vertices.size(), {});
  windows = {};
  face_sources.clear();
  origins.clear();
  sources_by_face.clear();
  crossings.clear();
  radius = 0;
}

std::span<const std::uint32_t> Distance_field::sources_in_face(std::uint32_t face) const {
  // no equal_range() of ranges: clang 14 refuses that of g++'s library
  const auto is_before = [this](std::uint32_t s, std::uint32_t f) {
    return face_sources[s].side / 3 < f;
  };
  const auto begin =
      std::lower_bound(sources_by_face.begin(), sources_by_face.end(), face, is_before);
  return {begin, std::lower_bound(begin, sources_by_face.end(), face + 1, is_before)};
}

Plane_vector<double> Distance_field::turned_to(std::uint32_t side, Plane_vector<double> p,
                                               std::uint32_t from) const {
  while (from != side) {
    const std::uint32_t n = Corner_table::next(from);
    // seen in the mirror, and turned about the target, where n starts
    const Plane_vector<double> back =
        turned({table.corners[from].length - p.x, p.y}, table.corners[n]);
    p = {back.x, -back.y};
    from = n;
  }
  return p;
}

Point_in_face Distance_field::point(std::uint32_t side,
                                    const std::array<double, 3>& weights) const {
  const Window_face face(table, side);
  return {side,
          {weights[1] * face.base.length + weights[2] * face.apex.x, weights[2] * face.apex.y},
          weights};
}

Distance_and_arrival Distance_field::at(const Point_in_face& p) const {
  Distance_and_arrival best;
  const auto go_straight = [&](std::uint32_t side, Plane_vector<double> image, std::uint32_t source,
                               double distance) {
    if (distance < best.distance) best = {distance, {image, side, source, Arrival::Kind::straight}};
  };
  const std::uint32_t face = p.side / 3;
  for (const std::uint32_t s : sources_in_face(face)) {
    const Plane_vector<double> q = turned_to(p.side, face_sources[s].point, face_sources[s].side);
    go_straight(p.side, q, static_cast<std::uint32_t>(vertices.size() + s),
                planar_distance(q, p.point));
  }
  for (std::uint32_t side = 3 * face; side < 3 * face + 3; ++side) {
    const Plane_vector<double> q = turned_to(side, p.point, p.side), corner{0, 0};
    const std::uint32_t v = table.corners[side].origin;
    go_straight(side, corner, v, vertices[v].distance + planar_distance(q, corner));
    look_through(side, q, best);
  }
  if (best.arrival.source != Gluing::none) best.arrival.origin = origin(best.arrival.source);
  return best;
}

void Distance_field::look_through(std::uint32_t side, Plane_vector<double> p,
                                  Distance_and_arrival& best) const {
  const double length = table.corners[side].length;
  p.y = std::max(p.y, 0.0); // not below the side, where rounding would swing rays far along it
  windows.for_each(side, [&](const Stored_windows::Record& w) {
    const double distance = offset(w.source) + planar_distance(w.image, p);
    if (!(distance < best.distance)) return;
    const double crossing = w.image.x + (p.x - w.image.x) * (-w.image.y / (p.y - w.image.y));
    const double tolerance = window_angle_tolerance * length;
    if (crossing < Stored_windows::place(w.begin, length) - tolerance ||
        crossing > Stored_windows::place(w.end, length) + tolerance)
      return;
    best = {distance, {w.image, side, w.source, Arrival::Kind::straight}};
  });
}

} // namespace CGAL::Intrinsic_triangulations::internal
