// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/improvement/improve.h>

#include "operator_test_meshes.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

// Oracles: sums over the triangles in space, angles by their cosines, products with matrices.

namespace {

using namespace operator_test;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Labels = IT::Marked_edges<Triangulation, std::uint32_t>;

Shape rough(unsigned seed) { return rough_grid(6, .45, .8, seed); }

// Many flips make it Delaunay.
Shape sheared_grid(double shear) {
  Shape s = rough_grid(12, .2, 0, 7);
  for (auto& p : s.points) p[0] += shear * p[1];
  return s;
}

// Isosceles trapezoids, one upon the other, in a tilted plane: every diagonal is a tie, and areas are
// irrational, so that weights in doubles are rarely zero.
Shape ladder(std::uint32_t rungs) {
  Shape s;
  for (std::uint32_t j = 0; j < rungs; ++j) {
    const double w = 1 + 7 * j % 11, y = j;
    s.points.push_back({y - w, -y - w, y});
    s.points.push_back({y + w, -y + w, y});
    if (j == 0) continue;
    const std::uint32_t i = 2 * j;
    s.triangles.push_back({i - 2, i - 1, i + 1});
    s.triangles.push_back({i - 2, i + 1, i});
  }
  return s;
}

double area_in_space(const Shape& s) {
  double sum = 0;
  for (const auto& [i, j, k] : s.triangles)
    sum += (s.point(j) - s.point(i)).cross(s.point(k) - s.point(i)).norm() / 2;
  return sum;
}

// By the law of cosines, from lengths.
double least_angle(const Triangulation& t) {
  double least = 180;
  for (const auto f : faces(t.mesh())) {
    std::array<double, 3> l{};
    auto h = halfedge(f, t.mesh());
    for (double& x : l) {
      x = t.length(edge(h, t.mesh()));
      h = next(h, t.mesh());
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = l[k], b = l[(k + 1) % 3], c = l[(k + 2) % 3];
      least = std::min(least,
                       std::acos((b * b + c * c - a * a) / (2 * b * c)) * 180 / std::numbers::pi);
    }
  }
  return least;
}

// The lengths of an image in a point are the same bit by bit: so are sums, unless they round upwards.
TEST(improve, measures_the_same_after_reflection_in_a_point) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Shape s = rough_grid(20, .45, .8, seed);
    Shape image = s;
    for (auto& p : image.points) p = {-p[0], -p[1], -p[2]};
    Triangulation t(s.input()), u(image.input());
    EXPECT_EQ(IT::measure(t, Labels(t), s.points).dirichlet,
              IT::measure(u, Labels(u), image.points).dirichlet);
  }
}

TEST(improve, flips_and_measure_agrees_with_matrices) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Shape s = rough(seed);
    Triangulation t(s.input());
    const IT::Improvement done = IT::improve(t);
    const IT::Measurements m = IT::measure(t, Labels(t), s.points);
    EXPECT_GT(done.flips.flips, 0U);
    EXPECT_EQ(m.edges.non_delaunay, 0U);
    EXPECT_GE(m.quality.minimum_weight, 0);
    EXPECT_NEAR(m.quality.minimum_angle, least_angle(t), 1e-6);
    const double area = area_in_space(s);
    EXPECT_NEAR(m.area, area, 1e-9 * area);
    EXPECT_NEAR(done.area_before, area, 1e-9 * area);
    EXPECT_NEAR(IT::area_of_points(t), area, 1e-9 * area);
    const Matrix l = IT::cotangent_laplacian(t);
    EXPECT_NEAR(m.laplacian_trace, Eigen::VectorXd(l.diagonal()).sum(), 1e-6);
    ASSERT_TRUE(m.dirichlet);
    for (Eigen::Index c = 0; c < 3; ++c) {
      Eigen::VectorXd x(static_cast<Eigen::Index>(s.points.size()));
      for (std::uint32_t v = 0; v < s.points.size(); ++v) x[v] = s.point(v)[c];
      EXPECT_NEAR((*m.dirichlet)[static_cast<std::size_t>(c)], x.dot(l * x), 1e-6) << seed;
    }
  }
}

// One pass over the edges has the signs, and the weights, that single questions have; on grids with
// ties, of which some are kept, and where flips have made intervals wide.
TEST(measure, tests_and_weighs_edges_as_single_questions_do) {
  std::size_t ties = 0, bad = 0, bad_kept = 0;
  for (unsigned seed = 0; seed <= 8; ++seed)
    for (const bool flips : {false, true}) {
      const Shape s = seed == 0   ? rough_grid(5, 0, 0, 1)
                      : seed == 7 ? sheared_grid(9.3)
                      : seed == 8 ? ladder(40)
                                  : rough(seed);
      Triangulation t(s.input());
      if (flips) IT::flip_to_delaunay(t);
      Labels kept(t);
      for (const auto e : edges(t.mesh()))
        if (t.index(e) % 5 == 0) put(kept, e, 1);
      std::vector<double> weights(t.numbers().edge_capacity(t.mesh()));
      const IT::Measurements m = IT::measure_shapes(
          t, kept, [&](const auto& h, double w) { weights[t.index(edge(h, t.mesh()))] = w; });
      const IT::Tested_edges& tested = m.edges;
      std::size_t constrained = 0, tied = 0, constrained_bad = 0, other_bad = 0;
      std::array<std::size_t, 10> counts{};
      for (const auto e : edges(t.mesh())) {
        const auto h = halfedge(e, t.mesh());
        const bool is_border = CGAL::is_border(e, t.mesh());
        const CGAL::Sign sign = is_border ? CGAL::POSITIVE : t.delaunay_sign(h);
        const double weight = Triangulation::Const_session(t).cotangent_weight(e);
        const bool is_kept = get(kept, e) != 0;
        constrained += std::size_t{is_kept};
        tied += std::size_t{!is_kept && sign == CGAL::ZERO};
        if (sign == CGAL::NEGATIVE) ++(is_kept ? constrained_bad : other_bad);
        EXPECT_NEAR(weights[t.index(e)], weight, 1e-9);
        EXPECT_NEAR(weights[t.index(e)], weight,
                    IT::statistics_tolerance * std::max(std::abs(weight), 1e-6));
        EXPECT_TRUE(sign != CGAL::ZERO || weights[t.index(e)] == 0);
        if (!is_border)
          ++counts[weight < 0 ? 0 : weight < 2 ? 1 + static_cast<std::size_t>(4 * weight) : 9];
      }
      EXPECT_EQ(m.quality.weights, counts);
      EXPECT_EQ(tested.constrained, constrained);
      EXPECT_EQ(tested.cocircular, tied);
      EXPECT_EQ(tested.non_delaunay, other_bad);
      EXPECT_EQ(tested.constrained_non_delaunay, constrained_bad);
      EXPECT_EQ(tested.probable_zero, 0U);
      ties += tied, bad += other_bad, bad_kept += constrained_bad;
    }
  EXPECT_GT(ties, 0U);
  EXPECT_GT(bad, 0U);
  EXPECT_GT(bad_kept, 0U);
}

TEST(measure, area_of_points_is_that_of_the_input_after_flips_also_of_doubles_alone) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Shape s = rough(seed);
    Double t(s.input());
    IT::flip_to_delaunay(t);
    EXPECT_NEAR(IT::area_of_points(t), area_in_space(s), 1e-12 * area_in_space(s));
    std::vector<double> squares;
    for (const auto e : edges(t.mesh())) squares.push_back(t.squared_length(e));
    EXPECT_TRUE(std::isnan(IT::area_of_points(Double(IT::Intrinsic_input(t.mesh(), squares)))));
  }
}

TEST(improve, changes_nothing_if_nothing_is_asked_for) {
  const Shape s = rough(1);
  Triangulation t(s.input()), before(s.input());
  IT::Improve_options options;
  options.flips = false;
  const IT::Improvement done = IT::improve(t, options);
  EXPECT_EQ(done.flips.flips, 0U);
  EXPECT_FALSE(done.refined || done.adapted || done.inaccuracy);
  for (const auto e : edges(t.mesh())) EXPECT_EQ(t.length(e), before.length(e));
  EXPECT_GT(IT::measure(t, Labels(t)).edges.non_delaunay, 0U);
  EXPECT_FALSE(IT::measure(t, Labels(t)).dirichlet);
}

TEST(improve, refines_to_angles_and_lengths) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Shape s = rough(seed);
    Triangulation t(s.input());
    IT::Improve_options options;
    options.refine.emplace();
    options.refine->minimum_angle = 25;
    options.refine->lengths.assign(s.points.size(), .5);
    const IT::Improvement done = IT::improve(t, options);
    ASSERT_TRUE(done.refined);
    EXPECT_EQ(done.refined->status, IT::Status::done);
    EXPECT_LE(done.refined->longest_side.value(), 1);
    EXPECT_GT(done.refined->points, s.points.size());
    EXPECT_NEAR(done.refined->minimum_angle, least_angle(t), 1e-6);
    if (done.refined->unsatisfied_faces() == 0) {
      EXPECT_GE(done.refined->minimum_angle, 25 - 1e-9);
    }
    EXPECT_LT(done.refined->quality_before.minimum_angle, 25);
    EXPECT_NEAR(IT::measure(t, Labels(t)).area, area_in_space(s), 1e-9 * area_in_space(s));
    for (const auto e : edges(t.mesh())) EXPECT_LE(t.length(e), .5 * (1 + 1e-9));
  }
}

TEST(improve, adapts_to_a_pole_and_refuses_what_has_none) {
  const Shape s = rough(2);
  Triangulation t(s.input());
  IT::Improve_options options;
  options.adapt.emplace();
  options.adapt->source = 24;
  options.adapt->tolerance = .05;
  const IT::Improvement done = IT::improve(t, options);
  ASSERT_TRUE(done.adapted);
  EXPECT_LE(done.adapted->result.rounds.back().estimated_error, .05 * done.adapted->unit);
  EXPECT_NEAR(done.adapted->unit, std::sqrt(area_in_space(s)), 1e-9);
  options.adapt->source = 49;
  EXPECT_THROW(IT::improve(t, options), IT::Invalid_input);
  options.adapt->source = 0;
  options.adapt->heat_time = 1e-200;
  EXPECT_THROW(IT::improve(t, options), IT::Invalid_input);
  Triangulation two(two_tetrahedra().input());
  options.adapt->heat_time = 0;
  EXPECT_THROW(IT::improve(two, options), IT::Invalid_input);
}

TEST(improve, ends_where_edges_would_be_too_many) {
  Triangulation t(rough(3).input());
  IT::Improve_options options;
  options.refine.emplace();
  options.refine->odt_length = 1e-7;
  EXPECT_THROW(IT::improve(t, options), IT::Invalid_input);
}

} // namespace
