// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/distance/Signed_heat_distance.h>

#include "delaunay.h"
#include "dense_eigenvalues.h"
#include "operator_test_meshes.h"
#include "soups.h"

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_operators/elements/crouzeix_raviart.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using namespace operator_test;
using Complex = std::complex<double>;

// the halfedge between two rows
template <class T>
typename T::halfedge_descriptor halfedge_between(const T& t, std::uint32_t from, std::uint32_t to) {
  for (const auto h : halfedges(t.mesh()))
    if (t.input_vertex(source(h, t.mesh())) == from && t.input_vertex(target(h, t.mesh())) == to)
      return h;
  throw std::out_of_range("no such edge");
}

template <class T>
std::vector<typename T::halfedge_descriptor> path_of_rows(const T& t,
                                                          const std::vector<std::uint32_t>& rows) {
  std::vector<typename T::halfedge_descriptor> path;
  for (std::size_t i = 1; i < rows.size(); ++i)
    path.push_back(halfedge_between(t, rows[i - 1], rows[i]));
  return path;
}

// Two circles around a square torus bound a strip: all normals are parallel.
template <class T>
void expect_exact_from_strip() {
  constexpr std::uint32_t n = 12;
  const T t(torus(n, 0));
  std::vector<std::uint32_t> up, down; // x = 0 upwards, x = n / 2 downwards
  for (std::uint32_t y = 0; y <= n; ++y) {
    up.push_back(n * (y % n));
    down.push_back(n * ((n - y) % n) + n / 2);
  }
  IT::Signed_heat_distance signed_distance(t);
  const Eigen::VectorXd d =
      signed_distance.distances(std::vector{path_of_rows(t, up), path_of_rows(t, down)});
  std::reverse(up.begin(), up.end());
  std::reverse(down.begin(), down.end());
  const Eigen::VectorXd back =
      signed_distance.distances(std::vector{path_of_rows(t, up), path_of_rows(t, down)});
  for (std::uint32_t v = 0; v < n * n; ++v) {
    const double x = v % n, half = n / 2;
    const double expected = x < half ? std::min(x, half - x) : -std::min(x - half, n - x);
    EXPECT_NEAR(d[v], expected, 1e-10);
    EXPECT_NEAR(back[v], -expected, 1e-10);
    if (expected == 0) {
      EXPECT_EQ(d[v], 0);
    }
  }
}

TEST(Signed_heat_distance, from_the_sides_of_a_strip_is_exact_on_every_mesh_type) {
  expect_exact_from_strip<Exact>();
  expect_exact_from_strip<Double>();
  expect_exact_from_strip<IT::Intrinsic_triangulation<Surface_mesh>>();
  expect_exact_from_strip<IT::Intrinsic_triangulation<Polyhedron_with_ids>>();
  expect_exact_from_strip<IT::Intrinsic_triangulation<OpenMesh_triangles>>();
}

// The square [a, b]^2 in a grid, counterclockwise.
std::vector<std::uint32_t> square_loop(std::uint32_t n, std::uint32_t a, std::uint32_t b) {
  std::vector<std::uint32_t> rows;
  const auto add = [&](std::uint32_t x, std::uint32_t y) { rows.push_back((n + 1) * y + x); };
  for (std::uint32_t x = a; x < b; ++x) add(x, a);
  for (std::uint32_t y = a; y < b; ++y) add(b, y);
  for (std::uint32_t x = b; x > a; --x) add(x, b);
  for (std::uint32_t y = b; y > a; --y) add(a, y);
  rows.push_back(rows.front());
  return rows;
}

double distance_to_square(double x, double y, double a, double b) {
  const double outside_x = std::max({a - x, 0.0, x - b}), outside_y = std::max({a - y, 0.0, y - b});
  if (outside_x > 0 || outside_y > 0) return std::hypot(outside_x, outside_y);
  return -std::min({x - a, b - x, y - a, b - y});
}

TEST(Signed_heat_distance, of_a_loop_is_negative_inside_and_zero_on_it) {
  constexpr std::uint32_t n = 40;
  const Shape s = grid(n);
  const Exact t(s.input());
  IT::Signed_heat_distance signed_distance(t);
  const std::vector<std::uint32_t> loop = square_loop(n, 10, 30);
  const Eigen::VectorXd d = signed_distance.distances(path_of_rows(t, loop));
  for (const std::uint32_t r : loop) EXPECT_EQ(d[r], 0);
  for (std::uint32_t v = 0; v < s.points.size(); ++v) {
    const double expected = distance_to_square(s.points[v][0], s.points[v][1], 10, 30);
    EXPECT_NEAR(d[v], expected, 1.5);
    if (std::abs(expected) > 1) {
      EXPECT_EQ(d[v] > 0, expected > 0) << v;
    }
  }
  // a hole in the loop: open curves have sides too
  std::vector<std::uint32_t> open(loop.begin(), loop.end() - 4);
  const Eigen::VectorXd with_gap = signed_distance.distances(path_of_rows(t, open));
  EXPECT_LT(with_gap[(n + 1) * 20 + 20], -5);
  EXPECT_GT(with_gap[0], 5);
  // two loops
  const auto two =
      std::vector{path_of_rows(t, square_loop(n, 4, 12)), path_of_rows(t, square_loop(n, 24, 36))};
  const Eigen::VectorXd both = signed_distance.distances(two);
  EXPECT_LT(both[(n + 1) * 8 + 8], -2);
  EXPECT_LT(both[(n + 1) * 30 + 30], -4);
  EXPECT_GT(both[(n + 1) * 18 + 18], 4);
}

double distance_to_edge(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                        const Eigen::Vector3d& b) {
  const double x = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - x * (b - a)).norm();
}

// The mean error of distances to a square loop, whose vertices are moved at random, in edges.
double mean_error_of_loop(unsigned seed) {
  constexpr std::uint32_t n = 40;
  const Shape s = rough_grid(n, 0.3, 0, seed);
  Exact t(s.input());
  const std::vector<std::uint32_t> loop = square_loop(n, 8 + seed % 5, 27 + seed % 6);
  const Eigen::VectorXd d = IT::Signed_heat_distance(t).distances(path_of_rows(t, loop));
  double sum = 0;
  for (std::uint32_t v = 0; v < s.points.size(); ++v) {
    double exact = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < loop.size(); ++i)
      exact = std::min(exact, distance_to_edge(s.point(v), s.point(loop[i - 1]), s.point(loop[i])));
    sum += std::abs(std::abs(d[v]) - exact);
  }
  return sum / static_cast<double>(s.points.size());
}

TEST(Signed_heat_distance, flows_for_a_time_of_the_distance_of_its_nodes) {
  // 0.13 to 0.22 for 60 seeds; with the mean length of edges in place of half of it 0.22 to 0.38
  double sum = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) sum += mean_error_of_loop(seed) / 5;
  EXPECT_LT(sum, 0.22);
}

TEST(Signed_heat_distance, from_a_straight_polyline_through_faces_is_that_from_its_line) {
  const Shape s = rough_grid(16, 0.2, 0, 11);
  const Exact t = delaunay<Exact>(s.input());
  const std::uint32_t from = 5, to = 17 * 16 + 9; // on opposite sides
  const IT::Shortest_path path = IT::Polyhedral_distance(t, IT::vertex_of_row(t, from))
                                     .shortest_path(IT::vertex_of_row(t, to));
  ASSERT_GT(path.points.size(), 10U);
  const Eigen::VectorXd d = IT::Signed_heat_distance(t).distances(IT::Polyline_source{path.points});
  const Eigen::Vector3d along = (s.point(to) - s.point(from)).normalized();
  for (std::uint32_t v = 0; v < s.points.size(); ++v) {
    const Eigen::Vector3d x = s.point(v) - s.point(from);
    EXPECT_NEAR(d[v], x.x() * along.y() - x.y() * along.x(), 0.3) << "right of the line: positive";
  }
  EXPECT_NEAR(d[from], 0, 1e-13);
  EXPECT_NEAR(d[to], 0, 1e-12);
}

// Its Laplacian has no entries for diagonals, which the order of edges must not miss: it took
// minutes and all memory.
TEST(Signed_heat_distance, from_a_side_of_a_large_grid_of_right_angles_is_exact) {
  const int n = 200;
  const Shape s = grid(n);
  const Exact t(s.input());
  std::vector<typename Exact::halfedge_descriptor> side;
  for (const auto h : halfedges(t.mesh())) {
    const auto i = t.input_vertex(source(h, t.mesh())), j = t.input_vertex(target(h, t.mesh()));
    if (s.point(i).y() == 0 && s.point(j).y() == 0 && s.point(i).x() < s.point(j).x())
      side.push_back(h);
  }
  const Eigen::VectorXd d = IT::Signed_heat_distance(t).distances(side);
  for (std::uint32_t v = 0; v < s.points.size(); ++v) EXPECT_NEAR(d[v], -s.point(v).y(), 1e-6);
}

TEST(Signed_heat_distance, ends_when_the_visitor_says_so) {
  struct Visitor {
    IT::Heat_step last;
    bool progress(IT::Heat_step step) { return step != last; }
  };
  const Exact t(grid(2).input());
  for (const IT::Heat_step last : {IT::Heat_step::heat_factored, IT::Heat_step::heat_found}) {
    IT::Signed_heat_distance d(t, IT::parameters::visitor(Visitor{last}));
    EXPECT_EQ(d.distances(*halfedges(t.mesh()).begin()).size(), 0);
    EXPECT_EQ(d.status(), IT::Status::cancelled);
  }
}

TEST(Signed_heat_distance, is_infinite_where_there_is_no_curve_and_refuses_what_has_no_sides) {
  Shape s = grid(2);
  s.points.push_back({9, 9, 9});
  const Exact t(s.input());
  IT::Signed_heat_distance signed_distance(t);
  const Eigen::VectorXd d = signed_distance.distances(halfedge_between(t, 1, 4));
  EXPECT_EQ(d[9], std::numeric_limits<double>::infinity());
  EXPECT_TRUE(d.head(9).allFinite());
  EXPECT_THROW(signed_distance.distances(*vertices(t.mesh()).begin()), std::invalid_argument);
  const IT::Surface_point inside{0, {0.25, 0.25, 0.5}};
  EXPECT_THROW(signed_distance.distances(inside), std::invalid_argument);
  for (const double factor : {-1., 1e-300, 1e300})
    EXPECT_THROW(IT::Signed_heat_distance(t, IT::parameters::time_factor(factor)),
                 std::invalid_argument);
  const Exact cover(
      IT::make_domain(soups::soup({s.points, s.triangles}), IT::Domain_kind::tufted_cover).input);
  EXPECT_THROW(IT::Signed_heat_distance{cover}, IT::Invalid_input);
}

TEST(Signed_heat_distance, is_finite_on_every_complex_of_the_gallery) {
  for (const gallery::Surface& surface : gallery::oriented()) {
    if (surface.expected.faces == 0) continue;
    const Exact t(input(surface));
    IT::Signed_heat_distance signed_distance(t);
    for (const auto h : halfedges(t.mesh()))
      for (const double x : signed_distance.distances(h)) EXPECT_FALSE(std::isnan(x)) << surface;
  }
}

Eigen::VectorXcd constant_field(const Exact& t, const Shape& s, Complex direction) {
  Eigen::VectorXcd x(num_edges(t.mesh()));
  for (const auto e : edges(t.mesh())) {
    const auto h = t.numbers().halfedge_at(2 * t.index(e));
    const Eigen::Vector3d along = (s.point(t.input_vertex(target(h, t.mesh()))) -
                                   s.point(t.input_vertex(source(h, t.mesh()))))
                                      .normalized();
    x[t.index(e)] = direction * std::conj(Complex(along.x(), along.y()));
  }
  return x;
}

TEST(Edge_connection_laplacian, has_constant_fields_of_the_plane_in_its_kernel) {
  const Shape s = rough_grid(7, 0.3, 0, 5);
  const Exact t(s.input());
  const Eigen::SparseMatrix<Complex> l = IT::edge_connection_laplacian(t);
  const Eigen::VectorXcd x = constant_field(t, s, {0.6, 0.8});
  EXPECT_LE((l * x).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Edge_connection_laplacian, is_hermitian_and_definite_up_to_parallel_fields) {
  for (const gallery::Surface& surface : gallery::oriented()) {
    if (surface.expected.faces == 0) continue;
    const Exact t(input(surface));
    const Eigen::MatrixXcd l(IT::edge_connection_laplacian(t));
    EXPECT_LE((l - l.adjoint()).norm(), 1e-14 * l.norm()) << surface;
    const Eigen::VectorXd values = dense_eigenvalues(l);
    EXPECT_GE(values[0], -1e-12 * (1 + l.norm())) << surface;
  }
  // an octahedron has curvature, and no parallel field; a flat torus has one
  const Eigen::MatrixXcd flat(IT::edge_connection_laplacian(Exact(torus(3, 0.2))));
  EXPECT_NEAR(dense_eigenvalues(flat)[0], 0, 1e-12);
  const Eigen::MatrixXcd curved(IT::edge_connection_laplacian(Exact(tetrahedron().input())));
  EXPECT_GT(dense_eigenvalues(curved)[0], 0.1);
}

TEST(Edge_connection_laplacian, is_the_energy_of_linear_fields) {
  // v(x, y) = (a x + b y) + i (c x + d y) in the plane: the integral of its squared gradient
  const Shape s = rough_grid(6, 0.3, 0, 2);
  const Exact t(s.input());
  Eigen::VectorXcd x = constant_field(t, s, 1);
  for (const auto e : edges(t.mesh())) {
    const auto h = halfedge(e, t.mesh());
    const Eigen::Vector3d middle = (s.point(t.input_vertex(source(h, t.mesh()))) +
                                    s.point(t.input_vertex(target(h, t.mesh())))) /
                                   2;
    x[t.index(e)] *= Complex(2 * middle.x() - middle.y(), 0.5 * middle.x() + 3 * middle.y());
  }
  double area = 0;
  for (const auto f : faces(t.mesh())) area += t.area(f);
  const Eigen::VectorXcd lx = IT::edge_connection_laplacian(t) * x;
  EXPECT_NEAR(std::real(Complex(x.dot(lx))) / area, 4 + 1 + 0.25 + 9, 1e-11);
}

} // namespace
