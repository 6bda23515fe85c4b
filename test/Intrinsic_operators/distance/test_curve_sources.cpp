// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "planar_bezier.h"

#include <CGAL/Intrinsic_operators/distance/curve_sources.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

// Curves over the mesh as pieces in faces of the triangulation. Oracle: where both are in space.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;

TEST(CurveSources, are_the_pieces_of_a_curve_through_faces) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const meshes::Mesh m = planar_bezier::random_square(20 + seed, random);
    Triangulation t(m.input());
    IT::flip_to_delaunay(t);
    const auto f = static_cast<std::uint32_t>(random() % m.triangles.size());
    // from a corner into the face, and to another corner
    const std::vector<IT::Place> places{IT::Place::at_vertex(m.triangles[f][0]),
                                        IT::Place::in_face(f, {0.25, 0.5, 0.25}),
                                        IT::Place::at_vertex(m.triangles[f][2])};
    const IT::Traced_curve curve = IT::curve_through(t, places);
    ASSERT_EQ(curve.faces.size(), 2U);
    double expected = 0, found = 0;
    for (std::size_t i = 0; i < 2; ++i)
      expected += planar_bezier::distance(IT::point_in_space(t, curve.points[i], m.points),
                                          IT::point_in_space(t, curve.points[i + 1], m.points));
    for (const IT::Polyline_source& piece : IT::polyline_sources(t, curve))
      for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
        const auto p = IT::locate_on_input(t, piece.points[i]),
                   q = IT::locate_on_input(t, piece.points[i + 1]);
        ASSERT_TRUE(p && q);
        found += planar_bezier::distance(IT::point_in_space(t, *p, m.points),
                                         IT::point_in_space(t, *q, m.points));
      }
    EXPECT_NEAR(found, expected, 1e-9);
  }
}

TEST(CurveSources, need_a_face_with_both_places) {
  std::mt19937 random(5);
  const meshes::Mesh m = planar_bezier::random_square(40, random);
  const Triangulation t(m.input());
  std::size_t apart = 0;
  for (std::uint32_t v = 1; v < m.points.size(); ++v) {
    bool is_beside = false;
    for (const auto& [a, b, c] : m.triangles)
      is_beside = is_beside || ((a == 0 || b == 0 || c == 0) && (a == v || b == v || c == v));
    const std::vector<IT::Place> places{IT::Place::at_vertex(0), IT::Place::at_vertex(v)};
    if (is_beside) {
      EXPECT_EQ(IT::curve_through(t, places).points.size(), 2U);
    } else {
      ++apart;
      EXPECT_THROW(IT::curve_through(t, places), IT::Invalid_input);
    }
  }
  EXPECT_GT(apart, 5U);
}

} // namespace
