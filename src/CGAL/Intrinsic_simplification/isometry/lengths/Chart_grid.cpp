// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/lengths/Chart_grid.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_number.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>
#include <CGAL/number_utils.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

constexpr std::int64_t most_scale = std::int64_t{1} << 24;
constexpr std::int64_t most_coordinate = std::int64_t{1} << 30; // differences have 32 bits
constexpr std::size_t form_bits = 62;

// The denominator, or 0 if it is too large for a scale.
std::int64_t small_denominator(const Gmpq& x) {
  const mpz_srcptr d = mpq_denref(x.mpq());
  return mpz_cmp_ui(d, static_cast<unsigned long>(most_scale)) <= 0 ? mpz_get_si(d) : 0;
}

std::optional<std::int32_t> coordinate(const Gmpq& x, std::int64_t scale) {
  const std::int64_t d = small_denominator(x);
  const mpz_srcptr n = mpq_numref(x.mpq());
  if (d == 0 || scale % d != 0 || mpz_cmpabs_ui(n, static_cast<unsigned long>(most_coordinate)) > 0)
    return std::nullopt;
  const std::int64_t result = mpz_get_si(n) * (scale / d);
  if (std::abs(result) > most_coordinate) return std::nullopt;
  return static_cast<std::int32_t>(result);
}

} // namespace

// |x e + y f|^2 = x^2 l_e + x y p + y^2 l_f, where p = 2 <e, f> = 2 l_e times the real part of f.
Chart_grid::Chart_grid(const Rational_triangle& first) : corner_(first.corners[2]) {
  const std::array<Gmpq, 3> form{first.lengths[0], 2 * first.lengths[0] * corner_.x,
                                 first.lengths[2]};
  Gmpz common(1), divisor(0);
  for (const Gmpq& x : form) mpz_lcm(common.mpz(), common.mpz(), mpq_denref(x.mpq()));
  std::array<Gmpz, 3> integers;
  for (std::size_t k = 0; k < 3; ++k) {
    integers[k] = (form[k] * Gmpq(common)).numerator();
    mpz_gcd(divisor.mpz(), divisor.mpz(), integers[k].mpz());
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Gmpz x = integers[k] / divisor;
    if (mpz_sizeinbase(x.mpz(), 2) > form_bits) return;
    form_[k] = mpz_get_si(x.mpz());
  }
  scale_ = 1;
}

void Chart_grid::include(const Plane_number& coordinates) {
  for (const Gmpq* x : {&coordinates.x, &coordinates.y}) {
    const std::int64_t d = small_denominator(*x);
    scale_ = d == 0 || scale_ == 0 ? 0 : std::lcm(scale_, d);
    if (scale_ > most_scale) drop();
  }
}

std::optional<Grid_point> Chart_grid::point(const Plane_number& coordinates) const {
  const std::optional<std::int32_t> x = coordinate(coordinates.x, scale_),
                                    y = coordinate(coordinates.y, scale_);
  return x && y ? std::optional(Grid_point{*x, *y}) : std::nullopt;
}

// If differences from the first corner are below 2^b, those of two other corners are below 2^(b+1),
// and with coefficients below 2^w, squared lengths are below 3 2^(2b+2+w), a sum of two of them
// less a third one below 2^(2b+5+w), determinants below 2^(2b+3), and a sum of two products below
// 2^(4b+9+w).
bool Chart_grid::fits(const Grid_diamond& d) const {
  std::uint64_t differences = 0, coefficients = 0;
  const auto add = [](std::uint64_t& to, std::int64_t x) {
    to |= static_cast<std::uint64_t>(std::abs(x));
  };
  for (std::size_t k = 1; k < d.size(); ++k) {
    add(differences, std::int64_t{d[k].x} - d[0].x);
    add(differences, std::int64_t{d[k].y} - d[0].y);
  }
  for (const std::int64_t x : form_) add(coefficients, x);
  return 4 * std::bit_width(differences) + 9 + std::bit_width(coefficients) <= 127;
}

std::optional<Diamond_values<double>> Chart_grid::approximate(const Grid_diamond& d, double unit,
                                                              double area) const {
  if (!fits(d)) return std::nullopt;
  const Diamond_values<Wide> v = values(d);
  const auto scale = static_cast<double>(scale_);
  const double of_length = unit / (static_cast<double>(form_[0]) * scale * scale),
               of_area = 2 * unit * area * CGAL::to_double(corner_.y) / (scale * scale);
  const auto length = [&](Wide x) { return static_cast<double>(x) * of_length; };
  const auto quadruple = [&](Wide x) { return static_cast<double>(x) * of_area; };
  return Diamond_values<double>{length(v.ij), length(v.jk),        length(v.ki),       length(v.im),
                                length(v.mj), quadruple(v.area_f), quadruple(v.area_g)};
}

} // namespace CGAL::Intrinsic_triangulations::internal
