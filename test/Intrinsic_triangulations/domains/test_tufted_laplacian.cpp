// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "soups.h"
#include "tufted_oracle.h"

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/signed_incidence.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/certify_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Exact = IT::Intrinsic_triangulation<>;
using Matrix = Eigen::SparseMatrix<double>;
using meshes::Mesh;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/*
A weight is right to 1e-12 (`cotangent_weight()`), of its cotangents; a diagonal entry sums as many as the vertex has
neighbours, all of one sign.
*/
constexpr double weight_error = 4e-12;

Exact delaunay(IT::Domain domain) {
  Exact t(std::move(domain.input));
  IT::flip_to_delaunay(t);
  return t;
}
Exact tufted(const Mesh& m) {
  return delaunay(IT::make_domain(soups::soup(m), IT::Domain_kind::tufted_cover));
}
Matrix tufted_laplacian(const Mesh& m) { return IT::cotangent_laplacian(tufted(m)); }

// what every tufted Laplacian is
void expect_sound(const Mesh& m, const std::string& what) {
  const Exact t = tufted(m);
  const auto report = IT::check_delaunay(t);
  EXPECT_EQ(report.non_delaunay_edges, 0U) << what;
  EXPECT_EQ(t.metric().statistics().probable_zero, 0U) << what;
  const Matrix l = IT::cotangent_laplacian(t);
  ASSERT_EQ(l.rows(), static_cast<int>(m.points.size())) << what;
  for (int c = 0; c < l.cols(); ++c) {
    double sum = 0, size = 0;
    for (Matrix::InnerIterator i(l, c); i; ++i) {
      EXPECT_EQ(i.value(), l.coeff(c, static_cast<int>(i.row())));
      if (i.row() != c) {
        EXPECT_LT(i.value(), 0) << what << ", between " << c << " and " << i.row();
      }
      sum += i.value();
      size += std::abs(i.value());
    }
    EXPECT_LE(std::abs(sum), size * epsilon * static_cast<double>(l.nonZeros())) << what;
  }
}

void expect_near(const Matrix& a, const Matrix& b, const std::string& what) {
  ASSERT_EQ(a.rows(), b.rows()) << what;
  const Matrix difference = a - b;
  for (int c = 0; c < a.cols(); ++c)
    for (Matrix::InnerIterator i(difference, c); i; ++i) {
      const double size = std::max(std::abs(a.coeff(i.row(), i.row())), std::abs(a.coeff(c, c)));
      EXPECT_LE(std::abs(i.value()), weight_error * std::max(1.0, size))
          << what << ", between " << c << " and " << i.row();
    }
}

std::vector<std::pair<std::string, Mesh>> closed_meshes() {
  return {{"box", meshes::box(2, 3, 1)},
          {"potato", meshes::potato(2, 3)},
          {"prism", meshes::prism({{0, 0}, {5, 0}, {3, 2}, {0, 4}}, 2)},
          {"cap", meshes::with_cap(meshes::potato(1, 5), 3)}};
}
std::vector<std::pair<std::string, Mesh>> bordered_meshes() {
  return {{"triangle", {{{0, 0, 0}, {7, 0, 0}, {1, 1, 0}}, {{0, 1, 2}}}},
          {"grid", meshes::grid(3, 4)},
          {"sheared grid", meshes::sheared_grid(4, 3, 2.5)},
          {"height field", meshes::integer_height_field(5, 4, 3)},
          {"terrain", meshes::integer_terrain(30, 50, 4)},
          {"walls", meshes::walls({{0, 0}, {3, 0}, {3, 2}, {1, 5}}, 3)}};
}
std::vector<std::pair<std::string, Mesh>> soups_of_all_kinds() {
  std::vector<std::pair<std::string, Mesh>> result{{"fins", soups::three_fins()},
                                                   {"Moebius strip", soups::moebius_strip()},
                                                   {"Klein bottle", soups::klein_bottle()},
                                                   {"projective plane", soups::projective_plane()}};
  for (unsigned seed = 0; seed < 12; ++seed)
    result.emplace_back("random soup " + std::to_string(seed),
                        soups::random(5 + seed, 12 + 3 * seed, seed));
  return result;
}

TEST(Tufted_laplacian, has_no_negative_weight_and_no_sum_on_any_triangles) {
  for (const auto& [name, m] : soups_of_all_kinds()) expect_sound(m, name);
  for (const auto& [name, m] : closed_meshes()) expect_sound(m, name);
  for (const auto& [name, m] : bordered_meshes()) expect_sound(m, name);
}

TEST(Tufted_laplacian, is_that_of_the_mesh_if_it_has_no_border) {
  for (const auto& [name, m] : closed_meshes())
    expect_near(IT::cotangent_laplacian(delaunay(IT::make_domain(soups::soup(m)))),
                tufted_laplacian(m), name);
}

TEST(Tufted_laplacian, is_that_of_both_sides_of_a_mesh_with_border) {
  for (const auto& [name, m] : bordered_meshes()) {
    soups::Doubled d = soups::doubled(m);
    Exact both(std::move(d.input));
    IT::flip_to_delaunay(both);
    const Matrix of_both = IT::cotangent_laplacian(both);
    std::vector<Eigen::Triplet<double>> entries;
    for (int c = 0; c < of_both.cols(); ++c)
      for (Matrix::InnerIterator i(of_both, c); i; ++i)
        entries.emplace_back(d.front[static_cast<std::size_t>(i.row())],
                             d.front[static_cast<std::size_t>(c)], i.value() / 2);
    const auto n = static_cast<int>(m.points.size());
    Matrix folded(n, n);
    folded.setFromTriplets(entries.begin(), entries.end());
    expect_near(folded, tufted_laplacian(m), name);
  }
}

TEST(Tufted_laplacian, is_what_the_definition_says_in_400_digits) {
  std::vector<std::pair<std::string, Mesh>> all{{"fins", soups::three_fins()},
                                                {"projective plane", soups::projective_plane()}};
  for (unsigned seed = 0; seed < 20; ++seed)
    all.emplace_back("random soup " + std::to_string(seed),
                     soups::random_without_repetition(5 + seed / 3, 6 + seed, seed));
  for (const auto& [name, m] : all) {
    const oracle::Answer expected = soups::tufted(m);
    Matrix l = tufted_laplacian(m);
    std::size_t weights = 0;
    for (const auto& [ij, w] : expected.laplacian) {
      const double found = -l.coeff(static_cast<int>(ij.first), static_cast<int>(ij.second));
      EXPECT_NEAR(found, w / 2, weight_error * std::max(1.0, w)) << name;
      weights += w > 1e-200 ? 1 : 0;
    }
    EXPECT_EQ(static_cast<std::size_t>(l.nonZeros()), 2 * weights + m.points.size()) << name;
  }
}

// two closed surfaces that share a vertex, one of them the wrong way round
Mesh touching() {
  Mesh m = meshes::box(2, 3, 1);
  const auto first = static_cast<std::uint32_t>(m.points.size());
  m.points.insert(m.points.end(), {{-1, -2, -7}, {-5, -1, -2}, {-2, -6, -1}});
  m.triangles.insert(m.triangles.end(), {{0, first, first + 1},
                                         {0, first + 1, first + 2},
                                         {0, first + 2, first},
                                         {first, first + 1, first + 2}});
  return m;
}

TEST(Tufted_laplacian, and_masses_are_those_of_the_surface_without_border_of_fewest_sheets) {
  const auto check = [](const std::string& name, const Mesh& m, IT::Domain_kind kind) {
    IT::Domain d = IT::make_domain(soups::soup(m), IT::Domain_kind::closed);
    EXPECT_EQ(d.report.kind, kind) << name << ": " << d.report.reason;
    EXPECT_EQ(d.report.sheets, kind == IT::Domain_kind::manifold ? 1U : 2U) << name;
    const Exact closed = delaunay(std::move(d)), both = tufted(m);
    for (const auto e : edges(closed.mesh()))
      EXPECT_FALSE(CGAL::is_border(e, closed.mesh())) << name;
    expect_near(IT::cotangent_laplacian(both), IT::cotangent_laplacian(closed), name);
    expect_near(IT::lumped_mass_matrix(both), IT::lumped_mass_matrix(closed), name);
    expect_near(IT::galerkin_mass_matrix(both), IT::galerkin_mass_matrix(closed), name);
  };
  for (const auto& [name, m] : closed_meshes()) check(name, m, IT::Domain_kind::manifold);
  check("touching", touching(), IT::Domain_kind::manifold);
  for (const auto& [name, m] : bordered_meshes()) check(name, m, IT::Domain_kind::tufted_cover);
  check("fins", soups::three_fins(), IT::Domain_kind::tufted_cover);
  check("Moebius strip", soups::moebius_strip(), IT::Domain_kind::tufted_cover);
  check("Klein bottle", soups::klein_bottle(), IT::Domain_kind::orientation_cover);
  check("projective plane", soups::projective_plane(), IT::Domain_kind::orientation_cover);
  for (unsigned seed = 0; seed < 12; ++seed) // with more than two faces at some edge
    check("random soup " + std::to_string(seed), soups::random(5 + seed, 25 + 3 * seed, seed),
          IT::Domain_kind::tufted_cover);
}

// which edge is between which vertices, and which way faces are written, makes no difference
Mesh shuffled(Mesh m, unsigned seed) {
  std::mt19937 random(seed);
  std::shuffle(m.triangles.begin(), m.triangles.end(), random);
  for (auto& t : m.triangles) {
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    if (random() % 2 == 0) std::swap(t[0], t[1]);
  }
  return m;
}

TEST(Tufted_laplacian, does_not_depend_on_the_order_and_orientation_of_faces) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const Mesh m = soups::random_without_repetition(6 + seed, 15 + 2 * seed, seed);
    const Matrix l = tufted_laplacian(m);
    expect_near(l, tufted_laplacian(shuffled(m, seed)), "random soup " + std::to_string(seed));
  }
}

TEST(Tufted_laplacian, of_faces_that_are_all_repeated_is_as_many_times_that_of_one) {
  std::vector<std::pair<std::string, Mesh>> all = bordered_meshes();
  for (unsigned seed = 0; seed < 6; ++seed)
    all.emplace_back("random soup " + std::to_string(seed),
                     soups::random_without_repetition(6 + seed, 15 + 2 * seed, seed));
  for (const auto& [name, m] : all) {
    Mesh repeated = m;
    for (int r = 1; r < 3; ++r)
      repeated.triangles.insert(repeated.triangles.end(), m.triangles.begin(), m.triangles.end());
    expect_near(3 * tufted_laplacian(m), tufted_laplacian(shuffled(repeated, 1)), name);
  }
}

TEST(Tufted_laplacian, of_a_mirrored_soup_is_the_same) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Mesh m = soups::random_without_repetition(6 + seed, 15 + 2 * seed, seed);
    expect_near(tufted_laplacian(m), tufted_laplacian(meshes::mirrored(m)),
                "random soup " + std::to_string(seed));
  }
}

TEST(Tufted_laplacian, of_a_right_triangle_has_no_weight_across_its_hypotenuse) {
  const Exact t = tufted({{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, {{0, 1, 2}}});
  const Matrix l = IT::cotangent_laplacian(t);
  EXPECT_EQ(l.coeff(1, 2), 0);
  EXPECT_EQ(l.nonZeros(), 3 + 4) << "a tie, not a small number";
  EXPECT_NEAR(l.coeff(0, 1), -3. / 8, weight_error);
  EXPECT_NEAR(l.coeff(0, 2), -4. / 6, weight_error);
  EXPECT_EQ(t.metric().statistics().probable_zero, 0U);
}

TEST(Tufted_laplacian, of_an_obtuse_triangle_is_that_of_its_two_halves) {
  // the long side flips to twice the altitude, from the third corner to itself, which has no weight
  const Matrix l = tufted_laplacian({{{0, 0, 0}, {8, 0, 0}, {2, 1, 0}}, {{0, 1, 2}}});
  EXPECT_EQ(l.coeff(0, 1), 0);
  EXPECT_LT(l.coeff(0, 2), 0);
  EXPECT_LT(l.coeff(1, 2), 0);
}

TEST(Tufted_mass_matrix, has_the_area_of_the_triangles) {
  for (const auto& [name, m] : soups_of_all_kinds()) {
    double area = 0;
    for (const auto& [i, j, k] : m.triangles) {
      const auto side = [&points = m.points](std::uint32_t a, std::uint32_t b) {
        return Eigen::Vector3d(points[b][0] - points[a][0], points[b][1] - points[a][1],
                               points[b][2] - points[a][2]);
      };
      area += side(i, j).cross(side(i, k)).norm() / 2;
    }
    const Exact t = tufted(m);
    EXPECT_NEAR(IT::lumped_mass_matrix(t).sum(), area, 1e-11 * area) << name;
    EXPECT_NEAR(IT::galerkin_mass_matrix(t).sum(), area, 1e-11 * area) << name;
    EXPECT_EQ(IT::lumped_mass_matrix(t).rows(), static_cast<int>(m.points.size())) << name;
  }
}

TEST(Tufted_cover, is_certified_to_be_delaunay) {
  using Corresponding = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                    IT::Integer_coordinates>;
  for (const auto& [name, m] : soups_of_all_kinds()) {
    Corresponding t(IT::make_domain(soups::soup(m), IT::Domain_kind::tufted_cover).input);
    IT::flip_to_delaunay(t);
    const auto certificate = IT::certify_delaunay(t);
    EXPECT_TRUE(certificate.is_delaunay()) << name;
    EXPECT_EQ(certificate.statistics.probable_zero, 0U) << name;
  }
}

/// Edges by their ends: the sides of triangles there, sorted by the angles of the triangles around
/// the edge.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>>
sides_around_edges(const Mesh& m) {
  const auto point = [&m](std::uint32_t v) { return Eigen::Vector3d(m.points[v].data()); };
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> sides;
  for (std::uint32_t h = 0; h < 3 * m.triangles.size(); ++h)
    sides[std::minmax(m.triangles[h / 3][h % 3], m.triangles[h / 3][(h + 1) % 3])].push_back(h);
  for (auto& [ends, around] : sides) {
    const Eigen::Vector3d origin = point(ends.first),
                          axis = (point(ends.second) - origin).normalized(),
                          x = axis.unitOrthogonal(), y = axis.cross(x);
    const auto angle = [&](std::uint32_t h) {
      const Eigen::Vector3d d = point(m.triangles[h / 3][(h + 2) % 3]) - origin;
      return std::atan2(d.dot(y), d.dot(x));
    };
    std::sort(around.begin(), around.end(),
              [&](std::uint32_t g, std::uint32_t h) { return angle(g) < angle(h); });
  }
  return sides;
}

/// The same by incidences, in order around edges, and squared lengths, exact for integer
/// coordinates.
std::pair<IT::Signed_incidence, std::vector<double>> incidence(const Mesh& m) {
  IT::Signed_incidence s;
  s.number_of_vertices = static_cast<std::uint32_t>(m.points.size());
  s.number_of_faces = static_cast<std::uint32_t>(m.triangles.size());
  std::vector<double> lengths;
  for (const auto& [ends, around] : sides_around_edges(m)) {
    const auto [i, j] = ends;
    const std::uint32_t e = s.number_of_edges++;
    s.vertex_edge.push_back({e, i, -1});
    s.vertex_edge.push_back({e, j, +1});
    for (const std::uint32_t h : around)
      s.edge_face.push_back({h / 3, e, m.triangles[h / 3][h % 3] == i ? 1 : -1});
    double sum = 0;
    for (std::size_t x = 0; x < 3; ++x)
      sum += (m.points[i][x] - m.points[j][x]) * (m.points[i][x] - m.points[j][x]);
    lengths.push_back(sum);
  }
  return {s, lengths};
}

TEST(Tufted_laplacian, of_signed_incidences_and_lengths_is_that_of_points) {
  std::size_t shared = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    Mesh m = soups::random_without_repetition(12, 60, seed);
    for (meshes::Point& p : m.points)
      for (double& x : p) x = static_cast<double>(random() % 1000);
    const auto [s, lengths] = incidence(m);
    IT::Domain domain = IT::make_domain(s, lengths);
    shared += domain.report.nonmanifold_edges;
    EXPECT_EQ(domain.report.kind, IT::Domain_kind::tufted_cover);
    const Matrix by_lengths = IT::cotangent_laplacian(delaunay(std::move(domain))),
                 by_points = IT::cotangent_laplacian(tufted(m));
    EXPECT_LE(Matrix(by_lengths - by_points).norm(), weight_error * by_points.norm())
        << "seed " << seed;
    EXPECT_THROW(IT::make_domain(s, lengths, IT::Domain_kind::manifold), IT::Invalid_input);
    EXPECT_THROW(IT::make_domain(s, std::vector<double>(1, 1.)), IT::Invalid_input);
  }
  EXPECT_GT(shared, 100u);
}

TEST(Tufted_laplacian, of_signed_incidences_of_a_manifold_makes_no_cover) {
  const Mesh m = meshes::box(1, 2, 3);
  const auto [s, lengths] = incidence(m);
  IT::Domain domain = IT::make_domain(s, lengths);
  EXPECT_EQ(domain.report.kind, IT::Domain_kind::manifold);
  const Exact t(m.input());
  const Matrix l = IT::cotangent_laplacian(Exact(std::move(domain.input)));
  EXPECT_LE(Matrix(l - IT::cotangent_laplacian(t)).norm(), weight_error * l.norm());
}

} // namespace
