// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Expression_steps.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>

#include "number_archetypes.h"

#include <CGAL/CORE_Expr.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

using namespace CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;

namespace {

using archetypes::Field_number;
using archetypes::Ring_number;

static_assert(RingNumber<Ring_number> && !FieldNumber<Ring_number>);
static_assert(FieldNumber<Field_number> && FieldNumber<float> && FieldNumber<Gmpq>);
static_assert(FieldNumber<CGAL::Interval_nt<false>> && FieldNumber<CORE::Expr>);
static_assert(RingNumber<Expression_degree> && !FieldNumber<Expression_degree>);
static_assert(!RingNumber<Diamond> && !RingNumber<const double> && !RingNumber<void>);

using Point = std::array<Gmpq, 2>;

Gmpq squared_distance(const Point& p, const Point& q) {
  const Gmpq x = p[0] - q[0], y = p[1] - q[1];
  return x * x + y * y;
}

// twice the signed area
Gmpq turn(const Point& p, const Point& q, const Point& r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

// positive iff d is outside of the circle through a, b, c, counterclockwise
Gmpq outside(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto row = [&d](const Point& p) {
    const Gmpq x = p[0] - d[0], y = p[1] - d[1];
    return std::array<Gmpq, 3>{x, y, x * x + y * y};
  };
  const auto u = row(a), v = row(b), w = row(c);
  return -(u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
           u[2] * (v[0] * w[1] - v[1] * w[0]));
}

// k to the left of ij, m to the right: all in the plane, rational
struct Quadrilateral {
  Point i, j, k, m;

  Diamond_values<Gmpq> values() const {
    return {squared_distance(i, j), squared_distance(j, k), squared_distance(k, i),
            squared_distance(i, m), squared_distance(m, j), Gmpq(2) * turn(i, j, k),
            Gmpq(2) * turn(j, i, m)};
  }
};

// all quadrilaterals on a small grid occur sooner or later, with their ties
class Random_quadrilaterals {
public:
  Quadrilateral operator()() {
    while (true) {
      const Quadrilateral q{point(), point(), point(), point()};
      if (turn(q.i, q.j, q.k) > 0 && turn(q.j, q.i, q.m) > 0) return q;
    }
  }

private:
  Point point() {
    return {Gmpq(static_cast<int>(random_() % 7)), Gmpq(static_cast<int>(random_() % 7))};
  }
  std::mt19937 random_{20260711};
};

TEST(Diamond, delaunay_expression_has_the_sign_of_the_test_against_the_circle) {
  Random_quadrilaterals draw;
  int ties = 0;
  for (int n = 0; n < 3000; ++n) {
    const Quadrilateral q = draw();
    const CGAL::Sign expected = CGAL::sign(outside(q.i, q.j, q.k, q.m));
    EXPECT_EQ(CGAL::sign(Delaunay_expression()(q.values())), expected);
    if (expected == CGAL::ZERO) ++ties;
  }
  EXPECT_GT(ties, 50);
}

TEST(Diamond, convexity_expressions_are_the_areas_that_a_flip_makes) {
  Random_quadrilaterals draw;
  for (int n = 0; n < 3000; ++n) {
    const Quadrilateral q = draw();
    const Diamond_values<Gmpq> d = q.values();
    EXPECT_EQ(Convexity_at_source_expression()(d), Gmpq(2) * d.ij * Gmpq(2) * turn(q.m, q.k, q.i));
    EXPECT_EQ(Convexity_at_target_expression()(d), Gmpq(2) * d.ij * Gmpq(2) * turn(q.k, q.m, q.j));
  }
}

TEST(Diamond, a_flip_makes_the_other_diagonal_and_its_triangles) {
  Random_quadrilaterals draw;
  for (int n = 0; n < 1000; ++n) {
    const Quadrilateral q = draw();
    const Flipped_values<Gmpq> f = flipped(q.values());
    EXPECT_EQ(f.km, squared_distance(q.k, q.m));
    EXPECT_EQ(f.area_f, Gmpq(2) * turn(q.k, q.m, q.j));
    EXPECT_EQ(f.area_g, Gmpq(2) * turn(q.m, q.k, q.i));
  }
}

TEST(Diamond, two_flips_are_the_identity_on_values) {
  Random_quadrilaterals draw;
  for (int n = 0; n < 1000; ++n) {
    const Diamond_values<Gmpq> d = draw().values();
    const Flipped_values<Gmpq> f = flipped(d);
    const Flipped_values<Gmpq> back =
        flipped<Gmpq>({f.km, d.mj, d.jk, d.ki, d.im, f.area_f, f.area_g});
    EXPECT_EQ(back.km, d.ij);
    EXPECT_EQ(back.area_f, d.area_g); // the halfedge has turned by half a turn
    EXPECT_EQ(back.area_g, d.area_f);
  }
}

TEST(Diamond, a_cap_on_the_left_is_not_delaunay_and_flips_to_two_proper_triangles) {
  const Quadrilateral q{
      {Gmpq(0), Gmpq(0)}, {Gmpq(4), Gmpq(0)}, {Gmpq(1), Gmpq(0)}, {Gmpq(2), Gmpq(-3)}};
  const Diamond_values<Gmpq> d = q.values();
  EXPECT_EQ(d.area_f, 0);
  EXPECT_LT(Delaunay_expression()(d), 0);
  const Flipped_values<Gmpq> f = flipped(d);
  EXPECT_EQ(f.km, 10);
  EXPECT_EQ(f.area_f, 18);
  EXPECT_EQ(f.area_g, 6);
}

TEST(Diamond, formulas_use_no_more_than_their_concepts_ask_for) {
  const auto ring = [](double x) { return Ring_number(x, Ring_number::Tag()); };
  const Ring_number one = ring(1), two = ring(2), area = ring(2);
  EXPECT_EQ(
      Delaunay_expression()(Diamond_values<Ring_number>{two, one, one, one, one, area, area}).value,
      0);
  EXPECT_EQ(squared_quadruple_area(two, one, one).value, 4);
  EXPECT_EQ(twice_inner_product(one, two, one).value, 0);
  EXPECT_EQ(scaled_corner(one, two, one, area).y.value, 2);

  const Field_number x(1), diagonal(2), a(2.0);
  const Diamond_values<Field_number> square{diagonal, x, x, x, x, a, a};
  EXPECT_EQ(flipped(square).km.value, 2);
  EXPECT_EQ(cotangent_weight(square).value, 0);
  EXPECT_EQ(apex(x, diagonal, x, a).y.value, 1);
  EXPECT_EQ(squared_distance_from_corner(x, diagonal, x, a, x, Field_number(0)).value, 1);
  EXPECT_EQ(removed_from_border_edge(square).km.value, 2);
  const std::vector<Field_number> ones(4, x), diagonals(4, diagonal), areas(4, a);
  const Whole_star_values<Field_number> star{ones, diagonals, areas};
  EXPECT_EQ(moved_in_star(star, Field_number(0.5), Field_number(0)).spokes[2].value, 2.25);
}

} // namespace
