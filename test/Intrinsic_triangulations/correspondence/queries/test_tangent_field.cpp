// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent_field.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/vector_field.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/tracing/tangent_frames.h>

#include "gallery.h"
#include "mesh_types.h"
#include "meshes.h"
#include "surface_mesh.h"

#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Complex = std::complex<double>;

template <class Traits, class Correspondence_>
struct Choice {
  using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, Correspondence_>;
};
using Doubles = IT::Euclidean_traits<double>;

template <class Choice>
class Field_transfer : public testing::Test {};
using Choices =
    testing::Types<Choice<IT::Exact_euclidean_traits, IT::Integer_coordinates>,
                   Choice<IT::Exact_euclidean_traits, IT::Explicit_crossings>,
                   Choice<IT::Exact_euclidean_traits, IT::Signposts>,
                   Choice<Doubles, IT::Integer_coordinates>, Choice<Doubles, IT::Signposts>>;
TYPED_TEST_SUITE(Field_transfer, Choices);

Surface_mesh surface_mesh(const meshes::Mesh& m) { return meshes::surface_mesh<Surface_mesh>(m); }

IT::Tangent_field random_field(std::size_t size) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> d(-1, 1);
  IT::Tangent_field field(size);
  for (Complex& z : field) z = {d(random), d(random)};
  return field;
}

TYPED_TEST(Field_transfer, Of_a_constant_field_of_the_plane_is_constant) {
  using T = typename TypeParam::Triangulation;
  const Surface_mesh mesh = surface_mesh(meshes::scaled(meshes::random_planar(60, 1000, 2), 0.01));
  const Complex constant(1, 2);
  IT::Tangent_field field(mesh.number_of_vertices(), 0); // zero on the border
  for (const auto v : mesh.vertices()) {
    if (mesh.is_border(v)) continue;
    const auto d = mesh.point(source(mesh.halfedge(v), mesh)) - mesh.point(v);
    field[v] = constant / (Complex(d.x(), d.y()) / std::hypot(d.x(), d.y()));
  }
  T t(mesh);
  IT::delaunay_refine(t, IT::parameters::minimum_angle(28).maximum_edge_length(1));
  const auto vectors =
      IT::vectors_in_space(t, IT::tangent_field_to_intrinsic(t, field, mesh), mesh);
  std::size_t inserted = 0;
  for (const auto v : vertices(t.mesh())) {
    bool is_inside = true; // as are the corners of the input face that it is in
    if (t.is_inserted(v)) {
      const auto w = IT::weighted_vertices(t, t.correspondence().location(t.index(v)));
      for (std::size_t k = 0; k < w.size; ++k)
        is_inside = is_inside && (w.weights[k] == 0 ||
                                  !mesh.is_border(Surface_mesh::Vertex_index(w.vertices[k])));
    } else {
      is_inside = !mesh.is_border(Surface_mesh::Vertex_index(t.input_vertex(v)));
    }
    if (!is_inside) continue;
    if (t.is_inserted(v)) ++inserted;
    EXPECT_NEAR(vectors[t.input_vertex(v)][0], 1, 1e-8);
    EXPECT_NEAR(vectors[t.input_vertex(v)][1], 2, 1e-8);
    EXPECT_NEAR(vectors[t.input_vertex(v)][2], 0, 1e-12);
  }
  EXPECT_GT(inserted, 10U);
}

TYPED_TEST(Field_transfer, There_and_back_is_the_identity) {
  using T = typename TypeParam::Triangulation;
  for (const auto& [name, shape] :
       {std::pair{"grid", meshes::rough_grid(5, 4)}, std::pair{"box", meshes::box(2, 3, 2)},
        std::pair{"potato", meshes::potato(2, 6)}}) {
    const Surface_mesh mesh = surface_mesh(shape);
    T t(mesh);
    IT::delaunay_refine(t, IT::parameters::minimum_angle(25));
    const IT::Tangent_field field = random_field(mesh.number_of_vertices());
    const IT::Tangent_field there = IT::tangent_field_to_intrinsic(t, field, mesh),
                            back = IT::tangent_field_to_input(t, there, mesh);
    ASSERT_EQ(there.size(), t.number_of_vertices());
    ASSERT_EQ(back.size(), field.size());
    for (std::size_t i = 0; i < field.size(); ++i) {
      EXPECT_LE(std::abs(back[i] - field[i]), 1e-9) << name << ' ' << i;
      EXPECT_NEAR(std::abs(there[i]), std::abs(field[i]), 1e-12) << name << ' ' << i;
    }
  }
}

TYPED_TEST(Field_transfer, There_and_back_is_the_identity_where_edges_are_loops) {
  using T = typename TypeParam::Triangulation;
  for (const gallery::Surface& g : gallery::oriented()) {
    T t(gallery::input(g));
    const IT::Tangent_field field = random_field(t.number_of_vertices());
    for (const auto e : edges(t.mesh())) t.flip_edge(halfedge(e, t.mesh()));
    const IT::Tangent_field there = IT::tangent_field_to_intrinsic(t, field),
                            back = IT::tangent_field_to_input(t, there);
    for (const auto v : vertices(t.mesh())) {
      const bool is_isolated =
          halfedge(v, t.mesh()) == boost::graph_traits<typename T::Mesh>::null_halfedge();
      const std::uint32_t i = t.input_vertex(v);
      EXPECT_LE(std::abs(back[i] - (is_isolated ? 0 : field[i])), 1e-9) << g << i;
    }
  }
}

/// The angle from a halfedge counterclockwise to a vector at its source.
template <class View>
double angle_from(const View& view, std::uint32_t h, const IT::Tangent_vector& v) {
  const IT::Geodesic_face face(view, v.point.halfedge);
  double sum = 0;
  std::uint32_t g = h;
  do {
    for (unsigned k = 0; k < 3; ++k)
      if (face.side[k] == g && v.point.weights[k] > 1 - 1e-7) {
        const auto r = face.relative_to(k, v.vector);
        return sum + std::atan2(r[1], r[0]);
      }
    sum += angle_at_source(view, g);
    g = next_around_source(view, g);
  } while (g != h);
  ADD_FAILURE() << "the vector is not at the vertex";
  return 0;
}

/// At inserted vertices: against the interpolated vector in the face of the input, taken by the query for points.
TYPED_TEST(Field_transfer, Interpolates_at_inserted_vertices_of_a_curved_surface) {
  using T = typename TypeParam::Triangulation;
  const Surface_mesh mesh = surface_mesh(meshes::potato(2, 6));
  T t(mesh);
  IT::delaunay_refine(t, IT::parameters::maximum_circumradius(0.25));
  const IT::Input& input = t.input();
  const IT::Tangent_field field = random_field(mesh.number_of_vertices());
  const IT::Tangent_field there = IT::tangent_field_to_intrinsic(t, field);
  const IT::Tangent_frames frames(input);
  const IT::Intrinsic_view<T> view(t);
  std::size_t count = 0;
  for (const auto v : vertices(t.mesh())) {
    if (!t.is_inserted(v)) continue;
    const IT::Surface_point p = t.correspondence().location(t.index(v));
    const IT::Geodesic_face face(input, p.halfedge);
    IT::Tangent_vector x{p, {0, 0}};
    for (unsigned k = 0; k < 3; ++k) {
      const std::uint32_t h = face.side[k], corner = input.source(h);
      const Complex z = field[input.names().vertices.user(corner)];
      const auto& fan = frames.fan(frames.fan_of(h));
      // angles on the surface, from the first halfedge there
      const double angle = std::arg(z) / fan.scale() +
                           frames.cone_angle(input.outgoing_halfedge(corner)) -
                           frames.cone_angle(h);
      const double turn = std::remainder(angle, fan.angle);
      const auto y =
          face.from_relative_to(k, {std::abs(z) * std::cos(turn), std::abs(z) * std::sin(turn)});
      for (std::size_t c = 0; c < 2; ++c) x.vector[c] += p.weights[k] * y[c];
    }
    const Complex z = there[t.input_vertex(v)];
    EXPECT_NEAR(std::abs(z), std::hypot(x.vector[0], x.vector[1]), 1e-9);
    const auto found = IT::tangent_to_intrinsic(t, x);
    ASSERT_TRUE(found);
    const double angle = angle_from(view, view.outgoing_halfedge(t.index(v)), *found);
    EXPECT_LE(std::abs(std::remainder(angle - std::arg(z), 2 * std::numbers::pi)) * std::abs(z),
              1e-6);
    ++count;
  }
  EXPECT_GT(count, 20U);
}

TEST(Field_transfer_errors, Fields_must_have_a_vector_per_vertex) {
  const Surface_mesh mesh = surface_mesh(meshes::box(1, 1, 1));
  const Choice<Doubles, IT::Integer_coordinates>::Triangulation t(mesh);
  EXPECT_THROW(IT::tangent_field_to_intrinsic(t, IT::Tangent_field(7), mesh),
               std::invalid_argument);
  EXPECT_THROW(IT::tangent_field_to_input(t, IT::Tangent_field(9), mesh), std::invalid_argument);
}

TEST(Field_transfer_of_polygons, Has_axes_along_the_sides_of_polygons) {
  Surface_mesh mesh; // a cube of quadrilaterals
  for (unsigned v = 0; v < 8; ++v)
    mesh.add_vertex({static_cast<double>(v & 1U), static_cast<double>((v >> 1) & 1U),
                     static_cast<double>(v >> 2)});
  const std::array<unsigned, 4> quads[] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& q : quads)
    mesh.add_face(Surface_mesh::Vertex_index(q[0]), Surface_mesh::Vertex_index(q[1]),
                  Surface_mesh::Vertex_index(q[2]), Surface_mesh::Vertex_index(q[3]));
  const Choice<Doubles, IT::Integer_coordinates>::Triangulation t(mesh);
  // along the axis: the vector in space is that of the edge
  const auto vectors = IT::vectors_in_space(
      t, IT::tangent_field_to_intrinsic(t, IT::Tangent_field(8, 1), mesh), mesh);
  for (const auto v : mesh.vertices()) {
    const auto d = mesh.point(source(mesh.halfedge(v), mesh)) - mesh.point(v);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(vectors[v][static_cast<std::size_t>(k)], d[k], 1e-12) << v;
  }
}

} // namespace
