// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_DIAMOND_SIGN_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_DIAMOND_SIGN_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/exact/input_diamond_sign.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Binary_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Word_integer.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/integer_diamond_sign.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/enum.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The four corners i, j, k, m of a diamond of input faces.
class Corners {
public:
  Corners(const Input_metric& input, const Input_diamond& d)
      : delta_(input.delta()) {
    const auto& [left, right] = d;
    const Input_metric::Sides &f = input.sides(left.face), &g = input.sides(right.face);
    const std::uint32_t corner[4] = {f[left.slot], f[(left.slot + 1) % 3], f[(left.slot + 2) % 3],
                                     g[(right.slot + 2) % 3]};
    for (const std::uint32_t v : corner)
      for (const double x : input.points()[v]) {
        coordinates_.emplace_back(x);
        range_.include(coordinates_.back());
      }
    include_square(delta_);
    const unsigned l = left.slot, r = right.slot;
    for (const double x :
         {input.excess(left.face, l), input.excess(left.face, (l + 1) % 3),
          input.excess(left.face, (l + 2) % 3), input.excess(right.face, (r + 1) % 3),
          input.excess(right.face, (r + 2) % 3)}) {
      excess_.emplace_back(x);
      include_square(excess_.back());
    }
  }

  int width() const { return range_.width(); }

  template <class Length>
  Diamond_values<Length> lengths() const {
    Length p[4][3];
    for (unsigned c = 0; c < 12; ++c)
      p[c / 3][c % 3] = coordinates_[c].template scaled<Length>(range_.lowest);
    const Length delta = delta_.scaled<Length>(2 * range_.lowest);
    const auto length = [&](int a, int b, std::size_t side) {
      const Length x = p[a][0] - p[b][0], y = p[a][1] - p[b][1], z = p[a][2] - p[b][2];
      return x * x + y * y + z * z + delta + excess_[side].scaled<Length>(2 * range_.lowest);
    };
    return {
        length(0, 1, 0), length(1, 2, 1), length(2, 0, 2), length(0, 3, 3), length(3, 1, 4), 0, 0};
  }

private:
  void include_square(const Binary_double& x) {
    if (x.mantissa == 0) return;
    range_.lowest = std::min(range_.lowest, (x.exponent - 1) / 2 - 1);
    range_.highest = std::max(range_.highest, (x.exponent + 53) / 2 + 1);
  }

  boost::container::static_vector<Binary_double, 12> coordinates_;
  Binary_double delta_;
  boost::container::static_vector<Binary_double, 5> excess_; // ij, jk, ki, im, mj
  Bit_range range_;
};

// The five sides of a diamond of input faces with given squared lengths.
class Side_lengths {
public:
  Side_lengths(const Input_metric& input, const Input_diamond& d)
      : delta_(input.delta()) {
    const auto& [left, right] = d;
    const Input_metric::Sides &f = input.sides(left.face), &g = input.sides(right.face);
    for (const std::uint32_t e : {f[left.slot], f[(left.slot + 1) % 3], f[(left.slot + 2) % 3],
                                  g[(right.slot + 1) % 3], g[(right.slot + 2) % 3]}) {
      lengths_.emplace_back(input.squared_lengths()[e]);
      range_.include(lengths_.back());
    }
    range_.include(delta_);
  }

  // half the bits, as for coordinates
  int width() const { return (range_.width() + 1) / 2; }

  template <class Length>
  Diamond_values<Length> lengths() const {
    const auto length = [&](std::size_t i) {
      return lengths_[i].template scaled<Length>(range_.lowest) +
             delta_.scaled<Length>(range_.lowest);
    };
    return {length(0), length(1), length(2), length(3), length(4), 0, 0};
  }

private:
  boost::container::static_vector<Binary_double, 5> lengths_;
  Binary_double delta_;
  Bit_range range_;
};

// Coordinates of w bits have squared lengths below 2^(2w + 4), and 2w + 4 <= b - 6 for b bits.
template <class Source>
std::optional<Sign> integer_diamond_sign(const Source& source,
                                         const Recorded_diamond_expression& expression) {
  if (source.width() <= 58)
    return integer_diamond_sign(source.template lengths<Word_integer<2>>(), expression);
  if (source.width() <= 122)
    return integer_diamond_sign(source.template lengths<Word_integer<4>>(), expression);
  return {};
}

} // namespace internal

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::optional<Sign> input_diamond_sign(const Input_metric& input, const Input_diamond& diamond,
                                       const Recorded_diamond_expression& expression) {
  if (!expression.is_linear_in_areas()) return std::nullopt;
  if (input.is_embedded())
    return internal::integer_diamond_sign(internal::Corners(input, diamond), expression);
  return internal::integer_diamond_sign(internal::Side_lengths(input, diamond), expression);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_DIAMOND_SIGN_IMPL_H
