// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "planar_bezier.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Tangents_at_places.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

// Vectors at places of a user. Oracle: in a square, a line goes on along the vector in space.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Vector = std::array<double, 3>;

/// How far a line along a vector stays in the unit square.
double way_in_square(const Vector& from, const Vector& v) {
  double least = 1;
  for (std::size_t i = 0; i < 2; ++i) {
    if (v[i] > 0) least = std::min(least, (1 - from[i]) / v[i]);
    if (v[i] < 0) least = std::min(least, -from[i] / v[i]);
  }
  return least;
}

TEST(TangentsAtPlaces, lead_along_vectors_in_space) {
  std::size_t checked = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const meshes::Mesh m = planar_bezier::random_square(10 + seed, random);
    Triangulation t(m.input());
    IT::flip_to_delaunay(t);
    IT::Tangents_at_places<Triangulation> tangent(t, m.points);
    for (int trial = 0; trial < 10; ++trial) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(random()) / 0x1p32;
      const Vector v{std::cos(angle), std::sin(angle), 0};
      IT::Place place =
          IT::Place::at_vertex(static_cast<std::uint32_t>(random() % m.points.size()));
      Vector from = m.points[place.vertex];
      if (trial % 2 == 0) {
        const auto f = static_cast<std::uint32_t>(random() % m.triangles.size());
        // every other one on an edge
        place =
            IT::Place::in_face(f, {0.25, trial % 4 == 0 ? 0 : 0.25, trial % 4 == 0 ? 0.75 : 0.5});
        from = {0, 0, 0};
        for (std::size_t k = 0; k < 3; ++k)
          for (std::size_t i = 0; i < 3; ++i)
            from[i] += place.weights[k] * m.points[m.triangles[f][k]][i];
      }
      place = normalized(t.input(), place);
      const double length = 0.9 * way_in_square(from, v);
      if (!(length > 1e-3)) continue; // out of the square
      ++checked;
      const Vector end{from[0] + length * v[0], from[1] + length * v[1], 0};
      const IT::Tangent_vector on_input = tangent.on_input(place, v);
      const IT::Geodesic a =
          IT::trace_geodesic_on_input(t, on_input.point, on_input.vector, length);
      EXPECT_LT(planar_bezier::distance(IT::point_in_space(t, a.points.back(), m.points), end),
                1e-8);
      const IT::Tangent_vector here = tangent(place, v);
      const IT::Geodesic b = IT::trace_geodesic(t, here.point, here.vector, length);
      const auto there = IT::locate_on_input(t, b.points.back());
      ASSERT_TRUE(there);
      EXPECT_LT(planar_bezier::distance(IT::point_in_space(t, *there, m.points), end), 1e-8);
    }
  }
  EXPECT_GT(checked, 100U);
}

TEST(TangentsAtPlaces, keep_the_length_of_vectors_and_complex_numbers_turn_with_the_frame) {
  std::mt19937 random(3);
  const meshes::Mesh m = planar_bezier::random_square(30, random);
  Triangulation t(m.input());
  IT::Tangents_at_places<Triangulation> tangent(t, m.points);
  for (std::uint32_t f = 0; f < m.triangles.size(); ++f) {
    const IT::Place p = IT::Place::in_face(f, {0.25, 0.25, 0.5});
    const auto& [a, b, c] = m.triangles[f];
    const Vector side{m.points[b][0] - m.points[a][0], m.points[b][1] - m.points[a][1], 0};
    const double length = std::hypot(side[0], side[1]);
    // the first side of a face is its real axis
    const IT::Tangent_vector along = tangent.on_input(p, std::complex<double>(length, 0)),
                             in_space = tangent.on_input(p, side);
    EXPECT_NEAR(std::hypot(in_space.vector[0], in_space.vector[1]), length, 1e-12);
    EXPECT_EQ(along.point.halfedge, in_space.point.halfedge);
    EXPECT_NEAR(along.vector[0], in_space.vector[0], 1e-12);
    EXPECT_NEAR(along.vector[1], in_space.vector[1], 1e-12);
  }
}

TEST(TangentsAtPlaces, are_refused_without_points_and_if_they_are_not_finite) {
  std::mt19937 random(1);
  const meshes::Mesh m = planar_bezier::random_square(8, random);
  const Triangulation t(m.input());
  const std::vector<Vector> none;
  IT::Tangents_at_places<Triangulation> abstract(t, none), in_space(t, m.points);
  const IT::Place p = IT::Place::at_vertex(0);
  EXPECT_THROW(abstract.on_input(p, Vector{1, 0, 0}), IT::Invalid_input);
  EXPECT_NO_THROW(abstract.on_input(p, std::complex<double>(1, 0)));
  EXPECT_THROW(in_space.on_input(p, Vector{std::nan(""), 0, 0}), IT::Invalid_input);
}

} // namespace
