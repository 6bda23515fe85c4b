// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Value_recipes.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

void Value_recipes::expect_few_crossings(std::uint32_t edge) const {
  if (t_.correspondence().normal_coordinate(edge) > Diamond_unfolder::maximal_crossings)
    throw Undecidable("an edge of the Delaunay triangulation crosses too many "
                      "edges of the input");
}

const Unfolded_diamond* Value_recipes::strip(std::uint32_t edge) const {
  if (is_along_input(edge)) return nullptr;
  expect_few_crossings(edge);
  const Unfolded_diamond& strip = unfolder_.strip(view_, t_.correspondence(), side_with_face(edge));
  t_.correspondence().count_steps(t_, unfolder_.take_steps());
  return &strip;
}

Face_side Value_recipes::input_side_of(std::uint32_t edge) const {
  const Integer_coordinates& c = t_.correspondence();
  const std::uint32_t h = c.fans().halfedge(c.roundabout(2 * edge));
  return input_side(c.input(), c.input().is_border(h) ? h ^ 1U : h);
}

const Unfolded_diamond& Value_recipes::face(std::uint32_t f) const {
  std::uint32_t h = view_.halfedge_of_face(f);
  for (int k = 0; k < 3; ++k, h = view_.next(h)) expect_few_crossings(h / 2);
  return unfolder_.face(view_, t_.correspondence(), h);
}

} // namespace CGAL::Intrinsic_triangulations::internal
