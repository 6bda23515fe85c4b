// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MULTIQUADRATIC_TERMS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MULTIQUADRATIC_TERMS_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>

#include <CGAL/Gmpz.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <bit>
#include <tuple>
#include <utility>

/*!
\file
Arithmetic in the ring Z[sqrt(d_0), sqrt(d_1), ...] of a `Square_class_basis`, on which
`Multiquadratic_number` stands.

An element is a vector of terms value * sqrt(d_radical), sorted by radical, no value zero, so that
zero is the empty vector and equality that of vectors. Multiplication and inversion split at the
highest generator g that occurs, x = a + b sqrt(d_g), with a and b free of it.
*/

namespace CGAL::Intrinsic_triangulations::internal {

struct Multiquadratic_term {
  Square_class_basis::Mask radical;
  Gmpz value;
};

// one representative suffices for nearly all values: two terms
using Multiquadratic_terms = boost::container::small_vector<Multiquadratic_term, 2>;

// a + b, or a - b
inline Multiquadratic_terms sum(const Multiquadratic_terms& a, const Multiquadratic_terms& b,
                                bool subtract = false) {
  Multiquadratic_terms result;
  result.reserve(a.size() + b.size());
  auto i = a.begin(), j = b.begin();
  while (i != a.end() || j != b.end()) {
    if (j == b.end() || (i != a.end() && i->radical < j->radical))
      result.push_back(*i++);
    else if (i == a.end() || j->radical < i->radical) {
      result.push_back({j->radical, subtract ? -j->value : j->value});
      ++j;
    } else {
      Gmpz value = subtract ? i->value - j->value : i->value + j->value;
      if (value.sign() != ZERO) result.push_back({i->radical, value});
      ++i;
      ++j;
    }
  }
  return result;
}

// c a
inline Multiquadratic_terms scaled(const Multiquadratic_terms& a, const Gmpz& c) {
  if (c == 1) return a;
  Multiquadratic_terms result;
  result.reserve(a.size());
  for (const Multiquadratic_term& t : a) result.push_back({t.radical, t.value * c});
  return result;
}

// a times one term
inline Multiquadratic_terms product(const Square_class_basis* basis, const Multiquadratic_terms& a,
                                    const Multiquadratic_term& t) {
  if (t.radical == 0) return scaled(a, t.value);
  Multiquadratic_terms result;
  result.reserve(a.size());
  for (const Multiquadratic_term& s : a) {
    result.push_back({s.radical ^ t.radical, s.value * t.value});
    const Square_class_basis::Mask common = s.radical & t.radical;
    if (common != 0) result.back().value *= basis->product(common);
  }
  std::sort(result.begin(), result.end(),
            [](const auto& x, const auto& y) { return x.radical < y.radical; });
  return result;
}

inline Square_class_basis::Mask highest_generator(const Multiquadratic_terms& x) {
  return x.empty() ? 0 : std::bit_floor(x.back().radical);
}

// writes x = first + second sqrt(d_g), where no generator of x is above g
inline std::pair<Multiquadratic_terms, Multiquadratic_terms> split(const Multiquadratic_terms& x,
                                                                   Square_class_basis::Mask g) {
  const auto middle =
      std::find_if(x.begin(), x.end(), [g](const auto& t) { return (t.radical & g) != 0; });
  std::pair<Multiquadratic_terms, Multiquadratic_terms> result(
      std::piecewise_construct, std::forward_as_tuple(x.begin(), middle),
      std::forward_as_tuple(middle, x.end()));
  for (Multiquadratic_term& t : result.second) t.radical ^= g;
  return result;
}

// low + high sqrt(d_g)
inline Multiquadratic_terms joined(Multiquadratic_terms low, const Multiquadratic_terms& high,
                                   Square_class_basis::Mask g) {
  low.reserve(low.size() + high.size());
  for (const Multiquadratic_term& t : high) low.push_back({t.radical | g, t.value});
  return low;
}

// x y = (a + b s)(c + e s) with s^2 = d_g, by three products (Karatsuba) where that takes fewer pairs of terms than four: where few terms of many
// possible ones are there, sums have as many as their summands together
inline Multiquadratic_terms product(const Square_class_basis* basis, const Multiquadratic_terms& x,
                                    const Multiquadratic_terms& y) {
  if (x.empty() || y.empty()) return {};
  if (x.size() == 1) return product(basis, y, x.front());
  if (y.size() == 1) return product(basis, x, y.front());
  const Square_class_basis::Mask g = std::max(highest_generator(x), highest_generator(y));
  const auto [a, b] = split(x, g);
  const auto [c, e] = split(y, g);
  if (b.empty()) return joined(product(basis, a, c), product(basis, a, e), g);
  if (e.empty()) return joined(product(basis, a, c), product(basis, b, c), g);
  const Multiquadratic_terms ac = product(basis, a, c), be = product(basis, b, e);
  const Multiquadratic_terms low = sum(ac, scaled(be, basis->product(g)));
  if (a.empty()) return joined(low, product(basis, b, c), g);
  if (c.empty()) return joined(low, product(basis, a, e), g);
  const Multiquadratic_terms ab = sum(a, b), ce = sum(c, e);
  if (ab.size() * ce.size() >= a.size() * e.size() + b.size() * c.size())
    return joined(low, sum(product(basis, a, e), product(basis, b, c)), g);
  const Multiquadratic_terms all = product(basis, ab, ce);
  return joined(low, sum(all, sum(ac, be), true), g);
}

/*
returns z and n, not zero, with x z = n.

For x = a + b s, s^2 = d_g, the conjugate a - b s gives the norm a^2 - d_g b^2, which is free of g
and not zero, since changing the sign of s is an automorphism. The products of radicals of two terms
of the norm are products of those of x without g: the number of levels is the dimension over GF(2)
of the products of radicals in x, not the number of generators.
*/
inline std::pair<Multiquadratic_terms, Gmpz> cofactor(const Square_class_basis* basis,
                                                      const Multiquadratic_terms& x) {
  if (x.size() == 1) {
    const Square_class_basis::Mask radical = x.front().radical;
    const Multiquadratic_terms root(1, {radical, Gmpz(1)});
    if (radical == 0) return {root, x.front().value};
    return {root, x.front().value * basis->product(radical)};
  }
  const Square_class_basis::Mask g = highest_generator(x);
  const auto [a, b] = split(x, g);
  if (a.empty()) {
    const auto [z, n] = cofactor(basis, b);
    return {joined({}, z, g), n * basis->product(g)};
  }
  const Multiquadratic_terms norm =
      sum(product(basis, a, a), scaled(product(basis, b, b), basis->product(g)), true);
  const auto [z, n] = cofactor(basis, norm);
  return {joined(product(basis, a, z), scaled(product(basis, b, z), Gmpz(-1)), g), n};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_MULTIQUADRATIC_TERMS_H
