// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FIGURES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FIGURES_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
Figures that need no unfolding, or are made of others: see `Exact_ladder`.
*/

namespace CGAL::Intrinsic_triangulations {

/// A diamond of two faces of the input.
struct Input_diamond {
  Face_side left;  ///< side of the face on the left
  Face_side right; ///< side of the face on the right, glued to `left`

  /// returns the number of faces.
  static constexpr std::size_t size() { return 2; }
  /// returns the values; see `Unfolded_diamond::positions()`.
  template <class FT, class Input_values>
  Diamond_values<FT> values(const Input_values& input) const {
    const auto side = [&input](const Face_side& s, std::uint32_t k) -> FT {
      return input(s.face).first[(s.slot + k) % 3];
    };
    return {side(left, 0),  side(left, 1),           side(left, 2),           side(right, 1),
            side(right, 2), input(left.face).second, input(right.face).second};
  }
};

/// A diamond that lies in the plane of an input face in space, with the same orientation.
struct Flat_diamond {
  /// A corner, a convex combination of points of the input.
  struct Corner {
    std::array<std::uint32_t, 3> points; ///< the points
    std::array<double, 3> weights;       ///< their weights
  };
  std::uint32_t face;            ///< an input face in the plane
  std::array<Corner, 4> corners; ///< corners i, j, k, m
};

/// Faces that are unfolded, each the left one of its diamond.
struct Unfolded_faces {
  std::vector<Unfolded_diamond> faces; ///< the faces

  /// returns the number of triangles.
  std::size_t size() const {
    std::size_t n = 0;
    for (const Unfolded_diamond& f : faces) n += f.size();
    return n;
  }
  /// evaluates the faces; see `Unfolded_diamond::positions()`.
  template <class FT, class Input_values>
  std::vector<Face_values<FT>> values(const Input_values& input) const {
    std::vector<Face_values<FT>> result;
    for (const Unfolded_diamond& f : faces) {
      const Diamond_values<FT> v = f.values<FT>(input);
      result.push_back({{v.ij, v.jk, v.ki}, v.area_f});
    }
    return result;
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FIGURES_H
