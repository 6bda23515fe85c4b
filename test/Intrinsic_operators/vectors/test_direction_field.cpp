// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/vectors/direction_field.h>
#include <CGAL/Intrinsic_operators/vectors/field_singularities.h>
#include <CGAL/Intrinsic_operators/vectors/principal_directions.h>

#include <CGAL/Intrinsic_operators/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/vector_field.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include "Following.h"
#include "copies.h"
#include "delaunay.h"
#include "dense_eigenvalues.h"
#include "gallery.h"
#include "mesh_types.h"
#include "meshes.h"
#include "named_inputs.h"
#include "operator_test_meshes.h"
#include "soups.h"
#include "surface_mesh.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Complex = std::complex<double>;
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                          IT::Integer_coordinates>;
using Fixed = std::vector<std::pair<Exact::vertex_descriptor, Complex>>;
constexpr double pi = std::numbers::pi;

/// V - E + F, without isolated vertices, with one vertex per fan.
std::ptrdiff_t characteristic(const Exact& t) {
  const auto edges_there = edges(t.mesh());
  const auto faces_there = faces(t.mesh());
  const std::vector<std::uint32_t> umbrellas = IT::umbrellas(t.mesh());
  return std::accumulate(umbrellas.begin(), umbrellas.end(), std::ptrdiff_t{0}) -
         std::distance(edges_there.begin(), edges_there.end()) +
         std::distance(faces_there.begin(), faces_there.end());
}

void expect_exact_sum(const Exact& t, const IT::Direction_field& field, const std::string& name) {
  const auto s = IT::singularities(t, field);
  std::ptrdiff_t border = 0;
  for (const auto& [h, turns] : s.turns) border += turns;
  EXPECT_EQ(s.turns.size(), IT::boundary_loops(t.mesh()).size()) << name;
  EXPECT_EQ(s.sum(), field.degree * characteristic(t) + border) << name << ' ' << field.degree;
}

TEST(Singularities, of_any_field_sum_up_to_the_euler_characteristic_and_the_turns_of_the_border) {
  std::mt19937 random(3);
  for (operator_test::Named_input& n : operator_test::named_inputs())
    for (const bool is_flipped : {false, true}) {
      Exact t{IT::Intrinsic_input(n.input)};
      if (is_flipped) IT::flip_to_delaunay(t);
      if (is_flipped && t.input().names().sheets == 1 && num_faces(t.mesh()) > 20)
        IT::delaunay_refine(t, IT::parameters::minimum_angle(25).maximum_insertions(30));
      const std::size_t size = IT::Vertex_copies(t).size();
      for (const int degree : {1, 2, 3, 4, 6}) {
        IT::Direction_field field{degree, std::vector<Complex>(size)};
        for (Complex& z : field.powers)
          z = std::polar(1., static_cast<double>(random() % 1000) / 500 * pi);
        expect_exact_sum(t, field, n.name);
        for (Complex& z : field.powers) // ties: angles of 0, pi / 2, pi
          z = std::array<Complex, 4>{1, -1, Complex(0, 1), Complex(0, -1)}[random() % 4];
        expect_exact_sum(t, field, n.name);
        field.powers.assign(size, 0);
        expect_exact_sum(t, field, n.name);
      }
    }
}

TEST(Smoothest_direction_field, exists_everywhere_with_the_right_sum_of_indices) {
  for (operator_test::Named_input& n : operator_test::named_inputs()) {
    Exact t = delaunay<Exact>(IT::Intrinsic_input(n.input));
    for (const int degree : {1, 2, 4}) {
      const IT::Direction_field field = IT::smoothest_direction_field(t, degree);
      const IT::Vertex_copies copies(t);
      ASSERT_EQ(field.powers.size(), copies.size());
      for (const auto v : vertices(t.mesh()))
        EXPECT_NEAR(std::abs(field.powers[copies(v)]), copies_test::is_isolated(t, v) ? 0 : 1,
                    1e-12);
      expect_exact_sum(t, field, n.name);
    }
  }
}

/// On a round sphere the fields of least energy are those of least number of zeros.
TEST(Smoothest_direction_field, of_a_sphere_has_the_least_number_of_singularities) {
  Exact t = delaunay<Exact>(meshes::sphere(4).input());
  for (const int degree : {1, 2, 4}) {
    const auto s = IT::singularities(t, IT::smoothest_direction_field(t, degree));
    int positive = 0, others = 0;
    for (const int i : s.index) (i == 1 ? positive : others) += i == 0 ? 0 : 1;
    EXPECT_EQ(positive, 2 * degree);
    EXPECT_EQ(others, 0);
  }
}

TEST(Smoothest_direction_field, of_a_flat_torus_is_parallel_and_keeps_a_fixed_direction) {
  const Exact t = delaunay<Exact>(operator_test::torus(6, 0.3));
  const std::vector<Complex> r = IT::transport_along_halfedges(t);
  const auto expect_parallel = [&](const IT::Direction_field& field, double error) {
    for (const auto h : halfedges(t.mesh())) {
      const Complex z = field.powers[t.input_vertex(source(h, t.mesh()))] *
                        std::pow(r[t.numbers().halfedge(h)], field.degree);
      EXPECT_LE(std::abs(z - field.powers[t.input_vertex(target(h, t.mesh()))]), error);
    }
  };
  for (const int degree : {1, 3, 4})
    expect_parallel(IT::smoothest_direction_field(t, degree), 1e-6);
  const auto v = t.numbers().vertex_at(7);
  const IT::Direction_field field = IT::smoothest_direction_field(t, 4, Fixed{{v, {2, 1}}});
  const Complex expected = std::pow(Complex(2, 1) / std::sqrt(5.), 4);
  EXPECT_LE(std::abs(field.powers[t.input_vertex(v)] - expected), 1e-12);
  expect_parallel(field, 1e-5);
}

/// The eigenvalue is zero, which an iteration sees as that of its shift.
TEST(Smoothest_direction_field, of_a_flat_grid_is_parallel_by_iteration) {
  const Exact t = delaunay<Exact>(meshes::grid(60, 60).input());
  const auto found = IT::smoothest_direction_field(t, 4, {}, IT::Linear_solver::iterative).powers;
  const auto expected = IT::smoothest_direction_field(t, 4, {}, IT::Linear_solver::direct).powers;
  for (std::size_t v = 0; v < found.size(); ++v)
    EXPECT_LE(std::abs(found[v] / found[0] - expected[v] / expected[0]), 1e-6) << v;
}

/// Against a dense eigenvector of the generalized problem.
TEST(Smoothest_direction_field, is_the_smallest_eigenvector) {
  Exact t = delaunay<Exact>(meshes::potato(2, 6).input());
  for (const int degree : {1, 4}) {
    const Eigen::MatrixXcd l = IT::connection_laplacian(t, degree),
                           m = Eigen::MatrixXd(IT::lumped_mass_matrix(t)).cast<Complex>();
    const Eigen::VectorXcd expected = dense_eigenpairs(l, m).vectors.col(0);
    const IT::Direction_field field = IT::smoothest_direction_field(t, degree);
    const Complex phase = field.powers[0] / (expected[0] / std::abs(expected[0]));
    for (Eigen::Index i = 0; i < expected.size(); ++i)
      EXPECT_LE(std::abs(field.powers[static_cast<std::size_t>(i)] -
                         phase * expected[i] / std::abs(expected[i])),
                1e-4);
  }
}

TEST(Aligned_direction_field, is_the_guide_if_that_is_strong_and_smooth_if_it_is_weak) {
  Exact t = delaunay<Exact>(meshes::potato(2, 6).input());
  IT::Tangent_field guide(t.number_of_vertices());
  std::mt19937 random(5);
  for (Complex& z : guide) z = std::polar(3., static_cast<double>(random() % 1000));
  const IT::Direction_field near = IT::aligned_direction_field(t, 4, guide, 1e6);
  for (std::size_t i = 0; i < guide.size(); ++i)
    EXPECT_LE(std::abs(near.powers[i] - std::pow(guide[i] / 3., 4)), 1e-3);
  const auto energy = [&](const IT::Direction_field& f) {
    const Eigen::Map<const Eigen::VectorXcd> z(f.powers.data(),
                                               static_cast<Eigen::Index>(f.powers.size()));
    return z.dot(IT::connection_laplacian(t, 4) * z).real();
  };
  const IT::Direction_field smooth = IT::aligned_direction_field(t, 4, guide, 0.1);
  EXPECT_LT(energy(smooth), 0.5 * energy(near));
  expect_exact_sum(t, near, "near");
  expect_exact_sum(t, smooth, "smooth");
}

/// Around a disk, crosses that follow the border do not turn relative to it: the indices inside sum up to 4.
TEST(Fixed_directions, along_the_border_of_a_disk_leave_the_whole_characteristic_inside) {
  Exact t = delaunay<Exact>(meshes::rough_grid(8, 4).input());
  std::vector<Exact::halfedge_descriptor> border;
  const auto start = IT::boundary_loops(t.mesh()).front();
  auto h = start;
  do { // in the direction of the border halfedges
    border.push_back(h);
    h = next(h, t.mesh());
  } while (h != start);
  for (const int degree : {1, 2, 4}) {
    const auto directions = IT::directions_along_path(t, border);
    EXPECT_EQ(directions.size(), border.size());
    const auto s = IT::singularities(t, IT::smoothest_direction_field(t, degree, directions));
    ASSERT_EQ(s.turns.size(), 1U);
    EXPECT_EQ(s.turns[0].second, 0);
    EXPECT_EQ(s.sum(), degree);
  }
}

TEST(Fixed_directions,
     along_an_edge_path_are_those_of_its_edges_at_the_ends_and_between_them_inside) {
  Exact t(meshes::grid(6, 6).input());
  const auto at = [&t](std::uint32_t i) { return t.numbers().vertex_at(i); };
  std::vector<Exact::halfedge_descriptor> path; // along a straight row inside
  for (std::uint32_t i = 22; i < 26; ++i)
    for (const auto g : halfedges(t.mesh()))
      if (source(g, t.mesh()) == at(i) && target(g, t.mesh()) == at(i + 1)) path.push_back(g);
  ASSERT_EQ(path.size(), 4U);
  const auto directions = IT::directions_along_path(t, path);
  ASSERT_EQ(directions.size(), 5U);
  const std::vector<Complex> r = IT::transport_along_halfedges(t);
  for (std::size_t i = 0; i < path.size(); ++i) // straight: parallel
    EXPECT_LE(std::abs(directions[i].second * r[t.numbers().halfedge(path[i])] -
                       directions[i + 1].second),
              1e-12);
}

/// Around a cylinder, along its circles; in between, a guided field of crosses follows circles and rulings.
TEST(Principal_directions, of_a_cylinder_are_those_of_its_circles) {
  const std::uint32_t n = 24, rings = 8;
  meshes::Mesh shape;
  for (std::uint32_t r = 0; r <= rings; ++r)
    for (std::uint32_t i = 0; i < n; ++i) {
      const double a = 2 * pi * (i + 0.5 * r) / n;
      shape.points.push_back({2 * std::cos(a), 2 * std::sin(a), 0.5 * r});
    }
  for (std::uint32_t r = 0; r < rings; ++r)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = n * r + i, b = n * r + (i + 1) % n;
      shape.triangles.push_back({a, b, a + n});
      shape.triangles.push_back({b, b + n, a + n});
    }
  const Surface_mesh mesh = meshes::surface_mesh<Surface_mesh>(shape);
  Exact t(mesh);
  IT::delaunay_refine(t, IT::parameters::maximum_circumradius(0.2));
  const IT::Tangent_field guide = IT::principal_directions(t, mesh);
  EXPECT_EQ(guide, IT::principal_directions(t, shape.points));
  EXPECT_THROW(IT::principal_directions(t, std::vector<std::array<double, 3>>(5)),
               std::invalid_argument);
  const auto in_space = IT::vectors_in_space(t, guide, mesh);
  const IT::Direction_field crosses = IT::aligned_direction_field(t, 4, guide);
  const auto arms = IT::vectors_in_space(t, crosses.directions(), mesh);
  std::size_t inserted = 0;
  for (const auto v : vertices(t.mesh())) {
    const std::uint32_t i = t.input_vertex(v);
    if (t.is_inserted(v)) {
      ++inserted;
      EXPECT_EQ(guide[i], 0.);
    } else if (i >= n && i < n * rings) {          // inside
      EXPECT_NEAR(std::abs(guide[i]), 0.25, 0.05); // curvatures 1/2 and 0
      EXPECT_NEAR(in_space[i][2], 0, 0.02 * std::abs(guide[i]));
    }
    const double up = std::abs(arms[i][2]);
    EXPECT_TRUE(up < 0.1 || up > 0.99) << up;
  }
  EXPECT_GT(inserted, 20U);
}

TEST(Direction_fields, can_be_followed_and_cancelled) {
  Exact t = delaunay<Exact>(meshes::box(3, 3, 3).input());
  std::vector<IT::Direction_step> steps;
  const Following follow{[&](IT::Direction_step step) {
    steps.push_back(step);
    return true;
  }};
  const IT::Direction_field all =
      IT::smoothest_direction_field(t, 4, {}, IT::parameters::visitor(follow));
  EXPECT_EQ(all.status, IT::Status::done);
  EXPECT_EQ(all.powers, IT::smoothest_direction_field(t, 4).powers);
  ASSERT_FALSE(steps.empty());
  EXPECT_EQ(steps[0], IT::Direction_step::factored);
  for (std::size_t last = 0; last < steps.size(); ++last) {
    std::size_t calls = 0;
    const Following count{[&](IT::Direction_step) { return calls++ < last; }};
    const IT::Direction_field none =
        IT::smoothest_direction_field(t, 4, {}, IT::parameters::visitor(count));
    EXPECT_EQ(none.status, IT::Status::cancelled);
    EXPECT_TRUE(none.powers.empty());
    EXPECT_EQ(calls, last + 1);
  }
  const IT::Tangent_field guide(all.powers.size(), 1);
  const auto stop = IT::parameters::visitor(Following{[](IT::Direction_step) { return false; }});
  EXPECT_EQ(IT::aligned_direction_field(t, 4, guide, 1, {}, stop).status, IT::Status::cancelled);
}

TEST(Direction_fields, refuse_what_they_cannot_do) {
  Exact t(meshes::box(1, 1, 1).input());
  const auto v = t.numbers().vertex_at(0);
  EXPECT_THROW(IT::smoothest_direction_field(t, 0), std::invalid_argument);
  EXPECT_THROW(IT::smoothest_direction_field(t, 2, Fixed{{v, 0}}), std::invalid_argument);
  EXPECT_THROW(IT::aligned_direction_field(t, 2, IT::Tangent_field(7)), std::invalid_argument);
  EXPECT_THROW(IT::aligned_direction_field(t, 2, IT::Tangent_field(8), -1), std::invalid_argument);
  EXPECT_THROW(IT::singularities(t, IT::Direction_field{1, std::vector<Complex>(7)}),
               std::invalid_argument);
}

template <class Mesh>
class Direction_field_on : public testing::Test {};
using Direction_meshes = testing::Types<Surface_mesh, Polyhedron, OpenMesh_polygons>;
TYPED_TEST_SUITE(Direction_field_on, Direction_meshes);

/// Whatever the mesh type and arithmetic, the same faces are singular.
TYPED_TEST(Direction_field_on, has_the_same_singular_faces_for_all_mesh_types) {
  const operator_test::Shape shape = operator_test::rough_torus(9, 0.3, 1);
  Exact t(shape.input());
  IT::Intrinsic_triangulation<TypeParam, IT::Euclidean_traits<double>> u(
      operator_test::mesh_of<Surface_mesh>(shape));
  IT::flip_to_delaunay(t);
  IT::flip_to_delaunay(u);
  const auto a = IT::singularities(t, IT::smoothest_direction_field(t, 4));
  const auto b = IT::singularities(u, IT::smoothest_direction_field(u, 4));
  std::vector<std::vector<std::uint32_t>> faces_a, faces_b;
  const auto collect = [](const auto& triangulation, const auto& s, auto& result) {
    for (const auto f : faces(triangulation.mesh())) {
      if (s.index[triangulation.index(f)] == 0) continue;
      std::vector<std::uint32_t> corners;
      auto h = halfedge(f, triangulation.mesh());
      for (int k = 0; k < 3; ++k, h = next(h, triangulation.mesh()))
        corners.push_back(triangulation.input_vertex(target(h, triangulation.mesh())));
      std::sort(corners.begin(), corners.end());
      corners.push_back(static_cast<std::uint32_t>(s.index[triangulation.index(f)] + 100));
      result.push_back(corners);
    }
    std::sort(result.begin(), result.end());
  };
  collect(t, a, faces_a);
  collect(u, b, faces_b);
  EXPECT_EQ(faces_a, faces_b);
  EXPECT_EQ(a.sum(), 0);
}

} // namespace
