// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/improvement/describe_delaunay.h>
#include <CGAL/Intrinsic_operators/improvement/improve_and_measure.h>
#include <CGAL/Intrinsic_operators/improvement/reports.h>

#include "operator_test_meshes.h"

#include <CGAL/Intrinsic_triangulations/IO/soup/build_surface.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/points_of_rows.h>
#include <CGAL/Intrinsic_triangulations/input/Input_edges.h>
#include <CGAL/Intrinsic_triangulations/input/mollification.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/has_accurate_values.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Oracles: measure() and flip_to_delaunay() alone.

namespace {

using namespace operator_test;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;

Shape rough(unsigned seed) { return rough_grid(6, .45, .8, seed); }

IT::Built_surface<Triangulation> built(const Shape& s) {
  return IT::build_surface<Triangulation>(IT::Read_surface{s.input()});
}

IT::Improved_surface improved(IT::Built_surface<Triangulation>& b, const IT::Improve_options& o,
                              const std::vector<char>& marks = {}) {
  const auto kept = IT::labelled_input_edges(b.triangulation, marks);
  IT::Improved_surface result = IT::improve_soundly(b.triangulation, b.points, o, kept);
  IT::measure_improved(b.triangulation, b.points, kept, false, result);
  return result;
}

TEST(improve_and_measure, finds_what_flips_and_measure_find) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    auto b = built(rough(seed));
    const IT::Improved_surface result = improved(b, {});
    Triangulation t(rough(seed).input());
    EXPECT_EQ(result.done.flips.flips, IT::flip_to_delaunay(t).flips);
    // the same sum in another order
    const double rounding = 0x1p-53 * static_cast<double>(num_faces(t.mesh()));
    EXPECT_NEAR(result.input_area, IT::area_of_points(t), rounding * result.input_area);
    const IT::Measurements alone = IT::measure(t);
    EXPECT_EQ(result.measured.area, alone.area);
    EXPECT_EQ(result.measured.laplacian_trace, alone.laplacian_trace);
    ASSERT_TRUE(result.measured.dirichlet.has_value());
    EXPECT_STREQ(result.certificate(), "exact");
    EXPECT_EQ(result.shortcoming(), "");
  }
}

TEST(improve_and_measure, needs_points_of_inserted_vertices_or_none) {
  auto b = built(rough(3));
  Triangulation& t = b.triangulation;
  IT::Improve_options options;
  options.refine.emplace().minimum_angle = 25;
  const IT::Improved_surface result = improved(b, options);
  ASSERT_GT(t.number_of_vertices(), b.points.size());
  EXPECT_FALSE(result.measured.dirichlet.has_value());
  const auto all = IT::points_of_rows(t, b.points);
  const IT::Marked_edges<Triangulation, std::uint32_t> none(t);
  try {
    IT::measure(t, none, b.points);
    FAIL() << "points of inserted vertices were read, which there are not";
  } catch (const IT::Invalid_input& e) {
    EXPECT_EQ(e.index(), b.points.size());
    EXPECT_NE(std::string(e.what()).find("points_of_rows()"), std::string::npos);
  }
  EXPECT_TRUE(IT::measure(t, none, all).dirichlet.has_value());
}

// Values that users get, and enclosures: bit for bit.
std::vector<double> stored_values(const Triangulation& t) {
  std::vector<double> result;
  for (const auto e : edges(t.mesh())) {
    const auto& x = t.metric().squared_length(t.index(e));
    for (const double v : {x.inf(), x.sup(), t.metric().approximate_squared_length(t.index(e))})
      result.push_back(v);
  }
  for (const auto f : faces(t.mesh())) {
    const auto& x = t.metric().quadruple_area(t.index(f));
    for (const double v : {x.inf(), x.sup(), t.metric().approximate_quadruple_area(t.index(f))})
      result.push_back(v);
  }
  return result;
}

// Whether values are accurate after flips, and whether measuring changes what is stored.
std::array<bool, 2> accurate_and_changed(const IT::Intrinsic_input& input) {
  Triangulation t(input);
  IT::flip_to_delaunay(t);
  const std::vector<double> before = stored_values(t);
  const bool is_accurate = IT::has_accurate_values(t);
  EXPECT_EQ(stored_values(t), before);
  IT::measure(t, IT::Marked_edges<Triangulation, std::uint32_t>(t));
  return {is_accurate, stored_values(t) != before};
}

TEST(has_accurate_values, tells_that_measuring_will_not_change_what_is_stored) {
  for (const double stretch : {1., 1e-3, 1e-6}) // some vertices are in a grid of their own
    for (unsigned seed = 0; seed < 6; ++seed) {
      Shape s = rough_grid(4 + seed % 3, .45, seed % 2 == 0 ? 0 : .8 * stretch, seed);
      for (std::array<double, 3>& p : s.points)
        p[0] = stretch * (seed % 3 == 0 ? std::floor(8 * p[0]) : p[0]);
      const auto [is_accurate, is_changed] =
          accurate_and_changed(s.input(IT::Mollification::automatic));
      EXPECT_TRUE(is_accurate) << "stretch " << stretch << ", seed " << seed;
      EXPECT_FALSE(is_changed) << "stretch " << stretch << ", seed " << seed;
    }
  // intervals grow by each flip: with the first shears they are narrow
  for (const double shear : {.3, 1.7, 50.7, 200.3}) {
    const auto [is_accurate, is_changed] = accurate_and_changed(torus(3, shear));
    EXPECT_EQ(is_accurate, shear < 2) << shear;
    EXPECT_EQ(is_changed, shear > 2) << shear;
  }
  int changed = 0; // since weights are as small as rounding
  for (unsigned seed = 0; seed < 6; ++seed) {
    const auto [is_accurate, is_changed] =
        accurate_and_changed(rough_grid(6, 0x1p-50, 0, seed).input());
    EXPECT_NE(is_accurate, is_changed) << seed;
    changed += is_changed ? 1 : 0;
  }
  EXPECT_GT(changed, 0);
}

TEST(improve_and_measure, keeps_edges_of_the_input) {
  const Shape s = rough(3);
  auto b = built(s);
  IT::Input_edges edges(b.triangulation.input());
  std::vector<char> marks = edges.no_marks();
  ASSERT_TRUE(edges.mark(s.triangles[0][0], s.triangles[0][1], marks));
  ASSERT_TRUE(edges.mark(s.triangles[7][0], s.triangles[7][1], marks));
  const IT::Improved_surface result = improved(b, {}, marks);
  EXPECT_EQ(result.measured.edges.constrained, 2U);
}

TEST(improve_and_measure, says_that_an_unchanged_triangulation_is_not_delaunay) {
  auto b = built(rough(2));
  IT::Improve_options as_it_is;
  as_it_is.flips = false;
  const IT::Improved_surface result = improved(b, as_it_is);
  EXPECT_GT(result.measured.edges.non_delaunay, 0U);
  EXPECT_STREQ(result.certificate(), "none");
}

TEST(reports, have_what_was_built_done_and_measured) {
  auto b = built(rough(4));
  IT::Improve_options options;
  options.refine.emplace().minimum_angle = 25;
  IT::Report report = IT::surface_report("a grid", b.triangulation, b.facts);
  const IT::Improved_surface result = improved(b, options);
  IT::report_improvement(report, result, options, std::size_t{0});
  EXPECT_EQ(report.at("input").at("file").get<std::string>(), "a grid");
  EXPECT_EQ(report.at("input").at("vertices").get<std::int64_t>(),
            static_cast<std::int64_t>(b.facts.counts.vertices));
  EXPECT_EQ(report.at("arithmetic").get<std::string>(), "exact");
  EXPECT_EQ(report.at("correspondence").get<std::string>(), "integer");
  EXPECT_EQ(report.at("delaunay").at("flips").get<std::int64_t>(),
            static_cast<std::int64_t>(result.done.flips.flips));
  EXPECT_EQ(report.at("refine").at("asked_angle_deg").get<double>(), 25);
  EXPECT_EQ(report.at("refine").at("unsatisfied").get<IT::Report::Figures>().size(), 4U);
  EXPECT_EQ(report.at("certificate").get<std::string>(), result.certificate());
  EXPECT_EQ(report.at("area").at("intrinsic").get<double>(), result.measured.area);
  EXPECT_EQ(report.at("constraints").at("edges").get<std::int64_t>(), 0);
  for (const char* const name : {"read", "build", "topology", "delaunay", "refine", "verify"})
    EXPECT_TRUE(report.at("seconds").contains(name)) << name;
  const std::string text = IT::describe_delaunay(report);
  EXPECT_NE(text.find("exact arithmetic, certificate: exact"), std::string::npos);
  EXPECT_NE(text.find("vertices inserted"), std::string::npos);
}

} // namespace
