// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_TURNED_POSITIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_TURNED_POSITIONS_H

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Turn_products.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/formulas/Development.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
\brief holds the positions of the points of a development of input triangles in the plane.

Over needles a face crosses thousands of triangles about one vertex. Of such a turn only the last
point is computed, and others when they are asked for, see `Turn_products`. It reuses its memory.
\tparam FT number type of the plane
*/
template <FieldNumber FT>
class Turned_positions {
public:
  /// A point of the plane.
  using Point = Plane_vector<FT>;
  /// A functor from an input halfedge to the values of its face from it.
  using Values = std::function<Face_values<FT>(std::uint32_t)>;

  /// develops triangles, such that the first side of the first one runs from 0 to 1. All other
  /// arguments must live as long as points are asked for; the input is always the same.
  /// \complexity linear in the number of triangles, arithmetic in the number of short turns
  void develop(const Development<>& triangles, const Input& input, const Vertex_fans& fans,
               Values values) {
    input_ = &input;
    fans_ = &fans;
    values_ = std::move(values);
    unit_ = values_(triangles[0].side).squared_lengths[0];
    z_.assign({{FT(0), FT(0)}, {FT(1), FT(0)}});
    turns_.clear();
    std::uint32_t skipped = 0;
    for (std::uint32_t n = 0; n < triangles.size();) {
      const std::uint32_t about_source = end_of_turn(triangles, n, 0),
                          about_target = end_of_turn(triangles, n, 1),
                          end = std::max(about_source, about_target);
      if (end - n < long_turn) {
        for (; n < end; ++n) z_.push_back(apex_of(triangles[n]));
      } else {
        skipped += end - n - 1;
        const Turn turn = make_turn(triangles, n, end, about_source == end ? 0 : 1, skipped);
        z_.push_back(placed(turn, end - n));
        turns_.push_back(turn);
        n = end;
      }
    }
  }

  /// returns the position of a point.
  Point operator[](std::uint32_t point) const {
    const auto after =
        std::upper_bound(turns_.begin(), turns_.end(), point,
                         [](std::uint32_t p, const Turn& turn) { return p < turn.first; });
    if (after == turns_.begin()) return z_[point];
    const Turn& turn = *(after - 1);
    if (point < turn.last) return placed(turn, point - turn.first + 1);
    return z_[point - turn.skipped];
  }
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
  // From so many triangles on a turn is long. Shorter ones, nearly all on meshes without needles,
  // take less time one by one.
  static constexpr std::uint32_t long_turn = 32;

  // triangles about a common corner, pivot
  struct Turn {
    std::uint32_t first, last; // points opposite the pivot
    std::uint32_t skipped;     // points that are not computed up to its last one
    std::uint32_t slot;        // of the first side as it starts from the pivot
    bool is_clockwise;         // the pivot is where first sides end
    FT squared_length;         // of the first side
    Point pivot, arm;          // its position, and the vector from it along the first side
  };

  // behind the last triangle that has the same end of the first side as triangle n, all in between
  static std::uint32_t end_of_turn(const Development<>& triangles, std::uint32_t n, unsigned end) {
    std::uint32_t next = n + 1;
    while (next < triangles.size() && triangles[next].parent() == next - 1 &&
           triangles[next].point[end] == triangles[n].point[end])
      ++next;
    return next;
  }

  Point apex_of(const Development<>::Triangle& t) const {
    const Face_values<FT> v = values_(t.side);
    const auto& l = v.squared_lengths;
    const Point a = apex(l[0], l[1], l[2], v.quadruple_area);
    if (t.point[2] == 2) return a;
    const Point from = (*this)[t.point[0]];
    return from + ((*this)[t.point[1]] - from) * a;
  }

  Turn make_turn(const Development<>& triangles, std::uint32_t n, std::uint32_t end, unsigned pivot,
                 std::uint32_t skipped) const {
    const Development<>::Triangle& t = triangles[n];
    const Point z = (*this)[t.point[pivot]];
    return {n + 2,      end + 1,
            skipped,    fans_->slot(t.side ^ pivot),
            pivot == 1, values_(t.side).squared_lengths[0],
            z,          (*this)[t.point[1 - pivot]] - z};
  }

  // behind so many triangles of a turn
  Point placed(const Turn& t, std::uint32_t count) const {
    if (!t.is_clockwise)
      return t.pivot + t.arm * products_(*input_, *fans_, values_, t.slot, count);
    // the quotient counterclockwise is q, and 1 / q its conjugate by its square, which is that of
    // the lengths
    const std::uint32_t degree = fans_->degree(t.slot),
                        end = fans_->advance(t.slot, degree - count % degree);
    const Point q = products_(*input_, *fans_, values_, end, count);
    const FT scale = values_(fans_->halfedge(end)).squared_lengths[0] / t.squared_length;
    return t.pivot + t.arm * (scale * Point{q.x, FT(0) - q.y});
  }

  const Input* input_ = nullptr;
  const Vertex_fans* fans_ = nullptr;
  Values values_;
  FT unit_{};
  std::vector<Point> z_;    // of the points that are computed, in order
  std::vector<Turn> turns_; // long ones, in order
  mutable Turn_products<FT> products_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_TURNED_POSITIONS_H
