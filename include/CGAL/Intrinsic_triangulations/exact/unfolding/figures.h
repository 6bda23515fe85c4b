// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FIGURES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FIGURES_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/formulas/Development.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
Figures that need no unfolding, or are made of others: see `Exact_ladder`.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a diamond over the input triangles that reach its corners, unfolded into a plane.

With the first side of a triangle from z_t to z_u, squared lengths L_t of the side, L_u of the next
and L_v of the last, and D = 4 L_t L_v - p^2, p = L_t + L_v - L_u, its apex is

    z_v = z_t + (z_u - z_t) w,     w = (p + sqrt(-D)) / (2 L_t),

in complex numbers. The only divisors are squared lengths of the input, and the figure does not
depend on the flips that made the diamond.

A vertex that was inserted is a combination of the points of one triangle, with rational weights.
*/
struct Unfolded_diamond {
  /// The input triangles.
  using Triangles = Development<Face_side>;
  /// An input triangle.
  using Triangle = Triangles::Triangle;

  /// A corner of the diamond.
  struct Corner {
    std::uint32_t triangle = 0;             ///< triangle in the tree
    std::uint32_t corner = 0;               ///< corner of the triangle, from its first side on
    std::array<double, 3> weights{1, 0, 0}; ///< barycentric coordinates there, from that corner on
    /// tells whether it is a vertex that was inserted, not the corner of the triangle.
    bool is_inserted() const { return weights[0] != 1; }
  };

  /// The tree.
  Triangles triangles;
  /// Corners i, j, k, m of the diamond.
  std::array<Corner, 4> corners;

  /// returns the number of triangles.
  std::size_t size() const { return triangles.size(); }

  /// tells whether a corner is a vertex that was inserted.
  bool has_inserted_corners() const {
    return std::any_of(corners.begin(), corners.end(),
                       [](const Corner& c) { return c.is_inserted(); });
  }
  /// tells whether all of its triangles are those of points in space.
  bool is_in_space(const Input_metric& input) const {
    return input.is_in_space() ||
           std::all_of(triangles.begin(), triangles.end(),
                       [&input](const auto& t) { return input.is_in_space(t.side.face); });
  }
  /// returns the numbers of the points of the triangle of a corner, from it on.
  std::array<std::uint32_t, 3> points(const Corner& c) const {
    const std::array<std::uint32_t, 3>& p = triangles[c.triangle].point;
    return {p[c.corner], p[(c.corner + 1) % 3], p[(c.corner + 2) % 3]};
  }
  /// returns the number of the point in corner `c` of the diamond. \pre it was not inserted
  std::uint32_t point(std::size_t c) const {
    return triangles[corners[c].triangle].point[corners[c].corner];
  }

  /// A point of the plane into which the triangles are unfolded, where point 0 is the origin and
  /// point 1 is (1, 0).
  template <class FT>
  using Position = Plane_vector<FT>;
  /// The positions of all points.
  template <class FT>
  using Positions = boost::container::small_vector<Position<FT>, 16>;

  /*!
  \brief unfolds the triangles.
  \tparam FT a model of `Field`
  \tparam Input_values a functor from the number of an input face to a pair of its three squared
  lengths and its quadruple area
  */
  template <class FT, class Input_values>
  Positions<FT> positions(const Input_values& input) const {
    if constexpr (requires { typename internal::Enclosure_parts<FT>::Center; })
      return enclosed_positions<FT>(input);
    Positions<FT> z{{FT(0), FT(0)}, {FT(1), FT(0)}};
    triangles.carry(z, [&](const Triangle& t, const Position<FT>& from, const Position<FT>& to) {
      return apex_between(from, to, t.side.slot, input(t.side.face));
    });
    return z;
  }

  /// returns where corner number `c` of the diamond is, by the positions of all points.
  template <class FT>
  Position<FT> position(std::size_t c, const Positions<FT>& z) const {
    if (!corners[c].is_inserted()) return z[point(c)];
    Position<FT> sum{FT(0), FT(0)};
    const std::array<std::uint32_t, 3> p = points(corners[c]);
    for (std::size_t k = 0; k < 3; ++k) {
      const FT weight(corners[c].weights[k]);
      sum = {sum.x + weight * z[p[k]].x, sum.y + weight * z[p[k]].y};
    }
    return sum;
  }

  /// evaluates the diamond by unfolding; see `positions()`.
  template <class FT, class Input_values>
  Diamond_values<FT> values(const Input_values& input) const {
    const Positions<FT> z = positions<FT>(input);
    return values_of<FT>({position(0, z), position(1, z), position(2, z), position(3, z)},
                         squared_unit<FT>(input));
  }

  /// returns the values of a diamond with given corners. \param unit the squared length of (1, 0)
  template <class FT>
  static Diamond_values<FT> values_of(const std::array<Position<FT>, 4>& corners, const FT& unit) {
    const auto& [i, j, k, m] = corners;
    const FT twice = unit + unit;
    const auto length = [&unit](const Position<FT>& e) { return unit * dot(e, e); };
    return {length(j - i),
            length(k - j),
            length(i - k),
            length(m - i),
            length(j - m),
            twice * cross(j - i, k - i),
            twice * cross(i - j, m - j)};
  }

  /// returns the squared distance of corners i and j, by unfolding; see `positions()`.
  template <class FT, class Input_values>
  FT squared_length(const Input_values& input) const {
    const Positions<FT> z = positions<FT>(input);
    const Position<FT> e = position(1, z) - position(0, z);
    return squared_unit<FT>(input) * dot(e, e);
  }

  /*!
  \brief returns the part that reaches all corners but one, which is put where corner k is.

  Three corners may be near each other and the fourth across hundreds of triangles. The part is
  enough for expressions in those three.
  \param corner the corner that is left out, not k: 0 for i, 1 for j, 3 for m
  \complexity linear
  */
  Unfolded_diamond without(std::size_t corner) const;

private:
  // the squared length of the first side of the first triangle
  template <class FT, class Input_values>
  FT squared_unit(const Input_values& input) const {
    const Face_side& s = triangles[0].side;
    return input(s.face).first[s.slot];
  }

  // the apex of a triangle, from the ends of its first side
  template <class FT, class Face>
  static Position<FT> apex_between(const Position<FT>& from, const Position<FT>& to,
                                   std::uint32_t slot, const Face& face) {
    const auto& [l, area] = face;
    const FT& first = l[slot];
    return from +
           FT(FT(1) / (first + first)) *
               ((to - from) * scaled_corner(first, l[(slot + 1) % 3], l[(slot + 2) % 3], area));
  }

  // Sides follow from each other along the tree, so that their errors relative to their lengths
  // only add up; differences of positions would have the errors of all sides before, again and
  // again. The first few positions are better as differences: they take fewer operations, some of
  // them exact. Both enclose, so that no sign depends on this number.
  static constexpr std::size_t few_points = 10;

  template <class FT, class Input_values>
  Positions<FT> enclosed_positions(const Input_values& input) const {
    using Vector = Complex_ball<FT>;
    for (const Triangle& t : triangles) // otherwise waiting for memory takes half of the time
      __builtin_prefetch(&input(t.side.face));
    Positions<FT> z{{FT(0), FT(0)}, {FT(1), FT(0)}};
    boost::container::small_vector<std::array<Vector, 3>, 16> sides; // of triangles
    for (std::uint32_t n = 0; n < size(); ++n) {
      const Triangle& t = triangles[n];
      const std::uint32_t slot = t.side.slot;
      const auto& [l, area] = input(t.side.face);
      const FT &first = l[slot], &next = l[(slot + 1) % 3], &last = l[(slot + 2) % 3];
      const Vector side = n == 0 ? Vector() : -sides[t.parent()][triangles.exit_to(n)];
      const FT twice = first + first;
      const Vector to_apex = side * Vector(first + last - next, area, twice);
      sides.push_back({side, side * Vector(last - first - next, area, twice), -to_apex});
      const Position<FT>& a = z[t.point[0]];
      z.push_back(z.size() < few_points
                      ? apex_between(a, z[t.point[1]], slot, input(t.side.face))
                      : Position<FT>{a.x + to_apex.real(), a.y + to_apex.imaginary()});
    }
    return z;
  }
};

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
