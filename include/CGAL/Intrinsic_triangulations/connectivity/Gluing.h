// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GLUING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GLUING_H

#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>

#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief lists how the sides of disjoint triangles are glued together (§2.1, §2.2 of the course).

Halfedge `3f + k` is side `k` of face `f` and runs from vertex `origin[3f + k]` to
`origin[3f + (k + 1) % 3]`. `glue[h]` is the halfedge that `h` is glued to, or `none` on the
boundary. A gluing is ordinarily against the direction of the sides, which respects the orientation
of both faces; `reversed(h)` marks one along their direction, as a nonorientable surface needs.
*/
struct Gluing {
  /// No element.
  static constexpr std::uint32_t none = 0xffffffffU;
  /// Bit that marks a gluing along the direction of both sides.
  static constexpr std::uint32_t reversed_bit = 0x80000000U;

  /// Number of vertices, isolated ones included.
  std::uint32_t number_of_vertices = 0;
  /// Vertex that each halfedge starts from; three halfedges per face.
  std::vector<std::uint32_t> origin;
  /// What each halfedge is glued to.
  std::vector<std::uint32_t> glue;

  /// returns the number of faces.
  std::uint32_t number_of_faces() const { return static_cast<std::uint32_t>(origin.size() / 3); }

  /// returns the entry of `glue` for a gluing to `h` along the direction of both sides.
  static constexpr std::uint32_t reversed(std::uint32_t h) { return h | reversed_bit; }
  /// tells whether an entry of `glue` is along the direction of both sides.
  static constexpr bool is_reversed(std::uint32_t entry) {
    return entry != none && (entry & reversed_bit) != 0;
  }
  /// returns the halfedge in an entry of `glue`, or `none`.
  static constexpr std::uint32_t partner(std::uint32_t entry) {
    return entry == none ? none : entry & ~reversed_bit;
  }
  /// returns the halfedge that follows `h` in its face.
  static constexpr std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
};

/*!
\brief checks that arrays describe a gluing.

Sizes agree, indices are in range, every halfedge is glued to at most one other, mutually, and glued
sides have the same end vertices.
\throws Invalid_input naming the first halfedge at fault
\complexity linear
*/
inline void validate(const Gluing& g) {
  const auto fail = [](std::uint32_t h, const std::string& what) {
    throw Invalid_input::about(Element_kind::halfedge, h,
                               " (side " + std::to_string(h % 3) + " of face " +
                                   std::to_string(h / 3) + ") " + what);
  };
  if (g.origin.size() % 3 != 0 || g.glue.size() != g.origin.size())
    throw Invalid_input(Element_kind::none, 0,
                        "a gluing needs three origins and three gluings per face; " +
                            std::to_string(g.origin.size()) + " origins and " +
                            std::to_string(g.glue.size()) + " gluings are given");
  if (g.origin.size() >= Gluing::reversed_bit)
    throw Invalid_input(Element_kind::none, 0, "a gluing holds at most 715827882 faces");
  const auto count = static_cast<std::uint32_t>(g.origin.size());
  for (std::uint32_t h = 0; h < count; ++h) {
    if (g.origin[h] >= g.number_of_vertices)
      fail(h, "starts from vertex " + std::to_string(g.origin[h]) + ", which does not exist");
    const std::uint32_t p = Gluing::partner(g.glue[h]);
    if (p == Gluing::none) continue;
    if (p >= count) fail(h, "is glued to halfedge " + std::to_string(p) + ", which does not exist");
    if (p == h) fail(h, "is glued to itself; leave it unglued or glue it to another side");
    const bool reversed = Gluing::is_reversed(g.glue[h]);
    if (Gluing::partner(g.glue[p]) != h || Gluing::is_reversed(g.glue[p]) != reversed)
      fail(h, "is glued to halfedge " + std::to_string(p) + ", which is not glued back to it");
    const std::uint32_t expected = reversed ? p : Gluing::next(p);
    if (g.origin[h] != g.origin[expected])
      fail(h, "and halfedge " + std::to_string(p) + " are glued but have different end vertices");
  }
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GLUING_H
