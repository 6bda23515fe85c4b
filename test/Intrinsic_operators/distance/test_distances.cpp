// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/distance/Distances.h>
#include <CGAL/Intrinsic_operators/distance/divide_among.h>

#include "operator_test_meshes.h"

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <vector>

// Oracle: distances in a square are those in the plane.

namespace {

using namespace operator_test;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using IT::Place;

// A square with vertices inside moved at random, and places in it.
struct Square {
  static constexpr std::uint32_t n = 6;
  Shape shape = grid(n);
  std::mt19937 random;

  explicit Square(unsigned seed) : random(seed) {
    std::uniform_real_distribution<double> d(-.3, .3);
    for (auto& [x, y, z] : shape.points)
      if (x > 0 && x < n && y > 0 && y < n) x += d(random), y += d(random);
  }
  Triangulation triangulation() const {
    Triangulation t(shape.input());
    IT::flip_to_delaunay(t);
    return t;
  }
  // a vertex, a point inside of a face, or one on an edge
  Place place() {
    if (random() % 3 == 0)
      return Place::at_vertex(static_cast<std::uint32_t>(random() % shape.points.size()));
    std::uniform_real_distribution<double> d(.1, 1);
    std::array<double, 3> w{d(random), d(random), random() % 3 == 0 ? 0 : d(random)};
    const double sum = w[0] + w[1] + w[2];
    for (double& x : w) x /= sum;
    return Place::in_face(static_cast<std::uint32_t>(random() % shape.triangles.size()), w);
  }
  std::vector<Place> places(std::size_t number) {
    std::vector<Place> result;
    while (result.size() < number) result.push_back(place());
    return result;
  }
  Eigen::Vector3d point(const Place& p) const {
    if (p.is_vertex()) return shape.point(p.vertex);
    Eigen::Vector3d sum(0, 0, 0);
    for (std::size_t k = 0; k < 3; ++k)
      sum += p.weights[k] * shape.point(shape.triangles[p.face][k]);
    return sum;
  }
  double distance(const Place& p, const std::vector<Place>& sources) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Place& q : sources) least = std::min(least, (point(p) - point(q)).norm());
    return least;
  }
};

// exact: of rounding; by heat: the error of the method on edges of length 1
double tolerance(IT::Distance_method method) {
  return method == IT::Distance_method::exact ? 1e-9 : 1;
}

TEST(Distances, are_those_in_the_plane_for_both_methods) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Square s(seed);
    const Triangulation t = s.triangulation();
    const std::vector<Place> sources = s.places(1 + seed % 3), targets = s.places(10);
    IT::Distances<Triangulation> find(t);
    for (const IT::Distance_method method :
         {IT::Distance_method::exact, IT::Distance_method::heat}) {
      IT::Distance_options options;
      options.method = method;
      const IT::Found_distances all = find.from(sources, options),
                                some = IT::distances(t, sources, options, targets);
      EXPECT_EQ(all.status, IT::Status::done);
      for (std::uint32_t v = 0; v < s.shape.points.size(); ++v)
        EXPECT_NEAR(all.by_row[v], s.distance(Place::at_vertex(v), sources), tolerance(method))
            << "seed " << seed << ", vertex " << v;
      for (std::size_t i = 0; i < targets.size(); ++i)
        EXPECT_NEAR(some.at_targets[i], s.distance(targets[i], sources), tolerance(method))
            << "seed " << seed << ", target " << i;
    }
  }
}

TEST(Distances, of_columns_and_pairs_are_those_of_single_calls) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Square s(seed);
    const Triangulation t = s.triangulation();
    const std::size_t n = t.number_of_vertices();
    std::vector<std::vector<Place>> sets;
    for (std::size_t i = 0; i < 7; ++i) sets.push_back(s.places(1 + i % 3));
    std::vector<Place> first = s.places(10), second = s.places(20);
    first.insert(first.end(), first.begin(), first.begin() + 10); // share a search
    for (const IT::Distance_method method :
         {IT::Distance_method::exact, IT::Distance_method::heat}) {
      IT::Distance_options options;
      options.method = method;
      IT::Distances<Triangulation> find(t);
      std::vector<double> wide(n * sets.size());
      std::vector<float> narrow(n * sets.size());
      find.columns(sets, std::span(wide), options);
      find.columns(sets, std::span(narrow), options);
      std::size_t next = 0;
      find.for_each_column(
          sets,
          [&](std::size_t i, std::span<const double> column) {
            EXPECT_EQ(i, next++);
            const std::vector<double> expected = find.from(sets[i], options).by_row;
            for (std::size_t v = 0; v < n; ++v) {
              EXPECT_DOUBLE_EQ(column[v], expected[v]);
              EXPECT_DOUBLE_EQ(wide[i * n + v], expected[v]);
              EXPECT_EQ(narrow[i * n + v], static_cast<float>(wide[i * n + v]));
            }
          },
          options);
      EXPECT_EQ(next, sets.size());
      const std::vector<double> pairs = find.of_pairs(first, second, options);
      for (std::size_t i = 0; i < pairs.size(); ++i)
        EXPECT_NEAR(pairs[i], find.from({first[i]}, options, {second[i]}).at_targets[0], 1e-12);
    }
  }
}

TEST(divide_among, gives_each_vertex_of_a_square_to_the_nearest_set) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    Square q(seed);
    const Triangulation t = q.triangulation();
    const std::vector<std::vector<Place>> sets{q.places(2), q.places(1), q.places(3)};
    IT::Distances<Triangulation> find(t);
    const IT::Found_cells found = IT::divide_among(find, sets);
    for (std::uint32_t v = 0; v < q.shape.points.size(); ++v) {
      const Place p = Place::at_vertex(v);
      const double least =
          std::min({q.distance(p, sets[0]), q.distance(p, sets[1]), q.distance(p, sets[2])});
      EXPECT_NEAR(found.by_row[v], least, 1e-12);
      ASSERT_TRUE(found.nearest[v] >= 0 && found.nearest[v] < 3);
      EXPECT_NEAR(q.distance(p, sets[static_cast<std::size_t>(found.nearest[v])]), least, 1e-12);
    }
    double area = 0;
    std::size_t vertices = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      area += found.cells.areas[k];
      vertices += found.vertices[k];
    }
    EXPECT_NEAR(area, 36, 1e-9);
    EXPECT_EQ(vertices, q.shape.points.size());
  }
}

TEST(divide_among, leaves_the_cells_of_empty_sets_empty) {
  Square q(1);
  const Triangulation t = q.triangulation();
  IT::Distances<Triangulation> find(t);
  const IT::Found_cells found = IT::divide_among(find, {{}, q.places(1), {}});
  ASSERT_EQ(found.cells.areas.size(), 3U);
  EXPECT_EQ(found.cells.areas[0], 0);
  EXPECT_NEAR(found.cells.areas[1], 36, 1e-9);
  EXPECT_EQ(found.cells.areas[2], 0);
  EXPECT_EQ(found.vertices, (std::vector<std::size_t>{0, q.shape.points.size(), 0}));
}

TEST(divide_among, says_that_it_was_cancelled) {
  Square q(1);
  const Triangulation t = q.triangulation();
  IT::Distances<Triangulation> find(t);
  IT::Distance_options options;
  options.progress = [](IT::Distance_step step, std::uint64_t, std::uint64_t) {
    return step != IT::Distance_step::cells;
  };
  const IT::Found_cells found = IT::divide_among(find, {q.places(2)}, {}, options);
  EXPECT_EQ(found.status, IT::Status::cancelled);
  EXPECT_EQ(found.cells.status, IT::Status::cancelled);
  EXPECT_TRUE(found.cells.areas.empty());
}

TEST(Distances, end_where_asked) {
  Square s(1);
  const Triangulation t = s.triangulation();
  IT::Distances<Triangulation> find(t);
  IT::Distance_options options;
  options.maximum_distance = 2;
  const IT::Found_distances found = find.from({Place::at_vertex(0)}, options);
  EXPECT_GE(found.reached, 2);
  EXPECT_TRUE(std::isinf(found.by_row.back()));
  for (const IT::Distance_method method : {IT::Distance_method::exact, IT::Distance_method::heat}) {
    options = {};
    options.method = method;
    options.progress = [](IT::Distance_step, std::uint64_t, std::uint64_t) { return false; };
    const std::vector<std::vector<Place>> sets(100, {Place::at_vertex(0)});
    std::vector<double> out(sets.size() * t.number_of_vertices());
    EXPECT_EQ(find.columns(sets, std::span(out), options), IT::Status::cancelled);
    options.progress = {};
    EXPECT_EQ(find.from({Place::at_vertex(0)}, options).status, IT::Status::done);
  }
}

TEST(Distances, refuse_what_they_cannot_use) {
  Square s(1);
  const Triangulation t = s.triangulation();
  IT::Distances<Triangulation> find(t);
  EXPECT_THROW(find.from({}), IT::Invalid_input);
  EXPECT_THROW(find.from({Place::at_vertex(1000)}), IT::Invalid_input);
  EXPECT_THROW(find.of_pairs({Place::at_vertex(0)}, {}), IT::Invalid_input);
}

} // namespace
