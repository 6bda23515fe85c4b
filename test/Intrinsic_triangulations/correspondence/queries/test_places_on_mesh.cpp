// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/points_of_rows.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_edge.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include "mesh_types.h"
#include "meshes.h"
#include "surface_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Queries by the user's mesh and descriptors, with the same calls for every correspondence, mesh type and scale.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
template <class Correspondence>
using Triangulation =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Correspondence>;

Surface_mesh user_mesh(const meshes::Mesh& m) { return meshes::surface_mesh<Surface_mesh>(m); }

template <class Point>
double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
template <class Point>
double length(const std::vector<Point>& polyline) {
  double sum = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i) sum += distance(polyline[i - 1], polyline[i]);
  return sum;
}

/// Scales, of which all but the first have an exponent that is not zero, and that is no power of two.
constexpr std::array<double, 3> scales{1, 1000, 0.001};

std::vector<std::pair<std::string, meshes::Mesh>> shapes() {
  return {{"rough grid", meshes::rough_grid(6, 5)},
          {"box", meshes::box(3, 2, 4)},
          {"potato", meshes::potato(2, 6)},
          {"sheared grid", meshes::sheared_grid(5, 5, 7)}};
}

template <class T>
class Queries : public testing::Test {};
using Correspondences =
    testing::Types<IT::Integer_coordinates, IT::Explicit_crossings, IT::Signposts>;
TYPED_TEST_SUITE(Queries, Correspondences);

/// Flips and inserts vertices, some of them on edges of the input.
template <class T>
void change(T& t) {
  IT::flip_to_delaunay(t);
  std::vector<typename T::face_descriptor> some;
  for (const auto f : faces(t.mesh())) some.push_back(f);
  for (std::size_t i = 0; i < some.size(); i += 5) {
    const double last = i % 2 == 0 ? 0 : 0.25;
    t.insert_vertex(halfedge(some[i], t.mesh()), {0.25, 0.75 - last, last});
  }
  IT::flip_to_delaunay(t);
}

/// Calls `check` for all shapes and scales, with the mesh and a triangulation that has been changed.
template <class Correspondence, class Check>
void for_all_meshes(const Check& check) {
  for (const auto& [name, shape] : shapes())
    for (const double scale : scales) {
      SCOPED_TRACE(name + " times " + std::to_string(scale));
      const auto mesh = user_mesh(meshes::scaled(shape, scale));
      Triangulation<Correspondence> t(mesh);
      change(t);
      check(mesh, t, scale);
    }
}

TYPED_TEST(Queries, Places_on_my_mesh_go_there_and_back_at_every_scale) {
  for_all_meshes<TypeParam>([](const auto& mesh, auto& t, double scale) {
    for (const auto f : faces(mesh)) {
      const IT::Face_location<Surface_mesh> place{f, {0.2, 0.3, 0.5}};
      const auto there = IT::locate_on_intrinsic(t, place, mesh);
      ASSERT_TRUE(there);
      const auto back = IT::locate_on_input(t, *there, mesh);
      ASSERT_TRUE(back);
      const auto in_space = [&m = mesh](const auto& p) {
        std::array<double, 3> x{0, 0, 0};
        auto h = halfedge(p.first, m);
        for (const double w : p.second) {
          for (std::size_t k = 0; k < 3; ++k)
            x[k] += w * m.point(source(h, m))[static_cast<int>(k)];
          h = next(h, m);
        }
        return x;
      };
      EXPECT_LT(distance(in_space(place), in_space(*back)), 1e-9 * scale);
    }
  });
}

/// Points of the mesh are where they were; no edge is shorter than the chord of its ends, and edges
/// inside a face are as long, so that inserted points are where they belong.
TYPED_TEST(Queries, Points_of_rows_are_on_my_mesh) {
  for_all_meshes<TypeParam>([](const auto& mesh, auto& t, double) {
    const auto points = IT::points_of_rows(t, mesh);
    ASSERT_EQ(points.size(), t.number_of_vertices());
    ASSERT_GT(points.size(), mesh.number_of_vertices());
    for (const auto v : vertices(mesh)) {
      const auto& p = mesh.point(v);
      EXPECT_EQ(points[v], (std::array<double, 3>{p.x(), p.y(), p.z()}));
    }
    std::size_t straight = 0;
    for (const auto e : edges(t.mesh())) {
      const auto h = halfedge(e, t.mesh());
      const double chord = distance(points[t.input_vertex(source(h, t.mesh()))],
                                    points[t.input_vertex(target(h, t.mesh()))]);
      EXPECT_LE(chord, t.length(e) * (1 + 1e-9));
      straight += chord > t.length(e) * (1 - 1e-9) ? 1 : 0;
    }
    EXPECT_GT(straight, num_edges(t.mesh()) / 4);
  });
}

/// Of a mesh and of the soup with the same triangles in random order, each beginning at a random
/// corner: the weights that belong to the corners as listed name the same point, which is their
/// combination.
TYPED_TEST(Queries, Weights_are_in_the_order_in_which_faces_list_their_vertices) {
  const unsigned seed = 23;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (auto [name, shape] : shapes()) {
    std::shuffle(shape.triangles.begin(), shape.triangles.end(), random);
    for (auto& corners : shape.triangles)
      std::rotate(corners.begin(), corners.begin() + static_cast<int>(random() % 3), corners.end());
    const auto mesh = user_mesh(shape);
    const Triangulation<TypeParam> t(mesh);
    IT::Triangle_soup triangles;
    triangles.points = shape.points;
    triangles.triangles = shape.triangles;
    const Triangulation<TypeParam> soup{IT::Intrinsic_input(std::move(triangles))};
    std::exponential_distribution<double> number;
    for (const auto f : faces(mesh)) {
      const auto& corners = shape.triangles[f];
      std::array<double, 3> weights{number(random), number(random), number(random)};
      const double sum = weights[0] + weights[1] + weights[2];
      std::array<double, 3> wanted{0, 0, 0};
      for (std::size_t k = 0; k < 3; ++k) {
        weights[k] /= sum;
        for (std::size_t c = 0; c < 3; ++c) wanted[c] += weights[k] * shape.points[corners[k]][c];
      }
      const auto place = IT::place_in_face(f, weights, mesh);
      EXPECT_EQ(IT::weights_in_face(place), weights);
      // sums of three products of numbers below 10
      const auto on_mesh = IT::point_in_space(t, IT::surface_point(t, place, mesh), mesh);
      const auto in_soup = IT::point_in_space(
          soup, IT::point_on_input(soup.input(), IT::Place::in_face(f, weights)), shape.points);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(on_mesh[static_cast<int>(c)], wanted[c], 1e-14) << name << ' ' << f;
        EXPECT_NEAR(in_soup[c], wanted[c], 1e-14) << name << ' ' << f;
      }
    }
    for (std::uint32_t row = 0; row < shape.points.size(); ++row) {
      EXPECT_EQ(t.input_vertex(IT::vertex_of_row(t, row)), row);
      EXPECT_EQ(soup.input_vertex(IT::vertex_of_row(soup, row)), row);
    }
    const auto none = static_cast<std::uint32_t>(shape.points.size());
    EXPECT_THROW(IT::vertex_of_row(soup, none), IT::Invalid_input);
    const auto no_face = static_cast<std::uint32_t>(shape.triangles.size());
    EXPECT_THROW(IT::point_on_input(soup.input(), IT::Place::in_face(no_face, {1, 0, 0})),
                 IT::Invalid_input);
  }
}

TYPED_TEST(Queries, Intrinsic_edges_are_polylines_of_their_length_at_every_scale) {
  for_all_meshes<TypeParam>([](const auto& mesh, auto& t, double scale) {
    for (const auto e : edges(t.mesh())) {
      const auto points = IT::polyline(t, IT::trace_edge(t, e), mesh);
      ASSERT_GE(points.size(), 2U);
      EXPECT_NEAR(length(points), std::sqrt(t.squared_length(e)), 1e-9 * scale);
    }
  });
}

/// The edge as a straight line, and its points where the intrinsic triangulation says that they are.
TYPED_TEST(Queries, Edges_of_my_mesh_run_where_the_intrinsic_triangulation_says) {
  for_all_meshes<TypeParam>([](const auto& mesh, auto& t, double scale) {
    std::size_t crossings = 0, along = 0;
    for (const auto e : edges(mesh)) {
      const IT::Edge_path path = IT::trace_input_edge(t, e, mesh);
      ASSERT_EQ(path.status, IT::Status::done) << e;
      ASSERT_GE(path.points.size(), 2U);
      const auto points = IT::polyline(t, path, mesh);
      const auto from = mesh.point(source(e, mesh)), to = mesh.point(target(e, mesh));
      EXPECT_LT(distance(points.front(), from), 1e-12 * scale);
      EXPECT_LT(distance(points.back(), to), 1e-12 * scale);
      EXPECT_NEAR(length(points), distance(from, to), 1e-9 * scale) << e;
      double last = 0;
      for (const IT::Path_point& p : path.points) {
        EXPECT_GE(p.parameter, last);
        last = p.parameter;
        const auto back = IT::locate_on_input(t, p.on_intrinsic);
        ASSERT_TRUE(back);
        EXPECT_LT(
            distance(IT::point_in_space(t, *back, mesh), IT::point_in_space(t, p.on_input, mesh)),
            1e-8 * scale)
            << e;
      }
      crossings += path.points.size() - 2;
      if (path.along != IT::Gluing::none) ++along;
    }
    EXPECT_GT(crossings, 0U);
    EXPECT_GT(along, 0U);
  });
}

TYPED_TEST(Queries, Geodesics_have_the_length_that_is_asked_for_in_my_units) {
  for_all_meshes<TypeParam>([](const auto& mesh, auto& t, double scale) {
    for (const auto f : faces(mesh)) {
      const IT::Face_location<Surface_mesh> start{f, {0.2, 0.3, 0.5}};
      const double asked = 0.7 * scale;
      const IT::Geodesic g = IT::trace_geodesic(t, start, {0.6, 0.8}, asked, mesh);
      std::vector<Kernel::Point_3> points;
      for (const auto& p : g.points) points.push_back(IT::point_in_space(t, p, mesh));
      EXPECT_NEAR(length(points), g.length, 1e-9 * scale);
      if (g.status == IT::Status::done) {
        EXPECT_EQ(g.length, asked);
      } else {
        EXPECT_EQ(g.status, IT::Status::border);
        EXPECT_LT(g.length, asked);
      }
      EXPECT_LT(g.error, 1e-9 * scale);
    }
    // the same on the intrinsic triangulation: there and back by the same vector
    for (const auto f : faces(t.mesh())) {
      const auto h = t.numbers().halfedge(halfedge(f, t.mesh()));
      const double asked = 0.1 * scale;
      const auto g = IT::trace_geodesic(t, {h, {0.3, 0.3, 0.4}}, {0, 1}, asked);
      if (g.status != IT::Status::done) continue;
      const auto from = IT::locate_on_input(t, g.points.front()),
                 to = IT::locate_on_input(t, g.points.back());
      ASSERT_TRUE(from && to);
      EXPECT_LT(distance(IT::point_in_space(t, *from, mesh), IT::point_in_space(t, *to, mesh)),
                asked * (1 + 1e-9));
    }
  });
}

TYPED_TEST(Queries, Constrained_edges_of_my_mesh_are_kept_by_flips_and_refinement) {
  const auto mesh = user_mesh(meshes::scaled(meshes::box(3, 2, 4), 1000));
  std::map<Surface_mesh::Edge_index, bool> is_sharp;
  double before = 0;
  for (const auto e : edges(mesh)) {
    const auto a = mesh.point(source(e, mesh)), b = mesh.point(target(e, mesh));
    is_sharp[e] = a.x() == 0 && b.x() == 0; // also diagonals
    if (is_sharp[e]) before += distance(a, b);
  }
  Triangulation<TypeParam> t(mesh);
  auto constrained = IT::constrained_input_edges(t, mesh, boost::make_assoc_property_map(is_sharp));
  IT::flip_to_delaunay(t, IT::parameters::edge_is_constrained_map(constrained));
  const auto result = IT::delaunay_refine(
      t, IT::parameters::maximum_edge_length(400).edge_is_constrained_map(constrained));
  EXPECT_EQ(result.status, IT::Status::done);
  double after = 0;
  for (const auto e : edges(t.mesh())) {
    EXPECT_LE(t.squared_length(e), 400 * 400 * (1 + 1e-12));
    if (get(constrained, e)) after += std::sqrt(t.squared_length(e));
  }
  EXPECT_NEAR(after, before, 1e-9 * before);
  // found again from the correspondence
  const auto again = IT::constrained_input_edges(t, mesh, boost::make_assoc_property_map(is_sharp));
  for (const auto e : edges(t.mesh())) EXPECT_EQ(get(again, e), get(constrained, e));
}

/// The input of a triangulation without correspondence keeps no surface; edges are found by their names. The ends of an
/// edge tell which one it is, as the mesh is a simplicial complex.
void expect_constrained_edges_without_correspondence(const Surface_mesh& mesh) {
  std::map<Surface_mesh::Edge_index, bool> is_sharp;
  std::set<std::pair<std::size_t, std::size_t>> expected, found;
  const auto ends = [](std::size_t i, std::size_t j) {
    return std::pair(std::min(i, j), std::max(i, j));
  };
  for (const auto e : edges(mesh)) {
    is_sharp[e] = e.idx() % 3 == 1;
    if (is_sharp[e]) expected.insert(ends(source(e, mesh).idx(), target(e, mesh).idx()));
  }
  const Triangulation<IT::No_correspondence> t(mesh);
  ASSERT_EQ(t.input().surface(), nullptr);
  const auto constrained =
      IT::constrained_input_edges(t, mesh, boost::make_assoc_property_map(is_sharp));
  for (const auto e : edges(t.mesh()))
    if (get(constrained, e))
      found.insert(ends(t.input_vertex(source(e, t.mesh())), t.input_vertex(target(e, t.mesh()))));
  EXPECT_EQ(found, expected);
}

TEST(Constrained_edges, Need_no_correspondence_before_the_first_move) {
  expect_constrained_edges_without_correspondence(user_mesh(meshes::potato(2, 6)));
  const meshes::Mesh grid = meshes::grid(270, 270); // which is renumbered
  expect_constrained_edges_without_correspondence(
      user_mesh(meshes::permuted(grid, meshes::permutation(grid.points.size(), 3), 5)));
}

template <class Mesh>
class Places_on_mesh : public testing::Test {};
using User_meshes = testing::Types<Surface_mesh, Polyhedron, OpenMesh_triangles, OpenMesh_polygons>;
TYPED_TEST_SUITE(Places_on_mesh, User_meshes);

TYPED_TEST(Places_on_mesh, Are_those_of_every_mesh_type) {
  const auto mesh = meshes::mesh_of<TypeParam>(meshes::potato(2, 6));
  Triangulation<IT::Integer_coordinates> t(mesh);
  IT::flip_to_delaunay(t);
  for (const auto f : faces(mesh)) {
    const IT::Face_location<TypeParam> place{f, {0.2, 0.3, 0.5}};
    const IT::Surface_point p = IT::surface_point(t, place, mesh);
    EXPECT_EQ(IT::face_location(t, p, mesh), place);
    const auto there = IT::locate_on_intrinsic(t, place, mesh);
    ASSERT_TRUE(there);
    const auto back = IT::locate_on_input(t, *there, mesh);
    ASSERT_TRUE(back);
    EXPECT_LT(distance(IT::point_in_space(t, IT::surface_point(t, *back, mesh), mesh),
                       IT::point_in_space(t, p, mesh)),
              1e-9);
  }
}

/// Where the library numbers everything in another way.
TEST(Renumbered_meshes, Keep_their_places_and_edges) {
  const meshes::Mesh grid = meshes::grid(270, 270);
  const auto mesh =
      user_mesh(meshes::permuted(grid, meshes::permutation(grid.points.size(), 3), 5));
  const Triangulation<IT::Integer_coordinates> t(mesh);
  ASSERT_TRUE(t.report().renumbered);
  std::size_t i = 0;
  for (const auto f : faces(mesh)) {
    if (i++ % 100 != 0) continue;
    const IT::Face_location<Surface_mesh> place{f, {0.25, 0.25, 0.5}};
    const auto x = IT::point_in_space(t, IT::surface_point(t, place, mesh), mesh);
    const auto h = halfedge(f, mesh);
    const auto expected =
        CGAL::barycenter(mesh.point(source(h, mesh)), 0.25, mesh.point(target(h, mesh)), 0.25,
                         mesh.point(target(next(h, mesh), mesh)), 0.5);
    EXPECT_LT(distance(x, expected), 1e-12);
  }
  i = 0;
  for (const auto h : halfedges(mesh)) {
    if (i++ % 100 != 0) continue;
    const auto points = IT::polyline(t, IT::trace_input_edge(t, edge(h, mesh), mesh), mesh);
    EXPECT_EQ(points.front(), mesh.point(source(edge(h, mesh), mesh)));
    EXPECT_EQ(points.back(), mesh.point(target(edge(h, mesh), mesh)));
  }
}

TEST(Places_without_correspondence, Are_refused) {
  const Surface_mesh mesh = user_mesh(meshes::potato(1, 6));
  const IT::Intrinsic_triangulation<> t(mesh);
  const IT::Face_location<Surface_mesh> place{*faces(mesh).begin(), {0.2, 0.3, 0.5}};
  EXPECT_THROW(IT::surface_point(t, place, mesh), IT::Invalid_input);
  EXPECT_THROW(IT::face_location(t, IT::Surface_point(), mesh), IT::Invalid_input);
  EXPECT_THROW(IT::point_in_space(t, IT::Surface_point(), mesh), IT::Invalid_input);
}

TEST(Polygons, Have_edges_but_no_places) {
  Surface_mesh mesh;
  std::vector<Surface_mesh::Vertex_index> v;
  for (const auto& [x, y] : {std::pair{0, 0}, {2, 0}, {2, 1}, {0, 1}, {3, 0}})
    v.push_back(mesh.add_vertex({1. * x, 1. * y, 0}));
  const auto quad = mesh.add_face(v[0], v[1], v[2], v[3]),
             triangle = mesh.add_face(v[1], v[4], v[2]);
  const Triangulation<IT::Integer_coordinates> t(mesh);
  EXPECT_THROW(IT::surface_point(t, {quad, {0.5, 0.25, 0.25}}, mesh), IT::Invalid_input);
  const IT::Face_location<Surface_mesh> place{triangle, {0.5, 0.25, 0.25}};
  EXPECT_EQ(IT::face_location(t, IT::surface_point(t, place, mesh), mesh), place);
  for (const auto e : edges(mesh)) {
    const auto points = IT::polyline(t, IT::trace_input_edge(t, e, mesh), mesh);
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points.front(), mesh.point(source(e, mesh)));
    EXPECT_EQ(points.back(), mesh.point(target(e, mesh)));
  }
  Surface_mesh other(mesh);
  other.add_vertex({9, 9, 9});
  EXPECT_THROW(IT::surface_point(t, place, other), IT::Invalid_input);
}

} // namespace
