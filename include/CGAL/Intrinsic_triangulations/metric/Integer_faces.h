// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_INTEGER_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_INTEGER_FACES_H

#include <CGAL/Intrinsic_triangulations/metric/Input_metric.h>

#include <CGAL/Gmpz.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds the metric of an input face in integers: doubles are integers over powers of two.

With e = `exponent`, squared lengths are multiplied by 4^e, their products by 16^e.
*/
struct Integer_face {
  std::array<Gmpz, 3> squared_lengths; ///< 4^e L_0, 4^e L_1, 4^e L_2
  Gmpz squared_area;                   ///< 16^e D, D the squared quadruple area
  std::array<Gmpz, 3> normal; ///< 4^e times the cross product of sides 0 and 1, if embedded
  long exponent = 0;          ///< e
};

/*!
\brief converts input faces to integers, and remembers them.
*/
class Integer_faces {
public:
  /// returns the integers of face `f`; the reference stays valid.
  const Integer_face& operator()(const Input_metric& input, std::uint32_t f) {
    const auto found = faces_.find(f);
    if (found != faces_.end()) return found->second;
    return faces_.emplace(f, is_in_space(input) ? from_points(input, f) : from_lengths(input, f))
        .first->second;
  }

  /// returns the number of faces that are remembered.
  std::size_t size() const { return faces_.size(); }

  /// tells whether the metric is that of triangles in space, without mollification.
  static bool is_in_space(const Input_metric& input) {
    return input.is_embedded() && input.delta() == 0;
  }

  /// tells whether two faces in space, glued along a side, lie flat: in one plane, not folded over.
  static bool are_flat(const Integer_face& f, const Integer_face& g) {
    const std::array<Gmpz, 3>&m = f.normal, &n = g.normal;
    for (unsigned i = 0; i < 3; ++i)
      if (m[i] * n[(i + 1) % 3] != m[(i + 1) % 3] * n[i]) return false;
    for (unsigned i = 0; i < 3; ++i)
      if (m[i].sign() * n[i].sign() != 0) return m[i].sign() == n[i].sign();
    return false;
  }

private:
  static Integer_face from_points(const Input_metric& input, std::uint32_t f) {
    Integer_face face;
    face.exponent = std::numeric_limits<long>::min();
    for (const std::uint32_t v : input.sides(f))
      for (const double x : input.points()[v]) face.exponent = std::max(face.exponent, exponent(x));
    if (face.exponent == std::numeric_limits<long>::min()) face.exponent = 0;
    std::array<std::array<Gmpz, 3>, 3> p, side;
    for (unsigned k = 0; k < 3; ++k)
      for (unsigned i = 0; i < 3; ++i)
        p[k][i] = integer(input.points()[input.sides(f)[k]][i], face.exponent);
    for (unsigned k = 0; k < 3; ++k) {
      for (unsigned i = 0; i < 3; ++i) side[k][i] = p[(k + 1) % 3][i] - p[k][i];
      face.squared_lengths[k] = squared_norm(side[k]);
    }
    for (unsigned i = 0; i < 3; ++i)
      face.normal[i] =
          side[0][(i + 1) % 3] * side[1][(i + 2) % 3] - side[0][(i + 2) % 3] * side[1][(i + 1) % 3];
    face.squared_area = Gmpz(4) * squared_norm(face.normal);
    return face;
  }

  // L_k = |p - q|^2 + delta, or given
  static Integer_face from_lengths(const Input_metric& input, std::uint32_t f) {
    Integer_face face;
    if (input.is_embedded())
      face = from_points(input, f);
    else
      for (const std::uint32_t e : input.sides(f))
        face.exponent = std::max(face.exponent, half(exponent(input.squared_lengths()[e])));
    const long e = std::max(face.exponent, half(exponent(input.delta())));
    for (unsigned k = 0; k < 3; ++k) {
      Gmpz& l = face.squared_lengths[k];
      if (input.is_embedded())
        mpz_mul_2exp(l.mpz(), l.mpz(), static_cast<mp_bitcnt_t>(2 * (e - face.exponent)));
      else
        l = integer(input.squared_lengths()[input.sides(f)[k]], 2 * e);
      l = l + integer(input.delta(), 2 * e);
    }
    face.exponent = e;
    const auto& [a, b, c] = face.squared_lengths;
    const Gmpz p = a + c - b;
    face.squared_area = Gmpz(4) * a * c - p * p;
    return face;
  }

  static Gmpz squared_norm(const std::array<Gmpz, 3>& v) {
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  }

  // x = n 2^e for an integer n below 2^53
  static std::pair<double, long> split(double x) {
    int e = 0;
    const double m = std::frexp(x, &e);
    return {std::ldexp(m, 53), e - 53L};
  }

  // the least e for which 2^e x is an integer
  static long exponent(double x) {
    if (x == 0) return std::numeric_limits<long>::min();
    const auto [n, e] = split(x);
    return -e - std::countr_zero(static_cast<std::uint64_t>(std::fabs(n)));
  }

  // half of e, rounded up
  static long half(long e) { return e > 0 ? (e + 1) / 2 : e / 2; }

  static Gmpz integer(double x, long exponent) {
    if (x == 0) return Gmpz();
    const auto [n, e] = split(x);
    Gmpz result;
    mpz_set_d(result.mpz(), n);
    const long shift = e + exponent;
    if (shift >= 0)
      mpz_mul_2exp(result.mpz(), result.mpz(), static_cast<mp_bitcnt_t>(shift));
    else
      mpz_tdiv_q_2exp(result.mpz(), result.mpz(), static_cast<mp_bitcnt_t>(-shift));
    return result;
  }

  std::unordered_map<std::uint32_t, Integer_face> faces_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_INTEGER_FACES_H
