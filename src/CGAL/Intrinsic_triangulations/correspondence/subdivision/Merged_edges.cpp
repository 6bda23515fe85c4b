// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Merged_edges.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/expect_middle.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Corners_along::Corners_along(const Piece_gluer& pieces, Subdivided which, std::uint32_t halfedges) {
  constexpr std::uint32_t none = Common_subdivision::none;
  const Common_subdivision& s = pieces.subdivision();
  const bool is_input = which == Subdivided::input;
  const std::vector<std::uint32_t>& halfedge = is_input ? s.input_halfedge : s.intrinsic_halfedge;
  const auto crossing = [&s](std::uint32_t c) {
    return s.corner[c] < s.vertices.size() ? none : s.corner[c] - std::uint32_t(s.vertices.size());
  };
  // each crossing is on one edge
  std::vector<std::uint32_t> first(halfedges, none), from(2 * s.crossings.size(), none);
  for (std::uint32_t c = 0; c < s.corner.size(); ++c)
    if ((is_input ? s.side[c].input_edge : s.side[c].intrinsic_edge) != none)
      (crossing(c) == none ? first[halfedge[c]] : from[2 * crossing(c) + halfedge[c] % 2]) = c;
  for (std::uint32_t h = 0; h < halfedges; ++h) {
    for (std::uint32_t c = first[h]; c != none;) {
      if (corners_.size() == s.corner.size()) fail_middle(Element_kind::edge, h / 2, which);
      corners_.push_back(c);
      const std::uint32_t end = crossing(pieces.next(c));
      c = end == none ? none : from[2 * end + h % 2];
    }
    begin_.push_back(corners_.size());
  }
}

Merged_edges::Merged_edges(const Piece_gluer& first, const Piece_gluer& second,
                           std::uint32_t halfedges)
    : first_(first, Subdivided::intrinsic, halfedges),
      second_(second, Subdivided::input, halfedges),
      of_first_(first.subdivision().crossings.size()),
      of_second_(second.subdivision().crossings.size()), points_(halfedges / 2, 0) {
  for (std::uint32_t e = 0; e < halfedges / 2; ++e) merge(first, second, e);
}

void Merged_edges::merge(const Piece_gluer& first, const Piece_gluer& second, std::uint32_t edge) {
  constexpr double tolerance = 0x1p-40; // errors of places are less, but beside needles
  const Common_subdivision &a = first.subdivision(), &b = second.subdivision();
  const std::span<const std::uint32_t> of_a = first_[2 * edge], of_b = second_[2 * edge];
  std::uint32_t& rank = points_[edge];
  for (std::uint32_t i = 1, j = 1; i < of_a.size() || j < of_b.size();) {
    ++rank;
    std::uint32_t x = 0, y = 0;
    double difference = 0; // of the places of the next two
    if (i < of_a.size()) {
      x = static_cast<std::uint32_t>(a.corner[of_a[i]] - a.vertices.size());
      difference = a.crossings[x].on_intrinsic.parameter;
    }
    if (j < of_b.size()) {
      y = static_cast<std::uint32_t>(b.corner[of_b[j]] - b.vertices.size());
      difference -= b.crossings[y].on_input.parameter;
    }
    const bool is_both = i < of_a.size() && j < of_b.size();
    if (is_both && std::abs(difference) <= tolerance) {
      of_first_[x] = {i, rank, j - 1, y};
      of_second_[y] = {j++, rank, i++ - 1, x};
    } else if (is_both ? difference < 0 : i < of_a.size()) {
      of_first_[x] = {i++, rank, j - 1};
    } else {
      of_second_[y] = {j++, rank, i - 1};
    }
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
