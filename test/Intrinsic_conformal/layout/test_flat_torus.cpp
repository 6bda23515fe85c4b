// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/flat_torus.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include "flat_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>

// Periods of tori that are known.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using flat::Complex;

// Steps of the coordinates across seams are integers, and each face has its area in them.
void expect_lattice(const flat::Surface& s, const IT::Flat_torus& torus) {
  const IT::Gluing& g = torus.layout.surface.gluing;
  const auto at = [&](std::uint32_t h) -> Eigen::RowVector2d {
    return torus.coordinates.row(g.origin[h]);
  };
  double area = 0;
  for (std::uint32_t h = 0; h < s.length.size(); ++h) {
    const std::uint32_t p = s.gluing.glue[h];
    const Eigen::RowVector2d from = at(h) - at(IT::Gluing::next(p)),
                             to = at(IT::Gluing::next(h)) - at(p);
    for (int c = 0; c < 2; ++c) {
      EXPECT_NEAR(from[c], std::round(from[c]), 1e-14);
      EXPECT_NEAR(from[c], to[c], 1e-14);
    }
    if (h % 3 != 0) continue;
    const Eigen::RowVector2d a = at(h + 1) - at(h), b = at(h + 2) - at(h);
    EXPECT_GT(a[0] * b[1] - a[1] * b[0], 0);
    area += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  EXPECT_NEAR(area, 1, 1e-10);
}

TEST(FlatTorus, findsThePeriodWhateverTheTriangulation) {
  const Complex hexagonal = std::polar(1., std::numbers::pi / 3);
  struct Case {
    Complex a, b, period;
  };
  const Case cases[] = {
      {1, {0, 1}, {0, 1}},
      {1, {0, 3}, {0, 3}},
      {{0, 3}, -1, {0, 3}},
      {2., 2. * hexagonal, hexagonal},
      {1, hexagonal * hexagonal, hexagonal},
      {1, {0.3, 1.2}, {0.3, 1.2}},
      {1, {-0.3, 1.2}, {-0.3, 1.2}},
      {1, {-0.5, 1.2}, {0.5, 1.2}},
      {std::polar(1., 0.7), std::polar(1., 0.7) * Complex(4.3, 1.2), {0.3, 1.2}},
      {{3, 0.2}, Complex(3, 0.2) * 2. + Complex(0.1, 1.1), 0.}, // by the reduction below
  };
  for (std::size_t i = 0; i < std::size(cases); ++i)
    for (unsigned seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE("case " + std::to_string(i) + " seed " + std::to_string(seed));
      std::mt19937 random(seed);
      const Case& c = cases[i];
      flat::Surface s = flat::Surface::torus(c.a, c.b, 1 + seed);
      s.mix(random, 60, 600);
      const IT::Flat_torus torus = IT::flat_torus(s);
      expect_lattice(s, torus);
      const Complex shorter = Complex(0.1, 1.1);
      const Complex expected =
          c.period != 0. ? c.period
                         : (c.a - std::round(std::real(c.a / shorter)) * shorter) / shorter;
      const bool is_turned = std::imag(expected) < 0;
      EXPECT_NEAR(std::abs(torus.period - (is_turned ? -expected : expected)), 0, 1e-10);
      EXPECT_NEAR(std::imag(torus.translations[0]), 0, 1e-12);
      EXPECT_GT(std::real(torus.translations[0]), 0);
      EXPECT_LE(std::abs(std::real(torus.period)), 0.5 + 1e-9);
      EXPECT_GE(std::abs(torus.period), 1 - 1e-9);
    }
}

TEST(FlatTorus, refusesSurfacesThatAreNoFlatTori) {
  EXPECT_THROW(IT::flat_torus(flat::cube()), IT::Invalid_input);
  flat::Surface open({{0, 1, 2}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_THROW(IT::flat_torus(open), IT::Invalid_input);
  flat::Surface bent = flat::Surface::torus(1, Complex(0, 1), 4);
  bent.length[0] *= 1.1;
  bent.length[bent.gluing.glue[0]] *= 1.1;
  EXPECT_THROW(IT::flat_torus(bent), IT::Invalid_input);
}

} // namespace
