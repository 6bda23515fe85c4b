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
#include <vector>

namespace CGAL::Intrinsic_triangulations {

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
    if (c.path.empty() ? !c.is_end_of(from) : c.path.front().from != from) return false;
  for (Developed_corner& c : corners)
    if (c.path.empty())
      c.side = c.side == from ? next_side(to) : to;
    else
      c.path.erase(c.path.begin());
  return true;
}

// Joins the paths to the corners of a diamond from a common base.
class Corner_unfolder {
public:
  // `maximal_size`: most triangles that are worth it
  explicit Corner_unfolder(std::size_t maximal_size = 4000) : maximal_size_(maximal_size) {}

  // whether there are not too many triangles; its memory stays from call to call
  bool operator()(const std::array<Developed_corner, 4>& corners) {
    result_.triangles.clear();
    children_.clear();
    const Developed_corner& c = corners.front();
    add({c.path.empty() ? c.side.face : c.path.front().from.face, 0, 0, {0, 1, 2}});
    for (std::size_t i = 0; i < 4; ++i) {
      const Developed_corner& corner = corners[i];
      const std::uint32_t t = follow(0, corner.path), slot = corner.side.slot;
      if (result_.triangles.size() > maximal_size_) return false;
      result_.corners[i] = {t, slot, corner.weights};
    }
    return true;
  }

  const Unfolded_diamond& result() const { return result_; }

private:
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

  std::size_t maximal_size_;
  Unfolded_diamond result_;
  std::vector<std::array<std::uint32_t, 3>> children_; // 0 if there is none
};

} // namespace internal

/*!
\brief unfolds the input along the paths to the corners of a diamond.
\param corners the corners i, j, k, m, from one base
\return the triangles; nothing if there are thousands
\complexity linear in the length of all paths
*/
inline std::optional<Unfolded_diamond>
unfold_corners(const std::array<Developed_corner, 4>& corners) {
  internal::Corner_unfolder unfolder;
  if (!unfolder(corners)) return std::nullopt;
  return unfolder.result();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_UNFOLD_CORNERS_H
