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

// The matrix of the form with values on the sides of a triangle: each entry is linear in the three
// values. The first point may be the origin: then sides are exact, and products of them cheap.
class Form_of_sides {
public:
  explicit Form_of_sides(const Plane_triangle& p);
  Enclosed_form operator()(const Side_values& q) const;

private:
  template <class Number>
  void measure(Number x, Number y, Number u, Number w);

  std::array<Interval, 3> xx_, xy_, yy_; // factors of the values
};

inline double determinant(const Form& m) { return m.xx * m.yy - m.xy * m.xy; }

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

// The same for values on one triangle.
bool is_proven_above(const Side_values& upper, const std::array<Interval, 3>& lower);

// Certainly the values are those of a form that is nowhere above the other one.
bool is_proven_below(const Side_values& lower, const std::array<Interval, 3>& upper);

// A form by its values on the sides of a triangle, and a matrix that contains it.
struct Proven_form {
  Side_values values;
  Enclosed_form matrix;
};

// A triangle in the plane, and what makes matrices of values on its sides.
struct Measured_triangle {
  explicit Measured_triangle(const Plane_triangle& p) : points(p), matrix(p) {}
  Plane_triangle points;
  Form_of_sides matrix;
};

// A form that is proven to be above all given ones; nothing if the triangle has no area in
// intervals. \param near such a form, up to rounding
std::optional<Proven_form> proven_above(const Form& near, const Measured_triangle& t,
                                        std::span<const Enclosed_form* const> forms);

// A form that is proven to be below all; zero if none is found.
Proven_form proven_below(const Form& near, const Measured_triangle& t,
                         std::span<const Enclosed_form* const> forms);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_QUADRATIC_FORM_H
