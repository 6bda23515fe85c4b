// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_geodesics/distance/Face_complex.h>
#include <CGAL/Intrinsic_geodesics/distance/trace_back.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

bool Face_complex::is_under(const Input& input) {
  return input.names().sheets % 2 == 0 && Sheets(input).is_cover();
}

Face_complex::Face_complex(const Input& input) : input_(input), sheets_(input) {
  // the first side of the first face at three points; those of meshes are different faces
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> found;
  for (std::uint32_t f = 0; f < input.number_of_faces(); f += 2) {
    const auto sides = sides_of_face(input, input.halfedge_of_face(input.names().faces.here(f)));
    auto first = static_cast<std::uint32_t>(halfedges_.size());
    if (input.names().is_cloud()) {
      std::array<std::uint32_t, 3> rows{row(sides[0]), row(sides[1]), row(sides[2])};
      std::ranges::sort(rows);
      first = found.insert({rows, first}).first->second;
    }
    if (first == halfedges_.size()) halfedges_.insert(halfedges_.end(), sides.begin(), sides.end());
    for (unsigned k = 0; k < 3; ++k) sides_.push_back(same_side(first, sides, k));
  }
}

// A side of a face as a side of the first face at its corners.
Face_complex::Side Face_complex::same_side(std::uint32_t first,
                                           const std::array<std::uint32_t, 3>& sides,
                                           unsigned k) const {
  if (halfedges_[first] == sides[0]) return {first + k, false};
  const std::uint32_t from = row(sides[k]), to = row(sides[(k + 1) % 3]);
  for (unsigned j = 0;; ++j) {
    const std::uint32_t a = row(halfedges_[first + j]), b = row(halfedges_[first + (j + 1) % 3]);
    if (a == from && b == to) return {first + j, false};
    if (a == to && b == from) return {first + j, true};
  }
}

// Of the front. The same side of the back, of which the first one is that of the front, runs
// against it.
std::uint32_t Face_complex::side(std::uint32_t halfedge, bool& is_back) const {
  const std::uint32_t f = input_.face(halfedge), name = input_.names().faces.user(f);
  std::uint32_t k = 0;
  for (std::uint32_t h = input_.halfedge_of_face(f); h != halfedge; h = input_.next(h)) ++k;
  is_back = name % 2 != 0;
  const Side& s = sides_[3 * (name / 2) + (is_back ? (3 - k) % 3 : k)];
  is_back = is_back != s.is_against;
  return s.number;
}

Path_place Face_complex::place(const Surface_point& p) const {
  bool is_back = false;
  const std::uint32_t s = side(p.halfedge, is_back);
  if (!is_back) return {s, p.weights};
  return {s, {p.weights[1], p.weights[0], p.weights[2]}};
}

// In a cloud, the cover joins triangles of one star only. Here the triangles of all stars that have
// two points in common meet along the segment between them, as faces of meshes do.
Face_complex::Side_on_edge Face_complex::on_edge(std::uint32_t side) const {
  const std::uint32_t h = halfedges_[side];
  if (input_.names().is_cloud()) {
    const std::uint32_t from = row(h), to = row(input_.next(h));
    return {{std::min(from, to), std::max(from, to)}, side, from < to};
  }
  const std::uint32_t least = std::ranges::min(sheets_.edges_over(h));
  return {{least / 2, 0}, side, least % 2 == 0};
}

// The other sides at the edge of each side.
std::vector<Branched_side> Face_complex::sides_at_edges() const {
  std::vector<Side_on_edge> all;
  for (std::uint32_t s = 0; s < halfedges_.size(); ++s) all.push_back(on_edge(s));
  std::ranges::sort(all, {}, [](const Side_on_edge& s) { return std::pair(s.edge, s.number); });
  std::vector<Branched_side> result(all.size());
  for (std::size_t from = 0, to = 0; from < all.size(); from = to) {
    while (to < all.size() && all[to].edge == all[from].edge) ++to;
    const std::span<const Side_on_edge> sides(all.data() + from, all.data() + to);
    for (const Side_on_edge& s : sides) {
      Branched_side& branch = result[s.number];
      branch.side = s.number;
      for (const Side_on_edge& other : sides)
        if (other.number != s.number)
          branch.others.push_back({other.number, other.is_along == s.is_along});
    }
  }
  return result;
}

Corner_table Face_complex::table() const {
  Corner_table table;
  table.unit = std::ldexp(1.0, -input_.scale_exponent());
  table.first_corner.assign(input_.number_of_rows(), Gluing::none);
  std::vector<Branched_side> branch = sides_at_edges();
  for (std::uint32_t s = 0; s < halfedges_.size(); ++s) {
    const std::uint32_t h = halfedges_[s];
    const std::array<double, 3> l = squared_lengths_of_face(input_, h);
    const auto [cosine, sine] =
        corner_direction(l[0], l[2], l[1], input_.quadruple_area(input_.face(h)));
    const std::vector<Branched_side::Other>& others = branch[s].others;
    std::uint32_t opposite = Gluing::none;
    if (others.size() == 1 && !others.front().is_along) {
      opposite = others.front().side;
    } else if (!others.empty()) {
      opposite = static_cast<std::uint32_t>(Face_corner::first_branch + table.branches.size());
      table.branches.push_back(std::move(branch[s]));
    }
    table.corners.push_back(
        {std::sqrt(l[0]), cosine, sine, opposite, input_.names().row(input_.source(h))});
  }
  table.find_fans();
  return table;
}

} // namespace CGAL::Intrinsic_triangulations::internal
