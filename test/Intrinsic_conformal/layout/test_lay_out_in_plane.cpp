// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/lay_out_in_plane.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include "flat_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

// Layouts of flat surfaces in closed form, whose triangulations are random.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using flat::Complex;

Complex place(const IT::Flat_layout& layout, std::uint32_t h) {
  const auto v = static_cast<Eigen::Index>(layout.surface.gluing.origin[h]);
  return {layout.positions(v, 0), layout.positions(v, 1)};
}

// Distances in the plane are lengths, and motions take sides of seams to their partners.
void expect_isometric(const flat::Surface& s, const IT::Flat_layout& layout, double error) {
  IT::validate(layout.surface.gluing);
  const double extent =
      (layout.positions.colwise().maxCoeff() - layout.positions.colwise().minCoeff()).norm();
  for (std::uint32_t h = 0; h < s.length.size(); ++h)
    EXPECT_NEAR(std::abs(place(layout, IT::Gluing::next(h)) - place(layout, h)), s.length[h],
                error * extent);
  std::size_t sides = 0;
  for (const IT::Layout_seam& seam : layout.seams) {
    ASSERT_EQ(seam.sides.size(), seam.partners.size());
    sides += seam.sides.size();
    const Complex turn = std::polar(1., seam.rotation);
    for (std::size_t i = 0; i < seam.sides.size(); ++i) {
      const std::uint32_t h = seam.sides[i], p = seam.partners[i];
      EXPECT_EQ(s.gluing.glue[h], p);
      const Complex moved =
          turn * place(layout, h) + Complex(seam.translation[0], seam.translation[1]);
      EXPECT_LE(std::abs(moved - place(layout, IT::Gluing::next(p))), error * extent);
    }
  }
  EXPECT_EQ(sides, layout.surface.seams.size());
  EXPECT_LE(layout.largest_side_error, 100 * error);
  EXPECT_LE(layout.largest_seam_error, error);
  const IT::Map_certificate certificate = IT::certify_map(layout);
  EXPECT_EQ(certificate.faces, s.number_of_faces());
  EXPECT_TRUE(certificate.is_locally_injective());
}

// Rotations of seams are multiples of an angle.
void expect_rotations(const IT::Flat_layout& layout, double unit) {
  for (const IT::Layout_seam& seam : layout.seams)
    EXPECT_NEAR(std::remainder(seam.rotation, unit), 0, 1e-9);
}

std::vector<flat::Complex> regular_polygon(unsigned n) {
  std::vector<Complex> corners;
  for (unsigned k = 0; k < n; ++k) corners.push_back(std::polar(1., 2 * std::numbers::pi * k / n));
  return corners;
}

TEST(LayOutInPlane, keepsLengthsOfFlatToriAndTranslatesTheirSeams) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    flat::Surface s = flat::Surface::torus(1, Complex(0.3, 0.2 * seed), 2 + seed);
    s.mix(random, 100, 1000);
    ASSERT_TRUE(s.cones().empty());
    const IT::Flat_layout layout = IT::lay_out_in_plane(s);
    expect_isometric(s, layout, 1e-10);
    for (const IT::Layout_seam& seam : layout.seams) EXPECT_NEAR(seam.rotation, 0, 1e-10);
    EXPECT_TRUE(layout.seams.size() == 2 || layout.seams.size() == 3);
    EXPECT_TRUE(IT::certify_map(layout).is_injective()); // a fundamental domain
  }
}

TEST(LayOutInPlane, turnsSeamsOfPolyhedraByMultiplesOfTheirAngles) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    flat::Surface cube = flat::cube(), tetrahedron = flat::tetrahedron();
    cube.mix(random, 100, 1000);
    tetrahedron.mix(random, 100, 1000);
    const std::vector<std::uint32_t> of_cube = cube.cones(), of_tetrahedron = tetrahedron.cones();
    ASSERT_EQ(of_cube.size(), 8U);
    ASSERT_EQ(of_tetrahedron.size(), 4U);
    const IT::Flat_layout net = IT::lay_out_in_plane(cube, of_cube);
    expect_isometric(cube, net, 1e-10);
    expect_rotations(net, std::numbers::pi / 2);
    const IT::Flat_layout other = IT::lay_out_in_plane(tetrahedron, of_tetrahedron);
    expect_isometric(tetrahedron, other, 1e-10);
    expect_rotations(other, std::numbers::pi);
  }
}

TEST(LayOutInPlane, laysDoubledPolygonsOut) {
  for (const unsigned n : {3U, 4U, 5U, 12U}) {
    SCOPED_TRACE("corners " + std::to_string(n));
    std::mt19937 random(n);
    flat::Surface s = flat::Surface::doubled_polygon(regular_polygon(n));
    s.mix(random, 60, 600);
    const std::vector<std::uint32_t> cones = s.cones();
    ASSERT_EQ(cones.size(), n);
    const IT::Flat_layout layout = IT::lay_out_in_plane(s, cones);
    expect_isometric(s, layout, 1e-10);
    // multiples of the curvature 4 pi / n, up to full turns
    expect_rotations(layout, (n % 2 == 0 ? 4 : 2) * std::numbers::pi / n);
  }
}

TEST(LayOutInPlane, spreadsRoundingOverManyTriangles) {
  std::mt19937 random(7);
  flat::Surface s = flat::Surface::torus(1, Complex(0, 1), 60);
  s.mix(random, 0, 20000);
  const IT::Flat_layout layout = IT::lay_out_in_plane(s);
  expect_isometric(s, layout, 1e-11);
}

// Rings of triangles about a point, each half as large as the one around it.
TEST(LayOutInPlane, keepsTheShapeOfTrianglesThatAreMuchSmallerThanOthers) {
  constexpr std::uint32_t rings = 80, n = 6;
  std::vector<std::array<double, 3>> points;
  for (std::uint32_t r = 0; r < rings; ++r)
    for (std::uint32_t k = 0; k < n; ++k) {
      const Complex z = std::polar(std::ldexp(1., -int(r)), 2 * std::numbers::pi * k / n);
      points.push_back({z.real(), z.imag(), 0});
    }
  points.push_back({0, 0, 0});
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t r = 0; r < rings; ++r)
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t a = n * r + k, b = n * r + (k + 1) % n;
      if (r + 1 == rings)
        triangles.push_back({a, b, n * rings});
      else
        for (const auto& t : {std::array{a, b, b + n}, std::array{a, b + n, a + n}})
          triangles.push_back(t);
    }
  const flat::Surface s(triangles, points);
  const IT::Flat_layout layout = IT::lay_out_in_plane(s);
  EXPECT_LT(layout.largest_side_error, 1e-13);
  EXPECT_TRUE(IT::certify_map(layout).is_injective());
}

// Lengths are taken as they are: their squares as doubles have another triangle, or none.
TEST(LayOutInPlane, keepsTheHeightsOfTrianglesThatAreNearlySegments) {
  flat::Surface s({{0, 1, 2}}, {{0, 0, 0}, {1, 0, 0}, {0.5, 0.5, 0}});
  for (const int digits : {30, 45, 52}) {
    const double more = std::ldexp(1., -digits);
    s.length = {1, (1 + more) / 2, (1 + more) / 2};
    const IT::Flat_layout layout = IT::lay_out_in_plane(s);
    const Complex a = place(layout, 1) - place(layout, 0), b = place(layout, 2) - place(layout, 0);
    const double height = std::sqrt(more * (2 + more)) / 2;
    EXPECT_NEAR(std::imag(std::conj(a) * b) / std::abs(a), height, 1e-14 * height);
  }
}

TEST(LayOutInPlane, reportsCurvatureThatIsNotAtCones) {
  flat::Surface cube = flat::cube();
  std::vector<std::uint32_t> cones = cube.cones();
  cones.pop_back();
  EXPECT_GT(IT::lay_out_in_plane(cube, cones).largest_side_error, 0.01);
}

TEST(LayOutInPlane, namesFacesThatAreNoTriangles) {
  flat::Surface s = flat::cube();
  s.length[6] = 10;
  try {
    IT::lay_out_in_plane(s, s.cones());
    FAIL();
  } catch (const IT::Invalid_input& e) {
    EXPECT_EQ(e.kind(), IT::Element_kind::face);
    EXPECT_EQ(e.index(), 2U);
  }
}

} // namespace
