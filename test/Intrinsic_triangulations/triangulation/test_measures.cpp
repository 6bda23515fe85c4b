// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include "gallery.h"
#include "mesh_types.h"
#include "meshes.h"

#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using std::numbers::pi;

template <class Traits, class Correspondence = IT::No_correspondence>
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, Correspondence>;
using Exact = Triangulation<IT::Exact_euclidean_traits>;
using Double = Triangulation<IT::Euclidean_traits<double>>;

// ---- what the mesh in space says, by other formulas: cosines of angles between vectors, cross products

using meshes::area, meshes::cross, meshes::dot, meshes::minus, meshes::norm, meshes::Point;

std::vector<double> curvatures_in_space(const meshes::Mesh& m, const std::vector<bool>& on_border) {
  std::vector<double> result(m.points.size());
  for (std::size_t v = 0; v < result.size(); ++v) result[v] = on_border[v] ? pi : 2 * pi;
  for (const auto& f : m.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Point a = minus(m.points[f[(k + 1) % 3]], m.points[f[k]]),
                  b = minus(m.points[f[(k + 2) % 3]], m.points[f[k]]);
      result[f[k]] -= std::acos(dot(a, b) / std::sqrt(dot(a, a) * dot(b, b)));
    }
  return result;
}

std::vector<std::pair<std::string, meshes::Mesh>> all_meshes() {
  return {{"grid", meshes::grid(5, 4)},
          {"sheared grid", meshes::sheared_grid(5, 5, 7)},
          {"rough grid", meshes::rough_grid(6, 5)},
          {"box", meshes::box(3, 2, 4)},
          {"sphere", meshes::sphere(2)},
          {"potato", meshes::potato(2, 6)}};
}

template <class T>
std::vector<bool> border(const T& t) {
  std::vector<bool> result(t.number_of_vertices(), false);
  for (const auto h : halfedges(t.mesh()))
    if (face(h, t.mesh()) == boost::graph_traits<typename T::Mesh>::null_face())
      result[t.input_vertex(target(h, t.mesh()))] = true;
  return result;
}

// flips and insertions keep all measures of the surface, and inserted vertices are flat
template <class T>
void expect_measures_of_space(double error) {
  for (const auto& [name, m] : all_meshes()) {
    T t(m.input());
    const std::vector<double> expected = curvatures_in_space(m, border(t));
    const auto expect_same = [&, &n = name](const char* when) {
      EXPECT_NEAR(IT::total_area(t), area(m), error * area(m)) << n << when;
      for (const auto v : vertices(t.mesh()))
        EXPECT_NEAR(IT::gaussian_curvature(t, v),
                    t.is_inserted(v) ? 0 : expected[t.input_vertex(v)], error)
            << n << when << t.input_vertex(v);
    };
    expect_same(" before");
    IT::flip_to_delaunay(t);
    expect_same(" flipped");
    IT::delaunay_refine(t, IT::parameters::minimum_angle(28).maximum_insertions(300));
    expect_same(" refined");
  }
}

TEST(Measures, are_those_of_the_mesh_in_space_whatever_moves_were_made) {
  expect_measures_of_space<Exact>(1e-10);
  expect_measures_of_space<Triangulation<IT::Exact_euclidean_traits, IT::Integer_coordinates>>(
      1e-10);
  expect_measures_of_space<Triangulation<IT::Exact_euclidean_traits, IT::Explicit_crossings>>(
      1e-10);
  expect_measures_of_space<Triangulation<IT::Exact_euclidean_traits, IT::Signposts>>(1e-10);
  expect_measures_of_space<Double>(1e-9);
}

TEST(Measures, satisfy_Gauss_and_Bonnet_on_every_delta_complex_of_the_gallery) {
  for (const gallery::Surface& s : gallery::oriented()) {
    if (s.name.find("isolated") != std::string::npos ||
        s.name.find("bow tie") != std::string::npos ||
        s.name.find("sharing a vertex") != std::string::npos)
      continue; // a vertex that is not manifold has several fans
    Exact t(gallery::input(s));
    double sum = 0;
    for (const auto v : vertices(t.mesh())) sum += IT::gaussian_curvature(t, v);
    EXPECT_NEAR(sum, 2 * pi * static_cast<double>(s.euler_characteristic()), 1e-11) << s;
  }
}

TEST(Measures, have_closed_forms) {
  const Exact box(meshes::box(1, 1, 1).input());
  for (const auto v : vertices(box.mesh()))
    EXPECT_NEAR(IT::gaussian_curvature(box, v), pi / 2, 1e-15);
  EXPECT_NEAR(IT::total_area(box), 6, 1e-14);
  const Exact torus(gallery::input(gallery::one_vertex_torus()));
  for (const auto v : vertices(torus.mesh()))
    EXPECT_NEAR(IT::gaussian_curvature(torus, v), 0, 1e-15);
  // the octagon has one vertex, where its angles of 135 degrees meet
  const Exact octagon(gallery::input(gallery::octagon_of_genus_2()));
  for (const auto v : vertices(octagon.mesh()))
    EXPECT_NEAR(IT::gaussian_curvature(octagon, v), -4 * pi, 1e-13);
  EXPECT_NEAR(IT::total_area(octagon), 2 * std::sqrt(2.0), 1e-14);
  const Exact square(meshes::grid(1, 1).input());
  for (const auto v : vertices(square.mesh()))
    EXPECT_NEAR(IT::gaussian_curvature(square, v), pi / 2, 1e-15) << "corners of the border";
}

TEST(Measures, are_accurate_on_needles_after_many_flips) {
  // each row is shifted by 1000 cells: most of its faces are needles still, but flat
  Exact t(meshes::sheared_grid(4, 4, 1000).input());
  IT::flip_to_delaunay(t);
  const std::vector<bool> on_border = border(t);
  double sum = 0;
  for (const auto v : vertices(t.mesh())) {
    const double k = IT::gaussian_curvature(t, v);
    if (!on_border[t.input_vertex(v)]) {
      EXPECT_NEAR(k, 0, 1e-12);
    }
    sum += k;
  }
  EXPECT_NEAR(sum, 2 * pi, 1e-9);
  EXPECT_NEAR(IT::total_area(t), 16, 1e-12);
}

TEST(Measures, cotangent_weights_of_single_edges_are_those_of_the_angles_in_space) {
  const meshes::Mesh m = meshes::rough_grid(6, 5);
  const Exact t(m.input());
  const Double u(m.input());
  const auto expect_weights = [&m](const auto& x) {
    for (const auto e : edges(x.mesh())) {
      double expected = 0;
      for (const auto h : {halfedge(e, x.mesh()), opposite(halfedge(e, x.mesh()), x.mesh())}) {
        if (CGAL::is_border(h, x.mesh())) continue;
        const auto point = [&](const auto g) {
          return m.points[x.input_vertex(target(g, x.mesh()))];
        };
        const auto n = next(h, x.mesh());
        const Point a = minus(point(h), point(n)), b = minus(point(next(n, x.mesh())), point(n));
        expected += dot(a, b) / norm(cross(a, b)) / 2;
      }
      EXPECT_NEAR(IT::cotangent_weight(x, e), expected, 1e-12 * (1 + std::abs(expected)));
    }
  };
  expect_weights(t);
  expect_weights(u);
}

template <class Mesh>
class Measures_of_mesh : public ::testing::Test {};
TYPED_TEST_SUITE(Measures_of_mesh, All_meshes);

TYPED_TEST(Measures_of_mesh, are_the_same_for_each_mesh_type) {
  IT::Intrinsic_triangulation<TypeParam> t(meshes::box(2, 2, 2).input());
  IT::flip_to_delaunay(t);
  double sum = 0;
  for (const auto v : vertices(t.mesh())) sum += IT::gaussian_curvature(t, v);
  EXPECT_NEAR(sum, 4 * pi, 1e-12);
  EXPECT_NEAR(IT::total_area(t), 24, 1e-12);
}

} // namespace
