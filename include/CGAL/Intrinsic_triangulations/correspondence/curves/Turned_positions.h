// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_TURNED_POSITIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_TURNED_POSITIONS_H

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Triangle_strips.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Turn_products.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
\brief holds the positions of the points of a development of input triangles in the plane.

Over needles a face crosses thousands of triangles about one vertex. Of such a turn only the last
point is computed, and others when they are asked for, see `Turn_products`. It reuses its memory.
\tparam FT `double`, `Interval_nt<false>` or a `Ball`: the number type of the plane
*/
template <FieldNumber FT>
class Turned_positions {
public:
  /// A point of the plane.
  using Point = Plane_vector<FT>;
  /// A functor from an input halfedge to the values of its face from it.
  using Values = typename Turn_products<FT>::Values;

  /// develops triangles, such that the first side of the first one runs from 0 to 1. All other
  /// arguments must live as long as points are asked for; the input is always the same.
  /// \complexity linear in the number of triangles that are stored, and of long turns
  void develop(const Triangle_strips& triangles, const Input& input, const Vertex_fans& fans,
               Values values);

  /// returns the position of a point.
  Point operator[](std::uint32_t point) const;
  /// returns the squared length of the unit of the plane, the first side of the first triangle.
  const FT& unit() const { return unit_; }
  /// tells whether errors of points are too large for the middles of their intervals.
  /// \tparam Interval the number type: others have no bounds
  template <class Interval>
  bool is_vague() const {
    const auto is_wide = [](const Interval& x) {
      return !(x.sup() - x.inf() <= 0x1p-26 * std::max(1., std::abs(x.sup())));
    };
    return std::any_of(z_.begin(), z_.end(),
                       [&](const Point& p) { return is_wide(p.x) || is_wide(p.y); });
  }

  /// returns the input of the last development.
  const Input& input() const { return *input_; }
  /// returns the halfedges around its vertices.
  const Vertex_fans& fans() const { return *fans_; }

private:
  // triangles about a common corner, pivot
  struct Turn {
    std::uint32_t first, last; // points opposite the pivot
    std::uint32_t skipped;     // points that are not computed up to its last one
    std::uint32_t slot;        // of the first side as it starts from the pivot
    bool is_clockwise;         // the pivot is where first sides end
    FT squared_length;         // of the first side
    Point pivot, arm;          // its position, and the vector from it along the first side
  };

  // of the triangle of a side, on points
  Point apex_of(std::uint32_t side, const Triangle_strips::Points& points) const;

  Turn make_turn(const Triangle_strips& triangles, std::uint32_t n, std::uint32_t end,
                 unsigned pivot, std::uint32_t skipped) const;

  // behind so many triangles of a turn
  Point placed(const Turn& t, std::uint32_t count) const;

  // The point inside a turn. Each is asked for a few times, by a search and by what was found.
  const Point& inside(const Turn& t, std::uint32_t point) const;

  const Input* input_ = nullptr;
  const Vertex_fans* fans_ = nullptr;
  Values values_;
  FT unit_{};
  std::vector<Point> z_;    // of the points that are computed, in order
  std::vector<Turn> turns_; // long ones, in order
  mutable Turn_products<FT> products_;
  struct Known_point {
    std::uint32_t number;
    Point place;
  };
  // points inside turns that were asked for last, and the number of all that were computed
  mutable std::array<Known_point, 16> known_{};
  mutable std::size_t number_of_known_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_TURNED_POSITIONS_H
