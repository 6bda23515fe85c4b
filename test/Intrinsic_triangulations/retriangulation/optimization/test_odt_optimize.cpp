// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/odt_optimize.h>

#include "constrained_edges.h"
#include "meshes.h"
#include "properties.h"
#include "subdivision_oracle.h"

#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <boost/property_map/property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using constrained_edges::Constraints;
using constrained_edges::Edge_map;
using constrained_edges::total_length;
using IT::Status;
using subdivision_oracle::Exact;
using subdivision_oracle::input;
using subdivision_oracle::Rounded;
using Plane = std::array<double, 2>;

Plane minus(const Plane& a, const Plane& b) { return {a[0] - b[0], a[1] - b[1]}; }
double square(const Plane& a) { return a[0] * a[0] + a[1] * a[1]; }
double cross(const Plane& a, const Plane& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Twelve times the energy of a star, from the positions of its center and rim.
double star_energy(const Plane& p, const std::vector<Plane>& rim, double& area) {
  double energy = 0;
  area = 0;
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const Plane a = minus(rim[k], p), b = minus(rim[(k + 1) % rim.size()], p);
    area += cross(a, b) / 2;
    energy += cross(a, b) / 2 * (square(a) + square(b) + square(minus(a, b)));
  }
  return energy;
}

/// A polygon that is star-shaped about the origin, as a fan.
meshes::Mesh fan(const std::vector<Plane>& rim) {
  meshes::Mesh m;
  m.points.push_back({0, 0, 0});
  const auto n = static_cast<std::uint32_t>(rim.size());
  for (std::uint32_t k = 0; k < n; ++k) {
    m.points.push_back({rim[k][0], rim[k][1], 0});
    m.triangles.push_back({0, k + 1, (k + 1) % n + 1});
  }
  return m;
}

std::vector<Plane> random_rim(std::mt19937_64& random) {
  std::uniform_real_distribution<double> radius(0.5, 2), shift(-0.3, 0.3);
  const auto n = 3 + static_cast<unsigned>(random() % 6);
  std::vector<Plane> rim;
  for (unsigned k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * (k + shift(random)) / n, r = radius(random);
    rim.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return rim;
}

TEST(Odt_energy, Is_the_error_of_interpolating_the_square_of_the_distance) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> x(-1, 1);
  for (int i = 0; i < 20; ++i) {
    std::array<Plane, 3> p;
    for (Plane& q : p) q = {x(random), x(random)};
    const double area = std::abs(cross(minus(p[1], p[0]), minus(p[2], p[0]))) / 2;
    // midpoints of sides integrate polynomials of degree two exactly
    double error = 0;
    for (unsigned k = 0; k < 3; ++k) {
      const Plane &a = p[k], &b = p[(k + 1) % 3];
      error +=
          area / 3 * ((square(a) + square(b)) / 2 - square({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}));
    }
    meshes::Mesh m{{{p[0][0], p[0][1], 0}, {p[1][0], p[1][1], 0}, {p[2][0], p[2][1], 0}},
                   {{0, 1, 2}}};
    EXPECT_NEAR(IT::odt_energy(Rounded(input(m))), error, 1e-14);
    EXPECT_NEAR(IT::odt_energy(Rounded(input(meshes::scaled(m, 8)))), 4096 * error, 4096 * 1e-14);
  }
}

TEST(Planar_star, Has_its_least_energy_at_the_mean_of_circumcenters) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> x(-1, 1);
  for (int i = 0; i < 50; ++i) {
    const std::vector<Plane> rim = random_rim(random);
    const Rounded t(input(fan(rim)));
    const IT::Intrinsic_view view(t);
    IT::internal::Planar_star star;
    ASSERT_TRUE(star.load(view, view.outgoing_halfedge(0)));
    // the layout starts with the first spoke on the x-axis
    const Plane first = rim[view.target(star.spokes()[0]) - 1];
    const double c = first[0] / std::sqrt(square(first)), s = first[1] / std::sqrt(square(first));
    const auto turned = [&](const Plane& p) {
      return Plane{c * p[0] - s * p[1], s * p[0] + c * p[1]};
    };
    const double unit = std::ldexp(1, -t.metric().scale_exponent());
    const Plane best = turned({unit * star.optimum()[0], unit * star.optimum()[1]});
    double area = 0;
    const double least = star_energy(best, rim, area);
    for (int k = 0; k < 5; ++k) {
      const Plane d{x(random), x(random)};
      // its integral of |x|^2 is that of linear functions, and |x|^2 |star| / 3
      EXPECT_NEAR(star_energy({best[0] + d[0], best[1] + d[1]}, rim, area) - least,
                  4 * area * square(d), 1e-11);
    }
  }
}

TEST(Planar_star, Refuses_what_is_not_flat_or_on_the_border) {
  const Rounded flat(input(fan({{1, 0}, {0, 1}, {-1, -1}})));
  const Rounded cone(input(meshes::potato(1, 3)));
  IT::internal::Planar_star star;
  const IT::Intrinsic_view view(flat);
  EXPECT_TRUE(star.load(view, view.outgoing_halfedge(0)));
  EXPECT_FALSE(star.load(view, view.outgoing_halfedge(1)));
  const IT::Intrinsic_view cone_view(cone);
  EXPECT_FALSE(star.load(cone_view, cone_view.outgoing_halfedge(0)));
}

template <class T>
class Odt_optimize : public testing::Test {};
using Triangulations = testing::Types<Exact, Rounded>;
TYPED_TEST_SUITE(Odt_optimize, Triangulations);

TYPED_TEST(Odt_optimize, Moves_a_vertex_to_the_center_of_a_regular_hexagon) {
  meshes::Mesh m;
  for (int k = 0; k < 6; ++k) {
    const double angle = std::numbers::pi * k / 3;
    m.points.push_back({std::cos(angle), std::sin(angle), 0});
  }
  m.triangles = {{0, 1, 2}, {2, 3, 4}, {4, 5, 0}, {0, 2, 4}};
  TypeParam t(input(m));
  const auto n = t.insert_vertex(halfedge(*faces(t.mesh()).begin(), t.mesh()), {0.3, 0.2, 0.5});
  ASSERT_EQ(n.status, IT::Move_status::done);
  const auto result = IT::odt_optimize(t);
  EXPECT_EQ(result.status, Status::done);
  int n_edges = 0; // those that were removed are counted by num_edges()
  for (const auto e : edges(t.mesh())) {
    ++n_edges;
    EXPECT_NEAR(t.squared_length(e), 1, 1e-12);
  }
  EXPECT_EQ(n_edges, 12);
}

/// Notes the energy after every call.
template <class T>
struct Energies {
  const T* t;
  std::vector<double> values{};
  bool progress(const IT::Odt_result&) {
    values.push_back(IT::odt_energy(*t));
    return true;
  }
};

TYPED_TEST(Odt_optimize, Lowers_the_energy_and_keeps_the_surface) {
  int n = 0;
  for (const meshes::Mesh& m :
       {meshes::rough_grid(3, 3), meshes::potato(1, 5), meshes::sheared_grid(3, 3, 2),
        meshes::prism({{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 2)}) {
    SCOPED_TRACE(n++);
    TypeParam t(input(m));
    const double area = properties::total_area(t);
    const std::vector<double> angles = properties::cone_angles(t);
    const auto euler = properties::euler_characteristic(t);
    const double target = 0.8 * std::sqrt(area / static_cast<double>(num_faces(t.mesh())));
    Energies<TypeParam> energies{&t};
    const auto result = IT::odt_optimize(
        t,
        IT::parameters::maximum_edge_length(target).convergence(1e-2).visitor(std::ref(energies)));
    EXPECT_EQ(result.status, Status::done);
    EXPECT_EQ(result.refused, 0U);
    EXPECT_GT(result.splits, 0U);
    EXPECT_GT(result.moves, 0U);
    EXPECT_NEAR(properties::total_area(t), area, 1e-12 * area);
    EXPECT_EQ(properties::euler_characteristic(t), euler);
    EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, 0U);
    const std::vector<double> now = properties::cone_angles(t);
    for (std::size_t v = 0; v < angles.size(); ++v) EXPECT_NEAR(now[v], angles[v], 1e-10);
    double energy = result.energy_before;
    for (const double e : energies.values) {
      EXPECT_LE(e, energy * (1 + 1e-12));
      energy = e;
    }
    EXPECT_NEAR(energies.values.back(), result.energy_after, 1e-12 * energy);
    for (const auto e : edges(t.mesh()))
      EXPECT_LE(t.squared_length(e), target * target * 1.21); // moves after the last splits
    EXPECT_EQ(subdivision_oracle::defect(t), "");
    const IT::Common_subdivision s = IT::common_subdivision(t);
    EXPECT_GE(s.number_of_faces(), num_faces(t.mesh()));
  }
}

TYPED_TEST(Odt_optimize, Keeps_constrained_edges_and_the_border) {
  TypeParam t(input(meshes::sheared_grid(3, 4, 2)));
  Edge_map marks, border_marks;
  Constraints<TypeParam> constrained{&t, &marks}, border{&t, &border_marks};
  int k = 0;
  for (const auto e : edges(t.mesh())) {
    put(constrained, e, ++k % 7 == 0);
    put(border, e, CGAL::is_border(e, t.mesh()));
  }
  const double length = total_length(t, constrained), rim = total_length(t, border);
  const auto result = IT::odt_optimize(
      t, IT::parameters::maximum_edge_length(0.6).convergence(1e-2).edge_is_constrained_map(
             constrained));
  EXPECT_EQ(result.status, Status::done);
  EXPECT_GT(result.moves, 0U);
  EXPECT_NEAR(total_length(t, constrained), length, 1e-12 * length);
  for (const auto e : edges(t.mesh())) put(border, e, CGAL::is_border(e, t.mesh()));
  EXPECT_NEAR(total_length(t, border), rim, 1e-12 * rim);
  typename TypeParam::Session session(t);
  for (const auto e : edges(t.mesh()))
    EXPECT_TRUE(get(constrained, e) || session.is_locally_delaunay(halfedge(e, t.mesh())));
}

/// Standard deviation of the areas of faces by their mean.
template <class T>
double variation_of_areas(const T& t) {
  double sum = 0, squares = 0;
  for (const auto f : faces(t.mesh())) {
    sum += t.area(f);
    squares += t.area(f) * t.area(f);
  }
  const auto n = static_cast<double>(num_faces(t.mesh()));
  return std::sqrt(squares / n - sum * sum / (n * n)) / (sum / n);
}

template <class T>
std::size_t number_of_vertices(const T& t) { // removed ones are counted by num_vertices()
  std::size_t n = 0;
  for ([[maybe_unused]] const auto v : vertices(t.mesh())) ++n;
  return n;
}

// The moves alone leave angles of a few degrees. What the result tells is what there is, with the
// bound and without.
TYPED_TEST(Odt_optimize, Keeps_the_least_angle_that_is_asked_for) {
  for (const unsigned seed : {1U, 2U, 3U})
    for (const meshes::Mesh& m :
         {meshes::rough_grid(4, seed), meshes::potato(1, seed), meshes::sheared_grid(3, 3, 2)})
      for (const double angle : {0., 25.}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << angle << " degrees");
        TypeParam t(input(m));
        Edge_map marks;
        Constraints<TypeParam> constrained{&t, &marks};
        std::mt19937 random(seed);
        for (const auto e : edges(t.mesh())) put(constrained, e, random() % 9 == 0);
        const double length = total_length(t, constrained);
        double mean = 0;
        for (const auto e : edges(t.mesh())) mean += t.length(e);
        mean /= static_cast<double>(num_edges(t.mesh()));
        IT::delaunay_refine(t, IT::parameters::edge_is_constrained_map(constrained));
        const auto result = IT::odt_optimize(t, IT::parameters::maximum_edge_length(0.6 * mean)
                                                    .minimum_angle(angle)
                                                    .edge_is_constrained_map(constrained));
        EXPECT_EQ(result.status, Status::done);
        std::vector<double> angles;
        for (const auto f : faces(t.mesh())) angles.push_back(properties::least_angle(t, f));
        const auto small =
            std::ranges::count_if(angles, [&](double a) { return a < angle - 1e-6; });
        EXPECT_EQ(result.unsatisfied_faces, static_cast<std::size_t>(small));
        // an arc cosine near 1 loses half of the digits
        EXPECT_NEAR(*std::ranges::min_element(angles), result.minimum_angle, 1e-6);
        EXPECT_TRUE(angle > 0 || result.insertions == 0);
        EXPECT_NEAR(result.energy_after, IT::odt_energy(t), 1e-12 * result.energy_after);
        EXPECT_NEAR(total_length(t, constrained), length, 1e-12 * length);
      }
}

TEST(Odt, Makes_areas_more_even_than_refinement_and_uses_its_vertices_better) {
  const meshes::Mesh m = meshes::potato(2, 5);
  Rounded refined(input(m)), optimal(input(m));
  const double target = 0.1;
  IT::delaunay_refine(refined, IT::parameters::minimum_angle(25).maximum_edge_length(target));
  const auto result = IT::odt_optimize(optimal, IT::parameters::maximum_edge_length(target));
  EXPECT_EQ(result.status, Status::done);
  EXPECT_LT(variation_of_areas(optimal), 0.8 * variation_of_areas(refined));
  // the energy of an even triangulation goes with one by the number of its vertices
  EXPECT_LT(IT::odt_energy(optimal) * static_cast<double>(number_of_vertices(optimal)),
            IT::odt_energy(refined) * static_cast<double>(number_of_vertices(refined)));
}

TEST(Odt, Improves_what_was_refined_before_without_adding_vertices) {
  Rounded t(input(meshes::potato(2, 5)));
  IT::delaunay_refine(t, IT::parameters::minimum_angle(25).maximum_edge_length(0.15));
  const std::size_t n = number_of_vertices(t);
  const double before = variation_of_areas(t);
  const auto result = IT::odt_optimize(t);
  EXPECT_EQ(result.status, Status::done);
  EXPECT_EQ(number_of_vertices(t), n);
  EXPECT_LT(variation_of_areas(t), 0.8 * before);
  EXPECT_LT(result.energy_after, result.energy_before);
}

struct Stop {
  int calls = 0;
  bool progress(const IT::Odt_result&) { return ++calls < 2; }
};

TEST(Odt, Stops_at_its_caps_and_when_asked_to) {
  const meshes::Mesh m = meshes::potato(1, 5);
  {
    Rounded t(input(m));
    const auto result =
        IT::odt_optimize(t, IT::parameters::maximum_edge_length(0.05).maximum_insertions(10));
    EXPECT_EQ(result.status, Status::cap);
    EXPECT_EQ(result.splits, 10U);
    EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, 0U);
  }
  {
    Rounded t(input(m));
    const auto result =
        IT::odt_optimize(t, IT::parameters::maximum_edge_length(0.1).number_of_iterations(1));
    EXPECT_EQ(result.status, Status::cap);
    EXPECT_EQ(result.iterations, 1U);
  }
  {
    Rounded t(input(m));
    Stop stop;
    const auto result =
        IT::odt_optimize(t, IT::parameters::maximum_edge_length(0.1).visitor(std::ref(stop)));
    EXPECT_EQ(result.status, Status::cancelled);
    EXPECT_EQ(stop.calls, 2);
  }
  Rounded t(input(m));
  EXPECT_THROW(IT::odt_optimize(t, IT::parameters::maximum_edge_length(0)), std::invalid_argument);
  EXPECT_THROW(IT::odt_optimize(t, IT::parameters::maximum_edge_length(std::nan(""))),
               std::invalid_argument);
}

TEST(Odt, Does_nothing_without_vertices_to_move) {
  Rounded t(input(meshes::potato(1, 5)));
  const auto result = IT::odt_optimize(t);
  EXPECT_EQ(result.status, Status::done);
  EXPECT_EQ(result.moves + result.splits, 0U);
}

/// Areas and lengths are stored apart: where vertices move again and again they must go on fitting.
TEST(Odt, Sides_of_faces_span_their_areas_after_many_moves_with_doubles) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    Rounded t(input(meshes::rough_grid(6, seed)));
    IT::delaunay_refine(t, IT::parameters::minimum_angle(30.));
    const auto result = IT::odt_optimize(
        t, IT::parameters::maximum_edge_length(0.3).number_of_iterations(40U).convergence(0.));
    EXPECT_GT(result.moves, 10000U);
    EXPECT_NE(result.status, Status::inaccurate);
    for (const auto f : faces(t.mesh())) {
      const auto h = halfedge(f, t.mesh()), n = next(h, t.mesh());
      const double a = t.length(edge(h, t.mesh())), b = t.length(edge(n, t.mesh())),
                   c = t.length(edge(next(n, t.mesh()), t.mesh())), s = (a + b + c) / 2;
      EXPECT_NEAR(t.area(f), std::sqrt(s * (s - a) * (s - b) * (s - c)), 1e-9 * s * s);
    }
  }
}

} // namespace
