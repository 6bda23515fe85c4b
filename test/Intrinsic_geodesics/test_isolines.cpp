// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_geodesics/isolines/isolines.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "gallery.h"
#include "meshes.h"
#include "surface_mesh.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

// Oracles: planes that cut meshes in space, and the definition of an isoline, edge by edge.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Surface_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<double> coordinate(const meshes::Mesh& m, std::size_t axis) {
  std::vector<double> values;
  for (const meshes::Point& p : m.points) values.push_back(p[axis]);
  return values;
}

double length(const IT::Polyline& line) {
  double sum = 0;
  for (std::size_t i = 0; i < line.number_of_segments(); ++i) {
    const auto &a = line.points[i], &b = line.points[(i + 1) % line.points.size()];
    sum += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }
  return sum;
}

// Whether lines are what their definition says: each edge between below and above is crossed once,
// where the function has the value; pieces follow one another through faces; ends are on the border.
void expect_isolines(const Triangulation& t, const std::vector<double>& values,
                     const std::vector<double>& levels) {
  const IT::Intrinsic_view view(t);
  const auto value = [&](std::uint32_t v) {
    return values[t.input_vertex(t.numbers().vertex_at(v))];
  };
  std::map<std::pair<std::size_t, std::uint32_t>, int> crossed, expected;
  for (const auto& e : edges(t.mesh())) {
    const std::uint32_t h = t.numbers().halfedge(halfedge(e, t.mesh()));
    for (std::size_t i = 0; i < levels.size(); ++i)
      if ((value(view.source(h)) >= levels[i]) != (value(view.target(h)) >= levels[i]))
        expected[{i, h / 2}] = 1;
  }
  for (const IT::Isoline& line : IT::isolines(t, values, levels)) {
    EXPECT_EQ(line.level, levels[line.number_of_level]);
    for (const IT::Edge_point& p : line.points) {
      ++crossed[{line.number_of_level, p.halfedge / 2}];
      ASSERT_FALSE(view.is_border(p.halfedge));
      EXPECT_TRUE(p.parameter >= 0 && p.parameter <= 1);
      const double a = value(view.source(p.halfedge)), b = value(view.target(p.halfedge));
      if (std::isfinite(a) && std::isfinite(b)) {
        EXPECT_NEAR(a + p.parameter * (b - a), line.level, 1e-12);
      }
    }
    for (std::size_t i = 0; i < line.number_of_pieces(); ++i) {
      const std::uint32_t from = line.points[i].halfedge, to = line.end_of_piece(i).halfedge;
      EXPECT_EQ(view.face(from), view.face(to));
      EXPECT_GE(value(view.source(from)), line.level); // larger values are on the left
      EXPECT_GE(value(view.target(to)), line.level);
    }
    if (line.is_closed) continue;
    ASSERT_GE(line.points.size(), 2U);
    EXPECT_TRUE(view.is_border(line.points.front().halfedge ^ 1U));
    EXPECT_TRUE(view.is_border(line.points.back().halfedge ^ 1U));
  }
  EXPECT_EQ(crossed, expected);
}

TEST(Isolines, cross_each_edge_between_below_and_above_once_on_the_whole_gallery) {
  std::mt19937 random(7);
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    const Triangulation t(gallery::input(s));
    for (int round = 0; round < 10; ++round) {
      std::vector<double> values(t.input().number_of_rows());
      for (double& x : values) x = std::uniform_int_distribution<int>(0, 3)(random);
      expect_isolines(t, values, {0, 1, 1.5, 2, 3, 4, 1});
    }
  }
}

TEST(Isolines, cross_each_edge_once_with_random_values_and_infinite_ones) {
  std::mt19937 random(8);
  for (const meshes::Mesh& m :
       {meshes::sphere(3), meshes::rough_grid(9, 4), meshes::box(3, 2, 4)}) {
    Triangulation t(m.input());
    IT::flip_to_delaunay(t);
    std::vector<double> values(m.points.size());
    for (double& x : values) x = std::uniform_real_distribution<double>(-1, 1)(random);
    expect_isolines(t, values, {-0.5, 0, 0.25, values[3], values[10]});
    values[5] = infinity;
    values[6] = -infinity;
    expect_isolines(t, values, {-0.5, 0, 0.25, values[3], 5});
  }
}

TEST(Isolines, of_a_coordinate_are_parallel_lines_across_a_grid) {
  const auto m = meshes::surface_mesh<Surface_mesh>(meshes::grid(7, 5, 1, 0.5));
  const std::vector<double> x = coordinate(meshes::grid(7, 5, 1, 0.5), 0);
  // at a level of vertices there is one line too, and none at the least value
  const auto lines = IT::polylines(IT::isolines(m, x, std::vector{0.25, 3., 6.5, 7., 0., 7.5}), m);
  ASSERT_EQ(lines.size(), 4U);
  const std::vector<double> level{0.25, 3, 6.5, 7};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_FALSE(lines[i].is_closed);
    EXPECT_EQ(lines[i].label, static_cast<int>(i));
    EXPECT_NEAR(length(lines[i]), 2.5, 1e-14);
    for (const auto& p : lines[i].points) EXPECT_NEAR(p[0], level[i], 1e-14);
  }
}

TEST(Isolines, of_a_periodic_function_are_two_circles_of_a_torus) {
  // a tent over one direction of 6 x 6 squares: 0, 1, 2, 3, 2, 1
  const gallery::Surface s = gallery::flat_torus(6, 6);
  const Triangulation t(gallery::input(s));
  std::vector<double> values(36);
  for (std::size_t cell = 0; cell < 36; ++cell)
    values[s.gluing.origin[6 * cell]] = 3 - std::abs(3 - double(cell % 6));
  for (const double level : {0.5, 1., 1.75, 2.5}) {
    const auto lines = IT::isolines(t, values, std::vector{level});
    ASSERT_EQ(lines.size(), 2U);
    for (const IT::Isoline& line : lines) {
      EXPECT_TRUE(line.is_closed);
      EXPECT_NEAR(IT::length_of_isoline(t, line), 6, 1e-12);
    }
  }
}

TEST(Isolines, of_heights_are_perimeters_of_a_box_before_and_after_flips) {
  const meshes::Mesh box = meshes::box(2, 3, 5);
  const auto mesh = meshes::surface_mesh<Surface_mesh>(box);
  const std::vector<double> z = coordinate(box, 2);
  const std::vector<double> levels{0.5, 1, 2.25, 4.75};
  IT::Corresponding_triangulation t(mesh);
  IT::flip_to_delaunay(t);
  for (const auto& lines : {IT::polylines(IT::isolines(mesh, z, levels), mesh),
                            IT::polylines(t, IT::isolines(t, z, levels), mesh)}) {
    ASSERT_EQ(lines.size(), levels.size());
    for (std::size_t i = 0; i < levels.size(); ++i) {
      EXPECT_TRUE(lines[i].is_closed);
      EXPECT_NEAR(length(lines[i]), 10, 1e-12);
      for (const auto& p : lines[i].points) EXPECT_NEAR(p[2], levels[i], 1e-12);
    }
  }
}

TEST(Isolines, on_the_input_stay_on_it_after_flips) {
  const meshes::Mesh rough = meshes::rough_grid(8, 3);
  const auto mesh = meshes::surface_mesh<Surface_mesh>(rough);
  IT::Corresponding_triangulation t(mesh);
  IT::flip_to_delaunay(t);
  const std::vector<double> z = coordinate(rough, 0);
  const auto lines = IT::isolines(t, z, std::vector{2.3, 4.1, z[20]});
  const auto in_space = IT::polylines(t, lines, mesh);
  ASSERT_EQ(lines.size(), in_space.size());
  const auto by_points = IT::polylines(t, lines, rough.points);
  ASSERT_EQ(by_points.size(), in_space.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const IT::Traced_curve way = IT::trace_isoline(t, lines[i]);
    EXPECT_EQ(way.status, IT::Status::done);
    EXPECT_NEAR(way.length, IT::length_of_isoline(t, lines[i]), 1e-12);
    EXPECT_NEAR(length(in_space[i]), way.length, 1e-9);
    EXPECT_EQ(by_points[i].points, in_space[i].points);
  }
}

TEST(Isolines, of_heights_on_a_sphere_are_one_circle_each) {
  const meshes::Mesh sphere = meshes::sphere(3);
  const auto mesh = meshes::surface_mesh<Surface_mesh>(sphere);
  const std::vector<double> z = coordinate(sphere, 2);
  std::vector<double> levels{0}; // the equator consists of edges
  for (int i = -9; i < 10; ++i) levels.push_back(0.1 * i + 0.01);
  const auto lines = IT::isolines(mesh, z, levels);
  ASSERT_EQ(lines.size(), levels.size());
  for (const IT::Isoline& line : lines) EXPECT_TRUE(line.is_closed);
  const auto in_space = IT::polylines(lines, mesh);
  EXPECT_EQ(in_space[0].points.size(), 32U); // each vertex of the equator once
  std::ostringstream out;
  IT::write_polylines(out, "vtp", in_space, "level");
  EXPECT_FALSE(out.str().empty());
}

TEST(Isolines, at_an_extreme_value_shrink_to_the_vertex_or_vanish) {
  const auto mesh = meshes::surface_mesh<Surface_mesh>(meshes::sphere(1));
  std::vector<double> values(num_vertices(mesh), 0);
  values[3] = 1;
  const auto highest = IT::isolines(mesh, values, std::vector{1.});
  ASSERT_EQ(highest.size(), 1U);
  EXPECT_TRUE(highest[0].is_closed);
  EXPECT_TRUE(IT::polylines(highest, mesh).empty());
  EXPECT_TRUE(IT::isolines(mesh, values, std::vector{0.}).empty());
}

TEST(Isolines, refuse_values_that_are_missing_or_no_numbers) {
  const auto mesh = meshes::surface_mesh<Surface_mesh>(meshes::grid(2, 2));
  std::vector<double> values(9, 0);
  EXPECT_THROW((IT::isolines(mesh, values, std::vector{infinity})), std::invalid_argument);
  EXPECT_THROW((IT::isolines(mesh, std::vector<double>(8), std::vector{1.})),
               std::invalid_argument);
  values[4] = std::nan("");
  EXPECT_THROW((IT::isolines(mesh, values, std::vector{1.})), std::invalid_argument);
}

TEST(Isolines, have_parameters_in_the_whole_range_of_doubles) {
  const auto mesh = meshes::surface_mesh<Surface_mesh>(meshes::grid(1, 1));
  const double big = std::numeric_limits<double>::max(), tiny = 5e-324;
  const auto crossings = [&](double low, double high, double level) { // x of each
    std::vector<double> x;
    for (const IT::Isoline& line :
         IT::isolines(mesh, std::vector{low, high, low, high}, std::vector{level}))
      for (const IT::Edge_point& p : line.points) {
        const auto h = Surface_mesh::Halfedge_index(p.halfedge);
        x.push_back(std::lerp(mesh.point(source(h, mesh)).x(), mesh.point(target(h, mesh)).x(),
                              p.parameter));
      }
    return x;
  };
  EXPECT_EQ(crossings(-big, big, 0), std::vector(3, 0.5));
  EXPECT_EQ(crossings(-big, big, big), std::vector(3, 1.));
  EXPECT_EQ(crossings(0, tiny, tiny), std::vector(3, 1.));
  EXPECT_EQ(crossings(0, infinity, 7), std::vector(3, 0.));
  EXPECT_EQ(crossings(-infinity, 9, 7), std::vector(3, 1.));
  EXPECT_EQ(crossings(-infinity, infinity, 7), std::vector(3, 0.5));
}

struct Ends_before {
  std::size_t last;
  bool progress(std::size_t levels) const { return levels < last; }
};

TEST(Isolines, end_when_the_visitor_says_so) {
  const auto mesh = meshes::surface_mesh<Surface_mesh>(meshes::grid(3, 3));
  std::vector<double> values;
  for (const auto v : vertices(mesh)) values.push_back(mesh.point(v).x());
  const std::vector levels{0.5, 1.5, 2.5};
  const auto all = IT::isolines(mesh, values, levels);
  ASSERT_EQ(all.size(), 3U);
  for (const std::size_t last : {0U, 1U, 3U}) {
    const auto some =
        IT::isolines(mesh, values, levels, IT::parameters::visitor(Ends_before{last}));
    ASSERT_EQ(some.size(), last);
    for (std::size_t i = 0; i < last; ++i) EXPECT_EQ(some[i].level, all[i].level);
  }
}

} // namespace
