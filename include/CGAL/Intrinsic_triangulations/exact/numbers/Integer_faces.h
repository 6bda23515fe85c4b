// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_INTEGER_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_INTEGER_FACES_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

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
  Gmpz area_factor;                    ///< r of the quadruple area 4^-e r sqrt(n)
  Gmpz radicand;                       ///< n; faces of parallel planes have the same one
  std::array<Gmpz, 3>
      normal; ///< the shortest integer vector that is normal to the face, if embedded
  /// squared lengths of shorter integer vectors along the sides, if embedded; often the shortest
  std::array<Gmpz, 3> reduced_lengths;
  long exponent = 0; ///< e
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
    return faces_.emplace(f, input.is_in_space(f) ? from_points(input, f) : from_lengths(input, f))
        .first->second;
  }

  /// returns the number of faces that are remembered.
  std::size_t size() const { return faces_.size(); }

  /// tells whether two faces in space, glued along a side, lie flat: in one plane, not folded over.
  static bool are_flat(const Integer_face& f, const Integer_face& g) {
    return f.normal == g.normal && f.area_factor.sign() != ZERO && g.area_factor.sign() != ZERO;
  }

private:
  __extension__ using Wide = __int128;
  template <class Integer>
  using Vector = std::array<Integer, 3>;

  static Integer_face from_points(const Input_metric& input, std::uint32_t f) {
    long e = std::numeric_limits<long>::min();
    double size = 0;
    for (const std::uint32_t v : input.sides(f))
      for (const double x : input.points()[v]) {
        e = std::max(e, exponent(x));
        size = std::max(size, std::fabs(x));
      }
    if (e == std::numeric_limits<long>::min()) e = 0;
    // differences are below 2^62, sums of three products of two of them below 2^126
    if (e < 1000 && std::ldexp(size, static_cast<int>(e)) < 0x1p61)
      return from_points<Wide>(input, f, e);
    return from_points<Gmpz>(input, f, e);
  }

  template <class Integer>
  static Integer_face from_points(const Input_metric& input, std::uint32_t f, long e) {
    Integer_face face;
    face.exponent = e;
    std::array<Vector<Integer>, 3> p, side;
    for (unsigned k = 0; k < 3; ++k)
      for (unsigned i = 0; i < 3; ++i) set(p[k][i], input.points()[input.sides(f)[k]][i], e);
    for (unsigned k = 0; k < 3; ++k) {
      for (unsigned i = 0; i < 3; ++i) side[k][i] = p[(k + 1) % 3][i] - p[k][i];
      set(face.squared_lengths[k],
          side[k][0] * side[k][0] + side[k][1] * side[k][1] + side[k][2] * side[k][2]);
      face.reduced_lengths[k] = reduced_length(side[k], face.squared_lengths[k]);
    }
    for (unsigned i = 0; i < 3; ++i)
      set(face.normal[i], side[0][(i + 1) % 3] * side[1][(i + 2) % 3] -
                              side[0][(i + 2) % 3] * side[1][(i + 1) % 3]);
    find_area(face);
    return face;
  }

  // from the cross product of two sides, which becomes the shortest normal
  static void find_area(Integer_face& face) {
    Gmpz gcd;
    for (const Gmpz& x : face.normal)
      if (x.sign() != ZERO) mpz_gcd(gcd.mpz(), gcd.mpz(), x.mpz());
    if (gcd.sign() == ZERO) {
      face.radicand = Gmpz(1);
      return;
    }
    if (gcd != Gmpz(1))
      for (Gmpz& x : face.normal) mpz_divexact(x.mpz(), x.mpz(), gcd.mpz());
    face.radicand = squared_norm(face.normal);
    mpz_mul_2exp(face.area_factor.mpz(), gcd.mpz(), 1);
  }

  // squared length of a side over the square of a common divisor of its coordinates, namely the
  // absolute value of all that are not zero, or else a power of two: a sum of three squares is a
  // multiple of four only if all are
  template <class Integer>
  static Gmpz reduced_length(const Vector<Integer>& v, const Gmpz& squared_length) {
    Integer size(0);
    long count = 0;
    bool is_same = true;
    for (const Integer& x : v) {
      if (x == 0) continue;
      const Integer y = x < 0 ? Integer(-x) : x;
      is_same = is_same && (count == 0 || y == size);
      size = y;
      ++count;
    }
    if (is_same) return Gmpz(count);
    Gmpz result;
    const mp_bitcnt_t twos = mpz_scan1(squared_length.mpz(), 0) / 2;
    mpz_fdiv_q_2exp(result.mpz(), squared_length.mpz(), 2 * twos);
    return result;
  }

  // L_k = |p - q|^2 + delta + excess, or given
  static Integer_face from_lengths(const Input_metric& input, std::uint32_t f) {
    Integer_face face;
    if (input.is_embedded())
      face = from_points(input, f);
    else
      for (const std::uint32_t e : input.sides(f))
        face.exponent = std::max(face.exponent, half(exponent(input.squared_lengths()[e])));
    long e = std::max(face.exponent, half(exponent(input.delta())));
    for (unsigned k = 0; k < 3; ++k) e = std::max(e, half(exponent(input.excess(f, k))));
    for (unsigned k = 0; k < 3; ++k) {
      Gmpz& l = face.squared_lengths[k];
      if (input.is_embedded())
        mpz_mul_2exp(l.mpz(), l.mpz(), static_cast<mp_bitcnt_t>(2 * (e - face.exponent)));
      else
        l = integer(input.squared_lengths()[input.sides(f)[k]], 2 * e);
      l = l + integer(input.delta(), 2 * e) + integer(input.excess(f, k), 2 * e);
    }
    face.exponent = e;
    const auto& [a, b, c] = face.squared_lengths;
    const Gmpz p = a + c - b;
    // D = r^2 n; its square root is r sqrt(n)
    face.radicand = Gmpz(4) * a * c - p * p;
    face.area_factor = Square_class_basis::extract_square(face.radicand);
    return face;
  }

  static Gmpz squared_norm(const std::array<Gmpz, 3>& v) {
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  }

  static void set(Gmpz& result, const Gmpz& x) { result = x; }
  static void set(Gmpz& result, double x, long exponent) { result = integer(x, exponent); }
  static void set(Wide& result, double x, long exponent) {
    result = static_cast<std::int64_t>(std::ldexp(x, static_cast<int>(exponent)));
  }
  static void set(Gmpz& result, Wide x) {
    __extension__ using Natural = unsigned __int128;
    const Natural n = x < 0 ? -static_cast<Natural>(x) : static_cast<Natural>(x);
    const std::array<std::uint64_t, 2> words{static_cast<std::uint64_t>(n),
                                             static_cast<std::uint64_t>(n >> 64)};
    mpz_import(result.mpz(), 2, -1, sizeof(std::uint64_t), 0, 0, words.data());
    if (x < 0) mpz_neg(result.mpz(), result.mpz());
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_INTEGER_FACES_H
