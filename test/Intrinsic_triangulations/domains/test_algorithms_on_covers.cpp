// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "soups.h"

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/read_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/write_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_triangulations/geodesics/queries/Geodesic_finder.h>
#include <CGAL/Intrinsic_triangulations/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulations/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulations/operators/solve_with_fixed_values.h>
#include <CGAL/Intrinsic_triangulations/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_triangulations/operators/transfer.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/is_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// That a cover is a surface like any other: nothing here knows of covers but the rows of matrices.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Domain_kind;
using meshes::Mesh;
template <class Correspondence>
using Exact =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Correspondence>;
using Integer = Exact<IT::Integer_coordinates>;

std::vector<std::pair<std::string, Mesh>> soups_of_all_kinds() {
  return {{"fins", soups::three_fins()},
          {"Moebius strip", soups::moebius_strip()},
          {"Klein bottle", soups::klein_bottle()},
          {"projective plane", soups::projective_plane()},
          {"random soup", soups::random(9, 30, 5)},
          {"grid", meshes::grid(4, 3)}};
}

template <class Triangulation>
Triangulation delaunay(const Mesh& m, Domain_kind kind = Domain_kind::tufted_cover) {
  Triangulation t(IT::make_domain(soups::soup(m), kind).input);
  IT::flip_to_delaunay(t);
  return t;
}

double area(const Mesh& m) {
  double sum = 0;
  for (const auto& [i, j, k] : m.triangles) {
    const auto &p = m.points[i], &q = m.points[j], &r = m.points[k];
    meshes::Point n{};
    for (unsigned c = 0; c < 3; ++c) {
      const unsigned d = (c + 1) % 3, e = (c + 2) % 3;
      n[c] = (q[d] - p[d]) * (r[e] - p[e]) - (q[e] - p[e]) * (r[d] - p[d]);
    }
    sum += std::hypot(n[0], n[1], n[2]) / 2;
  }
  return sum;
}

template <class Triangulation>
void expect_subdivision(const Mesh& m, const std::string& name) {
  const auto t = delaunay<Triangulation>(m);
  const IT::Common_subdivision s = IT::common_subdivision(t);
  const std::vector<meshes::Point> points = IT::positions(s, std::span(m.points));
  double sum = 0;
  for (const double a : IT::subdivision_areas(t, s)) sum += a;
  EXPECT_NEAR(sum, 2 * area(m), 1e-9 * area(m)) << name;
  // each face lies in the face of the soup that it is said to lie in, on one side of it
  double in_space = 0;
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    const auto& corners = m.triangles[t.input().names().polygon_of_triangle[s.input_face[f]]];
    Mesh cell{points, {}};
    const auto face = s.face(f);
    for (std::size_t k = 2; k < face.size(); ++k)
      cell.triangles.push_back({face[0], face[k - 1], face[k]});
    in_space += area(cell);
    for (const std::uint32_t v : face) {
      double parts = 0;
      for (unsigned k = 0; k < 3; ++k) {
        Mesh part{m.points, {{corners[k], corners[(k + 1) % 3], 0}}};
        part.points.push_back(points[v]);
        part.triangles[0][2] = static_cast<std::uint32_t>(m.points.size());
        parts += area(part);
      }
      const double whole = area({m.points, {corners}});
      EXPECT_NEAR(parts, whole, 1e-9 * area(m)) << name;
    }
  }
  EXPECT_NEAR(in_space, 2 * area(m), 1e-9 * area(m)) << name;
}

TEST(Cover, has_a_common_subdivision_over_both_sides_of_every_face) {
  for (const auto& [name, m] : soups_of_all_kinds()) {
    expect_subdivision<Integer>(m, name);
    expect_subdivision<Exact<IT::Explicit_crossings>>(m, name);
    expect_subdivision<Exact<IT::Signposts>>(m, name);
  }
}

TEST(Cover, has_mass_matrices_of_rows_by_way_of_its_subdivision) {
  for (const auto& [name, m] : soups_of_all_kinds()) {
    const auto t = delaunay<Integer>(m);
    const IT::Common_subdivision s = IT::common_subdivision(t);
    const Eigen::SparseMatrix<double> p = IT::interpolation_from_intrinsic(s);
    const Eigen::SparseMatrix<double> mass = IT::subdivision_mass_matrix(t, s),
                                      product = p.transpose() * mass * p;
    const Eigen::SparseMatrix<double> direct = IT::galerkin_mass_matrix(t);
    ASSERT_EQ(product.rows(), direct.rows()) << name;
    EXPECT_LE((product - direct).norm(), 1e-10 * direct.norm()) << name;
  }
}

TEST(Cover, transfers_linear_functions_of_a_flat_soup) {
  const Mesh m = meshes::sheared_grid(4, 3, 1.5);
  const auto t = delaunay<Integer>(m);
  const IT::Common_subdivision s = IT::common_subdivision(t);
  Eigen::VectorXd x(static_cast<int>(m.points.size()));
  for (std::size_t v = 0; v < m.points.size(); ++v)
    x[static_cast<int>(v)] = m.points[v][0] - 2 * m.points[v][1];
  EXPECT_LE(IT::L2_distance(t, s, Eigen::VectorXd::Ones(x.size()), Eigen::VectorXd::Zero(x.size())),
            std::sqrt(area(m)) * (1 + 1e-12));
  const IT::L2_transfer to_input(t, s);
  EXPECT_EQ(to_input(x).size(), x.size());
}

TEST(Cover, is_refined_to_25_degrees) {
  for (const auto& [name, m] : soups_of_all_kinds()) {
    auto t = delaunay<Integer>(m);
    const auto r = IT::delaunay_refine(t, IT::parameters::minimum_angle(25));
    EXPECT_EQ(r.status, IT::Status::done) << name;
    EXPECT_EQ(num_vertices(t.mesh()), t.input().number_of_vertices() + r.counts.inserted_vertices())
        << name;
    EXPECT_TRUE(IT::is_delaunay(t)) << name;
    const Eigen::SparseMatrix<double> l = IT::cotangent_laplacian(t);
    EXPECT_EQ(l.rows(), static_cast<int>(t.number_of_vertices())) << name;
    for (int c = 0; c < l.cols(); ++c)
      for (Eigen::SparseMatrix<double>::InnerIterator i(l, c); i; ++i)
        EXPECT_TRUE(i.row() == c || i.value() <= 0) << name;
    EXPECT_NEAR(IT::lumped_mass_matrix(t).sum(), area(m), 1e-9 * area(m)) << name;
  }
}

TEST(Cover, keeps_harmonic_functions_in_the_range_of_what_is_given) {
  for (const auto& [name, m] : soups_of_all_kinds()) {
    const auto t = delaunay<Integer>(m);
    const auto n = static_cast<int>(m.points.size());
    const Eigen::SparseMatrix<double> l = IT::cotangent_laplacian(t);
    Eigen::SparseMatrix<double> a = l;
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
    // two values on the border, or anywhere
    a.coeffRef(0, 0) += 1e6 * l.diagonal().maxCoeff();
    a.coeffRef(n - 1, n - 1) += 1e6 * l.diagonal().maxCoeff();
    b[n - 1] = 1e6 * l.diagonal().maxCoeff();
    for (int v = 0; v < n; ++v)
      if (l.coeff(v, v) == 0) a.coeffRef(v, v) += 1;
    const Eigen::VectorXd u = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(a).solve(b);
    EXPECT_GE(u.minCoeff(), -1e-12) << name;
    EXPECT_LE(u.maxCoeff(), 1 + 1e-12) << name;
  }
}

TEST(Cover, has_geodesics_on_a_sheet) {
  // from corner to corner of a flat grid: straight on its sheet, whichever edges there are
  const Mesh m = meshes::grid(5, 4);
  auto t = delaunay<Integer>(m);
  const IT::Input_names& names = t.input().names();
  const std::uint32_t from = 7, to = static_cast<std::uint32_t>(m.points.size()) - 8;
  std::size_t sheets = 0;
  double shortest = 1e9, longest = 0;
  for (std::uint32_t v = 0; v < t.input().number_of_vertices(); ++v) {
    if (names.row(v) != to) continue;
    ++sheets;
    const IT::Polyhedral_distance d(t, t.numbers().vertex_at(names.vertex(from)));
    const double exact = d.distance(t.numbers().vertex_at(v));
    shortest = std::min(shortest, exact);
    longest = std::max(longest, exact);
    IT::Geodesic_finder<Integer> find(t);
    const auto path = find(t.numbers().vertex_at(names.vertex(from)), t.numbers().vertex_at(v));
    EXPECT_EQ(path.status, IT::Status::done);
    EXPECT_GE(path.length, exact * (1 - 1e-12));
  }
  EXPECT_EQ(sheets, 2U);
  const double straight =
      std::hypot(m.points[to][0] - m.points[from][0], m.points[to][1] - m.points[from][1]);
  EXPECT_NEAR(shortest, straight, 1e-12);
  EXPECT_GT(longest, straight) << "on the back, it goes around the border";
}

TEST(Cover, is_stored_with_its_rows) {
  for (const auto& [name, m] : soups_of_all_kinds()) {
    auto t = delaunay<IT::Intrinsic_triangulation<>>(m);
    std::ostringstream out;
    IT::write_intrinsic_triangulation(out, t);
    std::istringstream in(out.str());
    const auto back = IT::read_intrinsic_triangulation<IT::Intrinsic_triangulation<>>(in, "file");
    EXPECT_EQ(back.input().names().sheets, 2U) << name;
    EXPECT_EQ(back.number_of_vertices(), m.points.size()) << name;
    const Eigen::SparseMatrix<double> difference =
        IT::cotangent_laplacian(t) - IT::cotangent_laplacian(back);
    EXPECT_EQ(difference.norm(), 0) << name;
    std::ostringstream again;
    IT::write_intrinsic_triangulation(again, back);
    EXPECT_EQ(again.str(), out.str()) << name;
  }
}

TEST(Cover, is_renumbered_and_keeps_its_rows) {
  const Mesh tidy = meshes::rough_grid(200, 5);
  const Mesh m = meshes::permuted(tidy, meshes::permutation(tidy.points.size(), 11), 12);
  const auto t = delaunay<IT::Intrinsic_triangulation<>>(m);
  ASSERT_TRUE(t.report().renumbered);
  IT::Domain d = IT::make_domain(soups::soup(m), Domain_kind::tufted_cover);
  d.input.may_renumber = false;
  IT::Intrinsic_triangulation<> u(std::move(d.input));
  IT::flip_to_delaunay(u);
  const Eigen::SparseMatrix<double> l = IT::cotangent_laplacian(t);
  const Eigen::SparseMatrix<double> difference = l - IT::cotangent_laplacian(u);
  EXPECT_LE(difference.norm(), 1e-11 * l.norm());
}

} // namespace
