// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GLUING_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GLUING_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>

#include <cstdint>
#include <string>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void validate(const Gluing& g) {
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GLUING_IMPL_H
