// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>

#include "gallery.h"
#include "mesh_types.h"
#include "meshes.h"
#include "properties.h"
#include "subdivision_oracle.h"
#include "validity.h"

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Move_status;
using subdivision_oracle::defect;
using subdivision_oracle::Exact;
using subdivision_oracle::input;
using subdivision_oracle::Mover;
using subdivision_oracle::Rounded;
using subdivision_oracle::state;

/// Elements that are there; `num_vertices()` and the like may count those that were removed.
template <class Range>
std::size_t count(const Range& r) {
  return static_cast<std::size_t>(std::distance(r.begin(), r.end()));
}

TEST(Vertex_moves, Refuse_weights_that_are_no_point_of_a_face_and_change_nothing) {
  Exact t(input(meshes::rough_grid(2, 1)));
  const auto before = state(t);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::array<double, 3> w :
       {std::array{1., 0., 0.}, std::array{0.5, 0.7, -0.2}, std::array{0.5, 0.5, 0.5},
        std::array{nan, 0.5, 0.5}, std::array{0., 0., 1.}, std::array{0., 0., 0.}})
    EXPECT_EQ(t.insert_vertex({0}, w).status, Move_status::weights);
  for (const double x : {0., 1., -0.5, 2., nan})
    EXPECT_EQ(t.split_edge({0}, x).status, Move_status::weights);
  EXPECT_EQ(state(t), before);
}

TEST(Vertex_moves, Refuse_to_remove_and_move_vertices_of_the_input) {
  Exact t(input(meshes::sphere(0)));
  for (const auto v : vertices(t.mesh())) {
    EXPECT_EQ(t.remove_vertex(v), Move_status::not_inserted);
    EXPECT_EQ(t.reposition_vertex(v, {0}, {0.5, 0.25, 0.25}).status, Move_status::not_inserted);
  }
  EXPECT_EQ(num_vertices(t.mesh()), 6U);
}

TEST(Vertex_moves, Split_edges_of_both_kinds_from_both_sides) {
  for (const bool turned : {false, true}) {
    Exact t(input(meshes::grid(2, 2)));
    const std::size_t n = num_edges(t.mesh());
    for (std::uint32_t e = 0; e < n; ++e) {
      const double whole = std::sqrt(t.squared_length(IT::Gluing_map::Edge{e}));
      const auto r = t.split_edge({2 * e + (turned ? 1 : 0)}, 0.25);
      ASSERT_EQ(r.status, Move_status::done) << e;
      std::vector<double> lengths; // of the edges from the new vertex, the shortest part among them
      auto h = halfedge(r.vertex, t.mesh());
      const auto first = h;
      do {
        lengths.push_back(std::sqrt(t.squared_length(edge(h, t.mesh()))));
        h = opposite(next(h, t.mesh()), t.mesh());
      } while (h != first);
      int quarter = 0, rest = 0;
      for (const double l : lengths) {
        quarter += std::abs(l - whole / 4) < 1e-12 ? 1 : 0;
        rest += std::abs(l - 3 * whole / 4) < 1e-12 ? 1 : 0;
      }
      EXPECT_GE(quarter, 1) << e;
      EXPECT_GE(rest, 1) << e;
      ASSERT_EQ(defect(t), "") << e;
    }
    EXPECT_NEAR(properties::total_area(t), 4, 1e-12);
  }
}

TEST(Vertex_moves, Keep_area_and_valid_connectivity_on_the_gallery) {
  for (const gallery::Surface& s : gallery::oriented()) {
    Exact t(gallery::input(s));
    const double whole = properties::total_area(t);
    const std::size_t v = num_vertices(t.mesh()), e = num_edges(t.mesh()), f = num_faces(t.mesh());
    Mover<Exact> mover(t, 1);
    for (int i = 0; i < 60; ++i) {
      mover.move(true);
      ASSERT_FALSE(IT::delta_complex_defect(t.mesh())) << s << ' ' << i;
      ASSERT_EQ(count(vertices(t.mesh())), v + mover.inserted.size()) << s;
    }
    EXPECT_NEAR(properties::total_area(t), whole, 1e-10 * whole) << s;
    for (int pass = 0; pass < 10 && !mover.inserted.empty(); ++pass) {
      IT::flip_to_delaunay(t);
      std::erase_if(mover.inserted, [&](IT::Gluing_map::Vertex w) {
        return t.remove_vertex(w) == Move_status::done;
      });
    }
    EXPECT_TRUE(mover.inserted.empty()) << s << ": " << mover.inserted.size();
    if (!mover.inserted.empty()) continue;
    EXPECT_EQ(count(vertices(t.mesh())), v) << s;
    EXPECT_EQ(count(edges(t.mesh())), e) << s;
    EXPECT_EQ(count(faces(t.mesh())), f) << s;
    EXPECT_EQ(defect(t), "") << s;
  }
}

/// Largest difference of squared lengths and quadruple areas from those of the points, in the plane.
double error(const Rounded& t, const std::vector<meshes::Point>& points) {
  double worst = 0;
  const auto point = [&](auto v) { return points[t.input_vertex(v)]; };
  for (const auto e : edges(t.mesh())) {
    const auto p = point(source(halfedge(e, t.mesh()), t.mesh()));
    const auto q = point(target(halfedge(e, t.mesh()), t.mesh()));
    const double x = p[0] - q[0], y = p[1] - q[1];
    worst = std::max(worst, std::abs(t.squared_length(e) - (x * x + y * y)));
  }
  for (const auto f : faces(t.mesh())) {
    const auto h = halfedge(f, t.mesh());
    const auto p = point(source(h, t.mesh())), q = point(target(h, t.mesh()));
    const auto r = point(target(next(h, t.mesh()), t.mesh()));
    const double a = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    worst = std::max(worst, std::abs(4 * t.area(f) - 2 * a));
  }
  return worst;
}

TEST(Vertex_moves, Removal_at_a_high_degree_does_not_multiply_rounding) {
  // nearly a circle of radius 1: an inserted vertex has edges to nearly all others
  constexpr std::uint32_t n = 150;
  std::mt19937 random(5);
  meshes::Mesh m;
  for (std::uint32_t k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n;
    const double radius = 1 + 1e-3 * static_cast<double>(random() % 1000) / 1000;
    m.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    if (k > 1) m.triangles.push_back({0, k - 1, k});
  }
  Rounded t(input(m));
  IT::flip_to_delaunay(t);
  for (int repeat = 0; repeat < 10; ++repeat) {
    const auto widest =
        *std::max_element(faces(t.mesh()).begin(), faces(t.mesh()).end(),
                          [&](const auto f, const auto g) { return t.area(f) < t.area(g); });
    const auto v = t.insert_vertex(halfedge(widest, t.mesh()), {0.25, 0.25, 0.5});
    ASSERT_EQ(v.status, Move_status::done);
    IT::flip_to_delaunay(t);
    const auto all = halfedges(t.mesh());
    ASSERT_GT(std::count_if(all.begin(), all.end(),
                            [&](const auto h) { return target(h, t.mesh()) == v.vertex; }),
              n / 2);
    ASSERT_EQ(t.remove_vertex(v.vertex), Move_status::done);
    IT::flip_to_delaunay(t);
    // a move adds some roundings of values up to 8; they add up over the star, and over the repetitions
    EXPECT_LE(error(t, m.points), (repeat + 1) * n * 8 * 0x1p-52);
  }
}

TEST(Vertex_moves, Removal_from_the_border_at_a_high_degree_gives_lengths_of_the_plane) {
  // a vertex on the diameter of a half disk sees all corners
  constexpr std::uint32_t n = 40;
  meshes::Mesh m{{{-1, 0, 0}, {1, 0, 0}}, {}};
  for (std::uint32_t k = 1; k <= n; ++k) {
    const double angle = std::numbers::pi * k / (n + 1);
    m.points.push_back({std::cos(angle), std::sin(angle), 0});
    m.triangles.push_back({0, k, k + 1}); // vertex 1 is where the angle is zero
  }
  Rounded t(input(m));
  auto base = halfedge(*faces(t.mesh()).begin(), t.mesh());
  while (!CGAL::is_border(opposite(base, t.mesh()), t.mesh()) ||
         t.index(source(base, t.mesh())) > 1 || t.index(target(base, t.mesh())) > 1)
    base = next(base, t.mesh());
  const auto inserted = t.split_edge(base, 0.5);
  ASSERT_EQ(inserted.status, Move_status::done);
  for (bool flips = true; flips;) {
    flips = false;
    IT::for_each_outgoing(inserted.vertex, t.mesh(), [&](auto h) {
      if (!flips && !CGAL::is_border(h, t.mesh()))
        flips = t.flip_edge(next(h, t.mesh())) == Move_status::done;
    });
  }
  std::size_t degree = 0;
  IT::for_each_outgoing(inserted.vertex, t.mesh(), [&](auto) { ++degree; });
  ASSERT_EQ(degree, n + 2);
  ASSERT_EQ(t.remove_vertex(inserted.vertex), Move_status::done);
  for (const auto e : edges(t.mesh())) {
    const auto &a = m.points[t.index(source(e, t.mesh()))],
               &b = m.points[t.index(target(e, t.mesh()))];
    const double x = a[0] - b[0], y = a[1] - b[1];
    // n steps around the star, each some roundings
    EXPECT_NEAR(t.squared_length(e), x * x + y * y, n * 0x1p-46);
  }
}

TEST(Vertex_moves, Change_nothing_when_they_are_refused) {
  for (const auto& mesh : {meshes::box(1, 1, 1), meshes::rough_grid(3, 1)}) {
    Exact t(input(mesh));
    Mover<Exact> mover(t, 7);
    int refused = 0;
    for (int i = 0; i < 300; ++i) {
      const auto counts = mover.statuses;
      // removal may exchange the halfedges of edges that it flips and flips back
      const auto normal = [&] {
        std::vector<std::int64_t> n;
        for (const auto& s : state(t)) n.push_back(s[0]);
        return n;
      };
      const auto before = normal();
      mover.move(true);
      if (mover.statuses == counts || mover.statuses[0] != counts[0]) continue;
      ++refused;
      ASSERT_EQ(normal(), before) << i;
    }
    EXPECT_GT(refused, 10);
    EXPECT_EQ(defect(t), "");
  }
}

/// Values, independent of the numbers of the elements: of edges with a correspondence, how often
/// they are crossed.
template <class T>
std::vector<double> sorted_values(const T& t) {
  std::vector<double> values;
  for (const auto e : edges(t.mesh())) {
    if constexpr (IT::CurveCoordinates<typename T::Correspondence>)
      values.push_back(t.correspondence().normal_coordinate(t.index(e)));
    else
      values.push_back(t.squared_length(e));
  }
  std::sort(values.begin(), values.end());
  return values;
}

/// The same moves on a mesh of another type, found by number.
template <class Mesh, class Correspondence>
void expect_same_as_on_gluing_map() {
  using Reference =
      IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Correspondence>;
  IT::Intrinsic_triangulation<Mesh, IT::Exact_euclidean_traits, Correspondence> t(
      input(meshes::rough_grid(3, 4)));
  Reference reference(input(meshes::rough_grid(3, 4)));
  const IT::Intrinsic_view<Reference> view(reference);
  for (std::uint32_t i = 0; i < 12; ++i) {
    const std::uint32_t h = view.halfedge_of_face(i);
    const std::array<double, 3> w =
        i % 3 == 0 ? std::array{0.5, 0.5, 0.} : std::array{0.5, 0.25, 0.25};
    const auto a = reference.insert_vertex({h}, w);
    const auto b = t.insert_vertex(t.numbers().halfedge_at(h), w);
    ASSERT_EQ(a.status, b.status);
    ASSERT_EQ(a.status, Move_status::done);
    ASSERT_EQ(reference.index(a.vertex), t.index(b.vertex));
    if (i % 4 == 3) {
      ASSERT_EQ(reference.remove_vertex(a.vertex), Move_status::done);
      ASSERT_EQ(t.remove_vertex(b.vertex), Move_status::done);
    }
  }
  IT::flip_to_delaunay(t);
  IT::flip_to_delaunay(reference);
  if constexpr (IT::CurveCoordinates<Correspondence>) {
    EXPECT_EQ(defect(t), "");
  }
  const std::vector<double> found = sorted_values(t), expected = sorted_values(reference);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) // flips may come in another order
    EXPECT_NEAR(found[i], expected[i], 1e-12);
}

TEST(Vertex_moves, Do_the_same_on_all_mesh_types) {
  // coordinates know elements by number: one other mesh type is enough for them
  expect_same_as_on_gluing_map<Surface_mesh, IT::Integer_coordinates>();
  expect_same_as_on_gluing_map<Polyhedron, IT::No_correspondence>();
  expect_same_as_on_gluing_map<OpenMesh_triangles, IT::No_correspondence>();
  expect_same_as_on_gluing_map<OpenMesh_polygons, IT::No_correspondence>();
}

} // namespace
