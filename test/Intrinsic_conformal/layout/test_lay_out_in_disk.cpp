// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/angles/flat_angles.h>
#include <CGAL/Intrinsic_conformal/angles/ideal_start.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_in_disk.h>
#include <CGAL/Intrinsic_conformal/metric/hyperbolic_metric.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include "hyperbolic_surfaces.h"
#include "ideal_triangulations.h"
#include "operator_test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

// Layouts of surfaces whose groups are known.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Complex = std::complex<double>;
using Ideal = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_ideal_hyperbolic_traits,
                                          IT::Integer_coordinates>;

Ideal solved(Ideal t) {
  IT::hyperbolic_metric(t, IT::flat_angles(t), IT::parameters::tolerance(1e-13));
  return t;
}

double distance(Complex p, Complex q) {
  return 2 * std::asinh(std::abs(p - q) / std::sqrt((1 - std::norm(p)) * (1 - std::norm(q))));
}

Complex place(const IT::Disk_layout& layout, std::uint32_t v) {
  return {layout.positions(v, 0), layout.positions(v, 1)};
}

void expect_layout(const IT::Surface_to_cut& s, const IT::Disk_layout& layout) {
  EXPECT_LE(layout.largest_side_error, 1e-9);
  EXPECT_LE(layout.pairings.largest_seam_error, 1e-9);
  EXPECT_LE(layout.pairings.largest_relation_error, 1e-9);
  EXPECT_EQ(layout.flipped_faces, 0U);
  const std::vector<std::uint32_t>& origin = layout.surface.gluing.origin;
  double radius = 0;
  for (std::uint32_t h = 0; h < s.length.size(); ++h) {
    const Complex p = place(layout, origin[h]), q = place(layout, origin[IT::Gluing::next(h)]);
    EXPECT_NEAR(distance(p, q), s.length[h], 1e-8);
    radius = std::max(radius, distance(p, 0));
  }
  EXPECT_NEAR(layout.radius, radius, 1e-9);
  for (const IT::Disk_seam& seam : layout.pairings.seams) {
    EXPECT_NEAR(std::norm(seam.motion.a) - std::norm(seam.motion.b), 1, 1e-9);
    for (std::size_t i = 0; i < seam.sides.size(); ++i)
      EXPECT_LT(std::abs(seam.motion(place(layout, origin[seam.sides[i]])) -
                         place(layout, origin[IT::Gluing::next(seam.partners[i])])),
                1e-9);
  }
}

// The shortest closed geodesic of Bolza's surface has length 2 arcosh(1 + sqrt(2)): that is how far
// motions of the group move at least. One of the pairs of sides is that near.
TEST(LayOutInDisk, hasTheGroupOfBolzasSurface) {
  for (const std::size_t flips : {0U, 30U}) {
    Ideal t(gallery::input(hyperbolic::bolza()));
    ideal::flip_at_random(t, flips, 2);
    t = solved(std::move(t));
    const IT::Surface_to_cut s = IT::hyperbolic_surface(t);
    const IT::Disk_layout layout = IT::lay_out_in_disk(s);
    expect_layout(s, layout);
    double least = 100;
    for (const IT::Disk_seam& seam : layout.pairings.seams)
      least = std::min(least, std::abs(seam.motion.a.real()));
    EXPECT_NEAR(least, 1 + std::numbers::sqrt2, 1e-8);
    EXPECT_GE(layout.pairings.seams.size(), 4U);
    EXPECT_LE(layout.pairings.seams.size(), 9U); // edges of a graph with nodes of degree 3
  }
}

TEST(LayOutInDisk, laysKleinsQuarticOut) {
  const Ideal t = solved(Ideal(gallery::input(hyperbolic::klein_quartic())));
  const IT::Surface_to_cut s = IT::hyperbolic_surface(t);
  for (const std::size_t centers : {1U, 8U}) {
    const IT::Disk_layout layout = IT::lay_out_in_disk(s, {}, centers);
    expect_layout(s, layout);
    EXPECT_LE(layout.pairings.seams.size(), 15U);
  }
}

TEST(LayOutInDisk, turnsAboutCones) {
  const IT::Gluing g = gallery::tetrahedron().gluing;
  const double a = std::numbers::pi / 6, l = hyperbolic::side(a, a, a);
  const IT::Surface_to_cut s{g, std::vector<double>(12, l), {}};
  const IT::Disk_layout layout = IT::lay_out_in_disk(s, std::array{0U, 1U, 2U, 3U});
  expect_layout(s, layout);
  EXPECT_EQ(layout.pairings.seams.size(), 3U);
  std::size_t quarters = 0; // those of the leaves of the tree that is cut
  for (const IT::Disk_seam& seam : layout.pairings.seams)
    if (std::abs(std::abs(seam.motion.a.real()) - std::cos(std::numbers::pi / 4)) < 1e-12)
      ++quarters;
  EXPECT_GE(quarters, 2U);
}

TEST(LayOutInDisk, refusesWhatIsNoTriangleOrNotOriented) {
  IT::Surface_to_cut s{gallery::octagon_of_genus_2().gluing, {}, {}};
  s.length.assign(s.gluing.glue.size(), 1);
  s.length[1] = 3;
  EXPECT_THROW(IT::lay_out_in_disk(s), IT::Invalid_input);
  s.length[1] = 0;
  EXPECT_THROW(IT::lay_out_in_disk(s), IT::Invalid_input);
  s = {gallery::klein_bottle().gluing, {}, {}};
  s.length.assign(s.gluing.glue.size(), 1);
  EXPECT_THROW(IT::lay_out_in_disk(s), IT::Invalid_input);
}

TEST(LayOutInDisk, knowsHowPointsTurn) {
  EXPECT_EQ(IT::orientation_in_disk({0.125, 0.25}, {-0.25, -0.5}, {0.0625, 0.125}), 0);
  // the geodesic through two points is nearer to the centre than Euclid's line
  EXPECT_EQ(IT::orientation_in_disk({0.8, 0.5}, {0.8, -0.5}, 0.6), 1);
  EXPECT_EQ(IT::orientation_in_disk({0.8, 0.5}, {0.8, -0.5}, 0.5), -1);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> d(-0.7, 0.7);
  const auto klein = [](Complex z) { return 2. * z / (1 + std::norm(z)); };
  for (int n = 0; n < 1000; ++n) {
    const Complex p(d(random), d(random)), q(d(random), d(random)), r(d(random), d(random));
    const double area = std::imag(std::conj(klein(q) - klein(p)) * (klein(r) - klein(p)));
    if (std::abs(area) < 1e-12) continue;
    EXPECT_EQ(IT::orientation_in_disk(p, q, r), area > 0 ? 1 : -1);
    EXPECT_EQ(IT::orientation_in_disk(q, p, r), area > 0 ? -1 : 1);
    EXPECT_EQ(IT::orientation_in_disk(p, q, p), 0);
  }
}

} // namespace
