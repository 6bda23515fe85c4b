// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_QUADRATIC_FORM_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_QUADRATIC_FORM_H

#include <CGAL/Interval_nt.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>

/*!
\file
Quadratic forms on the plane: as matrices, and by their values on the sides of a triangle, of which
squared lengths are the best known ones. Intervals require that the processor rounds up.
*/

namespace CGAL::Intrinsic_triangulations::internal {

using Interval = Interval_nt<false>;

// The values of a quadratic form on the sides 01, 12, 20 of a triangle.
using Side_values = std::array<double, 3>;

// A point of the plane, known exactly.
struct Exact_point {
  double x = 0, y = 0;
};

// The points of a triangle, counterclockwise.
using Plane_triangle = std::array<Exact_point, 3>;

// A symmetric matrix of two rows.
template <class FT>
struct Symmetric_matrix {
  FT xx, xy, yy;
};

// Symmetric matrices in doubles; they have no bounds on their errors.
using Form = Symmetric_matrix<double>;

// A matrix that contains the form.
using Enclosed_form = Symmetric_matrix<Interval>;

// The matrix of the form with values on the sides of a triangle that is known by two of its sides.
template <class FT>
class Form_of_sides {
public:
  explicit Form_of_sides(const Plane_triangle& p)
      : x_(FT(p[1].x) - FT(p[0].x)), y_(FT(p[1].y) - FT(p[0].y)), u_(FT(p[2].x) - FT(p[0].x)),
        w_(FT(p[2].y) - FT(p[0].y)) {
    const FT d = x_ * w_ - y_ * u_;
    inverse_ = FT(1) / (d * d);
  }
  Symmetric_matrix<FT> operator()(const Side_values& q) const {
    const FT a(q[0]), c(q[2]), b = (a + c - FT(q[1])) * FT(0.5);
    return {(w_ * w_ * a - (w_ + w_) * y_ * b + y_ * y_ * c) * inverse_,
            ((u_ * y_ + x_ * w_) * b - u_ * w_ * a - x_ * y_ * c) * inverse_,
            (u_ * u_ * a - (u_ + u_) * x_ * b + x_ * x_ * c) * inverse_};
  }

private:
  FT x_, y_, u_, w_, inverse_;
};

inline Form middle_of(const Enclosed_form& m) {
  const auto middle = [](const Interval& i) { return (i.inf() + i.sup()) / 2; };
  return {middle(m.xx), middle(m.xy), middle(m.yy)};
}

// The values of a form on the sides of a triangle.
Side_values side_values(const Form& m, const Plane_triangle& p);

// A form above both, the smallest one in the basis in which both are diagonal; and one below both,
// the greatest. Up to rounding.
Form join(const Form& a, const Form& b);
Form meet(const Form& a, const Form& b);

// The least and the greatest factor of one form by another, with values on the same triangle; up
// to rounding, and infinite where the other one is not positive.
std::array<double, 2> factors(const Side_values& form, const Side_values& by);

// Certainly `upper` minus `lower` is nowhere negative.
bool is_proven_above(const Enclosed_form& upper, const Enclosed_form& lower);

// The same for values on one triangle: factor times `upper`, and `lower`.
bool is_proven_above(const Side_values& upper, const Interval& factor,
                     const std::array<Interval, 3>& lower);

// Certainly the values are those of a form that is nowhere above the other one.
bool is_proven_below(const Side_values& lower, const std::array<Interval, 3>& upper);

// Values on the sides of a triangle, of a form that is proven to be above all given ones; nothing
// if the triangle has no area in intervals. \param near such a form, up to rounding
std::optional<Side_values> proven_above(const Form& near, const Plane_triangle& p,
                                        std::span<const Enclosed_form* const> forms);

// A form that is proven to be below all; zero if none is found.
Side_values proven_below(const Form& near, const Plane_triangle& p,
                         std::span<const Enclosed_form* const> forms);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_QUADRATIC_FORM_H
