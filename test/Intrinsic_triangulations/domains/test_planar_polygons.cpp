// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "properties.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/read_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/write_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <iterator>
#include <map>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Point = std::array<double, 3>;
using Points = std::vector<Point>;
using Faces = std::vector<std::vector<std::uint32_t>>;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                          IT::Integer_coordinates>;
constexpr double pi = std::numbers::pi;
constexpr auto planar = IT::Nonplanar_polygons::planar;

struct Polygon_mesh {
  Points points;
  Faces faces;
};

// Quadrilaterals over [-1, 1]^2, at a height.
template <class Height>
Polygon_mesh quadrilaterals(std::uint32_t n, const Height& height) {
  Polygon_mesh m;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) {
      const double x = 2.0 * i / n - 1, y = 2.0 * j / n - 1;
      m.points.push_back({x, y, height(x, y)});
    }
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t v = j * (n + 1) + i;
      m.faces.push_back({v, v + 1, v + n + 2, v + n + 1});
    }
  return m;
}

// The cube with six faces of four times as many sides, bent; n sides in each edge.
Polygon_mesh bent_cube(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-0.1, 0.1);
  Polygon_mesh m{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {}};
  const Faces cube{{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                   {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoint;
  for (const auto& face : cube) {
    m.faces.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t v = face[k], w = face[(k + 1) % 4];
      const auto [found, is_new] =
          midpoint.insert({std::minmax(v, w), static_cast<std::uint32_t>(m.points.size())});
      if (is_new) {
        Point p;
        for (std::size_t c = 0; c < 3; ++c) p[c] = (m.points[v][c] + m.points[w][c]) / 2;
        m.points.push_back(p);
      }
      m.faces.back().push_back(v);
      m.faces.back().push_back(found->second);
    }
  }
  for (Point& p : m.points)
    for (double& x : p) x += noise(random);
  return m;
}

Mesh surface_mesh(const Polygon_mesh& m) {
  Mesh mesh;
  for (const Point& p : m.points) mesh.add_vertex({p[0], p[1], p[2]});
  for (const auto& face : m.faces) {
    std::vector<Mesh::Vertex_index> corners;
    for (const std::uint32_t v : face) corners.emplace_back(v);
    mesh.add_face(corners);
  }
  return mesh;
}

IT::Intrinsic_input input_of(const Polygon_mesh& m, IT::Nonplanar_polygons kind) {
  return std::move(IT::make_domain(IT::triangle_soup(m.points, m.faces, kind)).input);
}

double squared_distance(const Point& p, const Point& q) {
  return IT::Input_metric::squared_distance<double>(p, q);
}

double interior_angle(const IT::Planar_polygons::Polygon& polygon, std::size_t i) {
  const std::size_t n = polygon.points.size();
  const auto at = [&](std::size_t k) {
    return std::complex<double>(polygon.points[k % n][0], polygon.points[k % n][1]);
  };
  const double a = std::arg((at(i + n - 1) - at(i)) / (at(i + 1) - at(i)));
  return a < 0 ? a + 2 * pi : a;
}

// Sides are those of the points exactly, diagonals those of the planar polygons; angles in triangles are together those of the
// polygons.
void expect_metric_of_polygons(const IT::Input& input, const Polygon_mesh& m) {
  const IT::Input_metric& metric = input.metric();
  const double unit = std::ldexp(1, 2 * input.scale_exponent());
  std::vector<double> angle(m.points.size(), 0), expected(m.points.size(), 0);
  for (std::uint32_t f = 0; f < input.number_of_faces(); ++f) {
    const auto polygon = input.planar_polygons()(input.names().polygon(f));
    ASSERT_FALSE(polygon.points.empty());
    std::uint32_t h = input.halfedge_of_face(f);
    std::array<double, 3> l{};
    std::array<std::uint32_t, 3> row{};
    for (unsigned k = 0; k < 3; ++k, h = input.next(h)) {
      row[k] = input.names().row(input.source(h));
      const std::uint32_t w = input.names().row(input.target(h));
      const std::size_t i = polygon.corner(row[k]), j = polygon.corner(w);
      const auto exact = metric.squared_length<CGAL::Gmpq>(f, k);
      l[k] = CGAL::to_double(exact) / unit;
      if (polygon.is_side(i, j)) {
        EXPECT_EQ(exact,
                  IT::Input_metric::squared_distance<CGAL::Gmpq>(m.points[row[k]], m.points[w]) *
                      CGAL::Gmpq(unit));
        EXPECT_NE(input.names().edges.user(h / 2), IT::Gluing::none);
      } else {
        const double x = polygon.points[i][0] - polygon.points[j][0],
                     y = polygon.points[i][1] - polygon.points[j][1];
        EXPECT_NEAR(l[k], x * x + y * y,
                    1e-14 * (1 + squared_distance(m.points[row[k]], m.points[w])));
      }
    }
    for (unsigned k = 0; k < 3; ++k) {
      const double a = l[k], b = l[(k + 2) % 3], c = l[(k + 1) % 3];
      angle[row[k]] += std::acos((a + b - c) / (2 * std::sqrt(a * b)));
    }
  }
  for (std::uint32_t f = 0; f < m.faces.size(); ++f) {
    const auto polygon = input.planar_polygons()(f);
    for (std::size_t i = 0; i < polygon.points.size(); ++i)
      expected[polygon.vertices[i]] += interior_angle(polygon, i);
  }
  for (std::size_t v = 0; v < angle.size(); ++v) EXPECT_NEAR(angle[v], expected[v], 1e-9);
}

void expect_all_flattened(const IT::Planar_polygons& polygons, std::size_t count) {
  EXPECT_EQ(polygons.report.flattened, count);
  EXPECT_EQ(polygons.report.kept, 0U);
  EXPECT_EQ(polygons.report.planar, 0U);
  EXPECT_GT(polygons.report.largest_angle_change, 0);
}

TEST(Planar_polygons, sides_are_exact_and_cone_angles_are_those_of_polygons) {
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const Polygon_mesh m = bent_cube(seed);
    const Exact of_soup(input_of(m, planar));
    expect_all_flattened(of_soup.input().planar_polygons(), 6);
    expect_metric_of_polygons(of_soup.input(), m);
    const Exact of_mesh(IT::Intrinsic_input(surface_mesh(m), IT::Mollification::automatic, planar));
    expect_all_flattened(of_mesh.input().planar_polygons(), 6);
    expect_metric_of_polygons(of_mesh.input(), m);
  }
  const Polygon_mesh m =
      quadrilaterals(9, [](double x, double y) { return x * y + 0.1 * x * x * x; });
  const Exact t(input_of(m, planar));
  expect_metric_of_polygons(t.input(), m);
}

TEST(Planar_polygons, numbers_may_change_with_the_order_of_vertices) {
  Polygon_mesh m = quadrilaterals(260, [](double x, double y) { return std::sin(3 * x) * y; });
  std::mt19937 random(7);
  std::shuffle(m.faces.begin(), m.faces.end(), random);
  const Exact t(input_of(m, planar));
  EXPECT_TRUE(t.report().renumbered);
  const auto& report = t.input().planar_polygons().report;
  EXPECT_EQ(report.planar + report.flattened, m.faces.size());
  EXPECT_GT(report.flattened, m.faces.size() / 2);
  const Exact same(IT::Intrinsic_input(surface_mesh(m), IT::Mollification::automatic, planar));
  const auto areas = [&m](const Exact& x) {
    std::vector<double> result(m.faces.size(), 0);
    const double unit = std::ldexp(1, -2 * x.input().scale_exponent() - 2);
    for (std::uint32_t f = 0; f < x.input().number_of_faces(); ++f)
      result[x.input().names().polygon(f)] += x.input().quadruple_area(f) * unit;
    return result;
  };
  const std::vector<double> one = areas(t), other = areas(same);
  for (std::size_t f = 0; f < one.size(); ++f) EXPECT_NEAR(one[f], other[f], 1e-14);
}

// Where points of planar polygons are in space.
TEST(Planar_polygons, points_of_regular_polygons_are_where_symmetry_wants_them) {
  const Polygon_mesh square{{{1, 1, 1}, {-1, -1, 1}, {1, -1, -1}, {-1, 1, -1}}, {{0, 1, 2, 3}}};
  const Exact t(input_of(square, planar));
  for (std::uint32_t e = 0; e < 5; ++e) { // middles of sides, and of the diagonal
    const std::uint32_t h = t.input().is_border(2 * e) ? 2 * e + 1 : 2 * e;
    const Point p = IT::point_in_space(t, {h, {0.5, 0.5, 0}}, square.points);
    const Point &a = square.points[t.input().source(h)], &b = square.points[t.input().target(h)];
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(p[c], t.input().is_border(h ^ 1U) ? (a[c] + b[c]) / 2 : 0.0, 1e-14);
  }
}

TEST(Planar_polygons, subdivisions_meet_at_sides_and_fill_nearly_planar_polygons) {
  Polygon_mesh m = quadrilaterals(5, [](double x, double y) { return 1e-7 * x * y; });
  const auto check = [](const Polygon_mesh& mesh, double tolerance) {
    Exact t(input_of(mesh, planar));
    IT::flip_to_delaunay(t);
    const IT::Common_subdivision s = IT::common_subdivision(t);
    const Points curved = IT::positions(s, mesh.points, t.input()),
                 straight = IT::positions(s, mesh.points);
    ASSERT_EQ(curved.size(), straight.size());
    for (std::size_t v = 0; v < curved.size(); ++v) {
      const IT::Weighted_vertices w = s.on_input(v);
      bool is_on_side = w.size < 2;
      for (const auto& face : mesh.faces)
        for (std::size_t k = 0; k < face.size() && w.size == 2; ++k)
          is_on_side = is_on_side || std::minmax(face[k], face[(k + 1) % face.size()]) ==
                                         std::minmax(w.vertices[0], w.vertices[1]);
      EXPECT_LT(squared_distance(curved[v], straight[v]),
                is_on_side ? 1e-30 : tolerance * tolerance);
    }
  };
  check(m, 1e-6);
  check(bent_cube(3), 0.3);
}

TEST(Planar_polygons, of_both_sheets_of_a_cover_are_the_same) {
  const Polygon_mesh m = bent_cube(4);
  IT::Domain d =
      IT::make_domain(IT::triangle_soup(m.points, m.faces, planar), IT::Domain_kind::tufted_cover);
  const Exact cover(std::move(d.input));
  const Exact surface(input_of(m, planar));
  EXPECT_NEAR(properties::total_area(cover), 2 * properties::total_area(surface), 1e-12);
  for (std::uint32_t f = 0; f < cover.input().number_of_faces(); ++f)
    EXPECT_TRUE(cover.input().metric().has_excess(f));
}

// With or without the option for planar polygons, planar faces give the same triangles.
TEST(Planar_polygons, planar_polygons_stay_as_they_are) {
  const Polygon_mesh flat = quadrilaterals(6, [](double x, double y) { return 0.5 * x - 2 * y; });
  Polygon_mesh prism{{}, {{}, {}}};
  for (std::uint32_t i = 0; i < 9; ++i) {
    const double a = 2 * pi * i / 9;
    prism.points.push_back({std::cos(a) + 5, std::sin(a), std::sin(a) / 3});
    prism.points.push_back({std::cos(a) + 5, std::sin(a), std::sin(a) / 3 + 1});
    prism.faces[0].push_back(2 * (8 - i));
    prism.faces[1].push_back(2 * i + 1);
    prism.faces.push_back({2 * i, (2 * i + 2) % 18, (2 * i + 3) % 18, 2 * i + 1});
  }
  for (const Polygon_mesh& m : {flat, prism}) {
    const IT::Triangle_soup a = IT::triangle_soup(m.points, m.faces),
                            b = IT::triangle_soup(m.points, m.faces, planar);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_TRUE(b.planar_polygons.empty());
    EXPECT_EQ(b.planar_polygons.report.planar, m.faces.size());
    EXPECT_EQ(a.planar_polygons.report.planar, 0U);
    const IT::Intrinsic_input c(surface_mesh(m), IT::Mollification::automatic, planar);
    EXPECT_TRUE(c.planar_polygons.empty());
  }
}

template <class Triangulation>
Eigen::MatrixXd delaunay_laplacian(IT::Intrinsic_input input) {
  Triangulation t(std::move(input));
  IT::flip_to_delaunay(t);
  EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, 0U);
  return IT::cotangent_laplacian(t);
}

// Saddles, a quarter turn of which turns them over; and the same after a reflection.
TEST(Planar_polygons, symmetric_meshes_have_symmetric_laplacians) {
  constexpr std::uint32_t n = 6;
  const Polygon_mesh m = quadrilaterals(n, [](double x, double y) { return x * y; });
  const Eigen::MatrixXd l = delaunay_laplacian<Exact>(input_of(m, planar));
  const auto vertex = [](std::uint32_t i, std::uint32_t j) { return j * (n + 1) + i; };
  const auto images = [&](std::uint32_t i, std::uint32_t j) {
    return std::array{vertex(j, n - i), vertex(n - i, j), vertex(j, i), vertex(n - i, n - j)};
  };
  double largest = 0;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j)
      for (std::uint32_t p = 0; p <= n; ++p)
        for (std::uint32_t q = 0; q <= n; ++q)
          for (std::size_t k = 0; k < 4; ++k)
            largest = std::max(largest, std::abs(l(vertex(i, j), vertex(p, q)) -
                                                 l(images(i, j)[k], images(p, q)[k])));
  EXPECT_LT(largest, 1e-12);
  // triangles are not that symmetric, as a quadrilateral is cut along one of its diagonals
  const Eigen::MatrixXd fan = delaunay_laplacian<Exact>(input_of(m, IT::Nonplanar_polygons::fan));
  EXPECT_GT((l - fan).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(Planar_polygons, regular_skew_quadrilaterals_are_squares) {
  const Polygon_mesh m{{{1, 1, 1}, {-1, -1, 1}, {1, -1, -1}, {-1, 1, -1}}, {{0, 1, 2, 3}}};
  const Eigen::MatrixXd l = delaunay_laplacian<Exact>(input_of(m, planar));
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      EXPECT_NEAR(l(i, j), i == j ? 1.0 : i % 2 == j % 2 ? 0.0 : -0.5, 1e-14);
}

// Ties of triangles in space are proven beside planar polygons, and at them.
TEST(Planar_polygons, ties_are_certified) {
  for (const double slope : {0.0, 0.5}) {
    Polygon_mesh m = quadrilaterals(12, [&](double x, double y) {
      return slope * x + (x > 0.7 && y > 0.7 ? 0.125 * x * y : 0);
    });
    Faces triangles;
    for (const auto& f : m.faces)
      if (m.points[f[2]][1] < 0) {
        triangles.push_back({f[0], f[1], f[2]});
        triangles.push_back({f[0], f[2], f[3]});
      } else
        triangles.push_back(f);
    m.faces = triangles;
    IT::Triangle_soup soup = IT::triangle_soup(m.points, m.faces, planar);
    const std::size_t flattened = soup.planar_polygons.report.flattened;
    EXPECT_GT(flattened, 0U);
    EXPECT_LT(flattened, 20U);
    Exact t(std::move(IT::make_domain(std::move(soup)).input));
    std::mt19937 random(3);
    for (int i = 0; i < 300; ++i) { // away from the input
      const auto e = *std::next(edges(t.mesh()).begin(), random() % num_edges(t.mesh()));
      t.flip_edge(halfedge(e, t.mesh())); // unless it is refused
    }
    IT::flip_to_delaunay(t);
    const auto check = IT::check_delaunay(t);
    EXPECT_EQ(check.non_delaunay_edges, 0U);
    EXPECT_GT(check.cocircular_edges.size(), 50U);
    EXPECT_EQ(t.metric().statistics().probable_zero, 0U);
    EXPECT_GT(t.metric().statistics().certified_zero, 50U);
  }
}

TEST(Planar_polygons, exact_and_inexact_traits_agree) {
  using Double = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>,
                                             IT::No_correspondence>;
  for (const std::uint32_t seed : {5U, 6U}) {
    const Polygon_mesh m = bent_cube(seed);
    const Eigen::MatrixXd a = delaunay_laplacian<Exact>(input_of(m, planar)),
                          b = delaunay_laplacian<Double>(input_of(m, planar));
    EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(Planar_polygons, metrics_are_scaled_from_them) {
  const Polygon_mesh m = bent_cube(8);
  const IT::Scaled_metric s =
      IT::scale_conformally(input_of(m, planar), [](IT::Gluing_map::Vertex) { return 0.0; });
  const Exact t(input_of(m, planar));
  const Exact scaled{IT::Intrinsic_input(s.input)};
  EXPECT_NEAR(properties::total_area(t), properties::total_area(scaled), 1e-12);
}

TEST(Planar_polygons, polygons_that_cannot_become_planar_are_kept) {
  Points eight; // whose vector area is zero
  for (int i = 0; i < 12; ++i) {
    const double t = (i + 0.5) * pi / 6;
    eight.push_back({std::cos(t), std::sin(2 * t), 0.1 * std::cos(3 * t)});
  }
  const std::vector<Points> kept{{{0, 0, 0}, {0, 0, 0}, {1, 0, 0.5}, {1, 1, 0}, {0, 1, 0.5}},
                                 eight};
  for (const Points& points : kept) {
    Faces faces(1);
    for (std::uint32_t v = 0; v < points.size(); ++v) faces[0].push_back(v);
    const IT::Triangle_soup s = IT::triangle_soup(points, faces, planar);
    EXPECT_EQ(s.planar_polygons.report.kept, 1U);
    EXPECT_TRUE(s.planar_polygons.empty());
    EXPECT_EQ(s.triangles, IT::triangle_soup(points, faces).triangles);
  }
  const Points line{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}};
  EXPECT_EQ(IT::triangle_soup(line, Faces{{0, 1, 2, 3}}, planar).planar_polygons.report.planar, 1U);
}

// The corner at vertex 1 is nearly straight: convex in space, reflex in the plane, where the diagonal from 0 to 2 is outside. All
// triangulations without it have edges of other faces.
TEST(Planar_polygons, without_a_free_diagonal_in_the_plane_they_are_cut_in_space) {
  const Points points{{0, 0, 0},  {1, -0.01, 0}, {2, 0, 0},  {2, 1, 1.2},
                      {0, 1, -1}, {1, -3, 2},    {1, -3, -2}};
  const Faces pentagon{{0, 1, 2, 3, 4}};
  const IT::Triangle_soup alone = IT::triangle_soup(points, pentagon, planar);
  ASSERT_EQ(alone.planar_polygons.report.flattened, 1U);
  const auto has_edge = [](const IT::Triangle_soup& s, std::uint32_t a, std::uint32_t b) {
    return std::any_of(s.triangles.begin(), s.triangles.end(), [&](const auto& t) {
      return std::count(t.begin(), t.end(), a) == 1 && std::count(t.begin(), t.end(), b) == 1;
    });
  };
  ASSERT_FALSE(has_edge(alone, 0, 2)) << "outside";
  const Faces faces{{0, 1, 2, 3, 4}, {1, 3, 5}, {4, 1, 6}};
  const IT::Triangle_soup s = IT::triangle_soup(points, faces, planar);
  EXPECT_EQ(s.planar_polygons.report.kept, 1U);
  EXPECT_TRUE(has_edge(s, 0, 2));
  EXPECT_EQ(IT::make_domain(s).report.nonmanifold_edges, 0U);
}

TEST(Planar_polygons, find_the_corner_at_a_vertex) {
  IT::Planar_polygons all;
  const std::vector<std::uint32_t> first{7, 2, 9, 4}, second{3, 1, 8};
  all.add(0, first, std::vector<IT::Planar_polygons::Point>(4));
  all.add(5, second, std::vector<IT::Planar_polygons::Point>(3));
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(all(0).corner(first[k]), k);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(all(5).corner(second[k]), k);
  EXPECT_EQ(all(0).corner(3), 4U);
  EXPECT_EQ(all(5).corner(9), 3U);
  EXPECT_TRUE(all(1).points.empty());
}

// Tangles: in any case lengths are those of triangles, and kept polygons are triangulated as usual.
TEST(Planar_polygons, tangles_become_planar_or_are_kept) {
  std::mt19937 random(9);
  std::normal_distribution<double> coordinate;
  std::size_t kept = 0, flattened = 0;
  for (const std::uint32_t n : {4U, 5U, 6U, 8U, 16U})
    for (int round = 0; round < 40; ++round) {
      Points points(n);
      Faces faces(1);
      for (std::uint32_t v = 0; v < n; ++v) {
        for (double& x : points[v]) x = coordinate(random);
        faces[0].push_back(v);
      }
      const IT::Triangle_soup s = IT::triangle_soup(points, faces, planar);
      kept += s.planar_polygons.report.kept;
      flattened += s.planar_polygons.report.flattened;
      if (s.planar_polygons.empty()) {
        EXPECT_EQ(s.triangles, IT::triangle_soup(points, faces).triangles);
      }
      Exact t(std::move(IT::make_domain(s).input));
      IT::flip_to_delaunay(t);
      EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, 0U);
    }
  EXPECT_EQ(kept + flattened, 200U);
  EXPECT_GT(kept, 0U);
  EXPECT_GT(flattened, 50U);
}

TEST(Planar_polygons, are_written_and_read) {
  const Polygon_mesh m = bent_cube(11);
  Exact t(input_of(m, planar));
  IT::flip_to_delaunay(t);
  std::stringstream file, again;
  IT::write_intrinsic_triangulation(file, t);
  using Stored = IT::Intrinsic_triangulation<>;
  Stored stored = IT::read_intrinsic_triangulation<Stored>(file, "file");
  IT::write_intrinsic_triangulation(again, stored);
  EXPECT_EQ(file.str(), again.str());
  ASSERT_NE(stored.input().surface(), nullptr);
  expect_metric_of_polygons(*stored.input().surface(), m);
  EXPECT_EQ((IT::cotangent_laplacian(stored) - IT::cotangent_laplacian(t)).norm(), 0);
  for (const char* const wrong : {"planar_polygons 7", "planar_polygons 5"}) {
    std::string text = file.str();
    text.replace(text.find("planar_polygons 6"), 17, wrong);
    std::istringstream in(text);
    EXPECT_THROW(IT::read_intrinsic_triangulation<Stored>(in, "file"), IT::Invalid_input);
  }
}

// Faces that shrink to lines have numbers, too.
TEST(Planar_polygons, may_have_larger_numbers_than_there_are_triangles) {
  const Points points{{0, 0, 0.5}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}};
  const Polygon_mesh m{points, {{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 0, 0}, {0, 1, 2, 3}}};
  const Exact t(input_of(m, planar));
  ASSERT_EQ(t.input().number_of_faces(), 2U);
  std::stringstream file;
  IT::write_intrinsic_triangulation(file, t);
  const Exact read = IT::read_intrinsic_triangulation<Exact>(file, "file");
  EXPECT_EQ(read.input().names().polygon(1), 4U);
  ASSERT_EQ(read.input().planar_polygons().size(), 1U);
  EXPECT_EQ(read.input().planar_polygons().face(0), 4U);
}

// Two polygons with the same four corners: each diagonal is one of both, or a side.
TEST(Planar_polygons, edges_of_two_polygons_have_one_length) {
  const Points points{{0, 0, 0.5}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}};
  for (const Faces& faces :
       {Faces{{0, 1, 2, 3}, {0, 1, 2, 3}, {3, 2, 1, 0}}, Faces{{0, 1, 2, 3}, {0, 2, 1}, {1, 3, 2}},
        Faces{{0, 1, 2, 3}, {0, 2, 1, 3}}}) {
    const IT::Triangle_soup s = IT::triangle_soup(points, faces, planar);
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> length;
    IT::Domain d = IT::make_domain(s);
    const Exact t(std::move(d.input));
    const IT::Input& input = t.input();
    for (std::uint32_t f = 0; f < input.number_of_faces(); ++f) {
      std::uint32_t h = input.halfedge_of_face(f);
      for (unsigned k = 0; k < 3; ++k, h = input.next(h)) {
        const double l = input.metric().squared_length<double>(f, k);
        const auto ends =
            std::minmax({input.names().row(input.source(h)), input.names().row(input.target(h))});
        EXPECT_EQ(length.insert({ends, l}).first->second, l);
      }
    }
    EXPECT_GT(s.planar_polygons.report.kept + s.planar_polygons.report.flattened, 0U);
  }
}

} // namespace
