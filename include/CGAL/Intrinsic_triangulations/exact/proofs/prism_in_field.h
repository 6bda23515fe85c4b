// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_PRISM_IN_FIELD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_PRISM_IN_FIELD_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Word_integer.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/thresholds.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Question.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/prism.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief decides whether an expression over a cylinder or prism is zero, if all of its terms have one
degree.

The positions of corners are integers and sums of roots of integers there (see `Prism_proof`), which
takes no division: ten microseconds, where the field takes hundreds, whatever the number of
triangles.
*/
struct Prism_in_field_proof {
  /// returns `zero` or `not_zero`, or nothing is known.
  Answer operator()(const Question<Unfolded_diamond, Recorded_diamond_expression>& q) const {
    if (!q.expression.degree() || !q.expression.degree()->is_uniform) return Answer::open;
    return internal::with_prism(
        q, [&](const auto& prism) { return decide(q, prism); }, Answer::open);
  }

private:
  using Number = Multiquadratic_number;

  template <class Asked, class Prism>
  static Answer decide(const Asked& q, const Prism& prism) {
    Square_class_basis basis;
    basis.limit_products(thresholds::pairs_of_terms);
    std::vector<Number> roots;
    for (const auto& s : prism.squares()) {
      const auto root = basis.sqrt_of(Gmpq(integer(s)));
      if (!root) return Answer::open;
      roots.emplace_back(basis, *root);
    }
    std::array<Unfolded_diamond::Position<Number>, 4> corners;
    for (std::size_t c = 0; c < 4; ++c) {
      corners[c] = {Number(Gmpq(integer(prism.x(c)))), Number(0)};
      for (std::size_t n = 0; n < prism.y(c).size(); ++n)
        corners[c].y += Number(prism.y(c)[n]) * roots[n];
    }
    try {
      const auto values = Unfolded_diamond::values_of<Number>(corners, Number(1));
      return q.expression(values).is_zero() ? Answer::zero : Answer::not_zero;
    } catch (const std::length_error&) {
      return Answer::open;
    }
  }

  template <std::size_t words>
  static Gmpz integer(const Word_integer<words>& x) {
    Gmpz result;
    mpz_import(result.mpz(), words, -1, sizeof(std::uint64_t), 0, 0,
               x.magnitude().words().data());
    return x.sign() < 0 ? -result : result;
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_PRISM_IN_FIELD_H
