// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_EXPECT_COARSE_H
#define INTRINSIC_TRIANGULATIONS_TEST_EXPECT_COARSE_H

// What every coarse surface has to be, whichever function makes it.

#include "operator_test_meshes.h"

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_simplification/simplification/Simplification.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/points_of_rows.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace operator_test {

inline IT::Corresponding_triangulation delaunay(IT::Intrinsic_input input) {
  return IT::delaunay_triangulation(std::move(input));
}

inline IT::Corresponding_triangulation delaunay(const Shape& s) { return delaunay(s.input()); }

inline double total_curvature(const IT::Corresponding_triangulation& t) {
  double sum = 0;
  for (const auto v : vertices(t.mesh())) sum += IT::gaussian_curvature(t, v);
  return sum;
}

// The coarse surface is a surface: proper triangles, Delaunay, with the topology of the fine one,
// and each vertex has a place on it.
inline void expect_surface(const IT::Corresponding_triangulation& fine,
                           const IT::Simplification& s) {
  const IT::Corresponding_triangulation coarse(s.surface);
  EXPECT_EQ(coarse.input().report().degenerate_faces, 0U);
  EXPECT_EQ(IT::euler_characteristic(coarse.mesh()), IT::euler_characteristic(fine.mesh()));
  EXPECT_EQ(IT::boundary_loops(coarse.mesh()).size(), IT::boundary_loops(fine.mesh()).size());
  EXPECT_NEAR(total_curvature(coarse), total_curvature(fine), 1e-9);
  EXPECT_EQ(s.kept.size() + s.removed, num_vertices(fine.mesh()));
  EXPECT_EQ(num_vertices(coarse.mesh()), s.kept.size());
  EXPECT_EQ(s.places.size(), fine.number_of_vertices());
  EXPECT_EQ(s.face_stretch.size(), num_faces(coarse.mesh()));
  for (std::uint32_t c = 0; c < s.kept.size(); ++c) EXPECT_EQ(s.places[s.kept[c]].vertex, c);
  for (const IT::Place& p : s.places)
    if (!p.is_vertex()) {
      EXPECT_LT(p.face, num_faces(coarse.mesh()));
      for (const double w : p.weights) EXPECT_GE(w, 0);
      EXPECT_NEAR(p.weights[0] + p.weights[1] + p.weights[2], 1, 1e-15);
    }
  for (const auto e : edges(coarse.mesh()))
    if (!CGAL::is_border(e, coarse.mesh())) {
      EXPECT_GT(IT::cotangent_weight(coarse, e), -1e-8);
    }
}

// Exact distances from some vertices to all others that stay are within the proven bounds.
inline void expect_distances_within(const IT::Corresponding_triangulation& fine,
                                    const IT::Simplification& s) {
  const IT::Corresponding_triangulation coarse(s.surface);
  IT::Polyhedral_distance<IT::Corresponding_triangulation> on_fine(fine), on_coarse(coarse);
  for (std::uint32_t c = 0; c < s.kept.size(); c += 3) {
    on_fine.search(IT::vertex_of_row(fine, s.kept[c]));
    on_coarse.search(IT::vertex_of_row(coarse, c));
    const std::vector<double> a = on_fine.distances(), b = on_coarse.distances();
    for (std::uint32_t d = 0; d < s.kept.size(); ++d) {
      EXPECT_LE(b[d], a[s.kept[d]] * s.stretch.upper * (1 + 1e-12));
      EXPECT_GE(b[d], a[s.kept[d]] * s.stretch.lower * (1 - 1e-12));
    }
  }
}

} // namespace operator_test

#endif // INTRINSIC_TRIANGULATIONS_TEST_EXPECT_COARSE_H
