// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_geodesics/distance/Face_complex.h>
#include <CGAL/Intrinsic_geodesics/distance/trace_back.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

bool Face_complex::is_under(const Input& input) {
  return input.names().sheets == 2 && Sheets(input).is_cover();
}

Face_complex::Face_complex(const Input& input) : input_(input) {
  for (std::uint32_t f = 0; f < input.number_of_faces(); f += 2) {
    const std::uint32_t front = input.names().faces.here(f);
    for (const std::uint32_t h : sides_of_face(input, input.halfedge_of_face(front)))
      halfedges_.push_back(h);
  }
}

// Of the front. The same side of the back, of which the first one is that of the front, runs
// against it.
std::uint32_t Face_complex::side(std::uint32_t halfedge, bool& is_back) const {
  const std::uint32_t f = input_.face(halfedge), name = input_.names().faces.user(f);
  std::uint32_t k = 0;
  for (std::uint32_t h = input_.halfedge_of_face(f); h != halfedge; h = input_.next(h)) ++k;
  is_back = name % 2 != 0;
  return 3 * (name / 2) + (is_back ? (3 - k) % 3 : k);
}

Path_place Face_complex::place(const Surface_point& p) const {
  bool is_back = false;
  const std::uint32_t s = side(p.halfedge, is_back);
  if (!is_back) return {s, p.weights};
  return {s, {p.weights[1], p.weights[0], p.weights[2]}};
}

// A cover glues the sides at an edge one after the other, in a circle or from border to border.
std::vector<Branched_side::Other> Face_complex::sides_at_edge(std::uint32_t first) const {
  std::vector<Branched_side::Other> sides{{first, true}};
  const auto add = [&](std::uint32_t halfedge, bool is_along) {
    if (input_.is_border(halfedge)) return;
    bool is_back = false;
    const std::uint32_t s = side(halfedge, is_back);
    if (std::ranges::find(sides, s, &Branched_side::Other::side) == sides.end())
      sides.push_back({s, is_along == is_back});
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto [s, is_along] = sides[i];
    const std::uint32_t front = halfedges_[s];
    const std::array<std::uint32_t, 3> back =
        sides_of_face(input_, input_.halfedge_of_face(input_.names().faces.here(2 * (s / 3) + 1)));
    add(front ^ 1U, is_along);
    add(back[(3 - s % 3) % 3] ^ 1U, !is_along);
  }
  return sides;
}

Corner_table Face_complex::table() const {
  Corner_table table;
  table.unit = std::ldexp(1.0, -input_.scale_exponent());
  table.first_corner.assign(input_.number_of_rows(), Gluing::none);
  for (std::uint32_t s = 0; s < halfedges_.size(); ++s) {
    const std::uint32_t h = halfedges_[s];
    const std::array<double, 3> l = squared_lengths_of_face(input_, h);
    const auto [cosine, sine] =
        corner_direction(l[0], l[2], l[1], input_.quadruple_area(input_.face(h)));
    Branched_side branch{s, sides_at_edge(s)};
    branch.others.erase(branch.others.begin()); // itself
    std::uint32_t opposite = Gluing::none;
    if (branch.others.size() == 1 && !branch.others.front().is_along) {
      opposite = branch.others.front().side;
    } else if (!branch.others.empty()) {
      opposite = static_cast<std::uint32_t>(Face_corner::first_branch + table.branches.size());
      table.branches.push_back(std::move(branch));
    }
    table.corners.push_back(
        {std::sqrt(l[0]), cosine, sine, opposite, input_.names().row(input_.source(h))});
  }
  table.find_fans();
  return table;
}

} // namespace CGAL::Intrinsic_triangulations::internal
