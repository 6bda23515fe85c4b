// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GLUING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GLUING_H

#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief lists how the sides of disjoint triangles are glued together (§2.1, §2.2 of the course).

Halfedge `3f + k` is side `k` of face `f` and runs from vertex `origin[3f + k]` to
`origin[3f + (k + 1) % 3]`. `glue[h]` is the halfedge that `h` is glued to, or `none` on the
boundary. A gluing usually joins sides of opposite direction, which respects the orientation of both
faces; `reversed(h)` marks one along their direction, for nonorientable surfaces.
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
  /// The halfedge that each one is glued to.
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
void validate(const Gluing& g);

/*!
\brief reports whether the faces of a gluing can be oriented consistently, and how.
*/
struct Orientation_result {
  /// Whether the surface is orientable (§2.1 of the course).
  bool is_orientable = true;
  /// If not: a halfedge whose gluing closes a path of faces that reverses orientation.
  std::uint32_t witness = Gluing::none;
  /// If so: nonzero for each face to be reversed, of each component at most half of the faces. The
  /// first one of a component is kept if there are as many of either kind.
  std::vector<char> reversed_faces;
};

namespace internal {

// For each number the least one of its set, where the pairs from `for_each_pair()` join sets.
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

// The name of a face in messages: its number if there are no names.
inline std::uint32_t face_name(std::uint32_t f, const std::vector<std::uint32_t>& names) {
  return names.empty() ? f : names[f];
}

} // namespace internal

/*!
\brief finds the faces to reverse so that all gluings respect the orientation.
\param g the gluing
\pre `validate(g)` does not throw
\complexity linear
*/
Orientation_result find_orientation(const Gluing& g);

/*!
\brief reverses faces of a gluing so that all gluings respect the orientation, if that is possible.

A reversed face keeps its corner 0; its side `k` becomes side `2 - k`. Which faces: see
`Orientation_result`.
\param g the gluing, which is changed only if it is orientable
\return the reversed faces, or a witness that no choice works
\pre `validate(g)` does not throw
\complexity linear
*/
Orientation_result orient_faces(Gluing& g);

namespace internal {

// Reports two faces that run along an edge in the same direction.
[[noreturn]] void fail_orientation(const Gluing& g, std::uint32_t h,
                                   const std::vector<std::uint32_t>& names);

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GLUING_H
