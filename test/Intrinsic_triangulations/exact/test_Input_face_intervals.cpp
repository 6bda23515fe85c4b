// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using CGAL::Gmpq;
using Short = IT::Ball<IT::Double_double>;
using Long = IT::Ball<IT::Mpfr_number>;

// slivers, and points so far from each other that their differences are no doubles
IT::Input_metric of_random_points(std::size_t n) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> in(-1, 1);
  meshes::Mesh m;
  for (std::size_t i = 0; i < n; ++i) {
    const auto v = static_cast<std::uint32_t>(m.points.size());
    const double x = in(random), y = in(random), z = in(random),
                 size = std::ldexp(1., -(int)(i % 30));
    m.points.push_back({x, y, z});
    m.points.push_back({x + size, y + size * in(random), z + size * in(random)});
    if (i % 3 == 0)
      m.points.push_back({in(random), in(random)*1e-9, in(random)});
    else
      m.points.push_back({x + 2 * size, y + 1e-3 * size, z});
    m.triangles.push_back({v, v + 1, v + 2});
  }
  return IT::Input_metric::from_points(m.map(), m.points, 0);
}

template <class Center>
void expect_contains(const IT::Ball<Center>& ball, const Gmpq& exact, double precision) {
  const CGAL::Interval_nt<false> i = [&ball] {
    const CGAL::Protect_FPU_rounding<true> upwards;
    return ball.interval();
  }();
  EXPECT_LE(Gmpq(i.inf()), exact);
  EXPECT_GE(Gmpq(i.sup()), exact);
  EXPECT_LE(ball.radius(), precision * std::abs(ball.to_double()));
  // of more digits than an interval has
  const Gmpq rest = exact - Gmpq(ball.to_double());
  const IT::Ball<Center> remainder = ball - IT::Ball<Center>(ball.to_double());
  EXPECT_LE(CGAL::abs(rest - Gmpq(remainder.to_double())),
            Gmpq(static_cast<double>(remainder.radius())) + CGAL::abs(rest) * Gmpq(0x1p-51));
}

TEST(Input_side_values, are_right_to_all_their_digits) {
  const IT::Input_metric m = of_random_points(600);
  const IT::Input_side_values<Short> values(m);
  const IT::Input_side_values<Long> long_values(m);
  for (std::uint32_t f = 0; f < m.number_of_faces(); ++f) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Gmpq exact = m.squared_length<Gmpq>(f, k);
      expect_contains(values.squared_length({f, k}), exact, 0x1p-95);
      expect_contains(long_values.squared_length({f, k}), exact, 0x1p-200);
    }
    expect_contains(values.squared_quadruple_area(f), m.squared_quadruple_area<Gmpq>(f), 0x1p-60);
  }
}

} // namespace
