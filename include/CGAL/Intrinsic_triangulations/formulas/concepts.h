// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_CONCEPTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_CONCEPTS_H

#include <concepts>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief requires a number type with +, - and *, which may return expression templates.

Syntax of \ref ::RingNumber.
*/
template <class FT>
concept RingNumber = std::copyable<FT> && requires(const FT& a) {
  FT(a + a);
  FT(a - a);
  FT(a * a);
};

/*!
\brief requires a number type with +, -, * and /, and with constants made of `int` and `double`.

Syntax of \ref ::FieldNumber.
*/
template <class FT>
concept FieldNumber = RingNumber<FT> && std::constructible_from<FT, int> &&
    std::constructible_from<FT, double> && requires(const FT& a) {
  FT(a / a);
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_CONCEPTS_H
