// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>

#include "delaunay.h"
#include "meshes.h"
#include "operator_test_meshes.h"
#include "soups.h"

#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace {

using namespace operator_test;
using Vector = Eigen::VectorXd;
// A triangulation without a name would end before the object that keeps a reference to it.
static_assert(!std::constructible_from<IT::Heat_distance<IT::Intrinsic_triangulation<>>,
                                       IT::Intrinsic_triangulation<>>);
constexpr double infinity = std::numeric_limits<double>::infinity();

template <class T>
std::vector<typename T::vertex_descriptor>
vertices_of_rows(const T& t, const std::vector<std::uint32_t>& rows) {
  std::vector<typename T::vertex_descriptor> result;
  for (const std::uint32_t r : rows) result.push_back(IT::vertex_of_row(t, r));
  return result;
}

// the distances on [0, n]^2 from its middle: the greatest error, relative to n
double error_on_square(std::uint32_t n, IT::Heat_border border) {
  const Shape s = rough_grid(n, 0.2, 0, 5);
  Exact t = delaunay<Exact>(s.input());
  const std::uint32_t middle = (n + 1) * (n / 2) + n / 2;
  IT::Heat_distance heat(t, IT::parameters::border_condition(border));
  const Vector d = heat.distances(IT::vertex_of_row(t, middle));
  double worst = 0;
  for (std::uint32_t v = 0; v < s.points.size(); ++v)
    worst = std::max(worst, std::abs(d[v] - (s.point(v) - s.point(middle)).norm()) / n);
  return worst;
}

TEST(Heat_distance, tends_to_the_distance_in_the_plane_as_edges_become_short) {
  const auto ratio = [](IT::Heat_border border) {
    const double coarse = error_on_square(12, border), fine = error_on_square(48, border);
    EXPECT_LT(coarse, 0.06);
    return fine / coarse;
  };
  EXPECT_LT(ratio(IT::Heat_border::average), 0.4);
  EXPECT_LT(ratio(IT::Heat_border::insulated), 0.7) << "errors at the border remain longer";
}

// Distances from a circle around a square torus: heat is a function of one coordinate, on the grid as on the torus, so that all
// gradients are right.
template <class T>
void expect_exact_from_circle(std::uint32_t x0) {
  constexpr std::uint32_t n = 12;
  const T t(torus(n, 0));
  const auto column = [&t](auto v) { return t.input_vertex(v) % n; };
  std::vector<typename T::halfedge_descriptor> circle;
  for (const auto e : edges(t.mesh())) {
    const auto h = halfedge(e, t.mesh());
    if (column(source(h, t.mesh())) == x0 && column(target(h, t.mesh())) == x0) circle.push_back(h);
  }
  ASSERT_EQ(circle.size(), n);
  const Vector d = IT::Heat_distance(t).distances(circle);
  for (std::uint32_t v = 0; v < n * n; ++v) {
    const std::uint32_t x = (v % n + n - x0) % n;
    EXPECT_NEAR(d[v], std::min(x, n - x), 1e-11) << "vertex " << v;
  }
}

TEST(Heat_distance, from_a_circle_around_a_torus_is_exact_on_every_mesh_type) {
  expect_exact_from_circle<Exact>(0);
  expect_exact_from_circle<Double>(3);
  expect_exact_from_circle<IT::Intrinsic_triangulation<Surface_mesh>>(5);
  expect_exact_from_circle<IT::Intrinsic_triangulation<Polyhedron_with_ids>>(5);
  expect_exact_from_circle<IT::Intrinsic_triangulation<OpenMesh_triangles>>(11);
}

TEST(Heat_distance, does_not_depend_on_the_correspondence) {
  const Shape s = rough_torus(12, 0.2, 3);
  const auto on = [&s](auto correspondence) {
    using C = decltype(correspondence);
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, C> t(s.input());
    IT::flip_to_delaunay(t);
    return IT::Heat_distance(t).distances(IT::vertex_of_row(t, 5));
  };
  const Vector d = on(IT::No_correspondence());
  EXPECT_LE((on(IT::Integer_coordinates()) - d).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LE((on(IT::Explicit_crossings()) - d).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LE((on(IT::Signposts()) - d).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Heat_distance, is_zero_at_each_of_many_sources_and_never_below_the_chord) {
  const Shape s = rough_torus(16, 0.3, 8);
  Exact t = delaunay<Exact>(s.input());
  IT::Heat_distance heat(t);
  for (const std::size_t many : {1U, 2U, 8U, 9U, 60U}) {
    std::vector<std::uint32_t> rows = random_order(s.points.size(), 7);
    rows.resize(many);
    const Vector d = heat.distances(vertices_of_rows(t, rows));
    for (const std::uint32_t r : rows) EXPECT_EQ(d[r], 0);
    for (std::uint32_t v = 0; v < s.points.size(); ++v) {
      double chord = infinity;
      for (const std::uint32_t r : rows) chord = std::min(chord, (s.point(v) - s.point(r)).norm());
      EXPECT_GE(d[v], chord * (1 - 1e-15)) << many << " sources, vertex " << v;
      EXPECT_LT(d[v], 20);
    }
  }
}

TEST(Heat_distance, of_inserted_vertices_is_not_below_the_chord_either) {
  const Shape s = rough_grid(6, 0.3, 0.6, 2);
  IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, IT::Integer_coordinates>
      t(s.input());
  IT::delaunay_refine(t, IT::parameters::minimum_angle(25).maximum_edge_length(0.4));
  const Vector d = IT::Heat_distance(t).distances(IT::vertex_of_row(t, 0));
  ASSERT_GT(d.size(), 49);
  for (const auto v : vertices(t.mesh())) {
    if (!t.is_inserted(v)) continue;
    const auto x = IT::point_in_space(t, t.correspondence().location(t.index(v)), s.points);
    EXPECT_GE(d[t.input_vertex(v)], (Eigen::Vector3d(x.data()) - s.point(0)).norm() * (1 - 1e-12));
  }
}

// Eleven sources are fixed by multipliers, and those of both tori together by elimination.
TEST(Heat_distance, of_few_sources_by_multipliers_is_that_by_elimination) {
  const Shape one = rough_torus(10, 0.2, 4);
  const auto n = static_cast<std::uint32_t>(one.points.size());
  const Exact t(beside(one, rough_torus(10, 0.2, 5)).input());
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < 11; ++i) rows.push_back((37 * i) % n);
  IT::Heat_distance heat(t);
  const Vector few = heat.distances(vertices_of_rows(t, rows));
  for (std::uint32_t i = 0; i < 10; ++i) rows.push_back(n + (37 * i) % n);
  const Vector many = heat.distances(vertices_of_rows(t, rows));
  EXPECT_LE((few.head(n) - many.head(n)).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_GT(many.maxCoeff(), 1);
}

TEST(Heat_distance, is_infinite_where_there_is_no_source) {
  Shape two = two_tetrahedra();
  two.points.push_back({9, 9, 9}); // isolated
  const Exact t(two.input());
  IT::Heat_distance heat(t);
  const Vector d = heat.distances(IT::vertex_of_row(t, 1));
  for (int v = 0; v < 9; ++v) EXPECT_EQ(std::isfinite(d[v]), v < 4);
  EXPECT_EQ(d[1], 0);
  const Vector both = heat.distances(vertices_of_rows(t, {1, 6}));
  for (int v = 0; v < 8; ++v) EXPECT_TRUE(std::isfinite(both[v]));
  EXPECT_NEAR(both[4], both[5], 1e-12) << "by symmetry";
  const Vector alone = heat.distances(IT::vertex_of_row(t, 8));
  EXPECT_EQ(alone[8], 0);
  EXPECT_EQ(alone[0], infinity);
  const Vector none = heat.distances(vertices_of_rows(t, {}));
  for (const double x : none) EXPECT_EQ(x, infinity);
}

TEST(Heat_distance, is_finite_on_every_complex_of_the_gallery) {
  for (const gallery::Surface& surface : gallery::oriented()) {
    if (surface.expected.faces == 0) continue;
    Exact t(input(surface));
    for (const bool is_delaunay : {false, true}) {
      if (is_delaunay) IT::flip_to_delaunay(t);
      IT::Heat_distance heat(t);
      for (const auto v : vertices(t.mesh())) {
        const Vector d = heat.distances(v);
        EXPECT_EQ(d[t.input_vertex(v)], 0) << surface;
        for (const double x : d) EXPECT_FALSE(std::isnan(x) || x < 0) << surface;
      }
      const auto h = *halfedges(t.mesh()).begin();
      for (const double x : heat.distances(h)) EXPECT_FALSE(std::isnan(x)) << surface;
    }
  }
}

/// A strip of 2 x length cells, whose vertices 3 x + y are at (place(x), y, height(x)).
template <class Place, class Height>
Shape strip(std::uint32_t length, const Place& place, const Height& height) {
  Shape s;
  for (std::uint32_t x = 0; x <= length; ++x)
    for (std::uint32_t y = 0; y < 3; ++y)
      s.points.push_back({place(x), static_cast<double>(y), height(x)});
  for (std::uint32_t v = 0; v < 3 * length; v += 3)
    for (const std::uint32_t i : {v, v + 1}) {
      s.triangles.push_back({i, i + 3, i + 4});
      s.triangles.push_back({i, i + 4, i + 1});
    }
  return s;
}

TEST(Heat_distance, is_right_where_heat_is_below_the_range_of_doubles) {
  // a strip of 3 x 2500 cells: heat is about exp(-0.96 x), 10^-1000 at its end
  const Shape s = strip(
      2500, [](double x) { return x; }, [](double) { return 0.; });
  const Exact t(s.input());
  IT::Heat_distance heat(t, IT::parameters::border_condition(IT::Heat_border::insulated));
  const Vector d = heat.distances(vertices_of_rows(t, {0, 1, 2}));
  for (std::uint32_t v = 0; v < s.points.size(); ++v)
    ASSERT_NEAR(d[v], s.points[v][0], 0.02 * s.points[v][0] + 1) << v;
}

TEST(Heat_distance, with_both_conditions_is_right_from_the_border_of_a_long_folded_strip) {
  // to and fro, so chords do not help; where heat is zero on the border, none comes from a source
  // there
  const auto folded = [](std::uint32_t x) {
    const double rest = x % 100;
    return x / 100 % 2 == 0 ? rest : 100 - rest;
  };
  const Shape s = strip(2400, folded, [](double x) { return x / 1000; });
  const Exact t(s.input());
  IT::Heat_distance heat(t); // average
  const Vector d = heat.distances(IT::vertex_of_row(t, 0));
  for (std::uint32_t v = 0; v < s.points.size(); ++v)
    ASSERT_NEAR(d[v], v / 3, 0.02 * (v / 3) + 2) << v;
}

TEST(Heat_distance, from_points_in_faces_and_polylines_is_that_in_the_plane) {
  const Shape s = grid(20);
  const Exact t(s.input());
  IT::Heat_distance heat(t);
  const auto f = *faces(t.mesh()).begin();
  const auto h = t.numbers().halfedge(halfedge(f, t.mesh()));
  const IT::Intrinsic_view<Exact> view(t);
  const auto place = [&](const IT::Surface_point& p) {
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    std::uint32_t g = p.halfedge;
    for (std::size_t k = 0; k < 3; ++k, g = view.next(g))
      x += p.weights[k] * s.point(t.input_vertex(t.numbers().vertex_at(view.source(g))));
    return x;
  };
  const IT::Surface_point p{h, {0.2, 0.5, 0.3}};
  const Vector from_point = heat.distances(p);
  for (std::uint32_t v = 0; v < s.points.size(); ++v)
    EXPECT_NEAR(from_point[v], (s.point(v) - place(p)).norm(), 1);
  for (std::uint32_t g = h, k = 0; k < 3; ++k, g = view.next(g)) {
    const std::uint32_t row = t.input_vertex(t.numbers().vertex_at(view.source(g)));
    EXPECT_NEAR(from_point[row], (s.point(row) - place(p)).norm(), 1e-14) << "corner of the face";
  }
  // from an edge to another, and on from there: the same point, described from the other face
  const IT::Surface_point on_edge{h, {0.5, 0.5, 0}}, other_edge{h, {0.5, 0, 0.5}};
  const Vector from_line = heat.distances(IT::Polyline_source{{on_edge, other_edge}});
  const Eigen::Vector3d a = place(on_edge), b = place(other_edge);
  for (std::uint32_t v = 0; v < s.points.size(); ++v) {
    const double x = std::clamp((s.point(v) - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    EXPECT_NEAR(from_line[v], (s.point(v) - a - x * (b - a)).norm(), 1);
  }
  const Vector vertex = heat.distances(IT::Surface_point{h, {0, 1, 0}});
  EXPECT_EQ(vertex, heat.distances(t.numbers().vertex_at(view.target(h))));
  EXPECT_EQ(vertex, heat.distances(IT::face_location(t, {h, {0, 1, 0}})));
}

TEST(Heat_distance, of_a_tufted_cover_is_that_of_the_surface) {
  const Shape s = rough_grid(9, 0.2, 0.4, 6);
  const Exact cover(
      IT::make_domain(soups::soup({s.points, s.triangles}), IT::Domain_kind::tufted_cover).input);
  const Exact t(s.input());
  const auto insulated = IT::parameters::border_condition(IT::Heat_border::insulated);
  IT::Heat_distance heat(t, insulated);
  // the mean edge is another one: edges on the border are there once, others twice
  const double factor = heat.time() / IT::Heat_distance(cover).time();
  const Vector expected = heat.distances(vertices_of_rows(t, {3, 77})),
               d = IT::Heat_distance(cover, insulated.time_factor(factor))
                       .distances(vertices_of_rows(cover, {3, 77}));
  ASSERT_EQ(d.size(), expected.size());
  EXPECT_LE((d - expected).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(Heat_distance, is_in_the_units_of_the_input) {
  Shape s = rough_torus(8, 0.2, 1);
  const auto distances = [](const Shape& shape) {
    const Exact t(shape.input());
    return IT::Heat_distance(t).distances(IT::vertex_of_row(t, 3));
  };
  const Vector d = distances(s);
  for (auto& p : s.points)
    for (double& x : p) x = std::ldexp(x, 500);
  EXPECT_EQ(distances(s), d * std::ldexp(1.0, 500));
}

// A sheared square of n x n cells in the plane, moved at random inside, by its lengths alone:
// without places, no chord hides errors. Its triangles have obtuse angles, with weights down to
// about -1.
double mean_error_on_sheared_square(unsigned seed, bool is_delaunay) {
  constexpr std::uint32_t n = 30;
  const Shape corners = grid(n);
  Shape s = rough_grid(n, 0.25, 0, seed);
  for (std::uint32_t v = 0; v < s.points.size(); ++v) {
    if (v % (n + 1) % n == 0 || v / (n + 1) % n == 0) s.points[v] = corners.points[v];
    s.points[v][0] -= 2 * s.points[v][1];
  }
  IT::Gluing_map map = s.gluing_map();
  std::vector<double> squared(map.number_of_edges());
  for (const auto e : edges(map)) {
    const auto h = halfedge(e, map);
    squared[h.index / 2] =
        (s.point(source(h, map).index) - s.point(target(h, map).index)).squaredNorm();
  }
  Double t(IT::Intrinsic_input(std::move(map), squared));
  if (is_delaunay) IT::flip_to_delaunay(t);
  const auto from = static_cast<std::uint32_t>(std::mt19937(seed)() % (n * n));
  const Vector d = IT::Heat_distance(t).distances(IT::vertex_of_row(t, from));
  double sum = 0;
  for (std::uint32_t v = 0; v < s.points.size(); ++v)
    if (const double exact = (s.point(v) - s.point(from)).norm(); exact > 0)
      sum += std::abs(d[v] - exact) / exact;
  return sum / static_cast<double>(s.points.size() - 1);
}

TEST(Heat_distance, with_negative_weights_follows_the_magnitude_of_heat) {
  // Magnitudes: 0.16 to 0.32 in 200 such squares; signed values: 0.43 to 0.88, as gradients point
  // away from the source where they are negative. Delaunay: 0.008 to 0.028.
  for (unsigned seed = 1; seed <= 6; ++seed) {
    EXPECT_LT(mean_error_on_sheared_square(seed, false), 0.35) << "seed " << seed;
    EXPECT_LT(mean_error_on_sheared_square(seed, true), 0.04) << "seed " << seed;
  }
}

struct Stop_after {
  std::size_t steps, calls = 0;
  bool progress(IT::Heat_step) { return ++calls < steps; }
};

TEST(Heat_distance, tells_a_visitor_of_its_steps_and_stops_when_told) {
  const Exact t(grid(4).input());
  for (const std::size_t steps :
       {1U, 2U, 3U, 4U}) { // two matrices, as there is a border, then heat
    Stop_after stop{steps};
    IT::Heat_distance heat(t, IT::parameters::visitor(std::ref(stop)));
    EXPECT_EQ(stop.calls, std::min<std::size_t>(steps, 2));
    const Vector d = heat.distances(*vertices(t.mesh()).begin());
    EXPECT_EQ(stop.calls, std::min<std::size_t>(steps, 3));
    EXPECT_EQ(heat.status(), steps < 4 ? IT::Status::cancelled : IT::Status::done);
    EXPECT_EQ(d.size(), steps < 4 ? 0 : 25);
  }
}

TEST(Heat_distance, refuses_what_makes_no_sense) {
  const Exact t(grid(2).input());
  for (const double factor : {0., infinity, 1e300, 1e-300})
    EXPECT_THROW(IT::Heat_distance(t, IT::parameters::time_factor(factor)), std::invalid_argument);
  IT::Heat_distance heat(t);
  for (const auto h : halfedges(t.mesh()))
    if (face(h, t.mesh()) == boost::graph_traits<Exact::Mesh>::null_face()) {
      EXPECT_THROW(heat.distances(IT::Surface_point{t.numbers().halfedge(h), {0.5, 0.5, 0}}),
                   std::invalid_argument);
    }
  const auto f = faces(t.mesh()).begin();
  const auto first = t.numbers().halfedge(halfedge(*f, t.mesh())),
             last = t.numbers().halfedge(halfedge(*std::prev(faces(t.mesh()).end()), t.mesh()));
  EXPECT_THROW(
      heat.distances(IT::Polyline_source{{{first, {0.4, 0.3, 0.3}}, {last, {0.4, 0.3, 0.3}}}}),
      std::invalid_argument);
  EXPECT_NEAR(heat.time() / IT::Heat_distance(t, IT::parameters::time_factor(0.5)).time(), 2,
              1e-15);
}

TEST(Heat_distance, tends_to_a_limit_for_long_times) {
  // Heat differs from the even one by area / time; the rest is that of the potential of the source.
  // Differences of heat lose the digits of time / area.
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Exact t = delaunay<Exact>(rough_torus(12, 0.2, seed).input());
    const double areas = IT::total_area(t) / IT::Heat_distance(t).time();
    const auto after = [&](double time) {
      return IT::Heat_distance(t, IT::parameters::time_factor(time * areas))
          .distances(IT::vertex_of_row(t, seed));
    };
    const Vector limit = after(1e6);
    std::mt19937 random(seed);
    const double time = std::pow(10, std::uniform_real_distribution<double>(5, 8)(random));
    EXPECT_LE((after(time) - limit).cwiseAbs().maxCoeff(), 1e-4) << "seed " << seed;
    EXPECT_THROW(after(std::pow(time, 4)), std::invalid_argument);
  }
}

TEST(Heat_distance, on_a_sphere_is_near_the_angle) {
  const meshes::Mesh sphere = meshes::sphere(4);
  const Exact t = delaunay<Exact>(sphere.input());
  const Vector d = IT::Heat_distance(t).distances(IT::vertex_of_row(t, 0));
  for (std::uint32_t v = 0; v < sphere.points.size(); ++v) {
    const Eigen::Vector3d p(sphere.points[0].data()), q(sphere.points[v].data());
    EXPECT_NEAR(d[v], std::acos(std::clamp(p.dot(q), -1.0, 1.0)), 0.06);
  }
}

} // namespace
