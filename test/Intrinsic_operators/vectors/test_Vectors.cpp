// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/vectors/Vectors.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/vector_field.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "delaunay.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

// Vectors from places that a user names, on a flat square, where all of them are known.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                          IT::Integer_coordinates>;
using Point = std::array<double, 3>;
constexpr double rounding = 1e-9; // of solutions, relative to the size 1 of the square

// A square of n times n smaller ones in the plane z = 0.
struct Square {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> faces;

  explicit Square(std::uint32_t n) {
    for (std::uint32_t i = 0; i <= n; ++i)
      for (std::uint32_t j = 0; j <= n; ++j)
        points.push_back({double(i) / n + 0.01 * (j % 2), double(j) / n, 0});
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
        faces.push_back({a, b, b + 1});
        faces.push_back({a, b + 1, a + 1});
      }
  }
  Exact triangulation() const {
    const IT::Gluing gluing =
        IT::gluing_from_triangles(static_cast<std::uint32_t>(points.size()), faces);
    Exact t{IT::Intrinsic_input(IT::Gluing_map(gluing), points)};
    IT::flip_to_delaunay(t);
    return t;
  }
};

// What has no name would end before the object that keeps a reference to it.
template <class... Arguments>
constexpr bool makes_vectors = std::constructible_from<IT::Vectors<Exact>, Arguments...>;
static_assert(makes_vectors<const Exact&, const std::vector<Point>&>);
static_assert(!makes_vectors<const Exact&, std::vector<Point>>);
static_assert(!makes_vectors<Exact, const std::vector<Point>&>);
static_assert(!std::constructible_from<IT::Vector_heat_method<Exact>, Exact>);

TEST(Vectors, AreTransportedByTheIdentityInThePlane) {
  const Square square(6);
  const Exact t = square.triangulation();
  IT::Vectors<Exact> find(t, square.points);
  const Point along_x{1, 0, 0};
  const auto found = find.transport({{IT::Place::at_vertex(24)}, {}, {along_x}});
  const auto in_space = IT::vectors_in_space(t, found.vectors, square.points);
  for (const std::uint32_t i : found.of_row) {
    EXPECT_NEAR(in_space[i][0], 1, rounding);
    EXPECT_NEAR(in_space[i][1], 0, rounding);
  }
}

TEST(Vectors, LogarithmsAreAsLongAsTheDistance) {
  const Square square(6);
  const Exact t = square.triangulation();
  IT::Vectors<Exact> find(t, square.points);
  const std::uint32_t from = 24;
  const auto found = find.logarithms(IT::Place::at_vertex(from), IT::Logarithm_method::exact);
  for (std::size_t r = 0; r < square.points.size(); ++r)
    EXPECT_NEAR(std::abs(found.vectors[found.of_row[r]]),
                std::hypot(square.points[r][0] - square.points[from][0],
                           square.points[r][1] - square.points[from][1]),
                rounding);
}

TEST(Vectors, ValuesStayBetweenThoseGiven) {
  const Square square(6);
  const Exact t = square.triangulation();
  IT::Vectors<Exact> find(t, square.points);
  const std::vector<double> values =
      find.extend({IT::Place::at_vertex(0), IT::Place::at_vertex(48)}, {2, 5});
  EXPECT_NEAR(values[0], 2, 0.1); // smoothed near the source
  for (const double x : values) {
    EXPECT_GE(x, 2 - rounding);
    EXPECT_LE(x, 5 + rounding);
  }
}

TEST(Vectors, IndicesOfDirectionsHaveTheSumOfTheSurface) {
  const std::vector<Point> points{{1, 0, 0},  {0, 1.1, 0}, {-1.2, 0, 0},
                                  {0, -1, 0}, {0, 0, 1.3}, {0, 0, -1}};
  const std::vector<std::array<std::uint32_t, 3>> octahedron{
      {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}};
  Exact t{IT::Intrinsic_input(IT::Gluing_map(IT::gluing_from_triangles(6U, octahedron)), points)};
  IT::flip_to_delaunay(t);
  IT::Vectors<Exact> find(t, points);
  const auto found = find.directions(4);
  ASSERT_FALSE(found.centres.empty());
  int sum = 0; // with exact arithmetic, the centre of each singular face is found on the input
  for (const auto& [p, index] : found.centres) sum += index;
  EXPECT_EQ(found.index_sum, sum);
  EXPECT_EQ(found.index_sum, 4 * 2); // degree times the Euler characteristic
}

TEST(Vectors, OfACloudLieInItsTangentPlanes) {
  const Square square(6);
  IT::Point_cloud cloud = IT::make_point_cloud(square.points, 8);
  const Exact t(std::move(cloud.input));
  IT::Vectors<Exact> find(t, square.points);
  ASSERT_TRUE(find.is_cloud());
  const auto found = find.transport({{IT::Place::at_vertex(24)}, {}, {{1, 0, 0}}});
  for (std::size_t r = 0; r < square.points.size(); ++r) {
    ASSERT_EQ(found.of_row[r], r);
    const Point v = find.cloud(30).in_space(r, found.vectors[r]);
    EXPECT_NEAR(v[0], 1, 0.05); // the connection of a cloud is approximate
    EXPECT_NEAR(v[2], 0, rounding);
  }
  EXPECT_THROW(find.transport({{IT::Place::in_face(0, {1, 0, 0})}, {1.}}), IT::Invalid_input);
  EXPECT_EQ(find.usual_method(), IT::Logarithm_method::affine);
  EXPECT_THROW(find.logarithms(IT::Place::at_vertex(24), IT::Logarithm_method::exact),
               IT::Invalid_input);
  EXPECT_THROW(find.directions(4, 1.), IT::Invalid_input);
}

TEST(Vectors, FollowCurvatureOnlyWhereThereIsSome) {
  const Square square(6);
  const Exact t = square.triangulation();
  IT::Vectors<Exact> find(t, square.points);
  EXPECT_EQ(find.usual_method(), IT::Logarithm_method::exact);
  EXPECT_EQ(find.directions(4, 1.).status, IT::Status::done);
  EXPECT_THROW(find.directions(3, 1.), IT::Invalid_input); // it has no sign
  const std::vector<Point> none;
  EXPECT_THROW(IT::Vectors<Exact>(t, none).directions(4, 1.), IT::Invalid_input);
}

TEST(Vectors, RefuseOptionsThatTheMethodHasNoUseFor) {
  const Square square(6);
  const Exact t = square.triangulation();
  IT::Vectors<Exact> find(t, square.points);
  const IT::Place middle = IT::Place::at_vertex(24);
  IT::Vector_options slow, near;
  slow.time_factor = 2;
  near.maximum_distance = 0.5;
  EXPECT_THROW(find.logarithms(middle, IT::Logarithm_method::exact, slow), IT::Invalid_input);
  EXPECT_THROW(find.logarithms(middle, IT::Logarithm_method::affine, near), IT::Invalid_input);
  EXPECT_EQ(find.logarithms(middle, IT::Logarithm_method::exact, near).status, IT::Status::done);
  EXPECT_EQ(find.logarithms(middle, IT::Logarithm_method::affine, slow).status, IT::Status::done);
}

TEST(Vectors, EndWithoutAResultWhenTheCallerSaysSo) {
  const Square square(6);
  const Exact t = square.triangulation();
  IT::Vectors<Exact> find(t, square.points);
  IT::Vector_options options;
  options.progress = [](IT::Vector_step, std::uint64_t) { return false; };
  const IT::Given_vectors given{{IT::Place::at_vertex(24)}, {1.}};
  EXPECT_EQ(find.transport(given, options).status, IT::Status::cancelled);
  EXPECT_EQ(find.directions(4, {}, {}, options).status, IT::Status::cancelled);
  EXPECT_EQ(find.logarithms(given.places[0], IT::Logarithm_method::affine, options).status,
            IT::Status::cancelled);
  EXPECT_TRUE(find.extend(given.places, {1}, options).empty());
  EXPECT_EQ(find.transport(given).status, IT::Status::done); // the next call is not affected
}

} // namespace
