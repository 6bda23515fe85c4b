// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_UNFOLDED_DIAMOND_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_UNFOLDED_DIAMOND_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Complex_ball.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a tree of input triangles, to be unfolded into a plane, that reaches all corners of a
diamond.

Points 0 and 1 are the ends of side 0 of the first triangle. Triangle number n adds point n + 2, the
corner opposite the side by which it is entered. With that side from z_t to z_u, squared lengths
L_t of the side, L_u of the next and L_v of the last, and D = 4 L_t L_v - p^2, p = L_t + L_v - L_u,

    z_v = z_t + (z_u - z_t) w,     w = (p + sqrt(-D)) / (2 L_t),

in complex numbers. Nothing is ever divided by but squared lengths of the input, and the figure does
not depend on the flips that made the diamond.

A vertex that was inserted is a combination of the points of one triangle, with rational weights.
*/
struct Unfolded_diamond {
  /// An input triangle in the tree.
  struct Triangle {
    std::uint32_t face;                 ///< input face
    std::uint32_t entry;                ///< slot of the side by which it is entered; 0 in the first
    std::uint32_t parent;               ///< triangle on the other side of it; itself in the first
    std::array<std::uint32_t, 3> point; ///< points in the corners, where sides 0, 1, 2 start

    /// returns the point where the entry starts.
    std::uint32_t start() const { return point[entry]; }
    /// returns the point where the entry ends.
    std::uint32_t end() const { return point[(entry + 1) % 3]; }
  };

  /// A corner of the diamond.
  struct Corner {
    std::uint32_t triangle = 0;             ///< triangle in the tree
    std::uint32_t slot = 0;                 ///< corner of the triangle
    std::array<double, 3> weights{1, 0, 0}; ///< barycentric coordinates there, from that corner on
    /// tells whether it is a vertex that was inserted, not the corner of the triangle.
    bool is_inserted() const { return weights[0] != 1; }
  };

  /// The tree, parents first.
  std::vector<Triangle> triangles;
  /// Corners i, j, k, m of the diamond.
  std::array<Corner, 4> corners;

  /// returns the number of triangles.
  std::size_t size() const { return triangles.size(); }

  /// returns the triangle that is glued along slot `entry` to slot `exit` of triangle `parent`, to
  /// be added to the tree.
  Triangle beyond(std::uint32_t parent, std::uint32_t exit, std::uint32_t face,
                  std::uint32_t entry) const {
    const std::array<std::uint32_t, 3>& p = triangles[parent].point;
    Triangle t{face, entry, parent, {}};
    t.point[entry] = p[(exit + 1) % 3];
    t.point[(entry + 1) % 3] = p[exit];
    t.point[(entry + 2) % 3] = static_cast<std::uint32_t>(triangles.size()) + 2;
    return t;
  }

  /// tells whether a corner is a vertex that was inserted.
  bool has_inserted_corners() const {
    return std::any_of(corners.begin(), corners.end(),
                       [](const Corner& c) { return c.is_inserted(); });
  }
  /// tells whether all of its triangles are those of points in space.
  bool is_in_space(const Input_metric& input) const {
    return input.is_in_space() ||
           std::all_of(triangles.begin(), triangles.end(),
                       [&input](const auto& t) { return input.is_in_space(t.face); });
  }
  /// returns the numbers of the points of the triangle of a corner, from its slot on.
  std::array<std::uint32_t, 3> points(const Corner& c) const {
    const std::array<std::uint32_t, 3>& p = triangles[c.triangle].point;
    return {p[c.slot], p[(c.slot + 1) % 3], p[(c.slot + 2) % 3]};
  }
  /// returns the number of the point in corner `c` of the diamond. \pre it was not inserted
  std::uint32_t point(std::size_t c) const {
    return triangles[corners[c].triangle].point[corners[c].slot];
  }

  /// A point of the plane into which the triangles are unfolded, where point 0 is the origin and point 1 is (1, 0).
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
    for (const Triangle& t : triangles) z.push_back(apex(t, z, input(t.face)));
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
                         input(triangles.front().face).first[0]);
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
    return input(triangles.front().face).first[0] * dot(e, e);
  }

private:
  // the apex of a triangle, from the positions of its other corners
  template <class FT, class Face>
  static Position<FT> apex(const Triangle& t, const Positions<FT>& z, const Face& face) {
    const auto& [l, area] = face;
    const Position<FT>& a = z[t.start()];
    return a + FT(FT(1) / (l[t.entry] + l[t.entry])) *
                   ((z[t.end()] - a) *
                    scaled_corner(l[t.entry], l[(t.entry + 1) % 3], l[(t.entry + 2) % 3], area));
  }

  // Sides follow from each other along the tree, so that their errors relative to their lengths only add up; differences of
  // positions would have the errors of all sides before, again and again. The first few positions are better as differences: they take
  // fewer operations, some of them exact.
  static constexpr std::size_t few_points = 10;

  template <class FT, class Input_values>
  Positions<FT> enclosed_positions(const Input_values& input) const {
    using Vector = Complex_ball<FT>;
    for (const Triangle& t : triangles) // half of the time is spent on waiting for memory otherwise
      __builtin_prefetch(&input(t.face));
    Positions<FT> z{{FT(0), FT(0)}, {FT(1), FT(0)}};
    boost::container::small_vector<std::array<Vector, 3>, 16>
        sides; // of triangles, from slot to slot
    for (const Triangle& t : triangles) {
      const auto& [l, area] = input(t.face);
      const std::size_t next = (t.entry + 1) % 3, last = (t.entry + 2) % 3;
      const Vector side = sides.empty() ? Vector() : -sides[t.parent][exit_to(t)];
      const FT twice = l[t.entry] + l[t.entry];
      const Vector to_apex = side * Vector(l[t.entry] + l[last] - l[next], area, twice);
      sides.emplace_back();
      sides.back()[t.entry] = side;
      sides.back()[next] = side * Vector(l[last] - l[t.entry] - l[next], area, twice);
      sides.back()[last] = -to_apex;
      const Position<FT>& a = z[t.start()];
      z.push_back(z.size() < few_points
                      ? apex(t, z, input(t.face))
                      : Position<FT>{a.x + to_apex.real(), a.y + to_apex.imaginary()});
    }
    return z;
  }
  // the slot of the parent at which a triangle is glued to it
  std::size_t exit_to(const Triangle& t) const {
    const std::array<std::uint32_t, 3>& p = triangles[t.parent].point;
    return p[1] == t.start() && p[0] == t.end() ? 0 : p[2] == t.start() && p[1] == t.end() ? 1 : 2;
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_UNFOLDED_DIAMOND_H
