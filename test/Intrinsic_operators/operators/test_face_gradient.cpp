// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "delaunay.h"
#include "operator_test_meshes.h"
#include "soups.h"

#include <CGAL/Intrinsic_operators/operators/Face_gradient.h>
#include <CGAL/Intrinsic_operators/operators/hodge_stars.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <utility>
#include <vector>

namespace {

namespace face_gradient {

using namespace operator_test;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// In the plane the gradient of a linear function is the same vector in each frame.
TEST(Face_gradient, of_a_linear_function_is_its_slope) {
  for (const double unit : {1., 1000., 0x1p-300}) {
    Shape s = rough_grid(6, 0.2, 0, 5);
    for (auto& p : s.points)
      for (double& x : p) x *= unit;
    const Exact t(s.input());
    Eigen::VectorXd u(static_cast<Eigen::Index>(s.points.size()));
    for (std::uint32_t v = 0; v < s.points.size(); ++v)
      u[v] = (2 * s.points[v][0] - 3 * s.points[v][1]) / unit;
    const IT::Face_gradient g(t);
    const Eigen::VectorXcd gradient = g.gradient(u);
    EXPECT_LE((g.matrix() * u - gradient).norm(), 1024 * epsilon * gradient.norm());
    for (const auto f : faces(t.mesh())) {
      const auto h = halfedge(f, t.mesh());
      const Eigen::Vector3d axis = s.point(t.input_vertex(target(h, t.mesh()))) -
                                   s.point(t.input_vertex(source(h, t.mesh())));
      const std::complex<double> in_plane =
          gradient[t.index(f)] * std::polar(1., std::atan2(axis[1], axis[0]));
      // slopes of u in faces whose height is more than a fifth of their size
      EXPECT_LE(std::abs(in_plane * unit - std::complex<double>(2, -3)), 1024 * epsilon);
    }
  }
}

template <class Triangulation>
void expect_identities(const Triangulation& t) {
  const IT::Face_gradient g(t);
  const Matrix l = IT::cotangent_laplacian(t);
  const Eigen::VectorXd u = Eigen::VectorXd::Random(l.rows());
  const double size = l.norm() * u.norm();
  const Eigen::VectorXcd x = g.gradient(u);
  EXPECT_LE((g.divergence(x) + l * u).norm(), 4096 * epsilon * size);
  const Matrix d0 = IT::exterior_derivative_0(t), d1 = IT::exterior_derivative_1(t);
  EXPECT_EQ((d1 * d0).norm(), 0); // integers
  const Matrix product = d0.transpose() * IT::hodge_star_1(t).asDiagonal() * d0;
  EXPECT_LE((product - l).norm(), 4096 * epsilon * l.norm());
  const Eigen::VectorXd area_of_vertices = IT::hodge_star_0(t);
  double area = 0;
  for (const auto f : faces(t.mesh())) area += t.area(f) / t.input().names().sheets;
  EXPECT_NEAR(area_of_vertices.sum(), area, 4096 * epsilon * area);
  // of no sheet, a field and what is turned by a right angle have the same flux and circulation
  const Eigen::VectorXcd y = Eigen::VectorXcd::Random(g.number_of_faces());
  const Eigen::VectorXcd turned = std::complex<double>(0, 1) * y;
  EXPECT_EQ((g.curl(turned) - g.divergence(y)).norm(), 0);
  for (const auto f : faces(t.mesh()))
    EXPECT_NEAR(IT::hodge_star_2(t)[t.index(f)] * t.area(f), t.input().names().sheets, 4 * epsilon);
}

TEST(Face_gradient, divergence_and_derivatives_make_the_laplacian) {
  expect_identities(Exact(rough_grid(7, 0.2, 0.5, 3).input()));
  expect_identities(Double(cube().input()));
  expect_identities(Exact(torus(1, 0.25))); // one vertex: all edges are loops
  Exact t = delaunay<Exact>(rough_grid(7, 0.3, 2, 4).input());
  expect_identities(t);
}

TEST(Face_gradient, is_that_of_the_surface_below_a_cover) {
  auto domain = IT::make_domain(soups::soup(soups::book()), IT::Domain_kind::tufted_cover);
  Exact t = delaunay<Exact>(std::move(domain.input));
  expect_identities(t);
}

// On a closed surface, and at inner vertices: sum over the star of A <J grad phi_i, grad u> is half the sum of the differences of u around it.
TEST(Face_gradient, gradients_have_no_curl_at_inner_vertices) {
  const Exact t(rough_grid(6, 0.2, 0.7, 9).input());
  const IT::Face_gradient g(t);
  const Eigen::VectorXd u = Eigen::VectorXd::Random(g.number_of_vertices());
  const Eigen::VectorXd curl = g.curl(g.gradient(u));
  double border = 0;
  for (const auto v : vertices(t.mesh())) {
    bool is_inner = true;
    for (const auto h : CGAL::halfedges_around_target(v, t.mesh()))
      is_inner = is_inner && !CGAL::is_border(h, t.mesh());
    if (is_inner)
      EXPECT_LE(std::abs(curl[t.input_vertex(v)]), 256 * epsilon);
    else
      border += std::abs(curl[t.input_vertex(v)]);
  }
  EXPECT_GT(border, 1);
}

TEST(Face_gradient, refuses_what_makes_no_sense) {
  const Exact t(cube().input());
  const IT::Face_gradient g(t);
  EXPECT_THROW(g.gradient(Eigen::VectorXd::Ones(7)), std::invalid_argument);
  EXPECT_THROW(g.divergence(Eigen::VectorXcd::Ones(7)), std::invalid_argument);
  Shape cap{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}};
  const Exact degenerate(cap.input());
  EXPECT_THROW(IT::Face_gradient{degenerate}, IT::Invalid_input);
}

} // namespace face_gradient

} // namespace
