// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/distance/heat_distances.h>

#include "operator_test_meshes.h"

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

// Oracle: `Heat_distance::distances()` for one set, bit by bit.

namespace {

using namespace operator_test;
namespace parameters = IT::parameters;
using Vertex = Exact::vertex_descriptor;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Sets of one to `most` vertices.
std::vector<std::vector<Vertex>> random_sets(const Exact& t, std::size_t number, std::size_t most,
                                             unsigned seed) {
  const std::vector<Vertex> all(vertices(t.mesh()).begin(), vertices(t.mesh()).end());
  std::mt19937 random(seed);
  std::vector<std::vector<Vertex>> sets(number);
  for (std::size_t i = 0; i < number; ++i)
    for (std::size_t k = 0; k <= i % most; ++k) sets[i].push_back(all[random() % all.size()]);
  return sets;
}

// Compares columns of a batch, in several numbers of threads, with single calls.
template <class Sets>
void expect_single_calls(const Exact& t, const Sets& sets) {
  const std::size_t n = t.number_of_vertices();
  IT::Heat_distance single(t);
  const IT::Heat_distance shared(t);
  for (const std::size_t threads : {0, 1, 2, 5}) {
    std::vector<double> out(n * sets.size(), -1);
    std::vector<float> narrow(n * sets.size(), -1);
    EXPECT_EQ(
        IT::heat_distances(shared, sets, std::span(out), parameters::number_of_threads(threads)),
        IT::Status::done);
    EXPECT_EQ(IT::heat_distances(t, sets, std::span(narrow)), IT::Status::done);
    for (std::size_t i = 0; i < sets.size(); ++i) {
      const Eigen::VectorXd expected = single.distances(sets[i]);
      for (std::size_t v = 0; v < n; ++v) {
        const double d = expected[static_cast<Eigen::Index>(v)];
        EXPECT_EQ(out[i * n + v], d) << "set " << i << ", vertex " << v;
        EXPECT_EQ(narrow[i * n + v], static_cast<float>(d));
      }
    }
  }
}

TEST(Heat_distances, columns_are_those_of_single_calls_bit_by_bit) {
  Exact closed(rough_torus(12, 0.3, 4).input()), bordered(rough_grid(11, 0.3, 0.5, 2).input());
  IT::flip_to_delaunay(closed);
  IT::flip_to_delaunay(bordered);
  for (const Exact* t : {&closed, &bordered}) {
    expect_single_calls(*t, random_sets(*t, 1, 1, 1));
    expect_single_calls(*t, random_sets(*t, 21, 1, 1));
    expect_single_calls(*t, random_sets(*t, 19, 3, 2));
    expect_single_calls(*t, random_sets(*t, 25, 25, 3)); // more than multipliers take
  }
}

TEST(Heat_distances, on_several_components_each_set_has_its_own) {
  const Exact t(beside(tetrahedron(), rough_torus(8, 0.2, 1)).input());
  std::vector<std::vector<Vertex>> sets = random_sets(t, 12, 2, 5);
  sets.emplace_back(); // no source
  expect_single_calls(t, sets);
  std::vector<double> out(t.number_of_vertices() * sets.size());
  IT::heat_distances(t, sets, std::span(out));
  EXPECT_EQ(out.back(), infinity);
}

TEST(Heat_distances, where_heat_is_below_the_range_of_doubles_are_those_of_single_calls) {
  Shape s = grid(1); // a strip of 1,500 cells
  s.points.clear();
  s.triangles.clear();
  for (std::uint32_t x = 0; x <= 1500; ++x) {
    s.points.push_back({x * 1.0, 0, 0});
    s.points.push_back({x * 1.0, 1, 0});
    if (x == 0) continue;
    s.triangles.push_back({2 * x - 2, 2 * x, 2 * x - 1});
    s.triangles.push_back({2 * x, 2 * x + 1, 2 * x - 1});
  }
  const Exact t(s.input());
  expect_single_calls(t, random_sets(t, 9, 2, 7)); // levels differ between the sets
}

TEST(Heat_distances, take_points_and_curves_as_sources) {
  const Exact t(rough_torus(9, 0.2, 3).input());
  std::vector<std::vector<Exact::halfedge_descriptor>> curves(10);
  std::size_t i = 0;
  for (const auto e : edges(t.mesh())) curves[i++ % 10].push_back(halfedge(e, t.mesh()));
  for (auto& c : curves) c.resize(2);
  expect_single_calls(t, curves);
}

TEST(Heat_distances, a_visitor_sees_each_column_and_ends_the_batch) {
  struct Visitor {
    std::vector<std::size_t> seen;
    std::size_t last;
    bool progress(std::size_t done, std::size_t all) {
      EXPECT_EQ(all, 40U);
      seen.push_back(done);
      return done < last;
    }
  };
  const Exact t(rough_torus(6, 0.2, 3).input());
  const auto sets = random_sets(t, 40, 1, 1);
  const auto run = [&](Visitor& visitor) {
    std::vector<double> out(t.number_of_vertices() * sets.size(), -1);
    const auto np = parameters::number_of_threads(1).visitor(std::ref(visitor));
    const IT::Status status = IT::heat_distances(t, sets, std::span(out), np);
    EXPECT_EQ(out.back() == -1, status == IT::Status::cancelled);
    return status;
  };
  Visitor patient{{}, 100}, hasty{{}, 3};
  EXPECT_EQ(run(hasty), IT::Status::cancelled);
  EXPECT_EQ(hasty.seen, (std::vector<std::size_t>{1, 2, 3}));
  EXPECT_EQ(run(patient), IT::Status::done);
  ASSERT_EQ(patient.seen.size(), 40U);
  EXPECT_EQ(patient.seen.back(), 40U);
}

TEST(Heat_distances, refuse_what_makes_no_sense_before_they_write) {
  const Exact t(rough_torus(5, 0.2, 3).input());
  const auto sets = random_sets(t, 3, 1, 1);
  std::vector<double> out(t.number_of_vertices() * 3, -1);
  EXPECT_THROW(IT::heat_distances(t, sets, std::span(out).first(out.size() - 1)),
               std::invalid_argument);
  IT::Polyline_source leaps;
  for (const auto h : {*halfedges(t.mesh()).begin(), *std::prev(halfedges(t.mesh()).end())})
    leaps.points.push_back({t.numbers().halfedge(h), {0.5, 0.25, 0.25}});
  const std::vector<IT::Polyline_source> polylines{{{leaps.points[0]}}, leaps, leaps};
  EXPECT_THROW(IT::heat_distances(t, polylines, std::span(out)), std::invalid_argument);
  EXPECT_EQ(out, std::vector<double>(out.size(), -1));
  EXPECT_THROW(IT::heat_distances(t, sets, std::span(out), parameters::time_factor(-1.0)),
               std::invalid_argument);
  std::vector<double> none;
  EXPECT_EQ(IT::heat_distances(t, std::vector<Vertex>(), std::span(none)), IT::Status::done);
}

} // namespace
