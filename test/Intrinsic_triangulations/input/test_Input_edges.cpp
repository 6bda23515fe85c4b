// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/input/Input_edges.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Point = std::array<double, 3>;
using Faces = std::vector<std::vector<std::uint32_t>>;

// A cube of squares, so that every face has a diagonal that is no edge.
IT::Intrinsic_input cube(double unit = 1) {
  std::vector<Point> points;
  for (const double z : {0., unit})
    for (const double y : {0., unit})
      for (const double x : {0., unit}) points.push_back({x, y, z});
  const Faces faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                    {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return IT::Intrinsic_input(IT::triangle_soup(points, faces));
}

std::size_t count(const std::vector<char>& marks) {
  return static_cast<std::size_t>(std::count(marks.begin(), marks.end(), char{1}));
}

static_assert(!std::is_constructible_v<IT::Input_edges, IT::Intrinsic_input>);

TEST(Input_edges, finds_edges_by_their_ends_but_no_diagonals) {
  const IT::Intrinsic_input in = cube();
  IT::Input_edges edges(in);
  std::vector<char> marks = edges.no_marks();
  EXPECT_EQ(marks.size(), 18U);
  EXPECT_TRUE(edges.mark(0, 1, marks));
  EXPECT_TRUE(edges.mark(3, 1, marks));
  EXPECT_TRUE(edges.mark(1, 0, marks)); // again
  EXPECT_EQ(count(marks), 2U);
  EXPECT_FALSE(edges.mark(0, 3, marks)); // across a square
  EXPECT_FALSE(edges.mark(1, 2, marks)); // the other diagonal
  EXPECT_FALSE(edges.mark(0, 7, marks)); // across the cube
  EXPECT_FALSE(edges.mark(0, 8, marks)); // there is no vertex 8
  EXPECT_EQ(count(marks), 2U);
}

TEST(Input_edges, finds_sharp_edges_in_all_units) {
  for (const double unit : {1., 1e-120, 1e120}) {
    const IT::Intrinsic_input in = cube(unit);
    const IT::Input_edges edges(in);
    std::vector<char> marks = edges.no_marks();
    edges.mark_sharp(91, marks);
    EXPECT_EQ(count(marks), 0U);
    edges.mark_sharp(89, marks);
    EXPECT_EQ(count(marks), 12U);
  }
}

TEST(Input_edges, finds_the_edges_of_the_input_of_a_triangulation) {
  const IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                    IT::Integer_coordinates>
      t(cube());
  IT::Input_edges edges(t.input());
  std::vector<char> marks = edges.no_marks();
  edges.mark_sharp(45, marks);
  EXPECT_EQ(count(marks), 12U);
  marks = edges.no_marks();
  EXPECT_TRUE(edges.mark(6, 7, marks));
  for (std::uint32_t e = 0; e < marks.size(); ++e) {
    const std::uint32_t i = t.input().names().row(t.input().source(2 * e)),
                        j = t.input().names().row(t.input().target(2 * e));
    EXPECT_EQ(marks[e] != 0, std::min(i, j) == 6 && std::max(i, j) == 7);
  }
}

} // namespace
