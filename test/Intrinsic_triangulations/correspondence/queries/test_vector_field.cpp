// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_sectors.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_edge.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/vector_field.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include "mesh_types.h"
#include "meshes.h"
#include "surface_mesh.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

template <class Correspondence>
class Vector_field : public testing::Test {};
using Correspondences =
    testing::Types<IT::Integer_coordinates, IT::Explicit_crossings, IT::Signposts>;
TYPED_TEST_SUITE(Vector_field, Correspondences);

Surface_mesh surface_mesh(const meshes::Mesh& m) { return meshes::surface_mesh<Surface_mesh>(m); }

/// The vector (1, 2, 0) of the plane at every vertex.
template <class T>
IT::Tangent_field constant_field(const T& t, const Surface_mesh& mesh) {
  IT::Tangent_field field(t.number_of_vertices());
  for (const auto v : vertices(t.mesh())) {
    const auto h = opposite(halfedge(v, t.mesh()), t.mesh());
    auto points = IT::polyline(t, IT::trace_edge(t, edge(h, t.mesh())), mesh);
    if (t.numbers().halfedge(h) % 2 != 0) std::reverse(points.begin(), points.end());
    const auto d = points.back() - points.front();
    const std::complex<double> axis(d.x(), d.y());
    double angle = std::arg(std::complex<double>(1, 2) / axis);
    if (face(opposite(h, t.mesh()), t.mesh()) ==
        boost::graph_traits<typename T::Mesh>::null_face()) {
      const IT::Intrinsic_view<T> view(t); // on the border: scaled to half a circle
      bool is_on_border = false;
      const double all = IT::cone_angle(view, t.numbers().halfedge(h), is_on_border);
      if (angle < 0) angle += 2 * std::numbers::pi;
      angle *= std::numbers::pi / all;
      if (angle > std::numbers::pi) continue; // points out of the surface
    }
    field[t.input_vertex(v)] = std::polar(std::sqrt(5.), angle);
  }
  return field;
}

TYPED_TEST(Vector_field, That_is_constant_in_the_plane_stays_so_at_all_vertices) {
  using T = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, TypeParam>;
  for (const auto& [name, shape] :
       {std::pair{"random", meshes::random_planar(60, 1000, 2)},
        std::pair{"grid", meshes::scaled(meshes::grid(4, 12), 0.001)}}) {
    const Surface_mesh mesh = surface_mesh(shape);
    T t(mesh);
    IT::delaunay_refine(t, IT::parameters::minimum_angle(28));
    const IT::Tangent_field field = constant_field(t, mesh);
    const auto at_vertices = IT::vectors_in_space(t, field, mesh);
    std::size_t count = 0;
    for (const auto v : vertices(t.mesh())) {
      const std::uint32_t i = t.input_vertex(v);
      if (std::abs(field[i]) == 0) continue;
      ++count;
      EXPECT_NEAR(at_vertices[i][0], 1, 1e-6) << name << ' ' << i;
      EXPECT_NEAR(at_vertices[i][1], 2, 1e-6) << name << ' ' << i;
      EXPECT_NEAR(at_vertices[i][2], 0, 1e-12) << name;
    }
    EXPECT_GT(2 * count, num_vertices(t.mesh()));
  }
}

/// Crosses and their kin: at each vertex any of the directions is given, at each face all of them
/// are found.
TYPED_TEST(Vector_field, Of_several_directions_does_not_depend_on_which_is_given) {
  using T = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, TypeParam>;
  const unsigned seed = 17;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (const meshes::Mesh& shape :
       {meshes::random_planar(60, 1000, 2), meshes::scaled(meshes::grid(4, 12), 0.001)}) {
    const Surface_mesh mesh = surface_mesh(shape);
    const std::vector<std::array<double, 3>>& points = shape.points;
    T t(mesh);
    IT::delaunay_refine(t, IT::parameters::minimum_angle(28));
    const IT::Common_subdivision s = IT::common_subdivision(t);
    const IT::Tangent_field constant = constant_field(t, mesh);
    for (const unsigned degree : {1U, 2U, 3U, 4U, 6U}) {
      IT::Tangent_field field = constant;
      for (std::complex<double>& z : field)
        z *= std::polar(1., 2 * std::numbers::pi * static_cast<double>(random() % degree) / degree);
      const auto by_points = IT::vectors_in_space(t, field, s, points, degree);
      const auto by_mesh = IT::vectors_in_space(t, field, s, mesh, degree);
      EXPECT_EQ(by_mesh, by_points);
      ASSERT_EQ(by_points.size(), degree * s.number_of_faces());
      std::size_t inside = 0;
      for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
        bool is_inside =
            true; // where a direction on the border is turned, the others leave the surface
        auto h = halfedge(t.numbers().face_at(s.intrinsic_face[f]), t.mesh());
        for (int k = 0; k < 3; ++k, h = next(h, t.mesh()))
          for (const auto g : CGAL::halfedges_around_source(source(h, t.mesh()), t.mesh()))
            is_inside = is_inside && !CGAL::is_border(g, t.mesh());
        if (!is_inside) continue;
        ++inside;
        // the one nearest to (1, 2, 0), then the others counterclockwise; vertices are where exact
        // coordinates are after rounding, off by 1e-6 of small faces at most
        std::size_t first = 0;
        const auto along = [&](std::size_t k) {
          const auto& x = by_points[degree * f + k];
          return x[0] + 2 * x[1];
        };
        for (std::size_t k = 1; k < degree; ++k)
          if (along(k) > along(first)) first = k;
        for (std::size_t k = 0; k < degree; ++k) {
          const auto& x = by_points[degree * f + (first + k) % degree];
          const std::complex<double> wanted =
              std::complex<double>(1, 2) *
              std::polar(1., 2 * std::numbers::pi * static_cast<double>(k) / degree);
          EXPECT_NEAR(x[0], wanted.real(), 1e-6) << degree << ' ' << f;
          EXPECT_NEAR(x[1], wanted.imag(), 1e-6) << degree << ' ' << f;
          EXPECT_NEAR(x[2], 0, 1e-12);
        }
      }
      EXPECT_GT(inside, 10U);
    }
  }
}

/// Lengths are kept and vectors are tangent to the faces that they are in.
TYPED_TEST(Vector_field, Keeps_lengths_on_curved_surfaces) {
  using T = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, TypeParam>;
  const Surface_mesh mesh = surface_mesh(meshes::potato(2, 6));
  T t(mesh);
  IT::delaunay_refine(t, IT::parameters::maximum_circumradius(0.2));
  IT::Tangent_field field(t.number_of_vertices());
  for (std::size_t i = 0; i < field.size(); ++i)
    field[i] = std::polar(1 + 0.01 * static_cast<double>(i), static_cast<double>(i));
  const auto vectors = IT::vectors_in_space(t, field, mesh);
  for (const auto v : vertices(t.mesh())) {
    const auto& x = vectors[t.input_vertex(v)];
    EXPECT_NEAR(std::hypot(x[0], x[1], x[2]), std::abs(field[t.input_vertex(v)]), 1e-9);
  }
}

/// A vector in a face of the input, which has an area.
std::array<double, 3> in_space(const IT::Input& input, const IT::Tangent_vector& v,
                               const std::vector<std::array<double, 3>>& points) {
  const auto corner = [&](std::uint32_t h) {
    const auto& p = points[input.names().row(input.source(h))];
    return Kernel::Point_3(p[0], p[1], p[2]);
  };
  const std::uint32_t h = v.point.halfedge, n = input.next(h);
  const Kernel::Vector_3 side = corner(n) - corner(h), to_apex = corner(input.next(n)) - corner(h),
                         left = to_apex - to_apex * side / side.squared_length() * side;
  EXPECT_GT(left.squared_length(), 0x1p-40 * to_apex.squared_length());
  const Kernel::Vector_3 x = v.vector[0] / std::sqrt(side.squared_length()) * side +
                             v.vector[1] / std::sqrt(left.squared_length()) * left;
  return {x[0], x[1], x[2]};
}

/// At vertices of the input, on edges, in faces and on borders, a sector has the vector that a query
/// finds, in any direction, also out of the surface.
TYPED_TEST(Vector_field, In_sectors_is_where_queries_find_it) {
  using T = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, TypeParam>;
  std::size_t beyond = 0;
  for (const meshes::Mesh& shape :
       {meshes::random_planar(60, 1000, 2), meshes::scaled(meshes::grid(4, 12), 0.001),
        meshes::potato(2, 6), meshes::rough_grid(6, 3), meshes::box(2, 3, 4)}) {
    const Surface_mesh mesh = surface_mesh(shape);
    const std::vector<std::array<double, 3>>& points = shape.points;
    T t(mesh);
    IT::delaunay_refine(t, IT::parameters::minimum_angle(28));
    const IT::Vertex_sectors sectors(t, points);
    ASSERT_EQ(sectors.size(), t.number_of_vertices());
    for (int k = 0; k < 24; ++k) {
      const std::complex<double> z = std::polar(3., k < 12 ? k * std::numbers::pi / 6 : 0.3 + k);
      const auto found = sectors.in_space(IT::Tangent_field(sectors.size(), z));
      for (const auto v : vertices(t.mesh())) {
        const bool is_beyond = z.imag() < 0 && CGAL::is_border(halfedge(v, t.mesh()), t.mesh());
        beyond += is_beyond;
        if (std::is_same_v<TypeParam, IT::Signposts> && is_beyond)
          continue; // the query turns it to the border
        const auto x = IT::tangent_to_input(t, IT::tangent_vector(t, v, z));
        ASSERT_TRUE(x);
        const auto wanted = in_space(t.input(), *x, points);
        if (is_beyond && z.real() < 1e-9) { // drawn in the plane of the nearer side, the last face
          EXPECT_NEAR(std::hypot(found[t.input_vertex(v)][0], found[t.input_vertex(v)][1],
                                 found[t.input_vertex(v)][2]),
                      3, 1e-8);
          continue;
        }
        for (std::size_t c = 0; c < 3; ++c) // directions of signposts are the least accurate ones
          EXPECT_NEAR(found[t.input_vertex(v)][c], wanted[c], 1e-8) << t.index(v) << ' ' << z;
      }
    }
    EXPECT_THROW(sectors.in_space(IT::Tangent_field(3)), std::invalid_argument);
  }
  EXPECT_GT(beyond, 100U);
}

} // namespace
