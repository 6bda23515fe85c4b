// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "html_pages.h"
#include "subdivisions.h"

#include <CGAL/Intrinsic_triangulations/IO/view/write_html_view.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Points = subdivisions::Points;

using html_pages::numbers;
using html_pages::simple_view;

struct Page {
  std::string text;
  IT::Html_view_report report;
};

Page page(const IT::Common_subdivision& s, const Points& points, const IT::Html_view& view) {
  std::ostringstream out;
  const IT::Html_view_report report = IT::write_html_view(out, s, points, view);
  return {out.str(), report};
}

// circles about the middle of the unit square, in space on its plane
std::vector<IT::Polyline> circles(std::size_t count, std::size_t points) {
  std::vector<IT::Polyline> result;
  for (std::size_t c = 0; c < count; ++c) {
    IT::Polyline circle{{}, true, static_cast<std::int32_t>(c)};
    for (std::size_t i = 0; i < points; ++i) {
      const double a = 2 * 3.14159265358979 * static_cast<double>(i) / static_cast<double>(points);
      const double r = 0.5 * static_cast<double>(c + 1) / static_cast<double>(count);
      circle.points.push_back({0.5 + r * std::cos(a), 0.5 + r * std::sin(a), 0});
    }
    result.push_back(std::move(circle));
  }
  return result;
}

Points unit_points(const IT::Common_subdivision& s, std::uint32_t n) {
  Points points = IT::positions(s, subdivisions::grid_points(n));
  for (auto& p : points) p = {3 * p[0] / n, 7 * p[1] / n, 0};
  return points;
}

} // namespace

TEST(Bounds_of_pages, A_surface_keeps_its_shape_and_the_numbers_of_the_vertices_that_stay) {
  constexpr std::uint32_t n = 60;
  const auto s = subdivisions::grid(n);
  const Points points = unit_points(s, n);
  std::vector<double> x;
  for (const auto& p : points) x.push_back(p[0]);
  const IT::Subdivision_field field("height", x);
  IT::Html_view view = simple_view();
  view.fields = std::span(&field, 1);
  const Page all = page(s, points, view);
  EXPECT_TRUE(all.report.is_complete());
  EXPECT_EQ(all.text.find("thinned"), std::string::npos);
  view.maximum_size = all.text.size() / 2;
  const Page thin = page(s, points, view);
  EXPECT_LE(thin.text.size(), view.maximum_size);
  EXPECT_GE(thin.text.size(), view.maximum_size / 2); // not less than there is room for
  EXPECT_EQ(thin.report.pieces, 4u * n * n);
  EXPECT_LT(thin.report.shown_pieces, thin.report.pieces);
  EXPECT_FALSE(thin.report.is_complete());
  EXPECT_NE(thin.text.find(thin.report.description()), std::string::npos);

  const auto corner = numbers<std::uint32_t>(thin.text, "triangles");
  const auto place = numbers<float>(thin.text, "points");
  const auto label = numbers<std::uint32_t>(thin.text, "labels");
  const auto value = numbers<float>(thin.text, "field-0");
  const auto source = numbers<std::uint32_t>(thin.text, "sources");
  EXPECT_EQ(corner.size(), 3 * thin.report.shown_pieces);
  EXPECT_EQ(source.size(), 2 * thin.report.shown_pieces);
  EXPECT_EQ(place.size(), 3 * value.size());
  EXPECT_EQ(label.size(), 2 * value.size());
  const auto radius = static_cast<float>(std::sqrt(0.5));
  double area = 0;
  for (std::size_t t = 0; t < corner.size(); t += 3) {
    const float* const a = &place[3 * corner[t]];
    const float* const b = &place[3 * corner[t + 1]];
    const float* const c = &place[3 * corner[t + 2]];
    area += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
  }
  EXPECT_NEAR(area * radius * radius, 1, 0.15); // the border moves by a cell
  for (std::size_t v = 0; v < value.size(); ++v)
    EXPECT_NEAR(value[v], 0.5f + radius * place[3 * v], 1e-5f);
  for (const std::string id : {"input-edges", "intrinsic-edges"}) {
    const auto ends = numbers<std::uint32_t>(thin.text, id);
    EXPECT_EQ(ends.size(), 2 * numbers<float>(thin.text, id + "-room").size());
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t e = 0; e < ends.size(); e += 2) {
      EXPECT_LT(ends[e], ends[e + 1]);
      EXPECT_TRUE(pairs.insert({ends[e], ends[e + 1]}).second);
    }
  }
}

TEST(Bounds_of_pages, Curves_lose_points_within_a_tolerance_before_they_go) {
  const auto s = subdivisions::grid(2);
  const Points points = unit_points(s, 2);
  const auto curves = circles(100, 2000);
  IT::Html_view view = simple_view();
  view.curves = curves;
  const Page all = page(s, points, view);
  EXPECT_TRUE(all.report.is_complete());
  EXPECT_EQ(numbers<float>(all.text, "curves").size(), 3u * 100 * 2000);
  EXPECT_EQ(numbers<std::int32_t>(all.text, "curves-sizes"), std::vector<std::int32_t>(100, -2000));
  view.maximum_size = 1'000'000;
  const Page thin = page(s, points, view);
  EXPECT_LE(thin.text.size(), view.maximum_size);
  EXPECT_EQ(thin.report.shown_pieces, thin.report.pieces);
  EXPECT_EQ(thin.report.shown_curves, 100u);
  EXPECT_GT(thin.report.curve_tolerance, 0);
  EXPECT_LT(thin.report.curve_tolerance, 0.004);
  const auto size = numbers<std::int32_t>(thin.text, "curves-sizes");
  const auto place = numbers<float>(thin.text, "curves");
  const double radius = std::sqrt(0.5);
  std::size_t first = 0;
  for (std::size_t c = 0; c < 100; ++c) {
    ASSERT_LT(size[c], 0);
    const auto n = static_cast<std::size_t>(-size[c]);
    for (const auto& p : curves[c].points) { // each has a neighbour on the page
      double nearest = 1;
      for (std::size_t i = 3 * first; i < 3 * (first + n); i += 3)
        nearest = std::min(nearest, std::hypot(p[0] - 0.5 - radius * double{place[i]},
                                               p[1] - 0.5 - radius * double{place[i + 1]}));
      ASSERT_LE(nearest, thin.report.curve_tolerance + 1e-6);
    }
    first += n;
  }
}

TEST(Bounds_of_pages, Whatever_is_given_the_page_is_bounded) {
  constexpr std::uint32_t n = 40;
  const auto s = subdivisions::grid(n);
  const Points points = unit_points(s, n);
  const auto many = circles(20000, 8), few = circles(1, 200000), some = circles(3000, 50);
  const std::vector<IT::Polyline> marks(100000, {{{0.5, 0.5, 0}}, false, 1});
  std::vector<IT::Placed_vector> vectors;
  for (int i = 0; i < 300000; ++i) vectors.push_back({{i / 3e5, 0.5, 0}, {1, 0, 0}});
  std::vector<IT::Subdivision_field> fields;
  for (int i = 0; i < 70; ++i)
    fields.push_back({"f" + std::to_string(i), std::vector<double>(s.number_of_vertices(), i)});
  for (const auto* curves : {&many, &few, &some})
    for (const bool has_all : {false, true}) {
      IT::Html_view view = simple_view();
      view.curves = *curves;
      view.initial_curves = *curves;
      if (has_all) {
        view.marks = marks;
        view.fields = fields;
        view.vectors = vectors;
      }
      view.maximum_size = 1'200'000;
      const Page thin = page(s, points, view);
      EXPECT_LE(thin.text.size(), view.maximum_size) << curves->size() << has_all;
      EXPECT_GT(thin.report.shown_curves, 0u);
      EXPECT_EQ(thin.report.shown_fields, has_all ? 64u : 0u);
      EXPECT_EQ(thin.report.shown_marks, has_all ? 20000u : 0u);
      EXPECT_FALSE(thin.report.description().empty());
    }
}

namespace {

// up on the page of a surface
std::array<double, 3> up_of(const IT::Common_subdivision& s, const Points& points) {
  const auto axes = numbers<float>(page(s, points, simple_view()).text, "view-axes");
  EXPECT_EQ(axes.size(), 7u);
  return {axes[0], axes[1], axes[2]};
}

} // namespace

TEST(Bounds_of_pages, A_surface_stands_on_its_largest_flat_base) {
  const auto s = subdivisions::tetrahedron();
  const auto expect_up = [&](const Points& points, const std::array<double, 3>& up) {
    const auto found = up_of(s, points);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], up[c], 1e-3) << c;
  };
  const double h = 0.4; // the base is the largest face, in each of the axes
  expect_up({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, h}}, {0, 0, 1});
  expect_up({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, -h}}, {0, 0, -1});
  expect_up({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0.3, h, 0.3}}, {0, 1, 0});
  expect_up({{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-h, 0.3, 0.3}}, {-1, 0, 0});
  // turned about x by 30 degrees
  const double c = std::sqrt(0.75), d = 0.5;
  expect_up({{0, 0, 0}, {1, 0, 0}, {0, c, d}, {0.3, 0.3 * c - h * d, 0.3 * d + h * c}}, {0, -d, c});
  // all of a plane is its base
  const auto flat = subdivisions::grid(3);
  EXPECT_EQ(up_of(flat, unit_points(flat, 3)), (std::array<double, 3>{0, 0, 1}));
}
