// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/angles/flat_angles.h>
#include <CGAL/Intrinsic_conformal/angles/ideal_start.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_scaled.h>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.h>
#include <CGAL/Intrinsic_conformal/metric/flat_surface.h>
#include <CGAL/Intrinsic_conformal/metric/hyperbolic_metric.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "flat_surfaces.h"
#include "gallery.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Layouts of meshes whose conformal map starts from their Delaunay triangulation.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Euclidean = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                              IT::Integer_coordinates>;
using Ideal = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Ideal_hyperbolic_traits<double>,
                                          IT::Integer_coordinates>;

struct Mapped {
  std::vector<double> u;
  IT::Scaled_layout layout;
};

enum class Start { mesh, delaunay };

// Scales the double of a surface with border, or a closed one, and lays it out.
template <class Angles>
Mapped mapped(IT::Intrinsic_input in, Start start, const Angles& angles_of,
              bool is_hyperbolic = false) {
  Euclidean t(IT::make_domain(std::move(in), IT::Domain_kind::closed).input);
  if (start == Start::delaunay) IT::flip_to_delaunay(t);
  Ideal ideal(start == Start::mesh ? IT::ideal_start(t.input()) : IT::ideal_start(t));
  IT::Surface_to_cut flat = IT::flat_surface(ideal);
  const IT::Prescribed_angles angles = angles_of(ideal);
  const auto np = IT::parameters::tolerance(1e-13).number_of_iterations(30);
  const IT::Conformal_metric m = is_hyperbolic ? IT::hyperbolic_metric(ideal, angles, np)
                                               : IT::conformal_metric(ideal, angles, np);
  EXPECT_LE(m.residual, 1e-11);
  IT::Scaled_surface s = IT::scaled_surface(ideal, std::move(flat), m.scale_factors, angles,
                                            t.input().names(), is_hyperbolic);
  if (start == Start::delaunay) IT::add_mesh(s, t, ideal);
  return {m.u, IT::lay_out_scaled(s)};
}

IT::Prescribed_angles flat_ones(Ideal& t) { return IT::flat_angles(t); }

// Two cones on a surface of genus 1.
IT::Prescribed_angles with_cones(Ideal& t) {
  IT::Prescribed_angles angles = IT::flat_angles(t);
  angles.set(3, IT::Multiple_of_pi{3, 2});
  angles.set(8, IT::Multiple_of_pi{5, 2});
  return angles;
}

// Homogeneous coordinates are linear functions of barycentric coordinates on the mesh, on each piece
// with more than three corners. Returns how many such pieces there are.
std::size_t expect_projective(const IT::Subdivision_layout& layout) {
  std::size_t checked = 0;
  const IT::Common_subdivision& s = layout.subdivision;
  const std::vector<double> values = IT::fields_of_layout(layout).at(2).values;
  const Eigen::Map<const Eigen::Matrix3Xd> homogeneous(values.data(), 3, layout.weights.size());
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    const auto corners = s.face(f);
    std::vector<std::uint32_t> names;
    Eigen::Matrix3Xd weights = Eigen::Matrix3Xd::Zero(3, std::ssize(corners)), images = weights;
    for (Eigen::Index c = 0; c < std::ssize(corners); ++c) {
      const std::uint32_t v = corners[static_cast<std::size_t>(c)];
      const IT::Weighted_vertices on = s.on_input(v);
      for (std::size_t i = 0; i < on.size; ++i) {
        if (on.weights[i] == 0) continue;
        auto at = std::find(names.begin(), names.end(), on.vertices[i]);
        if (at == names.end()) at = names.insert(at, on.vertices[i]);
        if (names.size() <= 3) weights(at - names.begin(), c) += on.weights[i];
      }
      images.col(c) = homogeneous.col(v);
    }
    const Eigen::Matrix3d square = weights * weights.transpose();
    if (corners.size() < 4 || names.size() != 3 || !(square.determinant() > 1e-8)) continue;
    const Eigen::Matrix3d map = images * weights.transpose() * square.inverse();
    EXPECT_LE((map * weights - images).norm(), 1e-7 * images.norm());
    ++checked;
  }
  return checked;
}

// The places of the vertices of the mesh in a layout without cuts.
std::vector<std::complex<double>> places(const IT::Subdivision_layout& layout, std::size_t n) {
  std::vector<std::complex<double>> result(n);
  const IT::Common_subdivision& s = layout.subdivision;
  for (std::uint32_t v = 0; v < s.vertices.size(); ++v)
    if (s.kind(v) == IT::Subdivision_vertex_kind::input)
      result[s.vertices[v].on_input.vertices[0]] = {layout.positions(v, 0), layout.positions(v, 1)};
  return result;
}

// A box without lid, of triangles that are mixed.
flat::Surface open_box(unsigned seed) {
  flat::Surface s({{0, 2, 1},
                   {0, 3, 2},
                   {0, 1, 5},
                   {0, 5, 4},
                   {1, 2, 6},
                   {1, 6, 5},
                   {2, 3, 7},
                   {2, 7, 6},
                   {3, 0, 4},
                   {3, 4, 7}},
                  {{0, 0, 0},
                   {1.1, 0, 0},
                   {1, 1.2, 0},
                   {0, 1, 0},
                   {0, 0, 1},
                   {1.2, 0, 1},
                   {1, 1.3, 1.1},
                   {0, 1, 1}});
  std::mt19937 random(seed);
  s.mix(random, 40, 100);
  return s;
}

TEST(LayOutScaled, doesNotDependOnTheTrianglesOfTheMesh) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    flat::Surface s = open_box(seed);
    const std::size_t n = s.gluing.number_of_vertices;
    const Mapped first = mapped(input_of(s), Start::delaunay, flat_ones);
    std::mt19937 random(seed + 100);
    s.mix(random, 0, 300);
    const Mapped second = mapped(input_of(s), Start::delaunay, flat_ones);
    for (std::size_t v = 0; v < n; ++v) EXPECT_NEAR(first.u[v], second.u[v], 1e-9);
    const auto z = places(first.layout.layout, n), w = places(second.layout.layout, n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_NEAR(std::abs(z[i] - z[j]), std::abs(w[i] - w[j]), 1e-8);
    for (const Mapped* m : {&first, &second}) {
      EXPECT_TRUE(m->layout.certificate.is_locally_injective());
      EXPECT_LE(m->layout.layout.largest_side_error, 1e-7);
      EXPECT_GT(expect_projective(m->layout.layout), 10U);
    }
  }
}

// Where there are cuts, they are edges of the mesh: the same from both starts.
TEST(LayOutScaled, isThatOfTheMeshIfItIsDelaunay) {
  flat::Surface s = flat::Surface::torus(1, flat::Complex(-0.3, 0.9), 5);
  const Mapped first = mapped(input_of(s), Start::mesh, with_cones),
               second = mapped(input_of(s), Start::delaunay, with_cones);
  const IT::Subdivision_layout &a = first.layout.layout, &b = second.layout.layout;
  ASSERT_EQ(a.positions.rows(), b.positions.rows());
  EXPECT_EQ(a.subdivision.number_of_faces(), b.subdivision.number_of_faces());
  EXPECT_EQ(first.layout.seams, second.layout.seams);
  const std::size_t halfedges = s.length.size();
  const auto z = IT::corner_coordinates(a, halfedges), w = IT::corner_coordinates(b, halfedges);
  for (std::size_t h = 0; h < halfedges; ++h)
    for (std::size_t c = 0; c < 2; ++c) EXPECT_NEAR(z[h][c], w[h][c], 1e-9);
}

TEST(LayOutScaled, isProjectiveOnPiecesOfClosedSurfaces) {
  std::size_t checked = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    flat::Surface s = flat::Surface::torus(1, flat::Complex(0.3, 0.9), 2);
    s.mix(random, 20, 200);
    const Mapped m = mapped(input_of(s), Start::delaunay, with_cones);
    EXPECT_TRUE(m.layout.certificate.is_locally_injective());
    EXPECT_LE(m.layout.layout.largest_side_error, 1e-7);
    checked += expect_projective(m.layout.layout);
  }
  EXPECT_GT(checked, 100U);
}

// The octagon whose sides are glued, with more vertices.
flat::Surface genus_2(std::mt19937& random) {
  const gallery::Surface octagon = gallery::octagon_of_genus_2();
  flat::Surface s = flat::Surface::torus(1, flat::Complex(0, 1), 1);
  s.gluing = octagon.gluing;
  s.length.clear();
  for (const double x : octagon.squared_length_of_side) s.length.push_back(std::sqrt(x));
  s.mix(random, 20, 200);
  return s;
}

TEST(LayOutScaled, isProjectiveInTheDisk) {
  std::size_t checked = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const Mapped m = mapped(input_of(genus_2(random)), Start::delaunay, flat_ones, true);
    EXPECT_LE(m.layout.layout.largest_side_error, 1e-7);
    EXPECT_LE(m.layout.layout.pairings.largest_seam_error, 1e-8);
    EXPECT_LE(m.layout.layout.pairings.largest_relation_error, 1e-8);
    EXPECT_EQ(m.layout.flipped_geodesic_triangles, 0U);
    checked += expect_projective(m.layout.layout);
  }
  EXPECT_GT(checked, 100U);
}

} // namespace
