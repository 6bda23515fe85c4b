// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/lengths/Developed_faces.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Frame_maps.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Length_chain.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_charts.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_number.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Value_recipes.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Gmpq.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

using Link = Length_chain::Link;

Link shift_by(const Gmpq& square, const Plane_number& z) { return {square, {1, 0}, z}; }

// to coordinates of a triangle, from those in which a side runs from 1 to 0
Link across(const Rational_triangle& t, std::uint32_t side) {
  const Plane_number &from = t.corners[(side + 1) % 3], &to = t.corners[side];
  return {t.squared_area, to - from, from};
}

Rational_triangle triangle_at(const Input_metric& m, const Face_side& s) {
  const auto length = [&](std::uint32_t k) {
    return m.squared_length<Gmpq>(s.face, (s.slot + k) % 3);
  };
  return Rational_triangle({length(0), length(1), length(2)});
}

} // namespace

std::optional<Length_chain> Value_recipes::chain(std::uint32_t edge) const {
  const Unfolded_diamond* strip = this->strip(edge);
  if (strip == nullptr) {
    const Face_side s = input_side_of(edge);
    return Length_chain{metric().squared_length<Gmpq>(s.face, s.slot), {shift_by(1, {1, 0})}};
  }
  const auto& triangles = strip->triangles;
  const std::size_t last = triangles.size() - 1;
  if (strip->has_inserted_corners() || strip->corners[0].triangle != 0 ||
      strip->corners[1].triangle != last)
    return std::nullopt;
  const Face_side& first = triangles[0].side;
  Length_chain result{metric().squared_length<Gmpq>(first.face, first.slot), {}};
  for (std::uint32_t k = 0; k <= last; ++k) {
    if (k > 0 && triangles[k].parent() != k - 1) return std::nullopt;
    const Rational_triangle t = triangle_at(metric(), triangles[k].side);
    if (k == 0)
      result.links.push_back(shift_by(t.squared_area, -t.corners[strip->corners[0].corner]));
    result.links.push_back(k < last
                               ? across(t, triangles.exit_to(k + 1))
                               : shift_by(t.squared_area, t.corners[strip->corners[1].corner]));
  }
  return result;
}

std::optional<Gmpq> Developed_faces::rational_length(std::uint32_t edge) const {
  if (!recipes_.is_along_input(edge)) return std::nullopt;
  const Face_side s = recipes_.input_side_of(edge);
  return recipes_.metric().squared_length<Gmpq>(s.face, s.slot);
}

std::optional<Developed_faces::Rational_frame>
Developed_faces::rational_frame(std::uint32_t frame) const {
  if (charts_.chart(frame) != Plane_charts::none)
    return Rational_frame{charts_.squared_area(frame), {}};
  std::array<Gmpq, 3> lengths;
  std::uint32_t h = first_side_[frame];
  for (Gmpq& l : lengths) {
    const std::optional<Gmpq> x = rational_length(h / 2);
    if (!x) return std::nullopt;
    l = *x;
    h = next_[h];
  }
  const Rational_triangle t(lengths);
  return Rational_frame{t.squared_area, t.corners};
}

Plane_number Developed_faces::place(const Rational_frame& frame, std::uint32_t halfedge) const {
  const std::uint32_t face = face_[halfedge], first = first_side_[face];
  if (charts_.chart(face) != Plane_charts::none)
    return charts_.point(charts_.number_of_point(halfedge));
  return frame.corners[halfedge == first ? 0 : halfedge == next_[first] ? 1 : 2];
}

// A map across an edge goes by coordinates in which the edge runs from 0 to 1.
bool Developed_faces::append_letter(Frame_maps::Map letter, std::vector<Link>& links) const {
  if (!maps_.is_at_start(letter)) {
    const Plane_motion& m = *maps_.motion_of(letter);
    links.push_back({charts_.squared_area(m.chart), m.turn, m.shift});
    return true;
  }
  const std::uint32_t h = Frame_maps::halfedge(letter), other = h ^ 1U;
  const auto own = rational_frame(frame_at_start_[face_[h]]),
             across = rational_frame(frame_at_start_[face_[other]]);
  if (!own || !across) return false;
  const Plane_number to = place(*own, h), from = place(*across, next_[other]);
  links.push_back({own->square, place(*own, next_[h]) - to, to});
  links.push_back(inverse({across->square, place(*across, other) - from, from}));
  return true;
}

std::optional<Length_chain> Developed_faces::chain(Value length) const {
  if (length < recipes_.number_of_values())
    return recipes_.is_length_of_edge(length) ? recipes_.chain(length) : std::nullopt;
  const Quantity& q = quantities_[length - recipes_.number_of_values()];
  const Point start = q.points[0], end = start_of(q.points[1]);
  const std::optional<Gmpq> unit_of_frame = rational_length(unit(q.frame));
  const auto first = rational_frame(q.frame), last = rational_frame(frame_at_start_[face_[end]]);
  if (q.is_area || !unit_of_frame || !first || !last) return std::nullopt;
  Length_chain result{*unit_of_frame, {shift_by(first->square, -place(*first, start))}};
  const Frame_maps::Map map = map_of(q.points[1]);
  if (maps_.number_of_letters(map) > 1) {
    for (const Frame_maps::Map letter : maps_.letters(map))
      if (!append_letter(letter, result.links)) return std::nullopt;
  } else if (map != Frame_maps::identity && !append_letter(map, result.links)) {
    return std::nullopt;
  }
  result.links.push_back(shift_by(last->square, place(*last, end)));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
