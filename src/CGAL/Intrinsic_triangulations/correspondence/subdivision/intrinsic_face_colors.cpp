// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/intrinsic_face_colors.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
namespace {

/// Light colours that differ in hue or lightness, on which black lines are seen.
constexpr std::array<std::uint32_t, 12> face_palette{0x8dd3c7, 0xffed6f, 0xbeaed4, 0xfb8072,
                                                     0x80b1d3, 0xfdb462, 0xb3de69, 0xfccde5,
                                                     0xbdbdbd, 0xbc80bd, 0xccebc5, 0xe5c494};

// The up to three neighbours of each intrinsic face, `none` where there are fewer.
std::vector<std::array<std::uint32_t, 3>> intrinsic_face_neighbours(const Common_subdivision& s) {
  constexpr std::uint32_t none = Common_subdivision::none;
  std::size_t bound = 0;
  for (const std::uint32_t f : s.intrinsic_face) bound = std::max(bound, std::size_t{f} + 1);
  std::vector<std::array<std::uint32_t, 3>> result(bound, {none, none, none});
  const auto add = [&](std::uint32_t f, std::uint32_t g) {
    *std::find(result[f].begin(), result[f].end() - 1, none) = g;
  };
  std::vector<std::uint32_t> first(intrinsic_edge_bound(s), none); // f, then `done`
  constexpr std::uint32_t done = none - 1;
  for (std::size_t f = 0; f < s.number_of_faces(); ++f)
    for (const Common_subdivision::Side& side : s.sides(f)) {
      if (side.intrinsic_edge == none) continue;
      std::uint32_t& g = first[side.intrinsic_edge];
      if (g == none)
        g = s.intrinsic_face[f];
      else if (g != done && g != s.intrinsic_face[f]) {
        add(g, s.intrinsic_face[f]);
        add(s.intrinsic_face[f], g);
        g = done;
      }
    }
  return result;
}

} // namespace
} // namespace internal

std::vector<Rgb_color> intrinsic_face_colors(const Common_subdivision& s) {
  constexpr std::size_t size = internal::face_palette.size();
  const auto neighbours = internal::intrinsic_face_neighbours(s);
  std::vector<Rgb_color> result(neighbours.size());
  std::vector<std::uint8_t> chosen(neighbours.size(), size);
  for (std::size_t f = 0; f < neighbours.size(); ++f) {
    // multiplicative hashing: the upper bits of the product are spread evenly
    std::size_t c = ((f * 0x9e3779b97f4a7c15u) >> 40) % size;
    const auto is_taken = [&](std::uint32_t g) {
      return g != Common_subdivision::none && chosen[g] == c;
    };
    while (std::any_of(neighbours[f].begin(), neighbours[f].end(), is_taken)) c = (c + 1) % size;
    chosen[f] = static_cast<std::uint8_t>(c);
    for (std::size_t i = 0; i < 3; ++i)
      result[f][i] = static_cast<std::uint8_t>(internal::face_palette[c] >> (16 - 8 * i));
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
