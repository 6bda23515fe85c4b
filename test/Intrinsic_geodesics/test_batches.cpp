// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/batches.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>

#include "gallery.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <thread>
#include <vector>

// Oracles: `Polyhedral_distance` for one set, and a flat torus, where distances are those of the plane.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
namespace parameters = IT::parameters;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Vertex = Triangulation::vertex_descriptor;

constexpr double infinity = std::numeric_limits<double>::infinity();

Triangulation flat_torus(std::uint32_t n) {
  const gallery::Surface s = gallery::flat_torus(n, n);
  return Triangulation(gallery::input(s));
}

std::vector<std::vector<Vertex>> sets_of(const Triangulation& t, std::size_t number) {
  std::vector<Vertex> all(vertices(t.mesh()).begin(), vertices(t.mesh()).end());
  std::vector<std::vector<Vertex>> result(number);
  for (std::size_t i = 0; i < number; ++i)
    for (std::size_t k = 0; k <= i % 3; ++k)
      result[i].push_back(all[(7 * i + 11 * k) % all.size()]);
  return result;
}

TEST(Batches_of_distances, columns_are_those_of_single_searches_in_any_number_of_threads) {
  const Triangulation t = flat_torus(9);
  const auto sets = sets_of(t, 20);
  const std::size_t n = t.number_of_vertices();
  for (const std::size_t threads : {0, 1, 2, 5}) {
    std::vector<double> out(n * sets.size(), -1);
    std::vector<float> single(n * sets.size(), -1);
    EXPECT_EQ(
        IT::polyhedral_distances(t, sets, std::span(out), parameters::number_of_threads(threads)),
        IT::Status::done);
    EXPECT_EQ(IT::polyhedral_distances(t, sets, std::span(single)), IT::Status::done);
    for (std::size_t i = 0; i < sets.size(); ++i) {
      const std::vector<double> expected = IT::Polyhedral_distance(t, sets[i]).distances();
      for (std::size_t v = 0; v < n; ++v) {
        EXPECT_EQ(out[i * n + v], expected[v]);
        EXPECT_EQ(single[i * n + v], static_cast<float>(expected[v]));
      }
    }
  }
}

TEST(Batches_of_distances, limits_hold_for_each_set) {
  const Triangulation t = flat_torus(8);
  const auto sets = sets_of(t, 3);
  std::vector<double> near(t.number_of_vertices() * 3), all(near.size()), few(near.size());
  IT::polyhedral_distances(t, sets, std::span(all));
  const double radius = *std::ranges::max_element(all) / 3;
  IT::polyhedral_distances(t, sets, std::span(near), parameters::maximum_distance(radius));
  EXPECT_EQ(IT::polyhedral_distances(t, sets, std::span(few), parameters::maximum_number(2)),
            IT::Status::cap);
  bool is_cut = false;
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(near[i], all[i] <= radius ? all[i] : infinity);
    is_cut = is_cut || near[i] == infinity;
  }
  EXPECT_TRUE(is_cut);
}

TEST(Batches_of_distances, a_visitor_sees_progress_and_ends_the_batch) {
  struct Visitor {
    std::vector<std::size_t> seen;
    std::size_t last;
    bool progress(std::size_t done, std::size_t all) {
      EXPECT_EQ(all, 20U);
      seen.push_back(done);
      return done < last;
    }
  };
  const Triangulation t = flat_torus(6);
  const auto sets = sets_of(t, 20);
  std::vector<double> out(t.number_of_vertices() * sets.size(), -1);
  Visitor patient{{}, 100}, hasty{{}, 3};
  // one thread: others could be done with all sets before the visitor is asked
  EXPECT_EQ(IT::polyhedral_distances(t, sets, std::span(out),
                                     parameters::number_of_threads(1).visitor(std::ref(hasty))),
            IT::Status::cancelled);
  EXPECT_EQ(hasty.seen, (std::vector<std::size_t>{1, 2, 3}));
  EXPECT_EQ(out.back(), -1); // not reached
  EXPECT_EQ(
      IT::polyhedral_distances(t, sets, std::span(out), parameters::visitor(std::ref(patient))),
      IT::Status::done);
  EXPECT_EQ(patient.seen.size(), 20U);
}

TEST(Batches_of_distances, a_visitor_is_called_in_the_thread_of_the_caller_for_every_part) {
  struct Visitor {
    std::thread::id caller = std::this_thread::get_id();
    std::size_t seen = 0;
    bool progress(std::size_t done, std::size_t) {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      EXPECT_EQ(done, ++seen);
      return true;
    }
  };
  const Triangulation t = flat_torus(9);
  const auto sets = sets_of(t, 40);
  std::vector<double> out(t.number_of_vertices() * sets.size());
  for (const std::size_t threads : {1, 2, 3, 8}) {
    Visitor visitor;
    IT::polyhedral_distances(t, sets, std::span(out),
                             parameters::number_of_threads(threads).visitor(std::ref(visitor)));
    EXPECT_EQ(visitor.seen, sets.size());
  }
}

TEST(Batches_of_distances, errors_of_the_caller_are_thrown) {
  const Triangulation t = flat_torus(4);
  const auto sets = sets_of(t, 3);
  std::vector<double> small(t.number_of_vertices() * 3 - 1);
  EXPECT_THROW(IT::polyhedral_distances(t, sets, std::span(small)), std::invalid_argument);
  EXPECT_THROW(IT::pair_distances(t, {sets[0][0]}, {}), std::invalid_argument);
  struct Thrower {
    bool progress(std::size_t, std::size_t) { throw std::runtime_error("from the visitor"); }
  };
  std::vector<double> out(t.number_of_vertices() * 3);
  EXPECT_THROW(IT::polyhedral_distances(t, sets, std::span(out), parameters::visitor(Thrower())),
               std::runtime_error);
  EXPECT_EQ(IT::polyhedral_distances(t, std::vector<Vertex>(), std::span<double>()),
            IT::Status::done);
}

// On a flat torus distances are those in the plane to the nearest copy.
TEST(Pair_distances, are_those_of_the_plane_on_a_flat_torus) {
  constexpr std::uint32_t n = 8;
  const Triangulation t = flat_torus(n);
  const gallery::Surface s = gallery::flat_torus(n, n);
  const std::vector<Vertex> all(vertices(t.mesh()).begin(), vertices(t.mesh()).end());
  // corner 6 (i + n j) is at the lattice point (i, j)
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
    return all[s.gluing.origin[6 * (i + n * j)]];
  };
  std::vector<Vertex> from, to;
  std::vector<double> expected;
  for (std::uint32_t k = 0; k < 60; ++k) {
    const std::uint32_t i = k % 3, j = k % 2, x = (5 * k + 3) % n, y = (3 * k) % n;
    from.push_back(vertex(i, j));
    to.push_back(vertex(x, y));
    const std::uint32_t dx = (x + n - i) % n, dy = (y + n - j) % n;
    expected.push_back(std::hypot(std::min(dx, n - dx), std::min(dy, n - dy)));
  }
  const std::vector<double> found = IT::pair_distances(t, from, to);
  const std::vector<double> back =
      IT::pair_distances(t, to, from, parameters::number_of_threads(1));
  for (std::size_t i = 0; i < from.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], 1e-14);
    EXPECT_NEAR(back[i], expected[i], 1e-14);
  }
}

// Corners of faces are vertices; points within faces have the distances of their own searches.
TEST(Pair_distances, of_points_are_those_of_a_search_for_each) {
  const Triangulation t = flat_torus(5);
  std::vector<Vertex> vertices_from, vertices_to;
  std::vector<IT::Surface_point> corners_from, corners_to, from, to;
  for (std::uint32_t k = 0; k < 12; ++k) {
    const std::uint32_t h = 6 * (k % 5), g = (8 * k + 13) % 50;
    vertices_from.push_back(source(t.numbers().halfedge_at(h), t.mesh()));
    vertices_to.push_back(source(t.numbers().halfedge_at(g), t.mesh()));
    corners_from.push_back({h, {1, 0, 0}});
    corners_to.push_back({g, {1, 0, 0}});
    from.push_back({h, {0.5, 0.25, 0.25}});
    to.push_back({g, {0.25, 0.625, 0.125}});
  }
  EXPECT_EQ(IT::pair_distances(t, corners_from, corners_to),
            IT::pair_distances(t, vertices_from, vertices_to));
  const std::vector<double> found = IT::pair_distances(t, from, to);
  for (std::size_t i = 0; i < from.size(); ++i)
    EXPECT_NEAR(found[i], IT::Polyhedral_distance<Triangulation>(t, from[i]).distance(to[i]),
                1e-14);
}

} // namespace
