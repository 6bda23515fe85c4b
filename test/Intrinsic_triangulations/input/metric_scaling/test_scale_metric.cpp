// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gallery.h"
#include "meshes.h"
#include "properties.h"
#include "refusals.h"
#include "surface_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Element_kind;
using IT::Gluing_map;
using IT::Tensor_norm;
using IT::Triangle_inequality;
using refusals::expect_invalid;

namespace {

using Exact = IT::Intrinsic_triangulation<>;
using Double = IT::Intrinsic_triangulation<Gluing_map, IT::Euclidean_traits<double>>;
using Long_double = IT::Intrinsic_triangulation<Gluing_map, IT::Euclidean_traits<long double>>;
using Vector = std::array<double, 3>;
using Planar = IT::Unscaled_vector;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;

std::vector<double> squared_lengths(const meshes::Mesh& m) {
  const Gluing_map map = m.map();
  std::vector<double> l;
  for (std::uint32_t e = 0; e < map.number_of_edges(); ++e) {
    l.push_back(std::pow(
        meshes::distance(m.points[map.source({2 * e}).index], m.points[map.target({2 * e}).index]),
        2));
  }
  return l;
}

using properties::expect_near;

const auto euclidean = [](auto, const auto& v) {
  double sum = 0;
  for (std::size_t c = 0; c < sizeof v / sizeof v[0]; ++c) sum += v[c] * v[c];
  return std::sqrt(sum);
};

const auto smooth = [](const Vector& p) { return std::sin(p[0] + 2 * p[1]) + 0.3 * p[2]; };

// ---- conformal factors

TEST(Scale_conformally, by_a_constant_scales_areas_and_leaves_the_delaunay_triangulation) {
  for (const meshes::Mesh& m : {meshes::potato(2, 1), meshes::rough_grid(6, 2)})
    for (const double u : {-3.0, 0.25, 40.0}) {
      Exact before(m.input());
      const IT::Scaled_metric s = IT::scale_conformally(m.input(), [u](auto) { return u; });
      EXPECT_TRUE(s.is_metric);
      Exact t(s.input);
      const double factor = std::exp(2 * u);
      // an error of 1 u in a squared length moves areas by at most some 100 u: no slivers here
      for (const auto f : faces(t.mesh()))
        EXPECT_NEAR(t.area(f), factor * before.area(f), 1e-13 * factor * before.area(f));
      IT::flip_to_delaunay(t);
      IT::flip_to_delaunay(before);
      properties::expect_same_laplacian(properties::laplacian(t), properties::laplacian(before),
                                        1e-10);
    }
}

TEST(Scale_conformally, by_the_factors_of_an_inversion_gives_the_lengths_of_the_inverted_points) {
  for (const meshes::Mesh& shape : {meshes::sphere(2), meshes::potato(2, 4), meshes::grid(5, 4)}) {
    const meshes::Mesh m = meshes::translated(shape, {2.5, 4.5, -1.25});
    const auto u = [&m](Gluing_map::Vertex v) {
      return -2 * std::log(meshes::distance(m.points[v.index], {}));
    };
    meshes::Mesh inverted = m;
    for (Vector& p : inverted.points) {
      const double square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
      for (double& x : p) x /= square;
    }
    const IT::Scaled_metric s = IT::scale_conformally(m.input(), u);
    // coordinates are at most 50 times as long as edges: 50 u per length, 100 u per square
    expect_near(s.input.squared_lengths, squared_lengths(inverted), 1e-13);
    EXPECT_TRUE(s.violating_faces.empty());
    EXPECT_EQ(s.changed_edges, 0U);
  }
}

TEST(Scale_conformally, works_where_squared_lengths_alone_would_leave_the_range_of_doubles) {
  const meshes::Mesh m = meshes::potato(1, 1);
  for (const double unit : {0x1p-600, 0x1p600}) {
    const double u = -std::log(unit);
    const IT::Scaled_metric s =
        IT::scale_conformally(meshes::scaled(m, unit).input(), [u](auto) { return u; });
    expect_near(s.input.squared_lengths, squared_lengths(m), 1e-12); // |u| = 416: e^u within 416 u
  }
}

TEST(Scale_conformally, takes_property_maps) {
  auto mesh = meshes::surface_mesh<Surface_mesh>(meshes::grid(3, 3));
  auto u = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:u", 0.5).first;
  const IT::Scaled_metric s = IT::scale_conformally(mesh, u);
  std::size_t e = 0;
  for (const Surface_mesh::Edge_index i : mesh.edges()) {
    const auto h = mesh.halfedge(i);
    const double d = CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    EXPECT_NEAR(s.input.squared_lengths[e++], std::exp(1.0) * d, 1e-14);
  }
}

TEST(Scale_conformally, triangulates_polygons_and_reports_them) {
  Surface_mesh mesh;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
    mesh.add_vertex(Kernel::Point_3(x, y, 0));
  using V = Surface_mesh::Vertex_index;
  mesh.add_face(V(0), V(1), V(2), V(3));
  const IT::Scaled_metric s = IT::scale_conformally(mesh, [](V) { return 1; });
  EXPECT_EQ(s.input.triangulated_polygons, 1U);
  const Exact t(s.input);
  EXPECT_EQ(t.report().triangulated_polygons, 1U);
  EXPECT_NEAR(properties::total_area(t), std::exp(2.0), 1e-13);
  expect_invalid([&] { IT::scale_by_norm(mesh, euclidean); }, Element_kind::face, 0,
                 {"face 0", "not a triangle"});
  const auto steep = [](V v) { return v == V(0) || v == V(1) ? 9.0 : 0.0; };
  expect_invalid([&] { IT::scale_conformally(mesh, steep); }, Element_kind::face, 0,
                 {"face 0 of the triangulated mesh"});
}

// ---- norms

// the stretch of the plane by 3 along (3, 4)
constexpr double x_stretch = 3;
Planar stretched(double x, double y) {
  const double along = (x_stretch - 1) * (0.6 * x + 0.8 * y);
  return {x + 0.6 * along, y + 0.8 * along};
}

meshes::Mesh stretched(meshes::Mesh m) {
  for (Vector& p : m.points) {
    const Planar q = stretched(p[0], p[1]);
    p = {q[0], q[1], 0};
  }
  return m;
}

const auto stretch_in_space = [](auto, const Vector& v) {
  const Planar w = stretched(v[0], v[1]);
  return std::hypot(w[0], w[1]);
};

// the same norm in the frames of the faces, whose x-axes run along their first halfedges
template <class Mesh>
auto stretch_in_frames(const meshes::Mesh& m, const Mesh& map) {
  return [&m, &map](Gluing_map::Face f, const Planar& v) {
    const auto h = map.halfedge(f);
    const Vector &p = m.points[map.source(h).index], &q = m.points[map.target(h).index];
    const double x = q[0] - p[0], y = q[1] - p[1];
    // (0.6, 0.8) in the frame: its products with (x, y) and with (-y, x)
    return Tensor_norm::from_stretches({0.6 * x + 0.8 * y, -0.6 * y + 0.8 * x}, x_stretch, 1)(v);
  };
}

TEST(Scale_by_norm, of_one_inner_product_in_the_plane_stretches_the_points) {
  for (const meshes::Mesh& m :
       {meshes::grid(4, 3), meshes::random_planar(100, 1000, 1), meshes::sheared_grid(3, 3, 7)}) {
    const Gluing_map map = m.map();
    const std::vector<double> expected = squared_lengths(stretched(m));
    // coordinates below 2^10: differences are exact except for the rounding of stretched points
    expect_near(IT::scale_by_norm_in_space(m.input(), stretch_in_space).input.squared_lengths,
                expected, 1e-12);
    expect_near(IT::scale_by_norm(m.input(), stretch_in_frames(m, map)).input.squared_lengths,
                expected, 1e-12);
    const IT::Intrinsic_input intrinsic(map, squared_lengths(m)); // without points
    expect_near(IT::scale_by_norm(intrinsic, stretch_in_frames(m, map)).input.squared_lengths,
                expected, 1e-11); // needles: angles from squared lengths
  }
}

template <class T>
void expect_delaunay_of_stretched_points() {
  const meshes::Mesh m = meshes::random_planar(300, 1U << 20, 3); // random: no ties
  T expected(stretched(m).input()),
      t(IT::scale_by_norm_in_space(
            m.input(), stretch_in_space,
            IT::parameters::triangle_inequality(Triangle_inequality::repair).margin(1e-12))
            .input);
  EXPECT_GT(IT::flip_to_delaunay(expected).flips, 100U);
  IT::flip_to_delaunay(t);
  properties::expect_same_tessellation(properties::tessellation(t),
                                       properties::tessellation(expected), 1e-8);
}

TEST(Scale_by_norm, of_one_inner_product_gives_the_delaunay_triangulation_of_stretched_points) {
  expect_delaunay_of_stretched_points<Exact>();
  expect_delaunay_of_stretched_points<Double>();
  expect_delaunay_of_stretched_points<Long_double>();
}

TEST(Scale_by_norm, averages_over_the_faces_at_an_edge_and_takes_one_on_the_border) {
  const meshes::Mesh m = meshes::grid(1, 1); // faces 0 and 1 share a diagonal
  const auto norm = [](auto f, const auto& v) {
    return (f.index == 0 ? 1.0 : 1.5) * euclidean(f, v);
  };
  const IT::Scaled_metric s = IT::scale_by_norm(m.input(), norm);
  const Gluing_map& map = s.input.mesh;
  for (std::uint32_t e = 0; e < map.number_of_edges(); ++e) {
    const auto f = map.face({2 * e}), g = map.face({2 * e + 1});
    const bool border = f.index == IT::Gluing::none || g.index == IT::Gluing::none;
    const double expected =
        border ? (std::min(f.index, g.index) == 0 ? 1 : 1.5) : std::sqrt(2) * 1.25;
    EXPECT_NEAR(std::sqrt(s.input.squared_lengths[e]), expected, 1e-15);
  }
}

TEST(Scale_by_norm, counts_both_sides_where_a_face_is_glued_to_itself) {
  const gallery::Surface c = gallery::self_folded_cone(); // sides 1 and 2 are one edge; all are 1
  const IT::Intrinsic_input in = gallery::input(c);
  const Tensor_norm g = Tensor_norm::from_stretches({1, 2}, 2, 1);
  std::vector<Planar> asked;
  const IT::Scaled_metric s = IT::scale_by_norm(in, [&](auto, const Planar& v) {
    asked.push_back(v);
    return g(v);
  });
  ASSERT_EQ(asked.size(), 3U);
  const double h = std::sqrt(0.75);
  const auto [ij, jk, ki] = in.mesh.sides({0});
  ASSERT_EQ(jk.index / 2, ki.index / 2);
  EXPECT_NEAR(std::sqrt(s.input.squared_lengths[ij.index / 2]), g({1, 0}), 1e-15);
  EXPECT_NEAR(std::sqrt(s.input.squared_lengths[jk.index / 2]), (g({-0.5, h}) + g({-0.5, -h})) / 2,
              1e-15);
}

TEST(Scale_by_norm, and_conformally_work_on_every_surface_of_the_gallery) {
  for (const gallery::Surface& s : gallery::all()) {
    const IT::Intrinsic_input in = gallery::input(s);
    const IT::Scaled_metric same = IT::scale_by_norm(in, euclidean);
    expect_near(same.input.squared_lengths, in.squared_lengths, 1e-14);
    std::vector<double> fourfold = in.squared_lengths;
    for (double& x : fourfold) x *= 4;
    expect_near(IT::scale_conformally(in, [](Gluing_map::Vertex) { return std::log(2.0); })
                    .input.squared_lengths,
                fourfold, 1e-14);
  }
}

// ---- triangulations

TEST(Scale_metric, of_a_triangulation_scales_its_edges_as_they_are) {
  Exact t(meshes::sheared_grid(5, 5, 3).input());
  ASSERT_GT(IT::flip_to_delaunay(t).flips, 0U);
  const IT::Scaled_metric s = IT::scale_conformally(t, [](auto) { return std::log(2.0); });
  for (const auto e : edges(t.mesh()))
    EXPECT_NEAR(s.input.squared_lengths[t.index(e)], 4 * t.squared_length(e), 1e-14);
  Exact again(s.input);
  EXPECT_NEAR(properties::total_area(again), 4 * 25, 1e-12);
  EXPECT_EQ(properties::connectivity(again), properties::connectivity(t));
}

TEST(Scale_metric, of_a_triangulation_takes_faces_without_area) {
  meshes::Mesh m = meshes::with_cap(meshes::box(2, 1, 1), 3);
  for (Vector& p : m.points) p = {p[0] / 3, p[1] / 7, p[2]}; // a cap up to rounding
  const Exact t(m.input());
  const auto repair =
      IT::parameters::triangle_inequality(Triangle_inequality::repair).margin(1e-12);
  // heights of the cap are near the root of rounding errors and of the margin
  expect_near(IT::scale_by_norm(t, euclidean, repair).input.squared_lengths, squared_lengths(m),
              1e-11);
}

// ---- the triangle inequality

// corners (0, 0), (1, 0), (0, 1) in face 1; an isolated vertex comes first, face 0 is far away
meshes::Mesh steep_mesh() {
  return {{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 7, 0}, {9, 7, 0}, {8, 9, 0}},
          {{4, 5, 6}, {1, 2, 3}}};
}
const auto steep = [](Gluing_map::Vertex v) { return v.index == 1 || v.index == 2 ? 4.0 : 0.0; };

TEST(Scale_metric, check_lists_faces_that_violate_the_triangle_inequality) {
  const IT::Scaled_metric s = IT::scale_conformally(
      steep_mesh().input(), steep, IT::parameters::triangle_inequality(Triangle_inequality::check));
  EXPECT_FALSE(s.is_metric);
  EXPECT_EQ(s.violating_faces, (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(s.changed_edges, 0U);
  EXPECT_THROW(Exact t(s.input), IT::Invalid_input);
}

TEST(Scale_metric, refuse_names_the_face_its_vertices_and_lengths) {
  expect_invalid([] { IT::scale_conformally(steep_mesh().input(), steep); }, Element_kind::face, 1,
                 {"face 1 with vertices 1, 2 and 3", "lengths 54.59815003314", "10.449703",
                  "7.3890560989", "repair"});
}

TEST(Scale_metric, repair_shortens_the_side_that_is_too_long_and_reports_it) {
  for (const double margin : {1e-5, 0.5}) {
    const IT::Scaled_metric s = IT::scale_conformally(
        steep_mesh().input(), steep,
        IT::parameters::triangle_inequality(Triangle_inequality::repair).margin(margin));
    EXPECT_TRUE(s.is_metric);
    EXPECT_EQ(s.violating_faces, (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(s.changed_edges, 1U);
    const double repaired = std::exp(2.0) * (std::sqrt(2.0) + 1 - margin);
    EXPECT_NEAR(s.largest_relative_change, 1 - repaired / std::exp(4.0), 1e-14);
    Exact t(s.input);
    EXPECT_EQ(t.report().degenerate_faces, 0U);
    EXPECT_EQ(IT::flip_to_delaunay(t).status, IT::Status::done);
    EXPECT_TRUE(IT::is_delaunay(t));
  }
}

TEST(Scale_metric, repair_of_wild_factors_gives_a_metric_that_becomes_delaunay) {
  for (const double amplitude : {1.0, 8.0, 60.0}) {
    const meshes::Mesh m = meshes::rough_grid(12, 1);
    const auto u = [&](Gluing_map::Vertex v) { return amplitude * smooth(m.points[v.index]); };
    const IT::Scaled_metric s = IT::scale_conformally(
        m.input(), u, IT::parameters::triangle_inequality(Triangle_inequality::repair));
    EXPECT_GT(s.violating_faces.size(), 0U);
    EXPECT_GE(2 * s.changed_edges, s.violating_faces.size()); // an edge is in two faces
    Exact t(s.input);
    EXPECT_EQ(t.report().degenerate_faces, 0U);
    EXPECT_EQ(IT::flip_to_delaunay(t).status, IT::Status::done);
    EXPECT_TRUE(IT::is_delaunay(t));
  }
}

// ---- bad input

TEST(Scale_metric, names_vertices_and_faces_with_values_that_make_no_sense) {
  const meshes::Mesh m = meshes::box(1, 1, 1);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    expect_invalid(
        [&] {
          IT::scale_conformally(
              m.input(), [bad](auto v) { return v.index == 5 ? bad : 0.0; },
              IT::parameters::triangle_inequality(Triangle_inequality::check));
        },
        Element_kind::vertex, 5, {"vertex 5"});
    for (const double length : {bad, 0.0, -1.0})
      expect_invalid(
          [&] {
            IT::scale_by_norm(
                m.input(),
                [&](auto f, const auto& v) { return f.index == 7 ? length : euclidean(f, v); },
                IT::parameters::triangle_inequality(Triangle_inequality::check));
          },
          Element_kind::face, 7, {"face 7", "positive"});
  }
  expect_invalid(
      [&] {
        IT::scale_by_norm(m.input(), [](auto f, const Planar& v) {
          return Tensor_norm::from_tensor(1, f.index == 2 ? 2 : 0, 1)(v);
        });
      },
      Element_kind::face, 2, {"face 2"});
}

TEST(Scale_metric, names_vertices_in_the_order_of_iteration_after_removals) {
  Surface_mesh mesh;
  const meshes::Mesh m = meshes::box(1, 1, 1);
  mesh.add_vertex(Kernel::Point_3(9, 9, 9));
  for (const auto& p : m.points) mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  using V = Surface_mesh::Vertex_index;
  for (const auto& [a, b, c] : m.triangles) mesh.add_face(V(a + 1), V(b + 1), V(c + 1));
  mesh.remove_vertex(V(0));
  expect_invalid([&] { IT::scale_conformally(mesh, [](V v) { return v == V(4) ? NAN : 0.0; }); },
                 Element_kind::vertex, 3, {"vertex 3"});
}

TEST(Scale_metric, names_edges_whose_new_squared_length_is_no_double) {
  const meshes::Mesh m = meshes::grid(1, 1);
  for (const double u : {400.0, -400.0, 1e308, -1e308})
    expect_invalid([&] { IT::scale_conformally(m.input(), [u](auto) { return u; }); },
                   Element_kind::edge, 0, {"edge 0", "vertices", "range"});
  expect_invalid(
      [&] {
        IT::scale_by_norm(m.input(), [](auto f, const auto& v) { return 1e200 * euclidean(f, v); });
      },
      Element_kind::edge, 0, {"edge 0"});
}

TEST(Scale_metric, names_edges_whose_length_is_lost_against_the_mean_edge) {
  meshes::Mesh m = meshes::grid(1, 1);
  m.points[1] = {1e-170, 0, 0};
  expect_invalid([&] { IT::scale_conformally(m.input(), [](auto) { return 0.0; }); },
                 Element_kind::edge, 0, {"edge 0", "2^500"});
}

TEST(Scale_metric, needs_points_for_norms_in_space_and_lengths_that_form_triangles) {
  const IT::Intrinsic_input in(Gluing_map(gallery::triangle().gluing),
                               std::vector<double>{1, 1, 1});
  expect_invalid([&] { IT::scale_by_norm_in_space(in, euclidean); }, Element_kind::none, 0,
                 {"no points"});
  const IT::Intrinsic_input bad(Gluing_map(gallery::triangle().gluing),
                                std::vector<double>{1, 1, 9});
  expect_invalid([&] { IT::scale_by_norm(bad, euclidean); }, Element_kind::face, 0,
                 {"face 0", "before"});
  const IT::Intrinsic_input few(Gluing_map(gallery::triangle().gluing), std::vector<double>{1, 1});
  expect_invalid([&] { IT::scale_by_norm(few, euclidean); }, Element_kind::none, 0, {"3 edges"});
}

TEST(Scale_metric, keeps_edges_of_length_zero_without_asking_for_their_norm) {
  const meshes::Mesh m = meshes::with_needle(meshes::box(1, 1, 1), 2, 0);
  const auto norm = [](auto, const auto& v) {
    const double l = euclidean(0, v);
    EXPECT_GT(l, 0);
    return 2 * l;
  };
  const std::vector<double> before = squared_lengths(m);
  const auto twice = [](auto) { return std::log(2.0); };
  // the two other sides of a face with a side of length zero are equal up to rounding
  const auto repair = IT::parameters::triangle_inequality(Triangle_inequality::repair);
  for (const IT::Scaled_metric& s : {IT::scale_by_norm(m.input(), norm, repair),
                                     IT::scale_by_norm_in_space(m.input(), norm, repair),
                                     IT::scale_conformally(m.input(), twice, repair)})
    for (std::size_t e = 0; e < before.size(); ++e)
      EXPECT_NEAR(s.input.squared_lengths[e], 4 * before[e], 1e-14 * before[e]);
}

} // namespace
