// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/conformal_map.h>
#include <CGAL/Intrinsic_operators/parametrization/disk_border.h>
#include <CGAL/Intrinsic_operators/parametrization/harmonic_map.h>
#include <CGAL/Intrinsic_operators/parametrization/measure_distortion.h>

#include "delaunay.h"
#include "dense_eigenvalues.h"
#include "meshes.h"
#include "operator_test_meshes.h"
#include "soups.h"

#include <CGAL/Intrinsic_operators/operators/hodge_stars.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace operator_test;
using Map = Eigen::MatrixX2d;

// A convex piece of a sphere: a grid that is projected to it, from z = 1 to below the equator if `steep` is above 1.
Shape sphere_cap(std::uint32_t n, double steep) {
  Shape s = grid(n);
  for (auto& p : s.points) {
    const double x = steep * (2 * p[0] / n - 1), y = steep * (2 * p[1] / n - 1);
    const double r = 1 + x * x + y * y; // inverse stereographic projection
    p = {2 * x / r, 2 * y / r, 2 / r - 1};
  }
  return s;
}

// A half of a cylinder: the grid, bent.
Shape bent_grid(std::uint32_t n) {
  Shape s = rough_grid(n, 0.2, 0, 3);
  for (auto& p : s.points) {
    const double a = 2.5 * p[0] / n, r = n / 2.5;
    p = {r * std::sin(a), p[1], r * std::cos(a)};
  }
  return s;
}

IT::Border_map own_border(const Shape& s, const Exact& t) {
  IT::Border_map border = IT::circular_border(t);
  for (std::size_t i = 0; i < border.rows.size(); ++i)
    border.positions.row(static_cast<Eigen::Index>(i)) = s.point(border.rows[i]).head<2>();
  return border;
}

TEST(Harmonic_map, of_a_flat_disk_with_its_own_border_is_the_identity) {
  const Shape s = rough_grid(9, 0.3, 0, 4);
  for (const Exact& t : {Exact(s.input()), delaunay<Exact>(s.input())}) {
    const Map uv = IT::harmonic_map(t, own_border(s, t));
    for (std::uint32_t v = 0; v < s.points.size(); ++v)
      EXPECT_LE((uv.row(v) - s.point(v).head<2>().transpose()).norm(), 1e-11);
    const IT::Map_distortion d = IT::measure_distortion(t, uv);
    EXPECT_NEAR(d.maximum_quasi_conformal, 1, 1e-4) << "the root of what rounding leaves";
    EXPECT_LE(d.maximum_angle_change, 1e-8);
    EXPECT_NEAR(d.minimum_area_ratio, 1, 1e-8);
    EXPECT_NEAR(d.mean_area_ratio, 1, 1e-8);
  }
}

TEST(Harmonic_map, to_the_circle_is_injective_by_certificate_if_edges_are_Delaunay) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Shape s = rough_grid(10, 0.35, seed % 2 == 0 ? 0.4 : 0, seed);
    if (seed % 2 == 1)
      for (auto& p : s.points) p[1] *= 0.05; // slivers
    Exact t = delaunay<Exact>(s.input());
    const IT::Map_certificate certificate = IT::certify_map(t, IT::harmonic_map(t));
    EXPECT_TRUE(certificate.is_injective()) << seed;
    EXPECT_EQ(certificate.faces, 200U);
    IT::delaunay_refine(t, IT::parameters::minimum_angle(25));
    const Map refined = IT::harmonic_map(t);
    EXPECT_TRUE(IT::certify_map(t, refined).is_injective()) << seed;
    EXPECT_LE(refined.rowwise().norm().maxCoeff(), 1 + 1e-15) << "the principle of the maximum";
  }
}

TEST(Harmonic_map, flips_faces_where_weights_are_negative_and_the_certificate_says_so) {
  bool is_any_flipped = false;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    Shape s = rough_grid(10, 0.35, 1.5, seed);
    for (auto& p : s.points) p[1] *= 0.02;
    const Exact t(s.input());
    const IT::Map_certificate c = IT::certify_map(t, IT::harmonic_map(t));
    is_any_flipped = is_any_flipped || c.flipped > 0;
    EXPECT_EQ(c.is_locally_injective(), c.bad_faces.empty());
    EXPECT_TRUE(c.border_is_simple);
  }
  EXPECT_TRUE(is_any_flipped);
}

TEST(Harmonic_map, reaches_the_corners_of_a_polygon) {
  const Shape s = rough_grid(12, 0.05, 0.1, 2); // corners of the grid come to corners of the square
  const Exact t = delaunay<Exact>(s.input());
  const std::vector<std::array<double, 2>> square{{0, 0}, {3, 0}, {3, 3}, {0, 3}};
  const IT::Border_map border = IT::polygonal_border(t, square);
  const Map uv = IT::harmonic_map(t, border);
  for (const auto& corner : square) {
    bool is_there = false;
    for (Eigen::Index v = 0; v < uv.rows(); ++v)
      is_there = is_there || (uv(v, 0) == corner[0] && uv(v, 1) == corner[1]);
    EXPECT_TRUE(is_there) << corner[0] << ", " << corner[1];
  }
  for (Eigen::Index v = 0; v < uv.rows(); ++v) {
    EXPECT_GE(uv.row(v).minCoeff(), -1e-14);
    EXPECT_LE(uv.row(v).maxCoeff(), 3 + 1e-14);
  }
  EXPECT_TRUE(IT::certify_map(t, uv).is_injective());
  const auto refused = [&t](const std::vector<std::array<double, 2>>& corners) {
    EXPECT_THROW(IT::polygonal_border(t, corners), std::invalid_argument);
  };
  refused({{0, 0}, {0, 3}, {3, 3}, {3, 0}});                               // clockwise
  refused({{0, 0}, {1, 0}, {2, 0}, {1, 1}});                               // a straight corner
  refused({{0, 0}, {1, 0}});                                               // no polygon
  refused({{1, 0}, {-0.8, 0.6}, {0.3, -0.95}, {0.3, 0.95}, {-0.8, -0.6}}); // a star
  refused(std::vector<std::array<double, 2>>(1000, std::array<double, 2>{0, 0})); // a point
}

TEST(Conformal_maps, of_developable_surfaces_are_isometries) {
  const auto expect_isometry = [](const Exact& t, const Map& uv, const std::string& what) {
    for (const auto e : edges(t.mesh())) {
      const auto h = halfedge(e, t.mesh());
      const auto a = uv.row(t.input_vertex(source(h, t.mesh()))),
                 b = uv.row(t.input_vertex(target(h, t.mesh())));
      EXPECT_NEAR((a - b).norm() / t.length(e), 1, 1e-4) << what;
    }
    EXPECT_TRUE(IT::certify_map(t, uv).is_injective()) << what;
    EXPECT_LE(IT::measure_distortion(t, uv).maximum_angle_change, 1e-4) << what;
  };
  const Exact flat = delaunay<Exact>(rough_grid(10, 0.3, 0, 9).input());
  expect_isometry(flat, IT::least_squares_conformal_map(flat), "flat, least squares");
  expect_isometry(flat, IT::spectral_conformal_map(flat), "flat, spectral");
}

TEST(Conformal_maps, end_when_the_visitor_says_so) {
  struct Visitor {
    std::size_t calls = 0, last;
    bool progress(std::size_t) { return calls++ < last; }
  };
  const Exact t = delaunay<Exact>(bent_grid(4).input());
  for (const bool is_spectral : {false, true}) {
    const auto map = [&](Visitor& v) {
      const auto np = IT::parameters::visitor(std::ref(v));
      return is_spectral ? IT::spectral_conformal_map(t, np)
                         : IT::least_squares_conformal_map(t, np);
    };
    Visitor all{0, 1000};
    const Map uv = map(all);
    EXPECT_EQ(uv, is_spectral ? IT::spectral_conformal_map(t) : IT::least_squares_conformal_map(t));
    EXPECT_GE(all.calls, 2U);
    for (std::size_t last = 0; last < all.calls; ++last) {
      Visitor some{0, last};
      EXPECT_EQ(map(some).rows(), 0);
      EXPECT_EQ(some.calls, last + 1);
    }
  }
}

TEST(Conformal_maps, of_a_bent_sheet_are_nearly_isometries) {
  // inscribed in a cylinder: curvature at vertices is small, but not zero
  const Exact t = delaunay<Exact>(bent_grid(24).input());
  for (const Map& uv : {IT::least_squares_conformal_map(t), IT::spectral_conformal_map(t)}) {
    EXPECT_TRUE(IT::certify_map(t, uv).is_injective());
    const IT::Map_distortion d = IT::measure_distortion(t, uv);
    EXPECT_LT(d.mean_quasi_conformal, 1.02);
    EXPECT_LT(d.mean_area_ratio, 1.05);
  }
}

TEST(Conformal_maps, of_a_piece_of_a_sphere_tend_to_conformal_ones) {
  const auto distortion = [](std::uint32_t n, bool is_spectral) {
    const Exact t = delaunay<Exact>(sphere_cap(n, 0.9).input());
    const Map uv = is_spectral ? IT::spectral_conformal_map(t) : IT::least_squares_conformal_map(t);
    EXPECT_TRUE(IT::certify_map(t, uv).is_injective()) << n;
    const IT::Map_distortion d = IT::measure_distortion(t, uv);
    EXPECT_GT(d.maximum_area_ratio, 1.5) << "no map of a sphere keeps areas and angles";
    return d.mean_quasi_conformal - 1;
  };
  for (const bool is_spectral : {false, true}) {
    const double coarse = distortion(8, is_spectral), fine = distortion(32, is_spectral);
    EXPECT_LT(coarse, 0.2);
    EXPECT_LT(fine, coarse / 2);
  }
}

TEST(Conformal_maps, have_no_less_energy_than_is_possible) {
  const Shape s = rough_grid(7, 0.3, 0.8, 5);
  const Exact t = delaunay<Exact>(s.input());
  const Eigen::MatrixXcd c(IT::conformal_energy(t));
  EXPECT_LE((c - c.adjoint()).norm(), 1e-15 * c.norm());
  const Eigen::VectorXd eigenvalues = dense_eigenvalues(c);
  EXPECT_GE(eigenvalues[0], -1e-13);
  // the energy of any map is that of the equations of Cauchy and Riemann in each face
  const Map uv = random_vector(2 * c.rows(), 4).reshaped(c.rows(), 2);
  const Eigen::VectorXcd w = uv.col(0) + std::complex<double>(0, 1) * uv.col(1);
  double energy = 0;
  for (const auto f : faces(t.mesh())) {
    const auto h = halfedge(f, t.mesh()), n = next(h, t.mesh()), l = next(n, t.mesh());
    const double ij = t.length(edge(h, t.mesh())), jk = t.squared_length(edge(n, t.mesh())),
                 ki = t.squared_length(edge(l, t.mesh()));
    const double x = (ij * ij + ki - jk) / (2 * ij), y = 2 * t.area(f) / ij;
    const auto at = [&](auto g) { return w[t.input_vertex(source(g, t.mesh()))]; };
    const std::complex<double> w_x = (at(n) - at(h)) / ij, w_y = (at(l) - at(h) - x * w_x) / y;
    energy += t.area(f) * std::norm(w_x + std::complex<double>(0, 1) * w_y) / 2;
  }
  EXPECT_NEAR(std::real(std::complex<double>(w.dot(c * w))), energy, 1e-12 * energy);
}

TEST(Map_certificate, knows_flipped_degenerate_and_overlapping_maps) {
  const Exact t(grid(1).input()); // two triangles, 0 1 3 and 0 3 2
  const auto certify = [&t](const std::vector<double>& x) {
    Map uv(4, 2);
    for (Eigen::Index i = 0; i < 4; ++i)
      uv.row(i) << x[2 * static_cast<std::size_t>(i)], x[2 * static_cast<std::size_t>(i) + 1];
    return IT::certify_map(t, uv);
  };
  EXPECT_TRUE(certify({0, 0, 1, 0, 0, 1, 1, 1}).is_injective());
  const IT::Map_certificate mirrored = certify({0, 0, 0, 1, 1, 0, 1, 1});
  EXPECT_EQ(mirrored.flipped, 2U);
  EXPECT_TRUE(mirrored.border_is_simple);
  EXPECT_FALSE(mirrored.is_injective());
  const IT::Map_certificate folded = certify({0, 0, 1, 0, 0.9, 0.1, 1, 1});
  EXPECT_EQ(folded.flipped, 1U);
  EXPECT_EQ(folded.bad_faces.size(), 1U);
  // one unit in the last place decides
  EXPECT_EQ(certify({0, 0, 1, 0, 0.5, 0.5, 1, 1}).degenerate, 1U);
  EXPECT_EQ(certify({0, 0, 1, 0, 0.5, std::nextafter(0.5, 1), 1, 1}).degenerate, 0U);
  EXPECT_EQ(certify({0, 0, 1, 0, 0.5, std::nextafter(0.5, 0), 1, 1}).flipped, 1U);
  EXPECT_THROW(IT::certify_map(t, Map::Zero(3, 2)), std::invalid_argument);
  EXPECT_THROW(certify({0, 0, NAN, 0, 0, 0, 0, 0}), std::invalid_argument);
}

TEST(Map_certificate, knows_faces_that_are_listed_twice) {
  std::vector<std::array<std::uint32_t, 3>> fan{{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  Map uv(4, 2);
  uv << 0, 0, 3, 0, 0, 3, 1, 1;
  EXPECT_TRUE(IT::certify_map(fan, uv).is_injective());
  fan.push_back(fan[1]);
  EXPECT_FALSE(IT::certify_map(fan, uv).is_injective());
  fan.back() = {0, 1, 2};
  EXPECT_FALSE(IT::certify_map(fan, uv).is_injective());
}

TEST(Harmonic_map, refuses_rows_without_positions) {
  const Exact t(grid(2).input());
  IT::Border_map border = IT::circular_border(t);
  border.rows.push_back(4); // the one inside
  EXPECT_THROW(IT::harmonic_map(t, border), std::invalid_argument);
}

TEST(Map_certificate, knows_maps_that_are_locally_injective_but_overlap) {
  // a strip that winds around once and a half; and a fan that winds around its centre twice
  std::vector<std::array<std::uint32_t, 3>> strip, fan;
  constexpr std::uint32_t n = 24;
  Map spiral(2 * (n + 1), 2), twice(n + 1, 2);
  const double pi = std::numbers::pi;
  for (std::uint32_t i = 0; i <= n; ++i) {
    const double a = 3 * pi * i / n;
    spiral.row(2 * i) << std::cos(a), std::sin(a);
    spiral.row(2 * i + 1) << 2 * std::cos(a), 2 * std::sin(a);
  }
  for (std::uint32_t i = 0; i < 2 * n; i += 2) {
    strip.push_back({i, i + 1, i + 3});
    strip.push_back({i, i + 3, i + 2});
  }
  twice.row(n) << 0, 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double a = 4 * pi * i / n;
    twice.row(i) << (1 + 0.01 * i) * std::cos(a), (1 + 0.01 * i) * std::sin(a);
    fan.push_back({n, i, (i + 1) % n});
  }
  for (const auto& [triangles, uv] : {std::pair{strip, spiral}, {fan, twice}}) {
    const IT::Map_certificate c = IT::certify_map(triangles, uv);
    EXPECT_TRUE(c.is_locally_injective());
    EXPECT_FALSE(c.border_is_simple);
    EXPECT_FALSE(c.is_injective());
  }
}

/// Thorns that lean to a side: the Delaunay triangulation joins tips to few of the vertices around. Blunt ones are repaired; of sharp ones every
/// refinement has such a tip, and the status says so.
TEST(Injective_harmonic_map, splits_edges_where_vertices_separate_others_from_the_border) {
  std::size_t repaired = 0;
  for (const double height : {0.2, 0.3, 0.5, 0.7, 1., 3., 30.})
    for (const double lean : {0.5, 1., 2.}) {
      Shape s = grid(8);
      s.points[40][0] += lean * height;
      s.points[40][1] += 0.3 * lean * height;
      s.points[40][2] += height;
      Exact t = delaunay<Exact>(s.input());
      const double area = IT::total_area(t);
      const bool is_bad = !IT::certify_map(t, IT::harmonic_map(t)).is_injective();
      const IT::Border_map border = IT::circular_border(t);
      const IT::Injective_map map = IT::injective_harmonic_map(t);
      EXPECT_EQ(map.status == IT::Status::done, map.certificate.is_injective());
      EXPECT_EQ(IT::certify_map(t, map.uv).is_injective(), map.certificate.is_injective());
      if (is_bad && map.certificate.is_injective()) ++repaired;
      const double angle =
          2 * std::numbers::pi - IT::gaussian_curvature(t, t.numbers().vertex_at(40));
      if (angle > 2) {
        EXPECT_EQ(map.status, IT::Status::done) << height << ' ' << lean;
      }
      EXPECT_EQ(map.inserted > 0, map.rounds > 0);
      EXPECT_EQ(num_vertices(t.mesh()), s.points.size() + map.inserted);
      EXPECT_NEAR(IT::total_area(t) / area, 1, 1e-12);
      for (std::size_t k = 0; k < border.rows.size(); ++k) // it stays in place
        EXPECT_EQ(map.uv.row(border.rows[k]), border.positions.row(static_cast<Eigen::Index>(k)));
    }
  EXPECT_GT(repaired, 0U);
}

/// Two vertices so near to each other that the weights of their other edges are lost beside theirs:
/// their images coincide up to rounding, until sizes of faces around them grow step by step.
TEST(Injective_harmonic_map, reaches_small_sizes_in_few_rounds) {
  std::size_t repaired = 0;
  for (const double height : {1e-3, 1e-5, 1e-7, 1e-12}) {
    Shape s = grid(8);
    for (const std::size_t f : {20, 47, 90}) {
      const std::array<std::uint32_t, 3> corners = s.triangles[f];
      const auto tip = static_cast<std::uint32_t>(s.points.size());
      s.points.push_back(s.points[corners[0]]);
      s.points.back()[2] += height;
      s.triangles[f][2] = tip;
      s.triangles.push_back({corners[1], corners[2], tip});
      s.triangles.push_back({corners[2], corners[0], tip});
    }
    Exact t = delaunay<Exact>(s.input());
    const bool is_bad = !IT::certify_map(t, IT::harmonic_map(t)).is_injective();
    const IT::Injective_map map = IT::injective_harmonic_map(t);
    if (is_bad && map.status == IT::Status::done) ++repaired;
    EXPECT_EQ(map.status == IT::Status::done, map.certificate.is_injective());
    if (height >= 1e-7) {
      EXPECT_EQ(map.status, IT::Status::done) << height;
    }
    EXPECT_LE(map.rounds, 8U) << height;
    EXPECT_LE(map.inserted, 400U) << height;
  }
  EXPECT_GT(repaired, 0U);
}

TEST(Injective_harmonic_map, splits_faces_on_a_side_of_a_polygon) {
  Exact t(grid(4).input());
  const IT::Border_map border = IT::polygonal_border(t, {{0, 0}, {1, 0}, {0, 1}});
  IT::flip_to_delaunay(t);
  const IT::Map_certificate before = IT::certify_map(t, IT::harmonic_map(t, border));
  EXPECT_GT(before.degenerate, 0U);
  const IT::Injective_map map = IT::injective_harmonic_map(t, border);
  EXPECT_EQ(map.status, IT::Status::done);
  EXPECT_TRUE(map.certificate.is_injective());
  EXPECT_GT(map.inserted, 0U);
  // no refinement makes a map of a triangle to a line injective
  Shape one;
  one.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles = {{0, 1, 2}};
  Exact u(one.input());
  IT::Border_map line = IT::circular_border(u);
  line.positions.col(1).setZero();
  EXPECT_EQ(IT::injective_harmonic_map(u, line).status, IT::Status::stalled);
  EXPECT_EQ(IT::injective_harmonic_map(t, border, IT::parameters::maximum_rounds(0)).status,
            IT::Status::done);
}

TEST(Injective_harmonic_map, ends_when_the_visitor_says_so) {
  struct Visitor {
    bool progress(const IT::Injective_map& map) { return map.uv.size() == 0; }
  };
  Exact t(grid(4).input());
  const IT::Border_map border = IT::polygonal_border(t, {{0, 0}, {1, 0}, {0, 1}});
  const IT::Injective_map map =
      IT::injective_harmonic_map(t, border, IT::parameters::visitor(Visitor()));
  EXPECT_EQ(map.status, IT::Status::cancelled);
  EXPECT_EQ(map.certificate.faces, 32U);
  EXPECT_EQ(map.inserted, 0U);
}

// A tube of 60 rings of hexagons, closed at its end, that opens in a plane; there a vertex is pulled out. Faces of the tube come first.
Shape tube_with_thorn(double height, double lean) {
  constexpr std::uint32_t m = 6, rings = 60, all = rings + 5;
  Shape s;
  s.points.push_back({0, 0, rings});
  for (std::uint32_t k = 0; k < all; ++k) {
    const double r = k <= rings ? 1 : k - rings + 1, z = k <= rings ? rings - k : 0;
    for (std::uint32_t i = 0; i < m; ++i) {
      const double angle = 2 * std::numbers::pi * i / m;
      s.points.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
  }
  for (std::uint32_t i = 0; i < m; ++i) s.triangles.push_back({0, 1 + i, 1 + (i + 1) % m});
  for (std::uint32_t k = 0; k + 1 < all; ++k)
    for (std::uint32_t i = 0; i < m; ++i) {
      const std::uint32_t a = 1 + k * m + i, b = 1 + k * m + (i + 1) % m;
      s.triangles.push_back({a, a + m, b});
      s.triangles.push_back({b, a + m, b + m});
    }
  auto& tip = s.points[1 + (rings + 2) * m];
  tip = {tip[0] + lean * height, tip[1] + 0.3 * lean * height, height};
  return s;
}

/// The faces that a map turns over or whose image has no area; exact.
std::vector<Exact::face_descriptor> bad_faces(const Exact& t, const Map& uv) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  std::vector<Exact::face_descriptor> result;
  for (const auto f : faces(t.mesh())) {
    std::vector<Point> p;
    for (const auto v : CGAL::vertices_around_face(halfedge(f, t.mesh()), t.mesh()))
      p.emplace_back(uv(t.input_vertex(v), 0), uv(t.input_vertex(v), 1));
    if (CGAL::orientation(p[0], p[1], p[2]) != CGAL::LEFT_TURN) result.push_back(f);
  }
  return result;
}

/// On the tube more than a hundred faces are smaller than rounding and stay; the thorn is still
/// repaired.
TEST(Injective_harmonic_map, splits_large_faces_whose_numbers_come_after_many_of_rounding_size) {
  std::size_t repaired = 0;
  for (const double height : {1.5, 2.})
    for (const double lean : {1., 2.}) {
      Exact t = delaunay<Exact>(tube_with_thorn(height, lean).input());
      const auto large = [&t](const Map& uv) {
        const IT::Map_certificate c = IT::certify_map(t, uv);
        const std::vector<Exact::face_descriptor> bad = bad_faces(t, uv);
        EXPECT_EQ(bad.size(), c.flipped + c.degenerate);
        EXPECT_GT(bad.size(), 100U);
        const auto is_large = [&](Exact::face_descriptor f) { // half of the digits are left
          const auto h = halfedge(f, t.mesh());
          const auto at = [&](auto side) { return uv.row(t.input_vertex(target(side, t.mesh()))); };
          const auto size = [&](auto side) { return (at(side) - at(h)).norm(); };
          const auto g = next(h, t.mesh());
          return std::max(size(g), size(next(g, t.mesh()))) > 0x1p-28 * uv.cwiseAbs().maxCoeff();
        };
        return std::ranges::count_if(bad, is_large);
      };
      const bool is_bad = large(IT::harmonic_map(t)) > 0;
      const IT::Injective_map map = IT::injective_harmonic_map(t);
      EXPECT_EQ(map.certificate.bad_faces.size(), 100U);
      EXPECT_EQ(map.inserted > 0, is_bad);
      if (map.status == IT::Status::inaccurate) {
        EXPECT_EQ(large(map.uv), 0);
        if (is_bad) ++repaired;
      } else {
        EXPECT_EQ(map.status, IT::Status::cap);
      }
    }
  EXPECT_GE(repaired, 2U);
}

TEST(Map_distortion, of_a_linear_map_is_its_singular_values) {
  const Shape s = rough_grid(6, 0.3, 0, 8);
  const Exact t(s.input());
  Map uv(s.points.size(), 2);
  for (std::uint32_t v = 0; v < s.points.size(); ++v)
    uv.row(v) << 3 * s.points[v][0] + 4 * s.points[v][1],
        0.5 * (3 * s.points[v][1] - 4 * s.points[v][0]);
  const IT::Map_distortion d = IT::measure_distortion(t, uv); // a rotation, times diag(5, 2.5)
  EXPECT_NEAR(d.mean_quasi_conformal, 2, 1e-10);
  EXPECT_NEAR(d.maximum_quasi_conformal, 2, 1e-10);
  EXPECT_NEAR(d.minimum_area_ratio, 1, 1e-12);
  EXPECT_NEAR(d.maximum_area_ratio, 1, 1e-12);
  EXPECT_LE(d.maximum_angle_change, 2 * (std::atan(2) - std::atan(0.5)) + 1e-12);
  EXPECT_GT(d.mean_angle_change, 0.1);
}

TEST(Map_distortion, does_not_depend_on_the_unit_of_the_map) {
  const Exact t = delaunay<Exact>(rough_grid(6, 0.3, 0.5, 8).input());
  const Map uv = IT::harmonic_map(t);
  const IT::Map_distortion expected = IT::measure_distortion(t, uv);
  EXPECT_GT(expected.mean_quasi_conformal, 1.01);
  for (const int e : {-900, -540, 540, 1000}) {
    const IT::Map_distortion d = IT::measure_distortion(t, Map(uv * std::ldexp(1., e)));
    EXPECT_EQ(d.faces_left_out, 0U);
    EXPECT_EQ(d.mean_quasi_conformal, expected.mean_quasi_conformal) << e;
    EXPECT_EQ(d.mean_angle_change, expected.mean_angle_change) << e;
    EXPECT_EQ(d.minimum_area_ratio, expected.minimum_area_ratio) << e;
    EXPECT_EQ(d.mean_area_ratio, expected.mean_area_ratio) << e;
  }
}

TEST(Map_distortion, leaves_out_and_counts_faces_without_area) {
  meshes::Mesh m;
  m.points = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, -1, 0}};
  m.triangles = {{0, 2, 3}, {2, 1, 3}, {0, 4, 1}, {0, 1, 2}}; // the last is a line
  const Exact t(m.input());
  Map uv(5, 2);
  for (int v = 0; v < 5; ++v)
    uv.row(v) << 2 * m.points[static_cast<std::size_t>(v)][0],
        m.points[static_cast<std::size_t>(v)][1];
  const IT::Map_distortion d = IT::measure_distortion(t, uv);
  EXPECT_EQ(d.faces_left_out, 1U);
  EXPECT_NEAR(d.mean_quasi_conformal, 2, 1e-14);
  EXPECT_NEAR(d.minimum_area_ratio, 1, 1e-14);
  EXPECT_NEAR(d.mean_area_ratio, 1, 1e-14);
  EXPECT_TRUE(std::isfinite(d.mean_angle_change));
  EXPECT_THROW(IT::hodge_star_1(t), IT::Invalid_input);
  EXPECT_THROW(IT::cotangent_laplacian(t), IT::Invalid_input);
  m.triangles = {{0, 1, 2}};
  m.points.resize(3);
  const IT::Map_distortion none = IT::measure_distortion(Exact(m.input()), Map(uv.topRows(3)));
  EXPECT_EQ(none.faces_left_out, 1U);
  EXPECT_EQ(none.mean_quasi_conformal, 1);
  EXPECT_EQ(none.mean_area_ratio, 1);
  uv(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(IT::measure_distortion(t, uv), std::invalid_argument);
}

template <class Function>
void expect_no_disk(const IT::Intrinsic_input& input, const std::string& reason, Function f) {
  const Exact t(input);
  try {
    f(t);
    ADD_FAILURE() << reason << ": not refused";
  } catch (const IT::Invalid_input& e) {
    EXPECT_NE(std::string(e.what()).find(reason), std::string::npos) << e.what();
  }
}

TEST(Disk_border, is_refused_of_what_is_no_disk) {
  const auto border = [](const Exact& t) { IT::circular_border(t); };
  expect_no_disk(torus(3, 0.3), "no border", border);
  expect_no_disk(input(gallery::annulus(5)), "more than one border", border);
  expect_no_disk(tetrahedron().input(), "no border", border);
  expect_no_disk(input(gallery::self_folded_cone()), "1 vertices", border);
  expect_no_disk(beside(grid(1), tetrahedron(), 5).input(), "vertex of row 4 has no border",
                 border);
  const auto soup = soups::soup({grid(2).points, grid(2).triangles});
  expect_no_disk(IT::make_domain(soup, IT::Domain_kind::tufted_cover).input, "cover", border);
}

TEST(Harmonic_map, is_the_same_on_every_mesh_type_and_leaves_isolated_vertices_at_the_origin) {
  Shape s = rough_grid(6, 0.3, 0.5, 1);
  const Map expected = IT::harmonic_map(Exact(s.input()));
  const Map conformal = IT::least_squares_conformal_map(Exact(s.input()));
  const auto on = [&](const auto& mesh) {
    const IT::Intrinsic_triangulation<std::decay_t<decltype(mesh)>> t(mesh);
    EXPECT_LE((IT::harmonic_map(t) - expected).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LE((IT::least_squares_conformal_map(t) - conformal).cwiseAbs().maxCoeff(), 1e-9);
  };
  on(mesh_of<Surface_mesh>(s));
  on(mesh_of<Polyhedron>(s));
  on(mesh_of<OpenMesh_polygons>(s));
  s.points.push_back({50, 50, 50});
  const Exact t(s.input());
  for (const Map& uv :
       {IT::harmonic_map(t), IT::least_squares_conformal_map(t), IT::spectral_conformal_map(t)}) {
    EXPECT_EQ(uv.row(uv.rows() - 1).norm(), 0);
    EXPECT_TRUE(uv.allFinite());
    EXPECT_TRUE(IT::certify_map(t, uv).border_is_simple);
  }
}

TEST(Conformal_maps, of_a_single_triangle_keep_its_shape) {
  Shape s;
  s.points = {{0, 0, 0}, {4, 0, 0}, {1, 2, 3}};
  s.triangles = {{0, 1, 2}};
  const Exact t(s.input());
  for (const Map& uv : {IT::least_squares_conformal_map(t), IT::spectral_conformal_map(t)}) {
    EXPECT_TRUE(IT::certify_map(t, uv).is_injective());
    EXPECT_LE(IT::measure_distortion(t, uv).maximum_angle_change, 1e-6);
  }
  EXPECT_TRUE(IT::certify_map(t, IT::harmonic_map(t)).is_injective());
}

} // namespace
