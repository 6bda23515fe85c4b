// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "refusals.h"

#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <limits>
#include <list>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Points = std::vector<std::array<double, 3>>;

const Points square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

template <class Faces>
std::string refusal(const Points& points, const Faces& faces) {
  return refusals::refusal([&] { IT::triangle_soup(points, faces); });
}

TEST(Triangle_soup, takes_any_ranges) {
  const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {0, 2, 3}};
  const IT::Triangle_soup s = IT::triangle_soup(square, triangles);
  EXPECT_EQ(s.points, square);
  ASSERT_EQ(s.triangles.size(), 2U);
  EXPECT_EQ(s.triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
  EXPECT_TRUE(s.polygon_of_triangle.empty());
  using Point = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  const std::deque<Point> points{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0)};
  const std::list<std::vector<std::size_t>> faces{{0, 1, 2}, {2, 1, 0}};
  EXPECT_EQ(IT::triangle_soup(points, faces).triangles.size(), 2U);
}

TEST(Triangle_soup, triangulates_polygons) {
  const std::vector<std::vector<int>> faces{{0, 1, 2, 3}, {0, 1, 2}};
  const IT::Triangle_soup s = IT::triangle_soup(square, faces);
  EXPECT_EQ(s.triangulated_polygons, 1U);
  EXPECT_EQ(s.input_faces, 2U);
  EXPECT_EQ(s.polygon_of_triangle, (std::vector<std::uint32_t>{0, 0, 1}));
}

TEST(Triangle_soup, takes_polygons_any_number_of_times) {
  const std::vector<std::vector<int>> faces(5, {0, 1, 2, 3});
  const IT::Domain d = IT::make_domain(IT::triangle_soup(square, faces));
  EXPECT_EQ(d.report.kind, IT::Domain_kind::tufted_cover);
  EXPECT_EQ(d.input.mesh.number_of_faces(), 20U);
}

TEST(Triangle_soup, names_the_face_or_point_that_is_wrong) {
  using Faces = std::vector<std::vector<int>>;
  EXPECT_NE(refusal(square, Faces{{0, 1, 2}, {0, 1, 7}}).find("face 1 refers to vertex 7"),
            std::string::npos);
  EXPECT_NE(refusal(square, Faces{{0, -1, 2}}).find("face 0 refers to vertex -1"),
            std::string::npos);
  EXPECT_EQ(refusal(square, Faces{{0, 1}}).rfind("face 0 has 2 vertices", 0), 0U);
  EXPECT_EQ(refusal(square, Faces{{0, 1, 2, 0, 3, 2}}).rfind("face 0 repeats vertex 0", 0), 0U);
  EXPECT_EQ(refusal(square, Faces{{0, 1, 0}}).rfind("no face has three different", 0), 0U);
  EXPECT_NE(refusal(square, Faces{}), "");
  Points bad = square;
  bad[2][1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(bad, Faces{{0, 1, 3}}).rfind("vertex 2 ", 0), 0U);
}

} // namespace
