// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

const Unfolded_diamond& Diamond_unfolder::unfold_from_common_base() {
  for (Corner& c : corners_) c.trim(input());
  std::size_t base = 0;
  while (moves_base(base)) ++base;
  return unfold(base);
}

bool Diamond_unfolder::moves_base(std::size_t base) {
  const auto longest =
      std::max_element(corners_.begin(), corners_.end(), [](const Corner& a, const Corner& b) {
        return a.path.size() < b.path.size();
      });
  if (longest->path.size() <= base) return false;
  const std::uint32_t to = longest->path[base], from = to ^ 1U;
  for (const Corner& c : corners_)
    if (c.path.size() <= base ? !c.is_end_of(input(), from) : c.path[base] != to) return false;
  for (Corner& c : corners_)
    if (c.path.size() <= base) c.halfedge = c.halfedge == from ? input().next(to) : to;
  return true;
}

const Unfolded_diamond& Diamond_unfolder::unfold(std::size_t base) {
  Unfolded_diamond::Triangles& triangles = diamond_.triangles;
  const auto& [path, halfedge, weights] = corners_[0];
  const std::uint32_t first = path.size() > base ? path[base] ^ 1U : halfedge;
  triangles.start({input().face(first), 0});
  for (std::size_t i = 0; i < 4; ++i) {
    std::uint32_t t = 0;
    for (std::size_t n = base; n < corners_[i].path.size(); ++n) {
      const std::uint32_t x = corners_[i].path[n], exit = from_first_side(t, x ^ 1U);
      const std::uint32_t known = triangles[t].beyond[exit];
      t = known != Unfolded_diamond::Triangles::none
              ? known
              : triangles.enter(t, exit, input_side(input(), x));
    }
    diamond_.corners[i] = {t, from_first_side(t, corners_[i].halfedge), corners_[i].weights};
  }
  return diamond_;
}

} // namespace CGAL::Intrinsic_triangulations
