// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SQUARE_ROOT_FIELD_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SQUARE_ROOT_FIELD_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Gmpq.h>
#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Says what exact arithmetic could not decide.
struct Undecidable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The field of the square roots of the areas of input faces, of one surface or
// of several together.
class Square_root_field {
public:
  using Number = Multiquadratic_number;
  // Squared lengths and quadruple area, in the scaled units of the surface.
  using Face = std::pair<std::array<Number, 3>, Number>;

  Square_root_field() = default;
  Square_root_field(const Square_root_field&) = delete;
  Square_root_field& operator=(const Square_root_field&) = delete;

  // \throws std::length_error if there are too many roots
  const Face& face(const Input_metric& m, std::uint32_t f) {
    auto& faces = faces_[&m];
    if (const auto known = faces.find(f); known != faces.end()) return known->second;
    const auto area = basis_.sqrt_of(m.squared_quadruple_area<Gmpq>(f));
    if (!area) throw std::length_error("too many square roots");
    const auto length = [&](unsigned k) { return Number(m.squared_length<Gmpq>(f, k)); };
    return faces.emplace(f, Face{{length(0), length(1), length(2)}, Number(basis_, *area)})
        .first->second;
  }
  // Bounds what products may cost from now on, see
  // `Square_class_basis::limit_products()`.
  void limit_products(std::size_t words) { basis_.limit_products(words); }
  // returns what is left of that
  std::size_t words_left() const { return basis_.words_left(); }

private:
  Square_class_basis basis_;
  std::map<const Input_metric*, std::unordered_map<std::uint32_t, Face>> faces_;
};

// the number times 2^exponent
inline Gmpq scaled_by_power_of_two(const Gmpq& x, int exponent) {
  Gmpq result;
  if (exponent >= 0)
    mpq_mul_2exp(result.mpq(), x.mpq(), static_cast<mp_bitcnt_t>(exponent));
  else
    mpq_div_2exp(result.mpq(), x.mpq(), static_cast<mp_bitcnt_t>(-exponent));
  return result;
}

// Encloses a number, with the current precision.
inline Long_ball enclosure_of(const Gmpq& x) {
  const Mpfr_number center = Mpfr_number::nearest(x);
  return Long_ball::around(center, std::abs(center.magnitude()) * Mpfr_number::rounding());
}
inline Long_ball enclosure_of(const Square_root_field::Number& x) {
  return x.value([](const Gmpq& q) { return enclosure_of(q); });
}

// Calls a function in more and more bits, until it returns something; nothing
// if it never does.
template <class Function>
auto in_growing_precision(const Function& f) -> decltype(f()) {
  decltype(f()) result = std::nullopt;
  raise_precision(256, 4096, [&](unsigned bits) {
    const Mpfr_precision precision(bits);
    result = f();
    return result.has_value();
  });
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SQUARE_ROOT_FIELD_H
