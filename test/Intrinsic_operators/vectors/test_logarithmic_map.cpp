// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include "delaunay.h"
#include "meshes.h"
#include "operator_test_meshes.h"
#include "planar_bezier.h"

#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

// Logarithmic maps against closed forms, and against the exponential map.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Complex = std::complex<double>;
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                          IT::Integer_coordinates>;
using Heat = IT::Vector_heat_method<Exact>;
using meshes::Point;
constexpr double pi = std::numbers::pi;
constexpr std::array all_methods{IT::Logarithm_method::exact, IT::Logarithm_method::affine,
                                 IT::Logarithm_method::polar};

Point point_of(const Exact& t, const IT::Surface_point& p, const std::vector<Point>& points) {
  return IT::point_in_space(t, *IT::locate_on_input(t, p), points);
}

/// The greatest distance in space between a vertex and the end of the exponential map of its logarithm, for vertices near the source.
template <class Source>
double worst_round_trip(const Exact& t, const Source& source, const std::vector<Complex>& log,
                        const std::vector<Point>& points, double radius) {
  double worst = 0;
  for (const auto v : vertices(t.mesh())) {
    if (t.is_inserted(v)) continue;
    const Complex z = log[t.input_vertex(v)];
    const IT::Geodesic g = IT::exponential_map(t, source, z);
    const Point start = point_of(t, g.points.front(), points);
    if (planar_bezier::distance(start, points[t.input_vertex(v)]) > radius) continue;
    worst = std::max(worst, planar_bezier::distance(point_of(t, g.points.back(), points),
                                                    points[t.input_vertex(v)]));
  }
  return worst;
}

/// From every corner of every face, border vertices included: the coordinates in the plane, from
/// there and in the frame of the side; and in polar coordinates of vertices, by the exponential map.
TEST(Logarithmic_map, in_the_plane_is_the_displacement_from_all_vertices) {
  const meshes::Mesh shape = meshes::scaled(meshes::random_planar(50, 1000, 3), 0.01);
  Exact t(shape.input());
  IT::delaunay_refine(t, IT::parameters::minimum_angle(25));
  const Heat heat(t);
  std::vector<Complex> places(t.number_of_vertices());
  const auto in_plane = [&](const IT::Surface_point& p) {
    const Point x = point_of(t, p, shape.points);
    return Complex(x[0], x[1]);
  };
  const auto corner = [&](auto h) { return IT::Surface_point{t.numbers().halfedge(h), {1, 0, 0}}; };
  for (const auto f : faces(t.mesh()))
    for (auto h : CGAL::halfedges_around_face(halfedge(f, t.mesh()), t.mesh()))
      places[t.input_vertex(source(h, t.mesh()))] = in_plane(corner(h));
  for (const auto f : faces(t.mesh()))
    for (auto h : CGAL::halfedges_around_face(halfedge(f, t.mesh()), t.mesh())) {
      const std::uint32_t i = t.input_vertex(source(h, t.mesh())),
                          j = t.input_vertex(target(h, t.mesh()));
      Complex side = places[j] - places[i];
      side /= std::abs(side);
      for (const auto method : {IT::Logarithm_method::exact, IT::Logarithm_method::affine}) {
        const std::vector<Complex> log = heat.logarithmic_map(corner(h), method);
        double worst = 0;
        for (std::size_t k = 0; k < log.size(); ++k)
          worst = std::max(worst, std::abs(log[k] * side - (places[k] - places[i])));
        // places of inserted vertices are as good as that; the square has sides of 10
        EXPECT_LE(worst, method == IT::Logarithm_method::exact ? 1e-12 : 1e-7) << i;
        EXPECT_EQ(log[i], 0.);
      }
    }
  for (const auto v : vertices(t.mesh())) {
    if (face(halfedge(v, t.mesh()), t.mesh()) == IT::Gluing_map::Face{IT::Gluing::none})
      continue; // from the border, lines to others there are cut by rounding
    for (const auto method : {IT::Logarithm_method::exact, IT::Logarithm_method::affine})
      EXPECT_LE(worst_round_trip(t, v, heat.logarithmic_map(v, method), shape.points, 1e300), 1e-6);
  }
}

/// On the border, what points out goes along the nearer side of it: rounding turns nothing around.
TEST(Logarithmic_map, vectors_along_the_border_keep_their_side) {
  meshes::Mesh square;
  square.points = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  square.triangles = {{0, 1, 3}, {1, 2, 3}};
  const Exact t(square.input());
  for (const auto v : vertices(t.mesh())) {
    if (t.input_vertex(v) != 1) continue;
    for (const Complex z : {Complex(0.3, -1e-17), Complex(-0.3, -1e-17), Complex(0.3, 1e-17),
                            Complex(-0.3, 0), Complex(0, 0.3)}) {
      const Point p = point_of(t, IT::exponential_map(t, v, z).points.back(), square.points);
      EXPECT_NEAR(p[0], z.real(), 1e-15) << z;
      EXPECT_NEAR(p[1], z.imag(), 1e-15) << z;
    }
  }
}

TEST(Logarithmic_map, in_the_plane_is_the_displacement_from_points_in_faces) {
  const meshes::Mesh shape = meshes::scaled(meshes::random_planar(50, 1000, 3), 0.01);
  Exact t = delaunay<Exact>(shape.input());
  const Heat heat(t);
  for (const auto f : faces(t.mesh()))
    for (const std::array<double, 3>& w :
         {std::array{0.2, 0.3, 0.5}, std::array{0.5, 0.5, 0.}, std::array{0.98, 0.01, 0.01}}) {
      const IT::Surface_point p{t.numbers().halfedge(halfedge(f, t.mesh())), w};
      const auto place = [](const Point& x) { return Complex(x[0], x[1]); };
      const auto h = halfedge(f, t.mesh());
      const Complex from = place(point_of(t, p, shape.points)),
                    side = place(shape.points[t.input_vertex(target(h, t.mesh()))]) -
                           place(shape.points[t.input_vertex(source(h, t.mesh()))]);
      for (const auto method : {IT::Logarithm_method::exact, IT::Logarithm_method::affine}) {
        const std::vector<Complex> log = heat.logarithmic_map(p, method);
        for (std::size_t i = 0; i < log.size(); ++i) // the square has sides of 10
          EXPECT_LE(std::abs(log[i] * side / std::abs(side) - (place(shape.points[i]) - from)),
                    method == IT::Logarithm_method::exact ? 1e-12 : 1e-6);
      }
    }
}

TEST(Logarithmic_map, at_a_vertex_given_as_a_point_is_that_of_the_vertex) {
  const meshes::Mesh shape = meshes::potato(2, 5);
  Exact t = delaunay<Exact>(shape.input());
  const Heat heat(t);
  for (const auto h : halfedges(t.mesh())) {
    if (t.numbers().halfedge(h) % 17 != 0) continue;
    const IT::Surface_point p{t.numbers().halfedge(h), {0, 1, 0}};
    const auto v = target(h, t.mesh());
    if (IT::gaussian_curvature(t, v) < 0) continue; // has more directions than the plane of a face
    for (const auto method : all_methods) {
      const std::vector<Complex> by_point = heat.logarithmic_map(p, method),
                                 by_vertex = heat.logarithmic_map(v, method);
      for (std::size_t i = 0; i < by_point.size(); ++i) {
        if (std::abs(by_vertex[i]) == 0) continue;
        const auto a = IT::exponential_map(t, p, by_point[i] / std::abs(by_point[i]) * 0.01),
                   b = IT::exponential_map(t, v, by_vertex[i] / std::abs(by_vertex[i]) * 0.01);
        EXPECT_LE(planar_bezier::distance(point_of(t, a.points.back(), shape.points),
                                          point_of(t, b.points.back(), shape.points)),
                  1e-7);
        EXPECT_NEAR(std::abs(by_point[i]), std::abs(by_vertex[i]), 1e-9);
      }
    }
  }
}

/// Displacements modulo the lattice, where one image of the source is much nearer than the others.
TEST(Logarithmic_map, on_a_flat_torus_is_the_displacement) {
  const std::uint32_t n = 24;
  const double shear = 0.3;
  Exact t = delaunay<Exact>(operator_test::torus(n, shear));
  const Heat heat(t);
  for (const auto method : all_methods) {
    const std::vector<Complex> log = heat.logarithmic_map(t.numbers().vertex_at(0), method);
    const double bound = method == IT::Logarithm_method::exact    ? 1e-14
                         : method == IT::Logarithm_method::affine ? 5e-3
                                                                  : 0.15;
    const Complex turn = log[1] / std::abs(log[1]); // to (1, 0)
    for (int y = -3; y <= 3; ++y)
      for (int x = -3; x <= 3; ++x) {
        const auto i = static_cast<std::uint32_t>((y + 24) % 24 * 24 + (x + 24) % 24);
        EXPECT_LE(std::abs(log[i] / turn - Complex(x + shear * y, y)), bound) << x << ' ' << y;
      }
  }
}

/// Rings of points on a surface of revolution, closed by rings of triangles: z and radius of each ring.
meshes::Mesh revolved(std::uint32_t n, const std::vector<std::array<double, 2>>& rings) {
  meshes::Mesh m;
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (std::uint32_t i = 0; i < n; ++i) {
      const double a = 2 * pi * (i + 0.5 * static_cast<double>(r % 2)) / n;
      m.points.push_back({rings[r][1] * std::cos(a), rings[r][1] * std::sin(a), rings[r][0]});
    }
  for (std::uint32_t r = 0; r + 1 < rings.size(); ++r)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = n * r + i, b = n * r + (i + 1) % n, c = a + n, d = b + n;
      if (r % 2 == 0) {
        m.triangles.push_back({a, b, c});
        m.triangles.push_back({b, d, c});
      } else {
        m.triangles.push_back({a, b, d});
        m.triangles.push_back({a, d, c});
      }
    }
  return m;
}

TEST(Logarithmic_map, undoes_the_exponential_map_on_a_cylinder_and_a_cone) {
  std::vector<std::array<double, 2>> cylinder, cone;
  for (unsigned r = 0; r <= 24; ++r) {
    cylinder.push_back({0.25 * r, 1});
    cone.push_back({0.2 * r, 2 - 0.06 * r});
  }
  for (const meshes::Mesh& shape : {revolved(24, cylinder), revolved(24, cone)}) {
    Exact t = delaunay<Exact>(shape.input());
    const Heat heat(t);
    const auto v = t.numbers().vertex_at(24 * 12);
    EXPECT_LE(worst_round_trip(t, v, heat.logarithmic_map(v), shape.points, 1e300), 1e-12);
    // where one path is the shortest by far
    EXPECT_LE(worst_round_trip(t, v, heat.logarithmic_map(v, IT::Logarithm_method::affine),
                               shape.points, 1.5),
              1e-2);
    EXPECT_LE(worst_round_trip(t, v, heat.logarithmic_map(v, IT::Logarithm_method::polar),
                               shape.points, 1.5),
              0.1);
  }
}

TEST(Logarithmic_map, converges_on_the_sphere) {
  for (const auto method : all_methods) {
    std::vector<double> errors, lengths;
    for (const unsigned levels : {3U, 4U, 5U}) {
      const meshes::Mesh shape = meshes::sphere(levels);
      Exact t = delaunay<Exact>(shape.input());
      const Heat heat(t);
      const auto v = t.numbers().vertex_at(0);
      const std::vector<Complex> log = heat.logarithmic_map(v, method);
      errors.push_back(worst_round_trip(t, v, log, shape.points, 1.4));
      double worst = 0;
      for (std::size_t i = 0; i < log.size(); ++i) {
        const double c = shape.points[0][0] * shape.points[i][0] +
                         shape.points[0][1] * shape.points[i][1] +
                         shape.points[0][2] * shape.points[i][2];
        const double r = std::acos(std::clamp(c, -1., 1.));
        if (r < 2) worst = std::max(worst, std::abs(std::abs(log[i]) - r));
      }
      lengths.push_back(worst);
    }
    if (method == IT::Logarithm_method::exact)
      EXPECT_LT(errors[2], 1e-12);
    else
      EXPECT_LT(errors[2], std::min(0.05, 0.8 * errors[1]));
    EXPECT_LT(lengths[2], std::min(0.07, 0.8 * lengths[1]));
  }
}

/// Edges at the source are from 0.4 to 1.6 long.
TEST(Logarithmic_map, has_directions_from_a_source_with_uneven_edges_far_away) {
  constexpr int n = 24;
  meshes::Mesh shape = meshes::grid(n, n);
  const auto center = static_cast<std::uint32_t>(std::ranges::find(shape.points, Point{12, 12, 0}) -
                                                 shape.points.begin());
  const Complex place(12.6, 12.3);
  shape.points[center] = {place.real(), place.imag(), 0};
  Exact t = delaunay<Exact>(shape.input());
  const std::vector<Complex> log =
      Heat(t).logarithmic_map(t.numbers().vertex_at(center), IT::Logarithm_method::polar);
  std::vector<Complex> turns;
  for (std::uint32_t i = 0; i < log.size(); ++i) {
    const Complex exact = Complex(shape.points[i][0], shape.points[i][1]) - place;
    if (std::abs(exact) > 3 && std::abs(exact) < 9)
      turns.push_back(log[i] / exact / std::abs(log[i] / exact));
  }
  Complex mean = 0;
  for (const Complex& z : turns) mean += z;
  for (const Complex& z : turns) EXPECT_LE(std::abs(std::arg(z / mean)), 0.2);
}

/// Points of the sphere, not only vertices.
TEST(Logarithmic_map, of_points_on_the_sphere_undoes_the_exponential_map) {
  const meshes::Mesh shape = meshes::sphere(4);
  Exact t = delaunay<Exact>(shape.input());
  const Heat heat(t);
  for (const std::uint32_t f : {0U, 77U, 500U})
    for (const auto method : all_methods) {
      const IT::Surface_point p{t.numbers().halfedge(halfedge(t.numbers().face_at(f), t.mesh())),
                                {0.3, 0.3, 0.4}};
      const double e = worst_round_trip(t, p, heat.logarithmic_map(p, method), shape.points, 1.5);
      EXPECT_LE(e, method == IT::Logarithm_method::exact    ? 1e-12
                   : method == IT::Logarithm_method::affine ? 0.1
                                                            : 0.15); // edges have 0.1
    }
}

/// Random surfaces: round trips by another mechanism, straight walks, which go on behind saddles
/// where paths bend there.
TEST(Logarithmic_map, by_shortest_paths_is_undone_by_the_exponential_map) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    const meshes::Mesh shape =
        seed % 2 == 0 ? meshes::potato(3, seed) : meshes::rough_grid(9, seed, 0.5);
    Exact t = delaunay<Exact>(shape.input());
    const auto v = t.numbers().vertex_at(40 + seed);
    const std::vector<Complex> log = IT::logarithmic_map(t, v);
    const IT::Polyhedral_distance distance(t, v);
    unsigned ends = 0;
    for (const auto w : vertices(t.mesh())) {
      const std::uint32_t i = t.input_vertex(w);
      EXPECT_NEAR(std::abs(log[i]), distance.distance(w), 1e-14 * std::abs(log[i]));
      const auto passes = distance.shortest_path(w).points;
      const bool is_straight =
          std::none_of(passes.begin() + 1, passes.end() - (passes.size() > 1 ? 1 : 0),
                       [](const IT::Surface_point& p) { return p.weights[0] == 1; });
      if (w == v || !is_straight) continue;
      ++ends;
      const IT::Geodesic g = IT::exponential_map(t, v, log[i]);
      // rounding of the direction, over about ten faces
      EXPECT_LE(
          planar_bezier::distance(point_of(t, g.points.back(), shape.points), shape.points[i]),
          1e-12 * (1 + std::abs(log[i])));
    }
    EXPECT_GT(ends, 20U);
  }
}

TEST(Logarithmic_map, near_a_vertex_is_that_of_the_whole_surface) {
  const meshes::Mesh shape = meshes::potato(4, 3);
  Exact t = delaunay<Exact>(shape.input());
  const auto v = t.numbers().vertex_at(17);
  const std::vector<Complex> all = IT::logarithmic_map(t, v),
                             near = IT::logarithmic_map(t, v, IT::parameters::maximum_distance(1));
  std::size_t known = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_near = std::abs(all[i]) <= 1;
    known += is_near ? 1 : 0;
    EXPECT_TRUE(is_near ? near[i] == all[i] : std::isnan(near[i].real() + near[i].imag())) << i;
  }
  EXPECT_GT(known, 10U);
}

TEST(Logarithmic_map, ends_when_the_visitor_says_so) {
  struct Visitor {
    bool progress(std::uint64_t, double) const { return false; }
  };
  const Exact t = delaunay<Exact>(meshes::grid(40, 40).input());
  const auto v = t.numbers().vertex_at(0);
  const std::vector<Complex> some = IT::logarithmic_map(t, v, IT::parameters::visitor(Visitor()));
  const auto is_missing = [](const Complex& z) { return std::isnan(z.real()); };
  EXPECT_EQ(std::ranges::count_if(some, is_missing), 41 * 41 - 1023);
}

/// A cone of random height and number of sides, and a triangle beside it: no vector is shorter than
/// the chord, none is known there.
TEST(Logarithmic_map, says_where_it_does_not_know) {
  std::mt19937 random(4);
  for (int round = 0; round < 30; ++round) {
    const std::uint32_t n = 3 + static_cast<std::uint32_t>(random() % 12);
    const double height = std::exp(static_cast<double>(random() % 1000) / 100 - 5);
    meshes::Mesh shape;
    for (std::uint32_t i = 0; i < n; ++i)
      shape.points.push_back({std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0});
    shape.points.push_back({0, 0, height});
    for (std::uint32_t i = 0; i < n; ++i) shape.triangles.push_back({i, (i + 1) % n, n});
    for (const Point& p : {Point{9, 0, 0}, Point{10, 0, 0}, Point{9, 1, 0}})
      shape.points.push_back(p);
    shape.triangles.push_back({n + 1, n + 2, n + 3});
    Exact t = delaunay<Exact>(shape.input());
    const Heat heat(t);
    for (const auto v : vertices(t.mesh()))
      for (const auto method : all_methods) {
        SCOPED_TRACE(testing::Message() << n << " sides, height " << height << ", vertex "
                                        << t.input_vertex(v) << ", method " << int(method));
        const std::vector<Complex> log = heat.logarithmic_map(v, method);
        const bool is_beside = t.input_vertex(v) > n;
        for (std::uint32_t i = 0; i < log.size(); ++i) {
          if ((i > n) != is_beside) {
            EXPECT_TRUE(std::isnan(log[i].real()) && std::isnan(log[i].imag())) << i;
          } else if (method == IT::Logarithm_method::exact || !std::isnan(log[i].real())) {
            const double chord =
                planar_bezier::distance(shape.points[t.input_vertex(v)], shape.points[i]);
            EXPECT_GE(std::abs(log[i]), chord * (1 - 1e-14)) << i; // rounding of two lengths
          }
        }
      }
  }
}

} // namespace
