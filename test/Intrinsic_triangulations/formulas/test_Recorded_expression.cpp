// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

double changing_bound = 0;

TEST(Recorded_expression, is_recorded_anew_if_what_it_reads_may_have_changed) {
  const auto e = [](const auto& d) { return d.ij - changing_bound; }; // an empty type
  const IT::Diamond_values<double> d{1.5, 1, 1, 1, 1, 1, 1};
  for (const double bound : {1., 2., -4.}) {
    changing_bound = bound;
    EXPECT_EQ(IT::recorded(e)(d), 1.5 - bound);
  }
}

/// A number, of which as many are counted as are alive but for those made by default.
class Counted_number {
public:
  Counted_number() = default;
  Counted_number(double x) : value_(std::make_shared<const Value>(x)) {} // NOLINT

  friend Counted_number operator+(const Counted_number& a, const Counted_number& b) {
    return a.value() + b.value();
  }
  friend Counted_number operator-(const Counted_number& a, const Counted_number& b) {
    return a.value() - b.value();
  }
  friend Counted_number operator-(const Counted_number& a) { return -a.value(); }
  friend Counted_number operator*(const Counted_number& a, const Counted_number& b) {
    return a.value() * b.value();
  }
  friend Counted_number operator/(const Counted_number& a, const Counted_number& b) {
    return a.value() / b.value();
  }
  double value() const { return value_->x; }

  static inline int alive = 0, most = 0;

private:
  struct Value {
    explicit Value(double x_) : x(x_) { most = std::max(most, ++alive); }
    ~Value() { --alive; }
    Value(const Value&) = delete;
    Value& operator=(const Value&) = delete;
    double x;
  };
  std::shared_ptr<const Value> value_;
};

TEST(Recorded_expression, keeps_results_of_many_steps_no_longer_than_they_are_used) {
  constexpr std::size_t number_of_faces = 100;
  std::vector<IT::Face_values<double>> faces;
  std::vector<IT::Face_values<Counted_number>> counted;
  for (std::size_t k = 0; k < number_of_faces; ++k) {
    const double x = 1 + static_cast<double>(k % 7) / 8;
    faces.push_back({{1, x, 1}, 1 / x});
    counted.push_back({{1., x, 1.}, 1 / x});
  }
  const std::vector<double> scales(number_of_faces, 0.5);
  const IT::Wedge_sine_expression e{scales};
  const int before = Counted_number::most = Counted_number::alive;
  const double result = IT::Recorded_face_expression(e, number_of_faces)(counted).value();
  EXPECT_EQ(result, e(std::span<const IT::Face_values<double>>(faces)));
  EXPECT_NE(result, 0);
  EXPECT_LT(Counted_number::most - before, 20);
}

// each value is used again at the end: none may be given up before
TEST(Recorded_expression, keeps_results_that_are_used_again) {
  const auto e = [](const auto& d) {
    std::vector powers{d.ij, d.ij * d.ij};
    while (powers.size() < 40) powers.push_back(powers.back() * d.jk);
    auto sum = powers.back() * powers.back();
    for (const auto& p : powers) sum = sum + p;
    return sum;
  };
  const IT::Diamond_values<double> d{1.5, 1.25, 1, 1, 1, 1, 1};
  EXPECT_EQ(IT::recorded(e)(d), e(d));
}

TEST(Recorded_expression, has_the_degree_of_what_it_negates) {
  const auto e = [](const auto& d) { return -d.ij * d.area_f - -(d.jk * d.area_g); };
  const auto expected = [](const auto& d) { return d.jk * d.area_g - d.ij * d.area_f; };
  const IT::Diamond_values<double> d{1.5, 1.25, 1, 1, 1, 3, 7};
  EXPECT_EQ(IT::recorded(e)(d), expected(d));
  const auto degree = IT::recorded(e).degree();
  ASSERT_TRUE(degree);
  EXPECT_EQ(degree->total, 2U);
  EXPECT_EQ(degree->areas, 1U);
  EXPECT_EQ(degree->terms, 2);
  EXPECT_TRUE(degree->is_linear_in_areas());
}

TEST(Recorded_expression, has_no_static_numbers) {
  EXPECT_THROW(IT::Recorded_number(), std::logic_error);
}

} // namespace
