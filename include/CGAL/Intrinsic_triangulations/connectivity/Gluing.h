// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GLUING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GLUING_H

#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
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

/*!
\brief reports whether the faces of a gluing can be oriented consistently, and how.
*/
struct Orientation_result {
  /// Whether the surface is orientable (§2.1 of the course).
  bool is_orientable = true;
  /// If not: a halfedge whose gluing closes a path of faces that reverses orientation.
  std::uint32_t witness = Gluing::none;
  /// If so: nonzero for each face to be reversed, of each component at most half of the faces. The first one of a component is
  /// kept if there are as many of either kind.
  std::vector<char> reversed_faces;
};

namespace internal {

// The least number of the set of each, if the pairs that `for_each_pair()` calls its argument with
// join sets.
template <class For_each_pair>
std::vector<std::uint32_t> joined_sets(std::size_t size, const For_each_pair& for_each_pair) {
  std::vector<std::uint32_t> parent(size);
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&parent](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for_each_pair([&](auto i, auto j) {
    const std::uint32_t r = root(static_cast<std::uint32_t>(i)),
                        s = root(static_cast<std::uint32_t>(j));
    parent[std::max(r, s)] = std::min(r, s);
  });
  for (std::uint32_t i = 0; i < size; ++i) parent[i] = root(i);
  return parent;
}

// What a face is called in messages: by its number if there are no names.
inline std::uint32_t face_name(std::uint32_t f, const std::vector<std::uint32_t>& names) {
  return names.empty() ? f : names[f];
}

// turns the choice of faces to reverse around if it is more than half of a component
inline void reverse_fewer(const std::vector<std::uint32_t>& component,
                          std::vector<char>& reversed) {
  const auto is_reversed = [&](std::uint32_t f) { return reversed[f] != 0; };
  const auto count = std::count_if(component.begin(), component.end(), is_reversed);
  if (2 * static_cast<std::size_t>(count) <= component.size()) return;
  for (const std::uint32_t f : component) reversed[f] = static_cast<char>(1 - reversed[f]);
}

} // namespace internal

/*!
\brief finds out which faces to reverse so that all gluings respect the orientation.
\param g the gluing
\pre `validate(g)` does not throw
\complexity linear
*/
inline Orientation_result find_orientation(const Gluing& g) {
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

/*!
\brief reverses faces of a gluing so that all gluings respect the orientation, if that is possible.

A reversed face keeps its corner 0; its side `k` becomes side `2 - k`. Which faces: see `Orientation_result`.
\param g the gluing, which is changed only if it is orientable
\return the faces reversed, or a witness that none of the choices works
\pre `validate(g)` does not throw
\complexity linear
*/
inline Orientation_result orient_faces(Gluing& g) {
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

// Reports two faces that run along an edge in the same direction.
[[noreturn]] inline void fail_orientation(const Gluing& g, std::uint32_t h,
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
                 "orients it; cut it open, or take the orientation double cover"));
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GLUING_H
