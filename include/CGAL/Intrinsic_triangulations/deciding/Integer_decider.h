// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_INTEGER_DECIDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_INTEGER_DECIDER_H

#include <CGAL/Intrinsic_triangulations/deciding/Figure_finder.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <optional>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Decides for a metric that stores nothing: intervals of doubles, evaluated on the figure of the
values, decide nearly all signs; the same figure decides the others exactly.
*/
template <class Triangulation, class Places>
class Integer_decider : public Figure_finder<Triangulation, Places> {
  using Base = Figure_finder<Triangulation, Places>;

public:
  using FT = Interval_nt<false>;
  using Base::Base;

  // whether the angles opposite the edge sum to at most pi
  bool is_open_delaunay(const Diamond& d) const {
    Diamond_values<FT> v = this->values(d);
    const bool are_right = left_cotangent_numerator(v).inf() >= 0 &&
                           right_cotangent_numerator(v).inf() >= 0; // areas do not matter
    return are_right || sign(d, Delaunay_expression(), v) != NEGATIVE;
  }
  // the sign of an expression in the values of a diamond, and of faces
  template <class Expression>
  Sign sign(const Diamond& d, const Expression& expression) const {
    static_assert(DiamondExpression<Expression>);
    Diamond_values<FT> v = this->values(d);
    return sign(d, expression, v);
  }
  template <class Expression>
  Sign sign(std::span<const Indexed_face> faces, const Expression& expression) const {
    static_assert(FaceExpression<Expression>);
    std::vector<Face_values<FT>> v = this->values(faces);
    if (const auto s = certain_sign(expression(std::span<const Face_values<FT>>(v)))) return *s;
    ++this->t_.metric().statistics().filter_failures;
    return this->exact_sign(faces, Recorded_face_expression(expression, faces.size()), v);
  }

  // doubles near the values of a face
  Face_values<double> approximate_values(const Indexed_face& face) const {
    const auto [l, a] = this->values(std::span(&face, 1)).front();
    return {{CGAL::to_double(l[0]), CGAL::to_double(l[1]), CGAL::to_double(l[2])},
            CGAL::to_double(a)};
  }

private:
  template <class Expression>
  Sign sign(const Diamond& d, const Expression& expression, Diamond_values<FT>& values) const {
    if (const std::optional<Sign> s = certain_sign(expression(values))) return *s;
    ++this->t_.metric().statistics().filter_failures;
    return this->exact_sign(d, recorded(expression), values);
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_INTEGER_DECIDER_H
