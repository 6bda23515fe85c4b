// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/parametrization/map_to_plane.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// Maps of what a user asks for, with what is known of them.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                          IT::Integer_coordinates>;
using Points = std::vector<std::array<double, 3>>;

// An L of three squares: harmonic maps of it to a disk turn a face over, unless edges are flipped.
const Points corners{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0},
                     {1, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}};
Exact l_shape() {
  const std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 4}, {0, 4, 3}, {1, 2, 4},
                                                        {2, 5, 4}, {3, 4, 7}, {3, 7, 6}};
  return Exact{IT::Intrinsic_input(IT::Gluing_map(IT::gluing_from_triangles(8U, faces)), corners)};
}

TEST(MapToPlane, IsMeasuredAndCertifiedByEachMethod) {
  for (const auto method :
       {IT::Map_method::harmonic, IT::Map_method::least_squares, IT::Map_method::spectral}) {
    Exact t = l_shape();
    IT::Map_options options;
    options.method = method;
    const IT::Map_to_plane map = IT::map_to_plane(t, corners, options);
    EXPECT_EQ(map.status, IT::Status::done);
    ASSERT_TRUE(map.has_faces());
    EXPECT_TRUE(map.certificate.is_injective());
    EXPECT_EQ(map.certificate.faces, num_faces(t.mesh()));
    EXPECT_GE(map.distortion->mean_quasi_conformal, 1);
    if (method != IT::Map_method::harmonic) { // flat surfaces keep their shape
      EXPECT_NEAR(map.distortion->maximum_quasi_conformal, 1, 1e-6);
      EXPECT_TRUE(map.is_injective_on_input.value());
    }
  }
}

TEST(MapToPlane, KeepsEdgesOnRequest) {
  Exact t = l_shape();
  IT::Map_options options;
  options.keeps_edges = true;
  const IT::Map_to_plane map = IT::map_to_plane(t, corners, options);
  EXPECT_EQ(map.inserted, 0U);
  EXPECT_EQ(t.number_of_vertices(), corners.size());
  EXPECT_EQ(map.certificate.is_injective(), map.is_injective_on_input.value());
}

TEST(MapToPlane, AsksWhetherToGoOn) {
  Exact t = l_shape();
  IT::Map_options options;
  options.progress = [](std::uint64_t) { return false; };
  for (const auto method :
       {IT::Map_method::harmonic, IT::Map_method::least_squares, IT::Map_method::spectral}) {
    options.method = method;
    EXPECT_EQ(IT::map_to_plane(t, corners, options).status, IT::Status::cancelled);
  }
  options.method = IT::Map_method::harmonic;
  options.keeps_edges = true;
  for (const std::uint64_t last : {0U, 1U}) {
    std::vector<std::uint64_t> asked;
    options.progress = [&](std::uint64_t n) {
      asked.push_back(n);
      return n < last;
    };
    EXPECT_EQ(IT::map_to_plane(t, corners, options).status, IT::Status::cancelled);
    EXPECT_EQ(asked.back(), last);
  }
}

TEST(MapToPlane, OfACloudHasNoFaces) {
  Points points;
  for (std::size_t i = 0; i < 36; ++i)
    points.push_back({double(i / 6) + 0.1 * double(i % 2), double(i % 6), 0});
  Exact t(IT::make_point_cloud(points, 8).input);
  IT::Map_options options;
  EXPECT_THROW(IT::map_to_plane(t, points, options), IT::Invalid_input);
  options.method = IT::Map_method::spectral;
  const IT::Map_to_plane map = IT::map_to_plane(t, points, options);
  EXPECT_FALSE(map.has_faces());
  EXPECT_FALSE(map.is_injective_on_input.has_value());
  ASSERT_EQ(map.uv.rows(), 36);
  EXPECT_NEAR((map.uv.row(0) - map.uv.row(30)).norm(), 5, 1e-6); // flat points are only turned
}

} // namespace
