// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>

#include "meshes.h"
#include "subdivision_oracle.h"

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using subdivision_oracle::Exact;
using subdivision_oracle::Mover;
using subdivision_oracle::Plane;
using subdivision_oracle::Rounded;

/// Largest distance between points of intrinsic faces and their images on the input.
template <class T>
double greatest_error(Plane<T>& p, Mover<T>& mover, int count, bool on_side) {
  double worst = 0;
  const IT::Input& s = p.t.correspondence().input();
  for (int i = 0; i < count; ++i) {
    const std::uint32_t h = mover.halfedge(false);
    const std::array<double, 3> w = *IT::representable_weights(mover.weights(on_side));
    const auto expected = p.at(h, w);
    const IT::Surface_point q = *IT::locate_on_input(p.t, {h, w});
    EXPECT_FALSE(s.is_border(q.halfedge));
    double sum = 0;
    std::array<double, 2> x{0, 0};
    std::uint32_t k = q.halfedge;
    for (const double y : q.weights) {
      EXPECT_GE(y, 0);
      sum += y;
      for (std::size_t c = 0; c < 2; ++c) x[c] += y * CGAL::to_double(p.position[s.source(k)][c]);
      k = s.next(k);
    }
    EXPECT_NEAR(sum, 1, 1e-15);
    worst = std::max(worst, std::hypot(x[0] - CGAL::to_double(expected[0]),
                                       x[1] - CGAL::to_double(expected[1])));
  }
  return worst;
}

template <class T>
void expect_positions(const meshes::Mesh& mesh, bool delaunay, double tolerance,
                      const std::string& name) {
  Plane<T> p(mesh);
  Mover<T> mover(p.t, 1);
  if (delaunay)
    IT::flip_to_delaunay(p.t);
  else
    for (int i = 0; i < 100; ++i) p.t.flip_edge({mover.halfedge(false)});
  EXPECT_LE(greatest_error(p, mover, 300, false), tolerance) << name;
  EXPECT_LE(greatest_error(p, mover, 300, true), tolerance) << name;
}

TEST(Locate_on_input, Finds_points_of_the_plane) {
  // 1e-9 of the size of the mesh
  for (const auto& [name, mesh, size] :
       {std::tuple{"grid", meshes::grid(4, 4), 4.},
        std::tuple{"shear", meshes::sheared_grid(4, 4, 20), 84.},
        std::tuple{"parabola", meshes::parabola_fan(12), 144.},
        std::tuple{"random", meshes::random_planar(40, 1024, 3), 1024.}}) {
    expect_positions<Exact>(mesh, true, 1e-9 * size, name);
    expect_positions<Rounded>(mesh, true, 1e-9 * size, name);
    expect_positions<Exact>(mesh, false, 1e-9 * size, name);
  }
}

TEST(Locate_on_input, Finds_inserted_vertices_whatever_moves_follow) {
  for (const auto& [name, mesh] : {std::pair{"random", meshes::random_planar(15, 64, 1)},
                                   std::pair{"grid", meshes::grid(3, 3)}}) {
    Plane<Exact> p(mesh);
    Mover<Exact> mover(p.t, 2);
    for (int i = 0; i < 150; ++i)
      mover.move(
          true, [&](std::uint32_t h, const auto& w) { return p.insert(h, w); },
          [&](IT::Gluing_map::Vertex v, std::uint32_t h, const auto& w) {
            return p.reposition(v, h, w);
          });
    const IT::Input& s = p.t.correspondence().input();
    for (const auto v : mover.inserted) {
      const IT::Surface_point& q = p.t.correspondence().location(p.t.index(v));
      std::array<double, 2> x{0, 0};
      std::uint32_t k = q.halfedge;
      for (const double y : q.weights) {
        for (std::size_t c = 0; c < 2; ++c) x[c] += y * CGAL::to_double(p.position[s.source(k)][c]);
        k = s.next(k);
      }
      for (std::size_t c = 0; c < 2; ++c)
        EXPECT_NEAR(x[c], CGAL::to_double(p.position[p.t.index(v)][c]), 1e-9) << name;
    }
  }
}

} // namespace
