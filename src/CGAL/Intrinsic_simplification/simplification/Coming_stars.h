// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_COMING_STARS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_COMING_STARS_H

#include <CGAL/Intrinsic_simplification/simplification/Coarse_mesh.h>
#include <CGAL/Intrinsic_simplification/simplification/Removal_queue.h>
#include <CGAL/Intrinsic_simplification/simplification/Vertex_star.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Brings what is read next into the cache. Cheap vertices are anywhere on the surface, and each face
of a star says where the next one is: meshes larger than the cache (armadillo, bunny00) wait for
them. While a vertex is removed, the stars of those that are first in the queue are followed, one
face in each direction at a time. No result changes.

GCC takes a function that only fetches for one without effect, and leaves out calls of it: fetches
are written into functions that do more.
*/
class Coming_stars {
public:
  // Begins with one face of each star. \param star what is removed now, for which forms, points and
  // the faces around are read, too
  void begin(const Coarse_mesh& mesh, const Removal_queue& queue, const Vertex_star& star) {
    for (const std::uint32_t h : star.sides()) {
      __builtin_prefetch(&mesh.forms(h / 3).above[0]);
      __builtin_prefetch(&mesh.forms(h / 3).below[2]);
      if (const std::uint32_t p = mesh.face(h / 3).first_point; p != Gluing::none)
        __builtin_prefetch(&mesh.point(p));
      if (const std::uint32_t g = mesh.glued(Coarse_mesh::next(h)); g != Gluing::none)
        __builtin_prefetch(&mesh.face(g / 3));
    }
    size_ = 0;
    for (const Removal_entry& e : queue.first(most_stars)) {
      const std::uint32_t h = mesh.outgoing(e.vertex);
      if (h == Gluing::none) continue;
      ends_[size_++] = {h, h};
      __builtin_prefetch(&mesh.face(h / 3));
    }
  }
  // Goes on to the next faces. Those before are there by now.
  void advance(const Coarse_mesh& mesh) {
    for (std::size_t n = 0; n < size_; ++n) {
      auto& [left, right] = ends_[n];
      if (left != Gluing::none) left = mesh.glued(Coarse_mesh::previous(left));
      if (right != Gluing::none) right = mesh.glued(right);
      if (right != Gluing::none) right = Coarse_mesh::next(right);
      if (left != Gluing::none) __builtin_prefetch(&mesh.face(left / 3));
      if (right != Gluing::none) __builtin_prefetch(&mesh.face(right / 3));
    }
  }

private:
  static constexpr std::size_t most_stars = 7; // three levels of the heap

  // Sides from the vertex, in the last faces to the left and to the right; none at the border.
  struct Ends {
    std::uint32_t left, right;
  };

  std::array<Ends, most_stars> ends_{};
  std::size_t size_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_COMING_STARS_H
