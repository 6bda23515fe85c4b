// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Surface_check.h>

#include "meshes.h"
#include "properties.h"
#include "subdivision_oracle.h"

#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/odt_optimize.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/adaptive_refine.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <boost/graph/graph_traits.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Inaccuracy;
using IT::Status;
using IT::internal::Surface_check;
using subdivision_oracle::Exact;
using subdivision_oracle::input;
using subdivision_oracle::Rounded;
using Kind = Inaccuracy::Kind;

/// Points of a parabola, all faces at one of them: doubles lose much of it.
meshes::Mesh flat_parabola_fan(std::uint32_t n) {
  meshes::Mesh m;
  for (std::uint32_t i = 0; i < n; ++i) m.points.push_back({double(i), double(i) * i / n, 0});
  for (std::uint32_t i = 1; i + 1 < n; ++i) m.triangles.push_back({0, i, i + 1});
  return m;
}

/// The first edge between two faces, with its values.
struct Spoilt {
  Rounded t;
  Rounded::halfedge_descriptor h;
  std::array<double, 3> values; // squared length, quadruple areas on the left and right

  explicit Spoilt(const meshes::Mesh& m) : t(input(m)) {
    for (const auto e : edges(t.mesh())) {
      if (CGAL::is_border(e, t.mesh())) continue;
      h = halfedge(e, t.mesh());
      const IT::Diamond d = t.diamond(h);
      values = {t.metric().squared_length(d.ij), t.metric().quadruple_area(d.f),
                t.metric().quadruple_area(d.g)};
      return;
    }
  }

  std::optional<Inaccuracy> after(double length_factor, double left_factor, double right_factor) {
    const Surface_check<Rounded> check(t);
    Rounded::Session(t).correct_values(
        h, {length_factor * values[0], left_factor * values[1], right_factor * values[2]});
    return check.find_inaccuracy();
  }

  std::uint32_t left() const { return t.index(face(h, t.mesh())); }
  std::uint32_t right() const { return t.index(face(opposite(h, t.mesh()), t.mesh())); }
};

const meshes::Mesh& mesh() {
  static const meshes::Mesh m = meshes::rough_grid(5, 3);
  return m;
}

TEST(Surface_check, Accepts_what_rounding_does) {
  EXPECT_FALSE(Spoilt(mesh()).after(1, 1, 1));
  EXPECT_FALSE(Spoilt(mesh()).after(1 + 1e-14, 1 + 1e-13, 1 - 1e-13));
}

TEST(Surface_check, Finds_faces_without_a_positive_area_or_length) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double factor :
       {0., -1., infinity, std::numeric_limits<double>::quiet_NaN(), -infinity}) {
    Spoilt s(mesh());
    const auto left = s.after(1, factor, 1);
    ASSERT_TRUE(left) << factor;
    EXPECT_EQ(left->kind, Kind::face);
    EXPECT_EQ(left->face, s.left());
    const auto both = Spoilt(mesh()).after(factor, 1, 1);
    ASSERT_TRUE(both) << factor;
    EXPECT_EQ(both->kind, Kind::face);
  }
}

TEST(Surface_check, Finds_the_face_that_its_sides_do_not_span) {
  Spoilt s(mesh());
  const auto found = s.after(1, 1, 1.001);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, Kind::shape);
  EXPECT_EQ(found->face, s.right());
}

TEST(Surface_check, Finds_area_that_is_lost_and_says_how_much) {
  Spoilt s(mesh());
  const double before = properties::total_area(s.t);
  const auto found = s.after(1, 1 - 2e-7, 1);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, Kind::total_area);
  EXPECT_EQ(found->face, s.left());
  EXPECT_NEAR(found->area_before, before, 1e-12 * before);
  EXPECT_NEAR(found->area_after, properties::total_area(s.t), 1e-12 * before);
  EXPECT_LT(found->area_after, found->area_before);
}

/// Shows one triangulation, then another.
struct Changing {
  using Metric = Rounded::Metric;
  using face_descriptor = Rounded::face_descriptor;
  using halfedge_descriptor = Rounded::halfedge_descriptor;
  const Rounded* t;
  const auto& mesh() const { return t->mesh(); }
  const auto& metric() const { return t->metric(); }
  const auto& numbers() const { return t->numbers(); }
  std::uint32_t index(face_descriptor f) const { return t->index(f); }
  std::uint32_t index(Rounded::edge_descriptor e) const { return t->index(e); }
};

TEST(Surface_check, Finds_another_topology) {
  const Rounded disk(input(meshes::grid(4, 4))), sphere(input(meshes::box(1, 1, 1)));
  Changing t{&disk};
  const Surface_check<Changing> check(t);
  EXPECT_FALSE(check.find_inaccuracy());
  t.t = &sphere;
  ASSERT_TRUE(check.find_inaccuracy());
  EXPECT_EQ(check.find_inaccuracy()->kind, Kind::topology);
}

TEST(Surface_check, Refinement_with_doubles_that_loses_area_is_inaccurate) {
  Rounded t(input(flat_parabola_fan(250)));
  const double before = properties::total_area(t);
  const auto result = IT::delaunay_refine(t, IT::parameters::minimum_angle(30.));
  // or else this mesh is not hard any more: find another
  ASSERT_GT(std::abs(properties::total_area(t) - before), 1e-7 * before);
  EXPECT_EQ(result.status, Status::inaccurate);
  ASSERT_TRUE(result.inaccuracy);
  EXPECT_LT(result.inaccuracy->face, t.numbers().face_capacity(t.mesh()));
  EXPECT_NEAR(result.inaccuracy->area_before, before, 1e-9 * before);
  EXPECT_NEAR(result.inaccuracy->area_after, properties::total_area(t), 1e-9 * before);
}

TEST(Surface_check, Adaptive_refinement_ends_where_doubles_have_lost_area) {
  Rounded t(input(flat_parabola_fan(250)));
  unsigned calls = 0;
  const auto estimate = [&calls](const Rounded& r) {
    ++calls;
    return std::vector<double>(r.numbers().face_capacity(r.mesh()), 1);
  };
  const auto result = IT::adaptive_refine(t, estimate, IT::parameters::minimum_angle(30.));
  EXPECT_EQ(result.status, Status::inaccurate);
  EXPECT_TRUE(result.inaccuracy);
  EXPECT_EQ(calls, 0U);
}

TEST(Surface_check, Optimisation_with_doubles_that_loses_area_is_inaccurate) {
  Rounded t(input(flat_parabola_fan(250)));
  const double before = properties::total_area(t);
  const auto result =
      IT::odt_optimize(t, IT::parameters::maximum_edge_length(5.).number_of_iterations(20U));
  const bool is_lost = std::abs(properties::total_area(t) - before) > 1e-3 * before;
  EXPECT_EQ(result.status == Status::inaccurate, is_lost);
  EXPECT_EQ(result.inaccuracy.has_value(), is_lost);
}

template <class T>
class Surface_check_of_what_is_right : public testing::Test {};
using Triangulations = testing::Types<Exact, Rounded>;
TYPED_TEST_SUITE(Surface_check_of_what_is_right, Triangulations);

TYPED_TEST(Surface_check_of_what_is_right, Finds_nothing) {
  for (const meshes::Mesh& m :
       {meshes::rough_grid(5, 3), meshes::potato(2, 5), meshes::stairs(3, 2, 1)}) {
    TypeParam t(input(m));
    const auto refined = IT::delaunay_refine(t, IT::parameters::minimum_angle(28.));
    EXPECT_EQ(refined.status, Status::done);
    EXPECT_FALSE(refined.inaccuracy);
    EXPECT_FALSE(IT::odt_optimize(t, IT::parameters::number_of_iterations(3U)).inaccuracy);
  }
}

} // namespace
