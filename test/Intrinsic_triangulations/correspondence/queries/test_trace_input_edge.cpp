// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_edge.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include "gallery.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

// Edges of the input traced one by one, against the common subdivision, which is made by going through faces.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

template <class Traits_, class Correspondence_>
struct Choice {
  using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, Traits_, Correspondence_>;
};
using Doubles = IT::Euclidean_traits<double>;

template <class Choice>
class Input_edges : public testing::Test {};
using Choices =
    testing::Types<Choice<IT::Exact_euclidean_traits, IT::Integer_coordinates>,
                   Choice<IT::Exact_euclidean_traits, IT::Explicit_crossings>,
                   Choice<IT::Exact_euclidean_traits, IT::Signposts>,
                   Choice<Doubles, IT::Integer_coordinates>, Choice<Doubles, IT::Signposts>>;
TYPED_TEST_SUITE(Input_edges, Choices);

using Point = std::array<double, 3>;

using meshes::distance;

/// With signposts that are rounded, edges lose their way where many vertices lie on a line.
template <class T>
std::vector<std::pair<std::string, meshes::Mesh>> all_meshes() {
  std::vector<std::pair<std::string, meshes::Mesh>> result{{"rough grid", meshes::rough_grid(6, 5)},
                                                           {"box", meshes::box(3, 2, 4)},
                                                           {"potato", meshes::potato(2, 6)}};
  if (T::Metric::is_exact || IT::CurveCoordinates<typename T::Correspondence>)
    result.emplace_back("sheared grid", meshes::sheared_grid(5, 5, 7));
  return result;
}

/// Flipped, and refined: circumcenters on edges of the input, too, and others that are put there.
template <class T>
T changed(const meshes::Mesh& m) {
  T t(m.input());
  IT::flip_to_delaunay(t);
  std::vector<typename T::halfedge_descriptor> some;
  for (const auto f : faces(t.mesh())) some.push_back(halfedge(f, t.mesh()));
  for (std::size_t i = 0; i < some.size(); i += 4) t.insert_vertex(some[i], {0.25, 0.75, 0});
  IT::delaunay_refine(t, IT::parameters::minimum_angle(25).maximum_insertions(100));
  return t;
}

// where the points of a path are in space
template <class T>
std::vector<Point> points_of(const T& t, const IT::Edge_path& path,
                             const std::vector<Point>& points) {
  std::vector<Point> result;
  for (const IT::Path_point& p : path.points)
    result.push_back(IT::position(IT::weighted_vertices(t, p.on_input), points));
  return result;
}

/// Straight, and in the direction that the parameters of crossings say; the other halfedge of an edge runs the same
/// way backwards.
TYPED_TEST(Input_edges,
           Are_straight_polylines_of_the_common_subdivision_that_run_as_they_are_traced) {
  using T = typename TypeParam::Triangulation;
  for (const auto& [name, m] : all_meshes<T>()) {
    const T t = changed<T>(m);
    const IT::Common_subdivision s = IT::common_subdivision(t);
    const IT::Edge_polylines lines = IT::input_edge_polylines(s);
    const std::vector<Point> positions = IT::positions(s, std::span(m.points));
    ASSERT_EQ(lines.size(), t.input().number_of_halfedges() / 2);
    std::size_t inserted = 0, crossings = 0;
    for (std::uint32_t e = 0; e < lines.size(); ++e) {
      SCOPED_TRACE(name + " " + std::to_string(e));
      const IT::Edge_path path = IT::trace_input_edge(t, 2 * e);
      ASSERT_EQ(path.status, IT::Status::done);
      std::vector<Point> traced = points_of(t, path, m.points),
                         back = points_of(t, IT::trace_input_edge(t, 2 * e + 1), m.points);
      std::reverse(back.begin(), back.end());
      ASSERT_EQ(back.size(), traced.size());
      ASSERT_EQ(lines[e].size(), traced.size());
      if (distance(traced.front(), positions[lines[e].front()]) > 1e-9) {
        std::reverse(traced.begin(), traced.end()); // the polyline runs the other way
        std::reverse(back.begin(), back.end());
      }
      double length = 0, last = 0;
      for (std::size_t i = 0; i < traced.size(); ++i) {
        EXPECT_LT(distance(traced[i], positions[lines[e][i]]), 1e-8);
        EXPECT_LT(distance(traced[i], back[i]), 1e-8);
        if (i > 0) length += distance(positions[lines[e][i - 1]], positions[lines[e][i]]);
        const auto kind = s.kind(lines[e][i]);
        const bool is_end = i == 0 || i + 1 == traced.size();
        EXPECT_EQ(is_end, kind == IT::Subdivision_vertex_kind::input);
        if (kind == IT::Subdivision_vertex_kind::inserted) ++inserted;
        if (kind != IT::Subdivision_vertex_kind::crossing) continue;
        ++crossings;
        const auto& x = s.crossings[lines[e][i] - s.vertices.size()].on_input;
        EXPECT_EQ(x.edge, e);
        EXPECT_GE(x.parameter, last);
        last = x.parameter;
      }
      EXPECT_NEAR(length, distance(positions[lines[e].front()], positions[lines[e].back()]), 1e-9);
    }
    EXPECT_EQ(crossings, s.crossings.size()) << name << ": each crossing is on one edge";
    EXPECT_GT(inserted, 0U) << name;
  }
}

/// Table 1 both ways: the same points, whichever edges are traced.
TYPED_TEST(Input_edges, Meet_intrinsic_edges_where_these_meet_them) {
  using T = typename TypeParam::Triangulation;
  for (const auto& [name, m] : all_meshes<T>()) {
    const T t = changed<T>(m);
    std::vector<Point> of_input, of_intrinsic;
    const auto add = [&](std::vector<Point>& to, const IT::Edge_path& path) {
      const std::vector<Point> points = points_of(t, path, m.points);
      for (std::size_t i = 1; i + 1 < points.size(); ++i)
        if (std::ranges::count(path.points[i].on_intrinsic.weights, 0) < 2) to.push_back(points[i]);
    };
    for (std::uint32_t x = 0; x < t.input().number_of_halfedges(); x += 2)
      add(of_input, IT::trace_input_edge(t, x));
    for (const auto e : edges(t.mesh())) add(of_intrinsic, IT::trace_edge(t, e));
    ASSERT_EQ(of_input.size(), of_intrinsic.size()) << name;
    for (const Point& p : of_input)
      EXPECT_TRUE(std::any_of(of_intrinsic.begin(), of_intrinsic.end(), [&](const Point& q) {
        return distance(p, q) < 1e-8;
      })) << name;
  }
}

/// Where edges are loops, and several have the same ends: as many crossings as the subdivision has.
TYPED_TEST(Input_edges, Of_delta_complexes_are_polylines_with_as_many_points_as_they_are_traced) {
  using T = typename TypeParam::Triangulation;
  std::size_t done = 0;
  for (const gallery::Surface& g : gallery::oriented()) {
    T t(gallery::input(g));
    for (int round = 0; round < 3; ++round)
      for (const auto e : edges(t.mesh())) t.flip_edge(halfedge(e, t.mesh()));
    IT::Common_subdivision s;
    try {
      s = IT::common_subdivision(t);
    } catch (const IT::Invalid_input&) { // signposts that are rounded may say that they are lost
      ASSERT_FALSE(T::Metric::is_exact || IT::CurveCoordinates<typename T::Correspondence>) << g;
      continue;
    }
    ++done;
    const IT::Edge_polylines lines = IT::input_edge_polylines(s);
    for (std::uint32_t e = 0; e < lines.size(); ++e) {
      const IT::Edge_path path = IT::trace_input_edge(t, 2 * e);
      ASSERT_EQ(path.status, IT::Status::done) << g << e;
      EXPECT_EQ(lines[e].size(), path.points.size()) << g << e;
    }
  }
  EXPECT_GT(done, 8U);
}

} // namespace
