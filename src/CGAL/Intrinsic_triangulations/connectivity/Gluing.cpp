// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

void validate(const Gluing& g) {
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

namespace internal {

// turns the choice of faces to reverse around if it is more than half of a component
static void reverse_fewer(const std::vector<std::uint32_t>& component,
                          std::vector<char>& reversed) {
  const auto is_reversed = [&](std::uint32_t f) { return reversed[f] != 0; };
  const auto count = std::count_if(component.begin(), component.end(), is_reversed);
  if (2 * static_cast<std::size_t>(count) <= component.size()) return;
  for (const std::uint32_t f : component) reversed[f] = static_cast<char>(1 - reversed[f]);
}

} // namespace internal

Orientation_result find_orientation(const Gluing& g) {
  constexpr char unseen = 2;
  Orientation_result r;
  r.reversed_faces.assign(g.number_of_faces(), unseen);
  std::vector<std::uint32_t> queue;
  queue.reserve(g.number_of_faces());
  for (std::uint32_t start = 0; start < g.number_of_faces(); ++start) {
    if (r.reversed_faces[start] != unseen) continue;
    r.reversed_faces[start] = 0;
    queue.assign(1, start);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const std::uint32_t f = queue[i];
      for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
        if (g.glue[h] == Gluing::none) continue;
        const std::uint32_t neighbour = Gluing::partner(g.glue[h]) / 3;
        const auto wanted = static_cast<char>(r.reversed_faces[f] ^ // 0 or 1
                                              static_cast<char>(Gluing::is_reversed(g.glue[h])));
        char& reversed = r.reversed_faces[neighbour];
        if (reversed == unseen) {
          reversed = wanted;
          queue.push_back(neighbour);
        } else if (reversed != wanted)
          return {false, h, {}};
      }
    }
    internal::reverse_fewer(queue, r.reversed_faces);
  }
  return r;
}

Orientation_result orient_faces(Gluing& g) {
  Orientation_result r = find_orientation(g);
  if (!r.is_orientable) return r;
  const auto renamed = [&r](std::uint32_t h) {
    return r.reversed_faces[h / 3] != 0 ? h - h % 3 + (2 - h % 3) : h;
  };
  std::vector<std::uint32_t> glue(g.glue.size(), Gluing::none);
  for (std::uint32_t h = 0; h < g.glue.size(); ++h) // no gluing along both sides remains
    if (g.glue[h] != Gluing::none) glue[renamed(h)] = renamed(Gluing::partner(g.glue[h]));
  g.glue = std::move(glue);
  for (std::uint32_t f = 0; f < g.number_of_faces(); ++f)
    if (r.reversed_faces[f] != 0) std::swap(g.origin[3 * f + 1], g.origin[3 * f + 2]);
  return r;
}

namespace internal {

[[noreturn]] void fail_orientation(const Gluing& g, std::uint32_t h,
                                   const std::vector<std::uint32_t>& names) {
  const std::uint32_t other = Gluing::partner(g.glue[h]);
  throw Invalid_input(
      Element_kind::edge, h,
      "edge (" + std::to_string(g.origin[h]) + ", " + std::to_string(g.origin[Gluing::next(h)]) +
          ") is traversed in the same direction by faces " +
          std::to_string(face_name(h / 3, names)) + " and " +
          std::to_string(face_name(other / 3, names)) +
          (find_orientation(g).is_orientable
               ? "; reverse one of them to orient the mesh consistently"
               : "; the surface has only one side, as a Moebius strip has: no reversal of faces "
                 "orients it; cut it open, or take the orientation double cover with "
                 "--domain orientation-cover"));
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
