// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_ESCALATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_ESCALATION_H

#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/Zero_answer.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/*!
\file
Steps of the ladder: signs in balls, and what is counted.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// precision at which a value that is probably zero is taken for zero
inline constexpr unsigned maximal_probable_bits = 1024;

// whether a value that may be zero is taken for zero instead of computing it in so many bits
inline bool gives_up(Zero_answer answer, unsigned bits) {
  if (answer == Zero_answer::probably_zero) return bits > maximal_probable_bits;
  if (bits <= Mpfr_number::most_bits) return false;
  throw std::logic_error("a value that was proven not to be zero shows no sign in " +
                         std::to_string(Mpfr_number::most_bits) +
                         " bits; please report this with the mesh");
}

inline Interval_nt<false> interval(const Interval_nt<false>& x) { return x; }
template <class Center>
Interval_nt<false> interval(const Ball<Center>& x) {
  return x.interval();
}

template <class FT>
Interval_nt<false> intervals(const FT& x) {
  return interval(x);
}
template <class FT>
Diamond_values<Interval_nt<false>> intervals(const Diamond_values<FT>& d) {
  return {interval(d.ij), interval(d.jk),     interval(d.ki),    interval(d.im),
          interval(d.mj), interval(d.area_f), interval(d.area_g)};
}

template <class FT>
std::vector<Face_values<Interval_nt<false>>> intervals(const std::vector<Face_values<FT>>& faces) {
  std::vector<Face_values<Interval_nt<false>>> result;
  for (const auto& [l, a] : faces)
    result.push_back({{interval(l[0]), interval(l[1]), interval(l[2])}, interval(a)});
  return result;
}

// The sign if it is certain, which is counted as found with so many bits.
inline std::optional<Sign> counted(const Uncertain<Sign>& s, unsigned bits,
                                   Predicate_statistics& statistics) {
  if (!is_certain(s)) return std::nullopt;
  ++(get_certain(s) == ZERO ? statistics.certified_zero : statistics.escalations[bits]);
  return get_certain(s);
}

// Zero, which is counted as proven.
inline Sign counted_zero(Predicate_statistics& statistics) {
  ++statistics.certified_zero;
  return ZERO;
}

/*
Returns the sign of an expression in values that `values()` computes in balls with so many bits, if it is certain, and whether the
value seems to be zero. `better` is set to intervals that contain the values.
*/
template <class Values, class Expression, class Better>
std::pair<std::optional<Sign>, bool> sign_in_balls(unsigned bits, const Values& values,
                                                   const Expression& expression, Better& better,
                                                   Predicate_statistics& statistics) {
  const auto [wide, value] = to_nearest([&] {
    const auto v = values();
    return std::pair(v, expression(v));
  });
  better = intervals(wide);
  return {counted(value.sign(), bits, statistics), value.seems_zero()};
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_ESCALATION_H
