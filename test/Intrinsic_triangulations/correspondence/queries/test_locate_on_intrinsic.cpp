// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>

#include "meshes.h"
#include "subdivision_oracle.h"

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using subdivision_oracle::Exact;
using subdivision_oracle::Mover;
using subdivision_oracle::Rounded;

double error(const IT::Input& s, const meshes::Mesh& m, const IT::Surface_point& p,
             const IT::Surface_point& q) {
  return meshes::distance(meshes::position(s, m.points, p), meshes::position(s, m.points, q));
}

/// From the input to the intrinsic triangulation and back.
template <class T>
void expect_round_trips(T& t, const meshes::Mesh& mesh, double tolerance, const std::string& name) {
  const IT::Input& s = t.correspondence().input();
  Mover<T> mover(t, 9);
  for (std::uint32_t f = 0; f < s.mesh().number_of_faces(); ++f)
    for (int i = 0; i < 12; ++i) {
      IT::Surface_point p{s.halfedge_of_face(f), mover.weights(i == 0)};
      if (i >= 3) { // on a side
        const auto k = static_cast<std::size_t>(i % 3);
        p.weights[(k + 1) % 3] += p.weights[k];
        p.weights[k] = 0;
      }
      const std::optional<IT::Surface_point> q = IT::locate_on_intrinsic(t, p);
      ASSERT_TRUE(q) << name;
      const IT::Surface_point r = *IT::locate_on_input(t, *q);
      EXPECT_LE(error(s, mesh, p, r), tolerance) << name << " face " << f;
    }
}

TEST(Locate_on_intrinsic, Is_undone_by_locating_on_the_input) {
  // 1e-9 of the size of the mesh
  for (const auto& [name, mesh, size] :
       {std::tuple{"box", meshes::box(2, 2, 1), 2.}, std::tuple{"l shape", meshes::l_shape(3), 3.},
        std::tuple{"sphere", meshes::sphere(2), 2.}, std::tuple{"potato", meshes::potato(2, 2), 2.},
        std::tuple{"shear", meshes::sheared_grid(4, 4, 30), 120.},
        std::tuple{"terrain", meshes::integer_terrain(50, 64, 1), 64.}}) {
    Exact exact(subdivision_oracle::input(mesh));
    IT::flip_to_delaunay(exact);
    expect_round_trips(exact, mesh, 1e-9 * size, name);
    Rounded rounded(subdivision_oracle::input(mesh));
    IT::flip_to_delaunay(rounded);
    expect_round_trips(rounded, mesh, 1e-9 * size, name);
    Mover<Exact> mover(exact, 5);
    for (int i = 0; i < 20; ++i) mover.move(true);
    expect_round_trips(exact, mesh, 1e-9 * size, name + std::string(", after moves"));
  }
}

TEST(Locate_on_intrinsic, Is_undone_on_degenerate_faces) {
  for (const auto& [name, mesh] :
       {std::pair{"cap", meshes::with_cap(meshes::box(2, 2, 1), 3)},
        std::pair{"needle", meshes::with_needle(meshes::box(2, 2, 1), 3, 0)}}) {
    Rounded t(subdivision_oracle::input(mesh, IT::Mollification::automatic));
    IT::flip_to_delaunay(t);
    expect_round_trips(t, mesh, 1e-9, name);
  }
}

// tetrahedra that share a corner, the first one flat, so that it is flipped
TEST(Locate_on_intrinsic, Finds_curves_in_all_fans_of_a_vertex) {
  const meshes::Mesh mesh{
      {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1.5, 1.5, 0.25}, {-4, 0, 0}, {0, -4, 0}, {0, 0, -1}},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}}};
  Exact t(subdivision_oracle::input(mesh));
  EXPECT_GT(IT::flip_to_delaunay(t).flips, 0U);
  const IT::Intrinsic_view<Exact> view(t);
  const IT::Input& s = t.correspondence().input();
  for (std::uint32_t x = 0; x < s.number_of_halfedges(); ++x) {
    const auto found = IT::find_curve(view, t.correspondence(), s.source(x), x);
    ASSERT_TRUE(found) << x;
    if (found->index < 0) continue;
    EXPECT_EQ(IT::input_halfedge(t.correspondence(), *found), x);
  }
  expect_round_trips(t, mesh, 1e-14, "tetrahedra");
}

TEST(Locate_on_intrinsic, Finds_corners_and_points_on_sides_where_nothing_was_flipped) {
  const meshes::Mesh mesh = meshes::rough_grid(3, 1);
  Exact t(subdivision_oracle::input(mesh));
  const IT::Input& s = t.correspondence().input();
  const IT::Intrinsic_view<Exact> view(t);
  for (std::uint32_t f = 0; f < s.mesh().number_of_faces(); ++f)
    for (const std::array<double, 3> w : {std::array{1., 0., 0.}, std::array{0., 0.25, 0.75}}) {
      const IT::Surface_point p{s.halfedge_of_face(f), w};
      const auto q = IT::locate_on_intrinsic(t, p);
      ASSERT_TRUE(q);
      // input and intrinsic triangulation have the same numbers
      EXPECT_LE(error(s, mesh, p, *q), 1e-14);
    }
}

} // namespace
