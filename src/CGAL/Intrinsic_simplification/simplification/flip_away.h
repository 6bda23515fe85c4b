// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_FLIP_AWAY_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_FLIP_AWAY_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <tuple>
#include <vector>

/*!
\file
How flat vertices are removed by flips, on triangulations of any kind.
*/

namespace CGAL::Intrinsic_triangulations::internal {

// Which ears are cut off first: those with the greatest rank.
struct Ear_rank {
  bool is_preferred; // comes before all others
  double power;      // of the vertex with respect to the circle about the ear: negative inside
};

/*
Removes a flat vertex by flips until it has three edges, or one inner edge on the border.

The faces around a flat vertex develop into a polygon that is star-shaped about it. A triangulation
of the polygon without the vertex has two ears at least, of which one does not contain the vertex:
the edge to its tip can be flipped. Edges from the vertex to itself go first: they lower the degree
by two. Then comes the edge whose ear has the circle that contains the vertex the least: where the
faces about it are Delaunay, so are ears cut off in this order (Devillers, On deletion in Delaunay
triangulations, 1999). Where edges from the vertex to itself block all ears, a flip that takes no
end away changes the faces.

`Vertex_remover` takes ears in the same order from an `Intrinsic_triangulation`, but by other moves:
observers see each of them, all are taken back if one is refused, and with doubles the star is laid
out once for all.

A star has a type `Halfedge` and these members:
- `find_edges()` returns a vector of the halfedges from the vertex, as they are now;
- `are_here(h)`: whether the target is the vertex, and the corners on the left and on the right;
- `is_in_two_faces(h)`;
- `rank(h)` of the ear that a flip would cut off, an `Ear_rank`;
- `flip(h, is_last)` flips if the faces are convex together, and returns whether it did. They may be
  straight at the vertex if three edges will be left, none from the vertex to itself: the face
  without area goes with the vertex;
- `take_out()` removes the vertex, of which no edge is a loop.
*/
template <class Star>
class Flat_vertex_removal {
public:
  explicit Flat_vertex_removal(Star& star) : star_(star) {}

  // \return whether the vertex is gone; otherwise others have to be removed first
  bool run() {
    // flips that take no end away could go round in a circle
    const std::size_t most_flips = 8 * star_.find_edges().size() + 32;
    for (std::size_t flips = 0; flips < most_flips; ++flips) {
      const std::vector<Halfedge>& edges = star_.find_edges();
      const auto ends_of_loops = std::count_if(edges.begin(), edges.end(),
                                               [this](Halfedge h) { return star_.are_here(h)[0]; });
      if (edges.size() == 3 && ends_of_loops == 0) {
        star_.take_out();
        return true;
      }
      if (!flip_an_edge(edges, ends_of_loops)) return false;
    }
    return false;
  }

private:
  using Halfedge = typename Star::Halfedge;
  struct Candidate {
    int gain; // number of edge ends that leave the vertex
    Ear_rank rank;
    Halfedge edge;
    auto key() const { return std::tuple(gain, rank.is_preferred, rank.power); }
  };

  int gain(Halfedge h) const {
    const std::array<bool, 3> are_here = star_.are_here(h);
    return 1 + static_cast<int>(are_here[0]) - static_cast<int>(are_here[1]) -
           static_cast<int>(are_here[2]);
  }

  bool flip_an_edge(const std::vector<Halfedge>& edges, std::ptrdiff_t ends_of_loops) {
    candidates_.clear();
    for (const Halfedge h : edges) {
      if (!star_.is_in_two_faces(h)) continue;
      if (const int g = gain(h); g > 0)
        candidates_.push_back({g, star_.rank(h), h});
      else if (g == 0) // only if there is nothing better, and never in a circle
        candidates_.push_back({0, {false, static_cast<double>(random_())}, h});
    }
    std::sort(candidates_.begin(), candidates_.end(),
              [](const Candidate& a, const Candidate& b) { return a.key() > b.key(); });
    return std::any_of(candidates_.begin(), candidates_.end(), [&](const Candidate& c) {
      const bool is_loop = star_.are_here(c.edge)[0];
      const bool is_last = c.gain == (is_loop ? 2 : 1) && ends_of_loops == (is_loop ? 2 : 0) &&
                           edges.size() == 3 + static_cast<std::size_t>(c.gain);
      return star_.flip(c.edge, is_last);
    });
  }

  Star& star_;
  std::vector<Candidate> candidates_;
  std::minstd_rand random_;
};

/*
Removes vertices until none is left. Some have to wait until others are gone, or until flips have
made the triangulation Delaunay again.
\param remove tries to remove a vertex, and returns whether it is gone
\param restore follows each round: it may add vertices
\return false if two rounds in a row have removed nothing
*/
template <class Vertex, class Remove, class Restore>
bool remove_in_rounds(std::vector<Vertex>& vertices, const Remove& remove, const Restore& restore) {
  for (bool was_blocked = false; !vertices.empty();) {
    const bool is_blocked = std::erase_if(vertices, remove) == 0;
    if (is_blocked && was_blocked) return false;
    was_blocked = is_blocked;
    restore();
  }
  return true;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_FLIP_AWAY_H
