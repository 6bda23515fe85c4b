// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/connection_laplacian.h>

#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include "copies.h"
#include "delaunay.h"
#include "dense_eigenvalues.h"
#include "gallery.h"
#include "mesh_types.h"
#include "meshes.h"
#include "named_inputs.h"
#include "operator_test_meshes.h"
#include "soups.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Complex = std::complex<double>;
using Complex_matrix = Eigen::SparseMatrix<Complex>;
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                          IT::Integer_coordinates>;
constexpr double pi = std::numbers::pi;

Eigen::VectorXd eigenvalues_of(const Complex_matrix& l) {
  return dense_eigenvalues(Eigen::MatrixXcd(l));
}

double largest(const Complex_matrix& m) {
  double r = 0;
  for (int c = 0; c < m.outerSize(); ++c)
    for (Complex_matrix::InnerIterator i(m, c); i; ++i) r = std::max(r, std::abs(i.value()));
  return r;
}

TEST(Connection_laplacian, is_hermitian_and_positive_semidefinite_everywhere) {
  for (operator_test::Named_input& n : operator_test::named_inputs())
    for (const int order : {1, 2, 4, 6}) {
      Exact t = delaunay<Exact>(IT::Intrinsic_input(n.input));
      const Complex_matrix l = IT::connection_laplacian(t, order);
      const Complex_matrix difference = l - Complex_matrix(l.adjoint());
      EXPECT_EQ(difference.norm(), 0) << n.name;
      EXPECT_GE(eigenvalues_of(l)[0], -1e-12 * largest(l)) << n.name << ' ' << order;
    }
}

TEST(Connection_laplacian, of_order_zero_is_that_of_functions) {
  for (const meshes::Mesh& m : {meshes::box(2, 3, 2), meshes::potato(2, 5)}) {
    Exact t = delaunay<Exact>(m.input());
    const Eigen::MatrixXcd zero = IT::connection_laplacian(t, 0);
    const Eigen::MatrixXd functions = IT::cotangent_laplacian(t);
    EXPECT_LE((zero - functions.cast<Complex>()).norm(), 1e-12 * functions.norm());
  }
}

/// The energy of a field edge by edge, with transports by halfedge.
TEST(Connection_laplacian, is_the_energy_that_its_page_says_with_loops_and_insertions) {
  for (operator_test::Named_input& n : operator_test::named_inputs()) {
    Exact t = delaunay<Exact>(IT::Intrinsic_input(n.input));
    if (t.input().names().sheets == 1 && num_faces(t.mesh()) > 20)
      IT::delaunay_refine(t, IT::parameters::minimum_angle(25).maximum_insertions(30));
    const Complex_matrix l = IT::connection_laplacian(t, 2);
    const std::vector<Complex> r = IT::transport_along_halfedges(t);
    const IT::Vertex_copies copies(t);
    ASSERT_EQ(l.rows(), static_cast<Eigen::Index>(copies.size()));
    Eigen::VectorXcd z(l.rows());
    z.real() = operator_test::random_vector(l.rows(), 1);
    z.imag() = operator_test::random_vector(l.rows(), 2);
    double sum = 0;
    for (const auto e : edges(t.mesh())) {
      const auto h = halfedge(e, t.mesh());
      const Complex turn = r[t.numbers().halfedge(h)];
      const double w = IT::cotangent_weight(t, e);
      if (w > 0)
        sum += w * std::norm(z[copies(target(h, t.mesh()))] -
                             turn * turn * z[copies(source(h, t.mesh()))]);
    }
    const Complex energy = z.dot(l * z);
    EXPECT_NEAR(energy.real(), sum, 1e-9 * sum + 1e-12) << n.name;
  }
}

TEST(Parallel_transport, turns_around_a_face_by_its_excess_of_scaled_angles) {
  for (operator_test::Named_input& n : operator_test::named_inputs()) {
    Exact t = delaunay<Exact>(IT::Intrinsic_input(n.input));
    const auto& mesh = t.mesh();
    const std::vector<Complex> r = IT::transport_along_halfedges(t);
    const IT::Intrinsic_view<Exact> view(t);
    for (const auto f : faces(mesh)) {
      Complex around = 1;
      double excess = -pi;
      auto h = halfedge(f, mesh);
      for (int k = 0; k < 3; ++k, h = next(h, mesh)) {
        const std::uint32_t i = t.numbers().halfedge(h);
        around *= r[i];
        bool is_on_border = false;
        const double all = IT::cone_angle(view, i, is_on_border);
        excess += IT::angle_at_source(view, i) * (is_on_border ? 1 : 2) * pi / all;
      }
      EXPECT_LE(std::abs(around - std::polar(1., excess)), 1e-9) << n.name;
    }
  }
}

/// Across the edges around a vertex, in unscaled angles about the others: the defect of the cone.
TEST(Parallel_transport, around_the_tip_of_a_cone_turns_by_its_defect) {
  // a pyramid of k sides whose border is far from flat, inside a ring of flat angles: all curvature is at the tip
  for (const std::uint32_t sides : {3U, 4U, 5U, 7U}) {
    IT::Gluing_map mesh{gallery::disc_fan(sides).gluing};
    std::vector<double> squared(mesh.number_of_edges(),
                                1); // equilateral: the total angle is sides pi / 3
    Exact t(IT::Intrinsic_input(std::move(mesh), std::move(squared)));
    const std::vector<Complex> r = IT::transport_along_halfedges(t);
    // along the border vectors keep their angle with it, which turns by the geodesic curvature
    Complex around = 1;
    double curvature = 0;
    for (const auto h : halfedges(t.mesh()))
      if (face(h, t.mesh()) == boost::graph_traits<IT::Gluing_map>::null_face()) {
        around *= r[t.numbers().halfedge(opposite(h, t.mesh()))];
        curvature += IT::gaussian_curvature(t, target(h, t.mesh()));
      }
    EXPECT_LE(std::abs(around - 1.), 1e-12);
    // Gauss and Bonnet: the rest of a full turn is the defect of the tip
    EXPECT_NEAR(2 * pi - curvature, 2 * pi - sides * pi / 3, 1e-12);
  }
}

TEST(Connection_laplacian,
     of_a_flat_torus_has_the_eigenvalues_of_functions_whatever_the_triangulation) {
  for (const double shear : {0., 0.3, 2.2}) {
    Exact t = delaunay<Exact>(operator_test::torus(5, shear));
    const Eigen::VectorXd functions = operator_test::eigenvalues(IT::cotangent_laplacian(t));
    for (const int order : {1, 3, 4})
      EXPECT_LE((eigenvalues_of(IT::connection_laplacian(t, order)) - functions).norm(), 1e-10);
  }
}

/// Ties of faces on a circle may be broken either way.
TEST(Connection_laplacian, does_not_depend_on_the_delaunay_triangulation) {
  Exact t = delaunay<Exact>(meshes::box(2, 3, 2).input());
  const Eigen::VectorXd before = eigenvalues_of(IT::connection_laplacian(t, 4));
  std::size_t flips = 0;
  for (const auto e : edges(t.mesh()))
    if (IT::cotangent_weight(t, e) == 0 &&
        t.flip_edge(halfedge(e, t.mesh())) == IT::Move_status::done)
      ++flips;
  EXPECT_GT(flips, 10U);
  EXPECT_TRUE(IT::is_delaunay(t));
  EXPECT_LE((eigenvalues_of(IT::connection_laplacian(t, 4)) - before).norm(), 1e-10);
}

/// On the unit sphere, fields of order n have the eigenvalues l (l + 1) - n^2, 2 l + 1 times, l >= n.
TEST(Connection_laplacian, of_a_sphere_has_its_eigenvalues) {
  Exact t = delaunay<Exact>(meshes::sphere(3).input());
  const Eigen::MatrixXcd mass = Eigen::MatrixXd(IT::lumped_mass_matrix(t)).cast<Complex>();
  for (const int n : {1, 2, 4}) {
    const Eigen::VectorXd values =
        dense_eigenpairs(Eigen::MatrixXcd(IT::connection_laplacian(t, n)), mass).values;
    for (int i = 0; i < 2 * n + 1; ++i) EXPECT_NEAR(values[i], n, 0.06 * n) << i;
    const double second = (n + 1) * (n + 2) - n * n;
    for (int i = 2 * n + 1; i < 4 * n + 4; ++i) EXPECT_NEAR(values[i], second, 0.06 * second) << i;
  }
}

template <class Mesh>
class Connection_laplacian_on : public testing::Test {};
TYPED_TEST_SUITE(Connection_laplacian_on, All_meshes);

/// Frames differ between mesh types, the quadratic form does not.
TYPED_TEST(Connection_laplacian_on, has_the_same_eigenvalues_for_all_mesh_types_and_arithmetics) {
  const operator_test::Shape shape = operator_test::rough_torus(7, 0.3, 1);
  Exact t = delaunay<Exact>(shape.input());
  const Eigen::VectorXd expected = eigenvalues_of(IT::connection_laplacian(t, 4));
  const auto mesh = operator_test::mesh_of<Surface_mesh>(shape);
  IT::Intrinsic_triangulation<TypeParam, IT::Euclidean_traits<double>> u(mesh);
  IT::flip_to_delaunay(u);
  EXPECT_LE((eigenvalues_of(IT::connection_laplacian(u, 4)) - expected).norm(), 1e-9);
}

} // namespace
