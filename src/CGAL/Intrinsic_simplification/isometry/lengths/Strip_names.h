// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_STRIP_NAMES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_STRIP_NAMES_H

#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_number.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Value_recipes.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Gmpq.h>

#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Names strips of input triangles, so that congruent strips have the same name:
then the edges over them have the same length, without arithmetic. A strip and
its mirror image have one name, from either end.
*/
class Strip_names {
public:
  using Name = std::uint32_t;

  // \param edge an edge of the triangulation of the recipes
  // \param exponent squared lengths are multiplied by 2^exponent
  // \return nothing if the strip is not a row of triangles
  std::optional<Name> name(const Value_recipes& recipes, std::uint32_t edge, int exponent);

private:
  // A strip: for the first and the last triangle the sides on the left and on
  // the right; for those between, on which side the path turns, and the side
  // that it does not cross; crossed sides.
  struct Row {
    std::uint32_t first_left, first_right, last_left, last_right;
    std::vector<std::uint32_t> crossed, turn, side;
    std::vector<std::uint32_t> letters(bool is_backward, bool is_mirrored) const;
  };

  std::uint32_t name_of_length(const Input_metric& m, Face_side s, int exponent);
  std::optional<Row> row(const Input_metric& m, const Unfolded_diamond& strip, int exponent);

  std::unordered_map<Gmpq, std::uint32_t, Hash_of_rational> lengths_;
  std::map<std::vector<std::uint32_t>, Name> names_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_STRIP_NAMES_H
