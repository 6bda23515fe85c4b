// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Triangle_strips.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Turned_positions.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

template <FieldNumber FT>
void Turned_positions<FT>::develop(const Triangle_strips& triangles, const Input& input,
                                   const Vertex_fans& fans, Values values) {
  input_ = &input;
  fans_ = &fans;
  values_ = std::move(values);
  unit_ = values_(triangles.side(0)).squared_lengths[0];
  z_.assign({{FT(0), FT(0)}, {FT(1), FT(0)}});
  turns_.clear();
  number_of_known_ = 0;
  std::uint32_t skipped = 0;
  for (std::uint32_t n = 0; n < triangles.size();) {
    const std::uint32_t about_source = triangles.end_of_turn(n, 0),
                        about_target = triangles.end_of_turn(n, 1),
                        end = std::max(about_source, about_target);
    if (end - n < Triangle_strips::long_turn) {
      for (; n < end; ++n) z_.push_back(apex_of(triangles.side(n), triangles.points(n)));
    } else {
      skipped += end - n - 1;
      const Turn turn = make_turn(triangles, n, end, about_source == end ? 0 : 1, skipped);
      z_.push_back(placed(turn, end - n));
      turns_.push_back(turn);
      n = end;
    }
  }
}

template <FieldNumber FT>
typename Turned_positions<FT>::Point Turned_positions<FT>::operator[](std::uint32_t point) const {
  const auto after =
      std::upper_bound(turns_.begin(), turns_.end(), point,
                       [](std::uint32_t p, const Turn& turn) { return p < turn.first; });
  if (after == turns_.begin()) return z_[point];
  const Turn& turn = *(after - 1);
  if (point < turn.last) return inside(turn, point);
  return z_[point - turn.skipped];
}

template <FieldNumber FT>
typename Turned_positions<FT>::Point
Turned_positions<FT>::apex_of(std::uint32_t side, const Triangle_strips::Points& points) const {
  const Face_values<FT> v = values_(side);
  const auto& l = v.squared_lengths;
  const Point a = apex(l[0], l[1], l[2], v.quadruple_area);
  if (points[2] == 2) return a;
  const Point from = (*this)[points[0]];
  return from + ((*this)[points[1]] - from) * a;
}

template <FieldNumber FT>
typename Turned_positions<FT>::Turn
Turned_positions<FT>::make_turn(const Triangle_strips& triangles, std::uint32_t n,
                                std::uint32_t end, unsigned pivot, std::uint32_t skipped) const {
  const std::uint32_t side = triangles.side(n);
  const Triangle_strips::Points points = triangles.points(n);
  const Point z = (*this)[points[pivot]];
  return {n + 2,      end + 1,
          skipped,    fans_->slot(side ^ pivot),
          pivot == 1, values_(side).squared_lengths[0],
          z,          (*this)[points[1 - pivot]] - z};
}

template <FieldNumber FT>
const typename Turned_positions<FT>::Point&
Turned_positions<FT>::inside(const Turn& t, std::uint32_t point) const {
  const auto end = known_.begin() + std::min(number_of_known_, known_.size());
  const auto found =
      std::find_if(known_.begin(), end, [&](const Known_point& k) { return k.number == point; });
  if (found != end) return found->place;
  Known_point& next = known_[number_of_known_ % known_.size()];
  next = {point, placed(t, point - t.first + 1)};
  ++number_of_known_;
  return next.place;
}

template <FieldNumber FT>
typename Turned_positions<FT>::Point Turned_positions<FT>::placed(const Turn& t,
                                                                  std::uint32_t count) const {
  if (!t.is_clockwise) return t.pivot + t.arm * products_(*input_, *fans_, values_, t.slot, count);
  // the quotient counterclockwise is q, and 1 / q its conjugate by its square, which is that of
  // the lengths
  const std::uint32_t degree = fans_->degree(t.slot),
                      end = fans_->advance(t.slot, degree - count % degree);
  const Point q = products_(*input_, *fans_, values_, end, count);
  const FT scale = values_(fans_->halfedge(end)).squared_lengths[0] / t.squared_length;
  return t.pivot + t.arm * (scale * Point{q.x, FT(0) - q.y});
}

template class Turned_positions<double>;
template class Turned_positions<Interval_nt<false>>;
template class Turned_positions<Short_ball>;
template class Turned_positions<Long_ball>;

} // namespace CGAL::Intrinsic_triangulations::internal
