// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_UNFOLD_CORNERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_UNFOLD_CORNERS_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/Crossing_path.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief tells where a vertex was inserted.
*/
struct Developed_insertion {
  std::uint32_t base;                      ///< the input face in whose plane the corners are
  std::array<Developed_corner, 3> corners; ///< of the face into which it was inserted
  std::array<double, 3> weights;           ///< its barycentric coordinates
};

namespace internal {

// Moves the base of paths across an edge that all cross, but for those to ends of that edge, if there is
// one.
inline bool move_base(std::array<Developed_corner, 4>& corners) {
  const auto longest = std::max_element(corners.begin(), corners.end(),
                                        [](const Developed_corner& a, const Developed_corner& b) {
                                          return a.path.size() < b.path.size();
                                        });
  if (longest->path.empty()) return false;
  const auto [from, to] = longest->path.front();
  for (const Developed_corner& c : corners)
    if (c.path.empty() ? c.side != from && c.side != next_side(from) : c.path.front().from != from)
      return false;
  for (Developed_corner& c : corners)
    if (c.path.empty())
      c.side = c.side == from ? next_side(to) : to;
    else
      c.path.erase(c.path.begin());
  return true;
}

/*!
Joins the paths to the corners of a diamond from a common base.

`Insertions` is a functor from a node that inserted a vertex to its `Developed_insertion`, or to a
reference to it. The same
vertex reached along the same path is one point, so that vertices inserted next to vertices that were
inserted do not multiply. Nothing recurses: nodes are visited again when their corners are there.
*/
class Corner_unfolder {
public:
  // `maximal_size`: most triangles and combinations that are worth it
  explicit Corner_unfolder(std::size_t maximal_size = 4000) : maximal_size_(maximal_size) {}

  // whether there are not too many triangles; its memory stays from call to call
  template <class Insertions>
  bool operator()(const std::array<Developed_corner, 4>& corners, const Insertions& insertions) {
    clear();
    const Developed_corner& c = corners.front();
    const std::uint32_t base = !c.path.empty()   ? c.path.front().from.face
                               : c.is_inserted() ? insertions(c.side.face).base
                                                 : c.side.face;
    add({base, 0, 0, {0, 1, 2}});
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t t = follow(0, corners[i].path);
      if (result_.triangles.size() > maximal_size_) return false;
      if (corners[i].is_inserted() && !place(t, corners[i].side.face, insertions)) return false;
      result_.corners[i] = *known(t, corners[i].side);
    }
    return true;
  }

  const Unfolded_diamond& result() const { return result_; }

private:
  using Corner = Unfolded_diamond::Corner;

  void clear() {
    result_.triangles.clear();
    result_.combinations.clear();
    children_.clear();
    if (!placed_.empty()) placed_.clear();
  }

  void add(const Unfolded_diamond::Triangle& t) {
    result_.triangles.push_back(t);
    children_.push_back({0, 0, 0});
  }

  // the triangle at the end of a path from triangle `t`
  std::uint32_t follow(std::uint32_t t, const Crossing_path& path) {
    for (const auto& [from, to] : path) {
      if (children_[t][from.slot] == 0) {
        if (t != 0 && result_.triangles[t].entry == from.slot) {
          t = result_.triangles[t].parent; // back over the side by which it was entered
          continue;
        }
        children_[t][from.slot] = static_cast<std::uint32_t>(result_.triangles.size());
        add(result_.beyond(t, from.slot, to.face, to.slot));
      }
      t = children_[t][from.slot];
    }
    return t;
  }

  // the corner `side` from triangle `t`, if it has been placed
  std::optional<Corner> known(std::uint32_t t, Face_side side) const {
    if (side.slot != Developed_corner::inserted) return Corner{t, side.slot};
    const auto found = placed_.find(key(t, side.face));
    if (found == placed_.end()) return std::nullopt;
    return Corner{found->second, Developed_corner::inserted};
  }

  // adds the vertex that a node inserted, seen from triangle `t`, after those that it refers to
  template <class Insertions>
  bool place(std::uint32_t t, std::uint32_t node, const Insertions& insertions) {
    std::vector<std::array<std::uint32_t, 2>> stack{{t, node}};
    while (!stack.empty()) {
      if (result_.triangles.size() + result_.combinations.size() > maximal_size_) return false;
      const auto [from, n] = stack.back();
      const Developed_insertion& insertion = insertions(n);
      Unfolded_diamond::Combination c{{}, insertion.weights};
      const std::size_t size = stack.size();
      for (std::size_t k = 0; k < 3; ++k) {
        // another corner stands in for one without weight
        const std::size_t l = insertion.weights[k] != 0 ? k : insertion.weights[0] != 0 ? 0 : 1;
        const Developed_corner& corner = insertion.corners[l];
        const std::uint32_t at = follow(from, corner.path);
        const std::optional<Corner> found = known(at, corner.side);
        if (found)
          c.corners[k] = *found;
        else
          stack.push_back({at, corner.side.face});
      }
      if (stack.size() > size) continue;
      stack.pop_back();
      if (placed_.emplace(key(from, n), static_cast<std::uint32_t>(result_.combinations.size()))
              .second)
        result_.combinations.push_back(c);
    }
    return true;
  }

  static std::uint64_t key(std::uint32_t t, std::uint32_t node) {
    return (static_cast<std::uint64_t>(t) << 32) | node;
  }

  std::size_t maximal_size_;
  Unfolded_diamond result_;
  std::vector<std::array<std::uint32_t, 3>> children_; // 0 if there is none
  std::unordered_map<std::uint64_t, std::uint32_t> placed_;
};

} // namespace internal

/*!
\brief unfolds the input along the paths to the corners of a diamond.
\tparam Insertions a functor from a node that inserted a vertex to its `Developed_insertion`
\param corners the corners i, j, k, m, from one base
\param insertions the functor
\return the triangles; nothing if there are thousands
\complexity linear in the length of all paths
*/
template <class Insertions>
std::optional<Unfolded_diamond> unfold_corners(const std::array<Developed_corner, 4>& corners,
                                               const Insertions& insertions) {
  internal::Corner_unfolder unfolder;
  if (!unfolder(corners, insertions)) return std::nullopt;
  return unfolder.result();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_UNFOLD_CORNERS_H
